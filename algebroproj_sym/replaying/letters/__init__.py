"""Checking the evidence for statements in letters: their text, their expansion into entries, and proofs in words."""

from algebroproj_sym.replaying.letters.checking import require_in_letters

__all__ = ["require_in_letters"]
