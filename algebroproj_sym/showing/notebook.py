"""In a notebook each cell shows the claims that it declares, in their order, wherever in the cell they are declared.

A form at the end of a cell is shown as the claims show theirs.
"""

import sys
from collections.abc import Sequence
from typing import Any
from weakref import WeakKeyDictionary

import sympy

from algebroproj_sym.declaring import Claim, Section, judge
from algebroproj_sym.declaring.text_forms import Given, text_fields
from algebroproj_sym.expressions import NotRationalError
from algebroproj_sym.expressions.arranging import arranged
from algebroproj_sym.proving import reduced
from algebroproj_sym.showing.display import markdown
from algebroproj_sym.showing.latex import latex

METADATA = "algebroproj"
"""Under this key the output of a claim names the claim."""


def show_claims_of_cells() -> None:
    """Let IPython, if it runs, show after each cell what has been declared in the notebook's own section.

    It is the one that the notebook calls ``section``; those of imported modules stay silent.
    """
    shell: Any = sys.modules["IPython"].get_ipython()
    if shell is None:
        return
    shown: WeakKeyDictionary[Section, int] = WeakKeyDictionary()

    def declared_by_the_cell() -> Sequence[Claim]:
        section = shell.user_ns.get("section")
        return section.claims[shown.get(section, 0) :] if isinstance(section, Section) else ()

    def show_claims(_: object) -> None:
        for claim in declared_by_the_cell():
            section = shell.user_ns["section"]
            shown[section] = shown.get(section, 0) + 1
            _publish(claim)

    def show_value(claim: Claim) -> None:
        if not any(claim is declared for declared in declared_by_the_cell()):
            _publish(claim)

    shell.events.register("post_run_cell", show_claims)
    shell.display_formatter.ipython_display_formatter.for_type(Claim, show_value)
    for form in (sympy.Expr, sympy.MatrixBase):
        shell.display_formatter.formatters["text/latex"].for_type(form, latex_of_form)


def latex_of_form(form: sympy.Expr | sympy.MatrixBase) -> str:
    """Return a derived form, which a cell ends with, as the claims show it."""
    try:
        return f"$$ {latex(arranged(reduced(form)))} $$"
    except NotRationalError:
        given = Given({"derived": form}, (), (), (), {})
        if not given.is_text:
            raise
    return f"$$ {latex(text_fields(given, 'identity', 'form')['derived'])} $$"


def _publish(claim: Claim) -> None:
    from IPython.display import display

    try:
        shown = markdown(judge(claim))
    except Exception as error:
        display({"text/plain": f"({claim.number}) cannot be judged: {type(error).__name__}: {error}"}, raw=True)
        return
    data = {"text/markdown": shown, "text/plain": f"({claim.number}) {claim.title}"}
    display(data, raw=True, metadata={METADATA: {"claim": claim.number}})
