"""Labelled results: xarray datasets with units and provenance, in netCDF or Zarr files, without loss of digits.

A double-double number is two variables, ``name`` and ``name_lo``, whose sum it is; a number of any precision is decimal
text that reads back as the same number (its variable says with how many bits), and a fraction is the text ``p/q``.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from fractions import Fraction
from importlib.metadata import version
from pathlib import Path
from typing import Any, Literal

import h5netcdf
import mpmath
import numpy as np
import xarray
from numpy.typing import ArrayLike, NDArray

import algebroproj

ENGINE: Literal["h5netcdf"] = "h5netcdf"
LIBRARIES = ("algebroproj-sym", "numpy", "mpmath", "python-flint", "xarray")
ZARR = ".zarr"
DIMENSIONLESS = "1"


def variable(dimensions: Sequence[str], values: ArrayLike, units: str = DIMENSIONLESS, about: str = "") -> Any:
    """Return a variable with its units.

    Parameters
    ----------
    dimensions : sequence of str
        A name for each dimension of the values.
    values : array_like
        The values.
    units : str, optional
        As UDUNITS writes them; "1" if dimensionless.
    about : str, optional
        What it is, in a few words, for axes and tables.

    Examples
    --------
    >>> variable(["member"], [1.5, 2.5], "m", "distance").attrs
    {'units': 'm', 'long_name': 'distance'}
    """
    attributes = {"units": units} | ({"long_name": about} if about else {})
    return xarray.Variable(tuple(dimensions), np.asarray(values), attributes)


def pair(
    name: str,
    dimensions: Sequence[str],
    number: algebroproj.DoubleDouble,
    units: str = DIMENSIONLESS,
    about: str = "",
) -> dict[str, Any]:
    """Return the two variables of double-double numbers.

    Examples
    --------
    >>> third = algebroproj.DoubleDouble(np.array([1.0])) / 3.0
    >>> dataset = xarray.Dataset(pair("third", ["member"], third))
    >>> dataset.third.item(), dataset.third_lo.item()
    (0.3333333333333333, 1.850371707708594e-17)
    """
    low = np.zeros_like(number.hi) if number.lo is None else number.lo
    return {
        name: variable(dimensions, number.hi, units, about),
        f"{name}_lo": variable(dimensions, low, units, f"second part of {name}, to be added to it"),
    }


def text(
    dimensions: Sequence[str], values: ArrayLike, units: str = DIMENSIONLESS, about: str = "", bits: int = 53
) -> Any:
    """Return the variable of numbers of any precision: Fractions, mpmath numbers or floats.

    Parameters
    ----------
    dimensions, units, about
        As those of `variable`.
    values : array_like of object
        Fractions, integers or mpmath's real numbers.
    bits : int, optional
        The precision of mpmath's numbers.

    Examples
    --------
    >>> numbers(text(["member"], [Fraction(1, 3), Fraction(2)])).tolist()
    [Fraction(1, 3), Fraction(2, 1)]
    """
    cells = np.asarray(values, dtype=object)
    written = np.array([_written(value, bits) for value in cells.reshape(-1)], dtype=object).reshape(cells.shape)
    result = variable(dimensions, written, units, about)
    result.attrs["bits"] = bits
    return result


def numbers(written: Any) -> NDArray[np.object_]:
    """Return the numbers of a variable of `text`: Fractions where it has quotients, mpmath's numbers elsewhere."""
    cells = np.asarray(written.values, dtype=object)
    with mpmath.workprec(int(written.attrs["bits"])):
        read = [Fraction(cell) if "/" in cell else mpmath.mpf(cell) for cell in cells.reshape(-1)]
    result = np.empty(len(read), dtype=object)
    result[:] = read
    return result.reshape(cells.shape)


def _written(value: Any, bits: int) -> str:
    if isinstance(value, Fraction | int):
        return f"{Fraction(value).numerator}/{Fraction(value).denominator}"
    with mpmath.workprec(bits):
        digits = mpmath.libmp.repr_dps(bits)
        return str(mpmath.nstr(mpmath.mpf(value), digits, strip_zeros=True))


def provenance(source: Path) -> dict[str, str]:
    """Return what computes a study: the versions of the libraries, its source, and the commit if there is one.

    Parameters
    ----------
    source : Path
        The module of the study; the modules beside it, and in packages beside it, belong to the source.

    Examples
    --------
    >>> sorted(provenance(Path(__file__)))[:2]
    ['algebroproj-sym', 'backend']
    """
    versions = {library: version(library) for library in LIBRARIES}
    commit = _commit()
    here = {"backend": str(algebroproj.backend()), "source": _digest(source)}
    return versions | here | ({"commit": commit} if commit else {})


def _digest(source: Path) -> str:
    """Return a digest of the source of a study, of what runs it, and of the functions that it evaluates."""
    digest = hashlib.sha256()
    own = [source.parent] if source.is_file() else []
    for folder in (Path(__file__).parent, Path(algebroproj.__file__).parent, *own):
        for path in sorted([*folder.glob("*.py"), *folder.glob("*/*.py")]):
            digest.update(path.relative_to(folder).as_posix().encode() + path.read_bytes())
    return digest.hexdigest()


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


def _require_equal_units(found: Mapping[str, str], wanted: Mapping[str, str]) -> None:
    """Refuse a part that has other variables or other units than the first one."""
    if found.keys() != wanted.keys():
        raise ValueError(f"expected the variables {', '.join(wanted)}, got {', '.join(found)}")
    for name, unit in found.items():
        if unit != wanted[name]:
            raise ValueError(f"{name}: expected the unit {wanted[name]} as before, got {unit}")


def write(dataset: xarray.Dataset, path: Path) -> None:
    """Write a dataset to a netCDF file: whole, or not at all; its bytes depend on the dataset alone.

    Raises
    ------
    OSError
        If the file cannot be written.
    """
    temporary = _beside(path)
    dataset.to_netcdf(temporary, engine=ENGINE)
    temporary.replace(path)


def join(paths: Sequence[Path], dimension: str, attributes: Mapping[str, str], path: Path) -> None:
    """Write one dataset of several ones in netCDF files, one after the other along a dimension, whole or not at all.

    Only one of them is in memory at a time.

    Parameters
    ----------
    paths : sequence of Path
        Files of `write`.
    dimension : str
        Along which they follow each other; variables without it are taken from the first one.
    attributes : mapping of str to str
        Of the whole.
    path : Path
        The result: a Zarr folder if its name ends with ``.zarr``, else a netCDF file.

    Raises
    ------
    ValueError
        If one has other variables or units than the first.
    OSError
        If the result cannot be written.
    """
    temporary = _beside(path)
    joining = _join_zarr if path.suffix == ZARR else _join_netcdf
    joining(paths, dimension, attributes, temporary)
    temporary.replace(path)


def _join_netcdf(paths: Sequence[Path], dimension: str, attributes: Mapping[str, str], result: Path) -> None:
    lengths = [_length(path, dimension) for path in paths]
    ends = np.cumsum(lengths).tolist()
    with h5netcdf.File(paths[0], "r") as first, h5netcdf.File(result, "w") as file:
        file.dimensions = {name: len(each) for name, each in first.dimensions.items()} | {dimension: ends[-1]}
        file.attrs.update(attributes)
        for name, variable in first.variables.items():
            _declare(file, name, variable)
        for path, length, end in zip(paths, lengths, ends, strict=True):
            with h5netcdf.File(path, "r") as part:
                _require_equal_units(_units(part), _units(first))
                for name, variable in part.variables.items():
                    file.variables[name][_place(variable.dimensions, dimension, end - length, end)] = variable[...]


def _join_zarr(paths: Sequence[Path], dimension: str, attributes: Mapping[str, str], result: Path) -> None:
    with xarray.open_dataset(paths[0], engine=ENGINE) as first:
        _with_even_chunks(first, dimension).assign_attrs(attributes).to_zarr(result, mode="w", consolidated=False)
        for path in paths[1:]:
            with xarray.open_dataset(path, engine=ENGINE) as part:
                _require_equal_units(_units(part), _units(first))
                along = part.drop_vars([name for name, each in part.variables.items() if dimension not in each.dims])
                described = _with_texts_of_any_length(along).assign_attrs(attributes)
                described.to_zarr(result, append_dim=dimension, consolidated=False)


def read(path: Path) -> xarray.Dataset:
    """Open a dataset that `write` or `join` has written; its values are read when they are needed."""
    if path.suffix == ZARR:
        dataset: xarray.Dataset = xarray.open_zarr(path, consolidated=False, create_default_indexes=False)
        return dataset
    return xarray.open_dataset(path, engine=ENGINE, chunks={}, create_default_indexes=False)


def _length(path: Path, dimension: str) -> int:
    with h5netcdf.File(path, "r") as file:
        return len(file.dimensions[dimension])


def _units(dataset: Any) -> dict[str, str]:
    """Return the units of the variables of a dataset or of a file."""
    return {str(name): each.attrs.get("units", DIMENSIONLESS) for name, each in dataset.variables.items()}


def _declare(file: h5netcdf.File, name: str, variable: Any) -> None:
    """Make an empty variable in a file, with chunks as large as the given one."""
    attributes = {key: value for key, value in variable.attrs.items() if key != "_FillValue"}
    made = file.create_variable(
        name,
        variable.dimensions,
        variable.dtype,
        chunks=variable.shape if variable.shape and all(variable.shape) else None,
        fillvalue=variable.attrs.get("_FillValue"),
    )
    made.attrs.update(attributes)


def _place(dimensions: Sequence[str], dimension: str, start: int, stop: int) -> Any:
    """Return where the values of a part are in the whole."""
    return tuple(slice(start, stop) if each == dimension else slice(None) for each in dimensions) or Ellipsis


def _with_even_chunks(dataset: xarray.Dataset, dimension: str) -> xarray.Dataset:
    """Return a dataset whose chunks in a Zarr folder are those of the dataset."""
    plain = _with_texts_of_any_length(dataset)
    for variable in plain.variables.values():
        if dimension in variable.dims:
            variable.encoding["chunks"] = variable.shape
    return plain


def _with_texts_of_any_length(dataset: xarray.Dataset) -> xarray.Dataset:
    texts = {name: each.astype(object) for name, each in dataset.variables.items() if each.dtype.kind == "U"}
    return dataset.assign(texts).drop_encoding()


def _beside(path: Path) -> Path:
    """Return where a file is written before it is renamed; nothing is there."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.partial")
    if temporary.is_dir():
        shutil.rmtree(temporary)
    return temporary


def attributes(title: str, arguments: Mapping[str, Any], source: Path) -> dict[str, str]:
    """Return what a dataset says about itself: its title, the arguments of its sweep and its provenance."""
    return {
        "title": title,
        "arguments": json.dumps(arguments, sort_keys=True),
        "provenance": json.dumps(provenance(source), sort_keys=True),
    }
