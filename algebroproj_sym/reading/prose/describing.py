"""What words call a letter: "the wave number $k$", "$k$ is the wave number", or "Gravity $g$" as a title."""

import re
from collections.abc import Iterator, Sequence

from algebroproj_sym.reading.prose.devices import heard
from algebroproj_sym.reading.prose.phrases import symbols_in_list
from algebroproj_sym.reading.prose.sentences import is_neutral, without_laws, words_of
from algebroproj_sym.reading.prose.words import NEAR

MOST_NOUNS = 4
"""How many words may name a thing."""
_TOKEN = re.compile(r"[^\W\d_][\w'’-]*|\$[^$]*\$|[^\w\s]")
_MINOR = heard("<ends-name>")
_GENERAL = heard("<of-anything>")
_ADJECTIVE = re.compile(
    r"(?:[^e]ed|ly)$|^(?:surround|involv|remain|correspond|result|follow|preced|exist|includ|contain)ing$"
)
_DETERMINERS = frozenset(("the", "a", "an", "its", "our", "this", "that", "each", "any", "some", "whose"))
_ACTORS = frozenset(("we", "you", "one", "i", "they", "to", "can", "may", "will", "must", "us", "let"))
_CALLS = frozenset(("is", "are", "be", "by", "as", "called", "denoted", "named", "written", "|", "&", ":", "("))
_NAMING = re.compile(r"\b(?:denot|call|nam|writ|label|symbol)\w*", re.IGNORECASE)
_LISTED = re.compile(r"((?:[A-Za-z-]+,? ){1,8})are (?:denoted (?:by )?)?(?:\$[^$]*\$,? )+(?:and )?$")
_ITEM = re.compile(r"(?:^|\n)\s*(?:[*+-]|\d+[.)]|\\item)\s*$")
_SAYS = re.compile(
    r"[\s*_}]*(?:\([^()]*\)\s*)?(?:"
    r"(?:(?:now |then |here )?(?:is|are|be|being)(?: now| then| here)?|,)(?=\s+(?:the|an?|our|its)\b)"
    r"|\](?=[^$]*\S)|\[[^\]]*\](?=\s*[a-z])"
    r"|(?:now )?(?:denot(?:es?|ing)|st(?:ands?|anding) for|represent(?:s|ing)?|means?)|:|=|\||&|–|—|--+|\((?=[a-z])"
    r"|(?=(?:the|an?)\b))"
)


def described(text: str) -> Iterator[tuple[str, frozenset[str]]]:
    """Yield the letters of which words say what they are, with the words; without any for "Let $c$ be".

    Examples
    --------
    >>> for words in ("with gravity $g$", "The wave number is $k$.", "$c = 3$ is the speed of light.", "Hence $b$ is"):
    ...     print(*((symbol, sorted(nouns)) for symbol, nouns in described(words)))
    ('g', ['gravity'])
    ('k', ['wave'])
    ('c', ['light', 'speed'])
    <BLANKLINE>
    """
    for formula in re.finditer(r"\$([^$]*)\$", text):
        start, end = formula.span()
        before, behind = without_laws(text[max(0, start - NEAR) : start]), text[end : end + NEAR]
        letter = formula[1].partition("=")[0].strip().rstrip(":")
        lets = re.search(r"\b[Ll]et $", before) and re.match(r" (?:now )?(?:be|denote|stand|represent)\b", behind)
        named = (*_named_before(before, behind), *_named_behind(before, behind))
        nouns = {each for each in named if not (_GENERAL.fullmatch(each) or _ADJECTIVE.search(each))}
        if (nouns or lets) and letter:
            yield from ((symbol, frozenset(nouns)) for symbol in symbols_in_list(letter))


def is_titled(sentence: str) -> bool:
    r"""Whether a sentence begins with a title, or speaks of things of a sort: what it says is said of these alone.

    Examples
    --------
    >>> [is_titled(each) for each in (r"\textbf{Rods.} We have", "Region I:", "Thin lenses obey", "Most springs have")]
    [True, True, True, True]
    >>> [is_titled(each) for each in ("The speed is", "Hence", "Newton's law gives", "Similarly, we get", "Let")]
    [False, False, False, False, False]
    """
    if title := _TITLE.match(sentence):
        return any(map(names_a_thing, words_of(next(filter(None, title.groups()), ""))))
    first = _FIRST.match(without_laws(_OF_LISTS.sub("", sentence, count=1)))
    if first is None or first[1].endswith("ly"):
        return False
    return _PARTLY.match(first[0]) is not None or names_a_thing(first[1].lower())


_OF_LISTS = re.compile(
    r"(?:\s|\\(?:begin|end)\{\w+\*?\}(?:\{[^{}]*\}|\[[^\]]*\])*|\\item(?!\[)\b|[*+-]\s|\d+[.)]\s|\([a-z]+\)\s)*"
)
"""What may stand before the first words of an item."""
_TITLE = re.compile(
    _OF_LISTS.pattern + r"(?:\\item\[([^\]]+)\]|\\(?:textbf|emph|textit|textsc|underline)\{([^{}]*)\}"
    r"|(?:\*\*|__)([^*_]+)(?:\*\*|__)|===+\s*\"([^\"]*)\")"
)
_FIRST = re.compile(r"\W*([A-Za-z][\w-]*)(?!['’]s\b)(?:[ ,]+\w+)?")
_PARTLY = re.compile(r"\W*(?:most|some|many|few|half|all but|apart|except|certain|several)\b", re.IGNORECASE)
"""How a sentence begins that speaks of some things, and not of others."""


def is_same(some: frozenset[str], others: frozenset[str]) -> bool:
    """Whether words may name the same thing: two of them begin alike.

    Examples
    --------
    >>> is_same(frozenset({"masses"}), frozenset({"mass"})), is_same(frozenset({"wave"}), frozenset({"stiffness"}))
    (True, False)
    """
    begins = {each[:MOST_ALIKE] for each in others}
    return any(each[:MOST_ALIKE] in begins for each in some)


MOST_ALIKE = 4
"""How many characters words of one stem have in common."""


def names_a_thing(word: str) -> bool:
    """Whether a word may be the name of a thing."""
    return not (is_neutral(word) or _MINOR.fullmatch(word) or _GENERAL.fullmatch(word))


def _named_before(before: str, behind: str) -> list[str]:
    """Return the nouns that stand right before a formula, or before the verb that leads to it, or its comma."""
    sentence = re.split(r"[.!?;]\s|\n\s*\n|\n(?=\s*[*+|-])", before)[-1]
    if listed := _LISTED.search(sentence):
        return [each.lower() for each in _TOKEN.findall(listed[1]) if names_a_thing(each)]
    tokens = _TOKEN.findall(sentence)
    leads = tokens[-1:] == [","] and behind[:1] in (".", ",")
    if leads:
        tokens.pop()
    while tokens and (tokens[-1].lower() in _CALLS):
        if tokens[-1].lower() in ("by", "as") and not _NAMING.search(sentence):
            return []
        leads = True
        tokens.pop()
    found, stopped = more, _ = _nouns(tokens[::-1])
    while more and stopped in ("of", *_DETERMINERS):
        tokens = tokens[: -len(more) - (stopped != "of")]
        if [each.lower() for each in tokens[-1:]] != ["of"]:
            break
        tokens.pop()
        more, stopped = _nouns(tokens[::-1])
        found = found + more
    if stopped in _ACTORS and found:
        found.pop()
    if stopped not in _DETERMINERS or (len(found) > 1 and _GENERAL.fullmatch(found[1])):
        found = [each for each in found if not re.search(r"(?:ing|ed|ly)$", each)]
    return [] if leads and stopped not in (*_DETERMINERS, "", "|", "&") else found


def _named_behind(before: str, behind: str) -> list[str]:
    """Return the nouns behind a formula that say what it is."""
    says = _SAYS.match(behind)
    start = says.end() if says else 0 if _ITEM.search(before) else None
    if start is None:
        return []
    clause = re.split(r"[.!?;,]|\n\s*\n|\||\\\\|\\item", behind[start:])[0]
    tokens = _TOKEN.findall(clause)
    while tokens and tokens[0].lower() in (*_DETERMINERS, "now", "then", "here"):
        tokens.pop(0)
    found = _nouns(tokens)[0] or [each.lower() for each in tokens[:1] if says and each.isalpha()]
    rest = tokens[len(found) :]
    if found and rest[:1] == ["of"]:
        rest = [each for each in rest[1:] if each.lower() not in _DETERMINERS]
        found += _nouns(rest)[0]
    return found


def _nouns(tokens: Sequence[str]) -> tuple[list[str], str]:
    """Return the words up to the first one that names nothing, and this one."""
    found = list[str]()
    for each in tokens[: MOST_NOUNS + 1]:
        word = each.lower()
        general = _GENERAL.fullmatch(word) is not None
        if not general and (not word[0].isalpha() or is_neutral(word) or _MINOR.fullmatch(word)):
            return found, word
        found.append(word)
    return found, ""
