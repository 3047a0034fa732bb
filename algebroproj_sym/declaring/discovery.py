"""Finding derivations: the modules of the installed papers, or a module given by its path."""

from __future__ import annotations

import importlib
import importlib.util
import pkgutil
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import ModuleType

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.driver import Driver
from algebroproj_sym.declaring.kernel import Kernel
from algebroproj_sym.declaring.section import Section

PAPERS = "algebroproj_derivations"


class UnknownSelectorError(ValueError):
    """A selector names no paper, section, claim or derivation module."""


@dataclass(frozen=True)
class Derivation:
    """A derivation module and what it declares."""

    module: str
    section: Section


def installed_papers() -> tuple[str, ...]:
    """Return the keys of the installed papers, sorted."""
    package = importlib.import_module(PAPERS)
    return tuple(sorted(info.name for info in pkgutil.iter_modules(package.__path__) if info.ispkg))


@cache
def derivations(paper: str) -> tuple[Derivation, ...]:
    """Import the derivation modules of an installed paper, in the order of their names.

    Raises
    ------
    DeclarationError
        If a number is declared twice, or a claim or kernel refers to a number that is not declared.
    """
    package = importlib.import_module(f"{PAPERS}.{paper}")
    names = sorted(info.name for info in pkgutil.iter_modules(package.__path__))
    modules = (importlib.import_module(f"{package.__name__}.{name}") for name in names)
    found = tuple(Derivation(module.__name__, section) for module in modules for section in _sections(module))
    _require_consistent(found)
    return found


def _require_consistent(found: Sequence[Derivation]) -> None:
    claims = [claim for derivation in found for claim in derivation.section.claims]
    kernels_found = [kernel for derivation in found for kernel in derivation.section.kernels]
    numbers = Counter(claim.number for claim in claims)
    twice = sorted(number for number, count in numbers.items() if count > 1)
    if twice:
        raise DeclarationError(f"{claims[0].paper}: expected numbers that are declared once, got {twice} twice")
    referred = {(claim.number, claim.instead) for claim in claims if claim.instead}
    referred |= {(kernel.qualified_name, number) for kernel in kernels_found for number in kernel.claims}
    for source, number in sorted(referred):
        if number not in numbers:
            raise DeclarationError(f"{source}: expected a reference to a declared claim, got {number}")


def derivation_at(path: Path) -> tuple[Derivation, ...]:
    """Import the derivation module at a path; one of an installed paper keeps its own name."""
    target = path.resolve()
    for paper in installed_papers():
        if target.parent not in _folders(paper):
            continue
        for derivation in derivations(paper):
            if Path(str(sys.modules[derivation.module].__file__)).resolve() == target:
                return (derivation,)
    spec = importlib.util.spec_from_file_location(target.stem, target)
    if spec is None or spec.loader is None:
        raise UnknownSelectorError(f"selector: expected the path of a Python module, got {path}")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    found = tuple(Derivation(target.stem, section) for section in _sections(module))
    if not found:
        raise UnknownSelectorError(f"selector: expected a module that makes a Section named section, got {path}")
    _require_consistent(found)
    return found


def _folders(paper: str) -> set[Path]:
    """Return where the modules of a paper are, without importing them."""
    return {Path(folder).resolve() for folder in importlib.import_module(f"{PAPERS}.{paper}").__path__}


def select(selectors: Sequence[str] = ()) -> tuple[Claim, ...]:
    """Return the claims that some selectors name, in the order of the papers; all claims without a selector.

    Parameters
    ----------
    selectors : sequence of str
        Each a paper key, ``paper:section``, ``paper:number`` or the path of a derivation module.

    Raises
    ------
    UnknownSelectorError
        If a selector names nothing.
    """
    return tuple(claim for _, claim in located(selectors))


def located(selectors: Sequence[str] = ()) -> tuple[tuple[Derivation, Claim], ...]:
    """Return the claims that some selectors name, as `select` does, each with the derivation that declares it."""
    chosen = [found for selector in selectors or installed_papers() for found in _located(selector)]
    return tuple({(claim.paper, claim.number): (source, claim) for source, claim in chosen}.values())


def kernels(names: Sequence[str] = ()) -> tuple[Kernel, ...]:
    """Return the kernels of all installed papers, sorted by module, in the order of their declaration.

    Parameters
    ----------
    names : sequence of str
        Modules or qualified names; without one, all kernels are returned.

    Raises
    ------
    UnknownSelectorError
        If a name names nothing.
    """
    found = [k for paper in installed_papers() for d in derivations(paper) for k in d.section.kernels]
    modules = sorted({kernel.module for kernel in found})
    for name in names:
        if name not in modules and name not in {kernel.qualified_name for kernel in found}:
            raise UnknownSelectorError(f"function: expected one of {', '.join(modules)} or module.name, got {name!r}")
    chosen = [k for k in found if not names or k.module in names or k.qualified_name in names]
    return tuple(sorted(chosen, key=lambda kernel: kernel.module))


def drivers() -> tuple[Driver, ...]:
    """Return the hand-written functions that travel with the kernels, sorted by module."""
    found = [driver for paper in installed_papers() for d in derivations(paper) for driver in d.section.drivers]
    return tuple(sorted(found, key=lambda driver: driver.module))


def _sections(module: ModuleType) -> tuple[Section, ...]:
    section = getattr(module, "section", None)
    return (section,) if isinstance(section, Section) else ()


def _located(selector: str) -> list[tuple[Derivation, Claim]]:
    if selector.endswith(".py"):
        path = Path(selector)
        if not path.is_file():
            raise UnknownSelectorError(f"selector: expected an existing derivation module, got {selector}")
        return [(source, claim) for source in derivation_at(path) for claim in source.section.claims]
    paper, _, part = selector.partition(":")
    if paper not in installed_papers():
        raise UnknownSelectorError(
            f"selector: expected one of the papers {', '.join(installed_papers())}, got {selector!r}"
        )
    found = [(source, claim) for source in derivations(paper) for claim in source.section.claims]
    named = [(source, claim) for source, claim in found if not part or _names(part, claim)]
    if part and not named:
        raise UnknownSelectorError(f"selector: expected a section or number of {paper}, got {part!r}")
    return named


def _names(part: str, claim: Claim) -> bool:
    in_section = claim.section == part or claim.section.startswith(f"{part}.")
    return in_section or claim.number == part or claim.number.startswith(f"{part}#")
