"""Sentences and their words, without formulas, and without what a derivation says anyway."""

import re
from collections.abc import Collection

from algebroproj_sym.reading.prose.devices import heard, says

IN_THIS_CASE = heard(r"\b<known-case>\b")
_CASE_BEFORE = re.compile(
    r"(?:^|[.:;,}]\s*)\s*(?:and )?(?:if|when|for)\b[^.,;:]*"
    r"\$[^$]*(?:[=<>]|\\(?:le|ge|ne|in|to)(?:q|slant)?(?![a-z]))[^$]*\$\s*[:,]\s*$",
    re.IGNORECASE,
)
"""A case that stands before a colon, and so before what holds in it: "If $n > 0$:"."""
_AND_THEN = re.compile(
    r"(\b(?:if|when|whenever|assuming)\s+\S+(?:\s+(?!(?:if|when|whenever)\b)\S+){2,}?"
    r"\s+(?<!\bthat\s)(?<!\bwhich\s)(?<!\bwhere\s)(?<!\band\s)(?<!\bor\s)(?<!\bas\s)(?<!\bhow\s))"
    r"((?:(?:we|you|they)\s+(?:(?:can|may|will|then|now|also)\s+)*(?:(?:re)?write|get|obtain|find|have)"
    r"|(?:it|this)\s+(?:then )?(?:generali[sz]es|reduces|becomes|simplifies|gives|yields|reads|results))\b)",
    re.IGNORECASE,
)
"""How a condition is followed by the main clause without a comma: "If there are two we can write"."""
_OF_A_THING = re.compile(r"\s*(?:the|its|their|our|an?) (?!same\b)[a-z-]+\b", re.IGNORECASE)
"""How a clause begins that names what an equation gives, as in "If it is closed, the area"."""
_GOES_ON = re.compile(r"\s*(?:and|or|but|nor)\b(?!\s+(?:then|we|hence|so|thus|therefore)\b)", re.IGNORECASE)


def main_clause(sentence: str) -> str:
    """Return the last clause of a sentence, if it asserts something; else all of it, without a case before a colon.

    Examples
    --------
    >>> main_clause("If the orbit is closed, its period is:"), main_clause("If $a$ is real, and $b$ is")
    (' its period is', 'If $a$ is real, and $b$ is')
    >>> main_clause("If $a$ is real, then $b$ is a root, and $c$ is")
    ' and $c$ is'
    """
    if _CASE_BEFORE.search(sentence):
        return ""
    bare = FORMULA.sub(lambda found: re.sub(r"[,;:]", " ", found.group()), sentence)
    bare = _AND_THEN.sub(r"\1, \2", IN_THIS_CASE.sub(" then ", bare))
    clauses = [each for each in re.split(r"[,;:]|\b(?=then\b)", bare) if each.strip()]
    last = clauses[-1] if clauses else ""
    concluded = any(each.startswith("then") for each in clauses[:-1])
    alone = concluded or not _GOES_ON.match(last)
    asserts = says(r"\b<asserts>\b", FORMULA.sub(" ", last)) or (len(clauses) > 1 and _OF_A_THING.match(last))
    return last if asserts and alone else sentence


def last_sentence(words: str) -> str:
    """Return the words since the last full stop or the last empty line."""
    return sentences_of(words)[-1]


def sentences_of(words: str) -> list[str]:
    """Return the sentences of words; what stands behind the last full stop is the last one."""
    return re.split(r"[.!?](?:\s+(?=[A-Z\\$])|$)|\n\s*\n", words.rstrip())


def words_of(text: str) -> frozenset[str]:
    """Return the words of a text, without formulas and commands, in small letters."""
    return frozenset(each.lower() for each in _WORD.findall(without_formulas(text)))


def strange_word(sentence: str, known: Collection[str]) -> str:
    """Return a word that is none of a derivation, and that is not known; empty for none.

    Examples
    --------
    >>> strange_word("Hence, for the ring, we obtain", {"disc"}), strange_word("This gives $x$ and thus", ())
    ('ring', '')
    """
    words = (each for each in _WORD.findall(without_formulas(without_laws(sentence))) if not is_neutral(each))
    return next((each for each in words if each.lower() not in known), "")


def are_of_two_things(one: str, other: str) -> bool:
    """Whether two short sentences differ in a word or two, and so say the same of two things.

    Examples
    --------
    >>> are_of_two_things("The left camera has", "The right camera has")
    True
    >>> are_of_two_things("The force is", "The work is")
    False
    """
    ours, theirs = ([each.lower() for each in _WORD.findall(without_formulas(text))] for text in (one, other))
    if ours == theirs or max(len(ours), len(theirs)) > MOST_WORDS:
        return False
    only, shared, others = {*ours} - {*theirs}, {*ours} & {*theirs}, {*theirs} - {*ours}
    little = all(1 <= len(each - _ARTICLES) <= 2 for each in (only, others))
    strange = [any(not is_neutral(each) for each in words) for words in (shared, only, others - _QUANTIFIERS)]
    return little and all(strange[:2]) and (strange[2] or not others.isdisjoint(_QUANTIFIERS))


def is_neutral(word: str) -> bool:
    """Whether a word is one of those of a derivation."""
    return heard("<neutral>").fullmatch(word) is not None


def without_laws(text: str) -> str:
    """Return words without the names of laws, which hold beside what else is said of a letter, and of both sides.

    Examples
    --------
    >>> without_laws("By Newton's second law, it is")
    ', it is'
    """
    return _SIDE.sub("", heard("<law>", re.NOFLAG).sub("", text))


_SIDE = re.compile(
    r"\b(?:left|right)(?:[ -]?hand)?[ -](?:sides?|terms?|factors?)\b|\b(?:[Oo]n|[Tt]o|[Ff]rom) the (?:left|right)\b"
    r"|\b[Oo]n the other hand\b"
)
MOST_WORDS = 12
"""How many words sentences have that are compared word by word."""
_ARTICLES = frozenset(("the", "an", "this", "that", "these", "those"))
_QUANTIFIERS = frozenset(("all", "every", "each", "any", "no", "most", "one"))
FORMULA = re.compile(r"\$[^$]*\$")
_WORD = re.compile(r"[^\W\d_]{2,}|\b[^\W\d_]\d{2,}")


def without_formulas(text: str) -> str:
    """Return words without formulas, references, and what names the letters of an equation alone."""
    return _FORMULAS.sub(" ", text)


_FORMULAS = heard(r"\$[^$]*\$|\\(?:eq)?ref\s*\{[^{}]*\}|\\[a-zA-Z]+|<of-letters>", re.NOFLAG)
