"""The exported files: one for each section of a paper, those they share, and the list of what is not exported."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files as resources
from typing import Any

from algebroproj_sym.exporting.claims import Proved, theorems
from algebroproj_sym.exporting.gallina import LEMMAS
from algebroproj_sym.exporting.letters import in_entries
from algebroproj_sym.exporting.objects import Definition, Object
from algebroproj_sym.exporting.reals import theorems_of_claim
from algebroproj_sym.exporting.refusal import AnotherForm, NotExportable, Silent
from algebroproj_sym.exporting.terms import free
from algebroproj_sym.exporting.theorems import Theorem
from algebroproj_sym.processes import mapped
from algebroproj_sym.replaying import Replayed, replay_claim

ASSUMPTIONS = "assumptions"
LIBRARY = "Algebroproj"
UNEXPORTED = "not_exported.txt"
CONVENTIONS = "conventions.txt"
CHECKING = ("-silent", "-o", "-bytecode-compiler", "yes")
"""What coqchk is asked for: a list of axioms, and to compute as fast as coqc."""

ABOUT = ("paper", "number", "section", "title", "kind", "verdict")
NO_STEPS = "no steps are written for claims of this kind"
LONGEST_NAME = 200
HEADER = f"""From Coq Require Import Reals QArith List.
From {LIBRARY} Require Import Formulas Linear.
Import ListNotations.
Open Scope R_scope.
"""
FUNCTIONS = f"From Coq Require Import Lra.\nFrom {LIBRARY} Require Import Functions.\n"


@dataclass(frozen=True)
class Exported:
    """The theorems of a claim, or why there are none."""

    paper: str
    number: str
    section: str
    title: str
    kind: str
    verdict: str
    """The claim as the ledger has it."""
    theorems: tuple[Theorem, ...] = ()
    """What it shows."""
    reason: str = ""
    """Why there is no theorem; empty if there is one."""
    refused: bool = False
    """Whether the evidence does not replay, or does not show what the ledger says."""
    definitions: tuple[Definition, ...] = ()
    """The objects that the theorems are about."""
    why: str = ""
    """Why there are no such objects, if it is known."""
    line: int = 0
    """The line of the paper that has the claim, 0 if none is quoted."""
    functions: bool = False
    """Whether the theorems are about real functions."""

    @property
    def equations(self) -> int:
        """How many equations the theorems state, entry by entry."""
        return sum(theorem.equations for theorem in self.theorems)

    @property
    def trivial(self) -> int:
        """How many of these read a = a."""
        return sum(theorem.trivial for theorem in self.theorems)


def exported(record: Mapping[str, Any], made: Object | str = "", replayed: Replayed | None = None) -> Exported:
    """Return the theorems of a claim of the ledger, which is replayed unless that was done.

    `made` is how its derivation makes the derived form, or why that is not known.
    """
    replayed = replayed or replay_claim(record)
    if replayed.status == "replayed":
        return translated(record, made)
    return _exported(record, reason=f"the evidence does not replay: {replayed.reason}", refused=True)


def translated(record: Mapping[str, Any], made: Object | str = "") -> Exported:
    """Return the theorems of a claim whose evidence was replayed."""
    setting = record["setting"]
    definitions: tuple[Definition, ...] = ()
    missing = made if isinstance(made, str) else ""
    found: Proved = {}
    try:
        if "assumptions" in setting:
            found = theorems_of_claim(record)
        elif "letters" in setting:
            found = theorems(in_entries(record))
        elif isinstance(made, Object):
            try:
                found, definitions = theorems(record, made), made.definitions
            except AnotherForm:
                raise
            except (NotExportable, RecursionError) as error:
                missing = str(error) or "the expressions are too large"
        found = found or theorems(record)
    except NotExportable as why:
        return _exported(record, reason=str(why), refused=not isinstance(why, Silent))
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        reason = f"the entry is not well-formed ({type(error).__name__}: {error})"
        return _exported(record, reason=reason, refused=True)
    except (RecursionError, OverflowError):
        return _exported(record, reason="the expressions are too large", refused=True)
    stem = f"claim_{word(str(record['number']))}"
    if len(stem) + len(_file_name(str(record["paper"]), str(record["section"]))) > LONGEST_NAME:
        return _exported(record, reason="paper, section and number are too long for names of files", refused=True)
    named = {shown: stem if shown == "holds" else f"{stem}_{word(shown)}" for shown in found}
    proved = tuple(Theorem(named[shown], *found[shown]) for shown in found)
    return _exported(record, theorems=proved, definitions=definitions, why=missing, functions="assumptions" in setting)


def _exported(record: Mapping[str, Any], **found: Any) -> Exported:
    paper, number, section, title, kind, verdict = (str(record.get(key)) for key in ABOUT)
    quote = record.get("quote")
    line = quote.get("line") if isinstance(quote, Mapping) else None
    return Exported(paper, number, section, title, kind, verdict, line=line if type(line) is int else 0, **found)


def export(
    records: Sequence[Mapping[str, Any]],
    jobs: int = 1,
    replayed: Sequence[Replayed] | None = None,
    objects: Mapping[tuple[str, str], Object | str] | None = None,
) -> Iterator[Exported]:
    """Yield the theorems of claims of the ledger, in order.

    What the replay of a whole ledger says of them may be given; without it each claim is replayed by itself.  So may,
    by paper and number, how the derivations make what they derive, or why that is not known.
    """
    said = [None] * len(records) if replayed is None else replayed
    made = [(objects or {}).get((str(r.get("paper")), str(r.get("number"))), "") for r in records]
    return mapped(_of_claim, list(zip(records, made, said, strict=True)), jobs)


def _of_claim(claim: tuple[Mapping[str, Any], Object | str, Replayed | None]) -> Exported:
    return exported(*claim)


def word(text: str) -> str:
    """Return a text as a part of a name; different texts stay different.

    Examples
    --------
    >>> word("1.3/e'1#mu"), word("1_3")
    ('1_3_x2f_e_x27_1_x23_mu', '1_x5f_3')
    """
    return re.sub(r"[^A-Za-z0-9]", lambda found: _spelled(found.group()), text)


def _file_name(paper: str, section: str) -> str:
    return f"s_{word(paper)}_{word(section)}"


def _spelled(character: str) -> str:
    return "_" if character == "." else f"_x{ord(character):x}_"


def render(claims: Iterable[Exported]) -> dict[str, str]:
    """Return the text of every file by its name.

    There are the lemmas, a file of theorems for each section, `assumptions.v`, `_CoqProject`, `Makefile`, and the lists
    `not_exported.txt` and `conventions.txt`.
    """
    claims = [*claims]
    sections: dict[str, list[Exported]] = {}
    for claim in claims:
        if claim.theorems:
            sections.setdefault(_file_name(claim.paper, claim.section), []).append(claim)
    texts = {section: _section(found) for section, found in sections.items()}
    names = [*lemmas(), *texts]
    return {
        **{f"{name}.v": text for name, text in lemmas().items()},
        **{f"{section}.v": text for section, (text, _) in texts.items()},
        f"{ASSUMPTIONS}.v": assumptions_of({section: called for section, (_, called) in texts.items()}),
        "_CoqProject": "".join([f"-R . {LIBRARY}\n", *(f"{name}.v\n" for name in (*names, ASSUMPTIONS))]),
        "Makefile": _makefile([*texts]),
        UNEXPORTED: "".join(_reason(claim) for claim in claims if claim.reason),
        CONVENTIONS: "".join(_convention(claim) for claim in claims if claim.trivial),
    }


@cache
def lemmas() -> Mapping[str, str]:
    """Return the texts of the files that all theorems need, by name."""
    folder = resources("algebroproj_sym.exporting")
    return {name.removesuffix(".v"): folder.joinpath(name).read_text(encoding="utf-8") for name in LEMMAS}


def _reason(claim: Exported) -> str:
    about = f"{claim.paper}:{claim.number}  {claim.kind}, {claim.verdict}: {claim.reason}"
    return f"{plain(about)}\n"


def _convention(claim: Exported) -> str:
    where = f"line {claim.line} of the paper" if claim.line else "not in the paper"
    counted = f"{claim.trivial} of {claim.equations}, {where}"
    return f"{plain(f'{claim.paper}:{claim.number}  {counted}: {claim.why or NO_STEPS}: {claim.title}')}\n"


def _section(claims: Sequence[Exported]) -> tuple[str, list[str]]:
    """Return the file of a section, and the names of its theorems."""
    called: list[str] = []
    parts = [HEADER, *([FUNCTIONS] if any(claim.functions for claim in claims) else [])]
    defined = dict.fromkeys(definition for claim in claims for definition in claim.definitions)
    for claim in claims:
        for definition in claim.definitions:
            if definition in defined:
                del defined[definition]
                parts.append(f"{definition.command}\n")
        about = f"{claim.paper}:{claim.number}, {claim.verdict}: {claim.title}"
        parts.append(f"(** {comment(about)} *)\n")
        for theorem in claim.theorems:
            called.append(free(theorem.name, called))
            parts.append(f"Theorem {called[-1]} :\n{theorem.statement}.\nProof.\n{theorem.proof}\nQed.\n")
    return "\n".join(parts), called


def assumptions_of(theorems: Mapping[str, Sequence[str]]) -> str:
    """Return a file that requires all others, mentions all theorems, and prints what they assume."""
    required = "".join(f"From {LIBRARY} Require {section}.\n" for section in theorems)
    mentioned = "".join(
        f"  let _ := @{LIBRARY}.{section}.{name} in\n" for section, called in theorems.items() for name in called
    )
    return f"{required}\nDefinition all_theorems : True :=\n{mentioned}  I.\n\nPrint Assumptions all_theorems.\n"


def comment(text: str) -> str:
    """Return a text that neither opens nor ends a comment or a string.

    Examples
    --------
    >>> comment('*) Axiom evil : False. (* "P*"')
    "{*}) Axiom evil : False. ({*} ''P{*}''"
    """
    return plain(text).replace('"', "''").replace("*", "{*}")


def plain(text: str) -> str:
    r"""Return a text in one line of printable ASCII; other characters are spelled.

    Examples
    --------
    >>> plain("Δ\n")
    '\\u0394\\n'
    """
    return "".join(c if c.isascii() and c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def _makefile(sections: Sequence[str]) -> str:
    needed = [*lemmas()]
    names = [*needed, *sections, ASSUMPTIONS]
    targets = " ".join(f"{name}.vo" for name in names)
    theorems = " ".join(f"{name}.vo" for name in sections)
    rules = [
        f"all: {targets}\n",
        "".join(f"{name}.vo: {needed[place]}.vo\n" for place, name in enumerate(needed[1:])),
        f"{theorems}: {needed[-1]}.vo\n" if sections else "",
        f"{ASSUMPTIONS}.vo: {theorems}\n",
        f"%.vo: %.v\n\tcoqc -q -R . {LIBRARY} $<\n",
        f"check: all\n\tcoqchk {' '.join(CHECKING)} -R . {LIBRARY} "
        + " ".join(f"-norec {LIBRARY}.{name}" for name in names)
        + "\n",
    ]
    cleaning = "clean:\n\trm -f *.vo *.vok *.vos *.glob .*.aux\n"
    return "\n".join([*filter(None, rules), cleaning, ".PHONY: all check clean\n"])
