"""What the sentence of an equation supposes: an equation within the text, as in "since $b = 0$, the sum is"."""

import re

from algebroproj_sym.reading.documents.displays import Display
from algebroproj_sym.reading.prose.devices import heard
from algebroproj_sym.reading.prose.sentences import FORMULA, last_sentence, without_formulas
from algebroproj_sym.reading.prose.words import CASES, SAYS, Beside, ends_clause

_LEADS = re.compile(
    r"\W*(?:(?:and|so|now|then|thus|hence|also|thereby|we|it is|letting|given)\b\W*)*"
    r"(?:(?:since|as|because|where|in which|when|if|for|with|by|at|using|use|let|put(?:ting)?|set(?:ting)?|"
    r"tak(?:e|ing)|suppose|supposing|assume|assuming|choos(?:e|ing)|introducing|substitut(?:e|ing)|insert(?:ing)?|"
    r"hav(?:e|ing)|know|recall|given|comparing(?: (?:this|it|them))?)\b\W*)*"
    r"(?:(?:that|the (?:parameter|abbreviation|notation|quantity|value|identity|relation|equation|fact that|letter)|"
    r"(?:we|you) (?:can )?(?:have|set|use|put|take|know|assume|choose|introduce|define)|there is|"
    r"(?:(?:we|you) )?(?:use|have|take) an? (?:[a-z]+ ){1,2}(?:where|with|in which))\b\W*)*",
    re.IGNORECASE,
)
"""The words before a formula that its sentence supposes."""
_NAMED = heard(
    r"\W*(?:(?:<leads-in>|since|as|because|where|when|if|for|with|by|using|introducing|comparing|define|let)\W+)*"
    r"(?:(?:the|its|our|an?)\s+)?(?:(?!<asserting we-assert reports>\b|(?:of|in|with)\b)[a-z-]+\s+){0,3}<quantity>"
    r"(?:\s+(?:of|in|for)(?:\s+(?:the|its|an?))?(?:\s+[a-z-]+){1,2})?(?:\s+(?:is|are))?\W*"
)
"""A quantity right before a formula that says what it is: "with the gain $K = P S$", "The area $h = x y$"."""
_SAYS_A_VALUE = heard(r"\s*(?:<asserting>|evaluates?)\b(?:\s+(?:<how>|components|entries))*\W*")
"""How a sentence that says more of such a quantity ends."""
_WE_HAVE = re.compile(r"\b(?:we|one) (?:have|has|gets?|obtains?|finds?)(?: that)?\W*$", re.IGNORECASE)
_IN_CASE = re.compile(r"\W*(?:for|in|at|if|when|under|with)\b[^()]*\(\s*", re.IGNORECASE)
"""Words before a formula in brackets that says of which case they speak: "In the plane ($z = 0$)"."""
_OF_LETTERS = re.compile(r"=[^=]*[a-zA-Z]")
_THEN = re.compile(
    r"\s*(?:(?:as|is|are) (?:the|our|its|an?) (?:[a-z]+ ){0,3}[a-z]+)?\s*"
    r"(?:[,:]|$|(?:so|then|thus|hence|this|gives?|yields?|and (?:so|thus|hence|then|that|the|obtain|get|find)|into|"
    r"in (?:the|\()|leads?|reduces?|becomes?|holds?|we|it|the|these|they)\b)",
    re.IGNORECASE,
)
"""How a sentence goes on behind a formula that it supposes: with its main clause."""
_WHERE = re.compile(r"\W*(?:where|with|in which|and where)\b(?!\s+(?:we|i|the)\b)", re.IGNORECASE)
_APART = heard(r"\b<apart>\b")
_ELSEWHERE = re.compile(
    r"\b(?:at|in|on|for|inside|outside|near|under|over|above|below|behind|with|from|to|towards?|along|around|between)\s+"
    r"(?!(?:the|this|that)\s+(?:form|case|equations?|expressions?|formulas?|relations?|above|following)\b|"
    r"(?:terms?|this|that|it|\(|obtain|get|find|give|write|see)\b|\W*$)",
    re.IGNORECASE,
)
"""Words behind a formula that may lead elsewhere."""
_STATES = re.compile(
    r"(?:\b(?:we|you|one)(?: (?:can|may|then|thus|also|now|hence|therefore|immediately|easily|finally|clearly|directly|"
    r"indeed))* (?:have|has|gets?|obtains?|finds?|sees?|knows?|concludes?|arrives? at)(?: that)?|"
    r"\bfollows(?: (?:directly|immediately|easily))?(?: that)?|\b(?:hence|thus|therefore|so|so that|then|consequently)|"
    r"\b(?:not(?:e|ing)|notice|recall(?:ing)?|observe)(?: that)?|\bthat is|\bi\.e\.|"
    r"\b(?:gives?|yields?|implies|giving|yielding|implying|satisf(?:y|ies|ying)|obeys?)(?: that)?)[^\w$]*$",
    re.IGNORECASE,
)
"""The words right before a formula that its sentence states."""
_AND_MORE = re.compile(r"\A(?:\s*(?:,|,?\s*and)\s+\$[^$=]*=[^$]*\$)+")
"""Formulas that a sentence supposes behind a first one: "with $x = r c$ and $y = r s$"."""
_AND_ANOTHER = re.compile(r"\$[^$]*\$,?\s+and\s*$")
_GOES_ON = re.compile(r"\s+and\s+\$|,?\s+(?:where|with)\s+\$[^$=]*\$\s+(?:is|are|denotes?|stands? for)\b")
_INSIDE = re.compile(r"\([^()$]*\)")
_ORDER = re.compile(r"[<>≠≤≥≈∼∈]|\\(?:n?e?q?[lg]e?q?q?|neq?|approx|sim|in|lt|gt|to|ll|gg|not)(?![a-zA-Z])")


def supposes(beside: Beside, formula: str) -> bool:
    """Whether the sentence of an equation supposes a formula within the text.

    The formula stands in a clause of its own, or before the main one.  A sentence with a word of another case, with
    another place behind the formula, or with an inequality, supposes nothing.
    """
    before, found, behind = beside.sentence.rpartition(";")[2].partition(formula)
    behind = _AND_MORE.sub("", behind)
    lead = re.split(r"[,:]|\band\b", without_formulas(before))[-1]
    rest = " ".join(behind.replace("$", "").split())
    named = _OF_LETTERS.search(formula) is not None and _NAMED.fullmatch(lead) is not None
    leads = (named or _LEADS.fullmatch(lead) is not None) and _THEN.match(rest) is not None
    leads = leads or (named and _SAYS_A_VALUE.fullmatch(rest) is not None)
    leads = leads or (_WE_HAVE.search(lead) is not None and _THEN.match(rest) is not None)
    leads = leads or (_IN_CASE.fullmatch(lead) is not None and rest.startswith(")"))
    apart = _APART.search(f"{beside.sentence} {beside.condition}") or _ELSEWHERE.search(without_formulas(behind))
    formulas = (_INSIDE.sub("", each) for each in FORMULA.findall(beside.sentence))
    return bool(found) and leads and not (apart or beside.is_denied or any(map(_ORDER.search, formulas)))


def states(beside: Beside, display: Display, *, number: bool) -> bool:
    """Whether a sentence states a formula within the text, as in "we have $c = a - b$.", and of no case.

    So does "the width is $c = a - b$", but for a number: "the null hypothesis is $b = 0$" does not say that it is so.
    """
    lead = beside.sentence
    while (more := _AND_ANOTHER.sub("", lead)) != lead:
        lead = more
    apart = any(each.search(beside.sentence) for each in (CASES, _APART, heard(r"\b<wants>\b|\?")))
    ends = ends_clause(display) or _GOES_ON.match(display.after) is not None
    says = _STATES.search(lead) or (not number and SAYS.search(lead))
    return bool(says) and ends and not (apart or beside.is_conditional)


def goes_on_with(behind: str, *, ended: bool) -> bool:
    """Whether the words behind a display go on with what its letters are: "where $w^2 = k/m$ and".

    Behind a full stop they do if they begin with a small letter.
    """
    words = behind.strip()
    goes_on = _WHERE.match(words) is not None and last_sentence(words) == words
    return goes_on and not (ended and words[:1].isupper())


def goes_on_in_display(between: str, *, first: bool) -> bool:
    """Whether a sentence goes on from a display to the next one that says what its letters are: "where", then "and"."""
    return (_WHERE_ALONE if first else _AND_ALONE).fullmatch(between) is not None


_WHERE_ALONE = re.compile(
    r"\s*[.,;]?\s*(?:where|with|in which|here|and where)\s*,?\s*"
    r"(?:we (?:have )?(?:defined?|introduced?|set|put|used?|write) (?:the \w+ )?"
    r"|(?:the|its|an?) (?:[a-z-]+ ){0,3}[a-z-]+(?: (?:is|are))?(?: (?:given|defined) (?:by|as))?)?:?\s*",
    re.IGNORECASE,
)
_AND_ALONE = re.compile(r"\s*[.,;]?\s*(?:and|where|with)?\s*,?\s*", re.IGNORECASE)


def names_behind(sentence: str, formula: str, behind: str) -> bool:
    """Whether words behind a display say what a letter is: "where $u = a b$ is the speed at the wall, and $w = a$"."""
    before = without_formulas(sentence.partition(formula)[0])
    lead = re.split(r"[,;]|\band\b", before)[-1]
    said = re.split(r"[.;]|,?\s+(?:and|with)\s+(?:\$|\\\()", behind)[0]
    apart = any(_APART.search(_INSIDE.sub("", each)) for each in (before, said))
    return _IS_THE.match(behind) is not None and _LEADS.fullmatch(lead) is not None and not apart


_IS_THE = re.compile(
    r",?\s*(?:(?:is|are|denotes?|represents?|being) (?:the|an?|our|its) (?!case|special|limit|only)"
    r"|and\s*(?:\$|\\\()|(?:these|they|this|it) (?:are|is|becomes?) )"
)


def leads_elsewhere(behind: str) -> bool:
    """Whether the words behind a formula begin with a place, as in "with $b = 0$ at the top"."""
    return _ELSEWHERE.match(behind.lstrip()) is not None


_DENIED_BEHIND = heard(
    r"[^.!$]*\?"
    r"|\s*(?:is|are|need|does|do|can|must|should|may) not\b|[\s,]*(?:(?:but|only|just|exactly) )*<if>\b(?! and only)"
)


def is_denied_behind(behind: str) -> bool:
    """Whether words right behind a formula deny it: "where $b = 0$ is not assumed", "if it rains", or a question."""
    return _DENIED_BEHIND.match(behind) is not None
