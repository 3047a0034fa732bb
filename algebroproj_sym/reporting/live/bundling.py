"""The files that a site with the prover has beside its pages."""

from __future__ import annotations

import json
import tarfile
from collections.abc import Mapping
from importlib.resources import files
from importlib.resources.abc import Traversable
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from zipfile import ZipFile, ZipInfo

from algebroproj_sym.reporting.live.fetching import Package, fetched, pinned

FOLDER = "live"
PYTHON = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip", "pyodide-lock.json")
"""What is taken of Python for the browser."""

OWN = "algebroproj_sym.zip"
_PARTS = ("__init__.py", "expressions", "proving", "replaying", "reporting/__init__.py", "reporting/live")
_EARLIEST = (1980, 1, 1, 0, 0, 0)
_UNIX = 3


def live_files() -> dict[str, bytes]:
    """Fetch what the prover needs, and return all files of its folder by their addresses.

    Raises
    ------
    FetchError
        If a package cannot be fetched, or is not the one that is expected.
    """
    with TemporaryDirectory() as folder:
        contents = {package: fetched(package, Path(folder)) for package in pinned()}
    return {f"{FOLDER}/{name}": content for name, content in arranged(contents).items()}


def arranged(contents: Mapping[Package, bytes]) -> dict[str, bytes]:
    """Return the files of the folder: Python, the wheels, this program, the scripts, and a list of what to load."""
    found: dict[str, bytes] = {}
    for package, content in contents.items():
        if package.registry == "npm":
            with tarfile.open(fileobj=BytesIO(content)) as archive:
                members = {name: archive.extractfile(f"package/{name}") for name in PYTHON}
                found |= {name: member.read() for name, member in members.items() if member}
        else:
            found[package.file] = content
    wheels = [
        {"name": package.name, "file": package.file, "bytes": len(content)}
        for package, content in contents.items()
        if package.registry == "PyPI"
    ]
    found[OWN] = own_sources()
    found["wheels.json"] = json.dumps(wheels, indent=1).encode()
    for script in ("live.js", "worker.js"):
        found[script] = (files("algebroproj_sym.reporting.live") / "templates" / script).read_bytes()
    return found


def own_sources() -> bytes:
    """Return the modules of this program that run in the browser, as a ZIP file: the same bytes on every machine.

    They are not compressed: what that gives depends on the version of zlib.
    """
    root = files("algebroproj_sym")
    written = BytesIO()
    with ZipFile(written, "w") as archive:
        for part in _PARTS:
            for name, content in sorted(_modules(root.joinpath(*part.split("/")), part).items()):
                entry = ZipInfo(f"algebroproj_sym/{name}", _EARLIEST)
                entry.create_system = _UNIX
                archive.writestr(entry, content)
    return written.getvalue()


def _modules(place: Traversable, name: str) -> dict[str, bytes]:
    if place.is_file():
        return {name: place.read_bytes()} if name.endswith((".py", ".lark")) else {}
    found: dict[str, bytes] = {}
    for inner in place.iterdir():
        found |= _modules(inner, f"{name}/{inner.name}")
    return found
