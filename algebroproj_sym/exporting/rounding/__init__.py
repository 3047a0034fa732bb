"""A-priori error bounds as theorems for Coq: programs, certificates and bounds, for a checker that is proved sound.

`Rounding.v` has what Flocq proves of binary64, `Pairs.v` what follows for numbers kept as two, `Checker.v` the checker.
`Ranges.v` follows exponents, so that `Machine.v` can conclude what the machine computes.  `Exact.v` compares exact
values with formulas, and `Instances.v` finds that hypotheses can hold.  `theorems` writes a file for each function,
whose proof is a computation of these.
"""

from algebroproj_sym.exporting.rounding.theorems import CHECKER, accuracy_of, render

__all__ = ["CHECKER", "accuracy_of", "render"]
