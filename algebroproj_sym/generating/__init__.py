"""Generating: from a kernel to a straight-line program to NumPy and C source.

graph (expressions without signs and repetitions) → sharing (common pairs) → lowering (a proved program)
→ compensation (twice the digits where sums may cancel) → choosing (among equal forms, on samples) → numpy_source;
expansion (single numbers again) → c_source; plain_source (C without compensation); package (all files).  runtime has
what the generated package brings along.
"""

from algebroproj_sym.generating.c_source import c_files, c_name, is_compiled, is_compiled_plain
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.compensation import compensated
from algebroproj_sym.generating.lowering import Lowered, LoweringError
from algebroproj_sym.generating.measured import Measured, measured_errors, recorded_errors
from algebroproj_sym.generating.operation_counts import OperationCounts, operation_counts
from algebroproj_sym.generating.package import PACKAGE, drift, render, superfluous, write
from algebroproj_sym.generating.plain_source import plain_files
from algebroproj_sym.generating.program import Call, Program, Step, run

__all__ = [
    "PACKAGE",
    "Call",
    "Lowered",
    "LoweringError",
    "Measured",
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
    "measured_errors",
    "operation_counts",
    "plain_files",
    "recorded_errors",
    "render",
    "run",
    "superfluous",
    "write",
]
