"""Showing: claims and their evidence as text and as LaTeX, in the order and with the names of the author."""

from algebroproj_sym.expressions.arranging import LONG, arranged
from algebroproj_sym.showing.arranging import Part, as_declared, shown
from algebroproj_sym.showing.difference import differing_entries
from algebroproj_sym.showing.display import conditions, evidence_lines, folded, markdown
from algebroproj_sym.showing.forms import derived_form
from algebroproj_sym.showing.naming import Named, in_names, latex_of_name, named_latex

__all__ = [
    "LONG",
    "Named",
    "Part",
    "arranged",
    "as_declared",
    "conditions",
    "derived_form",
    "differing_entries",
    "evidence_lines",
    "folded",
    "in_names",
    "latex_of_name",
    "markdown",
    "named_latex",
    "shown",
]
