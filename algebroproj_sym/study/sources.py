"""The sources of a study: the files on which its numbers depend."""

import ast
import hashlib
import importlib.util
from functools import cache
from pathlib import Path

import algebroproj
from algebroproj_sym.declaring.importing import import_root
from algebroproj_sym.papers import PAPERS

OWN = ("algebroproj_sym", PAPERS, algebroproj.__name__)
"""Packages of the program; the versions of libraries are recorded instead."""


def digest(source: Path) -> str:
    """Return a digest of a module, of the modules that it imports, and of the data files with their names.

    Examples
    --------
    >>> len(digest(Path(__file__)))
    64
    """
    root = import_root(source)
    name = ".".join(source.resolve().relative_to(root).with_suffix("").parts)
    found = {name: source}
    left = [name]
    while left:
        module = left.pop()
        for imported in _imported(found[module], module):
            path = _file(imported, root)
            if imported not in found and path is not None:
                found[imported] = path
                left.append(imported)
    whole = hashlib.sha256()
    for module in sorted(found):
        path = found[module]
        for file in sorted(path.parent.glob(f"{path.stem}.*")):
            whole.update(f"{module} {file.name} {hashlib.sha256(file.read_bytes()).hexdigest()}\n".encode())
    return whole.hexdigest()


def _imported(path: Path, module: str) -> tuple[str, ...]:
    """Return the names of all modules that a file may import, anywhere in it; some are names of other things."""
    return _named(path.read_bytes(), module if path.name == "__init__.py" else module.rpartition(".")[0])


@cache
def _named(text: bytes, package: str) -> tuple[str, ...]:
    names: list[str] = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            names += (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            above = package.split(".")[: len(package.split(".")) - node.level + 1] if node.level else []
            start = ".".join([*above, *([node.module] if node.module else [])])
            names += (start, *(f"{start}.{alias.name}" for alias in node.names))
    return tuple(names)


def _file(module: str, root: Path) -> Path | None:
    """Return the source of a module of the program, or below a folder, or None."""
    place = root / module.replace(".", "/")
    for path in (place / "__init__.py", place.with_name(f"{place.name}.py")):
        if path.is_file():
            return path
    if module.partition(".")[0] not in OWN:
        return None
    try:
        found = importlib.util.find_spec(module)
    except ModuleNotFoundError:
        return None
    return Path(found.origin) if found and found.origin else None
