"""Studies are found: the installed ones, and those of a file or a folder, which run as the installed ones do."""

import shutil
import sys
from itertools import count
from pathlib import Path

import pytest
from click.testing import CliRunner

from algebroproj_sym.cli import main
from algebroproj_sym.declaring import installed_papers
from algebroproj_sym.study.datasets import read
from algebroproj_sym.study.discovery import studies
from algebroproj_sym.study.sources import digest

MODULE = """
import xarray
from algebroproj_sym.study import MEMBER, Option, Study
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.sampling import uniform


def chunk(indices, seed, *, scale):
    areas = variable([MEMBER], (scale * uniform(seed, indices)) ** 2, "m2", "area")
    return xarray.Dataset({"area": areas}, coords={MEMBER: indices})


STUDY = Study(
    "areas", "Areas of squares", (Option("scale", float, 1.0, "Largest side [m]."),), 50, chunk,
    lambda dataset: f"{dataset.sizes[MEMBER]} areas\\n", lambda dataset: {},
)
"""
NAMES = count()


@pytest.fixture
def own(tmp_path, monkeypatch):
    """A folder with a study and a module that has none; no two tests give the study the same module name."""
    monkeypatch.setattr(sys, "path", [*sys.path])
    folder = tmp_path / "own"
    folder.mkdir()
    (folder / "notes.py").write_text("raise SystemExit('not a study, and not imported')\n")
    module = folder / f"own_areas_{next(NAMES)}.py"
    module.write_text(MODULE)
    yield module
    sys.modules.pop(module.stem, None)


def invoke(*arguments):
    return CliRunner().invoke(main, ["study", *map(str, arguments)])


def test_the_installed_studies_are_found_and_are_no_paper():
    names = [study.name for study in studies()]
    expected = {"near-critical", "indicators", "layouts", "propagation", "precision", "normal-case", "example", "scene"}
    expected |= {"pair"}
    assert len(names) == len(expected)
    assert set(names) == expected
    assert "studies" not in installed_papers()


@pytest.mark.parametrize("jobs", [1, pytest.param(2, marks=pytest.mark.whole)])
def test_a_study_of_ones_own_runs_as_an_installed_one_does(own, tmp_path, jobs):
    arguments = ("--scale", 3.0, "--members", 40, "--chunk", 15, "--jobs", jobs)
    in_file = invoke(own, *arguments, "--out", tmp_path / "a")
    in_folder = invoke(own.parent, "areas", *arguments, "--out", tmp_path / "b")
    assert in_file.exit_code == in_folder.exit_code == 0, in_file.output + in_folder.output
    assert in_file.stdout.startswith("40 areas\n")
    assert (tmp_path / "a" / "areas.nc").read_bytes() == (tmp_path / "b" / "areas.nc").read_bytes()
    with read(tmp_path / "a" / "areas.nc") as dataset:
        assert dataset.sizes["member"] == 40
        assert 1 < dataset.area.values.max() <= 9


def test_a_changed_study_is_not_taken_for_the_one_that_a_folder_holds(own, tmp_path):
    assert invoke(own, "--out", tmp_path / "out").exit_code == 0
    shutil.rmtree(own.parent / "__pycache__", ignore_errors=True)
    own.write_text(MODULE.replace("** 2", "** 3"))
    refused = invoke(own, "--out", tmp_path / "out")
    assert refused.exit_code == 2
    assert "provenance.source" in refused.stderr


LOSING = """
import os

def losing(indices, seed, *, scale):
    if indices[0] >= 20 and os.path.exists({flag!r}):
        os._exit(1)
    return chunk(indices, seed, scale=scale)

STUDY = replace(STUDY, chunk=losing)
"""


def test_lost_workers_end_with_a_message_and_a_folder_that_goes_on(own, tmp_path):
    flag = tmp_path / "lose"
    flag.touch()
    own.write_text("from dataclasses import replace\n" + MODULE + LOSING.format(flag=str(flag)))
    arguments = (own, "--members", 40, "--chunk", 5)
    lost = invoke(*arguments, "--jobs", 2, "--out", tmp_path / "out")
    assert lost.exit_code == 1
    assert "Traceback" not in lost.output
    assert f"the workers were lost. Finished parts are kept in {tmp_path / 'out'}" in lost.stderr
    kept = {path.name for path in (tmp_path / "out" / "chunks").glob("0*.nc")}
    assert kept <= {f"{chunk:08d}.nc" for chunk in range(4)}
    flag.unlink()
    for folder in ("out", "undisturbed"):
        resumed = invoke(*arguments, "--out", tmp_path / folder)
        assert resumed.exit_code == 0, resumed.output
        assert resumed.stdout.startswith("40 areas\n")
    assert (tmp_path / "out" / "areas.nc").read_bytes() == (tmp_path / "undisturbed" / "areas.nc").read_bytes()


def test_what_a_study_does_not_import_may_change(own, tmp_path):
    own.write_text(MODULE.replace("import xarray\n", "import xarray\nimport factors\n"))
    factors = own.with_name("factors.py")
    factors.write_text("TWO = 2\n")
    beside = own.with_name("other.py")
    before = digest(own)
    beside.write_text("ONE = 1\n")
    (own.parent / "notes.py").write_text("# changed\n")
    assert digest(own) == before
    factors.write_text("TWO = 3\n")
    changed = digest(own)
    assert changed != before
    own.with_suffix(".toml").write_text("data = 1\n")
    assert digest(own) not in (before, changed)


@pytest.mark.whole
def test_each_installed_study_depends_on_its_own_sources(monkeypatch):
    installed = {study.name: study.source for study in studies()}
    before = {name: digest(source) for name, source in installed.items()}
    assert len(set(before.values())) == len(installed)
    read_bytes = Path.read_bytes

    def changed(path):
        return read_bytes(path) + (b"# changed" if path.match("studies/stereo/quadric.py") else b"")

    monkeypatch.setattr(Path, "read_bytes", changed)
    assert {name for name, source in installed.items() if digest(source) == before[name]} == {"example"}


def test_the_studies_of_a_folder_are_listed(own):
    assert "areas  Areas of squares" in invoke(own.parent, "--help").stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["notes.py"], "expected a module that makes a Study named STUDY, got"),
        (["", "volumes"], "No such command 'volumes'"),
        (["missing.py"], "No such command"),
    ],
)
def test_what_is_no_study_is_wrong_usage(own, arguments, message):
    path, *rest = arguments
    result = invoke(own.parent / path, *rest)
    assert result.exit_code == 2
    assert message in result.stderr


def test_a_study_that_cannot_be_imported_is_an_error_that_names_it(own):
    own.write_text("import nothing_of_this_name\n" + MODULE)
    result = invoke(own)
    assert result.exit_code == 1
    assert f"{own}: cannot be imported: ModuleNotFoundError" in result.stderr


def test_a_study_with_the_name_of_another_module_is_an_error(own):
    named = own.with_name("secrets.py")
    named.write_text(MODULE)
    import secrets  # noqa: F401

    result = invoke(named)
    assert result.exit_code == 1
    assert "another module secrets is at" in result.stderr
