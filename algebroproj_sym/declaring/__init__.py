"""Declaring: what derivations state and ask for, how each statement is judged and how it shows itself."""

from algebroproj_sym.declaring.arranging import Part, arranged, as_declared, shown
from algebroproj_sym.declaring.bibliography import Publication, bibtex, publication
from algebroproj_sym.declaring.claim import (
    VERDICTS,
    Claim,
    DeclarationError,
    Statement,
    Verdict,
    in_derived_terms,
    statement_text,
)
from algebroproj_sym.declaring.difference import differing_entries
from algebroproj_sym.declaring.discovery import (
    Derivation,
    UnknownSelectorError,
    derivation_at,
    derivations,
    derivations_of,
    drivers,
    installed_papers,
    kernels,
    located,
    numbered_with,
    paper_folders,
    quotes_of,
    select,
    split,
)
from algebroproj_sym.declaring.display import conditions, evidence_lines, folded, markdown
from algebroproj_sym.declaring.driver import Driver
from algebroproj_sym.declaring.identities import Answer, Identity, MalformedFileError, identities
from algebroproj_sym.declaring.importing import BrokenModuleError, import_root, makes_section
from algebroproj_sym.declaring.judging import Judgement, judge
from algebroproj_sym.declaring.kernel import Argument, Kernel, Result
from algebroproj_sym.declaring.naming import Named, in_names, latex_of_name, named_latex
from algebroproj_sym.declaring.quotes import UNPARSED, UNQUOTED, Quotations, Quote, quotations
from algebroproj_sym.declaring.section import Section
from algebroproj_sym.declaring.stage import (
    LINEAR,
    PRIMITIVES,
    Primitive,
    Stage,
    arctan2,
    cos_sin,
    let,
    null_vector,
    solution,
)

__all__ = [
    "LINEAR",
    "PRIMITIVES",
    "UNPARSED",
    "UNQUOTED",
    "VERDICTS",
    "Answer",
    "Argument",
    "BrokenModuleError",
    "Claim",
    "DeclarationError",
    "Derivation",
    "Driver",
    "Identity",
    "Judgement",
    "Kernel",
    "MalformedFileError",
    "Named",
    "Part",
    "Primitive",
    "Publication",
    "Quotations",
    "Quote",
    "Result",
    "Section",
    "Stage",
    "Statement",
    "UnknownSelectorError",
    "Verdict",
    "arctan2",
    "arranged",
    "as_declared",
    "bibtex",
    "conditions",
    "cos_sin",
    "derivation_at",
    "derivations",
    "derivations_of",
    "differing_entries",
    "drivers",
    "evidence_lines",
    "folded",
    "identities",
    "import_root",
    "in_derived_terms",
    "in_names",
    "installed_papers",
    "judge",
    "kernels",
    "latex_of_name",
    "let",
    "located",
    "makes_section",
    "markdown",
    "named_latex",
    "null_vector",
    "numbered_with",
    "paper_folders",
    "publication",
    "quotations",
    "quotes_of",
    "select",
    "shown",
    "solution",
    "split",
    "statement_text",
]
