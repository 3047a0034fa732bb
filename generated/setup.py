"""The extension module, which is compiled where there is a C compiler; see pyproject.toml for all else."""

import sys
from pathlib import Path

from setuptools import setup

sys.path.insert(0, str(Path(__file__).parent))
from compiling import Build, Wheel, extension

setup(ext_modules=[extension("algebroproj")], cmdclass={"bdist_wheel": Wheel, "build_ext": Build})
