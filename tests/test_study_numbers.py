"""The ready studies of numbers: members are functions of seed and index, and the reports say what must be true."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from algebroproj_derivations.studies import indicators, normal_case, precision, propagation
from algebroproj_derivations.studies.stereo.chain import Images, images
from algebroproj_derivations.studies.stereo.configurations import ordinary
from algebroproj_sym.study import sweeping
from algebroproj_sym.study.arithmetics import float64

SMALL = {indicators: {}, propagation: {"draws": 1000}, precision: {"timed": False}, normal_case: {}}
MEMBERS = {indicators: 600, propagation: 25, precision: 24, normal_case: 40}


def computed(module, indices, **options):
    study = module.STUDY
    return study.chunk(np.asarray(indices), 3, **study.arguments(SMALL[module] | options))


@pytest.fixture(scope="module", params=SMALL, ids=lambda module: module.STUDY.name)
def study(request):
    module = request.param
    return module, computed(module, np.arange(MEMBERS[module]))


def test_members_do_not_depend_on_their_chunk(study):
    module, dataset = study
    some = np.array([5, 2, 7])
    again = computed(module, some)
    for name, values in again.items():
        if "member" in values.dims:
            np.testing.assert_allclose(values, dataset[name].isel(member=some), rtol=1e-6, err_msg=name)


def test_every_variable_has_units_and_says_what_it_is(study):
    _, dataset = study
    assert dataset.sizes["member"] == len(dataset.member)
    for name, values in dataset.data_vars.items():
        assert values.attrs["units"], name
        assert values.attrs["long_name"], name


def test_reports_and_figures_are_made_of_a_swept_dataset(study, tmp_path):
    """Its values are read when they are needed, and it is the same dataset."""
    module, dataset = study
    members = MEMBERS[module]
    options = module.STUDY.arguments(SMALL[module])
    sweep = sweeping.Sweep(module.STUDY, tmp_path / "sweep", options, members, members // 2 + 1, 3)
    sweeping.prepare(sweep)
    assert len(list(sweeping.run(sweep))) == 2
    swept = sweeping.assemble(sweep)
    for name, values in dataset.items():
        np.testing.assert_allclose(swept[name], values, rtol=1e-6, err_msg=name)
    assert len(module.STUDY.report(swept).splitlines()) > 3
    drawn = module.STUDY.figures(swept)
    assert drawn
    assert all(isinstance(figure, Figure) and figure.axes for figure in drawn.values())


def test_times_are_in_the_report_if_they_are_measured():
    dataset = computed(precision, np.arange(4), timed=True)
    assert (dataset.time > 0).all()
    assert dataset.time.attrs["units"] == "s"
    timed, untimed = (precision.STUDY.report(each) for each in (dataset, dataset.drop_vars("time")))
    assert timed != untimed


@pytest.fixture(scope="module")
def nearness():
    return computed(indicators, np.arange(1500))


@pytest.mark.parametrize("output", ["z", "epipole"])
def test_the_mean_condition_number_predicts_lost_digits_with_slope_one(nearness, output):
    fit = indicators.fits(nearness, output)[f"{output}_mean"]
    assert fit["slope"] == pytest.approx(1, abs=0.03)
    assert fit["scatter"] < 0.3


def test_one_rounding_scatters_as_the_logarithm_of_a_normal_variable(nearness):
    """No indicator can do better: near criticality the error is one random number times a known one."""
    spread = indicators.fits(nearness, "z", "single")["z_mean"]["scatter"]
    assert spread == pytest.approx(np.pi / np.sqrt(8) / np.log(10), abs=0.08)


@pytest.mark.parametrize("output", ["z", "epipole"])
def test_no_error_is_larger_than_its_guaranteed_bound(nearness, output):
    bound = nearness[f"{output}_bound"].values
    largest = nearness[f"{output}_largest"].values
    usable = np.isfinite(bound) & (bound < 2.0**53)
    assert usable.mean() > 0.95
    assert (largest[usable] <= bound[usable]).all()


def test_the_bound_of_z_is_within_a_decade_for_most(nearness):
    assert (nearness.z_bound <= 10 * nearness.z_largest).mean() > 0.85


@pytest.fixture(scope="module")
def propagated():
    return computed(propagation, np.arange(60), draws=4000, smallest=1e-6, largest=1e-3)


def test_linear_propagation_of_z_fails_as_a_quotient_does(propagated):
    """With one divisor 1 + nu e the ends of the interval are off by about nu, its width by the square."""
    nu, ends, width = (propagated[name].values for name in ("nu", "z_ends", "z_width"))
    some = (nu > 0.03) & (nu < 0.3)
    assert some.sum() > 5
    assert 0.5 < np.median(ends[some] / nu[some]) < 2
    assert np.median(abs(width[some])) < 0.5 * np.median(ends[some])
    few = nu < 3e-3
    assert few.sum() > 5
    assert np.median(ends[few]) < 2e-2


def test_random_samples_are_sure_enough(propagated):
    assert (propagated.z_sure.values[propagated.nu < 0.1] < 0.1).all()


def test_propagation_refuses_options_without_sense():
    with pytest.raises(ValueError, match="draws: expected at least 100, got 5"):
        propagation.STUDY.arguments({"draws": 5})
    with pytest.raises(ValueError, match="smallest: expected 0 < smallest <= largest"):
        propagation.STUDY.arguments({"smallest": 1.0})


def test_every_arithmetic_is_as_accurate_as_its_digits_say():
    dataset = computed(precision, np.arange(24))
    digits = np.array([arithmetic.digits for arithmetic in precision.ARITHMETICS])
    ordinary = ~dataset.near.values
    for output in ("z", "epipole", "model"):
        lost = np.log10(dataset[f"{output}_error"].values) + digits
        assert (np.median(lost[ordinary], axis=0) < 7).all(), output
        assert (np.median(lost[~ordinary], axis=0) > np.median(lost[ordinary], axis=0)).all(), output


def test_every_bound_of_every_arithmetic_holds():
    dataset = computed(precision, np.arange(24))
    for output in ("z", "epipole", "model"):
        bound = dataset[f"{output}_bound"].values
        finite = np.isfinite(bound)
        assert (dataset[f"{output}_error"].values[finite] <= bound[finite]).all(), output
    enclosing = [arithmetic.encloses for arithmetic in precision.ARITHMETICS]
    assert np.isfinite(dataset.z_bound).any(dim="member").values.tolist() == enclosing


@pytest.fixture(scope="module")
def normal_cases():
    return computed(normal_case, np.arange(60))


def test_the_axis_point_does_not_change_what_noise_does(normal_cases):
    """Another axis point transforms the model projectively; the residuals of its images stay what they are."""
    axes = normal_cases.noise.values[:, normal_cases.choice.values == "y_a"]
    for way in (0, 1):
        relative = axes[..., way] / axes[:, :1, way] - 1
        assert np.nanmedian(abs(relative)) < 1e-6


def test_the_object_is_found_again_on_every_way(normal_cases):
    lost = normal_cases.lost.values
    assert np.isfinite(lost).all()
    assert (np.median(lost, axis=(0, 1)) < 5).all()


@pytest.mark.parametrize("way", normal_case.WAYS)
def test_the_noise_of_a_way_is_that_of_moved_images(way):
    dataset = computed(normal_case, [3])
    scene = ordinary([3], 3, normal_case.FURTHER)
    y = scene.points[:, 4:]
    both = images(float64(), scene)
    y_a, u_n31, step = dataset.y_a.values[:, 0], dataset.u_n31.values[:, 0], 1e-7
    base = normal_case._object(float64(), both, way, y, y_a, u_n31)[0]
    squares = 0.0
    for side in (0, 1):
        for place in np.ndindex(both[side].shape[2:]):
            moved = [u.copy() for u in both]
            moved[side][(0, 0, *place)] += step
            found = normal_case._object(float64(), Images(*moved), way, y, y_a, u_n31)[0]
            squares += (((found - base) / step)[0, normal_case.CONTROL] ** 2).sum(axis=-1)
    noise = float(dataset.noise.sel(way=way)[0, 0])
    assert np.sqrt(np.mean(squares)) == pytest.approx(noise, rel=1e-3)


def test_the_other_studies_refuse_options_without_sense():
    with pytest.raises(ValueError, match="choices: expected at least 2, got 1"):
        normal_case.STUDY.arguments({"choices": 1})
    with pytest.raises(ValueError, match="range: expected a positive number, got 0"):
        normal_case.STUDY.arguments({"range": 0.0})
    with pytest.raises(ValueError, match="nearest: expected 0 < nearest"):
        precision.STUDY.arguments({"nearest": 1.0})


def test_indicators_refuse_options_without_sense():
    with pytest.raises(ValueError, match="replicas: expected at least 1, got 0"):
        indicators.STUDY.arguments({"replicas": 0})
    with pytest.raises(ValueError, match=r"nearest: expected 0 < nearest <= farthest, got 1\.0 and"):
        indicators.STUDY.arguments({"nearest": 1.0})
