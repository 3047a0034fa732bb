"""How the C source becomes the extension module, in this project and in the one that holds the derivations.

A module is compiled where there is a C compiler, and left out where there is none.  GCC compiles parts of it at the same
time, on all cores.
"""

import os
import subprocess
import sys
from pathlib import Path

import numpy
from setuptools import Extension
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_ext import build_ext
from setuptools.errors import CCompilerError, ExecError

# No contraction of operations and no option that changes values: the results are those of the NumPy source, bit by bit.
VECTORISED = ["-O2", "-ftree-loop-vectorize", "-fvect-cost-model=dynamic", "-fno-tree-slp-vectorize"]
# Rows of constants are written as the others are: a call to fill 500 bytes takes longer.
AS_WRITTEN = ["-ffp-contract=off", "-fno-tree-loop-distribute-patterns"]
# Without these passes, and without vectors for the last points, GCC takes half the time, and functions take 0 to 5 % more
# (one 15 %).
SOON = ["-fno-schedule-insns2", "-fira-algorithm=priority", "-fira-region=one", "-fno-rerun-cse-after-loop"]
SOON += ["--param=vect-epilogues-nomask=0"]
OPTIONS = ["/fp:precise"] if sys.platform == "win32" else ["-std=c99", "-g0", *VECTORISED, *AS_WRITTEN]


def extension(folder):
    """Return the extension module whose source is in a folder."""
    source = Path(folder) / "_c" / "compiled.c"
    headers = sorted(str(path) for path in source.parent.glob("*.h"))
    return Extension(
        "algebroproj._compiled",
        [source.as_posix()],
        depends=[*headers, __file__],
        include_dirs=[numpy.get_include()],
        extra_compile_args=OPTIONS,
        optional=True,
    )


class Build(build_ext):
    """Compile on all cores, and not again what an editable installation has compiled."""

    def build_extension(self, extension):
        """Take the module that lies beside its source if it is newer than the source, or else compile it."""
        sources = [Path(name) for name in (*extension.sources, *extension.depends)]
        before = sources[0].parent.parent / Path(self.get_ext_filename(extension.name)).name
        if self.editable_mode and before.exists() and all(_older(source, before) for source in sources):
            self.mkpath(str(Path(self.get_ext_fullpath(extension.name)).parent))
            self.copy_file(str(before), self.get_ext_fullpath(extension.name))
        elif not (_is_gcc(self.compiler.compiler_so[0]) and self._built_in_parallel(extension)):
            super().build_extension(extension)

    def _built_in_parallel(self, extension):
        extension.extra_compile_args = [*OPTIONS, *SOON, "-flto", "-fno-fat-lto-objects"]
        extension.extra_link_args = [*OPTIONS, *SOON, f"-flto={os.cpu_count() or 1}"]
        try:
            super().build_extension(extension)
        except (CCompilerError, ExecError):
            extension.extra_compile_args, extension.extra_link_args = OPTIONS, []
            return False
        return True


class Wheel(bdist_wheel):
    """A wheel for this platform where the module was compiled, and for every platform where it was not."""

    def run(self):
        """Compile first."""
        self.run_command("build_ext")
        compiled = self.get_finalized_command("build_ext")
        if not any(Path(compiled.get_ext_fullpath(module.name)).exists() for module in compiled.extensions):
            self.root_is_pure, self.distribution.ext_modules = True, None
        super().run()


def _older(source, module):
    return source.stat().st_mtime <= module.stat().st_mtime


def _is_gcc(compiler):
    try:
        version = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return False
    return "Free Software Foundation" in version
