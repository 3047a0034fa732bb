"""Compiling: Coq's kernel checks the exported files, and what they assume is compared with what is allowed."""

from __future__ import annotations

import re
import shutil
import subprocess
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from algebroproj_sym.exporting.files import FORMULAS, LIBRARY

ALLOWED = frozenset(
    {
        "ClassicalDedekindReals.sig_forall_dec",
        "FunctionalExtensionality.functional_extensionality_dep",
    }
)
"""The axioms of the real numbers of Coq's standard library, on which theorems may rest."""

CLOSED = "Closed under the global context"


class NoCompilerError(Exception):
    """There is no coqc."""


@dataclass(frozen=True)
class Compiled:
    """What Coq says of a file.

    Attributes
    ----------
    name : str
        The file, without its suffix.
    seconds : float
        How long it took.
    axioms : tuple of str
        What the theorems assume.
    error : str
        Why the file is rejected; empty if it is accepted.
    """

    name: str
    seconds: float
    axioms: tuple[str, ...] = ()
    error: str = ""


def require_compiler() -> str:
    """Return the path of coqc."""
    path = shutil.which("coqc")
    if path is None:
        raise NoCompilerError("coqc is not installed")
    return path


def compiled_lemmas(folder: Path) -> Compiled:
    """Compile the lemmas that all files of theorems need."""
    return _run(require_compiler(), folder, FORMULAS)


def compiled(folder: Path, names: Sequence[str], jobs: int = 1) -> Iterator[Compiled]:
    """Compile files of theorems after the lemmas, and compare what they assume with what is allowed.

    Parameters
    ----------
    folder : Path
        Where they are.
    names : sequence of str
        The files of theorems, without suffix.
    jobs : int
        How many at a time.

    Yields
    ------
    Compiled
        For each file in order.
    """
    coqc = require_compiler()
    with ThreadPoolExecutor(jobs) as pool:
        yield from pool.map(lambda name: _judged(coqc, folder, name), names)


def _judged(coqc: str, folder: Path, name: str) -> Compiled:
    found = _run(coqc, folder, name)
    return found if found.error else Compiled(name, found.seconds, found.axioms, assumed(found.axioms))


def _run(coqc: str, folder: Path, name: str) -> Compiled:
    start = time.perf_counter()
    command = [coqc, "-q", "-R", ".", LIBRARY, f"{name}.v"]
    ended = subprocess.run(command, cwd=folder, capture_output=True, text=True, encoding="utf-8", check=False)
    seconds = time.perf_counter() - start
    if ended.returncode:
        return Compiled(name, seconds, (), _shortened(ended.stderr) or f"coqc ended with status {ended.returncode}")
    return Compiled(name, seconds, axioms(ended.stdout))


def _shortened(message: str, limit: int = 2000) -> str:
    return message if len(message) <= limit else f"{message[: limit // 2]}\n...\n{message[-limit // 2 :]}"


def axioms(output: str) -> tuple[str, ...]:
    r"""Return the axioms that ``Print Assumptions`` lists; ``("",)`` if it has not spoken.

    Examples
    --------
    >>> axioms("Axioms:\nclassic : forall P : Prop,\n  P -> P\nother\n  : nat\n")
    ('classic', 'other')
    >>> axioms("Closed under the global context\n"), axioms("")
    ((), ('',))
    """
    if output.strip() == CLOSED:
        return ()
    heading, _, listed = output.partition("\n")
    if heading.strip() != "Axioms:":
        return ("",)
    return tuple(re.findall(r"^(\S+)", listed, flags=re.MULTILINE))


def assumed(found: Sequence[str]) -> str:
    """Return what is wrong with axioms; nothing if all are allowed.

    Examples
    --------
    >>> assumed(["ClassicalDedekindReals.sig_forall_dec"]), assumed(["classic"]), assumed([""])
    ('', 'the theorems assume classic', 'Coq does not say what the theorems assume')
    """
    if "" in found:
        return "Coq does not say what the theorems assume"
    others = sorted({*found} - ALLOWED)
    return f"the theorems assume {', '.join(others)}" if others else ""
