"""Finding derivations: the modules of the installed papers, or modules and folders given by their paths.

A *source* is the key of an installed paper, or the path of a derivation module or of a folder of such modules.  What is
numbered together, an installed paper or the modules of one folder, is imported and held against itself as a whole.
"""

import importlib
from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from pathlib import Path
from types import ModuleType

from algebroproj_sym import papers
from algebroproj_sym.declaring.claim import NUMBER_OF, Claim, DeclarationError
from algebroproj_sym.declaring.driver import Driver
from algebroproj_sym.declaring.importing import import_at
from algebroproj_sym.declaring.kernel import Kernel
from algebroproj_sym.declaring.quotes import Quote, quotations
from algebroproj_sym.declaring.section import Section
from algebroproj_sym.expressions import provenance
from algebroproj_sym.papers import installed_papers, is_package, modules_in, paper_folders


class UnknownSelectorError(ValueError):
    """A selector names no paper, section, claim, derivation module or folder."""


@dataclass(frozen=True)
class Derivation:
    """A derivation module and what it declares."""

    module: str
    """Its name."""
    section: Section
    """Its claims and kernels."""
    path: Path
    """Its file."""


@cache
def derivations(paper: str) -> tuple[Derivation, ...]:
    """Import the derivation modules of an installed paper, in the order of their names.

    It raises `DeclarationError` if a number is declared twice, or a claim or kernel refers to a number that is not
    declared.
    """
    found = _imported(paper, papers.module_files(paper))
    _require_consistent(found)
    return found


def _imported(paper: str, files: Sequence[Path]) -> tuple[Derivation, ...]:
    modules = [importlib.import_module(f"{papers.PAPERS}.{paper}.{file.stem}") for file in files]
    return tuple(derivation for module in modules for derivation in _declared_by(module))


def derivation_at(path: Path, *, alone: bool = False) -> tuple[Derivation, ...]:
    """Import the derivation module at a path, or those of a folder in the order of their names.

    A module of an installed paper keeps its own name.  A module of a package is held against all modules of the
    package, another one, or one that is wanted `alone`, against itself.

    It raises `UnknownSelectorError` if there is no derivation module, `BrokenModuleError` if one cannot be imported,
    and `DeclarationError` if a number is declared twice, or a claim or kernel refers to a number that is not declared.
    """
    target = path.resolve()
    if target.is_dir():
        return _body_at(target)
    if alone:
        return tuple(derivation for module in import_at([target]) for derivation in _declared_by(module))
    return tuple(derivation for derivation in _body_at(target) if derivation.path == target)


def derivations_of(sources: Sequence[str] = ()) -> tuple[Derivation, ...]:
    """Return the derivation modules of some sources, in order; those of all installed papers without one."""
    return _united([derivation for source in sources or installed_papers() for derivation in _modules_of(source)])


def numbered_with(sources: Sequence[str] = ()) -> tuple[Derivation, ...]:
    """Return the derivation modules of some sources, and those that are numbered together with them."""
    return _united([derivation for source in sources or installed_papers() for derivation in _body_of(source)])


def select(selectors: Sequence[str] = ()) -> tuple[Claim, ...]:
    """Return the claims that selectors name, in the order of the papers.  Without a selector, return all claims.

    Parameters
    ----------
    selectors : sequence of str
        Each a source, or a source with a section or a number: ``paper:1.3``, ``paper:1.3.8``, ``folder:1.3.8``.

    Raises
    ------
    UnknownSelectorError
        If a selector names nothing.
    DeclarationError
        If two modules declare the same number of the same paper.
    """
    return tuple(claim for _, claim in located(selectors))


def located(selectors: Sequence[str] = ()) -> tuple[tuple[Derivation, Claim], ...]:
    """Return the claims that some selectors name, as `select` does, each with the derivation that declares it.

    For a section or number of an installed paper, only the modules that name it are imported.  The others are imported
    if that finds nothing.
    """
    chosen = [found for selector in selectors or installed_papers() for found in _located(selector)]
    sources = [split(selector)[0] for selector in selectors]
    if not {*sources} <= {*installed_papers()}:
        derivations_of(sources)
    return tuple({(claim.paper, claim.number): (source, claim) for source, claim in chosen}.values())


def quotes_of(derivations: Iterable[Derivation]) -> dict[tuple[str, str], Quote]:
    """Return what the papers print about the claims of some derivations, by paper and number."""
    return {
        (claim.paper, claim.number): quote
        for derivation in derivations
        for claim in derivation.section.claims
        if (quote := quotations(derivation.path.parent).quotes.get(claim.number)) is not None
    }


def split(selector: str) -> tuple[str, str]:
    """Return the source of a selector, and the section or number it asks for.

    Examples
    --------
    >>> split("mypaper:1.3.8")
    ('mypaper', '1.3.8')
    >>> split("somewhere/s1_lines.py")
    ('somewhere/s1_lines.py', '')
    """
    if selector and Path(selector).exists():
        return selector, ""
    source, _, part = selector.partition(":")
    return source, part


def kernels(names: Sequence[str] = (), sources: Sequence[str] = (), *, together: bool = False) -> tuple[Kernel, ...]:
    """Return the kernels of some sources, sorted by module, in the order of their declaration.

    Modules or qualified names choose some of them.  With `together`, the modules that are numbered together with the
    sources are searched, too.  For names in the installed papers, only the modules whose text may declare them are
    imported.  The others are imported if those do not declare all.

    It raises `UnknownSelectorError` if a name names nothing, and `DeclarationError` if two kernels have the same name.
    """
    at_once = _making(names) if names and not sources else ()
    modules_found = at_once or (numbered_with(sources) if together else derivations_of(sources))
    found = [kernel for derivation in modules_found for kernel in derivation.section.kernels]
    twice = [name for name, count in Counter(kernel.qualified_name for kernel in found).items() if count > 1]
    if twice:
        raise DeclarationError(f"kernels: expected names that are declared once, got {twice} twice")
    modules = sorted({kernel.module for kernel in found})
    for name in names:
        if name not in modules and name not in {kernel.qualified_name for kernel in found}:
            near = suggestion(name, {*modules, *(kernel.qualified_name for kernel in found)})
            raise UnknownSelectorError(
                f"function: expected one of {', '.join(modules)} or module.name, got {name!r}{near}"
            )
    chosen = [k for k in found if not names or k.module in names or k.qualified_name in names]
    return tuple(sorted(chosen, key=lambda kernel: kernel.module))


def derivations_with(wanted: Collection[tuple[str, str]]) -> tuple[Derivation, ...]:
    """Import the modules of installed papers whose text names claims, given by paper and number.

    All modules are imported if those do not declare each claim.
    """
    papers_of = dict.fromkeys(paper for paper, _ in sorted(wanted))
    found = [d for paper in papers_of for d in _naming(paper, *(number for of, number in wanted if of == paper))]
    known = {(claim.paper, claim.number) for derivation in found for claim in derivation.section.claims}
    return _united(found) if {*wanted} <= known else numbered_with()


def kernels_on(claims: Iterable[Claim], sources: Sequence[str] = ()) -> list[Kernel]:
    """Return the kernels that rest on claims; of installed papers, only modules whose text names one are imported."""
    wanted = {(claim.paper, claim.number) for claim in claims}
    found = derivations_with(wanted) if {*sources} <= {*installed_papers()} else numbered_with(sources)
    declared = [kernel for derivation in found for kernel in derivation.section.kernels]
    return [kernel for kernel in declared if wanted & {(kernel.paper, number) for number in kernel.claims}]


def drivers(sources: Sequence[str] = ()) -> tuple[Driver, ...]:
    """Return the hand-written functions that travel with the kernels of some sources, sorted by module."""
    found = [driver for derivation in derivations_of(sources) for driver in derivation.section.drivers]
    return tuple(sorted(found, key=lambda driver: driver.module))


def suggestion(given: str, known: Iterable[str]) -> str:
    """Return a question after what was meant, for the end of a message; nothing if no known name is similar.

    Examples
    --------
    >>> suggestion("mypapre", ["mypaper", "another"]), suggestion("x", ["another"])
    ('. Did you mean mypaper?', '')
    """
    near = get_close_matches(given, sorted(known), n=3)
    return f". Did you mean {' or '.join(near)}?" if near else ""


def _united(found: Sequence[Derivation]) -> tuple[Derivation, ...]:
    """Return each derivation once; what is numbered apart must not use the same numbers of the same paper."""
    united = tuple({derivation.path: derivation for derivation in found}.values())
    for paper, sections in _by_paper(united).items():
        _require_different_numbers(paper, sections)
    return united


def _require_consistent(found: Sequence[Derivation]) -> None:
    """Refuse what is numbered together if a number is declared twice, or referred to and not declared."""
    for paper, sections in _by_paper(found).items():
        _require_different_numbers(paper, sections)
        _require_references(sections)


def _by_paper(found: Sequence[Derivation]) -> dict[str, list[Section]]:
    papers: dict[str, list[Section]] = {}
    for derivation in found:
        papers.setdefault(derivation.section.paper, []).append(derivation.section)
    return papers


def _require_different_numbers(paper: str, sections: Sequence[Section]) -> None:
    numbers = Counter(claim.number for section in sections for claim in section.claims)
    twice = sorted(number for number, count in numbers.items() if count > 1)
    if twice:
        raise DeclarationError(f"{paper}: expected numbers that are declared once, got {twice} twice")


def _require_references(sections: Sequence[Section]) -> None:
    numbers = {claim.number for section in sections for claim in section.claims}
    claims = [claim for section in sections for claim in section.claims]
    referred = {(claim.number, other) for claim in claims for other in (claim.instead, claim.same_as) if other}
    referred |= {(claim.number, number) for claim in claims for number in NUMBER_OF.findall(claim.follows)}
    referred |= {(k.qualified_name, number) for section in sections for k in section.kernels for number in k.claims}
    for source, number in sorted(referred):
        if number not in numbers:
            raise DeclarationError(f"{source}: expected a reference to a declared claim, got {number}")


@cache
def _declared_by(module: ModuleType) -> tuple[Derivation, ...]:
    section = getattr(module, "section", None)
    if not isinstance(section, Section):
        return ()
    provenance.name(vars(module))
    return (Derivation(module.__name__, section, Path(str(module.__file__)).resolve()),)


def _modules_of(source: str, selector: str = "") -> tuple[Derivation, ...]:
    return derivation_at(_existing(source)) if _is_path(source, selector or source) else derivations(source)


def _body_of(source: str) -> tuple[Derivation, ...]:
    return _body_at(_existing(source).resolve()) if _is_path(source, source) else derivations(source)


def _is_path(source: str, selector: str) -> bool:
    """Whether a source is a path; the key of an installed paper is none, whatever the working directory holds."""
    if source in installed_papers():
        return False
    if source and (source.endswith(".py") or Path(source).name != source or Path(source).is_dir()):
        return True
    raise UnknownSelectorError(
        f"selector: expected one of the papers {', '.join(installed_papers())}, or the path of a derivation module "
        f"or folder, got {selector!r}{suggestion(source, installed_papers())}"
    )


def _existing(source: str) -> Path:
    path = Path(source)
    if not path.exists():
        what = "module" if source.endswith(".py") else "folder"
        raise UnknownSelectorError(f"selector: expected an existing derivation {what}, got {source}")
    return path


def _body_at(target: Path) -> tuple[Derivation, ...]:
    """Return what is numbered together at a path: a folder, the package of a module, or a module that stands alone."""
    if target.is_dir():
        files = modules_in(target)
    elif is_package(target.parent):
        files = (*dict.fromkeys((*modules_in(target.parent), target)),)
    else:
        files = (target,)
    found = _derivations_in(files, tuple(_stamp(file) for file in _beside(files)))
    if target.is_file() and target not in {derivation.path for derivation in found}:
        raise UnknownSelectorError(f"selector: expected a module that makes a Section named section, got {target}")
    if not found:
        raise UnknownSelectorError(
            f"selector: expected a folder with modules that make a Section named section, got {target}"
        )
    return found


def _beside(files: Sequence[Path]) -> list[Path]:
    return [path for folder in sorted({file.parent for file in files}) for path in sorted(folder.glob("*.py"))]


def _stamp(file: Path) -> tuple[Path, int, int]:
    status = file.stat()
    return file, status.st_mtime_ns, status.st_size


@cache
def _derivations_in(files: tuple[Path, ...], stamps: tuple[tuple[Path, int, int], ...]) -> tuple[Derivation, ...]:
    """Import modules; `stamps` tell whether anything beside them has changed since the last time."""
    folders = {paper: paper_folders(paper) for paper in installed_papers()}
    homes = {file: next((paper for paper in folders if file.parent in folders[paper]), None) for file in files}
    installed = {d.path: d for paper in dict.fromkeys(homes.values()) if paper for d in derivations(paper)}
    others = [file for file in files if homes[file] is None]
    imported = {d.path: d for module in import_at(others) for d in _declared_by(module)}
    found = tuple((installed | imported)[file] for file in files if file in installed or file in imported)
    _require_consistent(found)
    return found


def _located(selector: str) -> list[tuple[Derivation, Claim]]:
    source, part = split(selector)
    if part and source in installed_papers() and (named := _named(part, _naming(source, part))):
        return named
    found = _modules_of(source, selector)
    named = _named(part, found)
    if part and not named:
        known = {name for derivation in found for c in derivation.section.claims for name in (c.section, c.number)}
        raise UnknownSelectorError(
            f"selector: expected a section or number of {source}, got {part!r}{suggestion(part, known)}"
        )
    return named


def _naming(paper: str, *parts: str) -> tuple[Derivation, ...]:
    """Import the modules of an installed paper whose text may declare sections or numbers."""
    files = papers.module_files(paper)
    return _imported(paper, [file for file in files if papers.may_name(file.read_text("utf-8"), *parts)])


def _making(functions: Sequence[str]) -> tuple[Derivation, ...]:
    """Import the modules of the installed papers whose text may declare functions; none if not all are found."""
    found: list[Derivation] = []
    for paper in installed_papers():
        files = papers.module_files(paper)
        found += _imported(paper, [file for file in files if papers.may_make(file.read_text("utf-8"), functions)])
    known = {name for d in found for kernel in d.section.kernels for name in (kernel.module, kernel.qualified_name)}
    return _united(found) if {*functions} <= known else ()


def _named(part: str, found: Sequence[Derivation]) -> list[tuple[Derivation, Claim]]:
    return [(derivation, c) for derivation in found for c in derivation.section.claims if not part or _names(part, c)]


def _names(part: str, claim: Claim) -> bool:
    in_section = claim.section == part or claim.section.startswith(f"{part}.")
    return in_section or claim.number == part or claim.number.startswith(f"{part}#")
