"""What the site is about: papers, their sections, claims with verdicts, and the functions that rest on them."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import accumulate
from operator import itemgetter

from algebroproj_sym.declaring import Claim, Derivation, Judgement, Publication, Quote, Verdict, publication, quotations
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.reporting.dependences import Dependences, Key
from algebroproj_sym.reporting.ledger import summary
from algebroproj_sym.reporting.notebooks import Notebook
from algebroproj_sym.reporting.site.addresses import claim_page, function_page, notebook_page, slug
from algebroproj_sym.verifying.verification import Verification

GRAVITY: tuple[Verdict, ...] = ("definition", "proved", "illegible", "misprint", "error", "false", "open")
"""The verdicts, the gravest one last."""


@dataclass(frozen=True)
class Function:
    """A generated function."""

    lowered: Lowered
    """Its kernel and program."""
    verification: Verification
    """Its figures."""
    source: str
    """Its source text."""

    @property
    def name(self) -> str:
        """Module and name."""
        return self.lowered.kernel.qualified_name

    @property
    def page(self) -> str:
        """The address of its page."""
        return function_page(self.name)


@dataclass(frozen=True)
class Entry:
    """A claim, its verdict and where it is derived."""

    judgement: Judgement
    derivation: Derivation

    @property
    def claim(self) -> Claim:
        """What is declared."""
        return self.judgement.claim

    @property
    def page(self) -> str:
        """The address of its page."""
        return claim_page(self.claim.paper, self.claim.number)

    @property
    def key(self) -> Key:
        """Paper and number."""
        return self.claim.paper, self.claim.number

    @property
    def quote(self) -> Quote | None:
        """What the paper prints."""
        return quotations(self.derivation.path.parent).quotes.get(self.claim.number)


@dataclass(frozen=True, eq=False)
class Equation:
    """What a paper says under one number, and the claims about it."""

    number: str
    entries: tuple[Entry, ...]

    @property
    def quotes(self) -> tuple[Quote, ...]:
        """What the paper prints, each piece once."""
        found = dict.fromkeys(entry.quote for entry in self.entries if entry.quote is not None)
        return tuple(quote for quote in found if not any({*quote.read} < {*other.read} for other in found))

    @property
    def counts(self) -> Mapping[str, int]:
        """How often each verdict occurs."""
        return summary([entry.judgement for entry in self.entries])

    @property
    def verdict(self) -> Verdict:
        """The gravest verdict of its claims."""
        return max((entry.judgement.verdict for entry in self.entries), key=GRAVITY.index)


@dataclass(frozen=True)
class Chapter:
    """A section of a paper, as far as it is selected."""

    paper: str
    number: str
    title: str
    entries: tuple[Entry, ...]

    @property
    def refers(self) -> bool:
        """Whether all that is claimed is that references lead where they should."""
        return all(entry.claim.kind == "reference" for entry in self.entries)

    @cached_property
    def equations(self) -> tuple[Equation, ...]:
        """The claims by what stands before the number sign, in the order in which the paper prints them."""
        groups = _grouped(self.entries, lambda entry: entry.claim.number.partition("#")[0])
        equations = [Equation(number, tuple(entries)) for number, entries in groups.items()]
        lines = accumulate(equations, _line, initial=0)
        return tuple(equation for _, equation in sorted(zip([*lines][1:], equations, strict=True), key=itemgetter(0)))


@dataclass(frozen=True)
class Paper:
    """A paper, as far as it is selected."""

    about: Publication
    chapters: tuple[Chapter, ...]

    @cached_property
    def entries(self) -> tuple[Entry, ...]:
        """All claims in the paper's order."""
        return tuple(entry for chapter in self.chapters for entry in chapter.entries)

    @property
    def counts(self) -> Mapping[str, int]:
        """How often each verdict occurs."""
        return summary([entry.judgement for entry in self.entries])

    def with_verdict(self, *verdicts: str) -> tuple[Entry, ...]:
        """Return the claims with one of some verdicts."""
        return tuple(entry for entry in self.entries if entry.judgement.verdict in verdicts)


@dataclass(frozen=True)
class Catalogue:
    """All that the site shows."""

    papers: tuple[Paper, ...]
    """With at least one claim each."""
    functions: tuple[Function, ...]
    """In the order of the kernels."""
    notebooks: tuple[Notebook, ...] = ()
    """The derivations, run; none unless they are wanted."""
    live: bool = False
    """Whether the pages carry the prover."""
    rests: Dependences = field(default_factory=dict)
    """What claims rest on, by paper and number."""

    @property
    def entries(self) -> tuple[Entry, ...]:
        """All claims."""
        return tuple(entry for paper in self.papers for entry in paper.entries)

    @cached_property
    def by_number(self) -> Mapping[tuple[str, str], Entry]:
        """The claims by paper and number."""
        return {(entry.claim.paper, entry.claim.number): entry for entry in self.entries}

    def cell_of(self, entry: Entry) -> str | None:
        """Return the address of the cell that derives a claim, if the notebook was run."""
        module = entry.derivation.module
        ran = any(notebook.module == module for notebook in self.notebooks)
        return f"{notebook_page(module)}#{slug(entry.claim.number)}" if ran else None

    def bases(self, entry: Entry) -> tuple[Entry, ...]:
        """Return the claims that a claim rests on, as far as they are selected."""
        return tuple(self.by_number[key] for key in self.rests.get(entry.key, ()) if key in self.by_number)

    def resting_on(self, entry: Entry) -> tuple[Entry, ...]:
        """Return the claims that rest on a claim, as far as they are selected."""
        return self._resting.get(entry.key, ())

    @cached_property
    def _resting(self) -> Mapping[Key, tuple[Entry, ...]]:
        found: dict[Key, tuple[Entry, ...]] = {}
        for entry in self.entries:
            for base in self.bases(entry):
                found[base.key] = (*found.get(base.key, ()), entry)
        return found

    def functions_on(self, claim: Claim) -> tuple[Function, ...]:
        """Return the functions that rest on a claim."""
        kernels = ((function, function.lowered.kernel) for function in self.functions)
        return tuple(f for f, kernel in kernels if kernel.paper == claim.paper and claim.number in kernel.claims)


def catalogue(
    judgements: Sequence[Judgement],
    derivations: Sequence[Derivation],
    functions: Sequence[Function] = (),
    notebooks: Sequence[Notebook] = (),
    live: bool = False,
    rests: Dependences | None = None,
) -> Catalogue:
    """Return what the site is about: judgements in any order, each with the derivation that declares its claim.

    What claims rest on is given by paper and number.
    """
    entries = [Entry(judgement, source) for judgement, source in zip(judgements, derivations, strict=True)]
    groups = _grouped(sorted(entries, key=_place), lambda entry: entry.claim.paper)
    papers = tuple(Paper(publication(key), _chapters(key, group)) for key, group in groups.items())
    return Catalogue(papers, tuple(functions), tuple(notebooks), live, rests or {})


def _place(entry: Entry) -> tuple[str, str, int]:
    """Return where a claim stands: paper, module, and place in the module."""
    return entry.claim.paper, entry.derivation.module, entry.derivation.section.claims.index(entry.claim)


def _line(line: int, equation: Equation) -> int:
    """Return on which line an equation stands; without a quote it stays behind the one before it."""
    return equation.quotes[0].line if equation.quotes else line


def _chapters(paper: str, entries: Sequence[Entry]) -> tuple[Chapter, ...]:
    sections = _grouped(entries, lambda entry: entry.claim.section)
    chapters = (Chapter(paper, number, _titles(group), tuple(group)) for number, group in sections.items())
    return tuple(sorted(chapters, key=lambda chapter: chapter.refers))


def _grouped(entries: Sequence[Entry], key: Callable[[Entry], str]) -> Mapping[str, list[Entry]]:
    """Return the claims by a key, keys in the order of their first claims."""
    groups: dict[str, list[Entry]] = {}
    for entry in entries:
        groups.setdefault(key(entry), []).append(entry)
    return groups


def _titles(entries: Sequence[Entry]) -> str:
    return "; ".join(dict.fromkeys(entry.derivation.section.title for entry in entries))
