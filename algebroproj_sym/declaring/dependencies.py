"""Which derivation modules there are and what they import of each other, read without running them."""

from __future__ import annotations

import re
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from pkgutil import iter_modules

from algebroproj_sym.declaring.importing import makes_section


def derivation_names(package: str) -> tuple[str, ...]:
    """Return the names of the derivation modules of a package, sorted."""
    spec = find_spec(package)
    folders = (spec.submodule_search_locations if spec else None) or ()
    names = sorted(f"{package}.{info.name}" for info in iter_modules(folders))
    return tuple(name for name in names if makes_section(_file(name)))


@cache
def needed_by(name: str) -> dict[str, int]:
    """Return the modules of the same top-level package that a module imports, also by others, with their sizes.

    Returns
    -------
    dict of str to int
        Names, the module's own among them, and the lengths of their sources.
    """
    needed, waiting = dict[str, int](), [name]
    while waiting:
        module = waiting.pop()
        if module not in needed:
            source = _file(module).read_text(encoding="utf-8")
            needed[module] = len(source)
            waiting += _imported(source, name.partition(".")[0])
    return needed


def _imported(source: str, top: str) -> list[str]:
    return re.findall(rf"^from ({top}[\w.]*) import", source, re.MULTILINE)


def _file(name: str) -> Path:
    spec = find_spec(name)
    if spec is None or spec.origin is None:
        raise ModuleNotFoundError(f"expected a module with a source, got {name}")
    return Path(spec.origin)
