r"""The rate at which a formula changes, factor by factor, as ``\dot a \times b + a \times \dot b`` of ``a \times b``.

No factor changes its place, so this holds of vectors and matrices as well.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.labels import E
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import MOST_MATRIX_POWER
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in, tokens_in, trees_in, without_brackets

ONE: Formula = Tree("number", [Token("NUMBER", "1")])
ZERO: Formula = Tree("number", [Token("NUMBER", "0")])
TWO: Formula = Tree("number", [Token("NUMBER", "2")])
_MINUS_ONE: Formula = Tree("sum", [Token("SIGN", "-"), ONE])
MOST_COPIES = 20_000
_LINEAR = ("group", "bracket", "items", "cell")


def rate_of(
    tree: Formula, rates: Mapping[str, Formula], copies: Mapping[str, int] = MappingProxyType({})
) -> Formula | None:
    r"""Return the derivative of a formula; None if nothing in it changes.

    The rates are the derivatives of the letters that change, and of values such as ``x(t)``; of e as well, where it is
    Euler's number.  The copies say how often letters stand in the derivatives of those that are given by others.  It
    raises `UnreadableError` if something changes within what has no rule here, or the derivative would have too many
    terms.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> from algebroproj_sym.reading.parsing.writing import text_of
    >>> (side,) = parsed(r"\frac12 m x^2 + A y").sides
    >>> rate = {"x": parsed("v").sides[0], "y": parsed("w").sides[0]}
    >>> text_of(rate_of(side, rate), str)
    '(1/2*m*(v*x + x*v)) + (A*w)'
    """
    if copies_in(tree, copies) > MOST_COPIES:
        raise UnreadableError("the derivative of something in it has too many terms")
    return _rate(tree, rates)


def copies_in(tree: Formula, copies: Mapping[str, int]) -> int:
    """Return about how often letters stand in the derivative of a formula."""
    own = copies.get(str(tree.children[0]), 1) if tree.data in ("symbol", "opaque") else 1
    within = max((copies_in(each, copies) for each in trees_in(tree)), default=own)
    if tree.data in ("run", "product", "sum"):
        return len(trees_in(tree)) * within
    return 4 * within if tree.data in ("power", "fraction", "quotient", "root", "norm", "inner") else within


def _rate(tree: Formula, rates: Mapping[str, Formula]) -> Formula | None:
    if tree.data in ("symbol", "opaque"):
        return rates.get(str(tree.children[0]))
    if tree.data == "call" and (known := rates.get(written(tree))) is not None:
        return known
    if not any(each in rates for each in (*symbols_in(tree), *map(written, tree.find_data("call")))):
        return None
    if tree.data == "sum":
        return _sum_of(tree, rates)
    if tree.data in ("run", "product"):
        places = [(place, each) for place, each in enumerate(tree.children) if isinstance(each, Tree)]
        rated = [_with(tree, place, _rate(each, rates)) for place, each in places]
        return _sum([("+", each) for each in rated if each is not None])
    if tree.data == "fraction" or (tree.data == "quotient" and len(tree.children) == 2):
        above, below = trees_in(tree)
        return _of_fraction(above, below, rates)
    if tree.data == "power":
        base, exponent = trees_in(tree)
        return _of_power(base, exponent, rates)
    if tree.data == "function" and tree.children[0] in ("sin", "cos", "tan", "exp", "ln", "log"):
        return _of_function(tree, rates)
    if tree.data == "function" and tree.children[0] in ("tr", "Tr", "trace", "dev", "sym"):
        return _with(tree, 1, _rate(trees_in(tree)[0], rates))
    if tree.data == "function" and tree.children[0] == "det":
        return _of_determinant(tree, rates)
    if tree.data in ("root", "norm"):
        return _of_length(tree, rates)
    if tree.data == "inner" and len(items := _items(tree)) == 2:
        return _sum([("+", each) for place in (0, 1) if (each := _of_item(tree, items, place, rates)) is not None])
    if tree.data == "big" and str(tree.children[0]).startswith(r"\sum"):
        return _with(tree, 1, _rate(trees_in(tree)[0], rates))
    if tree.data == "marked" and tree.children[1] in ("T", "hat", "vee"):
        return _with(tree, 0, _rate(trees_in(tree)[0], rates))
    if tree.data in _LINEAR and len(tree.children) == 1:
        return _with(tree, 0, _rate(trees_in(tree)[0], rates))
    if tree.data in ("matrix", "row") and "vmatrix" not in str(tree.children[0]):
        parts: list[Any] = [each if isinstance(each, Token) else _or_zero(each, rates) for each in tree.children]
        return Tree(tree.data, parts)
    raise UnreadableError("the derivative of something in it is not computed")


def written(call: Formula) -> str:
    r"""Return a value such as ``x(t)`` as text; empty if it is more."""
    name, *rest = tokens_in(call)
    return f"{name}({rest[0]})" if len(rest) == 1 else ""


def _with(tree: Formula, place: int, part: Any) -> Formula | None:
    parts: list[Any] = [*tree.children[:place], part, *tree.children[place + 1 :]]
    return None if part is None else Tree(tree.data, parts)


def _or_zero(tree: Formula, rates: Mapping[str, Formula]) -> Formula:
    """Return the rate of an entry, or of each entry of a row; zero if it does not change."""
    if tree.data in ("row", "cell"):
        parts: list[Any] = [_or_zero(each, rates) for each in trees_in(tree)]
        return Tree(tree.data, parts)
    return _rate(tree, rates) or ZERO


def _sum(terms: list[tuple[str, Formula]]) -> Formula | None:
    signed: list[Any] = [part for sign, term in terms for part in (Token("SIGN", sign), term)]
    return Tree("sum", signed) if terms else None


def _sum_of(tree: Formula, rates: Mapping[str, Formula]) -> Formula | None:
    parts = tree.children if isinstance(tree.children[0], Token) else [Token("SIGN", "+"), *tree.children]
    pairs = [(str(sign), _rate(term, rates)) for sign, term in zip(parts[::2], parts[1::2], strict=True)]  # type: ignore[arg-type]  # signs and trees take turns
    return _sum([(sign, rate) for sign, rate in pairs if rate is not None])


def _of_fraction(above: Formula, below: Formula, rates: Mapping[str, Formula]) -> Formula | None:
    first, second = _rate(above, rates), _rate(below, rates)
    terms: list[tuple[str, Formula]] = [] if first is None else [("+", Tree("fraction", [first, below]))]
    if second is not None:
        square: Formula = Tree("run", [below, below])
        product: Formula = Tree("run", [second, above])
        terms.append(("-", Tree("fraction", [product, square])))
    return _sum(terms)


def _items(tree: Formula) -> list[Formula]:
    """Return what stands in the brackets of an inner product."""
    return trees_in(trees_in(tree)[0])


def _of_item(tree: Formula, items: Sequence[Formula], place: int, rates: Mapping[str, Formula]) -> Formula | None:
    """Return an inner product with the rate of one vector."""
    rate = _rate(items[place], rates)
    return None if rate is None else Tree("inner", [Tree("items", [*items[:place], rate, *items[place + 1 :]])])


def _of_length(tree: Formula, rates: Mapping[str, Formula]) -> Formula | None:
    """Return the rate of a root, or of the length of a vector."""
    (inside,) = trees_in(tree)
    rate = _rate(inside, rates)
    if rate is None:
        return None
    if tree.data == "norm":
        return Tree("fraction", [Tree("inner", [Tree("items", [inside, rate])]), tree])
    return Tree("fraction", [rate, Tree("run", [TWO, tree])])


def _of_power(base: Formula, exponent: Formula, rates: Mapping[str, Formula]) -> Formula | None:
    """Return the rate of a power with a small whole exponent: that of a product of so many factors.

    The square of a length is an inner product, and e has the rate of the exponent as a factor.
    """
    while exponent.data == "group":
        (exponent,) = trees_in(exponent)
    if base.data == "norm" and exponent == TWO:
        return _rate(Tree("inner", [Tree("items", [*trees_in(base), *trees_in(base)])]), rates)
    if base == E and E.children[0] in rates and (rate := _rate(exponent, rates)) is not None:
        return Tree("chained", [Tree("power", [base, exponent]), rate])
    times = str(exponent.children[0]) if exponent.data == "number" else ""
    if exponent == _MINUS_ONE:
        rate = _rate(base, rates)
        inverse: Formula = Tree("power", [base, exponent])
        return None if rate is None else _sum([("-", Tree("run", [inverse, Tree("group", [rate]), inverse]))])
    if not times and _rate(exponent, rates) is None:
        rate = _rate(base, rates)
        slope: Formula = Tree(
            "fraction", [Tree("run", [Tree("group", [exponent]), Tree("power", [base, exponent])]), base]
        )
        return None if rate is None else Tree("chained", [slope, Tree("group", [rate])])
    if not (times.isdigit() and 1 < int(times) <= MOST_MATRIX_POWER):
        raise UnreadableError("the derivative of a power in it is not computed")
    return _rate(Tree("run", [base] * int(times)), rates)


def _of_determinant(tree: Formula, rates: Mapping[str, Formula]) -> Formula | None:
    r"""Return the rate of a determinant: ``\det A \, \mathrm{tr}(A^{-1} \dot A)``."""
    (inside,) = trees_in(tree)
    rate, matrix = _rate(inside, rates), Tree("group", [without_brackets(inside)])
    if rate is None:
        return None
    product: Formula = Tree("run", [Tree("power", [matrix, _MINUS_ONE]), Tree("group", [without_brackets(rate)])])
    return Tree("run", [tree, Tree("function", [Token("FUNCTION", "tr"), Tree("items", [product])])])


def _of_function(tree: Formula, rates: Mapping[str, Formula]) -> Formula | None:
    name, inside = str(tree.children[0]), trees_in(tree)[0]
    rate = _rate(inside, rates)
    if rate is None:
        return None
    if rate.data == "items":
        (rate,) = trees_in(rate)
    if name == "tan":
        square: Formula = Tree("power", [tree, TWO])
        return Tree("chained", [Tree("sum", [ONE, Token("SIGN", "+"), square]), rate])
    if name in ("ln", "log"):
        return Tree("fraction", [rate, *(trees_in(inside) if inside.data == "items" else [inside])])
    other: Formula = Tree("function", [Token("FUNCTION", {"sin": "cos", "cos": "sin"}.get(name, name)), inside])
    sign = "-" if name == "cos" else "+"
    return _sum([(sign, Tree("chained", [other, rate]))])
