"""Single changes of a printed form, of the sort that a misprint makes."""

import random
import re
from collections.abc import Iterator, Sequence
from decimal import Decimal
from typing import Any, NamedTuple

import sympy

from algebroproj_sym.declaring import Claim, Statement
from algebroproj_sym.expressions import TextForm, entries, over, written
from algebroproj_sym.mutating.letters import changes_in_letters


class Mutant(NamedTuple):
    """A changed form and what was changed."""

    change: str
    form: Statement


def mutants(claim: Claim) -> list[Mutant]:
    """Return all single changes of the printed form of a claim, in a fixed order, each form once.

    A sign, an index, a prime, an integer, a factor, an exponent, a numerator against its denominator; of a matrix also
    the exchange of neighbours and an entry that is missing; of a decimal number each digit to each other one, the last
    digit with a carry, and the sign.

    Examples
    --------
    >>> from algebroproj_sym import Section
    >>> x, y1, y2 = sympy.symbols("x y1 y2")
    >>> claim = Section("demo", "1", "Squares").identity("1.1", "quotient", printed=y1 - y2, derived=y1 - y2)
    >>> sorted(str(mutant.form) for mutant in mutants(claim))
    ['-y1 - y2', '0', 'y1', 'y1 + y2', 'y1 - 1']
    """
    printed: Any = claim.printed
    seen: set[Any] = {printed}
    found = []
    for change, form in _changes(claim, printed):
        if form not in seen:
            seen.add(form)
            found.append(Mutant(change, form))
    return sorted(found, key=lambda mutant: mutant.change) if claim.kind == "structure" else found


def _changes(claim: Claim, printed: Any) -> Iterator[tuple[str, Any]]:
    if isinstance(printed, TextForm):
        yield from changes_in_letters(printed) if printed.letters else ()
        return
    if isinstance(printed, Decimal):
        yield from _of_decimal(printed)
    elif claim.kind in ("rank", "count"):
        yield "one more", printed + 1
        yield "one less", printed - 1
    elif claim.kind == "reference":
        for place, number in enumerate(printed):
            yield f"number {place + 1}", _replaced(printed, place, number + 1)
    elif claim.kind == "structure":
        yield from _of_pattern(printed)
    elif isinstance(printed, tuple):
        yield from _of_factors(printed)
    elif isinstance(printed, sympy.MatrixBase):
        yield from _of_matrix(printed)
    else:
        yield from _of_expression(printed, _siblings(printed.free_symbols))


def _of_decimal(printed: Decimal) -> Iterator[tuple[str, Decimal]]:
    _, digits, exponent = printed.as_tuple()
    for change, changed in changed_digits(f"{printed:f}"):
        yield change, Decimal(changed)
    unit = Decimal((0, (1,), int(exponent)))
    yield "last digit, one more", printed + unit
    yield "last digit, one less", printed - unit
    if any(digits):
        yield "sign", printed.copy_negate()


def changed_digits(text: str) -> Iterator[tuple[str, str]]:
    """Yield a number with each of its digits changed to each other digit.

    Examples
    --------
    >>> [*changed_digits("-0.1")][8:10]
    [('digit 1: 9', '-9.1'), ('digit 2: 0', '-0.0')]
    """
    places = [place for place, character in enumerate(text) if character.isdigit()]
    for count, place in enumerate(places, start=1):
        for new in "0123456789".replace(text[place], ""):
            yield f"digit {count}: {new}", f"{text[:place]}{new}{text[place + 1 :]}"


def _of_pattern(printed: Any) -> Iterator[tuple[str, Any]]:
    names = sorted(printed.free_symbols, key=str)
    for place, mark in enumerate(printed):
        where = f"entry {place + 1}"
        if mark != 0:
            yield f"{where}: sign", _replaced(printed, place, -mark)
            yield f"{where}: zero", _replaced(printed, place, sympy.Integer(0))
        for name in names:
            yield f"{where}: {name}", _replaced(printed, place, name)


def _of_factors(printed: tuple[Any, ...]) -> Iterator[tuple[str, Any]]:
    siblings = _siblings({symbol for factor in printed for symbol in factor.free_symbols})
    for place, factor in enumerate(printed):
        before, after = printed[:place], printed[place + 1 :]
        if len(printed) > 1:
            yield f"factor {place + 1}: missing", (*before, *after)
        for change, form in _of_expression(factor, siblings):
            yield f"factor {place + 1}: {change}", (*before, form, *after)


def _of_matrix(printed: Any) -> Iterator[tuple[str, Any]]:
    siblings = _siblings(printed.free_symbols)
    values = entries(printed)
    for place, entry in enumerate(values):
        where = f"entry {place + 1}"
        yield f"{where}: missing", _replaced(printed, place, sympy.Integer(int(entry == 0)))
        if place + 1 < len(values):
            exchanged = _replaced(_replaced(printed, place, values[place + 1]), place + 1, entry)
            yield f"{where}: exchanged with the next", exchanged
        for change, form in _of_expression(entry, siblings):
            yield f"{where}: {change}", _replaced(printed, place, form)


def _replaced(matrix: Any, place: int, entry: Any) -> Any:
    values = list(entries(matrix))
    values[place] = entry
    return sympy.ImmutableDenseMatrix(*matrix.shape, values)


def _siblings(symbols: Any) -> dict[Any, list[tuple[str, Any]]]:
    """Return, for each symbol, those that a slip of the pen turns it into: another index, another prime."""
    ordered = sorted(symbols, key=str)
    return {
        symbol: [
            (what, other)
            for what, alike in (("index", same_but_index), ("prime", _same_but_prime))
            for other in [next((o for o in ordered if o != symbol and alike(symbol.name, o.name)), None)]
            if other is not None
        ]
        for symbol in ordered
    }


def same_but_index(name: str, other: str) -> bool:
    """Whether two names differ in one digit."""
    differing = [(a, b) for a, b in zip(name, other, strict=False) if a != b]
    return len(name) == len(other) and len(differing) == 1 and "".join(differing[0]).isdecimal()


def _same_but_prime(name: str, other: str) -> bool:
    """Whether two names differ in the number of their primes, which are written as p."""
    plain = re.compile(r"(?<=[A-Za-z])p+")
    return name != other and plain.sub("", name) == plain.sub("", other)


def _of_expression(node: Any, siblings: dict[Any, list[tuple[str, Any]]]) -> Iterator[tuple[str, Any]]:
    """Yield the changes of an expression: first those of its top, then those of its arguments."""
    if node.is_Number:
        if node != 0:
            yield f"sign of {node}", -node
        yield f"integer {node}", node + 1
        return
    if node.is_Symbol:
        for what, other in siblings[node]:
            yield f"{what}: {node} for {other}", other
        return
    yield from _of_top(node)
    if isinstance(node, sympy.Pow):
        for change, form in _of_expression(node.base, siblings):
            if form != 0 or node.exp > 0:
                yield change, form**node.exp
        return
    for place, argument in enumerate(node.args):
        for change, form in _of_expression(argument, siblings):
            if not (isinstance(node, over) and place == 1 and form == 0):
                yield change, _with_argument(node, place, form)


def _with_argument(node: Any, place: int, argument: Any) -> Any:
    return node.func(*(argument if i == place else old for i, old in enumerate(node.args)))


def _of_top(node: Any) -> Iterator[tuple[str, Any]]:
    if isinstance(node, sympy.Add):
        for place, term in enumerate(node.args):
            yield f"sign of {_short(term)}", _with_argument(node, place, -term)
    elif isinstance(node, sympy.Mul):
        yield "sign of a product", -node
        for place, factor in enumerate(node.args):
            if not factor.is_Number:
                yield f"factor {_short(factor)}", _with_argument(node, place, sympy.Integer(1))
        if any(isinstance(factor, over) or _is_inverse(factor) for factor in node.args):
            yield "numerator and denominator exchanged", 1 / node
    elif isinstance(node, over):
        numerator, denominator = node.args
        if numerator != 0:
            yield "numerator and denominator exchanged", over(denominator, numerator)
        yield f"denominator {_short(denominator)} as a factor", numerator * denominator
    elif isinstance(node, sympy.Pow):
        yield f"exponent of {_short(node.base)} with the other sign", node.base**-node.exp
        yield f"exponent of {_short(node.base)}", node.base ** (node.exp + (1 if node.exp > 0 else -1))


def _is_inverse(factor: Any) -> bool:
    return isinstance(factor, sympy.Pow) and bool(factor.exp.is_negative)


def _short(expression: Any) -> str:
    text = written(expression)
    return text if len(text) <= 40 else f"{text[:37]}..."


def sampled(changes: Sequence[Any], limit: int, seed: int) -> list[Any]:
    """Return at most `limit` of some changes, chosen by a seed, in their order; all of them if the limit is 0."""
    if not limit or len(changes) <= limit:
        return list(changes)
    places = sorted(random.Random(seed).sample(range(len(changes)), limit))
    return [changes[place] for place in places]
