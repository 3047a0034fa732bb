"""The ways to prove what is not so, one by one: none of them works."""

from fractions import Fraction
from importlib import import_module
from itertools import repeat
from math import prod

import pytest
import sympy
from cases import for_each

from algebroproj_sym.expressions import Matrix, determinant, over
from algebroproj_sym.proving import UndefinedError, constrained, prove
from algebroproj_sym.proving.engines import ENGINES, ring

proving_module = import_module("algebroproj_sym.proving.prove")
field_module = import_module("algebroproj_sym.proving.rational_function")

x, y, z = sympy.symbols("x y z")
a, b, c, d = sympy.symbols("a b c d")
each_engine = pytest.mark.parametrize("engine", ["flint", "sympy"])


def unproved(proof):
    """Open, with a reason, and without anything that could be taken for evidence."""
    return proof.verdict == "open" and proof.counterexample is None and bool(proof.certificate["reason"])


# -- a denominator in the ideal of the constraints --------------------------------------------------------------------

DET = determinant(Matrix([[a, b], [c, d]]))
SINGULAR = {a: 1, b: 2, c: 3, d: 6}
VANISHING = {
    "a variable": (over(x, z), over(y, z), [z], {x: 1, y: 2, z: 0}),
    "a determinant": (over(x, DET), over(y, DET), [DET], SINGULAR),
    "a multiple of a determinant": (over(x, DET), over(y, DET), [DET * (z**2 + 1)], SINGULAR),
    "a power as constraint": (over(x, DET), over(y, DET), [DET**2], SINGULAR),
    "a power as denominator": (over(x, DET**3), over(y, DET**3), [DET], SINGULAR),
    "a factor": (over(x, z * DET), over(y, z * DET), [DET], SINGULAR),
    "in two steps": (over(x, z - 1), over(y, z - 1), [z - a, a - 1], {z: 1, a: 1}),
    "nested": (over(1, over(DET, x)), over(1, over(DET, y)), [DET], SINGULAR),
    "cancelling": (over(DET, DET), 1, [DET], SINGULAR),
    "true elsewhere": (over(x * DET, DET), x, [DET], SINGULAR),
    "one entry of two": (sympy.Matrix([1, over(x, DET)]), sympy.Matrix([1, over(y, DET)]), [DET], SINGULAR),
    "the constraint itself": (x, y, [over(DET, DET)], None),
}


@pytest.mark.parametrize(("engine", "given"), [("flint", True), ("flint", False), ("sympy", True)])
@pytest.mark.parametrize(("lhs", "rhs", "constraints", "witness"), VANISHING.values(), ids=VANISHING)
def test_a_denominator_that_vanishes_on_the_constraints_proves_nothing(engine, lhs, rhs, constraints, witness, given):
    assert unproved(prove(lhs, rhs, constraints=constraints, witness=witness if given else None, engine=engine))


@each_engine
def test_a_nonzero_condition_that_fails_on_the_constraints_proves_nothing(engine):
    assert unproved(prove(x, y, constraints=[DET], nonzero=[DET], engine=engine))
    assert unproved(prove(x, y, constraints=[DET], nonzero=[DET], witness=SINGULAR, engine=engine))
    assert unproved(prove(x, y, constraints=[x * y], nonzero=[x, y], engine=engine))


@each_engine
def test_conditions_that_never_hold_prove_nothing(engine):
    never = (x + 1) ** 2 - x**2 - 2 * x - 1
    assert unproved(prove(x, y, nonzero=[never], engine=engine))
    assert unproved(prove(x, y, constraints=[x - z], nonzero=[never], engine=engine))


@each_engine
def test_the_denominators_are_in_the_certificate(engine):
    proof = prove(over(x, DET), over(y, DET), constraints=[x - y], engine=engine)
    assert proof.verdict == "proved"
    assert [sympy.expand(h - DET) for h in proof.hypotheses] == [0]
    assert [sympy.expand(sympy.sympify(written) - DET) for written in proof.certificate["denominators"]] == [0]
    witness = {name: sympy.Rational(value) for name, value in proof.certificate["witness"].items()}
    assert DET.subs(witness) != 0
    assert (x - y).subs(witness) == 0


# -- inconsistent constraints -----------------------------------------------------------------------------------------

INCONSISTENT = {
    "one is zero": [1],
    "a number is zero": [Fraction(-3, 7)],
    "hidden number": [(x + 1) ** 2 - x**2 - 2 * x],
    "two values": [x, x - 1],
    "a product without factors": [x * y - 1, x],
    "parallel planes": [x + y + z, x + y + z - 1],
    "no real point": [x**2 + 1],
    "no real point in two variables": [x**2 + y**2 + 1],
    "a pole": [over(1, x)],
}


@each_engine
@pytest.mark.parametrize("constraints", INCONSISTENT.values(), ids=INCONSISTENT)
@pytest.mark.parametrize(("lhs", "rhs"), [(x, x + 1), (x**2, x**2)])
def test_inconsistent_constraints_prove_and_refute_nothing(engine, constraints, lhs, rhs):
    assert unproved(prove(lhs, rhs, constraints=constraints, engine=engine))


@for_each("constraints", [*list(INCONSISTENT.values())[:-1], [x - 1, y - 2]])
def test_a_witness_that_violates_a_constraint_is_refused(constraints):
    with pytest.raises(ValueError, match=r"^witness: expected a point with .* = 0"):
        prove(x, y, constraints=constraints, witness={x: 1, y: 1, z: 1})


def test_a_witness_must_satisfy_every_constraint():
    with pytest.raises(ValueError, match="witness: expected a point with y - 2 = 0"):
        prove(x, y, constraints=[x - 1, y - 2, z - 3], witness={x: 1, y: 1, z: 3})


def test_a_witness_is_checked_exactly():
    near = {x: Fraction(141421356237309504880, 10**20)}
    with pytest.raises(ValueError, match="witness"):
        prove(x**4, 4, constraints=[x**2 - 2], witness=near)


@each_engine
def test_a_witness_where_a_denominator_vanishes_is_no_evidence(engine):
    circle = [x**2 + y**2 - 1]
    lhs, rhs = over(1 - x, y), over(y, 1 + x)
    for pole in ({x: 1, y: 0}, {x: -1, y: 0}):
        proof = prove(lhs, rhs, constraints=circle, witness=pole, engine=engine)
        assert proof.certificate["witness"]["y"] != "0"
    defined = {x: Fraction(-3, 5), y: Fraction(4, 5)}
    assert prove(lhs, rhs, constraints=circle, witness=defined, engine=engine).verdict == "proved"


@each_engine
def test_a_witness_where_a_condition_fails_is_no_evidence(engine):
    arguments = {"constraints": [x * (y**2 - 1)], "nonzero": [x, z], "engine": engine}
    for witness in ({x: 0, y: 1, z: 1}, {x: 1, y: 1, z: 0}, {x: 1, y: 1, z: 1}):
        proof = prove(y**4, 1, witness=witness, **arguments)
        assert proof.verdict == "proved"
        assert "0" not in proof.certificate["witness"].values()


@each_engine
@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_one_entry_that_is_proved_does_not_prove_the_other(engine, order):
    lhs, rhs = ([pair[i] for i in order] for pair in ((x**2, x), (1, 1)))
    proof = prove(sympy.Matrix(lhs), sympy.Matrix(rhs), constraints=[x**2 - 1], witness={x: 1}, engine=engine)
    assert proof.verdict == "refuted"
    assert proof.counterexample == {x: -1}


# -- the limits of ideal membership and of the search for points ------------------------------------------------------


@each_engine
def test_what_needs_a_radical_is_proved_by_a_power(engine):
    proof = prove(x, 0, constraints=[x**2], witness={x: 0}, engine=engine)
    assert (proof.verdict, proof.certificate["entries"][0]["exponent"]) == ("proved", 2)


@each_engine
def test_what_is_true_over_the_reals_alone_is_proved_by_squares(engine):
    for side, constraint in ((0, x**2 + y**2), (1, x**3 - 1)):
        proof = prove(x, side, constraints=[constraint], engine=engine)
        assert (proof.verdict, proof.certificate["method"]) == ("proved", "sums of squares")


IRRATIONAL = {
    "true on the square root of two": (x**4, 4, [x**2 - 2]),
    "true on the cube root of two": (x**6, 4, [x**3 - 2]),
    "true on a circle without rational points": ((x**2 + y**2) ** 2, 9, [x**2 + y**2 - 3]),
    "false on the square root of two": (x, 1, [x**2 - 2]),
    "false on a circle without rational points": (x, y, [x**2 + y**2 - 3]),
}


@each_engine
@pytest.mark.parametrize(("lhs", "rhs", "constraints"), IRRATIONAL.values(), ids=IRRATIONAL)
def test_without_rational_points_an_irrational_one_decides(request, engine, lhs, rhs, constraints):
    proof = prove(lhs, rhs, constraints=constraints, engine=engine)
    assert proof.verdict == ("proved" if "true on" in request.node.callspec.id else "refuted")
    assert "extension" in proof.certificate


@each_engine
def test_what_is_true_at_every_rational_point_but_not_at_every_real_one_is_not_proved(engine):
    assert prove(x, 0, constraints=[x * (x**2 - 2)], witness={x: 0}, engine=engine).verdict == "refuted"


@each_engine
def test_what_is_true_modulo_a_prime_is_refuted(engine):
    assert prove(x**7, x, engine=engine).verdict == "refuted"
    assert prove((x + y) ** 5, x**5 + y**5, engine=engine).verdict == "refuted"
    assert prove(x + 2**61 * y - y, x, engine=engine).verdict == "refuted"


VANISHES_ON_INTEGERS = {
    "up to 2": x * (x**2 - 1) * (x**2 - 4),
    "up to 3": prod((x - k for k in range(-3, 4)), start=sympy.Integer(1)),
    "up to 12": prod((x - k for k in range(-12, 13)), start=sympy.Integer(1)),
    "up to 25": prod((x - k for k in range(-25, 26)), start=sympy.Integer(1)),
    "in two variables": prod(((x - k) * (y - k) for k in range(-12, 13)), start=sympy.Integer(1)),
    "multiplied out": sympy.expand(prod((x - k for k in range(-8, 9)), start=sympy.Integer(1))),
    "all but fractions": over(prod((x - k for k in range(-12, 13)), start=sympy.Integer(1)), 2 * x - 1),
}


@each_engine
@pytest.mark.parametrize("polynomial", VANISHES_ON_INTEGERS.values(), ids=VANISHES_ON_INTEGERS)
def test_what_vanishes_on_small_integers_is_still_refuted(engine, polynomial):
    proof = prove(polynomial, 0, engine=engine)
    assert proof.verdict == "refuted"
    point = {s: sympy.Rational(v.numerator, v.denominator) for s, v in proof.counterexample.items()}
    value = polynomial.doit().subs(point)
    assert value.is_Rational
    assert value != 0


@each_engine
def test_a_search_that_finds_no_counterexample_proves_nothing(monkeypatch, engine):
    on_the_axis = {x: Fraction(0), y: Fraction(3)}
    monkeypatch.setattr(proving_module, "rational_points", lambda *_: repeat(on_the_axis))
    assert unproved(prove(x * y, 0, engine=engine))
    assert unproved(prove(sympy.Matrix([1, x]), sympy.Matrix([1, 0]), engine=engine))


@each_engine
def test_a_search_on_constraints_that_finds_no_counterexample_proves_nothing(monkeypatch, engine):
    at_one = [Fraction(1), Fraction(1), Fraction(1)]
    monkeypatch.setattr(constrained, "real_points", lambda *_, **options: iter([list(at_one) for _ in range(9)]))
    assert unproved(prove(x, 1, constraints=[x - y], engine=engine))


# -- what SymPy would do to an expression -----------------------------------------------------------------------------


@each_engine
def test_a_cancelled_division_is_still_a_hypothesis(engine):
    assert prove(over(x, x), 1, engine=engine).hypotheses == (x,)
    assert prove(over(0, x), 0, engine=engine).hypotheses == (x,)
    assert prove(over(x, y) * over(y, x), 1, engine=engine).hypotheses == (x, y)


@each_engine
@pytest.mark.parametrize(
    "name", ["E", "I", "N", "O", "Q", "S", "beta", "gamma", "zeta", "lambda", "pi", "oo", "GF", "zoo"]
)
def test_a_reserved_name_is_a_symbol_like_any_other(engine, name):
    symbol = sympy.Symbol(name)
    proof = prove(over(symbol**2 - x**2, symbol - x), symbol + x, engine=engine)
    assert proof.verdict == "proved"
    assert [sympy.expand(h**2 - (symbol - x) ** 2) for h in proof.hypotheses] == [0]
    refuted = prove(symbol, 1, engine=engine)
    assert (refuted.verdict, set(refuted.counterexample)) == ("refuted", {symbol})
    constrained = prove(symbol**2, x**2, constraints=[symbol - x], engine=engine)
    assert (constrained.verdict, set(constrained.certificate["witness"])) == ("proved", {name, "x"})


@each_engine
def test_the_symbols_e_s_and_n_are_no_constants(engine):
    e, s, n = map(sympy.Symbol, "ESN")
    assert prove(over(e * s, n) * n, s * e, engine=engine).hypotheses == (n,)
    assert prove(e, sympy.Rational(2718281828, 10**9), engine=engine).verdict == "refuted"


# -- engines that fail ------------------------------------------------------------------------------------------------


class EngineError(Exception):
    pass


def failing(*_):
    raise EngineError


STATEMENTS = {
    "true": (over(x, y) * y, x, ()),
    "true under constraints": (x**2, y**2, (x - y,)),
    "zero on the points of the filter": (x * (x**2 - 1) * (x**2 - 4) * (x**2 - 9) * (x**2 - 16) * (x**2 - 25), 0, ()),
    "undefined": (over(1, over(x, x) - 1), 0, ()),
}


@each_engine
@pytest.mark.parametrize(("lhs", "rhs", "constraints"), STATEMENTS.values(), ids=STATEMENTS)
def test_an_engine_that_does_not_load_gives_no_verdict(monkeypatch, engine, lhs, rhs, constraints):
    monkeypatch.setattr(field_module, "ring", failing)
    with pytest.raises(EngineError):
        prove(lhs, rhs, constraints=constraints, engine=engine)


@pytest.mark.parametrize(("engine", "of_engine"), [(engine, type(ring(engine, []))) for engine in ENGINES])
@pytest.mark.parametrize("method", ["__init__", "constant", "terms", "factor"])
def test_an_engine_that_fails_midway_gives_no_verdict(monkeypatch, engine, of_engine, method):
    monkeypatch.setattr(of_engine, method, failing)
    with pytest.raises(EngineError):
        prove(over(x, y) + 1, over(x + y, y), engine=engine)


@pytest.mark.parametrize(("engine", "of_engine"), [(engine, type(ring(engine, []))) for engine in ENGINES])
def test_an_engine_that_fails_while_looking_for_cofactors_gives_no_verdict(monkeypatch, engine, of_engine):
    monkeypatch.setattr(of_engine, "polynomial", failing)
    with pytest.raises(EngineError):
        prove(x**2, y**2, constraints=[x - y], engine=engine)


@pytest.mark.parametrize(("engine", "of_engine"), [(engine, type(ring(engine, []))) for engine in ENGINES])
def test_cofactors_that_do_not_multiply_out_are_not_believed(monkeypatch, engine, of_engine):
    honest = of_engine.polynomial
    monkeypatch.setattr(of_engine, "polynomial", lambda self, terms: honest(self, {p: v + 1 for p, v in terms.items()}))
    assert unproved(prove(x**2, y**2, constraints=[x - y], engine=engine))


@each_engine
def test_an_undefined_statement_is_an_error_and_no_verdict(engine):
    with pytest.raises(UndefinedError):
        prove(over(x, over(y, y) - 1), over(x, over(y, y) - 1), engine=engine)
