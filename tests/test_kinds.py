"""Each kind of claim proves what is true, refutes what is false with a point that anyone can check, and says so."""

import math
from decimal import ROUND_DOWN, ROUND_HALF_UP, Decimal
from fractions import Fraction

import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError, judge
from algebroproj_sym.expressions import Matrix, over, vector
from algebroproj_sym.proving import ENGINES

x, y, z, w = sympy.symbols("x y z w")
SYMBOLS = (x, y, z)


def judged(kind, engine, printed, derived=None, **options):
    parts = {} if derived is None else {"derived": derived}
    section = Section("demo", "1", "Demonstration")
    return judge(getattr(section, kind)("1.1", "a title", printed=printed, **parts, **options), engine)


def at(expression, counterexample):
    """Return the entries at a counterexample; a symbol that it lacks keeps its name."""
    point = {symbol: sympy.Rational(value.numerator, value.denominator) for symbol, value in counterexample.items()}
    parts = list(expression) if isinstance(expression, sympy.MatrixBase) else [expression]
    values = [part.xreplace(point).doit() for part in parts]
    assert all(value.is_Rational for value in values)
    return values


def some_minor_differs_from_zero(first, second):
    pairs = [(i, j) for i in range(len(first)) for j in range(i)]
    return any(first[i] * second[j] != first[j] * second[i] for i, j in pairs)


@pytest.fixture(params=ENGINES)
def engine(request):
    return request.param


every_engine = st.sampled_from(ENGINES)
coefficients = st.integers(-5, 5)
monomials = st.builds(lambda *n: sympy.Mul(*(s**k for s, k in zip(SYMBOLS, n, strict=True))), *[st.integers(0, 2)] * 3)
polynomials = st.lists(st.builds(sympy.Mul, coefficients, monomials), min_size=1, max_size=4).map(
    lambda terms: sympy.Add(*terms)
)
nonzero_polynomials = polynomials.filter(lambda polynomial: polynomial != 0)


# Identity


@given(every_engine, polynomials, nonzero_polynomials, polynomials, nonzero_polynomials)
def test_a_sum_of_fractions_is_identical_to_the_fraction_it_makes(engine, a, b, c, d):
    result = judged("identity", engine, over(a * d + b * c, b * d), over(a, b) + over(c, d))
    assert result.verdict == "proved"
    assert result.counterexample is None


@given(every_engine, polynomials, nonzero_polynomials, nonzero_polynomials)
def test_fractions_that_differ_are_told_apart_by_an_exact_point(engine, a, b, difference):
    printed, derived = over(a, b), over(a, b) + difference
    result = judged("identity", engine, printed, derived)
    assert result.verdict == "false"
    assert at(printed, result.counterexample) != at(derived, result.counterexample)


def test_one_differing_entry_refutes_an_identity_of_matrices(engine):
    derived = Matrix([[x, y], [x * y, (x + y) ** 2]])
    assert judged("identity", engine, Matrix([[x, y], [y * x, x**2 + 2 * x * y + y**2]]), derived).verdict == "proved"
    result = judged("identity", engine, Matrix([[x, y], [x * y, x**2 + y**2]]), derived)
    assert result.verdict == "false"
    x_value, y_value = at(vector(x, y), result.counterexample)
    assert 2 * x_value * y_value != 0


def test_an_identity_holds_where_the_divisors_do_not_vanish(engine):
    result = judged("identity", engine, over(x**2 - y**2, x - y), x + y)
    assert result.verdict == "proved"
    assert {sympy.factor(h) for h in result.hypotheses} in ({x - y}, {y - x})


def test_an_identity_under_constraints_holds_on_them_only(engine):
    circle = {"constraints": [x**2 + y**2 - 1], "witness": {x: Fraction(3, 5), y: Fraction(4, 5)}}
    assert judged("identity", engine, 1 - y**2, x**2, **circle).verdict == "proved"
    assert judged("identity", engine, 1 - y**2, x**2).verdict == "false"
    assert judged("identity", engine, y**2, x**2, **circle).verdict == "false"


def test_a_counterexample_of_a_constrained_identity_satisfies_the_constraints(engine):
    result = judged("identity", engine, x, z, constraints=[x - y], nonzero=[x])
    assert result.verdict == "false"
    x_value, y_value, z_value = at(vector(x, y, z), result.counterexample)
    assert x_value == y_value != z_value
    assert x_value != 0


def test_abbreviations_of_the_printed_form_stand_for_what_is_said(engine):
    assert judged("identity", engine, w * z, x + y, where={w: over(x + y, z)}).verdict == "proved"
    assert judged("identity", engine, w * z, x + y, where={w: over(x - y, z)}).verdict == "false"


# Identity up to scale


@given(every_engine, st.lists(polynomials, min_size=2, max_size=4), nonzero_polynomials, nonzero_polynomials)
def test_proportional_vectors_are_equal_up_to_the_factor_of_the_certificate(engine, components, a, b):
    assume(any(components))
    derived = vector(*components)
    printed = derived.applyfunc(lambda component: over(a * component, b))
    result = judged("up_to_scale", engine, printed, derived)
    assert result.verdict == "proved"
    pivot = result.certificate["pivot"]
    assert sympy.cancel(printed[pivot].doit() * b - derived[pivot] * a) == 0 != derived[pivot]


@given(every_engine, st.lists(st.tuples(polynomials, polynomials), min_size=2, max_size=3))
def test_vectors_are_equal_up_to_scale_exactly_if_all_their_minors_vanish(engine, pairs):
    first, second = (vector(*components) for components in zip(*pairs, strict=True))
    assume(any(first))
    assume(any(second))
    minors = [first[i] * second[j] - first[j] * second[i] for i in range(len(pairs)) for j in range(i)]
    result = judged("up_to_scale", engine, first, second)
    if all(sympy.expand(minor) == 0 for minor in minors):
        assert result.verdict == "proved"
    else:
        assert result.verdict == "false"
        assert some_minor_differs_from_zero(at(first, result.counterexample), at(second, result.counterexample))


def test_matrices_are_compared_as_wholes(engine):
    derived = Matrix([[x, 0], [y, 1]])
    assert judged("up_to_scale", engine, Matrix([[x * z, 0], [y * z, z]]), derived).verdict == "proved"
    result = judged("up_to_scale", engine, Matrix([[x * z, 0], [y * w, w]]), derived)
    assert result.verdict == "false"
    printed_at, derived_at = (at(m, result.counterexample) for m in (Matrix([[x * z, 0], [y * w, w]]), derived))
    assert some_minor_differs_from_zero(printed_at, derived_at)


def test_a_vector_whose_first_entry_is_zero_is_compared_by_another(engine):
    assert judged("up_to_scale", engine, vector(0, 2 * x, 2 * y), vector(0, x, y)).verdict == "proved"
    assert judged("up_to_scale", engine, vector(1, 2 * x, 2 * y), vector(0, x, y)).verdict == "false"
    assert judged("up_to_scale", engine, vector(0, 2 * x, 2 * y), vector(1, x, y)).verdict == "false"


def test_a_printed_zero_vector_equals_nothing_up_to_scale(engine):
    assert judged("up_to_scale", engine, vector(0, 0), vector(x, y)).verdict == "open"


def test_a_derived_zero_vector_is_no_homogeneous_vector(engine):
    with pytest.raises(DeclarationError, match=r"1\.1: expected a derived form that is not identically zero"):
        judged("up_to_scale", engine, vector(x, y), vector(0, x - x))


def test_vectors_of_different_shapes_are_not_compared(engine):
    with pytest.raises(DeclarationError, match=r"1\.1: expected two sides of one shape, got \(2,\) and \(3,\)"):
        judged("up_to_scale", engine, vector(x, y), vector(x, y, z))
    with pytest.raises(DeclarationError, match=r"1\.1: expected two sides of one shape"):
        judged("up_to_scale", engine, vector(x, y), Matrix([[x, y]]))


def test_a_form_that_is_zero_on_the_constraints_is_not_equal_up_to_scale(engine):
    on_line = {"constraints": [x], "witness": {x: 0, y: 1}}
    assert judged("up_to_scale", engine, vector(x, x * y), vector(1, y), **on_line).verdict == "open"
    assert judged("up_to_scale", engine, vector(2 + x, 2 * y), vector(1, y), **on_line).verdict == "proved"


# Structure

a, b, c = sympy.symbols("a b c")


@pytest.mark.parametrize(
    ("pattern", "derived"),
    [
        (vector(0, a), vector(x - x, y)),
        (vector(a, a), vector((x + y) ** 2, x**2 + 2 * x * y + y**2)),
        (vector(a, -a), vector(x - y, y - x)),
        (vector(-a, a), vector(x - y, y - x)),
        (vector(-a, -a), vector(x, x)),
        (vector(1, -2, 0, a), vector(over(x, x), -2, 0, x)),
        (Matrix([[a, b], [-b, c]]), Matrix([[x, y], [-y, x + 1]])),
    ],
    ids=["zero", "equal", "opposite", "opposite, negative first", "both negative", "integers", "skew"],
)
def test_a_pattern_that_the_matrix_follows_is_proved(engine, pattern, derived):
    assert judged("structure", engine, pattern, derived).verdict == "proved"


@pytest.mark.parametrize(
    ("pattern", "derived", "difference"),
    [
        (vector(0, a), vector(x - y, z), x - y),
        (vector(a, a), vector(x, y), x - y),
        (vector(a, -a), vector(x, y), x + y),
        (vector(1, a), vector(x, y), x - 1),
        (vector(a, 3, 0), vector(x, 3, x * y), x * y),
    ],
    ids=["no zero", "not equal", "not opposite", "not the integer", "last entry"],
)
def test_a_pattern_that_an_entry_breaks_is_refuted_where_it_does(engine, pattern, derived, difference):
    result = judged("structure", engine, pattern, derived)
    assert result.verdict == "false"
    assert at(difference, result.counterexample) != [0]


@pytest.mark.parametrize("derived", [vector(x, 0), vector(x, x - x), vector(0, y)])
def test_a_symbol_does_not_stand_for_an_entry_that_is_identically_zero(engine, derived):
    assert judged("structure", engine, vector(a, b), derived).verdict == "open"


def test_a_hidden_zero_is_no_entry_for_a_symbol(engine):
    hidden = (x + y) ** 2 - x**2 - 2 * x * y - y**2
    assert judged("structure", engine, vector(a, b), vector(x, hidden)).verdict == "open"
    assert judged("structure", engine, vector(a, 0), vector(x, hidden)).verdict == "proved"


@pytest.mark.parametrize("mark", [a + b, 2 * a, a**2, sympy.Rational(1, 2)])
def test_a_pattern_consists_of_symbols_with_signs_and_integers(engine, mark):
    with pytest.raises(DeclarationError, match=r"1\.1: expected symbols with signs and integers as pattern, got"):
        judged("structure", engine, vector(mark, a), vector(x, y))


def test_a_pattern_has_the_shape_of_the_matrix(engine):
    with pytest.raises(DeclarationError, match=r"1\.1: expected two sides of one shape"):
        judged("structure", engine, vector(a, b), vector(x, y, z))


# Vanishing


@pytest.mark.parametrize(
    ("factors", "derived"),
    [
        ((x, y), x * y),
        ((y, x), -3 * x * y),
        ((x, y), x**2 * y**3),
        ((x**2, y), x * y),
        ((x - y, x + y), x**2 - y**2),
        ((y - x,), x - y),
        ((2 * x - 2,), (1 - x) / 5),
        ((x,), over(x * y, y)),
        ((x,), over(x, y)),
        ((x**2 + 1,), 3 * (x**2 + 1) ** 2),
        ((), sympy.Integer(3)),
    ],
    ids=str,
)
def test_an_expression_vanishes_where_its_factors_do(engine, factors, derived):
    assert judged("vanishing", engine, factors, derived).verdict == "proved"


@given(every_engine, st.lists(nonzero_polynomials, min_size=1, max_size=3), st.data())
def test_neither_multiplicity_nor_a_constant_matters(engine, factors, data):
    powers = data.draw(st.lists(st.integers(1, 2), min_size=len(factors), max_size=len(factors)))
    content = data.draw(coefficients.filter(bool))
    derived = sympy.Mul(content, *(sympy.expand(f) ** n for f, n in zip(factors, powers, strict=True)))
    result = judged("vanishing", engine, factors, derived)
    assert result.verdict == "proved"
    listed = sympy.Mul(*(sympy.sympify(name) ** count for name, count in result.certificate["factors"]))
    assert sympy.cancel(derived / listed).is_Rational


@pytest.mark.parametrize(
    ("factors", "derived"),
    [
        ((x,), x * y),
        ((), x - 2),
        ((x, y), x),
        ((x, y, x - y), x * y),
        ((x,), y),
        ((x - y,), x**2 - y**2),
        ((x, y), x + y),
        ((x, y), over(x, z)),
        ((x, y), x**2 + y**2),
    ],
    ids=str,
)
def test_a_missing_or_superfluous_factor_is_refuted_where_one_side_is_zero_and_the_other_is_not(
    engine, factors, derived
):
    result = judged("vanishing", engine, factors, derived)
    assert result.verdict == "false"
    (value,) = at(derived, result.counterexample)
    values = [at(factor, result.counterexample)[0] for factor in factors]
    assert (value == 0) != (0 in values)


def test_a_pole_is_no_zero(engine):
    assert judged("vanishing", engine, (x, y), over(x * y, y)).verdict != "proved"
    assert judged("vanishing", engine, (x, y), over(x, y)).verdict != "proved"


def test_a_hypothesis_takes_its_factor_out(engine):
    assert judged("vanishing", engine, (x,), x * y, nonzero=[y]).verdict == "proved"
    assert judged("vanishing", engine, (x,), x * y * z, nonzero=[y]).verdict == "false"


def test_a_counterexample_satisfies_the_hypotheses(engine):
    excluded = range(-8, 9)
    result = judged("vanishing", engine, (y,), y * z, nonzero=[x - k for k in excluded])
    x_value, y_value, z_value = at(vector(x, y, z), result.counterexample)
    assert x_value not in excluded
    assert z_value == 0 != y_value


@pytest.mark.parametrize(("factors", "derived"), [((), x**2 + 1), ((x,), x * (x**2 + 1)), ((), x**2 - 2)], ids=str)
def test_factors_without_a_rational_zero_leave_the_claim_open(engine, factors, derived):
    result = judged("vanishing", engine, factors, derived)
    assert result.verdict == "open"
    assert result.counterexample is None


def test_an_expression_that_is_identically_zero_has_no_factors(engine):
    with pytest.raises(DeclarationError, match=r"1\.1: expected a derived expression that is not identically zero"):
        judged("vanishing", engine, (x,), (x + 1) ** 2 - x**2 - 2 * x - 1)


# Numeric


def numeric(printed, derived, **options):
    exact = Fraction(derived)
    return judged("numeric", "flint", printed, sympy.Rational(exact.numerator, exact.denominator), **options).verdict


@pytest.mark.parametrize("engine", ENGINES)
def test_a_number_needs_no_engine(engine):
    assert judged("numeric", engine, "0.333", sympy.Rational(1, 3)).verdict == "proved"
    assert judged("numeric", engine, "0.334", sympy.Rational(1, 3)).verdict == "false"


TINY = Fraction(1, 10**40)


@pytest.mark.parametrize("printed", ["0.12", "-0.12", "12", "-12", "7.0"])
def test_a_tie_is_rounded_away_from_zero(printed):
    unit = Fraction(1, 10 ** len(printed.partition(".")[2]))
    size, sign = abs(Fraction(printed)), -1 if printed.startswith("-") else 1
    limits = {size - unit / 2: "proved", size - unit / 2 - TINY: "false"}
    limits |= {size + unit / 2 - TINY: "proved", size + unit / 2: "false", size: "proved"}
    assert {exact: numeric(printed, sign * exact) for exact in limits} == limits


@pytest.mark.parametrize("printed", ["0.12", "-0.12", "12", "-12", "7.0"])
def test_digits_are_cut_off_towards_zero(printed):
    unit = Fraction(1, 10 ** len(printed.partition(".")[2]))
    size, sign = abs(Fraction(printed)), -1 if printed.startswith("-") else 1
    limits = {size: "proved", size - TINY: "false", size + unit - TINY: "proved", size + unit: "false"}
    assert {exact: numeric(printed, sign * exact, rounding="cut") for exact in limits} == limits


@pytest.mark.parametrize(("rounding", "limit"), [("nearest", Fraction(1, 20)), ("cut", Fraction(1, 10))])
@pytest.mark.parametrize("printed", ["0.0", "-0.0"])
def test_a_zero_has_no_sign(printed, rounding, limit):
    for sign in (1, -1):
        assert numeric(printed, sign * (limit - TINY), rounding=rounding) == "proved"
        assert numeric(printed, sign * limit, rounding=rounding) == "false"
    assert numeric(printed, 0, rounding=rounding) == "proved"


def decimal(units, places):
    whole, fraction = divmod(abs(units), 10**places)
    return ("-" if units < 0 else "") + str(whole) + (f".{fraction:0{places}}" if places else "")


@given(st.fractions(-100, 100) | st.decimals(-100, 100, places=3).map(Fraction), st.integers(0, 8))
def test_exactly_one_number_is_proved_in_each_mode(exact, places):
    near = range(math.floor(exact * 10**places) - 1, math.floor(exact * 10**places) + 3)
    for rounding in ("nearest", "cut"):
        verdicts = [numeric(decimal(units, places), exact, rounding=rounding) for units in near]
        assert sorted(verdicts) == ["false"] * 3 + ["proved"]


@given(st.decimals(-100, 100, places=5), st.integers(0, 5))
def test_the_modes_are_those_of_the_decimal_module(exact, places):
    unit = Decimal(1).scaleb(-places)
    for rounding, mode in (("nearest", ROUND_HALF_UP), ("cut", ROUND_DOWN)):
        assert numeric(f"{exact.quantize(unit, mode):f}", Fraction(exact), rounding=rounding) == "proved"


def test_trailing_zeros_are_digits():
    assert numeric("0.5", Fraction(52, 100)) == "proved"
    assert numeric("0.50", Fraction(52, 100)) == "false"
    assert numeric("0.50", Fraction(504, 1000)) == "proved"


def test_an_integer_has_the_unit_one():
    assert numeric("13", Fraction(25, 2)) == "proved"
    assert numeric("12", Fraction(25, 2)) == "false"
    assert numeric("12", Fraction(25, 2), rounding="cut") == "proved"


def test_the_certificate_has_the_rounded_number_and_nothing_else():
    derived = sympy.Rational(-2, 3)
    for rounding, found in (("nearest", "-0.67"), ("cut", "-0.66")):
        certificate = judged("numeric", "flint", "-0.67", derived, rounding=rounding).certificate
        assert certificate == {"method": "exact rounding", "rounded": found}


def test_only_a_printed_number_is_rounded():
    with pytest.raises(DeclarationError, match=r"rounding: expected one of .* got 'up'"):
        numeric("0.5", Fraction(1, 2), rounding="up")
    with pytest.raises(DeclarationError, match="rounding"):
        judged("identity", "flint", x, x, rounding="cut")


# Definition


@pytest.mark.parametrize(
    "definiens", [x, sympy.Integer(3), vector(x, y - 1), over(x, y), Matrix([[over(1, x - y), x], [1, 0]])], ids=str
)
def test_a_definition_has_an_exact_instance(engine, definiens):
    result = judged("definition", engine, definiens)
    assert result.verdict == "definition"
    instance = {sympy.Symbol(name): Fraction(value) for name, value in result.certificate["instance"].items()}
    assert [sympy.Rational(value) for value in result.certificate["values"]] == at(definiens, instance)


def test_the_divisors_of_a_definition_are_hypotheses(engine):
    result = judged("definition", engine, over(x, y * (x - 1)))
    assert {sympy.expand(h) for h in result.hypotheses} == {y, x - 1}


@pytest.mark.parametrize("divisor", [(x + 1) ** 2 - x**2 - 2 * x - 1, over(x, x) - 1])
def test_a_definition_that_divides_by_zero_everywhere_defines_nothing(engine, divisor):
    with pytest.raises(ValueError, match="denominators that are not identically zero"):
        judged("definition", engine, over(x, divisor))


@pytest.mark.parametrize("factors", [(x, sympy.Integer(0)), (x, x - x), (sympy.Integer(0),)])
def test_a_factor_that_is_zero_everywhere_is_no_part_of_what_vanishes(factors):
    assert judged("vanishing", "flint", factors, x).verdict == "false"


@pytest.mark.parametrize("changed", [x**2 - x + y**2 + y, x**2 - 2 * x + y**2 - y, x**2 + y**2 - 1])
def test_zeros_are_found_on_conics_too(changed):
    assert judged("vanishing", "flint", (changed,), x**2 - x + y**2 - y).verdict == "false"
