"""The files that a site with the prover has beside its pages."""

from __future__ import annotations

import json
import subprocess
import tarfile
from collections.abc import Mapping
from importlib.resources import files
from importlib.resources.abc import Traversable
from io import BytesIO
from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory
from zipfile import ZipFile, ZipInfo

from algebroproj_sym.reporting.live.fetching import FetchError, Package, fetched, pinned

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
    with TemporaryDirectory() as name:
        folder = Path(name)
        contents = {package: fetched(package, folder) for package in pinned()}
        python = _python(next(content for package, content in contents.items() if package.registry == "npm"))
        wheels = {package: content for package, content in contents.items() if package.registry == "PyPI"}
        modules = {package.name: _loaded(package, content, python, folder) for package, content in wheels.items()}
    listed = [{"name": name, "file": file} for name, (file, _) in modules.items()]
    found = {**python, **dict(modules.values()), OWN: own_sources(), "modules.json": json.dumps(listed).encode()}
    found |= {script: _own(f"templates/{script}") for script in ("live.js", "worker.js")}
    return {f"{FOLDER}/{name}": content for name, content in found.items()}


def _python(package: bytes) -> dict[str, bytes]:
    with tarfile.open(fileobj=BytesIO(package)) as archive:
        members = {name: archive.extractfile(f"package/{name}") for name in PYTHON}
        return {name: member.read() for name, member in members.items() if member}


def _loaded(package: Package, wheel: bytes, python: Mapping[str, bytes], folder: Path) -> tuple[str, bytes]:
    """Return the file that a page loads for a wheel: the wheel, or its modules compiled if all are in Python."""
    if not package.file.endswith("-none-any.whl"):
        return package.file, wheel
    if which("node") is None:
        raise FetchError(f"node is not installed; it compiles {package.name}")
    own = {"compiling.py": _own("compiling.py"), "compile.mjs": _own("templates/compile.js")}
    for name, content in {**python, **own, package.file: wheel}.items():
        (folder / name).write_bytes(content)
    command = ["node", "compile.mjs", package.file]
    ended = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if ended.returncode:
        raise FetchError(f"{package.name} {package.version} cannot be compiled.\n{ended.stderr[-1000:].strip()}")
    return f"{package.name}.zip", (folder / f"{package.file}.zip").read_bytes()


def _own(name: str) -> bytes:
    return files("algebroproj_sym.reporting.live").joinpath(*name.split("/")).read_bytes()


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
