"""The wheel built from the tree works in an empty environment, from another directory, and adds no generic name."""

import importlib
import json
import os
import runpy
import shutil
import subprocess
import sys
import zipfile

import pytest

TOP_LEVEL = {"algebroproj", "algebroproj_derivations", "algebroproj_sym"}


@pytest.fixture(scope="module")
def tree(made_once, repository):
    """A copy of what the repository holds."""

    def copied(tree):
        command = ["git", "-C", str(repository), "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        listed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        for name in filter(None, listed.split("\0")):
            if (repository / name).is_file():
                (tree / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(repository / name, tree / name)

    return made_once("tree", copied)


@pytest.fixture(scope="module")
def wheel(made_once, tree):
    """The wheel.  Its module is the one that is installed, which was compiled from the same source."""

    def built(folder):
        compiler, module = folder / "compiler", importlib.import_module("algebroproj._compiled").__file__
        take = f'[ "$before" = -o ] && exec cp "{module}" "$word"'
        compiler.write_text(f"#!/bin/sh\nfor word; do {take}; before=$word; done\n", encoding="utf-8")
        compiler.chmod(0o755)
        options = ["--verbose", "--no-deps", "--no-build-isolation", "--wheel-dir", folder]
        command = [sys.executable, "-m", "pip", "wheel", *options, tree]
        environment = os.environ | {"CC": str(compiler)}
        done = subprocess.run(command, check=True, capture_output=True, text=True, env=environment)
        assert "would be ignored" not in done.stdout + done.stderr

    (found,) = made_once("wheel", built).glob("*.whl")
    return found


@pytest.fixture(scope="module")
def installed(made_once, wheel):
    """The folder where the wheel is installed; what it requires is installed already."""

    def install(folder):
        command = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--target", folder, wheel]
        subprocess.run(command, check=True, capture_output=True)

    return made_once("installed", install)


def run(installed, *arguments, cwd):
    """Run Python elsewhere, where packages of that folder are found before those of the repository."""
    environment = os.environ | {"PYTHONPATH": str(installed)}
    command = [sys.executable, *arguments]
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=True, env=environment).stdout


def test_an_older_python_is_refused_in_one_sentence(repository, monkeypatch):
    monkeypatch.setattr(sys, "version_info", (3, 10, 13))
    with pytest.raises(SystemExit, match=r"^algebroproj-sym needs Python 3\.11 or later, and this is Python "):
        runpy.run_path(str(repository / "setup.py"))


@pytest.mark.whole
def test_the_wheel_adds_no_generic_top_level_name(wheel):
    names = {name.split("/")[0] for name in zipfile.ZipFile(wheel).namelist()}
    assert {name for name in names if not name.endswith(".dist-info")} == TOP_LEVEL


@pytest.mark.whole
def test_every_file_of_the_packages_is_in_the_wheel_and_nothing_else(wheel, tree):
    folders = {
        "algebroproj": tree / "generated" / "algebroproj",
        "algebroproj_derivations": tree / "derivations",
        "algebroproj_sym": tree / "algebroproj_sym",
    }
    files = {
        f"{name}/{path.relative_to(folder).as_posix()}"
        for name, folder in folders.items()
        for path in folder.rglob("*")
        if path.is_file()
    }
    contents = zipfile.ZipFile(wheel).namelist()
    assert {name for name in contents if ".dist-info/" not in name and not name.endswith((".so", ".pyd"))} == files


@pytest.mark.whole
def test_the_wheel_is_for_the_platform_that_it_was_compiled_for(wheel):
    assert any(name.endswith((".so", ".pyd")) for name in zipfile.ZipFile(wheel).namelist())
    assert not wheel.name.endswith("-any.whl")


@pytest.mark.whole
def test_the_generated_package_imports_numpy_alone(installed, tmp_path):
    code = (
        "import sys, json; before = set(sys.modules); import numpy; with_numpy = set(sys.modules); "
        "import algebroproj, algebroproj.affine, algebroproj.projection, algebroproj.space, algebroproj.optics; "
        "new = {name.split('.')[0] for name in set(sys.modules) - with_numpy} - set(sys.stdlib_module_names); "
        "print(json.dumps([algebroproj.__file__, algebroproj.backend(), *sorted(new)]))"
    )
    file, backend, *new = json.loads(run(installed, "-c", code, cwd=tmp_path))
    assert (file, backend) == (str(installed / "algebroproj" / "__init__.py"), "compiled")
    assert set(new) <= {"algebroproj", "numpy"}


@pytest.mark.whole
def test_the_command_line_works_from_another_directory(installed, tmp_path):
    program = ["-m", "algebroproj_sym"]
    checked = json.loads(run(installed, *program, "check", "fundamentals1996:1.2", "--format", "json", cwd=tmp_path))
    assert checked["summary"]["proved"] > 0
    run(installed, *program, "generate", "--derivations", "normalcase1992", cwd=tmp_path)
    assert (tmp_path / "generated" / "algebroproj" / "metric.py").is_file()
    figures = json.loads(
        run(installed, *program, "verify", "optics", "--samples", "2", "--format", "json", cwd=tmp_path)
    )
    assert figures["functions"]
    assert all(function["passed"] for function in figures["functions"])
