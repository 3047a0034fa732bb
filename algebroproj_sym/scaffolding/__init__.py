"""Scaffolding: a derivation folder to start from."""

from algebroproj_sym.scaffolding.folder import InvalidNameError, OccupiedError, create

__all__ = ["InvalidNameError", "OccupiedError", "create"]
