"""Generating: from a kernel to a straight-line program to NumPy source.

graph (expressions without signs and repetitions) → sharing (common pairs) → lowering (a proved program)
→ numpy_source and package (text).
"""

from algebroproj_sym.generating.compensation import compensated
from algebroproj_sym.generating.lowering import Lowered, LoweringError, lower
from algebroproj_sym.generating.operation_counts import OperationCounts, operation_counts
from algebroproj_sym.generating.package import PACKAGE, drift, render, superfluous, write
from algebroproj_sym.generating.program import Call, Program, Step, run

__all__ = [
    "PACKAGE",
    "Call",
    "Lowered",
    "LoweringError",
    "OperationCounts",
    "Program",
    "Step",
    "compensated",
    "drift",
    "lower",
    "operation_counts",
    "render",
    "run",
    "superfluous",
    "write",
]
