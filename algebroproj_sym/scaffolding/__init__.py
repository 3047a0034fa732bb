"""Scaffolding: a derivation folder to start from: a module with a claim of each common kind, and a kernel."""

import re
import sys
from importlib.util import find_spec
from keyword import iskeyword
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined

from algebroproj_sym.files import write_texts

OWN = ("algebroproj", "algebroproj_derivations", "algebroproj_sym")
FILES = ("__init__.py", "s1_thin_lens.py")
_NAME = re.compile(r"[a-z][a-z0-9_]*")

_TEMPLATES = Environment(
    loader=PackageLoader("algebroproj_sym.scaffolding"), undefined=StrictUndefined, keep_trailing_newline=True
)


class InvalidNameError(ValueError):
    """A name cannot be that of a derivation folder."""


class OccupiedError(FileExistsError):
    """There is something already where a derivation folder is to be written."""


def create(name: str, out: Path) -> tuple[Path, ...]:
    """Write the derivation folder of a new paper in a folder, and return its files.

    It raises `InvalidNameError` if the name is not one of lower-case letters, digits and underscores, or means another
    package, and `OccupiedError` if the folder exists; nothing is written.
    """
    _require_well_formed(name)
    folder = out / name
    if folder.exists() or folder.is_symlink():
        raise OccupiedError(f"{folder} exists already, and nothing was written.")
    _require_free(name)
    write_texts({file: _TEMPLATES.get_template(f"{file}.j2").render(name=name) for file in FILES}, folder)
    return tuple(folder / file for file in FILES)


def _require_well_formed(name: str) -> None:
    if not _NAME.fullmatch(name) or iskeyword(name):
        raise InvalidNameError(
            f"expected a letter, then letters, digits and underscores, all of lower case, such as mypaper, got {name!r}"
        )


def _require_free(name: str) -> None:
    """Refuse the name of an installed package; the working directory holds what the user makes."""
    spec = find_spec(name)
    places = [] if spec is None else spec.submodule_search_locations or [str(spec.origin)]
    elsewhere = any(Path(place).resolve().parent != Path.cwd() for place in places)
    if name in sys.stdlib_module_names or name in OWN or elsewhere:
        raise InvalidNameError(f"expected a name of its own, but {name!r} is already that of another Python package")
