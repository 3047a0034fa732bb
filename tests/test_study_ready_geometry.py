"""The studies near-critical, layouts and example: what they measure is so."""

import json
from decimal import Decimal

import mpmath
import numpy as np
import pytest
import sympy
from click.testing import CliRunner
from matplotlib.figure import Figure

from algebroproj_derivations.fundamentals1996 import s4_a_coordinates as printed
from algebroproj_derivations.studies import example as example_study
from algebroproj_derivations.studies import near_critical
from algebroproj_derivations.studies.stereo.aerial import aerial
from algebroproj_derivations.studies.stereo.quadric import conditions, critical_quadric, exact, value
from algebroproj_derivations.studies.stereo.scenes import Scene, images, pictures
from algebroproj_sym.cli import main
from algebroproj_sym.study import MEMBER
from algebroproj_sym.study.discovery import studies

BY_NAME = {study.name: study for study in studies()}
OWN = ("near-critical", "layouts", "example")
MEMBERS = {"near-critical": 600, "layouts": 1100, "example": 400}


@pytest.fixture(scope="module")
def datasets():
    return {name: BY_NAME[name].chunk(np.arange(MEMBERS[name]), 1, **BY_NAME[name].arguments({})) for name in OWN}


@pytest.mark.parametrize("name", OWN)
def test_a_member_does_not_depend_on_its_chunk(datasets, name):
    study, whole = BY_NAME[name], datasets[name]
    part = study.chunk(np.arange(17, 29), 1, **study.arguments({}))
    for variable in whole.data_vars:
        expected = whole[variable].isel({MEMBER: slice(17, 29)}) if MEMBER in whole[variable].dims else whole[variable]
        if whole[variable].dtype.kind == "f":
            assert np.allclose(part[variable], expected, rtol=1e-6, atol=1e-9, equal_nan=True), variable
        else:
            assert np.array_equal(part[variable], expected), variable


@pytest.mark.parametrize("name", OWN)
def test_a_study_reports_and_draws(datasets, name):
    text = BY_NAME[name].report(datasets[name])
    assert text.endswith("\n")
    assert "nan" not in text or name == "near-critical"
    figures = BY_NAME[name].figures(datasets[name])
    assert figures
    assert all(isinstance(each, Figure) for each in figures.values())
    assert all(each.attrs["units"] for each in datasets[name].data_vars.values())


def test_distance_is_that_from_the_exact_quadric():
    indices = np.arange(12)
    arguments = BY_NAME["near-critical"].arguments({"digits": 8.0})
    found = near_critical.chunk(indices, 3, **arguments)
    scenes = aerial(3, indices, **{name: arguments[name] for name in ("base", "height", "relief", "tilt")})
    distances = found.intended.values
    points = near_critical._near_quadric(scenes, distances)
    for member in indices:
        form = critical_quadric(points[member, :7], scenes.centers[member])
        with mpmath.workdps(60):
            x = [mpmath.mpf(1), *map(mpmath.mpf, points[member, 7])]
            q = mpmath.matrix([[mpmath.mpf(int(cell)) for cell in row] for row in form])
            gradient = 2 * (q * mpmath.matrix(x))
            size = (mpmath.matrix([x]) * q * mpmath.matrix(x))[0]
            distance = abs(size) / mpmath.sqrt(sum(gradient[k] ** 2 for k in (1, 2, 3)))
        assert float(distance) == pytest.approx(float(found.distance[member]), rel=1e-6)


def test_digits_lost_are_those_of_exact_images_solved_with_fifty_digits():
    indices = np.arange(5)
    arguments = BY_NAME["near-critical"].arguments({"digits": 6.0})
    found = near_critical.chunk(indices, 5, **arguments)
    scenes = aerial(5, indices, **{name: arguments[name] for name in ("base", "height", "relief", "tilt")})
    points = near_critical._near_quadric(scenes, found.intended.values)
    for member in indices:
        parts = (exact(part) for part in (points[member], scenes.centers[member], scenes.planes[member]))
        u = images(Scene(*parts))
        rounded = exact(u.astype(float))
        with mpmath.workdps(50):
            true, changed = correlation_by_hand(u), correlation_by_hand(rounded)
            size = mpmath.norm(true) * mpmath.norm(changed)
            cosine = sum(a * b for a, b in zip(true, changed, strict=True)) / size
            lost = mpmath.log10(mpmath.sqrt(1 - cosine**2) * 2**53)
        assert float(lost) == pytest.approx(float(found.lost_images[member]), abs=1e-3)


def correlation_by_hand(u):
    """The nine elements from the eight homogeneous equations, the first one of the second row being 1."""
    rows = [[a * b for a in (1, *left) for b in (1, *right)] for left, right in zip(*u.tolist(), strict=True)]
    numbers = [[mpmath.mpf(cell.numerator) / cell.denominator for cell in row] for row in rows]
    others = [k for k in range(9) if k != 3]
    solved = mpmath.lu_solve(
        mpmath.matrix([[row[k] for k in others] for row in numbers]), mpmath.matrix([-row[3] for row in numbers])
    )
    return [*solved[:3], mpmath.mpf(1), *solved[3:]]


def test_slope_one_as_the_factor_of_the_determinant_says(datasets):
    joint = near_critical.counted(datasets["near-critical"])
    slope, _, scatter = joint["lost_images"].line(*near_critical.FITTED)
    assert slope == pytest.approx(-1, abs=0.05)
    assert scatter < 0.9


def test_layouts_lose_digits_where_they_are_critical_and_there_alone(datasets):
    text = BY_NAME["layouts"].report(datasets["layouts"])
    rows = [
        line for line in text.splitlines() if any(v in line for v in (" critical ", " regular ", " normalisation "))
    ]
    assert len(rows) == 11
    for row in rows:
        words = row.split("critical")[-1].split("regular")[-1].split("normalisation")[-1].split()
        slopes, lost = list(map(float, words[:2])), list(map(float, words[2:4]))
        if " critical " in row:
            assert slopes == [1.0, 1.0]
            assert min(lost) >= 5
        else:
            assert slopes[1] == 0.0
            assert max(lost) <= 3


def test_the_data_of_the_example_are_the_printed_ones():
    example = example_study.example()
    for name, point in zip(example.names, example.scene.points, strict=True):
        assert [Decimal(cell) for cell in printed.CARTESIAN[name]] == [Decimal(repr(float(x))) for x in point]
    for side, name in enumerate(("O1", "O2")):
        assert example.scene.centers[side].tolist() == [float(cell) for cell in printed.CARTESIAN[name]]
    assert example.names[:4] == printed.BASIC
    axes = [[float(cell) for cell in matrix[2]] for matrix in (printed.R_LEFT, printed.R_RIGHT)]
    assert example.scene.planes.tolist() == axes


def test_the_unrounded_results_of_the_example_are_the_printed_ones(datasets):
    found = datasets["example"]
    z = [[0, -0.97340074, -0.13114018], [1, -0.02659926, 0.07973035], [0.13112327, -0.08096187, 0.00001691]]
    assert np.abs(found.Z_true.values - z).max() < 2e-8
    epipoles = [[1.64746, -12.56421], [1.61706, -12.00280]]
    assert np.abs(found.epipole_true.values - epipoles).max() < 1e-4
    centers = [[-1.0679613, -0.2268166, 4.1115155], [-0.9762202, 0.7543148, 3.2860293]]
    assert np.abs(found.center_true.values - centers).max() < 2e-6


def test_the_spread_of_the_example_is_that_of_linear_propagation(datasets):
    """Uniform changes of the images, propagated to first order by differences."""
    from algebroproj import correlation

    u = images(example_study.example().scene)[:, 3:8]
    gradient = []
    for place in np.ndindex(u.shape):
        step = np.zeros(u.shape)
        step[place] = 1e-6
        plus, minus = (correlation.correlation_matrix(*(u + sign * step)) for sign in (1, -1))
        gradient.append((plus - minus) / 2e-6)
    expected = 1e-7 / np.sqrt(12) * np.sqrt(np.sum(np.square(gradient), axis=0))
    found = example_study.spread(datasets["example"], "Z")
    assert found.lost == 0
    assert np.allclose(found.deviation, expected, rtol=0.15, atol=1e-12)


def test_a_singular_member_is_reported_in_its_place():
    """One scene with two points in one place: its equations are singular, those of the others are not."""
    scene = aerial(1, range(5))
    scene.points[2, 7] = scene.points[2, 6]
    with np.errstate(all="ignore"):
        found = near_critical._members(scene)
    whole = np.isfinite(found["lost_total"])
    lost = found["lost_total"]
    assert whole[[0, 1, 3, 4]].all()
    assert lost[[0, 1, 3, 4]].max() < 5
    assert not whole[2] or lost[2] > 14


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["example", "--axis-y3", "0"], "axis point: expected one off the plane y3 = 0"),
        (["example", "--axis-y1", "1", "--axis-y2", "-1", "--axis-y3", "1"], "off the plane y1 + y2 + y3 = 1"),
        (["example", "--axis-y1", "nan"], "axis point: expected finite coordinates"),
        (["example", "--decimals", "0"], "decimals: expected at least 1 and at most 12, got 0"),
        (["layouts", "--digits", "13"], "digits: expected at least 1 and at most 12, got 13.0"),
    ],
)
def test_bad_options_are_refused_before_work_begins(tmp_path, arguments, message):
    result = CliRunner().invoke(main, ["study", *arguments, "--out", str(tmp_path / "new")])
    assert result.exit_code == 2
    assert message in result.stderr
    assert not (tmp_path / "new").exists()


def test_the_command_writes_dataset_figures_and_report(tmp_path):
    result = CliRunner().invoke(
        main, ["study", "example", "--members", "200", "--chunk", "100", "--out", str(tmp_path)]
    )
    assert result.exit_code == 0
    names = {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*") if path.is_file()}
    assert names == {
        ".lock",
        "example.nc",
        "example.nc.seal",
        "manifest.json",
        "report.txt",
        "figures/error-ellipses.png",
        "figures/error-ellipses.pdf",
        "figures/error-ellipsoids.png",
        "figures/error-ellipsoids.pdf",
    }
    assert (tmp_path / "report.txt").read_text() in result.stdout.replace("written to", "\nwritten to") + "\n"
    assert json.loads((tmp_path / "manifest.json").read_text())["arguments"]["options"]["decimals"] == 7


def test_conditions_count_ten_for_what_is_not_critical():
    scene = aerial(2, [0])
    assert conditions(np.concatenate([scene.points[0], scene.centers[0]])) == 10
    single = scene[0]
    form = critical_quadric(single.points[:7], single.centers)
    assert all(number == 0 for number in value(form, np.vectorize(sympy.Rational)(single.points[:7])))
    assert np.isfinite(pictures(single)).all()
