"""Whether a sentence plainly asserts the equation to which it leads: no speaker, no doubt, and no other time or place.

Words that deny cannot all be listed.  So the forms of sentences are listed that assert: "The cost is", "We have".
"""

import re

from algebroproj_sym.reading.prose.devices import heard
from algebroproj_sym.reading.prose.sentences import sentences_of, strange_word, without_formulas, words_of

_DETERMINER = r"(?:the|an?|its|our|their|this|these|those)"
_THING = rf"(?:(?:{_DETERMINER}|each|both|every|two|three)\b[^,;:]*|(?-i:[A-Z][a-z]+)['’]s?\s[^,;:]*)"
"""Any thing, with whatever is said of it."""
_PLAIN_THING = rf"(?:{_DETERMINER}\s+(?:<plain-adjective>\s+)*<quantity>(?:\s+(?:of|for)\s+{_DETERMINER}\s+[a-z]+)?)"
"""A quantity with no adjective that might deny it.  A thing that is no quantity may be a statement: "The gossip is"."""


def _form(thing: str, says: str, rest: str) -> str:
    """Return the form of sentences that say something of a thing; behind verbs of ours stands the rest."""
    lead = rf"\W*(?:(?:<leads-in>|by <means>|(?:from|by|using) {thing},)\W*)*"
    said = rf"(?:{thing}\s+{says}|(?:(?:it|this|they|there|where|which|and|with)\s+)?<asserting>)"
    said = rf"{said}(?:\s+<how>)*(?:\s+(?:at|by|of)\s+{thing})?"
    ours = rf"(?:we|one)\s+(?:(?:<leads-in>|can|may|thus)\s+)*<we-assert>\b{rest}|<commands>\b{rest}"
    placed = rf"{_DETERMINER}\s+[a-z]+\s+(?:is|are)\s+at\s+{thing}"
    return rf"{lead}(?:{said}|{placed}|{ours}|of)?\W*"


_ASSERTS = heard(_form(_THING, "<asserting>", "[^,;:]*"))
_PLAINLY = heard(_form(_PLAIN_THING, "<equating>", rf"(?:\s+(?:that|as|by|be|for|{_PLAIN_THING}))*"))
_DOUBTED = heard(r"\?|\b<rejects denies untrue unreal apart no roughly wants wanted sought otherwise judged>\b")


def asserts(before: str, behind: str, *, plainly: bool = False) -> bool:
    """Whether the sentence of an equation, up to it and behind it, asserts it.

    If no words of its own lead to it, the sentence before it must not doubt it.  It does so plainly if nothing more is
    said of the thing of which it speaks: "The phantom width is" may say what the width is not.

    Examples
    --------
    >>> [asserts(each, "") for each in ("Hence", "The cost is", "By definition, we have", "Let $c$ be")]
    [True, True, True, True]
    >>> [asserts(each, "") for each in ("Newton wrote", "Is it true that", "The old rule was", "Perhaps", "Right?")]
    [False, False, False, False, False]
    >>> [asserts("The phantom width is", "", plainly=each) for each in (False, True)]
    [True, False]
    """
    *above, own = (without_formulas(heard("<law>", re.NOFLAG).sub("", each)) for each in sentences_of(before))
    asked = before.rstrip().endswith("?")
    said = f"{own} {without_formulas(behind)} {'' if words_of(own) else ' '.join(above[-1:])} {'?' if asked else ''}"
    goes_on = _GOES_ON.match(behind) is not None or _GIVEN.fullmatch(own) is not None
    goes_on = goes_on and not (plainly and may_take_back(behind))
    form = _PLAINLY if plainly else _ASSERTS
    return form.fullmatch(own) is not None and goes_on and not doubts(said)


def may_take_back(words: str) -> bool:
    """Whether words behind an equation may be about it: some are not neutral, and they do not say what letters are.

    Examples
    --------
    >>> [may_take_back(each) for each in ("and hence", "where $a$ is the length of the lid", ", or so he thought")]
    [False, False, True]
    """
    strange = strange_word(_GOES_ON.sub("", words, count=1), ())
    return strange != "" and (doubts(words) or not _SAYS_LETTERS.match(words))


def doubts(words: str) -> bool:
    """Whether words deny something, or tell of what was thought, or of another time or place."""
    return _DOUBTED.search(words) is not None


_SAYS_LETTERS = re.compile(r"\W*(?:where|with|here|and)\b,?\s+\$[^$=]*\$", re.IGNORECASE)
"""How words begin that say what letters are."""
_GIVEN = heard(r"\W*(?:with|given|using|for|from)\W*")
"""Words before an equation behind which a main clause stands."""
_GOES_ON = heard(r"\W*(?:$|(?:where|with|which|so|and|for|in which|thus|hence|or|as)\b)")
