"""Within its range nothing overflows or underflows in a function, whatever the digits of the arguments are."""

from fractions import Fraction
from random import Random

import numpy as np
import pytest

from algebroproj import optics, orientation, projection
from algebroproj_sym.declaring import kernels
from algebroproj_sym.generating.program import Program, Step
from algebroproj_sym.generating.ranges import reach
from algebroproj_sym.generating.systems import system_program
from algebroproj_sym.verifying.shipped import function_of

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


@pytest.mark.parametrize("name", RATIONAL)
def test_nothing_overflows_or_underflows_within_the_range(name, lowered):
    low = lowered(name)
    k = reach(low.program)
    if k is None:
        assert low.program.operations().total() > 100
        return
    generator = np.random.default_rng(k)
    body = function_of(low.kernel, __import__("algebroproj")).__globals__[f"_{low.kernel.name}"]
    inputs = [extreme(k, 400, generator) for _ in low.kernel.symbols]
    with np.errstate(over="raise", under="raise", divide="ignore", invalid="ignore"):
        body(*inputs)


def test_the_documentation_tells_the_range():
    for function, exponent in ((optics.scale, 485), (projection.mu_from_center, 240)):
        assert f"between 2**-{exponent} and 2**{exponent}" in " ".join(function.__doc__.split())


@pytest.mark.parametrize(("dtype", "scales"), [(np.float32, (300.0, 4000.0)), (np.float64, (1e24, 1e30))])
def test_an_intersection_that_overflows_is_not_finite(dtype, scales):
    """Zero over infinity is no coordinate."""
    generator = np.random.default_rng(5)
    rows = generator.uniform(-1, 1, (3000, 14)) * np.exp(generator.uniform(*np.log(scales), (3000, 1)))
    rows = rows.astype(dtype)
    split = [(0, 2), (2, 4), (4, 7), (7, 9), (9, 12), (12, 14)]
    with np.errstate(all="ignore"):
        found = orientation.intersect(*(rows[:, a:b] for a, b in split))
        wide = orientation.intersect(*(rows[:, a:b].astype(np.longdouble) for a, b in split)).astype(np.float64)
    finite = np.isfinite(found).all(axis=1)
    assert 0.1 < finite.mean() < 0.9
    off = abs(found[finite] - wide[finite]).max(axis=1) / abs(wide[finite]).max(axis=1)
    assert off.max() < 64 * np.finfo(dtype).eps


def moved(generator, exponents):
    """Change the size of an entry, or of all that are as large."""
    changed, place, by = list(exponents), generator.randrange(len(exponents)), generator.randint(-40, 40)
    alike = generator.random() < 0.3
    for k, exponent in enumerate(exponents):
        if k == place or (alike and exponent == exponents[place]):
            changed[k] = min(max(exponent + by, -100), 0)
    return changed


@pytest.mark.parametrize("seed", range(4))
def test_small_coordinates_keep_their_digits_in_an_intersection(seed):
    """Hill climbing over the exponents, down to 1e-30, finds no entry that a sum such as 1 - x has swallowed."""
    generator = Random(seed)
    digits = [generator.choice((-1, 1)) * generator.uniform(1, 2) for _ in range(14)]
    bounds_of = [(0, 2), (2, 4), (4, 7), (7, 9), (9, 12), (12, 14)]

    def error(exponents):
        point = [d * 2.0**e for d, e in zip(digits, exponents, strict=True)]
        exact = orientation._intersect(*map(Fraction, point))
        found = orientation.intersect(*(point[a:b] for a, b in bounds_of))
        return max(abs(Fraction(float(x)) / y - 1) for x, y in zip(found, exact, strict=True))

    exponents = [generator.choice((0, -100)) for _ in digits]
    worst = error(exponents)
    for _ in range(150):
        candidate = moved(generator, exponents)
        if (larger := error(candidate)) >= worst:
            exponents, worst = candidate, larger
    assert worst < 5 * 2.0**-53


@pytest.mark.parametrize("intersect", [orientation.intersect, orientation._intersect], ids=["compiled", "NumPy"])
def test_underflow_is_reported_as_numpy_reports_it(intersect):
    """Products of numbers near 1e-48 are zero: who asks is told, whatever computes."""
    numbers = np.linspace(1e-48, 2e-48, 14)
    arguments = np.split(numbers, [2, 4, 7, 9, 12]) if intersect is orientation.intersect else numbers
    with np.errstate(under="raise"), pytest.raises(FloatingPointError, match="underflow"):
        intersect(*arguments)
