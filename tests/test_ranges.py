"""Within its range nothing overflows or underflows in a function, whatever the digits of the arguments are."""

from fractions import Fraction
from random import Random

import numpy as np
import pytest
from cases import for_each

import algebroproj
from algebroproj import optics, orientation, projection
from algebroproj_sym.declaring import kernels
from algebroproj_sym.generating.program import Program, Step
from algebroproj_sym.generating.ranges import reach
from algebroproj_sym.generating.systems import system_program
from algebroproj_sym.verifying.shipped import function_of, without_twin

RATIONAL = [kernel.qualified_name for kernel in kernels() if all(stage.primitive == "let" for stage in kernel.stages)]


def program(*steps, inputs="xy"):
    return Program(tuple(inputs), tuple(Step(*step) for step in steps), (steps[-1][0],))


@pytest.mark.parametrize(
    ("steps", "expected"),
    [
        ([("t0", "*", ("x", "y"))], 511),
        ([("t0", "+", ("x", "y"))], 1022),
        ([("t0", "/", ("x", "y"))], 511),
        ([("t0", "*", ("x", "y")), ("t1", "product_error", ("x", "y", "t0"))], 484),
        ([("t0", "-", ("x", "y")), ("t1", "*", ("t0", "t0"))], 485),
        ([("t0", "*", (0, "x")), ("t1", "+", ("t0", "y"))], 1022),
    ],
)
def test_ranges_of_small_programs(steps, expected):
    assert reach(program(*steps)) == expected


def test_linear_systems_have_none():
    assert reach(system_program("solve", 1, refined=False)) == 511
    assert reach(Program(("x",), (), ("x",))) == 1022


def extreme(k, shape, generator):
    """Return numbers from the ends of a range, neighbours of powers of two among them, and zeros."""
    exponents = generator.choice([-k, -k, k, k, 0, generator.integers(-k, k + 1)], shape)
    digits = generator.choice([1.0, 1 + 2.0**-52, 1.5, 1.25], shape)
    numbers = np.ldexp(np.where(exponents == k, 1.0, digits), exponents)
    return generator.choice([-1.0, 1.0, 1.0, 0.0], shape, p=[0.4, 0.4, 0.15, 0.05]) * numbers


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", RATIONAL)
def test_nothing_overflows_or_underflows_within_the_range(name, lowered):
    low = lowered(name)
    k = reach(low.program)
    if k is None:
        assert low.program.operations().total() > 100
        return
    generator = np.random.default_rng(k)
    body = function_of(low.kernel, algebroproj).__globals__[f"_{low.kernel.name}"]
    inputs = [extreme(k, 400, generator) for _ in low.kernel.symbols]
    with np.errstate(over="raise", under="raise", divide="ignore", invalid="ignore"):
        body(*inputs)


def test_the_documentation_tells_the_range():
    for function, exponent in ((optics.scale, 485), (projection.mu_from_center, 240)):
        assert f"between 2**-{exponent} and 2**{exponent}" in " ".join(function.__doc__.split())


SPLIT = [(0, 2), (2, 4), (4, 7), (7, 9), (9, 12), (12, 14)]
"""Which of 14 numbers belong to which argument of `orientation.intersect`."""


def given(rows):
    return [rows[..., a:b] for a, b in SPLIT]


def of_sizes(dtype, scales, count=1000):
    generator = np.random.default_rng(5)
    rows = generator.uniform(-1, 1, (count, 14)) * np.exp(generator.uniform(*np.log(scales), (count, 1)))
    return rows.astype(dtype)


SIZES = [
    (np.float32, (300.0, 4000.0)),
    (np.float32, (1e-9, 1e-6)),
    (np.float64, (1e24, 1e70)),
    (np.float64, (1e-99, 1e-30)),
]


@pytest.mark.parametrize(("dtype", "scales"), SIZES)
def test_an_intersection_is_right_where_its_intermediate_results_overflow_or_underflow(dtype, scales):
    rows = of_sizes(dtype, scales)
    with np.errstate(all="raise"):
        found, source = (
            function(*given(rows)) for function in (orientation.intersect, without_twin(orientation.intersect))
        )
        wide = orientation.intersect(*given(rows.astype(np.longdouble))).astype(np.float64)
    assert np.array_equal(found, source)
    assert (abs(found - wide) <= 5 * np.finfo(dtype).eps * abs(wide)).all()


@pytest.mark.parametrize("name", ["orientation.intersect", "optics.scale", "collinearity.intersect"])
def test_a_point_has_the_same_bits_whatever_its_neighbours_do(name):
    """One in a hundred overflows or underflows; the others are computed once more with it, or are not."""
    function, generator = function_of(kernels([name])[0], algebroproj), np.random.default_rng(8)
    signature = function.__globals__[f"_{function.__name__.upper()}_SIGNATURE"]
    arguments = [generator.uniform(-1, 1, (300, *core)) for _, core in signature.arguments]
    some = generator.random(300) < 0.01
    some[0] = True
    for argument in arguments:
        argument[some] *= 1e-200
    with np.errstate(all="ignore"):
        together = function(*arguments)
        alone = np.stack([function(*(argument[place] for argument in arguments)) for place in range(300)])
    assert np.array_equal(together, alone, equal_nan=True)


def test_results_are_written_where_the_arguments_were():
    rows = of_sizes(np.float64, (1e-99, 1e-30), 5000)
    expected = orientation.intersect(*given(rows))
    result = orientation.intersect(*given(rows), out=rows[:, 4:7])
    assert result.base is rows
    assert np.array_equal(rows[:, 4:7], expected)


@for_each("part", [slice(0, 5), slice(1, 6), slice(2, 7), slice(4, None, -1), slice(0, 10, 2)])
@for_each("size", [1.0, 1e-200])
def test_results_are_written_over_arguments(part, size):
    """Arrays in the usual layout are written at once, unless they share memory with an argument."""
    memory = np.linspace(1, 2, 10) * size
    x, f = memory[:5].copy(), np.full(5, 3 * size)
    found = optics.scale(memory[:5], f, out=memory[part])
    assert found.base is memory
    assert np.array_equal(memory[part], optics.scale(x, f))


def test_threads_notice_it(monkeypatch):
    rows = of_sizes(np.float64, (0.5, 2.0), 2000)
    rows[1700] *= 1e-60
    expected = orientation.intersect(*given(rows))
    monkeypatch.setattr(algebroproj._runtime.threads, "POINTS", 1000)
    assert np.array_equal(orientation.intersect(*given(rows)), expected)


def test_twice_the_digits_bounds_and_factors_know_small_numbers():
    rows = of_sizes(np.float64, (1e-99, 1e-60), 20)
    exact = np.array([orientation._intersect(*map(Fraction, row)) for row in rows.tolist()])
    double = algebroproj.dd(orientation.intersect)(*given(rows))
    values, errors = algebroproj.bounds(orientation.intersect)(*given(rows))
    (factors,) = algebroproj.hypotheses(orientation.intersect)(*given(rows * 1e38)).values()
    expected = [float(*orientation._intersect_factors(*map(Fraction, row))) for row in (rows * 1e38).tolist()]
    assert np.array_equal(values, orientation.intersect(*given(rows)))
    for row, value, error, hi, lo in zip(exact, values, errors, double.hi, double.lo, strict=True):
        for x, v, e, h, low in zip(row, value, error, hi, lo, strict=True):
            assert e == np.inf or abs(Fraction(v) - x) <= Fraction(e)
            assert abs(Fraction(h) + Fraction(low) - x) <= abs(x) / 2**98
    assert np.allclose(factors, expected, rtol=1e-15, atol=1e-322)


def moved(generator, exponents):
    """Change the size of an entry, or of all that are as large."""
    changed, place, by = list(exponents), generator.randrange(len(exponents)), generator.randint(-40, 40)
    alike = generator.random() < 0.3
    for k, exponent in enumerate(exponents):
        if k == place or (alike and exponent == exponents[place]):
            changed[k] = min(max(exponent + by, -100), 0)
    return changed


@pytest.mark.sampled(4)
@pytest.mark.parametrize("seed", range(4))
def test_small_coordinates_keep_their_digits_in_an_intersection(seed):
    """Hill climbing over the exponents, down to 1e-30, finds no entry that a sum such as 1 - x has swallowed."""
    generator = Random(seed)
    digits = [generator.choice((-1, 1)) * generator.uniform(1, 2) for _ in range(14)]

    def error(exponents):
        point = [d * 2.0**e for d, e in zip(digits, exponents, strict=True)]
        exact = orientation._intersect(*map(Fraction, point))
        found = orientation.intersect(*(point[a:b] for a, b in SPLIT))
        return max(abs(Fraction(float(x)) / y - 1) for x, y in zip(found, exact, strict=True))

    exponents = [generator.choice((0, -100)) for _ in digits]
    worst = error(exponents)
    for _ in range(150):
        candidate = moved(generator, exponents)
        if (larger := error(candidate)) >= worst:
            exponents, worst = candidate, larger
    assert worst < 5 * 2.0**-53


@pytest.mark.parametrize("version", [lambda function: function, without_twin], ids=["compiled", "NumPy"])
def test_only_a_result_that_is_too_large_or_too_small_is_reported(version):
    """NumPy warns of the former; of the latter it tells who asks."""
    determinant = version(projection.projection_determinant_from_mu)
    u3 = np.array([0.25, 0.5])
    with np.errstate(all="raise"):
        assert determinant(np.array([1e-200, 1e-200, 1e100]), u3) == pytest.approx(7.5e-101, rel=1e-15)
        for size, kind in ((1e160, "overflow"), (1e-170, "underflow")):
            with pytest.raises(FloatingPointError, match=kind):
                determinant(np.full(3, size), u3)
