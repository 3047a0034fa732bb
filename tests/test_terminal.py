"""Nothing from a file or a derivation reaches a terminal as anything but characters that one sees."""

import json

import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.cli import main
from algebroproj_sym.cli.terminal import visible

ESCAPES = (
    "\x1b[31m",
    "\x1b]0;title\x07",
    "\x9b2J",
    "\u202e",
    "\u2066",
    "\r",
    "\x08",
    "\x7f",
    "\u2028",
    "\ufeff",
    "\x00",
)
HOSTILE = "".join(ESCAPES)
DERIVATION = """
import sympy
from algebroproj_sym import Section

x = sympy.Symbol("x")
section = Section("demo", "1", "Demonstration")
section.identity("1.1", "a title", printed=x, derived=x + 1, corrected=1 + x, expect="misprint", note={note!r})
section.identity("1.2", "another", printed=x, derived=x + 1, note={note!r})
"""


def run(*arguments):
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


def shows_all(text):
    return not any(character in text for escape in ESCAPES for character in escape if not character.isprintable())


@given(st.text())
def test_a_visible_text_is_read_back_and_has_nothing_hidden(text):
    shown = visible(text)
    assert not {*shown} & {*HOSTILE} - {*"[]0;title2J31m"}
    assert json.loads(visible(json.dumps(text, ensure_ascii=False))) == text
    assert visible(text, line=True).count("\n") == 0


def test_what_is_seen_stays():
    text = "α + x' = √2 · Ω\n\té 漢字"
    assert visible(text) == text


@pytest.mark.usefixtures("decided_here")
@pytest.mark.parametrize("form", ["text", "json"])
@pytest.mark.parametrize("key", ["lhs", "rhs", "constraints", "expected", "variables"])
def test_a_file_of_identities(tmp_path, key, form):
    item = {"name": "x", "lhs": "x", "rhs": "x"} | {key: [HOSTILE] if key in ("constraints", "variables") else HOSTILE}
    path = tmp_path / "mine.json"
    path.write_text(json.dumps([item]), encoding="utf-8")
    result = run("check", path, "--format", form)
    assert result.exit_code == 2
    assert shows_all(result.output)


@pytest.mark.parametrize("name", [*ESCAPES, "two\nlines"])
def test_a_name_is_one_line_that_one_sees(tmp_path, name):
    path = tmp_path / "mine.json"
    path.write_text(json.dumps([{"name": f"x{name}", "lhs": "x", "rhs": "x"}]), encoding="utf-8")
    result = run("check", path)
    assert result.exit_code == 2
    assert "key 'name': expected text on one line" in result.output
    assert shows_all(result.output)


@pytest.mark.parametrize(
    "command", [["check"], ["explain"], ["explain", "--format", "markdown"], ["check", "--format", "json"]]
)
def test_notes_of_claims(tmp_path, command):
    path = tmp_path / "s1.py"
    path.write_text(DERIVATION.replace("{note!r}", ascii(HOSTILE)), encoding="utf-8")
    result = run(*command, path)
    assert result.exit_code in (0, 1)
    assert "another" in result.output
    assert shows_all(result.output)


@pytest.mark.parametrize("form", ["text", "json"])
def test_a_ledger(tmp_path, form):
    claim = dict.fromkeys(("paper", "number", "kind", "title", "note", "printed", "derived"), HOSTILE + "\n1 replayed")
    ledger = {"schema": 1, "claims": [claim | {"verdict": "proved"}], "summary": {"proved": 1}}
    path = tmp_path / "ledger.json"
    path.write_text(json.dumps(ledger), encoding="utf-8")
    result = run("replay", path, "--format", form)
    assert result.exit_code in (1, 2)
    assert shows_all(result.output)
    assert not any(line.startswith("1 replayed") for line in result.output.splitlines())
