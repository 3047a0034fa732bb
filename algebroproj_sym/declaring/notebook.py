"""In a notebook each cell shows the claims that it declares, in their order, wherever in the cell they are declared."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from algebroproj_sym.declaring.claim import Claim
from algebroproj_sym.declaring.display import markdown
from algebroproj_sym.declaring.judging import judge

if TYPE_CHECKING:
    from algebroproj_sym.declaring.section import Section

METADATA = "algebroproj"
"""Under this key the output of a claim names the claim."""


def show_in_notebook(section: Section) -> None:
    """Let IPython, if it runs, show after each cell what has been declared in the notebook's own section.

    Parameters
    ----------
    section : Section
        The one that the notebook calls ``section``; those of imported modules stay silent.
    """
    shell = _running_shell()
    if shell is None:
        return
    shown = 0

    def declared_by_the_cell() -> Sequence[Claim]:
        return section.claims[shown:] if shell.user_ns.get("section") is section else ()

    def show_claims(_: object) -> None:
        nonlocal shown
        for claim in declared_by_the_cell():
            shown += 1
            _publish(claim)

    def show_value(claim: Claim) -> None:
        if not any(claim is declared for declared in declared_by_the_cell()):
            _publish(claim)

    shell.events.register("post_run_cell", show_claims)
    shell.display_formatter.ipython_display_formatter.for_type(Claim, show_value)


def _running_shell() -> Any:
    interactive = sys.modules.get("IPython")
    return interactive.get_ipython() if interactive else None


def _publish(claim: Claim) -> None:
    from IPython.display import display

    try:
        shown = markdown(judge(claim))
    except Exception as error:
        display({"text/plain": f"({claim.number}) cannot be judged: {type(error).__name__}: {error}"}, raw=True)
        return
    data = {"text/markdown": shown, "text/plain": f"({claim.number}) {claim.title}"}
    display(data, raw=True, metadata={METADATA: {"claim": claim.number}})
