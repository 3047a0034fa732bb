"""Which folder is which package, and the extension module; see pyproject.toml for all else."""

import sys
from pathlib import Path

from setuptools import find_packages, setup

# pip asks for the extras before it compares versions of Python, and then names a requirement that it cannot find.
if sys.version_info < (3, 11):  # noqa: UP036
    sys.exit(f"algebroproj-sym needs Python 3.11 or later, and this is Python {sys.version.split()[0]}.")

sys.path.insert(0, str(Path(__file__).parent / "generated"))
from compiling import Build, Wheel, extension

FOLDERS = {
    "algebroproj": "generated/algebroproj",
    "algebroproj_derivations": "derivations",
    "algebroproj_sym": "algebroproj_sym",
}

setup(
    packages=[*FOLDERS, *(f"{name}.{inner}" for name, folder in FOLDERS.items() for inner in find_packages(folder))],
    package_dir=FOLDERS,
    ext_modules=[extension(FOLDERS["algebroproj"])],
    cmdclass={"bdist_wheel": Wheel, "build_ext": Build},
)
