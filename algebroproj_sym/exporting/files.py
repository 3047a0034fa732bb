"""The exported files: one a section of a paper, what they all need, and what could not be exported."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from importlib.resources import files as resources
from multiprocessing import get_context
from typing import Any

from algebroproj_sym.exporting.claims import theorems
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.exporting.terms import free
from algebroproj_sym.exporting.theorems import Theorem

FORMULAS = "Formulas"
LIBRARY = "Algebroproj"
UNEXPORTED = "not_exported.txt"
ABOUT = ("paper", "number", "section", "title", "kind", "verdict")
HEADER = f"""From Coq Require Import Reals QArith List.
From {LIBRARY} Require Import {FORMULAS}.
Import ListNotations.
Open Scope R_scope.
"""


@dataclass(frozen=True)
class Exported:
    """The theorems of a claim, or why there are none.

    Attributes
    ----------
    paper, number, section, title, kind, verdict : str
        The claim as the ledger has it.
    theorems : tuple of Theorem
        What it shows.
    reason : str
        Why there is no theorem; empty if there is one.
    """

    paper: str
    number: str
    section: str
    title: str
    kind: str
    verdict: str
    theorems: tuple[Theorem, ...] = ()
    reason: str = ""


def exported(record: Mapping[str, Any]) -> Exported:
    """Return the theorems of a claim.

    Parameters
    ----------
    record : mapping
        A claim of the ledger.

    Examples
    --------
    >>> record = {
    ...     "paper": "demo", "number": "1.1", "section": "1", "title": "a square", "kind": "identity",
    ...     "verdict": "proved", "printed": "(x**2 - 1)/(x - 1)", "derived": "x + 1", "corrected": None, "where": {},
    ...     "hypotheses": ["x - 1"], "certificate": {"method": "normal form", "denominators": ["x - 1"]}}
    >>> print(exported(record).theorems[0].statement)
    forall x : R,
    x - 1 <> 0 ->
    (x ^ 2 - 1) / (x - 1) = x + 1
    """
    paper, number, section, title, kind, verdict = (str(record[key]) for key in ABOUT)
    claim = Exported(paper, number, section, title, kind, verdict)
    try:
        found = theorems(record)
    except NotExportable as why:
        return replace(claim, reason=str(why))
    except (RecursionError, OverflowError):
        return replace(claim, reason="the expressions are too large")
    stem = f"claim_{word(claim.number)}"
    named = {shown: stem if shown == "holds" else f"{stem}_{word(shown)}" for shown in found}
    return replace(claim, theorems=tuple(Theorem(named[shown], *found[shown]) for shown in found))


def export(records: Sequence[Mapping[str, Any]], jobs: int = 1) -> Iterator[Exported]:
    """Yield the theorems of claims, in order.

    Parameters
    ----------
    records : sequence of mapping
        Claims of the ledger.
    jobs : int
        How many processes.
    """
    if jobs == 1:
        yield from map(exported, records)
        return
    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
        yield from pool.map(exported, records, chunksize=8)


def word(text: str) -> str:
    """Return a text as a part of a name; different texts stay different.

    Examples
    --------
    >>> word("1.3/e'1#mu")
    "1_3_x2f_e'1_x23_mu"
    """
    return re.sub(r"[^A-Za-z0-9_']", lambda found: _spelled(found.group()), text)


def _spelled(character: str) -> str:
    return "_" if character == "." else f"_x{ord(character):x}_"


def render(claims: Iterable[Exported]) -> dict[str, str]:
    """Return the text of every file by its name.

    Parameters
    ----------
    claims : iterable of Exported

    Returns
    -------
    dict of str to str
        `Formulas.v`, a file of theorems for each section, `_CoqProject`, `Makefile` and `not_exported.txt`.
    """
    sections: dict[str, list[Exported]] = {}
    missing = []
    for claim in claims:
        if claim.reason:
            missing.append(f"{claim.paper}:{claim.number}  {claim.kind}, {claim.verdict}: {claim.reason}\n")
        elif claim.theorems:
            sections.setdefault(f"{word(claim.paper)}_{word(claim.section)}", []).append(claim)
    names = [FORMULAS, *sections]
    return {
        f"{FORMULAS}.v": resources("algebroproj_sym.exporting").joinpath(f"{FORMULAS}.v").read_text(encoding="utf-8"),
        **{f"{section}.v": _section(found) for section, found in sections.items()},
        "_CoqProject": "".join([f"-R . {LIBRARY}\n", *(f"{name}.v\n" for name in names)]),
        "Makefile": _makefile(names),
        UNEXPORTED: "".join(missing),
    }


def _section(claims: Sequence[Exported]) -> str:
    taken: set[str] = set()
    parts = [HEADER]
    for claim in claims:
        parts.append(f"(** {_comment(f'{claim.paper}:{claim.number}')}, {claim.verdict}: {_comment(claim.title)} *)\n")
        for theorem in claim.theorems:
            called = free(theorem.name, taken)
            taken.add(called)
            parts.append(f"Theorem {called} :\n{theorem.statement}.\nProof.\n{theorem.proof}\nQed.\n")
    mentioned = "".join(f"  let _ := {called} in\n" for called in sorted(taken))
    parts.append(
        f"(** Everything above, for one list of axioms. *)\nDefinition all_theorems : True :=\n{mentioned}  I.\n"
    )
    return "\n".join([*parts, "Print Assumptions all_theorems.\n"])


def _comment(text: str) -> str:
    """Return a text that neither opens nor ends a comment or a string."""
    return text.replace('"', "''").replace("(*", "( *").replace("*)", "* )")


def _makefile(names: Sequence[str]) -> str:
    targets = " ".join(f"{name}.vo" for name in names)
    others = " ".join(f"{name}.vo" for name in names[1:])
    rules = [
        f"all: {targets}\n",
        f"{others}: {FORMULAS}.vo\n" if others else "",
        f"%.vo: %.v\n\tcoqc -q -R . {LIBRARY} $<\n",
    ]
    cleaning = "clean:\n\trm -f *.vo *.vok *.vos *.glob .*.aux\n"
    return "\n".join([*filter(None, rules), cleaning, ".PHONY: all clean\n"])
