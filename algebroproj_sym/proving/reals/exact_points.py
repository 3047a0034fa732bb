"""Points of exact numbers at which a statement may say something: angles, solutions of equations, ends of ranges."""

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations
from typing import Any

import sympy

from algebroproj_sym.expressions import NotRationalError, ParseError
from algebroproj_sym.proving.points import seed_of
from algebroproj_sym.proving.reals.reading import expression_of, term_of
from algebroproj_sym.replaying.reals import Statement
from algebroproj_sym.replaying.reals.definitions import is_affine, kinds, replaced
from algebroproj_sym.replaying.reals.terms import (
    CALCULUS,
    PI,
    Term,
    constant,
    function,
    negative,
    over,
    plus,
    power,
    read,
    times,
    written,
)

MOST_OCCURRENCES = 200
MOST_ENDS = 2
MOST_PARTS = 40
"""How many parts a side may have whose derivative is factored."""

_NUMBERS = "0 1 -1 2 1/2 -1/2 -2 3/5 sqrt(2)/2 exp(1) 1/3 3 sqrt(3)/2 sqrt(2)"
_ANGLES = "0 pi/2 pi pi/4 pi/3 pi/6 -pi/2 -pi 2*pi/3 -pi/4 3*pi/4 -pi/3 3*pi/2 2*pi -2*pi 1 -1 1/2"
NUMBERS, ANGLES = ([*map(read, texts.split())] for texts in (_NUMBERS, _ANGLES))
TURNING = frozenset({"sin", "cos", "tan", "cot", "sec", "csc"})

Point = Mapping[str, Term]


def exact_points(statement: Statement, tries: int) -> Iterator[Point]:
    """Yield points that satisfy the equations among the conditions as far as these could be solved.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.comparisons import comparisons
    >>> given = tuple(comparisons("x + y = pi"))
    >>> point = next(exact_points(Statement(read("sin(x)"), read("sin(y)"), given), 1))
    >>> {name: written(value) for name, value in point.items()}
    {'y': '0', 'x': 'pi - 0'}
    """
    names = sorted(statement.symbols())
    equations = [term for relation, term in statement.given if relation == "="]
    ends = [term for relation, term in statement.known() if relation in (">", ">=") and not kinds(term) & CALCULUS]
    ends += _slopes(statement, names)
    pools = {name: ANGLES if _turns(statement, name) else NUMBERS for name in names}
    generator = random.Random(seed_of(written(statement.left), written(statement.right)))
    chosen = [list[Term]()] + [
        list(some) for size in range(1, MOST_ENDS + 1) for some in combinations(dict.fromkeys(ends), size)
    ]
    found, seen = 0, set[tuple[Term, ...]]()
    rounds, solved = 0, list[list[list[tuple[str, Term]]]]()
    while names and rounds < tries and found < tries:
        for place, some in enumerate(chosen):
            if rounds == 0:
                solved.append([])
            for solution in solved[place] if rounds else _kept(_solved([*equations, *some], names), solved[place]):
                point = _filled(solution, names, pools, generator, rounds)
                key = tuple(point[name] for name in names)
                if key not in seen:
                    seen.add(key)
                    found += 1
                    yield point
        rounds += 1


def _slopes(statement: Statement, names: Sequence[str]) -> list[Term]:
    """Return factors of the derivatives of the difference of two sides: where they are zero, it may be least."""
    if len(names) > MOST_ENDS or any(kinds(side) & CALCULUS or side.size() > MOST_PARTS for side in statement.sides):
        return []
    try:
        difference = expression_of(plus(statement.left, negative(statement.right)))
        symbols = sorted(difference.free_symbols, key=str)
        factored = [sympy.factor_list(sympy.diff(difference, symbol))[1] for symbol in symbols]
        return [term_of(factor, "a factor") for factors in factored for factor, _ in factors]
    except (ParseError, NotRationalError, sympy.PolynomialError, TypeError, ValueError, RecursionError):
        return []


def _turns(statement: Statement, name: str) -> bool:
    """Whether a symbol occurs in the argument of a sine or its like."""
    terms = (*statement.sides, *(term for _, term in statement.given))
    return any(part.kind in TURNING and name in part.symbols() for term in terms for part in term.parts())


def _solved(equations: Sequence[Term], names: Sequence[str]) -> Iterator[list[tuple[str, Term]]]:
    """Yield symbols with what they are in terms of those that come later, as the first equations say."""
    if not equations:
        yield []
        return
    first, *others = equations
    for name in names:
        for value in solutions(first, name):
            rest = [replaced(other, name, value) for other in others]
            if any(other.size() > MOST_OCCURRENCES for other in rest):
                continue
            for solution in _solved(rest, [other for other in names if other != name]):
                yield [(name, value), *solution]
            break
        else:
            continue
        return


def _kept(solutions: Iterator[list[tuple[str, Term]]], kept: list[list[tuple[str, Term]]]) -> Iterator[Any]:
    """Yield solutions, and keep them."""
    for solution in solutions:
        kept.append(solution)
        yield solution


def _filled(
    solution: Sequence[tuple[str, Term]],
    names: Sequence[str],
    pools: Mapping[str, Sequence[Term]],
    generator: random.Random,
    number: int,
) -> dict[str, Term]:
    bound = {name for name, _ in solution}
    point: dict[str, Term] = {}
    same = generator.random() < 0.2
    place = generator.randrange(len(ANGLES))
    for name in names:
        if name not in bound:
            pool = pools[name][: 6 + number]
            point[name] = pool[place % len(pool)] if same else generator.choice(pool)
    for name, value in reversed(solution):
        for other, number_there in point.items():
            value = replaced(value, other, number_there)
        point[name] = value
    return point


def solutions(term: Term, name: str) -> list[Term]:
    """Return values of a symbol for which a term is zero, if the symbol occurs once, or in the first degree.

    Examples
    --------
    >>> [written(value) for value in solutions(read("cos(f) - a/r"), "f")]
    ['acos(a/r)', '-acos(a/r)']
    >>> [written(value) for value in solutions(read("x + x*y - 1"), "x")]
    ['-(0 + 0*y - 1)/((1 + 1*y - 1) - (0 + 0*y - 1))']
    """
    count = sum(part == Term("symbol", name) for part in term.parts())
    if not count or kinds(term) & CALCULUS:
        return []
    if count == 1:
        return _inverted(term, name, constant(0))
    if is_affine(term, name):
        at_zero, at_one = (replaced(term, name, constant(value)) for value in (0, 1))
        return [over(negative(at_zero), _minus(at_one, at_zero))]
    return []


def _minus(left: Term, right: Term) -> Term:
    return left if right == constant(0) else negative(right) if left == constant(0) else plus(left, negative(right))


def _inverted(term: Term, name: str, value: Term) -> list[Term]:
    """Return values of a symbol, which occurs once, for which a term has a value."""
    if term.kind == "symbol":
        return [value]
    place = next(place for place, part in enumerate(term.args) if name in part.symbols())
    inner, others = term.args[place], [part for k, part in enumerate(term.args) if k != place]
    if term.kind == "+":
        for other in others:
            value = plus(value, negative(other)) if value != constant(0) else negative(other)
            value = value.args[0].args[0] if value.kind == "-" and value.args[0].kind == "-" else value
        found = [value]
    elif term.kind == "-":
        found = [value.args[0] if value.kind == "-" else negative(value)]
    elif term.kind == "*":
        found = [over(value, others[0])]
    elif term.kind == "/":
        found = [times(value, others[0]) if place == 0 else over(others[0], value)]
    elif term.kind == "^":
        root = power(value, Fraction(1) / term.value) if term.value else value
        found = [root, negative(root)] if term.value.numerator % 2 == 0 else [root]
    else:
        found = [made(value) for made in _INVERSES.get(term.kind, ())]
    return [solution for each in found for solution in _inverted(inner, name, each)]


def _by(name: str) -> Callable[[Term], Term]:
    return lambda value: function(name, value)


_INVERSES: Mapping[str, Sequence[Callable[[Term], Term]]] = {
    "sin": (_by("asin"), lambda value: plus(PI, negative(function("asin", value)))),
    "cos": (_by("acos"), lambda value: negative(function("acos", value))),
    "tan": (_by("atan"),),
    "asin": (_by("sin"),),
    "acos": (_by("cos"),),
    "atan": (_by("tan"),),
    "exp": (_by("log"),),
    "log": (_by("exp"),),
    "sqrt": (lambda value: power(value, 2),),
    "abs": (lambda value: value, negative),
    "sinh": (_by("asinh"),),
    "cosh": (_by("acosh"),),
    "tanh": (_by("atanh"),),
    "asinh": (_by("sinh"),),
    "acosh": (_by("cosh"),),
    "atanh": (_by("tanh"),),
}
