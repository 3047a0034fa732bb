"""The C backend: generalized ufuncs of NumPy, which give the bits of the NumPy source."""

from algebroproj_sym.generating.backends.c.plain import plain_files
from algebroproj_sym.generating.backends.c.printer import c_files, c_name, is_compiled, is_compiled_plain

__all__ = ["c_files", "c_name", "is_compiled", "is_compiled_plain", "plain_files"]
