"""Checking the evidence for statements in letters: their text, their expansion into entries, and proofs in words."""

from algebroproj_sym.replaying.letters.checking import require_in_letters
from algebroproj_sym.replaying.letters.expansion import require_expansion
from algebroproj_sym.replaying.letters.statement import read_alone

__all__ = ["read_alone", "require_expansion", "require_in_letters"]
