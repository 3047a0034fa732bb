"""The README is true: its commands are what CI runs, its output is what they print."""

import doctest
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

README = (Path(__file__).resolve().parent.parent / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```console\n\$ (.*?)\n(.*?)\n```", README, flags=re.DOTALL)


def test_the_readme_shows_commands():
    assert len(BLOCKS) >= 5


@pytest.mark.parametrize(("command", "output"), BLOCKS, ids=[command for command, _ in BLOCKS])
def test_commands_print_what_the_readme_shows(command, output, tmp_path):
    program, *arguments = shlex.split(command)
    assert program == "algebroproj"
    result = subprocess.run(
        [sys.executable, "-m", "algebroproj_sym", *arguments], capture_output=True, text=True, check=True, cwd=tmp_path
    )
    assert [line.rstrip() for line in result.stdout.rstrip().split("\n")] == output.split("\n")


def test_python_examples_run():
    failures, tests = doctest.testfile("../README.md", optionflags=doctest.NORMALIZE_WHITESPACE)
    assert tests > 5
    assert failures == 0


def test_the_two_commands_are_what_ci_runs(repository):
    commands = re.search(r"```sh\n(.*?)```", README, flags=re.DOTALL).group(1).strip().split("\n")
    assert len(commands) == 2
    script = (repository / ".ci" / "run").read_text(encoding="utf-8")
    assert all(command in script for command in commands)
    assert os.access(repository / ".ci" / "run", os.X_OK)


def test_every_option_and_command_the_readme_names_exists():
    helps = [subprocess.run([sys.executable, "-m", "algebroproj_sym", "--help"], capture_output=True, text=True).stdout]
    for name in set(re.findall(r"`algebroproj (\w+)", README)):
        assert name in helps[0]
