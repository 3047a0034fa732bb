r"""Unit vectors that are perpendicular to each other, as those of the axes: what is said with them holds by components.

``\hat{i}``, ``\hat{j}`` and ``\hat{k}`` are where words speak of unit vectors.  Others, as ``\hat{e}_1`` and
``\hat{e}_2``, are only where they are said to be orthonormal, or perpendicular to each other.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from algebroproj_sym.reading.lexing.names import split_symbol

Axes = Mapping[str, int]
"""The places of some unit vectors among those of their basis."""
_INDICES = tuple(
    tuple(each.split())
    for each in (r"x y z", "1 2 3", r"r \theta z", r"r \theta \phi", r"\rho \phi z", r"\rho \theta z", "t n b")
)
_UNIT = re.compile(r"(?:\\(?:hat|mathbf|vec|widehat)\{?)+([ijk]|\\imath|\\jmath)\}*")
_VECTOR = re.compile(r"\\(?:hat|widehat|mathbf|vec|overrightarrow)(?![a-z]{2})")
_SAYS_UNIT = re.compile(r"\bunit[- ]vectors?\b|\bversors?\b|\bbas(?:is|e) vectors?\b|\bortho-?normal\b", re.IGNORECASE)
_ORTHONORMAL = re.compile(
    r"\bortho-?normal\b|\b(?:orthogonal|perpendicular)\b[^.]*\bunit[- ]vectors?\b"
    r"|\bunit[- ]vectors?\b[^.]*\b(?:orthogonal|perpendicular)\b",
    re.IGNORECASE,
)
_NOT = re.compile(
    r"\b(?:not|non|nor|neither|isn't|aren't)[- ]?(?:\w+ ){0,3}(?:ortho\w*|perpendicular|unit)\b|\bleft[- ]hand"
    r"|\b(?:oblique|skewed?|dual|reciprocal|co-?variant|contra-?variant|curvilinear|crystal\w*|lattice)"
    r"[ -](?:\w+[ -])?(?:bas[ei]s|ax[ei]s|vectors?|coordinates?|frames?)\b",
    re.IGNORECASE,
)
"""Words of a basis of another kind."""


def axes_in(symbols: Iterable[str], words: str) -> tuple[Axes, ...]:
    r"""Return the unit vectors of each basis that occurs, if the words of a document say enough of them.

    Examples
    --------
    >>> axes_in([r"\hat{i}", r"\hat{j}", r"\hat{e}_x"], "Here i and j are unit vectors.")
    ({'\\hat{i}': 0, '\\hat{j}': 1},)
    >>> axes_in([r"\hat{e}_x", r"\hat{e}_y", "x"], "The basis is orthonormal.")
    ({'\\hat{e}_x': 0, '\\hat{e}_y': 1},)
    """
    if _SAYS_UNIT.search(words) is None or _NOT.search(words):
        return ()
    occurring = sorted({*symbols})
    found = [*_of_letters(occurring), *(_of_indices(occurring) if _ORTHONORMAL.search(words) else ())]
    return tuple(each for each in found if len(each) > 1)


def _of_letters(symbols: Iterable[str]) -> Iterator[Axes]:
    places = {"i": 0, "j": 1, "k": 2, r"\imath": 0, r"\jmath": 1}
    bases: dict[str, dict[str, int]] = {}
    for each in symbols:
        if match := _UNIT.fullmatch(each):
            style = (
                each.replace(match[1], "", 1) if match[1] in "ijk" else each[: match.start(1)] + each[match.end(1) :]
            )
            bases.setdefault(style, {})[each] = places[match[1]]
    yield from bases.values()


def _of_indices(symbols: Iterable[str]) -> Iterator[Axes]:
    families: dict[str, dict[str, str]] = {}
    for each in symbols:
        if _VECTOR.match(each) and "/" not in each and " " not in each:
            letter, primes, below, above = split_symbol(each)
            families.setdefault(f"{letter}{primes}{above}", {})[below] = each
    for family in families.values():
        for indices in _INDICES:
            if len({*indices} & {*family}) > 1 and {*family} <= {*indices}:
                yield {symbol: indices.index(below) for below, symbol in family.items()}
                break
