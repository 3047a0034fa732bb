"""How derivations make what they derive, for the claims of installed papers."""

from __future__ import annotations

import sys
from collections.abc import Sequence

import sympy

from algebroproj_sym.declaring import Claim, located
from algebroproj_sym.exporting.objects import Object, Workshop
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.expressions.provenance import Made, Record, recording

CONVENTION = "the derivation writes it down as it is printed"


def made_by_derivations(
    selectors: Sequence[str],
) -> tuple[tuple[Claim, ...], dict[tuple[str, str], Object | str]]:
    """Return the claims of some derivations, and how the derived form of each is made, or why it is not known.

    Provenance is noted while the derivations are imported; nothing is known of those that were imported before.
    """
    with recording() as record:
        found = located(selectors)
    names = _names([derivation.module for derivation, _ in found], record)
    workshops: dict[str, Workshop] = {}
    objects = {}
    for derivation, claim in found:
        if claim.kind == "identity":
            key = claim.paper, claim.number
            workshop = workshops.setdefault(f"{claim.paper}:{claim.section}", Workshop(names))
            objects[key] = _object(workshop, record.claims.get(key))
    return tuple(claim for _, claim in found), objects


def _object(workshop: Workshop, made: Made | None) -> Object | str:
    if made is None:
        return "its making was not noted"
    try:
        return workshop.object(made) or CONVENTION
    except (NotExportable, RecursionError, KeyError, ValueError, TypeError, IndexError, AttributeError) as why:
        return str(why) or type(why).__name__


def _names(modules: Sequence[str], record: Record) -> dict[Made, str]:
    """Return what derivation modules call their objects."""
    found: dict[Made, str] = {}
    for module in dict.fromkeys(modules):
        for called, value in vars(sys.modules[module]).items() if module in sys.modules else ():
            made = getattr(value, "__dict__", {}).get("made") if isinstance(value, sympy.MatrixBase) else None
            if made is None and isinstance(value, sympy.Expr) and value.args:
                made = record.scalars.get(value)
            if isinstance(made, Made) and not called.startswith("_"):
                found.setdefault(made, called)
    return found
