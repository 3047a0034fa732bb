"""The tutorial is true: its blocks are executed, in their order and in an empty folder, and print what it shows."""

import doctest
import re
import shlex
import subprocess
import sys
from pathlib import Path

TUTORIAL = (Path(__file__).resolve().parent.parent / "docs" / "tutorial.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```(\w+)\n(.*?)\n```", TUTORIAL, flags=re.DOTALL)
PROGRAMS = {"algebroproj": "algebroproj_sym", "pytest": "pytest"}


def lines(text):
    """The lines of an output, but for spaces at their ends and the time that pytest took."""
    return [re.sub(r" in [\d.]+s$", "", line.rstrip()) for line in text.rstrip().split("\n")]


def run(command, folder):
    program, *arguments = shlex.split(command)
    if program == "rm":
        (folder / arguments[0]).unlink()
        return ""
    command = [sys.executable, "-m", PROGRAMS[program], *arguments]
    if program == "pytest":
        command += ["-p", "no:cacheprovider"]
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    status = f"[exit status {result.returncode}]\n" if result.returncode else ""
    return result.stdout + result.stderr + status


def session(block, folder):
    for command, output in re.findall(r"^\$ (.*)\n?((?:(?!\$ ).*\n?)*)", block, flags=re.MULTILINE):
        assert lines(run(command, folder)) == lines(output), command


def write(block, folder):
    """Write a module whose first line names it, append to it, or replace its last line."""
    heading, _, text = block.partition("\n")
    name, _, how = heading.removeprefix("# ").partition(", ")
    path = folder / name
    before = path.read_text(encoding="utf-8") if how else ""
    kept = "\n".join(before.rstrip("\n").split("\n")[:-1]) if how == "last line" else before
    path.write_text(f"{kept}\n{text}\n" if how else f"{text}\n", encoding="utf-8")


def interpret(block, folder, monkeypatch):
    monkeypatch.chdir(folder)
    monkeypatch.syspath_prepend(folder)
    test = doctest.DocTestParser().get_doctest(block, {}, "tutorial", None, 0)
    assert len(test.examples) > 1
    assert doctest.DocTestRunner().run(test).failed == 0


def test_every_block_is_executed_and_prints_what_is_shown(tmp_path, monkeypatch):
    assert {language for language, _ in BLOCKS} == {"sh", "console", "python"}
    for language, block in BLOCKS:
        if language == "console":
            session(block, tmp_path)
        elif language == "python" and block.startswith(">>> "):
            interpret(block, tmp_path, monkeypatch)
        elif language == "python":
            write(block, tmp_path)


def test_the_installation_is_that_of_the_readme(repository):
    (installation,) = [block for language, block in BLOCKS if language == "sh"]
    readme = (repository / "README.md").read_text(encoding="utf-8")
    assert installation.partition(" && source")[0] in readme
