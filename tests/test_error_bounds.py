"""Bounds of running error analysis hold: exact arithmetic on the same inputs says what the error is."""

from fractions import Fraction
from operator import add, mul, sub, truediv

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from algebroproj_sym.declaring import kernels
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.generating.program import run
from algebroproj_sym.generating.runtime.error_bounds import Bounded
from algebroproj_sym.generating.runtime.pairs import NEAR, SUMS, DoubleDouble, Pair
from algebroproj_sym.generating.runtime.sqrt import _with_bound
from algebroproj_sym.generating.samples import stratified

KERNELS = {kernel.qualified_name: kernel for kernel in kernels() if not kernel.stages}
HEAVY = {"critical.quadric"}


def bounded(program, samples):
    names = program.inputs
    values = {name: np.array([sample.values[name] for sample in samples]) for name in names}
    with np.errstate(all="ignore"):
        return run(program, {name: Bounded(value, np.zeros_like(value)) for name, value in values.items()})


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", sorted(set(KERNELS) - HEAVY))
def test_a_bound_is_never_below_the_error_and_seldom_far_above(name, lowered):
    low = lowered(name)
    samples = stratified(low, 10, seed=3)
    exact = [
        evaluate(low.kernel.derived, {s: Fraction(sample.values[s.name]) for s in low.kernel.symbols})
        for sample in samples
    ]
    ratios = []
    for program in (low.plain, low.program):
        for place, entry in enumerate(bounded(program, samples)):
            if not isinstance(entry, Bounded):
                continue
            values, errors = np.broadcast_arrays(entry.value, entry.error)
            for value, error, truth in zip(values, errors, (row[place] for row in exact), strict=True):
                if np.isfinite(error):
                    true = abs(Fraction(float(value)) - truth)
                    assert true <= Fraction(float(error))
                    ratios += [float(Fraction(float(error)) / true)] if true else []
    assert not ratios or np.median(ratios) < 100


@st.composite
def uncertain(draw):
    """Return a number with a bound, whose parts may cancel, and the farthest exact values that the bound allows."""
    hi = draw(st.floats(0.5, 2)) * draw(st.sampled_from([1, -1]))
    lo = draw(
        st.just(None)
        | st.floats(-1, 1).map(lambda part: part * 2.0**-54 * abs(hi))
        | st.integers(-3, 3).map(lambda units: -hi * (1 + units * 2.0**-52))
        | st.floats(-1, 1).map(lambda part: -hi * (1 + part * 2.0**-8))
        | st.floats(-1, 1)
    )
    near = lo is not None and abs(lo) <= 2.0**-53 * abs(hi)
    value = np.float64(hi) if lo is None else Pair(np.float64(hi), np.float64(lo), NEAR if near else SUMS)
    total = Fraction(hi) + (0 if lo is None else Fraction(lo))
    error = abs(float(total)) * draw(st.sampled_from([0.0, 1e-30, 2.0**-52, 1e-3, 0.5, 2.0]))
    return Bounded(value, np.float64(error)).wide(), [total - Fraction(error), total + Fraction(error)]


@given(uncertain(), uncertain())
@settings(max_examples=15 * settings.default.max_examples)
def test_bounds_hold_whatever_the_exact_operands_are(left, right):
    (x, exact_x), (y, exact_y) = left, right
    straddles = exact_y[0] * exact_y[1] <= 0
    for operation in (add, sub, mul, truediv):
        with np.errstate(all="ignore"):
            result = operation(x, y)
            numbers = [result, result.rounded(), result.rounded_twice()]
        if operation is truediv and straddles:
            assert all(number.error == np.inf for number in numbers[1:])
            continue
        for number in numbers:
            for truth in (operation(a, b) for a in exact_x for b in exact_y):
                assert number.error == np.inf or abs(exact(number.value) - truth) <= Fraction(float(number.error))


def exact(value):
    parts = [value.hi, value.lo] if hasattr(value, "hi") else [value]
    return sum((Fraction(float(part)) for part in parts if part is not None), Fraction(0))


def test_a_divisor_that_may_be_zero_has_no_bound():
    x = Bounded(np.array([1.0, 1.0]), np.array([0.0, 2.0]))
    with np.errstate(all="ignore"):
        assert (1 / x).error.tolist()[1] == np.inf
        assert (1 / x).error[0] < 1e-15


def test_a_value_that_overflows_has_no_bound():
    x = Bounded(np.array([1e300]), np.array([0.0]))
    with np.errstate(all="ignore"):
        assert (x * x).error[0] == np.inf
        assert (x.wide() * x).rounded().error[0] == np.inf


def test_the_bound_of_a_root_is_a_number_at_zero():
    """Nothing is lost there: the root of zero is zero."""
    of = Bounded(DoubleDouble(np.array([0.0, 4.0]), np.zeros(2)), np.zeros(2))
    with np.errstate(divide="raise", invalid="raise"):
        found = _with_bound(of)
    assert np.isfinite(found.error).all()
    assert found.error[0] < 1e-300
