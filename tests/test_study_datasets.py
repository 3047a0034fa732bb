"""Datasets: no digit is lost, and every variable has its unit."""

from pathlib import Path

import numpy as np
import pytest
import xarray
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_derivations.studies.stereo.distributions import joint
from algebroproj_sym.study import datasets
from algebroproj_sym.study.datasets import provenance, read, thinned, variable, write


def through_a_file(dataset, folder):
    write(dataset, folder / "values.nc")
    with read(folder / "values.nc") as found:
        return found.load()


@given(st.lists(st.floats(), min_size=1, max_size=6))
def test_files_lose_nothing(tmp_path_factory, values):
    dataset = xarray.Dataset({"x": variable(["member"], values, "m", "length")})
    found = through_a_file(dataset, tmp_path_factory.mktemp("file"))
    assert found.x.values.tobytes() == np.array(values).tobytes()
    assert found.x.attrs == {"units": "m", "long_name": "length"}


def test_a_file_that_cannot_be_written_leaves_the_old_one(tmp_path):
    path = tmp_path / "values.nc"
    write(xarray.Dataset({"x": variable(["member"], [1.0])}), path)
    before = path.read_bytes()
    with pytest.raises((TypeError, ValueError)):
        write(xarray.Dataset({"x": variable(["member"], [object()])}), path)
    assert path.read_bytes() == before
    with pytest.raises(OSError, match="nowhere"):
        write(xarray.Dataset(), tmp_path / "nowhere" / "values.nc")


def test_the_provenance_is_the_same_twice():
    assert provenance(Path(__file__)) == provenance(Path(__file__))
    assert len(provenance(Path(__file__))["source"]) == 64


def test_a_package_that_only_lies_in_the_folder_of_a_repository_has_no_commit(repository, monkeypatch):
    monkeypatch.setattr(datasets, "__file__", str(repository / "docs" / "package" / "study" / "datasets.py"))
    assert datasets._commit() is None


def test_quantiles_and_lines_of_counts_are_those_of_the_values():
    rng = np.random.default_rng(3)
    x = rng.uniform(0, 4, 40_000)
    y = 2 * x + rng.normal(0, 0.5, x.shape)
    dataset = xarray.Dataset({"x": ("member", x), "y": ("member", y)}).chunk(member=7_000)
    counted = joint(dataset, "x", "y", np.linspace(0, 4, 81), np.linspace(-4, 12, 1601))
    slope, intercept, scatter = counted.line(0.5, 3.5)
    inside = (x > 0.5) & (x < 3.5)
    expected = np.polyfit(x[inside], y[inside], 1)
    rest = y[inside] - np.polyval(expected, x[inside])
    assert np.allclose([slope, intercept, scatter], [*expected, rest.std()], atol=0.01)
    middle = (x >= 2) & (x < 2.05)
    assert np.allclose(counted.quantiles([0.25, 0.5])[:, 40], np.quantile(y[middle], [0.25, 0.5]), atol=0.03)
    assert counted.outside == 0


@given(members=st.integers(1, 60), most=st.integers(1, 70))
def test_a_thinned_dataset_has_no_more_members_than_wanted_and_as_many_as_can_be(members, most):
    some, step = thinned(xarray.Dataset({"x": ("member", np.arange(members))}), most)
    assert some.x.values.tolist() == list(range(0, members, step))
    assert some.sizes["member"] <= most
    assert step == 1 or len(range(0, members, step - 1)) > most
