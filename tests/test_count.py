"""Counts of independent functions: what invariance gives from above and a point from below, and nothing less."""

from fractions import Fraction
from itertools import combinations

import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError, judge
from algebroproj_sym.expressions import Matrix, over, vector
from algebroproj_sym.proving import ENGINES
from algebroproj_sym.proving.statements import UnsupportedError

x, y, z, w = sympy.symbols("x y z w")
XYZ = (x, y, z)


def judged(printed, derived, variables, kernel=(), engine="flint", **options):
    section = Section("demo", "1", "Demonstration")
    parts = {"printed": printed, "derived": derived, "variables": variables, "kernel": kernel} | options
    return judge(section.count("1.1", "a title", **parts), engine)


@pytest.fixture(params=ENGINES)
def engine(request):
    return request.param


def differences(values):
    return [a - b for a, b in combinations(values, 2)]


def squared_distances(points):
    return vector(*(sum((a - b) ** 2 for a, b in zip(p, q, strict=True)) for p, q in combinations(points, 2)))


FOUR = [sympy.symbols(f"x{k} y{k}") for k in range(4)]
FLAT = [coordinate for point in FOUR for coordinate in point]
MOTIONS = [
    vector(*(1, 0) * 4),
    vector(*(0, 1) * 4),
    vector(*(value for px, py in FOUR for value in (-py, px))),
]
QUATERNION = sympy.symbols("q0 q1 q2 q3")
q0, q1, q2, q3 = QUATERNION
NORM = sum(q**2 for q in QUATERNION)
ROTATION = Matrix(
    [
        [q0**2 + q1**2 - q2**2 - q3**2, 2 * (q1 * q2 - q0 * q3), 2 * (q1 * q3 + q0 * q2)],
        [2 * (q1 * q2 + q0 * q3), q0**2 - q1**2 + q2**2 - q3**2, 2 * (q2 * q3 - q0 * q1)],
        [2 * (q1 * q3 - q0 * q2), 2 * (q2 * q3 + q0 * q1), q0**2 - q1**2 - q2**2 + q3**2],
    ]
)
KNOWN = {
    "independent coordinates": (3, vector(x, y, z), XYZ, []),
    "symmetric functions": (3, vector(x + y + z, x * y + y * z + z * x, x * y * z), XYZ, []),
    "differences": (2, vector(*differences(XYZ)), XYZ, [vector(1, 1, 1)]),
    "ratios": (2, vector(x / y, over(y, z), over(z, x)), XYZ, [vector(x, y, z)]),
    "cross ratio": (
        1,
        over((x - z) * (y - w), (x - w) * (y - z)),
        (x, y, z, w),
        [vector(1, 1, 1, 1), vector(x, y, z, w), vector(x**2, y**2, z**2, w**2)],
    ),
    "distances of four points in the plane": (5, squared_distances(FOUR), FLAT, MOTIONS),
    "rotation of a quaternion": (3, ROTATION / NORM, QUATERNION, [vector(*QUATERNION)]),
    "scaled rotation of a quaternion": (4, ROTATION, QUATERNION, []),
    "one function of two": (1, (x + y) ** 3, (x, y), []),
    "more functions than variables": (1, vector(x, x**2, over(1, x)), (x,), []),
    "no function of the variables": (0, vector(z, z**2), (x, y), [vector(1, 0), vector(0, 1)]),
}
known = pytest.mark.parametrize(("count", "functions", "variables", "kernel"), KNOWN.values(), ids=KNOWN)


@known
def test_known_counts_are_proved(engine, count, functions, variables, kernel):
    judgement = judged(count, functions, variables, kernel, engine)
    assert judgement.verdict == "proved"
    assert judgement.counterexample is None


@known
def test_one_more_is_too_many(engine, count, functions, variables, kernel):
    assert judged(count + 1, functions, variables, kernel, engine).verdict == "false"


@known
def test_one_less_is_too_few_and_a_point_shows_it(engine, count, functions, variables, kernel):
    judgement = judged(count - 1, functions, variables, kernel, engine)
    assert judgement.verdict == "false"
    at = {symbol: sympy.Rational(str(value)) for symbol, value in judgement.counterexample.items()}
    parts = functions.doit() if isinstance(functions, sympy.MatrixBase) else vector(functions.doit())
    jacobian = vector(*parts).jacobian(vector(*variables)).xreplace(at)
    assert jacobian.rank() > count - 1


matrices = st.integers(1, 4).flatmap(
    lambda width: st.lists(st.lists(st.integers(-2, 2), min_size=width, max_size=width), min_size=1, max_size=4)
)


@given(st.sampled_from(ENGINES), matrices, st.integers(0, 5), st.booleans())
def test_linear_forms_are_counted_by_the_rank_of_their_matrix(engine, rows, printed, squared):
    matrix = Matrix(rows)
    variables = sympy.symbols(f"v0:{matrix.cols}")
    forms = matrix * vector(*variables)
    functions = forms.applyfunc(lambda form: (form + 1) ** 2) if squared else forms
    judgement = judged(printed, functions, variables, matrix.nullspace(), engine)
    assert judgement.verdict == ("proved" if printed == matrix.rank() else "false")


@given(st.sampled_from(ENGINES), matrices, st.integers(0, 4))
def test_without_directions_only_the_smaller_number_bounds_the_count(engine, rows, printed):
    matrix = Matrix(rows)
    rank, largest = matrix.rank(), min(matrix.shape)
    variables = sympy.symbols(f"v0:{matrix.cols}")
    verdict = judged(printed, matrix * vector(*variables), variables, engine=engine).verdict
    if printed < rank or printed > largest:
        assert verdict == "false"
    else:
        assert verdict == ("proved" if rank == largest else "open")


@given(st.sampled_from(ENGINES), matrices, st.data())
def test_a_wrong_direction_bounds_nothing(engine, rows, data):
    matrix = Matrix(rows)
    size = matrix.cols
    direction = vector(*data.draw(st.lists(st.integers(-2, 2), min_size=size, max_size=size)))
    assume(not (matrix * direction).is_zero_matrix)
    variables = sympy.symbols(f"v0:{size}")
    claimed = matrix.rank() - 1
    assert judged(claimed, matrix * vector(*variables), variables, [direction], engine).verdict == "false"
    whole = judged(matrix.rank(), matrix * vector(*variables), variables, [direction], engine).verdict
    assert whole == ("proved" if matrix.rank() == min(matrix.shape) else "open")


def test_one_wrong_direction_spoils_the_right_ones(engine):
    functions = vector(x - y, y - z, z - x)
    assert judged(2, functions, XYZ, [vector(1, 1, 1)], engine).verdict == "proved"
    assert judged(2, functions, XYZ, [vector(1, 1, 1), vector(1, 0, 0)], engine).verdict == "open"
    assert judged(1, functions, XYZ, [vector(1, 1, 1), vector(1, 0, 0)], engine).verdict == "false"


def test_dependent_directions_count_once(engine):
    functions = vector(x - y, 2 * x - 2 * y, z * 0)
    pair = [vector(1, 1, 0), vector(0, 0, 1)]
    assert judged(1, functions, XYZ, pair, engine).verdict == "proved"
    for repeated in ([pair[0], pair[0]], [pair[0], vector(x, x, 0)], [pair[0], vector(0, 0, 0)]):
        assert judged(1, functions, XYZ, repeated, engine).verdict == "open"


def test_a_direction_that_is_right_at_some_points_only_bounds_nothing(engine):
    functions = vector(x * y, (x * y) ** 2)
    assert judged(1, functions, (x, y), [vector(x, -y)], engine).verdict == "proved"
    assert judged(1, functions, (x, y), [vector(1, -1)], engine).verdict == "open"


def test_other_symbols_are_constants(engine):
    functions = vector(x * z, y * z)
    assert judged(2, functions, (x, y), engine=engine).verdict == "proved"
    assert judged(1, functions, (z,), engine=engine).verdict == "proved"
    assert judged(1, vector(x + z, 2 * x + z**2), (x,), engine=engine).verdict == "proved"


def test_a_count_speaks_of_rational_functions_and_has_no_hypotheses(engine):
    judgement = judged(1, vector(over(x, y), over(y, x)), (x, y), [vector(over(x, z), over(y, z))], engine)
    assert (judgement.verdict, judgement.hypotheses) == ("proved", ())
    assert judgement.certificate["kernel"] == ["Matrix([[x], [y]])"]


def test_functions_are_judged_where_they_are_defined(engine):
    pole = (x - 1) * (x - 2) * (x + 1) * (x + 3) * y
    assert judged(1, vector(over(1, pole), over(2, pole)), (x,), engine=engine).verdict == "proved"


def test_the_evidence_is_a_point_at_which_the_jacobian_has_the_rank():
    functions = vector(x * y, y * z, z * x, x * y * z)
    judgement = judged(3, functions, XYZ)
    point = {sympy.Symbol(name): sympy.Rational(value) for name, value in judgement.certificate["point"].items()}
    assert functions.jacobian(vector(*XYZ)).xreplace(point).rank() == 3


def test_a_wrong_count_with_the_right_one_is_a_misprint(engine):
    functions = vector(*differences(XYZ))
    options = {"corrected": 2, "expect": "misprint", "engine": engine}
    assert judged(3, functions, XYZ, [vector(1, 1, 1)], **options).verdict == "misprint"
    assert judged(1, functions, XYZ, [vector(1, 1, 1)], **options).verdict == "misprint"
    assert judged(2, functions, XYZ, [vector(1, 1, 1)], **options).verdict == "proved"


def test_a_count_needs_its_variables(engine):
    with pytest.raises(DeclarationError, match=r"^1\.1: expected the variables of the functions to be counted"):
        judged(1, x * y, (), engine=engine)


def test_a_count_has_no_constraints():
    with pytest.raises(DeclarationError, match="constraints: expected none for a claim of kind count"):
        judged(1, x * y, (x, y), constraints=[x - y])


@pytest.mark.parametrize("inexact", [0.5, sympy.sqrt(x), sympy.cos(x)])
def test_functions_and_directions_are_rational(inexact):
    with pytest.raises((TypeError, UnsupportedError), match=r"^claim demo:1\.1(, derived)?: expected"):
        judged(1, x + inexact, (x, y))
    with pytest.raises(TypeError, match=r"^claim demo:1\.1, kernel: expected"):
        judged(1, x, (x, y), [vector(inexact, 1)])


def test_equal_declarations_give_equal_evidence(engine):
    first, second = (judged(2, vector(*differences(XYZ)), XYZ, [vector(1, 1, 1)], engine) for _ in range(2))
    assert first.verdict == second.verdict == "proved"
    assert first.certificate == second.certificate
    assert first.hypotheses == second.hypotheses


def test_a_fraction_is_no_count(engine):
    with pytest.raises(DeclarationError, match=r"^1\.1: expected a number as printed form"):
        judged(Fraction(3, 2), vector(x, y), (x, y), engine=engine)


@pytest.mark.parametrize(
    ("printed", "derived", "variables", "kernel"),
    [(1, x * y, (x, y), [vector(x)]), (x, x * y, (x, y), ()), (0, x, (x + 1,), [vector(1)])],
    ids=["direction too short", "symbol as count", "expression as variable"],
)
def test_nonsense_is_refused(printed, derived, variables, kernel):
    with pytest.raises(DeclarationError):
        judged(printed, derived, variables, kernel)
