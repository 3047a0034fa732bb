"""Every report explains its columns, and every variable, axis and term has a unit."""

import re

import numpy as np
import pytest
from click.testing import CliRunner

from algebroproj_derivations.studies.pairs.populating import pair
from algebroproj_sym.cli import main
from algebroproj_sym.study import datasets, discovery, figures

pytestmark = pytest.mark.whole

STUDIES = {study.name: study for study in discovery.studies()}
SMALL = {
    "near-critical": ["--members", "400"],
    "layouts": ["--members", "440"],
    "indicators": ["--members", "40"],
    "propagation": ["--members", "12", "--draws", "200"],
    "precision": ["--members", "4"],
    "normal-case": ["--members", "10"],
    "example": ["--members", "100"],
    "scene": ["--members", "10", "--file", "scene.toml"],
    "pair": ["--members", "3", "--file", "pair.csv", "--points", "X,Y,Z"],
}
TABLES = STUDIES.keys() - {"scene", "pair"}
UNIT = re.compile(r"\[[^\]]+\]")
WITHOUT = ("decimal digits", "stereo pairs per cell", "part of the stereo pairs", "relative error", "log10 ")
"""Beginnings of labels of axes whose numbers have no unit but these words."""
SCENE = """
[points]
unit = "m"
P1 = [-310.0, -295.5, 12.5]
P2 = [305.0, -290.0, 3.0]
P3 = [-300.0, 310.0, -8.0]
P4 = [298.0, 302.0, 20.0]
P5 = [10.0, -150.0, 35.0]
P6 = [-140.0, 20.0, -12.0]
P7 = [150.0, 40.0, 5.0]
P8 = [20.0, 200.0, 28.0]
Q1 = [0.0, 0.0, 60.0]
[centers]
unit = "m"
left = [-150.0, 0.0, 900.0]
right = [160.0, 8.0, 915.0]
"""


@pytest.fixture(scope="module", params=sorted(STUDIES))
def run(request, tmp_path_factory):
    """A study, its dataset, its report, and the figures as they were drawn."""
    folder, drawn = tmp_path_factory.mktemp(request.param), {}
    (folder / "scene.toml").write_text(SCENE)
    known = pair(5, "ordinary", count=12, sigma=0.5)
    objects = np.random.default_rng(1).normal(size=(12, 3))
    rows = np.hstack([known.x1, known.x2, objects])
    np.savetxt(folder / "pair.csv", rows, delimiter=",", header="x1,y1,x2,y2,X,Y,Z", comments="", fmt="%.3f")

    def save(drawings, place):
        drawn.update(drawings)
        return []

    with pytest.MonkeyPatch.context() as patched:
        patched.chdir(folder)
        patched.setattr(figures, "save", save)
        result = CliRunner().invoke(main, ["study", request.param, *SMALL[request.param], "--out", "out"])
    assert result.exit_code == 0, result.output
    with datasets.read(folder / "out" / f"{request.param}.nc") as dataset:
        yield STUDIES[request.param], dataset, (folder / "out" / "report.txt").read_text(), drawn


def test_every_variable_says_what_it_is_and_has_a_unit(run):
    _, dataset, _, _ = run
    for name, values in dataset.variables.items():
        assert values.attrs.get("units"), name
        assert values.attrs.get("long_name"), name


def test_every_term_has_a_unit_and_is_below_the_report(run):
    study, _, text, _ = run
    assert study.terms
    body, _, legend = text.rpartition("\n\n")
    for term, meaning in study.terms.items():
        assert UNIT.search(meaning), term
        assert re.search(rf"^  {re.escape(term)}  +{re.escape(meaning)}$", legend, re.MULTILINE), term
        example = term.startswith("(")
        assert example or all(word.lower() in body.lower() for word in term.split(", ")), term


def cells(line):
    return re.split(r" {2,}", line.strip())


def is_row(line):
    def number(cell):
        try:
            return bool(float(cell)) or True
        except ValueError:
            return False

    return sum(map(number, cells(line))) >= 3


def headers(text):
    """Return the lines above tables, whose parts may have titles."""
    lines, found = text.splitlines(), []
    for k in range(1, len(lines)):
        if is_row(lines[k]) and not is_row(lines[k - 1]):
            above = next(line for line in reversed(lines[:k]) if len(cells(line)) > 1)
            found += [] if is_row(above) else [above]
    return found


def test_every_column_is_a_term(run):
    study, _, text, _ = run
    found = headers(text.rpartition("\n\n")[0])
    assert bool(found) == (study.name in TABLES)
    for line in found:
        assert set(cells(line)) <= study.terms.keys(), line


def test_every_axis_of_every_figure_says_what_it_is_and_in_which_unit(run):
    _, _, _, drawn = run
    assert drawn
    for name, drawing in drawn.items():
        assert drawing.axes, name
        for axes in filter(lambda each: each.axison, drawing.axes):
            for axis in ("x", "y", "z")[: 3 if hasattr(axes, "get_zlabel") else 2]:
                label = said(drawing, axes, axis)
                assert label is None or UNIT.search(label) or label.startswith(WITHOUT), (name, axis, label)


def said(drawing, axes, axis):
    """Return what is written to an axis, or to that of all panels or of the last one; None if it counts nothing."""
    label = getattr(axes, f"get_{axis}label")()
    common = getattr(drawing, f"_sup{axis}label", None)
    shared = getattr(axes, f"get_shared_{axis}_axes")().get_siblings(axes) if axis != "z" else []
    others = [getattr(each, f"get_{axis}label")() for each in shared]
    ticks = getattr(axes, f"get_{axis}ticklabels")()
    words = [tick for tick in ticks if re.search("[a-z]{3}", tick.get_text()) and "math" not in tick.get_text()]
    if words or (axes.get_label() == "<colorbar>" and not label):
        return None
    return label or (common.get_text() if common else "") or next(filter(None, others), "")


def test_a_column_without_explanation_is_found():
    table = "Some pairs.\n  thing        slope  new\n  one  1.0  2.0  3.0\n"
    assert headers(table) == ["  thing        slope  new"]
    assert not set(cells(headers(table)[0])) <= {"thing": "", "slope": ""}.keys()
