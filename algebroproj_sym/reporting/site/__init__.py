"""The site: what was judged and generated as pages that open from disk, without a network or a script.

catalogue (what there is) → formulas, comparison, evidence, plots (as HTML) → pages → folder (written as a whole).
"""

from algebroproj_sym.reporting.site.catalogue import Catalogue, catalogue
from algebroproj_sym.reporting.site.folder import OccupiedError, replace, require_free
from algebroproj_sym.reporting.site.function_pages import functions_of
from algebroproj_sym.reporting.site.pages import render_site

__all__ = [
    "Catalogue",
    "OccupiedError",
    "catalogue",
    "functions_of",
    "render_site",
    "replace",
    "require_free",
]
