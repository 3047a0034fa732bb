"""The files that a site with the prover has beside its pages."""

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

from algebroproj_sym.reporting.live.fetching import FetchError, fetched, pinned

FOLDER = "live"
PYTHON = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip", "pyodide-lock.json")
"""What is taken of Python for the browser."""

OWN = "algebroproj_sym"
_PARTS = ("__init__.py", "expressions", "proving", "replaying", "reporting/__init__.py", "reporting/live")
_EARLIEST = (1980, 1, 1, 0, 0, 0)
_UNIX = 3


def live_files() -> dict[str, bytes]:
    """Fetch what the prover needs, and return all files of its folder by their addresses.

    It raises `FetchError` if a package cannot be fetched, or is not the one that is expected.
    """
    with TemporaryDirectory() as name:
        folder = Path(name)
        contents = {package: fetched(package, folder) for package in pinned()}
        python = _python(next(content for package, content in contents.items() if package.registry == "npm"))
        wheels = {package: content for package, content in contents.items() if package.registry == "PyPI"}
        pure = {package.name: wheel for package, wheel in wheels.items() if package.file.endswith("-none-any.whl")}
        modules = _compiled({OWN: own_sources(), **pure}, python, folder)
    loaded = {package: f"{package.name}.zip" if package.name in pure else package.file for package in wheels}
    listed = [{"name": package.name, "file": file} for package, file in loaded.items()]
    found = {file: wheels[package] for package, file in loaded.items()} | modules | python
    found["modules.json"] = json.dumps(listed).encode()
    found |= {script: _own(f"templates/{script}") for script in ("live.js", "worker.js")}
    return {f"{FOLDER}/{name}": content for name, content in found.items()}


def _python(package: bytes) -> dict[str, bytes]:
    with tarfile.open(fileobj=BytesIO(package)) as archive:
        members = {name: archive.extractfile(f"package/{name}") for name in PYTHON}
        return {name: member.read() for name, member in members.items() if member}


def _compiled(archives: Mapping[str, bytes], python: Mapping[str, bytes], folder: Path) -> dict[str, bytes]:
    """Return the ZIP files that a page loads for archives of Python modules: the same modules, compiled."""
    if which("node") is None:
        raise FetchError("node is not installed; it compiles the modules for the browser")
    own = {"compiling.py": _own("compiling.py"), "compile.mjs": _own("templates/compile.js")}
    for name, content in {**python, **own, **archives}.items():
        (folder / name).write_bytes(content)
    command = ["node", "compile.mjs", *archives]
    ended = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if ended.returncode:
        raise FetchError(f"The modules for the browser cannot be compiled.\n{ended.stderr[-1000:].strip()}")
    return {f"{name}.zip": (folder / f"{name}.zip").read_bytes() for name in archives}


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
        return {name: place.read_bytes()} if name.endswith(".py") else {}
    found: dict[str, bytes] = {}
    for inner in place.iterdir():
        found |= _modules(inner, f"{name}/{inner.name}")
    return found
