"""The extension module of the compiled twin, which is left out where there is no C compiler; see pyproject.toml."""

import sys

import numpy
from setuptools import Extension, setup

# No contraction of operations and no option that changes values: the results are those of the NumPy source, bit by bit.
VECTORISED = ["-O2", "-ftree-loop-vectorize", "-fvect-cost-model=dynamic", "-fno-tree-slp-vectorize"]
# Rows of constants are written as the others are: a call to fill 500 bytes takes longer.
AS_WRITTEN = ["-ffp-contract=off", "-fno-tree-loop-distribute-patterns"]
OPTIONS = ["/fp:precise"] if sys.platform == "win32" else ["-std=c99", "-g0", *VECTORISED, *AS_WRITTEN]
HEADERS = ("_kernels", "_systems", "_moves", "_loops", "_fours", "_plain_kernels", "_plain_loops", "_calls")

setup(
    ext_modules=[
        Extension(
            "algebroproj._compiled",
            ["algebroproj/_compiled.c"],
            depends=[f"algebroproj/{name}.h" for name in HEADERS],
            include_dirs=[numpy.get_include()],
            extra_compile_args=OPTIONS,
            optional=True,
        )
    ]
)
