"""Which folder is which package, and the extension module; see pyproject.toml for all else."""

import sys
from pathlib import Path

from setuptools import find_packages, setup

sys.path.insert(0, str(Path(__file__).parent / "generated"))
from compiling import Build, extension

FOLDERS = {
    "algebroproj": "generated/algebroproj",
    "algebroproj_derivations": "derivations",
    "algebroproj_sym": "algebroproj_sym",
}

setup(
    packages=[*FOLDERS, *(f"{name}.{inner}" for name, folder in FOLDERS.items() for inner in find_packages(folder))],
    package_dir=FOLDERS,
    ext_modules=[extension(FOLDERS["algebroproj"])],
    cmdclass={"build_ext": Build},
)
