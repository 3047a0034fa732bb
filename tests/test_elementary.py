"""Elementary functions: digits, bounds and what is assumed of the C library, as mpmath says; kernels that call them."""

import shutil
import subprocess

import mpmath
import numpy as np
import pytest
import sympy

import algebroproj
from algebroproj_sym import Section, declaring
from algebroproj_sym.expressions import over, vector
from algebroproj_sym.generating.backends.cpp import render as render_cpp
from algebroproj_sym.generating.backends.numpy import render
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.runtime.arctan2 import arctan2, arctan2_of_pair
from algebroproj_sym.generating.runtime.cos_sin import HALF_PI, cos_sin, cos_sin_of_pair
from algebroproj_sym.generating.runtime.error_bounds import LIBRARY, Bounded
from algebroproj_sym.generating.runtime.exp import LOG_2, exp
from algebroproj_sym.generating.runtime.hypot import hypot
from algebroproj_sym.generating.runtime.log import log
from algebroproj_sym.generating.runtime.pairs import DoubleDouble, Pair
from algebroproj_sym.generating.runtime.sqrt import sqrt
from algebroproj_sym.generating.writing import PACKAGE, write
from algebroproj_sym.verifying.accuracy import samples_of, truths
from algebroproj_sym.verifying.shipped import function_of, load_package
from algebroproj_sym.verifying.verification import verify

ANGLES = (
    0.0,
    1e-20,
    -3e-9,
    0.5,
    0.7853981633974483,
    1.5707963267948966,
    3.141592653589793,
    -2.0,
    4.0,
    100.0,
    -12345.678,
)
DTYPES = [np.float32, np.float64, np.longdouble]


def exact(number):
    parts = [
        part.item().as_integer_ratio() if part.dtype != np.longdouble else part.as_integer_ratio() for part in number
    ]
    return mpmath.fsum(mpmath.mpf(a) / b for a, b in parts)


def bounds_of(angles):
    return algebroproj.bounds(algebroproj.metric.rotation_right)(*angles.T)


def assert_near(computed, truth, dtype):
    tolerance = 16 * mpmath.mpf(float(np.finfo(dtype).eps / 2)) ** 2
    for hi, lo, value in zip(np.atleast_1d(computed.hi), np.atleast_1d(computed.lo), truth, strict=True):
        assert abs(exact((hi, lo)) - value) <= tolerance * abs(value)


@pytest.fixture(autouse=True)
def _digits():
    with mpmath.workdps(80):
        yield


def test_half_pi_has_a_hundred_digits():
    with mpmath.workdps(120):
        assert abs(mpmath.mpf(HALF_PI.numerator) / HALF_PI.denominator - mpmath.pi / 2) < mpmath.mpf(10) ** -100


@pytest.mark.parametrize("dtype", DTYPES)
def test_cosine_and_sine(dtype):
    angles = np.array(ANGLES, dtype)
    cosine, sine = cos_sin_of_pair(DoubleDouble(angles))
    points = [exact((angle,)) for angle in angles]
    assert_near(cosine, [mpmath.cos(point) for point in points], dtype)
    assert_near(sine, [mpmath.sin(point) for point in points], dtype)


@pytest.mark.parametrize("dtype", DTYPES)
def test_cosine_and_sine_of_large_angles(dtype):
    farthest = np.array(0.5, dtype) / np.finfo(dtype).eps
    steps = np.array(np.random.default_rng(1).uniform(-1, 1, 200), dtype) * farthest
    angles = np.concatenate([steps, [np.nextafter(farthest, dtype(0))]]).astype(dtype)
    cosine, sine = cos_sin_of_pair(DoubleDouble(angles))
    for computed, function in ((cosine, mpmath.cos), (sine, mpmath.sin)):
        for hi, lo, angle in zip(computed.hi, computed.lo, angles, strict=True):
            error = abs(exact((hi, lo)) - function(exact((angle,))))
            assert error <= 16 * mpmath.mpf(float(np.finfo(dtype).eps / 2)) ** 2


@pytest.mark.parametrize("dtype", DTYPES)
def test_angles_without_a_direction_have_no_cosine_and_no_sine_and_numpy_says_so(dtype):
    farthest = np.array(0.5, dtype) / np.finfo(dtype).eps
    angles = np.array([farthest, -4 * farthest, 1e30, np.finfo(dtype).max, np.inf, np.nan], dtype)
    with pytest.warns(RuntimeWarning, match="invalid value"):
        cosine, sine = cos_sin_of_pair(DoubleDouble(angles))
    assert np.isnan([cosine.hi, sine.hi]).all()


@pytest.mark.parametrize("dtype", DTYPES)
def test_a_rotation_by_angles_of_any_size_is_one_or_not_a_number(dtype):
    angles = np.outer(10.0 ** np.arange(0, 38), [1, -2, 3]).astype(dtype)
    with np.errstate(invalid="ignore"):
        rotations = algebroproj.metric.rotation_right(*angles.T)
        (values, errors), known = bounds_of(angles), np.isfinite(rotations).all(axis=(-1, -2))
    gram = rotations[known] @ rotations[known].swapaxes(-1, -2)
    assert known[: 7 if dtype == np.float32 else 15].all()
    assert not known[20:].any()
    assert np.abs(gram - np.eye(3)).max() < 8 * np.finfo(dtype).eps
    assert np.isinf(errors[np.isnan(rotations)]).all()
    assert np.array_equal(values, rotations, equal_nan=True)


@pytest.mark.parametrize("dtype", DTYPES)
def test_arctangent_in_all_quadrants(dtype):
    y, x = (part.ravel() for part in np.meshgrid([-2.5, -1e-3, 0.7, 3.0], [-4.0, -1e-4, 0.3, 5.0]))
    y, x = y.astype(dtype), x.astype(dtype)
    angle = arctan2_of_pair(DoubleDouble(y), DoubleDouble(x))
    assert_near(angle, [mpmath.atan2(exact((a,)), exact((b,))) for a, b in zip(y, x, strict=True)], dtype)


def test_an_angle_has_its_own_second_part():
    angle = DoubleDouble(np.array([0.75]), np.array([1e-17]))
    cosine, _ = cos_sin_of_pair(angle)
    assert_near(cosine, [mpmath.cos(mpmath.mpf(0.75) + mpmath.mpf(1e-17))], np.float64)


# -- roots, lengths, exponentials and logarithms -----------------------------------------------------------------------

UNARY = {
    "exp": (exp, mpmath.exp, [0.0, 1e-20, 1.0, -0.7, 20.0, -60.25, 80.5]),
    "log": (log, mpmath.log, [1.0, 2.0, 1e-20, 0.7, 1e20, 3.0, 1 + 2.0**-20]),
    "sqrt": (sqrt, mpmath.sqrt, [0.0, 1.0, 2.0, 1e-20, 0.7, 1e20, 9.0]),
}
every_unary = pytest.mark.parametrize("name", UNARY)
every_type = pytest.mark.parametrize("dtype", DTYPES)


def test_log_2_has_a_hundred_digits():
    with mpmath.workdps(120):
        assert abs(mpmath.mpf(LOG_2.numerator) / LOG_2.denominator - mpmath.log(2)) < mpmath.mpf(10) ** -100


def drawn(name, dtype):
    """Operands: some that are special, and others of every size."""
    generator = np.random.default_rng(5)
    powers = generator.uniform(-30, 30, 100)
    return np.concatenate([UNARY[name][2], powers if name == "exp" else np.exp(powers)]).astype(dtype)


@every_unary
@every_type
def test_functions_of_one_number_have_twice_the_digits(name, dtype):
    function, truth, _ = UNARY[name]
    operands = drawn(name, dtype)
    low = operands * np.finfo(dtype).eps / 8
    computed = function(DoubleDouble(operands, low))
    tolerance = 64 * mpmath.mpf(float(np.finfo(dtype).eps / 2)) ** 2
    for hi, lo, *parts in zip(computed.hi, computed.lo, operands, low, strict=True):
        value = truth(exact(parts))
        assert abs(exact((hi, lo)) - value) <= tolerance * max(abs(value), int(name == "log"))


@every_type
def test_lengths_have_twice_the_digits_and_do_not_overflow(dtype):
    sizes = np.array([1e-12, 0.3, 5.0, 1e25, 0.0], dtype)
    x, y = (part.ravel() for part in np.meshgrid(sizes, -sizes))
    length = hypot(DoubleDouble(x), DoubleDouble(y))
    assert_near(length, [mpmath.hypot(exact((a,)), exact((b,))) for a, b in zip(x, y, strict=True)], dtype)


@every_unary
def test_the_library_errs_by_no_more_than_is_assumed(name):
    function, truth, _ = UNARY[name]
    for operand in drawn(name, np.float64):
        value = truth(exact((operand,)))
        assert abs(exact((function(operand),)) - value) <= LIBRARY * np.spacing(abs(float(value)))


def test_what_is_assumed_of_the_library_holds_for_angles_and_lengths():
    generator = np.random.default_rng(2)
    for a, b in generator.normal(size=(100, 2)) * 10 ** generator.uniform(-5, 5, (100, 1)):
        pairs = [(hypot(a, b), mpmath.hypot(a, b)), (arctan2(a, b), mpmath.atan2(a, b))]
        pairs += zip(cos_sin(a), (mpmath.cos(a), mpmath.sin(a)), strict=True)
        for computed, value in pairs:
            assert abs(exact((np.float64(computed),)) - value) <= LIBRARY * np.spacing(max(1.0, abs(float(value))))


@every_unary
def test_a_root_and_a_logarithm_of_a_negative_number_are_not_a_number(name):
    function = UNARY[name][0]
    with np.errstate(all="ignore"):
        results = [function(np.array([-1.0])), function(DoubleDouble(np.array([-1.0]))).hi]
    assert [bool(np.isnan(result[0])) for result in results] == [name != "exp"] * 2


@every_unary
@pytest.mark.parametrize("kind", [np.array, lambda x: Pair(np.array(x)), lambda x: DoubleDouble(np.array(x))])
def test_bounds_cover_uncertain_operands(name, kind):
    function, truth, _ = UNARY[name]
    generator = np.random.default_rng(3)
    values, radii = generator.uniform(0, 4, 300), generator.uniform(0, 1, 300) ** 4
    found = function(Bounded(kind(values), radii))
    finite = np.isfinite(found.error)
    assert finite.mean() > 0.8
    assert finite.all() == (name == "exp")
    parts = [getattr(found.value, "hi", found.value), getattr(found.value, "lo", np.zeros(300))]
    for place in np.flatnonzero(finite):
        computed = exact([part[place] for part in parts])
        for end in (-radii[place], 0, radii[place]):
            assert abs(truth(mpmath.mpf(values[place]) + end) - computed) <= found.error[place]


def test_bounds_of_lengths_cover_uncertain_points():
    generator = np.random.default_rng(4)
    (x, y), radius = generator.normal(size=(2, 300)), generator.uniform(0, 0.5, 300)
    length = hypot(Bounded(x, radius), Bounded(y, radius))
    for sign in (-1, 1):
        assert (abs(np.hypot(x + sign * radius, y - sign * radius) - length.value) <= length.error + 1e-15).all()


x, y, length, logarithm, power, root = sympy.symbols("x y length logarithm power root")


def kernel_of(derived, through, name="demo.f"):
    return Section("demo", "1", "Demonstration").kernel(
        name,
        "A function.",
        arguments={"x": x, "y": y},
        derived=derived,
        through=through,
        claims=["1.1"],
        example={"x": "0.5", "y": "0.25"},
        describe={"x": "A number.", "y": "A number."},
    )


CUBE_ROOT = kernel_of(
    {"difference": power - over(x, length), "size": logarithm, "moved": root * x + y},
    [
        declaring.hypot(length, x, y),
        declaring.log(logarithm, length),
        declaring.exp(power, over(logarithm, 3)),
        declaring.sqrt(root, length + x),
    ],
)
DIFFERENCE = kernel_of(vector(root, logarithm), [declaring.sqrt(root, x - y), declaring.log(logarithm, x + y)])


@pytest.mark.sampled(2)
@pytest.mark.parametrize("kernel", [CUBE_ROOT, DIFFERENCE], ids=["composed", "with a domain"])
def test_a_function_that_calls_them_is_proved_accurate_and_bounded(kernel, tmp_path):
    low = lower(kernel)
    write(render([low]), tmp_path / PACKAGE)
    package = load_package(tmp_path)
    verification = verify(low, package, size=40, seconds=0.5)
    assert verification.passed
    samples = samples_of(low, 40)
    assert 10 < len(samples) <= 80
    function = function_of(kernel, package)
    arguments = [np.array([sample.values[name] for sample in samples]) for name in "xy"]
    found = package.bounds(function)(*arguments)
    for place, truth in enumerate(truths(low, samples)):
        parts = (
            [(v[place], e[place]) for v, e in found]
            if kernel is CUBE_ROOT
            else zip(*(f[place] for f in found), strict=True)
        )
        for (value, error), exactly in zip(parts, truth.values, strict=True):
            assert abs(mpmath.mpf(value) - exactly) <= error < np.inf


def test_the_documentation_says_where_they_are_numbers():
    text = " ".join(render([lower(DIFFERENCE)])["demo.py"].split())
    assert "only where this is zero or positive: ``x - y``" in text
    assert "only where this is positive: ``x + y``" in text


# -- C++ ---------------------------------------------------------------------------------------------------------------

CPP = {"float": np.float32, "double": np.float64, "long double": np.longdouble}
CALLED = {
    "arctan2": (2, 1, lambda a, b: [mpmath.atan2(a, b)]),
    "cos_sin": (1, 2, lambda a: [mpmath.cos(a), mpmath.sin(a)]),
    "exp": (1, 1, lambda a: [mpmath.exp(a)]),
    "hypot": (2, 1, lambda a, b: [mpmath.hypot(a, b)]),
    "log": (1, 1, lambda a: [mpmath.log(a)]),
    "sqrt": (1, 1, lambda a: [mpmath.sqrt(a)]),
}
POINTS = 60


def program_that_calls():
    """Return a program that reads operands for each type and function, and writes what both versions give."""
    lines = [
        "#include <cstdio>",
        '#include "elementary.hpp"',
        "using namespace algebroproj::arithmetic;",
        "int main()",
        "{",
    ]
    for kind in CPP:
        for name, (operands, results, _) in CALLED.items():
            lines += [
                f"    for (int point = 0; point < {POINTS}; point++) {{",
                f"        {kind} both[1][{2 * operands}], first[1][{operands}];",
                f"        {kind} doubled[{2 * results}], single[{results}];",
                "        if (std::fread(both, sizeof both, 1, stdin) != 1) {",
                "            return 1;",
                "        }",
                f"        for (int place = 0; place < {operands}; place++) {{",
                "            first[0][place] = both[0][place];",
                "        }",
                f"        {name}_doubled(both, doubled);",
                f"        {name}(first, single);",
                "        std::fwrite(doubled, sizeof doubled, 1, stdout);",
                "        std::fwrite(single, sizeof single, 1, stdout);",
                "    }",
            ]
    return "\n".join([*lines, "    return 0;", "}", ""])


@pytest.mark.skipif(shutil.which("g++") is None, reason="needs g++")
def test_functions_of_the_cpp_headers_have_the_digits_that_are_promised(tmp_path):
    write(render_cpp([]), tmp_path)
    (tmp_path / "main.cpp").write_text(program_that_calls())
    options = ["-std=c++17", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-O1"]
    subprocess.run(["g++", *options, "-o", "run", "main.cpp"], cwd=tmp_path, check=True)
    generator = np.random.default_rng(6)
    given = []
    for dtype in CPP.values():
        for operands, _, _ in CALLED.values():
            high = np.exp(generator.uniform(-4, 4, (POINTS, operands))).astype(dtype)
            low = high * (generator.uniform(-0.25, 0.25, high.shape) * np.finfo(dtype).eps).astype(dtype)
            given.append(np.concatenate([high, low], axis=1))
    done = subprocess.run(
        [tmp_path / "run"], input=b"".join(g.tobytes() for g in given), capture_output=True, check=True
    )
    output, blocks = done.stdout, iter(given)
    for dtype in CPP.values():
        unit = mpmath.mpf(float(np.finfo(dtype).eps / 2))
        for name, (operands, results, truth) in CALLED.items():
            size = POINTS * 3 * results * np.dtype(dtype).itemsize
            found, output = np.frombuffer(output[:size], dtype).reshape(POINTS, 3 * results), output[size:]
            for point, row in zip(next(blocks), found, strict=True):
                both = [exact((point[k], point[k + operands])) for k in range(operands)]
                for k, (wide, narrow) in enumerate(
                    zip(truth(*both), truth(*(exact((part,)) for part in point[:operands])), strict=True)
                ):
                    one = max(1, abs(wide)) if name in ("cos_sin", "log") else abs(wide)
                    assert abs(exact(row[2 * k : 2 * k + 2]) - wide) <= 64 * unit**2 * one, name
                    assert abs(exact((row[2 * results + k],)) - narrow) <= 2 * LIBRARY * unit * abs(narrow), name
    assert not output
