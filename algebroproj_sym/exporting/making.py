"""The steps by which derivations compute their results, for the claims of installed papers."""

from collections.abc import Sequence

from algebroproj_sym.declaring import Claim, located
from algebroproj_sym.exporting.objects import Object, Workshop
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.expressions.provenance import Made, recording

CONVENTION = "the derivation introduces it in this form"
NUMBERS = "it is made of numbers that the derivation computes"


def made_by_derivations(
    selectors: Sequence[str],
) -> tuple[tuple[Claim, ...], dict[tuple[str, str], Object | str]]:
    """Return the claims of some derivations, and how the derived form of each is made, or why it is not known.

    Provenance is noted while the derivations are imported; nothing is known of those that were imported before.
    """
    with recording() as record:
        found = located(selectors)
    workshops: dict[str, Workshop] = {}
    objects = {}
    for _, claim in found:
        if claim.kind in ("identity", "identity under constraints"):
            key = claim.paper, claim.number
            section = f"{claim.paper}:{claim.section}"
            workshop = workshops.setdefault(section, Workshop(record.names))
            objects[key] = _object(workshop, record.claims.get(key))
    return tuple(claim for _, claim in found), objects


def _object(workshop: Workshop, made: Made | None) -> Object | str:
    if made is None:
        return "its making was not noted"
    try:
        return workshop.object(made) or (CONVENTION if made.value.free_symbols else NUMBERS)
    except (NotExportable, RecursionError, KeyError, ValueError, TypeError, IndexError, AttributeError) as why:
        return str(why) or type(why).__name__
