"""Statements with real functions: what decides them."""

from algebroproj_sym.proving.reals.prove import decided

__all__ = ["decided"]
