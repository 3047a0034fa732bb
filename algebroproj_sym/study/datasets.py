"""Labelled results: xarray datasets with units and provenance, in netCDF or Zarr files, without loss of digits."""

import json
import os
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Any, Literal

import dask
import h5netcdf
import numpy as np
import xarray
from numpy.typing import ArrayLike

import algebroproj
from algebroproj_sym.study.declaration import MEMBER
from algebroproj_sym.study.sources import digest

ENGINE: Literal["h5netcdf"] = "h5netcdf"
LIBRARIES = ("algebroproj-sym", "numpy", "mpmath", "python-flint", "xarray")
ZARR = ".zarr"
DIMENSIONLESS = "1"


def variable(dimensions: Sequence[str], values: ArrayLike, units: str = DIMENSIONLESS, about: str = "") -> Any:
    """Return a variable with a name for each dimension, with units as UDUNITS writes them, and what it is about.

    Examples
    --------
    >>> variable(["member"], [1.5, 2.5], "m", "distance").attrs
    {'units': 'm', 'long_name': 'distance'}
    """
    attributes = {"units": units} | ({"long_name": about} if about else {})
    return xarray.Variable(tuple(dimensions), np.asarray(values), attributes)


def provenance(source: Path) -> dict[str, str]:
    """Return what the numbers of a study depend on: the versions of the libraries, and a digest of its sources.

    Examples
    --------
    >>> sorted(provenance(Path(__file__)))[:2]
    ['algebroproj-sym', 'backend']
    """
    versions = {library: version(library) for library in LIBRARIES}
    return versions | {"backend": str(algebroproj.backend()), "source": digest(source)}


def _commit() -> str | None:
    """Return the commit of the source tree that runs, marked if the tree differs from it; None for an installed one."""
    root = Path(__file__).parents[2]
    if not (root / ".git").exists():
        return None
    command = ["git", "-C", str(root), "describe", "--always", "--abbrev=40", "--dirty", "--exclude=*"]
    try:
        described = subprocess.run(command, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    return described.stdout.strip()


def write(dataset: xarray.Dataset, path: Path) -> None:
    """Write a dataset to a netCDF file: whole, or not at all; its bytes depend on the dataset alone.

    It raises `OSError` if the file cannot be written.
    """
    temporary = _beside(path)
    # HDF5 would end the process if it could not write: on a full disk Python raises an error.
    content = bytes(dataset.to_netcdf(engine=ENGINE))
    try:
        temporary.write_bytes(content)
    except OSError:
        temporary.unlink(missing_ok=True)
        raise
    temporary.replace(path)


def join(paths: Sequence[Path], dimension: str, attributes: Mapping[str, str], path: Path) -> None:
    """Write one dataset of several ones in netCDF files, one after the other along a dimension, whole or not at all.

    Only a few of them are in memory at a time.

    They are files of `write`; variables without the dimension are taken from the first one. A name that ends with
    ``.zarr`` makes a Zarr folder, another one a netCDF file.

    It raises `ValueError` if one has other variables or units than the first.  It raises `OSError` if the result cannot
    be written.
    """
    temporary = _beside(path)
    _require_room(temporary, sum(each.stat().st_size for each in paths))
    if path.suffix == ZARR:
        whole = path.with_suffix(".nc")
        join(paths, dimension, attributes, whole)
        with read(whole) as dataset, dask.config.set(scheduler="synchronous"):
            texts = [name for name, each in dataset.variables.items() if each.dtype.kind == "U"]
            whole_texts = dataset[texts].astype(object).load()
            dataset.assign(whole_texts).drop_encoding().to_zarr(temporary, mode="w", consolidated=False)
        whole.unlink()
    else:
        _join(paths, dimension, attributes, temporary)
    temporary.replace(path)


def _require_room(path: Path, size: int) -> None:
    """Raise `OSError` if a file cannot be so large: HDF5 would end the process when it meets the end of the disk."""
    try:
        with path.open("wb") as file:
            os.posix_fallocate(file.fileno(), 0, size + size // 10)
    finally:
        path.unlink(missing_ok=True)


def _join(paths: Sequence[Path], dimension: str, attributes: Mapping[str, str], result: Path) -> None:
    """Write one part after the other: the bytes of the file depend on the order."""
    with xarray.open_dataset(paths[0], engine=ENGINE) as first:
        chunks = {name: {"chunksizes": each.shape} for name, each in first.variables.items() if dimension in each.dims}
        plain = first.drop_encoding().assign_attrs(attributes)
        plain.to_netcdf(result, engine=ENGINE, unlimited_dims=[dimension], encoding=chunks)
    with h5netcdf.File(result, "r+") as whole:
        for path in paths[1:]:
            with h5netcdf.File(path, "r") as part:
                _require_equal_units(_units(part), _units(whole))
                start = len(whole.dimensions[dimension])
                stop = start + len(part.dimensions[dimension])
                whole.resize_dimension(dimension, stop)
                for name, values in part.variables.items():
                    if dimension in values.dimensions:
                        place = (slice(start, stop) if each == dimension else slice(None) for each in values.dimensions)
                        whole.variables[name][tuple(place)] = values[...]


def _units(file: h5netcdf.File) -> dict[str, str]:
    return {name: each.attrs.get("units", DIMENSIONLESS) for name, each in file.variables.items()}


def _require_equal_units(found: Mapping[str, str], wanted: Mapping[str, str]) -> None:
    """Refuse a part that has other variables or other units than the first one."""
    if found.keys() != wanted.keys():
        raise ValueError(f"expected the variables {', '.join(wanted)}, got {', '.join(found)}")
    for name, unit in found.items():
        if unit != wanted[name]:
            raise ValueError(f"{name}: expected the unit {wanted[name]} as before, got {unit}")


def read(path: Path) -> xarray.Dataset:
    """Open a dataset that `write` or `join` has written; its values are read when they are needed."""
    if path.suffix == ZARR:
        dataset: xarray.Dataset = xarray.open_zarr(path, consolidated=False, create_default_indexes=False)
        return dataset
    return xarray.open_dataset(path, engine=ENGINE, chunks={}, create_default_indexes=False)


def thinned(dataset: xarray.Dataset, most: int | None) -> tuple[xarray.Dataset, int]:
    """Return at most so many members of a dataset, evenly spaced, and how far apart they are.

    Examples
    --------
    >>> some, step = thinned(xarray.Dataset({"x": ("member", range(10))}), 4)
    >>> some.x.values.tolist(), step
    ([0, 3, 6, 9], 3)
    """
    step = 1 if most is None else max(1, -(-dataset.sizes[MEMBER] // most))
    return dataset.isel({MEMBER: slice(None, None, step)}), step


def _beside(path: Path) -> Path:
    """Return where a file is written before it is renamed; nothing is there."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.partial")
    if temporary.is_dir():
        shutil.rmtree(temporary)
    return temporary


def attributes(title: str, arguments: Mapping[str, Any], provenance: Mapping[str, str]) -> dict[str, str]:
    """Return what a dataset says about itself: its title, the arguments of its sweep, its provenance and the commit."""
    commit = _commit()
    made_by = {**provenance, **({"commit": commit} if commit else {})}
    return {
        "title": title,
        "arguments": json.dumps(arguments, sort_keys=True),
        "provenance": json.dumps(made_by, sort_keys=True),
    }
