r"""Inner products ``\langle f, g \rangle``: which letters are vectors, and whether a document gives them itself."""

import re
from collections.abc import Iterable, Iterator

from algebroproj_sym.reading.parsing.factors import terms_of
from algebroproj_sym.reading.parsing.grammar import Formula, Sides, lone, symbols_in, trees_in

_NAMED = re.compile(r"\b(?:inner|scalar|dot)[- ]products?\b", re.IGNORECASE)


def vectors_in(sides: Iterable[Formula], words: str) -> frozenset[str]:
    """Return the letters that are terms in an inner product, where words speak of one, and that are no functions."""
    every = [*sides] if _NAMED.search(words) else []
    called = {str(call.children[0]) for side in every for call in side.find_data("call")}
    items = [item for side in every for items in products_in(side) for item in items]
    return frozenset(lone(term) for item in items for term in terms_of(item)) - called - {""}


def products_in(side: Formula) -> Iterator[list[Formula]]:
    """Yield both vectors of each inner product in a formula."""
    for each in side.find_data("inner"):
        if len(items := trees_in(trees_in(each)[0])) == 2:
            yield items


def is_given(equations: Iterable[Sides]) -> bool:
    r"""Whether a document says what an inner product is, otherwise than by ``x^T y`` and lengths."""
    pairs = ((one, other) for sides in equations for one in sides for other in sides if one.data == "inner")
    return any(_gives(one, other) for one, other in pairs)


def _gives(product: Formula, value: Formula) -> bool:
    letters = {letter for items in products_in(product) for letter in map(lone, items)}
    usual = value.data in ("run", "product") and len(trees_in(value)) == 2 and not [*value.find_data("call")]
    usual = usual or any(each.data in ("norm", "absolute", "inner", "function") for each in value.iter_subtrees())
    return letters <= {*symbols_in(value)} and bool(letters) and not usual
