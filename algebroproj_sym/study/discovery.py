"""Finding studies: the installed ones, or those of a file or a folder of one's own.

A module declares a study by the assignment ``STUDY = Study(...)``.
"""

import importlib
import re
import sys
from pathlib import Path
from pkgutil import iter_modules
from types import ModuleType

from algebroproj_sym.declaring.importing import BrokenModuleError, import_root
from algebroproj_sym.papers import PAPERS
from algebroproj_sym.study.declaration import Study

INSTALLED = f"{PAPERS}.studies"
DECLARES = re.compile(r"^STUDY\s*=", re.MULTILINE)


def studies(path: Path | None = None) -> tuple[Study, ...]:
    """Return the studies of a file or of the files in a folder, in the order of their names; else the installed ones.

    It raises `BrokenModuleError` if a module cannot be imported.
    """
    if path is None:
        names = sorted(info.name for info in iter_modules(importlib.import_module(INSTALLED).__path__))
        modules = [importlib.import_module(f"{INSTALLED}.{name}") for name in names]
    else:
        files = [path] if path.is_file() else sorted(path.glob("*.py"))
        modules = [_imported(file.resolve()) for file in files if DECLARES.search(file.read_text(encoding="utf-8"))]
    return tuple(study for module in modules if isinstance(study := getattr(module, "STUDY", None), Study))


def _imported(file: Path) -> ModuleType:
    """Import a module by a name under which worker processes, which have the same path, find it too."""
    root = import_root(file)
    if str(root) not in sys.path:
        sys.path.insert(0, str(root))
    try:
        module = importlib.import_module(".".join(file.relative_to(root).with_suffix("").parts))
    except Exception as error:
        raise BrokenModuleError(file, f"cannot be imported: {type(error).__name__}: {error}") from error
    if Path(str(module.__file__)).resolve() != file:
        raise BrokenModuleError(file, f"another module {module.__name__} is at {module.__file__}; give it another name")
    return module
