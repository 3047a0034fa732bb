"""Compiling the exported files with coqc and coqchk, and comparing their axioms with the allowed ones."""

import re
import shutil
import subprocess
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

from algebroproj_sym.exporting.files import ASSUMPTIONS, CHECKING, LIBRARY

ALLOWED = frozenset(
    {
        "ClassicalDedekindReals.sig_forall_dec",
        "FunctionalExtensionality.functional_extensionality_dep",
    }
)
"""The axioms of the real numbers of Coq's standard library, on which theorems may rest."""

CLASSICAL = ALLOWED | {"ClassicalDedekindReals.sig_not_dec", "Classical_Prop.classic"}
"""These and the excluded middle, on which Coq's angles, and theorems about rounding, rest."""

LOADED = re.compile(
    r"Coq\.(Reals\.Rdefinitions\.(RbaseSymbolsImpl|RinvImpl)|ssr\.ssrunder\.Under_rel)\.\w+"
    r"|Coq\.(Reals|Logic)\.ClassicalDedekindReals\.(sig_forall_dec|sig_not_dec)"
    r"|Coq\.Logic\.(FunctionalExtensionality\.functional_extensionality_dep|Classical_Prop\.classic)"
)
"""What coqchk lists of the standard library when the real numbers are loaded, whether a theorem rests on it or not:
axioms, and constants whose definitions a module hides."""

CLOSED = "Closed under the global context"
_SOUND = ("relying on type-in-type", "relying on unsafe (co)fixpoints", "whose positivity is assumed")


class NoCompilerError(Exception):
    """There is no coqc, or no coqchk."""


@dataclass(frozen=True)
class Compiled:
    """What Coq says of a file."""

    name: str
    """The file, without its suffix."""
    seconds: float
    """How long it took."""
    axioms: tuple[str, ...] = ()
    """What it says that is assumed, if it was asked."""
    error: str = ""
    """Why the file is rejected; empty if it is accepted."""


def require_compiler() -> None:
    """Raise `NoCompilerError` unless coqc and coqchk are there."""
    for program in ("coqc", "coqchk"):
        _path(program)


def _path(program: str) -> str:
    path = shutil.which(program)
    if path is None:
        raise NoCompilerError(f"{program} is not installed")
    return path


def compiled(folder: Path, names: Sequence[str], jobs: int = 1) -> Iterator[Compiled]:
    """Compile files of theorems, named without suffix, after the lemmas, and yield what became of each."""
    yield from _each(lambda name: _run("coqc", folder, name, "-q", f"{name}.v")[0], names, jobs)


def checked(folder: Path, names: Sequence[str], jobs: int = 1) -> Iterator[Compiled]:
    """Have compiled files checked by coqchk, and compare the axioms that it lists with those that may be there."""
    yield from _each(lambda name: _checked(folder, name), names, jobs)


def assumptions(folder: Path, allowed: frozenset[str] = ALLOWED) -> Compiled:
    """Compile the file that prints what the theorems assume, and compare it with what is allowed."""
    found, output = _run("coqc", folder, ASSUMPTIONS, "-q", f"{ASSUMPTIONS}.v")
    if found.error:
        return found
    return replace(found, axioms=axioms(output), error=assumed(axioms(output), allowed))


def _each(judge: Callable[[str], Compiled], names: Sequence[str], jobs: int) -> Iterator[Compiled]:
    with ThreadPoolExecutor(jobs) as pool:
        yield from pool.map(judge, names)


def _checked(folder: Path, name: str) -> Compiled:
    found, output = _run("coqchk", folder, name, *CHECKING, "-norec", f"{LIBRARY}.{name}")
    return found if found.error else replace(found, axioms=loaded(output), error=unexpected(output))


def _run(program: str, folder: Path, name: str, *arguments: str) -> tuple[Compiled, str]:
    start = time.perf_counter()
    command = [_path(program), *arguments[:-1], "-R", ".", LIBRARY, arguments[-1]]
    if program == "coqchk":
        command = [_path(program), "-R", ".", LIBRARY, *arguments]
    ended = subprocess.run(command, cwd=folder, capture_output=True, text=True, encoding="utf-8", check=False)
    seconds = time.perf_counter() - start
    failure = _shortened(ended.stderr) or f"{program} ended with status {ended.returncode}"
    return Compiled(name, seconds, (), failure if ended.returncode else ""), ended.stdout + ended.stderr * (
        program == "coqchk"
    )


def _shortened(message: str) -> str:
    return message if len(message) <= 2000 else f"{message[:1000]}\n...\n{message[-1000:]}"


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


def assumed(found: Sequence[str], allowed: frozenset[str] = ALLOWED) -> str:
    """Return what is wrong with axioms; nothing if all are allowed.

    Examples
    --------
    >>> assumed(["ClassicalDedekindReals.sig_forall_dec"]), assumed(["classic"]), assumed([""])
    ('', 'the theorems assume classic', 'Coq does not say what the theorems assume')
    """
    if "" in found:
        return "Coq does not say what the theorems assume"
    others = sorted({*found} - allowed)
    return f"the theorems assume {', '.join(others)}" if others else ""


def loaded(output: str) -> tuple[str, ...]:
    """Return the axioms that coqchk lists."""
    _, _, after = output.partition("* Axioms:")
    return tuple(after.partition("\n*")[0].replace("<none>", "").split())


def unexpected(output: str) -> str:
    r"""Return what is wrong with the summary of coqchk; nothing if all is as it should be.

    Examples
    --------
    >>> said = "* Theory: Set is predicative\n* Axioms:\n    {}\n"
    >>> said += "* Constants/Inductives relying on type-in-type: <none>\n"
    >>> said += "* Constants/Inductives relying on unsafe (co)fixpoints: <none>\n"
    >>> said += "* Inductives whose positivity is assumed: <none>\n"
    >>> unexpected(said.format("Coq.Logic.Classical_Prop.classic")), unexpected(said.format("Algebroproj.a.evil"))
    ('', 'coqchk finds the axioms Algebroproj.a.evil')
    >>> unexpected("")
    'coqchk does not say what the files rest on'
    """
    if "* Axioms:" not in output or "Set is predicative" not in output:
        return "coqchk does not say what the files rest on"
    others = [axiom for axiom in loaded(output) if not LOADED.fullmatch(axiom)]
    if others:
        return f"coqchk finds the axioms {', '.join(others)}"
    if not all(f"{text}: <none>" in output for text in _SOUND):
        return "coqchk finds definitions that are not checked"
    return ""
