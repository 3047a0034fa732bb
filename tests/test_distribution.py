"""The wheel built from the tree works in an empty environment, from another directory, and adds no generic name."""

import json
import runpy
import subprocess
import sys
import venv
import zipfile

import pytest

TOP_LEVEL = {"algebroproj", "algebroproj_derivations", "algebroproj_sym"}


@pytest.fixture(scope="module")
def tree(tmp_path_factory, repository):
    """A copy of what the repository holds."""
    tree = tmp_path_factory.mktemp("tree")
    archive = subprocess.run(
        ["git", "-C", str(repository), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        check=True,
        capture_output=True,
    )
    for name in filter(None, archive.stdout.decode().split("\0")):
        source = repository / name
        if source.is_file():
            target = tree / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(source.read_bytes())
    return tree


@pytest.fixture(scope="module")
def wheel(tmp_path_factory, tree):
    folder = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "pip", "wheel", "--verbose", "--no-deps", "--wheel-dir", str(folder), str(tree)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    assert "would be ignored" not in done.stdout + done.stderr
    return next(folder.glob("*.whl"))


@pytest.fixture(scope="module")
def python(tmp_path_factory, wheel):
    """An environment with the wheel and what it requires, and nothing else."""
    folder = tmp_path_factory.mktemp("environment")
    venv.create(folder, with_pip=True)
    executable = folder / "bin" / "python"
    install = [str(executable), "-m", "pip", "install", "--quiet", str(wheel)]
    subprocess.run(install, check=True, capture_output=True)
    return executable


def run(python, *arguments, cwd):
    return subprocess.run([str(python), *arguments], cwd=cwd, capture_output=True, text=True, check=True).stdout


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
def test_the_generated_package_imports_numpy_alone(python, tmp_path):
    code = (
        "import sys, json; before = set(sys.modules); import numpy; with_numpy = set(sys.modules); "
        "import algebroproj, algebroproj.affine, algebroproj.projection, algebroproj.space, algebroproj.optics; "
        "new = {name.split('.')[0] for name in set(sys.modules) - with_numpy} - set(sys.stdlib_module_names); "
        "print(json.dumps(sorted(new)))"
    )
    assert set(json.loads(run(python, "-c", code, cwd=tmp_path))) <= {"algebroproj", "numpy"}


@pytest.mark.whole
def test_the_command_line_works_from_another_directory(python, tmp_path):
    checked = json.loads(
        run(python, "-m", "algebroproj_sym", "check", "fundamentals1996:1.2", "--format", "json", cwd=tmp_path)
    )
    assert checked["summary"]["proved"] > 0
    run(python, "-m", "algebroproj_sym", "generate", "--derivations", "normalcase1992", cwd=tmp_path)
    assert (tmp_path / "generated" / "algebroproj" / "metric.py").is_file()
    figures = json.loads(
        run(python, "-m", "algebroproj_sym", "verify", "optics", "--samples", "2", "--format", "json", cwd=tmp_path)
    )
    assert figures["functions"]
    assert all(function["passed"] for function in figures["functions"])
