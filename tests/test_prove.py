"""What is true is proved, what is false is refuted by a point, and both engines agree."""

import dataclasses
import operator
import os
import subprocess
import sys
from fractions import Fraction

import pytest
import sympy
from cases import for_each
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from algebroproj_sym.expressions import Matrix, NotRationalError, inverse, over, solve, vector
from algebroproj_sym.proving import UndefinedError, prove

x, y, z = sympy.symbols("x y z")
each_engine = pytest.mark.parametrize("engine", ["flint", "sympy"])


def substituted(expression, point):
    """The value at a point, by SymPy's substitution into the divided expression."""
    exact = {s: sympy.Rational(v.numerator, v.denominator) for s, v in point.items()}
    return sympy.sympify(expression).doit().subs(exact)


def differ(lhs, rhs, point):
    """Whether two expressions have different rational values at a point."""
    values = [substituted(side, point) for side in (lhs, rhs)]
    if isinstance(lhs, sympy.MatrixBase):
        return all(entry.is_Rational for side in values for entry in side) and values[0] != values[1]
    return all(value.is_Rational for value in values) and values[0] != values[1]


# -- rational identities ----------------------------------------------------------------------------------------------

TRUE = {
    "difference of squares": ((x**2 - y**2) / (x - y), x + y),
    "binomial": ((x + y) ** 3, x**3 + 3 * x**2 * y + 3 * x * y**2 + y**3),
    "partial fractions": (over(1, x * (x + 1)), over(1, x) - over(1, x + 1)),
    "cancelling": (over(x, x), 1),
    "continued fraction": (over(1, 1 + over(1, 1 + over(1, x))), over(x + 1, 2 * x + 1)),
    "sign": (over(x, y - x), over(-x, x - y)),
    "Lagrange": ((x**2 + y**2) * (z**2 + 1), (x * z + y) ** 2 + (x - y * z) ** 2),
    "negative powers": (over(x, y) ** -3, y**3 / x**3),
    "a number": (x - x + Fraction(1, 2), Fraction(2, 4)),
}
FALSE = {
    "square": (x**2, x),
    "sign": (over(x, x - y), over(x, y - x)),
    "a number": (over(1, x) + 1, over(1, x) + 2),
    "a small coefficient": (x + y, x + y + z / 10**30),
    "an exponent": ((x + y) ** 2, x**2 + y**2),
    "a variable": (x, y),
    "an inverse": (over(x, y), over(y, x)),
}


@each_engine
@pytest.mark.parametrize(("lhs", "rhs"), TRUE.values(), ids=TRUE)
def test_true_identities_are_proved(engine, lhs, rhs):
    proof = prove(lhs, rhs, engine=engine)
    assert proof.verdict == "proved"
    assert proof.certificate["method"] == "normal form"
    assert proof.counterexample is None
    assert proof.engine == engine


@each_engine
@pytest.mark.parametrize(("lhs", "rhs"), FALSE.values(), ids=FALSE)
def test_false_identities_are_refuted_by_a_point_where_the_sides_differ(engine, lhs, rhs):
    proof = prove(lhs, rhs, engine=engine)
    assert proof.verdict == "refuted"
    assert set(proof.counterexample) == lhs.free_symbols | rhs.free_symbols
    assert all(isinstance(value, Fraction) for value in proof.counterexample.values())
    assert differ(lhs, rhs, proof.counterexample)


def test_a_refutation_shows_both_values():
    lhs, rhs = over(x, y), over(y, x)
    proof = prove(lhs, rhs)
    assert proof.certificate["left"] == [str(substituted(lhs, proof.counterexample))]
    assert proof.certificate["right"] == [str(substituted(rhs, proof.counterexample))]


HYPOTHESES = {
    "a divisor that cancels": (over(x, x), 1, {x}),
    "a power": (over(x, x**3), over(1, x**2), {x}),
    "factors": (over(x - y, x**2 - y**2), over(1, x + y), {x - y, x + y}),
    "either side": (over(x, x), over(y, y), {x, y}),
    "content and sign": (over(x, 6 - 6 * x), over(-x, 6 * x - 6), {x - 1}),
    "nested": (over(1, over(x, y)), over(y, x), {x, y}),
    "nested sums": (over(1, 1 + over(1, x)), over(x, x + 1), {x, x + 1}),
    "a divisor over itself": (over(1, over(x + y, x + y)), 1, {x + y}),
    "numbers": (over(x, 3), x / 3, set()),
    "no divisor": (x * (x + 1), x**2 + x, set()),
    "an irreducible quadric": (over(x**2 + y**2, x**2 + y**2), 1, {x**2 + y**2}),
    "a negative power": ((x - y) ** -2 * (x - y) ** 3, x - y, set()),
}


@each_engine
@pytest.mark.parametrize(("lhs", "rhs", "factors"), HYPOTHESES.values(), ids=HYPOTHESES)
def test_hypotheses_are_the_irreducible_factors_of_all_divisors(engine, lhs, rhs, factors):
    proof = prove(lhs, rhs, engine=engine)
    assert proof.verdict == "proved"
    assert set(proof.hypotheses) == factors
    assert len(proof.hypotheses) == len(factors)


def test_hypotheses_are_in_the_certificate_as_text():
    proof = prove(over(x - y, x**2 - y**2), over(1, x + y))
    assert set(map(sympy.sympify, proof.certificate["denominators"])) == {x - y, x + y}


# -- matrices ---------------------------------------------------------------------------------------------------------

GENERAL = Matrix(3, 3, sympy.symbols("a:3:3"))


@each_engine
def test_the_general_inverse_is_proved_on_both_sides(engine):
    unit = Matrix.eye(3)
    for product in (GENERAL * inverse(GENERAL), inverse(GENERAL) * GENERAL):
        proof = prove(product, unit, engine=engine)
        assert proof.verdict == "proved"
        assert [sympy.expand(h - sympy.Matrix(GENERAL).det(method="berkowitz")) for h in proof.hypotheses] == [0]


@each_engine
def test_the_general_solution_is_proved(engine):
    b = vector(*sympy.symbols("b:3"))
    assert prove(GENERAL * solve(GENERAL, b), b, engine=engine).verdict == "proved"


@each_engine
@pytest.mark.parametrize("place", [(0, 0), (0, 1), (1, 2), (2, 2)])
def test_one_wrong_entry_refutes_a_matrix(engine, place):
    right = sympy.Matrix([[x, over(1, y), 0], [x * y, 1, z], [x + y, over(x, x), -z]])
    wrong = right.copy()
    wrong[place] += x
    proof = prove(right, wrong, engine=engine)
    assert proof.verdict == "refuted"
    assert differ(right, wrong, proof.counterexample)
    assert prove(right, right, engine=engine).verdict == "proved"


@pytest.mark.parametrize(
    ("lhs", "rhs"),
    [
        (x, sympy.Matrix([x])),
        (sympy.Matrix([x, y]), sympy.Matrix([[x, y]])),
        (sympy.Matrix([x, y]), sympy.Matrix([x, y, z])),
        (sympy.eye(2), sympy.eye(3)),
        (sympy.zeros(2, 3), sympy.zeros(3, 2)),
        (sympy.zeros(2, 2), 0),
    ],
)
def test_sides_of_different_shapes_are_refused(lhs, rhs):
    with pytest.raises(ValueError, match="one shape"):
        prove(lhs, rhs)


# -- constants --------------------------------------------------------------------------------------------------------


@each_engine
def test_statements_without_symbols_are_decided(engine):
    assert prove(over(2, 4), Fraction(1, 2), engine=engine).verdict == "proved"
    assert prove(over(2, over(4, 3)) ** -2, sympy.Rational(4, 9), engine=engine).verdict == "proved"
    assert prove(sympy.Matrix([over(6, 3), 0]), sympy.Matrix([2, 0]), engine=engine).verdict == "proved"
    assert prove(over(2, 4), over(2, 4), engine=engine).hypotheses == ()
    refuted = prove(over(1, 3), Fraction(333333333333, 10**12), engine=engine)
    assert (refuted.verdict, refuted.counterexample) == ("refuted", {})


@each_engine
def test_a_constant_divisor_that_is_zero_is_undefined(engine):
    with pytest.raises(UndefinedError):
        prove(over(1, over(4, 2) - 2), 1, engine=engine)


# -- what is refused --------------------------------------------------------------------------------------------------

UNDEFINED = {
    "hidden zero": (over(x, (x + y) ** 2 - x**2 - 2 * x * y - y**2), 1),
    "zero after division": (over(1, over(x, x) - 1), y),
    "right side": (y, over(1, over(x, y) - over(2 * x, 2 * y))),
    "zero over zero": (over(x, x * (y + 1) - x * y - x), over(x, x * (y + 1) - x * y - x)),
    "negative power": (((x + 1) * (x - 1) - x**2 + 1) ** -1, 0),
    "an entry": (
        sympy.Matrix([x, over(1, over(x, x) - 1)]),
        sympy.Matrix([x, 1]),
    ),
}


@each_engine
@pytest.mark.parametrize(("lhs", "rhs"), UNDEFINED.values(), ids=UNDEFINED)
def test_a_divisor_that_is_identically_zero_is_an_error(engine, lhs, rhs):
    with pytest.raises(UndefinedError, match="not identically zero"):
        prove(lhs, rhs, engine=engine)


@each_engine
def test_a_divisor_that_is_identically_zero_is_an_error_under_constraints_too(engine):
    with pytest.raises(UndefinedError):
        prove(over(z, over(x, x) - 1), 1, constraints=[x - y], engine=engine)


def test_undefined_is_a_value_error():
    assert issubclass(UndefinedError, ValueError)


@for_each(("lhs", "rhs"), [(x, x), (x, y), (x, 1), (1, 2)])
@for_each("constraints", [(), (x - y,)])
def test_an_unknown_engine_is_refused_whatever_the_statement(lhs, rhs, constraints):
    with pytest.raises(ValueError, match="flint, sympy, got 'maple'"):
        prove(lhs, rhs, constraints=constraints, engine="maple")


@for_each("bad", [0.5, sympy.Float(1) / 3 * x, sympy.sqrt(2), sympy.sin(x), sympy.pi, sympy.oo, "x", True])
def test_what_is_not_rational_is_refused_in_every_argument(bad):
    for argument, call in {
        "lhs": lambda: prove(bad, x),
        "rhs": lambda: prove(x, bad),
        "constraints": lambda: prove(x, x, constraints=[x - 1, bad]),
        "nonzero": lambda: prove(x, x, nonzero=[bad]),
    }.items():
        with pytest.raises(NotRationalError, match=f"^{argument}: "):
            call()


def test_symbols_that_do_not_commute_are_refused():
    a, b = sympy.symbols("a b", commutative=False)
    with pytest.raises(NotRationalError):
        prove(a * b, b * a)


@pytest.mark.parametrize("where", ["rhs", "constraints", "nonzero"])
def test_two_symbols_of_one_name_are_refused(where):
    other = sympy.Symbol("x", real=True)
    arguments = {"rhs": x, "constraints": [], "nonzero": []}
    arguments[where] = other if where == "rhs" else [other]
    with pytest.raises(ValueError, match="one symbol of the name x"):
        prove(x, **arguments)


@pytest.mark.parametrize("argument", ["constraints", "nonzero"])
def test_a_matrix_is_no_constraint(argument):
    with pytest.raises(ValueError, match=f"{argument}: expected scalars"):
        prove(x, y, **{argument: [sympy.Matrix([x - y, x - 1])]})


# -- the result -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("rhs", "constraints", "verdict"), [(x, [], "proved"), (y, [], "refuted"), (0, [x**2 + 1], "open")]
)
def test_the_result_is_frozen(rhs, constraints, verdict):
    proof = prove(x, rhs, constraints=constraints)
    assert proof.verdict == verdict
    for name in ("verdict", "hypotheses", "certificate", "counterexample", "engine"):
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(proof, name, None)


REPEATED = """
import sympy
from algebroproj_sym.expressions import over
from algebroproj_sym.proving import prove
a, b, c, d, E = sympy.symbols("delta beta gamma alpha E")
for engine in ("flint", "sympy"):
    print(prove(over(a - b, a**2 - b**2) + over(c, d * E), over(1, a + b) + over(c, E * d), engine=engine))
    print(prove(over(a * c, d) + b * E, over(a * d, c) + b, engine=engine))
    print(prove(over(a, c), over(b, d), constraints=[a * d - b * c], engine=engine))
    print(prove(a * E, a * b, constraints=[a * d - b * c], nonzero=[E], engine=engine))
    print(prove(a**3 * c, a * c, constraints=[a**2 - 1, b - a * E], witness={a: 1, b: 7, E: 7}, engine=engine))
    print(prove(a, b, constraints=[a**2 + b**2 - 3], engine=engine))
"""


def test_the_result_does_not_depend_on_the_hash_seed():
    runs = [
        subprocess.Popen(
            [sys.executable, "-c", REPEATED],
            env=os.environ | {"PYTHONHASHSEED": seed},
            stdout=subprocess.PIPE,
            text=True,
        )
        for seed in ("1", "20250")
    ]
    first, second = (run.communicate()[0] for run in runs)
    assert [run.returncode for run in runs] == [0, 0]
    assert first.count("Proof(") == 12
    assert first == second


# -- constraints ------------------------------------------------------------------------------------------------------


def certified(proof, lhs, rhs, constraints):
    """Whether the cofactors multiply out to the numerators times the multiplier, as SymPy reads and multiplies them."""
    names = {s.name: s for side in (lhs, rhs, *constraints) for s in sympy.sympify(side).free_symbols}

    def parse(written):
        return sympy.sympify(written, locals=names)

    def is_product_of_denominators(function):
        factors = [f for part in sympy.fraction(sympy.cancel(function)) for f, _ in sympy.factor_list(part)[1]]
        return all(
            any(sympy.cancel(f / parse(d)).is_Number for d in proof.certificate["denominators"]) for f in factors
        )

    differences = [sympy.cancel(entry.doit()) for entry in sympy.Matrix([lhs]) - sympy.Matrix([rhs])]
    for difference, part in zip(differences, proof.certificate["entries"], strict=True):
        total = sympy.expand(sympy.Add(*(parse(c) * constraints[int(i)] for i, c in part["cofactors"].items())))
        expected = difference ** part["exponent"] * parse(part["multiplier"])
        if sympy.expand(expected - total) != 0 and not is_product_of_denominators(total / expected):
            return False
    return True


@each_engine
def test_the_circle(engine):
    c, s = sympy.symbols("c s")
    circle, point = [c**2 + s**2 - 1], {c: Fraction(3, 5), s: Fraction(4, 5)}
    for lhs, rhs in [(c**4 - s**4, c**2 - s**2), ((c**2 - s**2) ** 2 + 4 * c**2 * s**2, 1), (c**2 + s**2, 1)]:
        proof = prove(lhs, rhs, constraints=circle, witness=point, engine=engine)
        assert proof.verdict == "proved"
        assert certified(proof, lhs, rhs, circle)
        assert proof.certificate["witness"] == {"c": "3/5", "s": "4/5"}


@each_engine
def test_the_circle_with_a_division(engine):
    c, s = sympy.symbols("c s")
    point = {c: Fraction(3, 5), s: Fraction(4, 5)}
    proof = prove(over(1 - c, s), over(s, 1 + c), constraints=[c**2 + s**2 - 1], witness=point, engine=engine)
    assert proof.verdict == "proved"
    assert set(proof.hypotheses) == {s, c + 1}
    assert certified(proof, over(1 - c, s), over(s, 1 + c), [c**2 + s**2 - 1])


def test_a_tampered_certificate_does_not_multiply_out():
    proof = prove(x**3 * y, x * y, constraints=[x**2 - 1], witness={x: 1})
    assert certified(proof, x**3 * y, x * y, [x**2 - 1])
    assert not certified(proof, x**3 * y, x * y + 1, [x**2 - 1])
    assert not certified(proof, x**3 * y, x * y, [x**2 + 1])


@each_engine
def test_the_circle_refutes_what_the_witness_refutes(engine):
    c, s = sympy.symbols("c s")
    point = {c: Fraction(3, 5), s: Fraction(4, 5)}
    proof = prove(c + s, 1, constraints=[c**2 + s**2 - 1], witness=point, engine=engine)
    assert (proof.verdict, proof.counterexample) == ("refuted", point)


ROTATION = Matrix(3, 3, sympy.symbols("r1:4(1:4)"))
ORTHOGONAL = list((ROTATION.T * ROTATION - Matrix.eye(3)).vech())
TURNED = dict(zip(ROTATION, [Fraction(n, 3) for n in (1, -2, 2, 2, -1, -2, 2, 2, 1)], strict=True))


@each_engine
def test_a_rotation_preserves_lengths(engine):
    assert len(ROTATION.free_symbols) == 9
    v = vector(x, y, z)
    lhs, rhs = ((ROTATION * v).T * (ROTATION * v))[0], x**2 + y**2 + z**2
    proof = prove(lhs, rhs, constraints=ORTHOGONAL, witness=TURNED, engine=engine)
    assert proof.verdict == "proved"
    assert certified(proof, lhs, rhs, ORTHOGONAL)
    witness = {s: sympy.Rational(proof.certificate["witness"][s.name]) for s in (*ROTATION, x, y, z)}
    assert all(constraint.subs(witness) == 0 for constraint in ORTHOGONAL)


@each_engine
def test_a_rotation_preserves_scalar_products_of_matrices(engine):
    lhs, rhs = ROTATION.T * ROTATION * Matrix([[x, y], [y, z], [z, 1]]), Matrix([[x, y], [y, z], [z, 1]])
    proof = prove(lhs, rhs, constraints=ORTHOGONAL, witness=TURNED, engine=engine)
    assert proof.verdict == "proved"
    assert certified(proof, lhs, rhs, ORTHOGONAL)


@each_engine
def test_a_rotation_does_not_preserve_vectors(engine):
    v = vector(x, y, z)
    proof = prove(ROTATION * v, v, constraints=ORTHOGONAL, witness=TURNED, engine=engine)
    assert proof.verdict == "refuted"
    assert differ(ROTATION * v, v, proof.counterexample)
    assert all(substituted(constraint, proof.counterexample) == 0 for constraint in ORTHOGONAL)


CONSTRAINED = {
    "proportion": (over(x, y), over(z, 2), [2 * x - y * z]),
    "proportion of three": (over(x, y * (y - z)), over(z, 2 * (y - z)), [2 * x - y * z]),
    "plane": (x**2 - (1 - y) ** 2, 0, [x + y - 1]),
    "triangular": (z, x**3, [y - x**2, z - x * y]),
    "hyperbola": (over(1, x), y, [x * y - 1]),
    "quotients as constraints": (x + y, 2 * y, [over(x, y) - 1]),
}


@each_engine
@pytest.mark.parametrize(("lhs", "rhs", "constraints"), CONSTRAINED.values(), ids=CONSTRAINED)
def test_true_statements_under_constraints_are_proved_without_a_given_witness(engine, lhs, rhs, constraints):
    proof = prove(lhs, rhs, constraints=constraints, engine=engine)
    assert proof.verdict == "proved"
    witness = {
        s: Fraction(proof.certificate["witness"][s.name]) for s in (x, y, z) if s.name in proof.certificate["witness"]
    }
    assert all(substituted(constraint, witness) == 0 for constraint in constraints)
    assert substituted(lhs, witness) == substituted(rhs, witness)
    assert certified(proof, lhs, rhs, [sympy.numer(sympy.together(constraint.doit())) for constraint in constraints])


@each_engine
@pytest.mark.parametrize(("lhs", "rhs", "constraints"), CONSTRAINED.values(), ids=CONSTRAINED)
def test_false_statements_under_constraints_have_a_counterexample_on_them(engine, lhs, rhs, constraints):
    proof = prove(lhs, rhs + 1, constraints=constraints, engine=engine)
    assert proof.verdict == "refuted"
    assert all(substituted(constraint, proof.counterexample) == 0 for constraint in constraints)
    assert differ(lhs, rhs + 1, proof.counterexample)


@each_engine
def test_divisors_under_constraints_are_hypotheses(engine):
    proof = prove(over(x, y), over(z, 2), constraints=[2 * x - y * z], engine=engine)
    assert proof.hypotheses == (y,)
    assert proof.certificate["denominators"] == ["y"]


@each_engine
def test_a_factor_that_is_not_zero_may_be_cancelled(engine):
    proof = prove(z, y, constraints=[x * z - x * y], nonzero=[x], engine=engine)
    assert proof.verdict == "proved"
    assert certified(proof, z, y, [x * z - x * y])
    assert sympy.sympify(proof.certificate["entries"][0]["multiplier"]) == x


@each_engine
def test_a_factor_that_may_be_zero_may_not_be_cancelled(engine):
    proof = prove(z, y, constraints=[x * z - x * y], engine=engine)
    assert proof.verdict == "refuted"
    assert proof.counterexample[x] == 0
    assert proof.counterexample[y] != proof.counterexample[z]


@each_engine
def test_a_counterexample_respects_what_is_not_zero(engine):
    proof = prove(x, y, constraints=[z * (x + y)], nonzero=[z, x - 1], engine=engine)
    assert proof.verdict == "refuted"
    at = proof.counterexample
    assert at[z] != 0
    assert at[x] not in (1, at[y])
    assert at[x] + at[y] == 0


@each_engine
def test_a_constraint_that_always_holds_does_no_harm(engine):
    always = (x + 1) ** 2 - x**2 - 2 * x - 1
    proof = prove(x**3, x, constraints=[x**2 - 1, always, 0], witness={x: -1}, engine=engine)
    assert proof.verdict == "proved"


# -- laws -------------------------------------------------------------------------------------------------------------

trees = st.recursive(
    st.sampled_from("xyz") | st.integers(-4, 4),
    lambda part: st.tuples(st.sampled_from("+-*/"), part, part),
    max_leaves=7,
)
DEFINED = {"x": Fraction(17, 3), "y": Fraction(-23, 7), "z": Fraction(29, 11)}
REWRITINGS = [sympy.expand, sympy.together, sympy.factor, sympy.cancel, lambda e: sympy.apart(e, x), sympy.horner]


def compute(tree, leaves, number, divide=operator.truediv):
    if isinstance(tree, str):
        return leaves[tree]
    if isinstance(tree, int):
        return number(tree)
    left, right = (compute(part, leaves, number, divide) for part in tree[1:])
    return {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": divide}[tree[0]](left, right)


def rewritten(tree, rewriting):
    """An expression with every division kept, and the same function written otherwise by SymPy."""
    try:
        compute(tree, DEFINED, Fraction)
    except ZeroDivisionError:
        assume(False)
    symbols = {"x": x, "y": y, "z": z}
    plain = compute(tree, symbols, sympy.Integer)
    try:
        other = rewriting(plain)
    except (NotImplementedError, sympy.PolynomialError):
        other = sympy.together(plain)
    return compute(tree, symbols, sympy.Integer, over), other


@each_engine
@given(trees, st.sampled_from(REWRITINGS))
def test_a_function_written_otherwise_is_proved_equal(engine, tree, rewriting):
    lhs, rhs = rewritten(tree, rewriting)
    assert prove(lhs, rhs, engine=engine).verdict == "proved"


@each_engine
@given(trees, st.sampled_from(REWRITINGS))
def test_a_function_written_otherwise_plus_one_is_refuted(engine, tree, rewriting):
    lhs, rhs = rewritten(tree, rewriting)
    proof = prove(lhs, rhs + 1, engine=engine)
    assert proof.verdict == "refuted"
    assert differ(lhs, rhs + 1, proof.counterexample)


@given(trees, trees)
def test_both_engines_give_the_same_result(left, right):
    for tree in (left, right):
        rewritten(tree, sympy.together)
    symbols = {"x": x, "y": y, "z": z}
    lhs, rhs = (compute(tree, symbols, sympy.Integer, over) for tree in (left, right))
    first, second = prove(lhs, rhs, engine="flint"), prove(lhs, rhs, engine="sympy")
    assert dataclasses.replace(first, engine="sympy") == second


small = st.integers(-3, 3)
quadratics = st.builds(lambda a, b, c, d: a + b * x + c * y + d * x * y, small, small, small, small)
cubics = st.builds(lambda a, b, c: a * z + b * x * z + c * y * z**2, small, small, small)


@each_engine
@given(quadratics, cubics, quadratics)
def test_one_constraint_affine_in_a_variable_is_a_substitution(engine, solution, lhs, rhs):
    assume(sympy.expand(z - solution).free_symbols)
    proof = prove(lhs, rhs, constraints=[z - solution], engine=engine)
    if sympy.expand(lhs.subs(z, solution) - rhs) == 0:
        assert proof.verdict == "proved"
        assert certified(proof, lhs, rhs, [z - solution])
    else:
        assert proof.verdict == "refuted"
        assert substituted(z - solution, proof.counterexample) == 0
        assert differ(lhs, rhs, proof.counterexample)


@each_engine
@given(quadratics, cubics, quadratics)
@settings(max_examples=10)
def test_what_follows_from_a_constraint_is_proved(engine, solution, start, cofactor):
    constraint = z - solution
    lhs, rhs = start, sympy.expand(start + cofactor * constraint)
    proof = prove(lhs, rhs, constraints=[constraint], engine=engine)
    assert proof.verdict == "proved"
    assert certified(proof, lhs, rhs, [constraint])


@pytest.mark.parametrize("engine", ["flint", "sympy"])
def test_names_beyond_ascii_are_names(engine):
    angle = sympy.Symbol("λ")
    assert prove((angle + 1) ** 2, angle**2 + 2 * angle + 1, engine=engine).verdict == "proved"


def test_real_symbols_stand_for_any_number():
    assert prove(sympy.Symbol("n", real=True), 0).verdict == "refuted"


def test_a_witness_is_exact():
    with pytest.raises(NotRationalError, match=r"witness, x: expected .* got 0\.5"):
        prove(x**3, x, constraints=[x**2 - 1], witness={x: 0.5})


def test_a_witness_at_a_pole_of_a_constraint_is_no_witness():
    with pytest.raises(ValueError, match="witness: expected a point"):
        prove(x, x, constraints=[1 / x], witness={x: 0})


def test_a_system_that_is_not_triangular_has_counterexamples_too():
    conics = [x**2 + y**2 - 25, x * y - 12]
    proof = prove(x, y, constraints=conics, witness={x: 3, y: 4})
    assert proof.verdict == "refuted"
    proof = prove(x + y, 7, constraints=conics, witness={x: 3, y: 4})
    assert proof.verdict == "refuted"
    assert sum(proof.counterexample.values()) == -7


@each_engine
def test_a_witness_refutes_with_other_values_of_what_it_leaves_free(engine):
    vanishing = sympy.Mul(*(x - k for k in range(-5, 6)))
    proof = prove(vanishing, 0, constraints=ORTHOGONAL, witness=TURNED, engine=engine)
    assert proof.verdict == "refuted"
    point = {s: sympy.Rational(str(value)) for s, value in proof.counterexample.items()}
    assert all(constraint.subs(point) == 0 for constraint in ORTHOGONAL)
    assert vanishing.subs(point) != 0
