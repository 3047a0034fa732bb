"""Derivation modules as text: which modules there are, and their sections and numbers, without running them."""

import ast
import importlib
import re
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

PAPERS = "algebroproj_derivations"
"""The package of the installed papers."""

_SECTION = re.compile(r"^section\s*=", re.MULTILINE)


def installed_papers() -> tuple[str, ...]:
    """Return the keys of the installed papers, sorted: the packages that hold a derivation module."""
    return _papers_of(PAPERS)


@cache
def _papers_of(package: str) -> tuple[str, ...]:
    folders = [Path(folder) for folder in importlib.import_module(package).__path__]
    inside = (child for folder in folders for child in folder.iterdir() if is_package(child))
    return tuple(sorted(child.name for child in inside if any(map(makes_section, sorted(child.glob("*.py"))))))


def paper_folders(paper: str) -> set[Path]:
    """Return where the modules of an installed paper are."""
    folders = importlib.import_module(PAPERS).__path__
    return {(Path(folder) / paper).resolve() for folder in folders}


def module_files(paper: str) -> tuple[Path, ...]:
    """Return the derivation modules of an installed paper, in the order of their names."""
    files = {path for folder in paper_folders(paper) for path in folder.glob("*.py") if makes_section(path)}
    return tuple(sorted(files))


def makes_section(path: Path) -> bool:
    """Whether a file is a derivation module: whether it assigns ``section = Section(...)``."""
    return _assigns_section(path.read_text(encoding="utf-8", errors="replace"))


@cache
def _assigns_section(source: str) -> bool:
    if not _SECTION.search(source):
        return False
    try:
        statements = ast.parse(source).body
    except (SyntaxError, ValueError):
        return True
    return any(
        isinstance(statement, ast.Assign)
        and any(isinstance(target, ast.Name) and target.id == "section" for target in statement.targets)
        and isinstance(statement.value, ast.Call)
        and ast.unparse(statement.value.func).rpartition(".")[2] == "Section"
        for statement in statements
    )


def modules_in(folder: Path) -> tuple[Path, ...]:
    """Return the derivation modules of a folder in the order of their names, then those of the packages in it."""
    files = [path for path in sorted(folder.glob("*.py")) if makes_section(path)]
    packages = [path for path in sorted(folder.iterdir()) if is_package(path) and not path.name.startswith(".")]
    return (*files, *(module for package in packages for module in modules_in(package)))


def is_package(folder: Path) -> bool:
    """Whether a folder has an ``__init__.py``."""
    return (folder / "__init__.py").is_file()


def may_name(source: str, *parts: str) -> bool:
    """Whether the text of a module has a string that is a number, or begins with it and ``#``, or names its section.

    One of several numbers is enough.

    Examples
    --------
    >>> may_name('section.identity(f"1.3.4#{row}", ...)', "1.3.4"), may_name('"1.3.41"', "1.3.4")
    (True, False)
    >>> may_name('section = Section("mypaper", "1.3", "Lines")', "1")
    True
    """
    names, stems = map(_one_of, (parts, {part.partition("#")[0] for part in parts}))
    written = rf"""["']({names}["'#]|{stems}#[^"'{{]*\{{)|Section\([^)]*["']{names}\."""
    return re.search(written, source) is not None


def may_make(source: str, functions: Iterable[str]) -> bool:
    """Whether the text of a module has a string that begins with the module of a function, or a name that is computed.

    Examples
    --------
    >>> may_make('section.kernel("optics.scale", ...)', ["optics"]), may_make('"optics.scale"', ["optic.scale"])
    (True, False)
    >>> may_make('section.kernel(f"{module}.scale", ...)', ["optics"])
    True
    """
    modules = _one_of({function.partition(".")[0] for function in functions})
    return re.search(rf"""["']{modules}\.|\.kernel\(\s*[^"'\s]""", source) is not None


def _one_of(texts: Iterable[str]) -> str:
    return f"(?:{'|'.join(map(re.escape, sorted(texts)))})"


def names_in(path: Path) -> Iterator[str]:
    """Yield the sections and numbers that are written in a module, in their order."""
    try:
        calls = [node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.Call)]
    except (OSError, SyntaxError, ValueError):
        return
    for call in sorted(calls, key=lambda call: (call.lineno, call.col_offset)):
        match call:
            case ast.Call(func=ast.Name(id="Section"), args=[_, ast.Constant(value=str(name)), *_]):
                yield name
            case ast.Call(
                func=ast.Attribute(value=ast.Name(id="section"), attr=method), args=[ast.Constant(value=str(name)), *_]
            ) if method not in ("kernel", "driver"):
                yield name
