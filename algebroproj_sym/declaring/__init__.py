"""Declaring: what derivations state and ask for, and how each statement is judged."""

from algebroproj_sym.declaring.bibliography import Publication, bibtex, publication
from algebroproj_sym.declaring.claim import (
    GRADES,
    NUMBER_OF,
    VERDICTS,
    Claim,
    DeclarationError,
    Grade,
    Statement,
    Verdict,
    grade_of,
    in_derived_terms,
    statement_text,
)
from algebroproj_sym.declaring.discovery import (
    Derivation,
    UnknownSelectorError,
    derivation_at,
    derivations,
    derivations_of,
    derivations_with,
    drivers,
    kernels,
    kernels_on,
    located,
    numbered_with,
    quotes_of,
    select,
    split,
)
from algebroproj_sym.declaring.driver import Driver
from algebroproj_sym.declaring.elementary import ELEMENTARY, PRIMITIVES
from algebroproj_sym.declaring.elementary.arctan2 import arctan2
from algebroproj_sym.declaring.elementary.cos_sin import cos_sin
from algebroproj_sym.declaring.elementary.exp import exp
from algebroproj_sym.declaring.elementary.hypot import hypot
from algebroproj_sym.declaring.elementary.log import log
from algebroproj_sym.declaring.elementary.sqrt import sqrt
from algebroproj_sym.declaring.identities import Answer, Identity, MalformedFileError, identities
from algebroproj_sym.declaring.importing import BrokenModuleError, import_root
from algebroproj_sym.declaring.judging import Judgement, judge, judge_all
from algebroproj_sym.declaring.kernel import Argument, Kernel, Result
from algebroproj_sym.declaring.kinds import KINDS
from algebroproj_sym.declaring.primitive import Primitive
from algebroproj_sym.declaring.quotes import UNPARSED, UNQUOTED, Quotations, Quote, quotations
from algebroproj_sym.declaring.section import Section
from algebroproj_sym.declaring.stage import LINEAR, Stage, let, null_vector, solution
from algebroproj_sym.papers import installed_papers

__all__ = [
    "ELEMENTARY",
    "GRADES",
    "KINDS",
    "LINEAR",
    "NUMBER_OF",
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
    "Grade",
    "Identity",
    "Judgement",
    "Kernel",
    "MalformedFileError",
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
    "derivations_of",
    "derivations_with",
    "drivers",
    "exp",
    "grade_of",
    "hypot",
    "identities",
    "import_root",
    "in_derived_terms",
    "installed_papers",
    "judge",
    "judge_all",
    "kernels",
    "kernels_on",
    "let",
    "located",
    "log",
    "null_vector",
    "numbered_with",
    "publication",
    "quotations",
    "quotes_of",
    "select",
    "solution",
    "split",
    "sqrt",
    "statement_text",
]
