"""The NumPy backend: a Python package whose functions are NumPy source, with the C backend's module inside."""

from algebroproj_sym.generating.backends.numpy.package import render

__all__ = ["render"]
