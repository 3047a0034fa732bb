"""Expressions as text, letter by letter what `str` of SymPy gives, in a fraction of the time.

Each part is written once for all the expressions that share it, and terms and factors are put in order by the names of
their symbols.  Whatever else may occur in an expression is left to SymPy's own printer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import Any, NamedTuple

import sympy
from sympy.printing.precedence import PRECEDENCE, precedence
from sympy.printing.str import StrPrinter

from algebroproj_sym.expressions.quotient import over

REMEMBERED = 1 << 18

_SUM, _PRODUCT, _POWER = PRECEDENCE["Add"], PRECEDENCE["Mul"], PRECEDENCE["Pow"]
_FUNCTION, _ATOM = PRECEDENCE["Func"], PRECEDENCE["Atom"]
_SYMPY = {True: StrPrinter(), False: StrPrinter({"order": "none"})}

Written = tuple[str, int]


class _Style(NamedTuple):
    """Whether terms and factors are put in order, and whether a remembered quotient is written as a fraction."""

    ordered: bool
    fractions: bool


class _OtherError(Exception):
    """Something that is left to SymPy."""


class _Printer(StrPrinter):  # type: ignore[misc]
    """SymPy's printer of matrices and tuples, with entries written here."""

    def _print(self, node: Any, **options: Any) -> str:
        if type(node) in _WRITERS:
            return _written(node, _Style(self.order is None, fractions=False))[0]
        return str(super()._print(node, **options))


def written(expression: Any, *, ordered: bool = True, fractions: bool = False) -> str:
    """Return an expression, a matrix or a tuple of expressions as SymPy writes it.

    Parameters
    ----------
    expression : sympy.Basic or sympy matrix
        What to write.
    ordered : bool
        Whether to put terms and factors in order, as `str` does, or to leave them as they are stored.
    fractions : bool
        Whether to write a remembered quotient as a fraction, so that the text shows every division that was made.

    Examples
    --------
    >>> x, y = sympy.symbols("x y")
    >>> written((x + y) * y**2 / (2 * x) - 1)
    '-1 + y**2*(x + y)/(2*x)'
    >>> written(over(x, x) * y, fractions=True)
    'y*(x/x)'
    """
    style = _Style(ordered, fractions)
    if type(expression) in _WRITERS:
        return _written(expression, style)[0]
    if isinstance(expression, sympy.MatrixBase) and (ordered or fractions) and 0 not in expression.shape:
        rows = (", ".join(_written(entry, style)[0] for entry in expression.row(i)) for i in range(expression.rows))
        return f"Matrix([{', '.join(f'[{row}]' for row in rows)}])"
    return str(_Printer({} if ordered else {"order": "none"}).doprint(expression))


@lru_cache(maxsize=REMEMBERED)
def _written(node: Any, style: _Style) -> Written:
    """Return the text of an expression, and how tightly it binds."""
    write = _WRITERS.get(type(node))
    try:
        if write is not None:
            return write(node, style)
    except _OtherError:
        if style.fractions:
            return _as_stored(node, style)
    return _SYMPY[style.ordered].doprint(node), precedence(node)


def _as_stored(node: Any, style: _Style) -> Written:
    """Return the text of a sum, product or integer power, part by part."""
    if type(node) is sympy.Pow:
        base, exponent = node.args
        return f"{_within(base, _POWER, style)}**({exponent.p})", _POWER
    level, sign = (_SUM, " + ") if type(node) is sympy.Add else (_PRODUCT, "*")
    return sign.join(_within(argument, level, style) for argument in node.args), level


def _within(node: Any, level: int, style: _Style) -> str:
    text, binding = _written(node, style)
    return f"({text})" if binding <= level else text


def _symbol(node: Any, style: _Style) -> Written:
    return node.name, _ATOM


def _number(node: Any, style: _Style) -> Written:
    if node.q == 1:
        return str(node.p), _SUM if node.p < 0 else _ATOM
    return f"{node.p}/{node.q}", _SUM if node.p < 0 else _PRODUCT


def _quotient(node: Any, style: _Style) -> Written:
    if style.fractions:
        above, below = node.args
        return f"{_within(above, _SUM, style)}/{_within(below, _PRODUCT, style)}", _PRODUCT
    return f"over({', '.join(_written(argument, style)[0] for argument in node.args)})", _FUNCTION


def _power(node: Any, style: _Style) -> Written:
    base, exponent = node.args
    if not exponent.is_Integer:
        raise _OtherError
    below = _within(base, _POWER, style)
    if exponent.p == -1:
        return f"1/{below}", _POWER
    return f"{below}**{exponent.p}" if exponent.p >= 0 else f"{below}**({exponent.p})", _POWER


def _sum(node: Any, style: _Style) -> Written:
    parts: list[str] = []
    for term in _ordered_terms(node) if style.ordered else node.args:
        text = _written(term, style)[0]
        nested = type(term) is sympy.Add
        negative = text[0] == "-" and not nested
        parts += ("-" if negative else "+", f"({text})" if nested else text[negative:])
    sign = "-" if parts[0] == "-" else ""
    return sign + " ".join(parts[1:]), _SUM


def _product(node: Any, style: _Style) -> Written:
    coefficient, factors = _split(node)
    level = _SUM if coefficient.p < 0 else _PRODUCT
    above = [str(abs(coefficient.p))] if abs(coefficient.p) != 1 else []
    below = [str(coefficient.q)] if coefficient.q != 1 else []
    for factor in _ordered_factors(factors) if style.ordered else factors:
        if type(factor) is not sympy.Pow or factor.exp.p >= 0:
            above.append(_within(factor, level, style))
        elif factor.exp.p == -1:
            below.append(_within(factor.base, level, style))
        else:
            below.append(f"{_within(factor.base, _POWER, style)}**{-factor.exp.p}")
    text = ("-" if coefficient.p < 0 else "") + ("*".join(above) or "1")
    if below:
        text += f"/{below[0]}" if len(below) == 1 else f"/({'*'.join(below)})"
    return text, level


def _split(product: Any) -> tuple[Any, tuple[Any, ...]]:
    """Return the coefficient of a product, and its factors: symbols, sums, quotients and their integer powers."""
    first, *rest = product.args
    if first is sympy.S.One:
        raise _OtherError
    coefficient, factors = (first, tuple(rest)) if first.is_Rational else (sympy.S.One, product.args)
    for factor in factors:
        base = factor
        if type(factor) is sympy.Pow:
            base, exponent = factor.args
            if not exponent.is_Integer:
                raise _OtherError
        if type(base) not in _BASES:
            raise _OtherError
    return coefficient, factors


def _ordered_factors(factors: Iterable[Any]) -> list[Any]:
    """Put symbols and their powers in the order of their names, and what is compound after them."""
    symbols: list[tuple[str, int, Any]] = []
    compound: list[Any] = []
    for factor in factors:
        base, exponent = (factor.base, factor.exp.p) if type(factor) is sympy.Pow else (factor, 1)
        if type(base) is sympy.Symbol:
            symbols.append((base.name, exponent, factor))
        else:
            compound.append(factor)
    symbols.sort(key=_name_and_exponent)
    return [symbol for _, _, symbol in symbols] + _sorted(compound)


def _name_and_exponent(entry: tuple[str, int, Any]) -> tuple[str, int]:
    return entry[:2]


def _sorted(compound: list[Any]) -> list[Any]:
    return sorted(compound, key=_sort_key) if len(compound) > 1 else compound


@lru_cache(maxsize=REMEMBERED)
def _sort_key(node: Any) -> Any:
    return node.sort_key()


def _ordered_terms(node: Any) -> list[Any]:
    """Put the terms of a sum in order: by the exponents of the symbols, which go by their names."""
    if len(node.args) == 2 and _is_number_less_product(*node.args):
        return list(node.args)
    powers = [_powers(term) for term in node.args]
    bases = {base for found in powers for base in found}
    symbols = sorted((base for base in bases if type(base) is sympy.Symbol), key=_name)
    compound = _sorted([base for base in bases if type(base) is not sympy.Symbol])
    place = {base: i for i, base in enumerate([*symbols, *compound])}
    keys = []
    for found in powers:
        key = [0] * len(place)
        for base, exponent in found.items():
            key[place[base]] = -exponent
        keys.append(key)
    if len({*map(tuple, keys)}) < len(keys):
        raise _OtherError
    return [node.args[i] for i in sorted(range(len(keys)), key=keys.__getitem__)]


def _is_number_less_product(number: Any, product: Any) -> bool:
    """Whether SymPy writes the number first, as in 1 - 2*x."""
    if not number.is_Rational or number.p <= 0 or type(product) is not sympy.Mul or len(product.args) != 2:
        return False
    return any(factor.is_Rational and factor.p < 0 for factor in product.args)


def _name(symbol: Any) -> str:
    return str(symbol.name)


def _powers(term: Any) -> dict[Any, int]:
    """Return the exponents of a term's symbols, sums and quotients."""
    if term.is_Rational:
        return {}
    factors = _split(term)[1] if type(term) is sympy.Mul else (term,)
    found = {}
    for factor in factors:
        base, exponent = factor.args if type(factor) is sympy.Pow else (factor, sympy.S.One)
        if type(base) not in _BASES or not exponent.is_Integer:
            raise _OtherError
        found[base] = exponent.p
    return found


_BASES = (sympy.Symbol, sympy.Add, over)
_WRITERS: dict[Any, Callable[[Any, _Style], Written]] = {
    sympy.Symbol: _symbol,
    over: _quotient,
    sympy.Add: _sum,
    sympy.Mul: _product,
    sympy.Pow: _power,
    **{type(number): _number for number in map(sympy.sympify, (0, 1, -1, 2, "1/2", "1/3"))},
}
