"""The functions that are shipped: loaded from the installed package, or from a folder that was just generated."""

import importlib
import importlib.util
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from algebroproj_sym.declaring import Argument, Kernel
from algebroproj_sym.generating.writing import PACKAGE
from algebroproj_sym.proving import seed_of

Function = Callable[..., Any]


class NotShippedError(LookupError):
    """A kernel has no generated function in the package."""


def load_package(folder: Path | None = None, package_name: str = PACKAGE) -> ModuleType:
    """Import the generated package.

    Without a folder that contains it, the installed one is imported.

    It raises `NotShippedError` if there is no such package.
    """
    if folder is None:
        try:
            return importlib.import_module(package_name)
        except ModuleNotFoundError as error:
            raise NotShippedError(f"package: expected {package_name} to be installed, it is not") from error
    location = folder / package_name / "__init__.py"
    name = f"_{package_name}_at_{seed_of(location.resolve())}"
    spec = importlib.util.spec_from_file_location(name, location)
    if spec is None or spec.loader is None or not location.is_file():
        raise NotShippedError(f"package: expected {location}, which does not exist")
    for loaded in [module for module in sys.modules if module.startswith(f"{name}.")]:
        del sys.modules[loaded]
    package = importlib.util.module_from_spec(spec)
    sys.modules[name] = package
    with _no_bytecode():
        spec.loader.exec_module(package)
    return package


@contextmanager
def _no_bytecode() -> Iterator[None]:
    """Import without leaving caches, which carry times, beside the generated files."""
    before = sys.dont_write_bytecode
    sys.dont_write_bytecode = True
    try:
        yield
    finally:
        sys.dont_write_bytecode = before


def function_of(kernel: Kernel, package: ModuleType) -> Function:
    """Return the generated function of a kernel.

    It raises `NotShippedError` if the package lacks it.
    """
    module = getattr(package, kernel.module, None)
    function = getattr(module, kernel.name, None)
    if function is None:
        raise NotShippedError(f"package {package.__name__}: expected a function {kernel.qualified_name}")
    return function  # type: ignore[no-any-return]


def without_twin(function: Function) -> Function:
    """Return a generated function that runs its NumPy source even where there is a compiled version."""
    function = getattr(function, "compute", function)
    assert isinstance(function, FunctionType)
    constant = f"_{function.__name__.upper()}_SIGNATURE"
    names = dict(function.__globals__)
    names[constant] = replace(names[constant], twin=None)
    copy = FunctionType(function.__code__, names, function.__name__)
    copy.__kwdefaults__ = function.__kwdefaults__
    return copy


def call(function: Function, kernel: Kernel, values: Mapping[str, Any]) -> NDArray[Any]:
    """Call a generated function with the entries of its arguments given by name.

    They are numbers, or arrays of one batch shape. The results are one array, their core dimensions flattened to the
    last.
    """
    arrays = [_gathered(argument, values) for argument in kernel.arguments]
    returned = function(*arrays)
    results = returned if len(kernel.results) > 1 else (returned,)
    return np.concatenate(
        [_flat(np.asarray(r), len(k.shape)) for r, k in zip(results, kernel.results, strict=True)], -1
    )


def _flat(result: NDArray[Any], core_dimensions: int) -> NDArray[Any]:
    batch = result.shape[: result.ndim - core_dimensions]
    return result.reshape((*batch, -1))


def _gathered(argument: Argument, values: Mapping[str, Any]) -> NDArray[Any]:
    entries = [np.asarray(values[symbol.name]) for symbol in argument.symbols]
    stacked = np.stack(entries, axis=-1)
    return stacked.reshape(stacked.shape[:-1] + argument.shape)


@contextmanager
def replaced(function: Any, replacements: Mapping[str, Any]) -> Iterator[None]:
    """Give names another meaning inside a function, for a while."""
    names = function.__globals__
    before = {name: names[name] for name in replacements}
    names.update(replacements)
    try:
        yield
    finally:
        names.update(before)
