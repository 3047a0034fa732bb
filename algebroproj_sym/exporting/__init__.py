"""Exporting: theorems for Coq's kernel, from the statement and the evidence of each claim of the ledger.

The stages are the modules: a form of the ledger is read as `terms`; `divisions` finds how divisors split; `theorems`
and `points` state and prove what follows from hypotheses and what holds at a point; `claims` does so for each kind of
claim; `files` lays theorems out in files; `compiling` has them checked.
"""

from algebroproj_sym.exporting.compiling import Compiled, NoCompilerError, compiled, compiled_lemmas, require_compiler
from algebroproj_sym.exporting.files import UNEXPORTED, Exported, export, exported, render
from algebroproj_sym.exporting.refusal import NotExportable

__all__ = [
    "UNEXPORTED",
    "Compiled",
    "Exported",
    "NoCompilerError",
    "NotExportable",
    "compiled",
    "compiled_lemmas",
    "export",
    "exported",
    "render",
    "require_compiler",
]
