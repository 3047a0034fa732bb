"""The README is true: its commands are what CI runs, its blocks do and print what it shows."""

import os
import re
import subprocess
import sys

import pytest
from pages import DOCS, README, blocks, compared, perform

TEXT = README.read_text(encoding="utf-8")


def test_it_can_be_read_in_a_few_minutes():
    assert len(TEXT.splitlines()) <= 150


@pytest.mark.whole
def test_every_block_is_run_and_prints_what_is_shown(tmp_path, monkeypatch):
    languages = [language for language, _, _ in blocks(README)]
    assert languages.count("console") >= 2
    assert languages.count("python") >= 3
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    perform(README, tmp_path, compared)


def test_the_two_commands_are_what_ci_runs(repository):
    commands = re.search(r"```sh\n(.*?)```", TEXT, flags=re.DOTALL).group(1).strip().split("\n")
    assert len(commands) == 2
    script = (repository / ".ci" / "run").read_text(encoding="utf-8")
    assert all(command in script for command in commands)
    assert os.access(repository / ".ci" / "run", os.X_OK)


def test_every_command_it_names_exists():
    help = subprocess.run([sys.executable, "-m", "algebroproj_sym", "--help"], capture_output=True, text=True).stdout
    names = set(re.findall(r"(?:`|\$ |bin/)algebroproj (\w+)", TEXT))
    assert len(names) >= 4
    for name in names:
        assert re.search(rf"^  {name} ", help, flags=re.MULTILINE), name


def test_every_file_and_picture_it_links_to_is_there(repository):
    links = re.findall(r"\]\(([^)#]+)\)", TEXT)
    assert any(link.endswith(".png") for link in links)
    for link in links:
        assert (repository / link).is_file(), link
    assert sum(link.startswith(DOCS.name) for link in links) > 8
