"""Declaring: what derivations state and ask for, how each statement is judged and how it shows itself."""

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
from algebroproj_sym.declaring.dependencies import needed_by
from algebroproj_sym.declaring.difference import differing_entries
from algebroproj_sym.declaring.discovery import (
    Derivation,
    Outline,
    UnknownSelectorError,
    derivation_at,
    derivations,
    derivations_in,
    derivations_of,
    drivers,
    installed_papers,
    kernels,
    located,
    modules_of_papers,
    numbered_with,
    outline,
    require_consistent,
    select,
    split,
)
from algebroproj_sym.declaring.display import evidence_lines, markdown
from algebroproj_sym.declaring.driver import Driver
from algebroproj_sym.declaring.identities import Answer, Identity, MalformedFileError, identities
from algebroproj_sym.declaring.importing import BrokenModuleError, import_root, makes_section
from algebroproj_sym.declaring.judging import Judgement, judge
from algebroproj_sym.declaring.kernel import Argument, Kernel, Result
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
    "Outline",
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
    "bibtex",
    "cos_sin",
    "derivation_at",
    "derivations",
    "derivations_in",
    "derivations_of",
    "differing_entries",
    "drivers",
    "evidence_lines",
    "identities",
    "import_root",
    "in_derived_terms",
    "installed_papers",
    "judge",
    "kernels",
    "let",
    "located",
    "makes_section",
    "markdown",
    "modules_of_papers",
    "needed_by",
    "null_vector",
    "numbered_with",
    "outline",
    "publication",
    "quotations",
    "require_consistent",
    "select",
    "solution",
    "split",
    "statement_text",
]
