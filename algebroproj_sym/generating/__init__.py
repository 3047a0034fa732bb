"""Generating: from a kernel to a straight-line program to source.

graph (expressions without signs and repetitions) → sharing (common pairs) → lowering (a proved program)
→ compensation (twice the digits where sums may cancel) → choosing (among equal forms, on samples) → backends (a folder
each; expansion makes single numbers again for those that need it) → writing.  runtime has what the generated NumPy
package brings along.
"""

from algebroproj_sym.generating.backends import BACKENDS, Backend
from algebroproj_sym.generating.backends.c import c_files, c_name, is_compiled, is_compiled_plain, plain_files
from algebroproj_sym.generating.backends.numpy import render
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.compensation import compensated
from algebroproj_sym.generating.lowering import Lowered, LoweringError
from algebroproj_sym.generating.operation_counts import OperationCounts, operation_counts
from algebroproj_sym.generating.program import Call, Program, Step, run
from algebroproj_sym.generating.writing import PACKAGE, drift, superfluous, write

__all__ = [
    "BACKENDS",
    "PACKAGE",
    "Backend",
    "Call",
    "Lowered",
    "LoweringError",
    "OperationCounts",
    "Program",
    "Step",
    "c_files",
    "c_name",
    "compensated",
    "drift",
    "is_compiled",
    "is_compiled_plain",
    "lower",
    "operation_counts",
    "plain_files",
    "render",
    "run",
    "superfluous",
    "write",
]
