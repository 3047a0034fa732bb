"""Certificates of ranks, counts, vanishing expressions, patterns and limits, put together from pieces.

Each is right in most places: values at a point are computed, factors are those of SymPy.  So the place that is wrong
decides.  What is replayed is compared with what SymPy finds.  Some of it must be replayed, or the search says nothing.
"""

import random

import pytest
import sympy
from sympy.polys.matrices import DomainMatrix
from test_forgeries import entry, limit_of

from algebroproj_sym.replaying import replay_claim

X, Y, T = sympy.symbols("x y t")
PIECES = ("0", "1", "x", "y", "-x", "x + y", "x*y", "x**2", "2*x", "x - y")
POINTS = ({X: 2, Y: 3}, {X: 0, Y: 0}, {X: 1, Y: 1}, {X: 1, Y: -1}, {X: 5, Y: 0})
GENERIC = {X: sympy.Rational(1009, 17), Y: sympy.Rational(-7919, 23)}
TRIED = 250


def names(*expressions):
    return {symbol.name for expression in expressions for symbol in expression.free_symbols}


def exact(point, wanted):
    return {symbol.name: str(value) for symbol, value in point.items() if symbol.name in wanted}


def places(draw, limit, size):
    return sorted(draw.sample(range(limit), min(size, limit)))


def minor(draw, matrix, size):
    """Rows and columns, and the determinant that they have in a matrix of numbers."""
    size = max(0, min(size, *matrix.shape))
    rows, columns = places(draw, matrix.rows, size), places(draw, matrix.cols, size)
    return {"rows": rows, "columns": columns, "minor": str(matrix.extract(rows, columns).det())}


def kernel(draw, matrix):
    """Vectors, of the kernel or any, and a minor that shows them to be independent at a point."""
    rows = DomainMatrix.from_Matrix(matrix).to_field().nullspace().to_Matrix()
    true = [
        (row.T * sympy.prod(map(sympy.denom, row))).applyfunc(sympy.cancel) for row in map(rows.row, range(rows.rows))
    ]
    any_vector = sympy.Matrix([sympy.sympify(draw.choice(PIECES)) for _ in range(matrix.cols)])
    vectors = draw.choice([true, true, true[:1] * 2, [*true[:1], any_vector], true[1:]])
    if not vectors:
        return {"kernel": []}
    point, rows = draw.choice(POINTS), places(draw, matrix.cols, len(vectors))
    at_point = sympy.Matrix.hstack(*vectors).subs(point)
    return {
        "kernel": [str(vector) for vector in vectors], "kernel at": exact(point, names(*vectors)), "kernel rows": rows,
        "kernel minor": str(at_point.extract(rows, [*range(len(rows))]).det()),
    }  # fmt: skip


def claimed_rank(draw, kind, matrix, derived, symbols, setting):
    """A claim of a rank, proved or refuted, and whether it is true."""
    true = matrix.subs(GENERIC).rank()
    claimed, point = true + draw.choice([0, 0, 1, -1]), draw.choice(POINTS)
    below, above = minor(draw, matrix.subs(point), draw.choice([true, claimed, claimed + 1])), kernel(draw, matrix)
    way = draw.choice(["proved", "larger", "smaller"])
    at_point = exact(point, symbols)
    if way == "proved":
        evidence = {"method": "rank at a point and kernel vectors", "point": at_point, **below, **above}
        record = entry(kind, str(claimed), derived, evidence, setting=setting, hypotheses=[])
        return record, claimed == true
    if way == "larger":
        evidence = {"method": "counterexample", "rank": len(below["rows"]), **below}
    else:
        evidence = {"method": "kernel vectors", "rank at most": matrix.cols - len(above["kernel"]), **above}
    record = entry(
        kind, str(claimed), derived, evidence, "false", setting=setting, hypotheses=[], instead="1.2",
        counterexample=at_point if way == "larger" else {},
    )  # fmt: skip
    return record, claimed != true


def rank(draw):
    shape = draw.randint(1, 2), draw.randint(1, 3)
    matrix = sympy.Matrix(*shape, [sympy.sympify(draw.choice(PIECES)) for _ in range(shape[0] * shape[1])])
    return claimed_rank(draw, "rank", matrix, str(matrix), names(matrix), {})


def count(draw):
    functions = sympy.Matrix([sympy.sympify(draw.choice(PIECES)) for _ in range(draw.randint(1, 3))])
    variables = draw.choice([[X], [Y], [X, Y]])
    setting = {"variables": [variable.name for variable in variables]}
    symbols = names(functions) | {*setting["variables"]}
    return claimed_rank(draw, "count", functions.jacobian(variables), str(functions), symbols, setting)


FACTORS = ("x", "y", "x - y", "x + y", "x**2 - y", "x**2 - y**2", "x*y", "2*x", "x - 1")


def powers(expression):
    content, factors = sympy.factor_list(expression, X, Y)
    return content, [[str(factor), int(power)] for factor, power in factors]


def vanishing(draw):
    """An expression, and the factors it is said to vanish with."""
    product = sympy.prod(sympy.sympify(draw.choices(FACTORS, k=draw.randint(1, 3))))
    below = sympy.sympify(draw.choice(["1", "1", *FACTORS]))
    derived = product / below
    above = sympy.numer(sympy.cancel(derived))
    printed = sympy.sympify(draw.choices(FACTORS, k=draw.randint(1, 2)))
    if draw.random() < 0.5:
        of_above = [factor for factor, _ in sympy.factor_list(above, X, Y)[1]]
        printed = of_above[draw.choice([0, 0, 1]) :] or printed
    content, factors = powers(product)
    of_below, divisors = powers(below)
    nonzero = draw.choice([[], [], [draw.choice(FACTORS)]])
    listed = [name for name, _ in divisors]
    factors = draw.choice([factors, factors, factors[1:]])
    given = {name for name, _ in factors}
    wanted = {name for factor in printed for name, _ in powers(factor)[1]}
    excluded = sorted(given & draw.choice([{*listed}, given - wanted, set()]))
    evidence = {
        "method": "factorisation", "content": str(content / of_below), "factors": factors, "denominator": divisors,
        "printed": [powers(factor)[1] for factor in printed], "excluded": excluded,
    }  # fmt: skip
    text = "(" + "".join(f"{factor}, " for factor in printed) + ")"
    record = entry(
        "vanishing", text, f"({product})/({below})", evidence, hypotheses=listed,
        setting={"nonzero": nonzero} if nonzero else {},
    )  # fmt: skip
    allowed = {name for divisor in [*listed, *nonzero] for name, _ in powers(sympy.sympify(divisor))[1]}
    zeros = {name for name, _ in powers(product)[1]} - allowed
    return record, zeros == wanted - allowed


def structure(draw):
    """A matrix and a pattern of it; the pattern of the certificate is the printed one."""
    entries = draw.choices(("0", "x", "-x", "y", "x + y - y", "x*y/y", "2*x - x", "1"), k=4)
    marks = [{"0": "0", "1": "1", "y": "b", "x + y - y": "a", "-x": "-a"}.get(text, "a") for text in entries]
    for place in draw.sample(range(4), draw.choice([0, 1, 1, 2])):
        marks[place] = draw.choice(("0", "a", "-a", "b", "-b", "1", "c"))
    pattern = {}
    for place, mark in enumerate(marks, start=1):
        sign = -1 if mark.startswith("-") else 1
        pattern.setdefault(mark.lstrip("-"), []).append(sign * place)
    hypotheses = ["y"] if "x*y/y" in entries else []
    record = entry(
        "structure", "Matrix([[{}, {}], [{}, {}]])".format(*marks), "Matrix([[{}, {}], [{}, {}]])".format(*entries),
        {"method": "normal form", "denominators": hypotheses, "pattern": pattern}, hypotheses=hypotheses,
    )  # fmt: skip
    values: dict[str, set] = {}
    for mark, text in zip(marks, entries, strict=True):
        value = sympy.cancel(text)
        values.setdefault(mark.lstrip("-"), set()).add(-value if mark.startswith("-") else value)
    true = all(
        len(found) == 1 and (found == {sympy.Integer(mark)} if mark.isdecimal() else 0 not in found)
        for mark, found in values.items()
    )
    return record, true


PARTS = ("x", "y", "t", "t*x", "x + t", "1", "t**2", "x - y", "x*t + y")


def limit(draw):
    """A quotient, its limit where t goes to zero, or another one, and orders that are counted or not."""
    above, below = (sympy.prod(sympy.sympify(draw.choices(PARTS, k=2))) for _ in range(2))
    value = sympy.cancel(above / below)
    order = min(sympy.Poly(above, T).monoms())[0] - min(sympy.Poly(below, T).monoms())[0]
    true = sympy.cancel(value.subs(T, 0)) if order >= 0 else None
    printed = draw.choice([true if true is not None else X, sympy.sympify(draw.choice(PARTS)), sympy.Integer(0)])
    divisors = [str(factor) for factor, _ in sympy.factor_list(below)[1]]
    lowest = sympy.Poly(below, T).coeffs()[-1]
    hypotheses = draw.choice([[str(f) for f, _ in sympy.factor_list(lowest)[1]], []])
    orders = [order + draw.choice([0, 0, 0, 1, -1])]
    record = limit_of(str(printed), f"({above})/({below})", divisors, orders, hypotheses)
    return record, true is not None and sympy.cancel(true - printed) == 0


@pytest.mark.whole
@pytest.mark.parametrize("kind", [rank, count, vanishing, structure, limit], ids=lambda kind: kind.__name__)
def test_what_is_replayed_is_true(kind):
    draw, replayed = random.Random(kind.__name__), 0
    for _ in range(TRIED):
        record, true = kind(draw)
        if replay_claim(record).status == "replayed":
            assert true, record
            replayed += 1
    assert replayed >= TRIED / 20
