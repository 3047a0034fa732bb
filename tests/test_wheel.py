"""The generated package alone: a wheel of it installs and runs with NumPy and nothing else."""

import ast
import importlib
import os
import shutil
import subprocess
import sys
import time
import tomllib
import zipfile

import pytest
from setuptools import Distribution, Extension

import algebroproj
import algebroproj_sym
from algebroproj_sym.generating.writing import PACKAGE

PROGRAM = """
import sys
sys.meta_path.insert(0, type("Nothing", (), {"find_spec": staticmethod(lambda name, path=None, target=None: (
    (_ for _ in ()).throw(ModuleNotFoundError(name)) if name.partition(".")[0] in FORBIDDEN else None))}))
import algebroproj
from algebroproj import correlation, projection
assert algebroproj.__file__.startswith(sys.argv[1]), algebroproj.__file__
print(projection.projection_matrix([0.5, 0.25, 2.0], [0.25, 0.5]).shape, len(correlation.epipoles.__doc__) > 0)
"""

ALONE = """
import sys
sys.meta_path = [finder for finder in sys.meta_path if "editable" not in str(finder)]
import algebroproj
print(algebroproj.backend(), algebroproj.optics.scale(1.0, 2.0))
"""


@pytest.fixture(scope="module")
def declared(repository):
    return tomllib.loads((repository / "generated" / "pyproject.toml").read_text(encoding="utf-8"))


def test_it_needs_numpy_alone(declared):
    assert [entry.partition(">")[0] for entry in declared["project"]["dependencies"]] == ["numpy"]


def test_its_python_is_that_of_the_project(declared, repository):
    whole = tomllib.loads((repository / "pyproject.toml").read_text(encoding="utf-8"))
    assert declared["project"]["requires-python"] == whole["project"]["requires-python"]
    assert whole["project"]["license"] == f"{declared['project']['license']} AND OFL-1.1"
    assert declared["project"]["dependencies"][0] in whole["project"]["dependencies"]


def test_there_is_one_version(repository):
    citation = (repository / "CITATION.cff").read_text(encoding="utf-8")
    assert algebroproj.__version__ == algebroproj_sym.__version__
    assert f"\nversion: {algebroproj_sym.__version__}\n" in citation


def test_its_licence_is_that_of_the_project(repository):
    assert (repository / "generated" / "LICENSE").read_bytes() == (repository / "LICENSE").read_bytes()


def test_its_source_is_valid_for_the_oldest_python(repository):
    for path in sorted((repository / "generated" / PACKAGE).glob("*.py")):
        ast.parse(path.read_text(encoding="utf-8"), feature_version=(3, 11))


def test_it_runs_where_there_is_nothing_but_numpy(repository):
    forbidden = {"algebroproj_sym", "sympy", "mpmath", "flint", "jinja2", "click", "rich", "scipy"}
    program = f"FORBIDDEN = {sorted(forbidden)}\n{PROGRAM}"
    folder = str(repository / "generated")
    done = subprocess.run(
        [sys.executable, "-c", program, folder], capture_output=True, text=True, check=True, env={"PYTHONPATH": folder}
    )
    assert done.stdout == "(3, 3) True\n"


TINY = """
#include <Python.h>
static struct PyModuleDef module = {PyModuleDef_HEAD_INIT, "tiny", NULL, -1, NULL};
PyMODINIT_FUNC PyInit_tiny(void)
{
    PyObject *made = PyModule_Create(&module);
    PyModule_AddIntConstant(made, "number", NUMBER);
    return made;
}
"""


@pytest.fixture
def built(repository, tmp_path, monkeypatch):
    """Build a module of a few lines as the functions are built, and return how its number came out."""
    monkeypatch.syspath_prepend(repository / "generated")
    monkeypatch.chdir(tmp_path)
    compiling = importlib.import_module("compiling")
    source = tmp_path / "_c" / "tiny.c"
    source.parent.mkdir()

    def build(number, age=0.0, editable=True):
        source.write_text(f"#define NUMBER {number}\n{TINY}", encoding="utf-8")
        os.utime(source, (time.time() - age,) * 2)
        module = Extension("tiny", [str(source)], extra_compile_args=compiling.OPTIONS)
        command = compiling.Build(Distribution({"ext_modules": [module], "script_name": "setup.py"}))
        folder = tmp_path / f"{number}"
        command.build_lib, command.build_temp, command.editable_mode = str(folder), str(folder), editable
        command.ensure_finalized()
        command.run()
        program = "import tiny; print(tiny.number)"
        place = tmp_path if editable else folder
        done = subprocess.run([sys.executable, "-c", program], cwd=place, capture_output=True, text=True, check=True)
        return int(done.stdout)

    return build


def test_an_editable_installation_compiles_again_what_has_changed_and_nothing_else(built):
    assert built(1) == 1
    assert built(2, age=3600.0) == 1
    assert built(3, age=-60.0) == 3
    assert built(4, age=3600.0, editable=False) == 4


def test_what_cannot_be_built_in_parallel_is_built_in_one_piece(built, monkeypatch):
    compiling = importlib.import_module("compiling")
    monkeypatch.setattr(compiling.os, "cpu_count", lambda: "no number")
    assert built(5) == 5


@pytest.mark.whole
def test_without_a_c_compiler_it_is_built_all_the_same_and_runs_the_numpy_source(repository, tmp_path):
    tree = shutil.copytree(
        repository / "generated", tmp_path / "tree", ignore=shutil.ignore_patterns("*.so", "*.pyd", "__pycache__")
    )
    command = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", str(tmp_path), str(tree)]
    no_compiler = {"CC": str(tmp_path / "no-compiler"), "CXX": str(tmp_path / "no-compiler")}
    subprocess.run(command, check=True, capture_output=True, env=os.environ | no_compiler)
    (wheel,) = tmp_path.glob("*.whl")
    names = zipfile.ZipFile(wheel).namelist()
    assert {name.split("/")[0].partition("-")[0] for name in names} == {PACKAGE}
    assert {f"{PACKAGE}/accuracy.json", f"{PACKAGE}/py.typed"} <= {*names}
    assert [name for name in names if name.endswith("/licenses/LICENSE")]
    assert not [name for name in names if name.endswith((".so", ".pyd", ".c", ".h"))]
    assert wheel.name.endswith("-py3-none-any.whl")
    installed = tmp_path / "installed"
    zipfile.ZipFile(wheel).extractall(installed)
    done = subprocess.run([sys.executable, "-c", ALONE], cwd=installed, capture_output=True, text=True, check=True)
    assert done.stdout.startswith("numpy 0.333")
