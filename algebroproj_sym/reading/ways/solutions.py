"""Solutions of differential equations: what satisfies one and its initial values is the only one that does.

The equation is one of a number.  It gives its highest derivative as a polynomial of the others, so that the theorem of
Picard and Lindelöf holds.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy
from lark import Token, Tree

from algebroproj_sym.expressions import over, shape
from algebroproj_sym.reading.asking.questions import Way
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.notation import (
    DOT,
    PARTIAL,
    PRIME,
    bare,
    derivative_in,
    derivatives_among,
    has_rate,
    order_of,
)
from algebroproj_sym.reading.defining.premises import MOST_TOGETHER, Premise, extended, letter_of, said_by
from algebroproj_sym.reading.defining.recognising import defined_by
from algebroproj_sym.reading.defining.vocabulary import UNCOMPUTED, Vocabulary
from algebroproj_sym.reading.deriving.asking import slope_of, unchanged
from algebroproj_sym.reading.deriving.components import column_of
from algebroproj_sym.reading.deriving.series import with_exponentials
from algebroproj_sym.reading.deriving.totals import AT_START
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, lone, symbols_in, trees_in, without_brackets
from algebroproj_sym.reading.remembering.memory import where_of
from algebroproj_sym.reading.remembering.standing import Standing
from algebroproj_sym.reading.ways.constraining import is_asserted

_WAVES = (sympy.sin, sympy.cos, sympy.exp)


@dataclass(frozen=True)
class _Unknown:
    """The function that a differential equation gives."""

    letter: str
    variable: str
    orders: Mapping[str, int]
    """How often each symbol of the document is derived that is this function or a derivative of it."""


@dataclass(frozen=True)
class _Initial:
    """An initial value: that of a derivative at a point."""

    order: int
    side: Formula
    point: Formula
    value: Formula
    where: str


def of_solutions(standing: Standing, left: Formula, right: Formula) -> Iterator[Way]:
    """Yield whether the right side satisfies a differential equation near it, and the initial values of its section."""
    letter, parameters = defined_by(left)
    if not letter or letter in symbols_in(right) or standing.vocabulary.is_matrix(letter) or len(parameters) > 1:
        return
    given = (each for each in standing.vocabulary.definitions.values() if each.part == standing.part)
    near = [each for each in standing.near(MOST_TOGETHER) if is_asserted(standing, each, is_last=True)]
    for each in [*near, *(each for each in map(said_by, given) if not each.special)]:
        for variable in parameters or _variables_of(letter, each):
            unknown = _Unknown(letter, variable, _orders(letter, variable, standing.survey.occurring))
            way = _solved(standing, each, unknown, right)
            yield from [] if way is None else [way]


def _variables_of(letter: str, premise: Premise) -> list[str]:
    """Return the letters by which an equation has a derivative of one."""
    below = {found.variable for each in premise.symbols if (found := derivative_in(each)) is not None}
    return [each for each in sorted({"t", *below} - {""}) if len(_orders(letter, each, premise.symbols)) > 1]


def _orders(letter: str, variable: str, symbols: frozenset[str]) -> dict[str, int]:
    """Return how often the symbols are derived that are a letter or a derivative of it.

    Dots and primes together are derivatives by two letters, and a prime of the variable is none.
    """
    found = {each: order_of(each, letter, variable) for each in symbols}
    orders = {symbol: order for symbol, order in found.items() if order is not None} | {letter: 0}
    signs = {slope.sign for each in orders if (slope := derivative_in(each)) is not None}
    return {letter: 0} if signs >= {DOT, PRIME} or f"{variable}'" in symbols else orders


def _solved(standing: Standing, premise: Premise, unknown: _Unknown, right: Formula) -> Way | None:
    """Return whether a formula satisfies an equation and as many initial values as its order asks for."""
    known, orders = standing.vocabulary, unknown.orders
    order = max((orders[each] for each in premise.symbols if each in orders), default=0)
    if not order or not _is_of_one(standing, unknown, premise, right):
        return None
    lead, initial = _leading(premise, unknown, order, known), _initial_values(standing, unknown, order)
    if lead is None or len(initial) < order or unknown.variable in known.definitions:
        return None
    letters = known.letters_of(*premise.sides, right)
    constant = sorted(letters - {*orders, unknown.variable})
    if _move(standing, premise, unknown, initial, constant):
        return None
    places = (*(each.where for each in initial), premise.where)
    solution = [
        Definition(_name(place), (unknown.variable,), slope_of(right, *[unknown.variable] * place), where, -1, True)
        for place, where in enumerate(places)
    ]
    values = [(_call(each.order, each.point), each.value) for each in initial]
    pairs = [premise.sides, *values]
    ours, theirs = (column_of(*(_put_in(with_exponentials(pair[side]), unknown) for pair in pairs)) for side in (0, 1))
    shown = f"{known.equation(letter_of(unknown.letter), right)}, as the solution of {premise.where}"
    supposes = [f"{premise.where} holds for every {known.name(unknown.variable)}{unchanged(constant, known)}"]
    supposes += [f"{lead} != 0"] if lead.free_symbols else []
    slopes = {each: derivative_in(each) for each in premise.symbols & {*orders}}
    signs = sorted(each for each, slope in slopes.items() if slope is not None and not slope.is_quotient)
    supposes += [f"{known.name(each)} is a derivative by {known.name(unknown.variable)}" for each in signs]
    supposes += [f"{known.equation(each.side, each.value)}, by {each.where}" for each in initial]
    return Way(ours, theirs, extended(known, solution), shown, supposes=tuple(supposes))


def _move(
    standing: Standing, premise: Premise, unknown: _Unknown, initial: Sequence[_Initial], letters: Collection[str]
) -> bool:
    """Whether some letters may change with the variable or the function; initial values are tied to it at one point."""
    known = standing.vocabulary
    free = {each for each in letters if not AT_START.search(each)}
    inner = {symbol for each in initial for symbol in (*symbols_in(each.value), *symbols_in(each.point))}
    return (
        any(has_rate(each, unknown.variable, standing.survey.occurring) for each in letters)
        or known.moves_with(free, unknown.variable)
        or known.moves_with(free - inner, unknown.letter, premise.symbols)
    )


def _is_of_one(standing: Standing, unknown: _Unknown, premise: Premise, right: Formula) -> bool:
    r"""Whether an equation has a function of one variable at this variable alone, unlike ``\dot x(t) = x(t - T)``."""
    known, formulas = standing.vocabulary, standing.survey.formulas.values()
    calls = [
        (call, [lone(without_brackets(each)) for items in trees_in(call) for each in trees_in(items)])
        for formula in formulas
        if isinstance(formula, Parsed)
        for side in formula.sides
        for call in side.find_data("call")
        if str(call.children[0]) in unknown.orders
    ]
    own = [call for side in premise.sides for call in side.find_data("call")]
    others = [call for call, letters in calls if call in own and letters != [unknown.variable]]
    used = (each for each in known.used_in(*premise.sides, right) if each.symbol not in unknown.orders)
    hidden = {symbol for each in used for symbol in symbols_in(each.tree)}
    slopes = derivatives_among(standing.survey.occurring)
    partly = any((each.sign, each.function) == (PARTIAL, bare(unknown.letter)) for each in slopes)
    return not (others or partly or hidden & {*unknown.orders}) and all(len(letters) == 1 for _, letters in calls)


def _leading(premise: Premise, unknown: _Unknown, order: int, known: Vocabulary) -> Any:
    """Return by what an equation multiplies its highest derivative; None if the theorem may not hold.

    Beside the function and its derivatives stand polynomials of the variable, sines, cosines and exponentials of such.
    """
    letters = [sympy.Symbol(known.name(_name(place))) for place in range(order + 1)]
    tree: Formula = Tree("sum", [premise.left, Token("SIGN", "-"), premise.right])
    try:
        value = known.value(_put_in(with_exponentials(tree), unknown, by_letters=True))
    except UNCOMPUTED:
        return None
    if shape(value):
        return None
    value = value.replace(over, lambda above, below: above / below)
    variable, waves = sympy.Symbol(known.name(unknown.variable)), value.atoms(*_WAVES)
    plain = value.xreplace(dict.fromkeys(waves, sympy.S.One))
    try:
        polynomial = sympy.Poly(value, *letters)
        smooth = [sympy.Poly(part, *letters, variable) for part in (plain, *(wave.args[0] for wave in waves))]
    except sympy.PolynomialError:
        return None
    lead = polynomial.coeff_monomial(letters[-1])
    rest = sympy.Poly(value - lead * letters[-1], *letters)
    is_given = bool(smooth) and rest.degree(letters[-1]) < 1 and lead != 0
    return lead if is_given and not lead.free_symbols & {*letters, variable} else None


def _initial_values(standing: Standing, unknown: _Unknown, order: int) -> list[_Initial]:
    """Return the last initial values of a section above an equation, or of its sentence, of each order at one point.

    A second value of an order begins another problem.
    """
    place = standing.beside.place
    found: dict[int, _Initial] = {}
    for statement in standing.survey.statements:
        formula = standing.survey.formulas[id(statement)]
        if statement.display.part != standing.part or statement.display.place >= place:
            continue
        if isinstance(formula, Parsed) and formula.relations == ("=",):
            for side, other in (formula.sides, formula.sides[::-1]):
                point = _point_in(side, unknown)
                if point is not None:
                    callee = unknown.orders[str(side.children[0])]
                    if callee in found and (found[callee].point, found[callee].value) != (point, other):
                        found = {}
                    found[callee] = _Initial(callee, side, point, other, where_of(statement))
    values = [found[place] for place in range(order) if place in found]
    return values if all(each.point == values[0].point for each in values) else []


def _point_in(side: Formula, unknown: _Unknown) -> Formula | None:
    """Return where a function or a derivative is taken, if that is no variable point."""
    if side.data != "call" or str(side.children[0]) not in unknown.orders:
        return None
    arguments = [each for items in trees_in(side) for each in trees_in(items)]
    is_fixed = len(arguments) == 1 and lone(without_brackets(arguments[0])) != unknown.variable
    return arguments[0] if is_fixed and unknown.variable not in symbols_in(arguments[0]) else None


def _put_in(tree: Formula, unknown: _Unknown, *, by_letters: bool = False) -> Formula:
    """Return a formula with the solution for the function, and its derivatives; or with letters for them."""
    name = str(tree.children[0]) if tree.data in ("symbol", "opaque", "call") else ""
    if name in unknown.orders and (tree.data != "call" or _point_in(tree, unknown) is None):
        order = unknown.orders[name]
        return letter_of(_name(order)) if by_letters else _call(order, letter_of(unknown.variable))
    parts: list[Any] = [
        _put_in(each, unknown, by_letters=by_letters) if isinstance(each, Tree) else each for each in tree.children
    ]
    return Tree(tree.data, parts)


def _name(order: int) -> str:
    return f"solution {order}"


def _call(order: int, point: Formula) -> Formula:
    return Tree("call", [Token("CALLEE", _name(order)), Tree("items", [point])])
