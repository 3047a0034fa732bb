"""Every generated function with twice the digits and with bounds, held against 50 digits of the derivation."""

import mpmath
import numpy as np
import pytest

from algebroproj_sym.declaring import kernels
from algebroproj_sym.generating.samples import stratified
from algebroproj_sym.verifying.accuracy import truths
from algebroproj_sym.verifying.shipped import function_of, load_package

KERNELS = {kernel.qualified_name: kernel for kernel in kernels()}
every_kernel = pytest.mark.parametrize("name", list(KERNELS))


@pytest.fixture(scope="module")
def package():
    return load_package()


@pytest.fixture(autouse=True)
def _digits():
    with mpmath.workdps(60):
        yield


def gathered(kernel, samples):
    """Return the arguments of a function for a batch of samples."""
    arrays = []
    for argument in kernel.arguments:
        entries = [[sample.values[symbol.name] for symbol in argument.symbols] for sample in samples]
        arrays.append(np.array(entries).reshape(len(samples), *argument.shape))
    return arrays


def flat(results, members):
    """Return the entries of one or several results, a row for each member of the batch."""
    return np.concatenate([np.asarray(result).reshape(members, -1) for result in results], axis=-1)


def exact(value):
    numerator, denominator = value.as_integer_ratio()
    return mpmath.mpf(numerator) / denominator


@pytest.mark.sampled(8)
@every_kernel
def test_twice_the_digits(name, lowered, package):
    low = lowered(name)
    samples = [sample for sample in stratified(low, 6) if sample.stratum == "ordinary"]
    returned = package.dd(function_of(low.kernel, package))(*gathered(low.kernel, samples))
    numbers = returned if isinstance(returned, tuple) else (returned,)
    high = flat([number.hi for number in numbers], len(samples))
    rest = flat([number.lo for number in numbers], len(samples))
    for row, truth in enumerate(truths(low, samples)):
        for place, (value, sensitivity) in enumerate(zip(truth.values, truth.sensitivities, strict=True)):
            error = abs(exact(high[row, place]) + exact(rest[row, place]) - value)
            assert error <= mpmath.mpf(10) ** -29 * (abs(value) + sensitivity)


@pytest.mark.sampled(12)
@every_kernel
def test_bounds_hold_near_singularities_as_well(name, lowered, package):
    low = lowered(name)
    samples = stratified(low, 5, seed=11)
    function = function_of(low.kernel, package)
    arguments = gathered(low.kernel, samples)
    returned = package.bounds(function)(*arguments)
    pairs = returned if isinstance(returned[0], tuple) else (returned,)
    values, errors = (flat([pair[part] for pair in pairs], len(samples)) for part in range(2))
    with np.errstate(all="ignore"):
        plain = function(*arguments)
    assert np.array_equal(values, flat(plain if isinstance(plain, tuple) else (plain,), len(samples)), equal_nan=True)
    ratios = []
    for row, truth in enumerate(truths(low, samples)):
        for place, value in enumerate(truth.values):
            if np.isfinite(errors[row, place]):
                error = abs(exact(values[row, place]) - value)
                assert error <= exact(errors[row, place]), (samples[row], place)
                ratios += [float(errors[row, place] / error)] if error else []
    assert np.isfinite(errors).mean() > 0.8
    assert not ratios or np.median(ratios) < 100


def test_arguments_of_twice_the_digits_count(package):
    third = package.DoubleDouble(np.float64(1) / 3, np.float64(1.850371707708594e-17))
    result = package.dd(package.optics.scale)(third, 1.0)
    assert abs(exact(result.hi) + exact(result.lo) - mpmath.mpf(1) / 4) < 1e-31


@pytest.mark.parametrize("modifier", ["dd", "bounds"])
def test_what_is_no_generated_function_of_real_numbers_is_refused(modifier, package):
    modified = getattr(package, modifier)
    with pytest.raises(TypeError, match=f"{modifier}: expected a generated function, got sum"):
        modified(sum)
    with pytest.raises(TypeError, match="expected real machine numbers, got dtype complex128"):
        modified(package.optics.scale)(1j, 1.0)
    with pytest.raises(TypeError, match="expected the arguments f, x3, got 1"):
        modified(package.optics.scale)(1.0)


def test_a_batch_of_float32_systems_has_twice_the_digits(package):
    """An entry of a system is the integer 1: in a batch it must not make float64 of the others."""
    pairs = np.random.default_rng(1).normal(size=(2, 5, 8, 2)).astype(np.float32)
    function = package.dd(package.correlation.general_correlation_matrix)
    several, wide = function(*pairs), function(*pairs.astype(float))
    assert several.hi.dtype == several.lo.dtype == np.float32
    found = several.hi.astype(float) + several.lo
    assert np.max(abs(found - wide.hi)) < 1e-11
