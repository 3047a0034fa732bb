"""Bounds of running error analysis hold: exact arithmetic on the same inputs says what the error is."""

from fractions import Fraction

import numpy as np
import pytest

from algebroproj_sym.declaring import kernels
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.generating import run
from algebroproj_sym.generating.runtime._error_bounds import Bounded
from algebroproj_sym.verifying import stratified

KERNELS = {kernel.qualified_name: kernel for kernel in kernels() if not kernel.stages}
HEAVY = {"critical.quadric"}


def bounded(program, samples):
    names = program.inputs
    values = {name: np.array([sample.values[name] for sample in samples]) for name in names}
    with np.errstate(all="ignore"):
        return run(program, {name: Bounded(value, np.zeros_like(value)) for name, value in values.items()})


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
