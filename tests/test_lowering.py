"""A program computes exactly what its kernel derives, over any field, and divides by everything it must not skip."""

from fractions import Fraction

import numpy as np
import pytest
import sympy
from cases import for_each
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym import Section
from algebroproj_sym.declaring import kernels
from algebroproj_sym.expressions import Matrix, over, vector
from algebroproj_sym.generating.lowering import LoweringError
from algebroproj_sym.generating.lowering import lowered_form as lower
from algebroproj_sym.generating.program import run

SYMBOLS = sympy.symbols("a b c d")
a, b, c, d = SYMBOLS
x, y = sympy.symbols("x y")
u, v, w = sympy.symbols("u v w")


def kernel(derived, form=None, where=None, symbols=SYMBOLS):
    names = {symbol.name: symbol for symbol in symbols}
    options = ({} if form is None else {"form": form}) | ({} if where is None else {"where": where})
    return Section("demo", "1", "Demonstration").kernel(
        "demo.f",
        "A function.",
        arguments=names,
        derived=derived,
        claims=["1.1"],
        example=dict.fromkeys(names, "1"),
        describe=dict.fromkeys(names, "A number."),
        **options,
    )


def of_xy(derived, form=None, where=None):
    return lower(kernel(derived, form, where, symbols=(x, y)))


def exact(value):
    return sympy.Rational(value.numerator, value.denominator)


def total(program):
    return sum(program.operations().values())


def parts_of(expression):
    return list(expression) if isinstance(expression, sympy.MatrixBase) else [expression]


def written_operations(expression):
    """Count the operations of an expression as it is written; signs within sums are free, other ones are not."""
    if isinstance(expression, sympy.MatrixBase):
        return sum(map(written_operations, expression))
    if isinstance(expression, sympy.Symbol):
        return 0
    if isinstance(expression, sympy.Rational):
        return int(expression.q != 1) + int(expression.p < 0)
    if isinstance(expression, sympy.Pow):
        exponent = int(expression.exp)
        return written_operations(expression.base) + abs(exponent) - 1 + int(exponent < 0)
    signs = [part for part in expression.args if part == -1 and not isinstance(expression, over)]
    parts = [part for part in expression.args if part not in signs]
    return sum(map(written_operations, parts)) + len(expression.args) - 1


numbers = st.fractions(-6, 6, max_denominator=4).map(lambda value: sympy.Rational(value.numerator, value.denominator))


def vanishes(expression):
    return sympy.expand(sympy.fraction(sympy.together(expression.doit()))[0]) == 0


def is_no_fraction(part):
    """Whether a part is not a number like 1/2 that stands alone: programs hold integers only."""
    return part.is_Integer or not part.is_number


def combined(parts):
    pairs = st.tuples(parts, parts)
    divisors = parts.filter(lambda part: not vanishes(part))
    fractions = st.tuples(parts, divisors).filter(lambda pair: all(map(is_no_fraction, pair)))
    quotients = fractions.filter(lambda pair: not (pair[0].is_number and pair[1].is_number))
    return st.one_of(
        pairs.map(lambda pair: pair[0] + pair[1]),
        pairs.map(lambda pair: pair[0] - pair[1]),
        pairs.map(lambda pair: pair[0] * pair[1]),
        quotients.map(lambda pair: over(pair[0], pair[1])),
        fractions.map(lambda pair: pair[0] / pair[1]),
        st.tuples(divisors, st.integers(-2, 3)).map(lambda pair: pair[0] ** pair[1]),
    )


expressions = st.recursive(st.sampled_from(SYMBOLS) | numbers, combined, max_leaves=7)
entries = expressions.filter(is_no_fraction)
several = st.lists(entries, min_size=1, max_size=3).map(lambda parts: vector(*parts))
points = st.tuples(*[st.fractions(-9, 9, max_denominator=5)] * 4)


@given(several, points)
def test_a_program_run_on_fractions_gives_the_exact_value_or_divides_by_a_hypothesis_that_vanishes(derived, point):
    lowered = lower(kernel(derived))
    at = {symbol: exact(value) for symbol, value in zip(SYMBOLS, point, strict=True)}
    vanishing = any(hypothesis.xreplace(at) == 0 for hypothesis in lowered.hypotheses)
    inputs = {symbol.name: value for symbol, value in zip(SYMBOLS, point, strict=True)}
    if vanishing:
        with pytest.raises(ZeroDivisionError):
            run(lowered.plain, inputs)
    else:
        expected = [part.xreplace(at).doit() for part in derived]
        assert all(value.is_Rational for value in expected)
        assert list(run(lowered.plain, inputs)) == [Fraction(int(value.p), int(value.q)) for value in expected]


@given(several)
def test_a_program_is_made_of_names_and_integers_and_assigns_each_name_once_and_before_its_use(derived):
    program = lower(kernel(derived)).plain
    known = set(program.inputs)
    assert len(known) == len(program.inputs)
    for step in program.steps:
        assert step.name not in known
        assert len(step.operands) == (1 if step.operator == "neg" else 2)
        assert all(type(operand) is int or operand in known for operand in step.operands)
        known.add(step.name)
    assert all(type(output) is int or output in known for output in program.outputs)


@given(several)
def test_a_program_has_no_more_operations_than_the_expression_has_as_written(derived):
    sums = [node for entry in derived for node in sympy.preorder_traversal(entry) if isinstance(node, sympy.Add)]
    assume(all(node.as_coeff_Add()[0].is_Integer for node in sums))
    assert total(lower(kernel(derived)).plain) <= written_operations(derived)


@pytest.mark.parametrize(
    ("derived", "count"),
    [
        ((x + 1) / 2, 2),
        ((x - y) / 3 - sympy.Rational(1, 6), 5),
        (x * (y - 1) / 2, 3),
        (1 / (x + sympy.Rational(1, 2)), 4),
    ],
    ids=str,
)
def test_a_fraction_in_a_sum_stays_exact(derived, count):
    program = of_xy(derived).plain
    point = {"x": Fraction(1, 3), "y": Fraction(5, 7)}
    expected = derived.xreplace({x: sympy.Rational(1, 3), y: sympy.Rational(5, 7)})
    assert run(program, point) == (Fraction(int(expected.p), int(expected.q)),)
    assert total(program) <= count


@given(several)
def test_no_operation_occurs_twice_in_a_program(derived):
    steps = lower(kernel(derived)).plain.steps
    assert len({(step.operator, step.operands) for step in steps}) == len(steps)


@given(several)
def test_every_operation_of_a_program_is_used(derived):
    program = lower(kernel(derived)).plain
    used = {operand for step in program.steps for operand in step.operands} | set(program.outputs)
    assert {step.name for step in program.steps} <= used


@pytest.mark.parametrize(
    ("derived", "count"),
    [
        (vector(x - y, (x - y) * x), 2),
        (vector(x * y, x * y + 1), 2),
        (vector((x - y) ** 2, (y - x) ** 2), 2),
        (vector(over(1, x + y), over(y, x + y)), 3),
        (x**4, 3),
        (over(x, 2), 1),
        (Matrix([[1, 0], [-2, x]]), 0),
    ],
    ids=str,
)
def test_what_occurs_twice_is_computed_once(derived, count):
    assert total(of_xy(derived).plain) == count


@pytest.mark.parametrize(
    ("derived", "count"),
    [
        (vector(x - y, (y - x) * x), 2),
        (vector(x - y, over(x, y - x)), 2),
        (vector((x - y) * x, (y - x) * y), 3),
        (vector(over(x, x - y), over(y, y - x)), 3),
    ],
    ids=str,
)
def test_opposite_differences_share_one_subtraction(derived, count):
    operations = of_xy(derived).plain.operations()
    assert operations["-"] == 1
    assert sum(operations.values()) - operations["neg"] == count


@pytest.mark.parametrize("order", [1, -1])
def test_a_long_sum_and_its_negative_are_summed_once(order):
    terms = a - b + c - d + 1
    assert total(lower(kernel(vector(*[terms, -terms][::order]))).plain) <= 5


# Guards


@pytest.fixture
def guarded():
    return of_xy(over(x * y, x), y)


def test_a_divisor_that_the_form_hides_is_guarded(guarded):
    assert guarded.guarded == (x,)
    assert guarded.hypotheses == (x,)
    assert guarded.plain.operations()["/"] == 1


def test_a_guard_leaves_the_value_unchanged(guarded):
    values = [Fraction(n, 7) for n in (-50, -3, 1, 8)]
    for at_x in values:
        for at_y in [*values, Fraction(0)]:
            assert run(guarded.plain, {"x": at_x, "y": at_y}) == (at_y,)
    floats = np.array([1e-300, -1e300, 3.7, 5e-324])
    assert run(guarded.plain, {"x": floats, "y": floats[::-1]})[0].tolist() == floats[::-1].tolist()


def test_a_guard_raises_on_fractions_where_its_factor_vanishes(guarded):
    with pytest.raises(ZeroDivisionError):
        run(guarded.plain, {"x": Fraction(0), "y": Fraction(3)})


@pytest.mark.parametrize("zero", [0.0, -0.0])
def test_a_guard_gives_no_finite_number_in_numpy_where_its_factor_vanishes(guarded, zero):
    with np.errstate(invalid="ignore", divide="ignore"):
        (result,) = run(guarded.plain, {"x": np.array([zero, 2.0]), "y": np.array([3.0, 3.0])})
    assert not np.isfinite(result[0])
    assert result[1] == 3.0


@pytest.mark.parametrize("zero", [0.0, -0.0])
def test_a_divisor_that_the_form_shows_needs_no_guard(zero):
    lowered = of_xy(over(x, y), x / y)
    assert (lowered.guarded, lowered.hypotheses) == ((), (y,))
    with np.errstate(divide="ignore"):
        assert np.isinf(run(lowered.plain, {"x": np.float64(1), "y": np.float64(zero)})[0])


def test_every_entry_that_depends_on_the_input_is_guarded():
    derived = Matrix([[over(x * y, x), 0], [over(x - y, x - y), y]])
    lowered = of_xy(derived, Matrix([[y, 0], [1, y]]))
    assert set(lowered.guarded) == {x, x - y}
    with np.errstate(all="ignore"):
        for point in ({"x": np.float64(0), "y": np.float64(1)}, {"x": np.float64(2), "y": np.float64(2)}):
            assert not np.isfinite(run(lowered.plain, point)[0])
            assert not np.isfinite(run(lowered.plain, point)[3])


@pytest.mark.parametrize("constant", [0, 1, -2])
def test_a_constant_is_guarded_if_nothing_else_can_be(constant):
    lowered = of_xy(over(constant * x, x) if constant else over(x - x + 0, 1) + over(x, x) - 1, sympy.Integer(constant))
    assert lowered.hypotheses == (x,)
    assert run(lowered.plain, {"x": Fraction(2), "y": Fraction(0)}) == (constant,)
    with pytest.raises(ZeroDivisionError):
        run(lowered.plain, {"x": Fraction(0), "y": Fraction(1)})


def test_irreducible_factors_of_a_hidden_divisor_are_guarded_one_by_one():
    lowered = of_xy(over(x**2 - y**2, x**2 - y**2) * x, x)
    assert {sympy.expand(factor) for factor in lowered.guarded} == {x - y, x + y}


def test_a_divisor_of_what_no_result_needs_is_guarded():
    lowered = of_xy(over(x * y, x), y, where={u: over(1, x)})
    assert lowered.guarded == (x,)
    with np.errstate(all="ignore"):
        (result,) = run(lowered.plain, {"x": np.array([0.0, 2.0]), "y": np.array([3.0, 3.0])})
    assert not np.isfinite(result[0])
    assert result[1] == 3.0


def test_the_hypotheses_are_those_of_the_derivation_and_of_the_form():
    lowered = of_xy(x + y, over((x + y) * x, x))
    assert (lowered.guarded, lowered.hypotheses) == ((), (x,))


@pytest.mark.parametrize("name", [kernel.qualified_name for kernel in kernels() if not kernel.stages][::6])
def test_the_kernels_of_the_papers_are_exact_at_a_rational_point(name, lowered):
    low = lowered(name)
    symbols = low.kernel.symbols
    point = {symbol: Fraction(sympy.prime(k + 5), 3 + k) for k, symbol in enumerate(symbols)}
    at = {symbol: exact(value) for symbol, value in point.items()}
    expected = [part.xreplace(at).doit() for part in parts_of(low.kernel.derived)]
    computed = run(low.plain, {symbol.name: value for symbol, value in point.items()})
    assert list(computed) == [Fraction(int(value.p), int(value.q)) for value in expected]


# Forms and abbreviations


@pytest.mark.parametrize(
    ("derived", "form"),
    [(x + y, x - y), (over(x, y), over(y, x)), (vector(x, y), vector(x, 2 * y)), (x, x + over(1, y) * 0 + 1)],
    ids=str,
)
def test_a_wrong_form_is_refused(derived, form):
    with pytest.raises(LoweringError, match=r"^kernel demo\.f, form: entry \d differs from the derivation"):
        of_xy(derived, form)


def test_the_first_wrong_entry_is_named():
    with pytest.raises(LoweringError, match="entry 2 "):
        of_xy(vector(x, y, x * y), vector(x, y, x + y))


def test_a_wrong_abbreviation_is_refused():
    with pytest.raises(LoweringError):
        of_xy(x - y, u, {u: x + y})


def test_abbreviations_keep_their_names_and_can_use_earlier_ones():
    derived = over((x + y) ** 2, 1 - (x + y) * x)
    program = of_xy(derived, over(u**2, v), {u: x + y, v: 1 - u * x}).plain
    names = [step.name for step in program.steps]
    assert {"u", "v"} <= set(names)
    assert names.index("u") < names.index("v")
    values = run(program, {"x": Fraction(1, 3), "y": Fraction(1, 2)})
    assert values == (Fraction(25, 36) / (1 - Fraction(5, 18)),)


def test_an_abbreviation_is_computed_once_however_often_it_is_used():
    program = of_xy(vector((x + y) ** 2, (x + y) * x), vector(u * u, u * x), {u: x + y}).plain
    assert [step.operator for step in program.steps].count("+") == 1


@for_each(
    ("where", "form", "derived"),
    [
        ({u: x * y, v: x * y}, u + v, 2 * x * y),
        ({u: x - y, v: y - x}, u * v, -((x - y) ** 2)),
        ({u: y - x, v: x - y}, u * v, -((x - y) ** 2)),
        ({u: x * y, v: u}, u + v, 2 * x * y),
        ({u: x, v: -x}, u * v, -(x**2)),
        ({u: sympy.Integer(2), v: x + y}, u * v, 2 * (x + y)),
        ({u: x * y, v: x + y, w: x * y}, u + v + w, 2 * x * y + x + y),
        ({u: x + y}, x, x),
    ],
)
def test_abbreviations_may_be_equal_opposite_trivial_or_unused(where, form, derived):
    program = of_xy(derived, form, where).plain
    assert run(program, {"x": Fraction(3), "y": Fraction(5)}) == (derived.xreplace({x: 3, y: 5}),)


@pytest.mark.parametrize("names", ["t0 t1", "t1 t0", "t2 t5"])
def test_an_input_may_have_the_name_of_a_step(names):
    first, second = symbols = sympy.symbols(names)
    derived = vector(over(first, second) + first * second, first - second**2)
    program = lower(kernel(derived, symbols=symbols)).plain
    values = dict(zip(names.split(), (Fraction(3), Fraction(5)), strict=True))
    assert run(program, values) == (Fraction(3, 5) + 15, -22)


def test_an_abbreviation_may_have_the_name_of_a_step():
    t1 = sympy.Symbol("t1")
    program = of_xy(x * y * 3 + (x + 1) * x, x * y * 3 + t1 * x, {t1: x + 1}).plain
    assert len({step.name for step in program.steps}) == len(program.steps)
    assert run(program, {"x": Fraction(2), "y": Fraction(5)}) == (36,)


def test_constant_entries_stay_integers():
    program = of_xy(Matrix([[1, x], [0, -1]])).plain
    assert program.outputs == (1, "x", 0, -1)


def test_lowering_twice_gives_the_same():
    first, second = (of_xy(over((x + y) ** 2, x - y) + over(x, y)) for _ in range(2))
    assert first == second


def test_a_constant_fraction_is_refused_by_name():
    x = sympy.Symbol("x")
    kernel = Section("demo", "1", "Demo").kernel(
        "demo.half",
        "Half.",
        arguments={"x": x},
        derived=sympy.ImmutableDenseMatrix([x, sympy.Rational(1, 2)]),
        claims=["1.1"],
        example={"x": "1"},
        describe={"x": "A number."},
    )
    with pytest.raises(LoweringError, match=r"demo\.half, form: expected no constant fraction"):
        lower(kernel)
