"""What words deny: nothing follows where a letter is positive that may be negative, or not zero where it is zero.

Nor does what needs the inverse of a matrix that words call singular, or divides by the product of orthogonal vectors.
"""

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from itertools import permutations

from algebroproj_sym.reading.documents.displays import Document
from algebroproj_sym.reading.judging.verdicts import Reading
from algebroproj_sym.reading.prose.devices import heard
from algebroproj_sym.reading.prose.phrases import symbols_in_list, symbols_of

MOST_SEARCHED = 2000
"""Beside how many formulas the words are searched."""
NEAR = 200
"""How many characters before a letter are searched for a case."""
_NEGATIVE = heard("<negative>", re.NOFLAG)
_ZERO = heard("<zero>")
_SINGULAR = heard("<singular>")
_ORTHOGONAL = heard("<orthogonal>")
_PRODUCT = re.compile(r"\W*(?:dot\W*)?(\w+)(?:\W*\.T\W*\*|, )\W*(\w+)\W*")
"""A product of two vectors, perhaps with a sign."""
_FACTOR = re.compile(r"(?:^|(?<=\*))(?:det\(\w+\)|\w+)(?=\*|$)(?![^()]*\))")
"""A letter, or a determinant, that is a factor of a product."""
_INVERTED = re.compile(r"\b(\w+)(?:\.T)?\*\*\(?-")
"""What has a negative power."""
_UNLESS = heard(r"\b<if unsaid>\b[^.;]*$")


def denied_by_words(document: Document) -> frozenset[str]:
    """Return the hypotheses that words deny: ``x > 0`` where x may be negative, ``x`` where it is zero, ``det(A)``."""
    words = " ".join(f"{each.before} ${each.latex}$ {each.after}" for each in document.formulas[:MOST_SEARCHED])
    words = " ".join(words.split())
    negative = {name for match in _NEGATIVE.findall(words) for each in match for name in _names(symbols_of(each))}
    zero, singular = (
        {name for names in _said(pattern, words, symbols_in_list) for name in names} for pattern in (_ZERO, _SINGULAR)
    )
    signs = (f"{each} {sign} 0" for each in negative for sign in (">", ">="))
    vectors = (pair for names in _said(_ORTHOGONAL, words, symbols_of) for pair in permutations(names, 2))
    across = map(" ".join, vectors)
    return frozenset((*signs, *zero, *singular, *(f"det({each})" for each in singular), *across))


def _said(pattern: re.Pattern[str], words: str, symbols: Callable[[str], Iterable[str]]) -> Iterator[list[str]]:
    """Yield the names of the letters of each place at which words say something of them, and not in a case."""
    for match in pattern.finditer(words):
        if not _UNLESS.search(words[max(0, match.start() - NEAR) : match.start()]):
            yield [name for each in match.groups() if each for name in _names(symbols(each))]


_STYLE = re.compile(r"\\(?:math(?:bf|bb|sf|rm)|vec|overrightarrow)(?![a-zA-Z])")


def _names(symbols: Iterable[str]) -> list[str]:
    return [_STYLE.sub("", each).strip("\\{}") for each in symbols]


def _denies(denied: frozenset[str], hypothesis: str) -> bool:
    """Whether a hypothesis is denied, or that a factor of it is not zero."""
    product = _PRODUCT.fullmatch(hypothesis)
    across = " ".join(product.groups()) if product else ""
    return not denied.isdisjoint((hypothesis, across, *_FACTOR.findall(hypothesis.removesuffix(" != 0"))))


def without_denied(reading: Reading, denied: frozenset[str]) -> Reading:
    """Return a reading in which nothing follows under a hypothesis that words deny."""
    inverted = [f"det({each})" for each in _INVERTED.findall(reading.read or "")]
    links = tuple(
        replace(link, verdict="not decided", reason=_reason_of(wrong[0]))
        if link.verdict == "follows"
        and (wrong := [each for each in (*link.hypotheses, *inverted) if _denies(denied, each)])
        else link
        for link in reading.links
    )
    return replace(reading, links=links)


def _reason_of(hypothesis: str) -> str:
    """Return what words say instead of a hypothesis."""
    name, sign, _ = hypothesis.partition(" ")
    return f"{name} may be {'negative' if sign and '>' in hypothesis else 'zero'} by the words of the document"
