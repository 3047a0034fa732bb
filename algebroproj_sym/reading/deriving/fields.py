r"""Vector fields: what ``\nabla``, ``\partial_t`` and ``\frac{\partial}{\partial x}`` make of formulas, by components.

Each letter is a smooth function of x, y, z and t.  Its derivatives are letters of their own, the same in any order.
So ``\nabla \cdot (\nabla \times \mathbf{A}) = 0`` is an equation of polynomials.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from functools import partial
from typing import Any

import sympy
from lark import Token, Tree

from algebroproj_sym.expressions import Matrix, require_bounded, shape, vector
from algebroproj_sym.reading.defining.identifiers import ZERO
from algebroproj_sym.reading.defining.notation import PARTIAL, derivative_in
from algebroproj_sym.reading.lexing.commands import VECTOR_STYLE
from algebroproj_sym.reading.lexing.names import bare_name
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import slope_of
from algebroproj_sym.reading.parsing.grammar import Formula, trees_in
from algebroproj_sym.reading.parsing.operators import Applied

SPACE = "xyz"
COORDINATES = (*SPACE, "t")
ALONG = ("along", "along, without brackets")
r"""``(u \cdot \nabla) v``, and ``u \cdot \nabla v``, which a few authors mean otherwise."""


class Fields:
    """What operators make of values: their letters are functions of place and time, but for those that are constant."""

    def __init__(self, constant: frozenset[str]) -> None:
        self._constant = constant
        self._derivatives: dict[Any, tuple[str, str]] = {}

    def operated(self, kind: str, values: Sequence[Any]) -> Any:
        r"""Return what an operator makes of the last value: ``(u \cdot \nabla) v`` has two."""
        *before, value = values
        found = self._applied(kind, value, *before)
        require_bounded(found, "what an operator makes")
        return found

    def _applied(self, kind: str, value: Any, along: Any = None) -> Any:
        if kind.startswith("partial"):
            return self._by(value, kind[-1])
        if kind in ALONG:
            return _summed(along[i] * self._by(value, letter) for i, letter in enumerate(SPACE))
        if kind == "lap":
            return _summed(self._by(self._by(value, letter), letter) for letter in SPACE)
        if kind == "grad":
            if shape(value):
                raise UnreadableError("the gradient of a vector is not computed")
            return vector(*(self._by(value, letter) for letter in SPACE))
        if shape(value) != (3,):
            raise UnreadableError(f"an operator takes a vector of three entries, got {shape(value) or 'a number'}")
        slopes = [[self._by(entry, letter) for letter in SPACE] for entry in value]
        if kind == "div":
            return sympy.Add(*(slopes[i][i] for i in range(3)))
        return vector(*(slopes[k][j] - slopes[j][k] for j, k in ((1, 2), (2, 0), (0, 1))))

    def _by(self, value: Any, letter: str) -> Any:
        """Return the derivative of a value, or of its entries, by a coordinate."""
        if shape(value):
            return Matrix(value.rows, value.cols, [self._by(entry, letter) for entry in value])
        symbols = sorted(value.free_symbols, key=str)
        return sympy.Add(*(slope_of(value, each) * self._derivative(each, letter) for each in symbols))

    def _derivative(self, symbol: Any, letter: str) -> Any:
        """Return the letter of a derivative; zero for a constant."""
        base, below = self._derivatives.get(symbol, (symbol.name, ""))
        if base in self._constant:
            return sympy.S.Zero
        below = "".join(sorted(below + letter))
        found = sympy.Symbol(f"d{below}__{base}")
        self._derivatives[found] = base, below
        return found

    def takes(self, name: str) -> bool:
        """Whether each value of a function that is computed elsewhere is a letter here."""
        return False

    def logarithm(self, value: Any) -> Any:
        """Return the logarithm of a value."""
        return sympy.log(value)

    def big(self, name: str, body: Any) -> Any:
        """Refuse a sum, a product, an integral or a limit."""
        raise UnreadableError(f"{name} is read, but not computed with fields")

    def call(self, name: str, arguments: Sequence[Any]) -> Any:
        """Refuse the value of a function that nothing defines."""
        raise UnreadableError(f"{name} with arguments is not computed with fields")

    known = call

    def slope(self, value: Any, variable: Any) -> Any:
        """Refuse another derivative."""
        raise UnreadableError("a derivative by another letter is not computed with fields")


def _summed(values: Iterable[Any]) -> Any:
    first, *others = values
    return sum(others, first)


def components_of(symbol: str, name: str, letters: Collection[str]) -> dict[str, Any]:
    r"""Return the values of a vector and of its components, which are among some letters: ``v_x`` beside ``\vec v``.

    Examples
    --------
    >>> components_of(r"\vec{v}", "v", {"v_x", "v_y", "v_z", "u_x"})["v_y"]
    v__y
    """
    entries = {letter: sympy.Symbol(f"{name}__{letter}") for letter in SPACE}
    thin = re.sub(rf"{VECTOR_STYLE}|[{{}}]", "", symbol)
    named = {f"{thin}_{letter}": entry for letter, entry in entries.items()}
    return {symbol: vector(*entries.values())} | (named if named.keys() <= {*letters} else {})


def with_operators_apart(tree: Any, applied: Mapping[str, Applied], letters: Mapping[str, str]) -> Any:
    r"""Return a formula in which operators stand before what they are applied to.

    So does a derivative that is one letter, such as ``\partial u/\partial t``.  The letters have their bare names.  It
    raises `UnreadableError` if a derivative is by no coordinate.
    """
    if not isinstance(tree, Tree):
        return tree
    inside: Callable[[Any], Any] = partial(with_operators_apart, applied=applied, letters=letters)
    name = str(tree.children[0]) if tree.data in ("symbol", "opaque", "big") else ""
    if ZERO.fullmatch(name):
        return Tree("number", [Token("NUMBER", "0")])
    if tree.data != "big" and (operator := applied.get(name)) is not None:
        require_coordinate(operator.kind)
        return operated(operator.kind, *map(inside, filter(None, (operator.by, operator.body))))
    slope = derivative_in(name) if "/" in name else None
    is_partial = slope is not None and slope.sign == PARTIAL and len(slope.letters) < 3
    if slope is None or not (is_partial and all(re.fullmatch("[a-z]", each) for each in slope.letters)):
        if name.startswith(r"\partial") and "/" in name:
            raise UnreadableError(f"{name} is no derivative by a coordinate")
        changed: Formula = Tree(tree.data, [*map(inside, tree.children)])
        return changed
    body = inside(tree.children[1]) if tree.data == "big" else _letter(letters, slope.function)
    for kind in (f"partial {letter}" for letter in slope.letters[::-1]):
        require_coordinate(kind)
        body = operated(kind, body)
    return body


def operated(kind: str, *parts: Formula) -> Formula:
    """Return an operator with what it is applied to as a formula."""
    sign: list[Any] = [Token("OPERATOR", kind)]
    return Tree("operated", [*sign, *parts])


def require_coordinate(kind: str) -> None:
    """Refuse a derivative by what is no coordinate."""
    operator, _, letter = kind.partition(" ")
    if operator == "partial" and letter not in COORDINATES:
        raise UnreadableError(f"{letter} is no coordinate")


def _letter(letters: Mapping[str, str], above: str) -> Formula:
    """Return the letter above the line of a derivative."""
    if re.search(r"[()\s+*]", above) or above in COORDINATES:
        raise UnreadableError(f"{above} is no letter of a field")
    return Tree("symbol", [Token("SYMBOL", letters.get(bare_name(above), above))])


def vectors_in(tree: Formula) -> set[str]:
    """Return the lone letters of which a formula has the divergence or the curl: they are vectors."""
    found = set()
    for part in tree.find_data("operated"):
        body = trees_in(part)[-1]
        if str(part.children[0]) in ("div", "curl") and body.data == "symbol":
            found.add(str(body.children[0]))
    return found
