"""Importing derivation modules by their paths, each time as if for the first time, and without leaving a trace.

A module in a package (a folder with ``__init__.py``) is imported by its full name, so that it may import its
neighbours: ``from mypaper.notation import x``.  A module in any other folder stands alone, as a script does.
"""

import importlib
import importlib.util
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from traceback import extract_tb
from types import ModuleType

from algebroproj_sym.papers import is_package


class BrokenModuleError(ValueError):
    """A derivation module cannot be imported.

    Attributes
    ----------
    path : Path
        The module.
    """

    def __init__(self, path: Path, message: str) -> None:
        super().__init__(f"{path}: {message}")
        self.path = path


def import_at(paths: Sequence[Path]) -> tuple[ModuleType, ...]:
    """Import modules, given by resolved paths; those of one folder share what they import from it.

    It raises `BrokenModuleError` if a module raises an exception; the message has its type, text and line.
    """
    with _without_trace(paths):
        return tuple(map(_imported, paths))


def _imported(path: Path) -> ModuleType:
    root, name = _full_name(path)
    sys.path.insert(0, str(root))
    try:
        return _executed(path, name) if name == path.stem else _of_package(path, name)
    except BrokenModuleError:
        raise
    except (Exception, SystemExit) as error:
        raise BrokenModuleError(path, f"cannot be imported{_line(path, error)}: {_cause(error)}") from error
    finally:
        sys.path.remove(str(root))


def import_root(path: Path) -> Path:
    """Return the folder from which a module is imported."""
    return _full_name(path)[0]


def _full_name(path: Path) -> tuple[Path, str]:
    """Return the folder from which a module is imported, and its name from there."""
    root = path.parent
    while is_package(root):
        root = root.parent
    return root, ".".join(path.relative_to(root).with_suffix("").parts)


def _executed(path: Path, name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise BrokenModuleError(path, "expected a Python module")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _of_package(path: Path, name: str) -> ModuleType:
    module = importlib.import_module(name)
    if Path(str(module.__file__)).resolve() != path:
        top = name.partition(".")[0]
        raise BrokenModuleError(
            path, f"another module {top!r} is imported from {module.__file__}; give the folder {top} another name"
        )
    return module


@contextmanager
def _without_trace(paths: Sequence[Path]) -> Iterator[None]:
    """Forget the modules that are imported here from the folders of the paths; write no bytecode beside them."""
    before, bytecode = set(sys.modules), sys.dont_write_bytecode
    homes = [(_full_name(path)[0], path) for path in paths]
    folders = {root if path.parent == root else root / path.relative_to(root).parts[0] for root, path in homes}
    sys.dont_write_bytecode = True
    importlib.invalidate_caches()
    try:
        yield
    finally:
        sys.dont_write_bytecode = bytecode
        for name in set(sys.modules) - before:
            file = getattr(sys.modules[name], "__file__", None)
            if file and any(_is_in(Path(file).resolve(), folder) for folder in folders):
                del sys.modules[name]


def _is_in(file: Path, folder: Path) -> bool:
    return folder in file.parents if is_package(folder) else file.parent == folder


def _line(path: Path, error: BaseException) -> str:
    if isinstance(error, SyntaxError):
        return f" (line {error.lineno})"
    lines = [frame.lineno for frame in extract_tb(error.__traceback__) if Path(frame.filename).resolve() == path]
    return f" (line {lines[-1]})" if lines else ""


def _cause(error: BaseException) -> str:
    if isinstance(error, SystemExit):
        return f"it ends the program, by SystemExit({error.code!r})"
    return f"{type(error).__name__}: {error.msg if isinstance(error, SyntaxError) else error}"
