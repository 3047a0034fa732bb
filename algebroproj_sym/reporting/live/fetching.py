"""Fetching what the prover needs in a browser: packages by name and version, each with a known digest."""

import subprocess
import sys
import tomllib
from dataclasses import dataclass
from hashlib import sha256
from importlib.resources import files
from pathlib import Path
from shutil import which

_WASM = ("--python-version", "3.14", "--implementation", "cp", "--abi", "cp314", "--abi", "none")
_PLATFORMS = ("--platform", "pyemscripten_2026_0_wasm32", "--platform", "any")


class FetchError(RuntimeError):
    """A package cannot be fetched, or is not the one that is expected."""


@dataclass(frozen=True)
class Package:
    """A file of a package registry.

    The registry is npm or PyPI; the digest has hexadecimal digits.
    """

    registry: str
    name: str
    version: str
    file: str
    sha256: str


def pinned() -> tuple[Package, ...]:
    """Return the packages that the prover needs in a browser.

    Examples
    --------
    >>> [package.name for package in pinned()]
    ['pyodide', 'mpmath', 'sympy', 'python-flint']
    """
    text = (files("algebroproj_sym.reporting.live") / "pinned.toml").read_text(encoding="utf-8")
    return tuple(Package(**record) for record in tomllib.loads(text)["package"])


def fetched(package: Package, folder: Path) -> bytes:
    """Fetch a package into a folder, and return its content.

    It raises `FetchError` if npm is missing, the package cannot be fetched, or it has another digest.
    """
    if package.registry == "npm" and which("npm") is None:
        raise FetchError(f"npm is not installed; it fetches {package.name}")
    download = (sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary=:all:")
    commands = {
        "npm": ["npm", "pack", "--silent", f"{package.name}@{package.version}"],
        "PyPI": [*download, *_WASM, *_PLATFORMS, "--dest", ".", f"{package.name}=={package.version}"],
    }
    ended = subprocess.run(commands[package.registry], cwd=folder, capture_output=True, text=True, check=False)
    path = folder / package.file
    if ended.returncode or not path.is_file():
        raise FetchError(f"{package.name} {package.version} cannot be fetched.\n{ended.stderr[-1000:].strip()}")
    return genuine(package, path.read_bytes())


def genuine(package: Package, content: bytes) -> bytes:
    """Return the content of a package; it raises `FetchError` if that has another digest than is expected."""
    found = sha256(content).hexdigest()
    if found != package.sha256:
        raise FetchError(f"{package.file}: expected the SHA-256 digest {package.sha256}, got {found}")
    return content
