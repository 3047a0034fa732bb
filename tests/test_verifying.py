"""Verification accepts what is shipped, and rejects every kind of planted error."""

import ast
import inspect
import shutil
from fractions import Fraction
from types import FunctionType, SimpleNamespace

import numpy as np
import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import algebroproj
from algebroproj_sym.declaring import kernels
from algebroproj_sym.declaring.kernel import entries
from algebroproj_sym.expressions import evaluate
from algebroproj_sym.generating.samples import Sample, stratified
from algebroproj_sym.verifying.accuracy import BOUND, measured, truths
from algebroproj_sym.verifying.oracle import NoAgreementError
from algebroproj_sym.verifying.proof_of_source import in_general, source_is_proved
from algebroproj_sym.verifying.shipped import NotShippedError, function_of, load_package, without_twin
from algebroproj_sym.verifying.verification import silent_factors, verify


def size_of(kernel):
    return sum(1 for entry in entries(kernel.form) for _ in sympy.preorder_traversal(entry))


KERNELS = {kernel.qualified_name: kernel for kernel in kernels()}
NAMES = list(KERNELS)
# The other engine is up to a hundred times slower on large expressions: it proves the sources of the small functions.
SLOW = {"critical.quadric", "projection.from_camera"}
SMALL = [name for name, kernel in KERNELS.items() if not kernel.stages and size_of(kernel) < 500 and name not in SLOW]
every_kernel = pytest.mark.parametrize("name", NAMES)


def is_within_bound(low, package, size):
    return measured(low, function_of(low.kernel, package), stratified(low, size)).within_bound


def planted(name, old, new):
    """Return a package with one function whose source has one change."""
    function = without_twin(function_of(KERNELS[name], load_package()))
    source = inspect.getsource(function.__globals__[f"_{function.__name__}"])
    assert source.count(old) >= 1, source
    namespace = dict(function.__globals__)
    exec(compile(ast.parse("from __future__ import annotations\n" + source.replace(old, new)), name, "exec"), namespace)
    changed = FunctionType(function.__code__, namespace, function.__name__)
    changed.__kwdefaults__ = function.__kwdefaults__
    module, function_name = name.split(".")
    return SimpleNamespace(__name__="planted", **{module: SimpleNamespace(**{function_name: changed})})


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", NAMES[::15])
def test_shipped_functions_are_verified(name, lowered):
    """Some of them, and with their compiled versions; a build does this for all."""
    verification = verify(lowered(name), load_package(), size=12)
    assert verification.source_proved
    assert verification.silent == ()
    assert verification.accuracy.overall.max_ratio <= BOUND


@pytest.mark.sampled(6)
@pytest.mark.parametrize("name", SMALL)
def test_the_sympy_engine_proves_the_source_too(name):
    assert in_general(KERNELS[name], "sympy").is_met_by(function_of(KERNELS[name], load_package()))


magnitudes = st.floats(min_value=1e-8, max_value=1e8)
coordinates = st.builds(lambda sign, size: sign * size, st.sampled_from((-1.0, 1.0)), magnitudes)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", NAMES[::6])
@settings(max_examples=8)
@given(data=st.data())
def test_drawn_inputs_stay_within_the_bound(name, lowered, data):
    low = lowered(name)
    values = {symbol.name: data.draw(coordinates, symbol.name) for symbol in low.kernel.symbols}
    point = {symbol: Fraction(values[symbol.name]) for symbol in low.kernel.symbols}
    assume(all(evaluate(factor, point)[0] != 0 for factor in (*low.input_hypotheses, *low.determinants)))
    samples = [Sample("drawn", values)]
    known = truths_or_none(low, samples)
    assume(known is not None)
    found = measured(low, function_of(low.kernel, load_package()), samples, known)
    assert found.overall.max_ratio <= BOUND
    assert found.backward or found.overall.within_ulps, found.overall


def truths_or_none(low, samples):
    """Return the exact results, or nothing where a matrix or a divisor within a stage is singular."""
    try:
        return truths(low, samples)
    except (ZeroDivisionError, NoAgreementError):
        return None


def test_the_oracle_refuses_singular_systems(lowered):
    low = lowered("orientation.intersect")
    point = dict.fromkeys((symbol.name for symbol in low.kernel.symbols), -1.0)
    with pytest.raises(ZeroDivisionError):
        truths(low, [Sample("singular", point)])


@pytest.mark.whole
def test_every_kernel_has_values_at_inputs_without_structure(lowered):
    rng = np.random.default_rng(7)
    for name in NAMES:
        low = lowered(name)
        values = {symbol.name: float(rng.uniform(-3, 3)) for symbol in low.kernel.symbols}
        assert truths_or_none(low, [Sample("drawn", values)]) is not None, name


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("projection.mu_from_center", "u31 * y00 / (u30 * y01)", "u32 * y00 / (u30 * y01)"),
        ("projection.projection_determinant_from_mu", "(wide(mu3) - 1)", "(wide(mu3) + 1)"),
        ("projection.project", "/ delta", "/ (delta + delta / 10**9)"),
        ("space.map_points", "return ", "return -"),
        ("optics.scale", "f / (f + x3)", "(f + x3) / f"),
        ("affine.plane_coordinates", "rounded_twice(c11 * d2", "rounded_twice(c11 / 10**12 + c11 * d2"),
    ],
)
def test_a_planted_error_is_caught_by_the_proof_and_by_the_samples(name, old, new, lowered):
    package = planted(name, old, new)
    assert not is_within_bound(lowered(name), package, 20)
    exact = new.replace("1e-9", "1").replace("1e-12", "1")
    assert not source_is_proved(KERNELS[name], planted(name, old, exact))


def test_an_unstable_but_equal_formula_is_proved_and_still_caught_by_the_samples(lowered):
    package = planted(
        "projection.mu_from_center", "y00 = rounded(1 - wide(y01) - y02 - y03)", "y00 = 1 - y01 - y02 - y03"
    )
    assert source_is_proved(KERNELS["projection.mu_from_center"], package)
    assert not is_within_bound(lowered("projection.mu_from_center"), package, 40)


def test_a_function_that_stays_finite_on_a_singularity_is_caught(lowered):
    guarded = lowered("projection.reconstruction_matrix")
    assert guarded.guarded
    package = planted("projection.reconstruction_matrix", "0 / y02", "0 * y02")
    silent = silent_factors(guarded, package)
    assert [str(factor) for factor in silent] == ["y02"]


def test_a_function_that_stays_finite_where_a_sum_of_squares_of_names_vanishes_is_caught(lowered):
    distance = lowered("stereo.sampson")
    assert silent_factors(distance, algebroproj) == ()
    package = planted("stereo.sampson", "1 / t54", "1 / (t54 + 1)")
    assert [str(factor) for factor in silent_factors(distance, package)] == ["g0**2 + g1**2 + g2**2 + g3**2"]


@pytest.mark.sampled(12)
@every_kernel
def test_samples_cover_every_stratum_and_come_as_near_as_they_say(name, lowered):
    low = lowered(name)
    samples = stratified(low, 28)
    strata = {sample.stratum for sample in samples}
    systems = {"near a singular system"} if low.determinants else set()
    factors = {f"near {factor}" for factor in low.input_hypotheses}
    elsewhere = {"near several factors", "near a zero of a result"}
    assert strata - elsewhere == {"ordinary", "badly scaled", *factors, *systems}
    for factor in low.input_hypotheses:
        near = [sample.values for sample in samples if sample.stratum == f"near {factor}"]
        points = ({s: Fraction(v[s.name]) for s in low.kernel.symbols} for v in near)
        distances = [abs(float(evaluate(factor, point)[0])) for point in points]
        assert min(distances) < 1e-11
        assert max(distances) > 1e-2


@pytest.mark.parametrize("name", ["projection.projection_matrix", "space.mu_from_fifth_point"])
def test_samples_come_near_several_factors_at_once(name, lowered):
    low = lowered(name)
    points = [
        {symbol: Fraction(sample.values[symbol.name]) for symbol in low.kernel.symbols}
        for sample in stratified(low, 40)
        if sample.stratum == "near several factors"
    ]
    assert len(points) == 40
    near = [sum(abs(evaluate(factor, point)[0]) < 0.11 for factor in low.input_hypotheses) for point in points]
    assert min(near) >= 2


@pytest.mark.parametrize("name", ["projection.projection_matrix", "critical.determinant", "metric.normal_covariance"])
def test_samples_come_near_zeros_of_results(name, lowered):
    low = lowered(name)
    near = [sample.values for sample in stratified(low, 28) if sample.stratum == "near a zero of a result"]
    points = ({s: Fraction(values[s.name]) for s in low.kernel.symbols} for values in near)
    entries = [evaluate(low.kernel.derived, point) for point in points]
    least = [min(abs(float(entry)) for entry in row if entry) for row in entries]
    assert len(least) == 28
    assert min(least) < 1e-9
    assert max(least) < 0.2


def test_samples_are_repeatable(lowered):
    low = lowered("projection.project")
    assert stratified(low, 10) == stratified(low, 10)
    assert stratified(low, 10) != stratified(low, 10, seed=1)


def test_errors_are_counted_in_units_in_the_last_place(lowered):
    low = lowered("optics.scale")

    def next_float(f, x3):
        return np.nextafter(f / (f + x3), np.inf)

    found = measured(low, next_float, [Sample("one", {"f": 1.0, "x3": 1.0})])
    assert found.overall.max_ulp == 1.0


def test_a_package_in_a_folder_is_loaded_from_there_and_leaves_no_caches(tmp_path, repository, monkeypatch, lowered):
    monkeypatch.setattr("sys.dont_write_bytecode", False)
    source = repository / "generated" / "algebroproj"
    shutil.copytree(source, tmp_path / "algebroproj", ignore=shutil.ignore_patterns("__pycache__"))
    package = load_package(tmp_path)
    assert str(tmp_path) in package.__file__
    assert verify(lowered("optics.scale"), package, size=5).passed
    assert not list(tmp_path.rglob("__pycache__"))


def test_a_missing_package_or_function_is_named(tmp_path):
    with pytest.raises(NotShippedError, match=r"expected .*algebroproj"):
        load_package(tmp_path)
    with pytest.raises(NotShippedError, match=r"expected a function optics\.scale"):
        function_of(KERNELS["optics.scale"], SimpleNamespace(__name__="empty"))
