"""A-priori error bounds as theorems for Coq: programs, certificates and bounds, for a checker that is proved sound.

`Rounding.v` has what Flocq proves of binary64, `Pairs.v` what follows for numbers kept as two, `Checker.v` the checker;
`theorems` writes a file for each function, whose proof is a computation of that checker.
"""

from algebroproj_sym.exporting.rounding.theorems import ALLOWED, CHECKER, Accuracy, accuracy_of, render

__all__ = ["ALLOWED", "CHECKER", "Accuracy", "accuracy_of", "render"]
