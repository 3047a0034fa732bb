"""What makes the command line a pleasant one: help, quiet and verbose, colors, advice, and Ctrl-C."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from importlib import import_module

import click
import pytest
from cases import for_each
from click.testing import CliRunner

from algebroproj_sym.cli import SUMMARIES, group, main, steps
from algebroproj_sym.declaring import derivation_at, select
from algebroproj_sym.files import write_texts
from algebroproj_sym.reporting.notebooks import NotebookError, run_notebook
from algebroproj_sym.scaffolding import create

COLOR = re.compile(r"\x1b\[[0-9;]*3[0-7][0-9;]*m")
SLOW = """
import sympy
from pathlib import Path
from algebroproj_sym import Section

s = sum(sympy.symbols("u v w x y"))
section = Section("slow", "1", "Claims that take their time")
for i in range(300):
    section.identity(f"1.{i}", "a power", printed=(s + i) * s**28, derived=s**29 + i * s**28)
Path(__file__).with_suffix(".read").touch()
"""


@pytest.fixture(autouse=True)
def _interruptible():
    """Be interrupted as at a terminal, also where the tests run in the background, which ignores Ctrl-C."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def run(*arguments, **options):
    return CliRunner().invoke(main, [str(argument) for argument in arguments], **options)


INTERRUPTED = (130, -signal.SIGINT)
"""Both are 130 in a shell.  Python ends by the signal itself if it was executing text, as `dataclass` does."""


def process(*arguments, **options):
    command = [sys.executable, "-m", "algebroproj_sym", *map(str, arguments)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)


@pytest.fixture(scope="module")
def right(tmp_path_factory):
    return create("right", tmp_path_factory.mktemp("bodies"))[0].parent


@pytest.fixture(scope="module")
def wrong(tmp_path_factory):
    module = create("wrong", tmp_path_factory.mktemp("bodies"))[1]
    text = module.read_text(encoding="utf-8")
    module.write_text(text.replace("printed=over(a * f, a - f)", "printed=over(a * f, a + f)"), encoding="utf-8")
    return module.parent


def test_help_shows_the_commands_in_the_order_of_their_use():
    output = run("--help").output
    listed = re.findall(r"^  (\w+)  +[A-Z]", output, flags=re.MULTILINE)
    assert [name for name in listed if name in SUMMARIES] == list(SUMMARIES)
    assert listed[0] == "new"
    assert "Typical commands" in output
    assert "Exit status" in output


def test_the_commands_that_help_shows_exist():
    shown = re.findall(r"^ +algebroproj (\w+)", run("--help").output, flags=re.MULTILINE)
    assert len(shown) >= 4
    assert set(shown) <= set(SUMMARIES)


@for_each("command", list(SUMMARIES))
def test_every_command_has_a_help_with_one_sentence_first(command):
    output = run(command, "--help")
    assert output.exit_code == 0
    assert main.get_command(click.Context(main), command).get_short_help_str(200) == SUMMARIES[command]
    assert output.output.split("\n\n")[1].strip().split("\n")[0][0].isupper()


def test_help_and_completion_import_no_mathematics():
    script = (
        "import sys; from algebroproj_sym.cli import main, check, explain; main(['--help'], standalone_mode=False)\n"
        "print({'sympy', 'numpy', 'flint', 'rich'} & {*sys.modules})"
    )
    for words in ({}, {"_ALGEBROPROJ_COMPLETE": "bash_complete", "COMP_WORDS": "algebroproj ch", "COMP_CWORD": "1"}):
        command = [sys.executable, "-c", script]
        found = subprocess.run(command, capture_output=True, text=True, check=True, env=os.environ | words)
        assert found.stdout.splitlines()[-1] == "set()"


def test_check_of_a_number_imports_nothing_that_makes_functions():
    script = (
        "import sys; from algebroproj_sym.cli import main\n"
        "main(['check', 'rhodos1990:1.1'], standalone_mode=False)\n"
        "print({'numpy', 'scipy', 'algebroproj_sym.generating', 'algebroproj_sym.verifying'} & {*sys.modules})"
    )
    found = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert found.stdout.splitlines()[-1] == "set()"


def test_the_advice_is_for_errors_that_there_are():
    from algebroproj_sym import declaring, expressions, pipeline, proving, reading
    from algebroproj_sym.generating import lowering
    from algebroproj_sym.reporting import notebooks
    from algebroproj_sym.verifying import shipped

    homes = (declaring, expressions, lowering, pipeline, proving, reading, notebooks, shipped)
    for name in (*group.NEXT, *group.WRONG_USAGE):
        assert any(issubclass(vars(home)[name], Exception) for home in homes if name in vars(home)), name


def test_the_options_name_what_there_is():
    from algebroproj_sym.generating.writing import PACKAGE
    from algebroproj_sym.proving import ENGINES

    def parameter(command, name):
        found = main.get_command(click.Context(main), command).params
        return next(each for each in found if each.name == name)

    assert parameter("check", "engine").type.choices == ENGINES
    assert parameter("build", "package").default == PACKAGE


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_completion_that_help_documents_works(shell):
    environment = os.environ | {"_ALGEBROPROJ_COMPLETE": f"{shell}_source"}
    result = process(env=environment)
    output, _ = result.communicate()
    assert "_ALGEBROPROJ_COMPLETE" in output


def test_an_explanation_can_be_pasted_into_a_review(wrong):
    output = run("explain", f"{wrong}:1.2", "--format", "markdown").output
    assert output.startswith("**(1.2)** distance of the image: **false, declared proved**\n\n$$\\frac{")
    assert r"counterexample: $" in output


def test_quiet_says_nothing_where_everything_is_as_declared(right):
    result = run("--quiet", "check", right)
    assert (result.exit_code, result.output) == (0, "")


def test_quiet_says_what_is_wrong(wrong):
    result = run("--quiet", "check", wrong)
    assert result.exit_code == 1
    assert result.stdout == ""
    assert "wrong (1.2)" in result.stderr
    assert "wrong (1.1)" not in result.stderr


def test_quiet_leaves_json_alone(right):
    assert json.loads(run("-q", "check", right, "--format", "json").stdout)["summary"]["proved"] == 1


def test_verbose_says_how_long_each_step_takes(right, tmp_path):
    arguments = ("generate", "--derivations", right, "--name", "functions", "--out", tmp_path)
    result = run("--verbose", *arguments)
    assert re.search(r"^checking: 1 in [\d.]+ s\nlowering: 1 in [\d.]+ s$", result.stderr, flags=re.MULTILINE)
    assert run(*arguments).stderr == ""


@pytest.mark.whole
@pytest.mark.parametrize(("no_color", "colored"), [({}, True), ({"NO_COLOR": "1"}, False)])
def test_no_color_is_respected(right, no_color, colored):
    environment = {key: value for key, value in os.environ.items() if key not in ("NO_COLOR", "TERM")}
    environment |= {"FORCE_COLOR": "1", "TERM": "xterm-256color"} | no_color
    output, _ = process("check", right, env=environment).communicate()
    assert bool(COLOR.search(output)) is colored
    assert "misprint" in output


@pytest.mark.parametrize(
    ("arguments", "advice"),
    [
        (("check", "nosuchpaper"), "or the path of a derivation module or folder"),
        (("verify", "--derivations", "{right}", "--name", "nosuchpackage"), "algebroproj generate --out DIR"),
        (("generate", "--derivations", "{wrong}", "--out", "{out}"), "algebroproj explain wrong:1.2"),
        (("generate", "--derivations", "{right}", "--out", "{out}", "--check"), "without --check"),
        (("generate", "--derivations", "{right}", "--name", "not-a-name"), "such as my_functions"),
        (("new", "right", "--out", "{parent}"), "--out DIR"),
    ],
)
def test_an_error_says_what_to_do_next(arguments, advice, right, wrong, tmp_path):
    places = {"right": right, "wrong": wrong, "out": tmp_path, "parent": right.parent}
    result = run(*(argument.format(**places) for argument in arguments))
    assert result.exit_code in (1, 2)
    assert advice in " ".join(result.output.split())


@pytest.mark.parametrize(("options", "missing"), [((), "latex2mathml"), (("--notebooks",), "nbclient")])
def test_a_report_without_what_it_needs_says_how_to_install_that(options, missing, right, tmp_path, monkeypatch):
    monkeypatch.setattr(steps, "find_spec", lambda name: None if name == missing else name)
    result = run("report", right, *options, "--out", tmp_path / "site")
    assert result.exit_code == 1
    assert missing in result.stderr
    assert "pip install 'algebroproj-sym[report]'" in result.stderr
    assert not (tmp_path / "site").exists()


def test_a_build_that_is_not_as_declared_says_why_and_writes_the_ledger(wrong, tmp_path):
    result = run("build", "--derivations", wrong, "--name", "functions", "--out", tmp_path)
    assert result.exit_code == 1
    assert "at this point derived" in result.stderr
    assert (tmp_path / "ledger.json").is_file()


def test_a_function_that_fails_is_named_with_the_reason_and_what_to_try(right, tmp_path, monkeypatch):
    monkeypatch.setattr(import_module("algebroproj_sym.verifying.accuracy"), "BOUND", 0)
    result = run("build", "--derivations", right, "--name", "functions", "--out", tmp_path, "--samples", "2")
    assert result.exit_code == 1
    assert re.search(r"^\w+\.\w+ is not verified: its errors are too large", result.stderr, flags=re.MULTILINE)
    for word in ("form=", "alternatives=", "report.md"):
        assert word in result.stderr
    assert "is not verified" in (tmp_path / "report.md").read_text(encoding="utf-8")


MODULE = """
# %%
import sys
import sympy
from algebroproj_sym import Section

x = sympy.Symbol("x")
section = Section("mine", "1", "Squares")

# %%
{cell}
"""


@pytest.mark.parametrize(
    ("cell", "message"),
    [
        ("sys.exit(3)", "cannot be imported (line 11): it ends the program, by SystemExit(3)"),
        ("section.identity(1.1, 'a', printed=x, derived=x)", "expected the text of a number such as 1.3.8"),
        ("section.identity('1.1', 7, printed=x, derived=x)", "title: expected text on one line, got 7"),
        (
            "section.numeric('1.1', 'a', printed=1.5, derived=x / x)",
            "expected the text of a decimal number such as -0.50, got 1.5",
        ),
    ],
)
def test_a_module_that_goes_wrong_is_an_error_with_a_name(tmp_path, cell, message):
    module = tmp_path / "mine.py"
    module.write_text(MODULE.format(cell=cell), encoding="utf-8")
    result = run("check", module)
    assert result.exit_code == 1
    assert message in result.stderr
    assert str(module) in result.stderr
    assert "Traceback" not in result.output


@pytest.mark.extra("report")
def test_an_exception_in_a_cell_is_an_error_that_names_the_cell(tmp_path):
    module = tmp_path / "mine.py"
    cell = "if 'get_ipython' in globals(): raise ValueError('only in a notebook')"
    module.write_text(MODULE.format(cell=cell), encoding="utf-8")
    with pytest.raises(
        NotebookError, match=r"mine.py: cell 2, which begins with .if 'get_ipython'.*: ValueError: only in"
    ):
        run_notebook(derivation_at(module)[0])


def completed(*words):
    """Return what the Tab key gives after some words, as bash tells them."""
    environment = {"_ALGEBROPROJ_COMPLETE": "bash_complete"}
    environment |= {"COMP_WORDS": " ".join(["algebroproj", *words]), "COMP_CWORD": str(len(words))}
    lines = run(env=environment, prog_name="algebroproj").output.split()
    return [line.partition(",")[2] for line in lines]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (("check", "funda"), ["fundamentals1996"]),
        (("check", "fundamentals1996:1.2/j=0"), ["fundamentals1996:1.2/j=0"]),
        (("check", "fundamentals1996", ":", "1.2/j=0"), ["1.2/j=0"]),
        (("explain", "rhodos1990", "fundamentals1996:1.2/j=0"), ["fundamentals1996:1.2/j=0"]),
        (("check", "nosuchpaper:1"), []),
        (("check", "./folder"), ["./folder"]),
    ],
)
def test_selectors_complete(words, expected):
    assert completed(*words) == expected


def test_all_numbers_of_a_paper_complete_that_are_written_in_its_modules():
    found = completed("explain", "critical1996", ":")
    declared = {claim.number for claim in select(["critical1996"])} | {"0"}
    assert found
    assert {*found} <= declared | {claim.section for claim in select(["critical1996"])}
    assert len(found) > len(declared) / 2


def test_without_the_studies_help_and_completion_say_what_to_install(monkeypatch):
    monkeypatch.setattr(steps, "find_spec", lambda name: None)
    help_text = run("study", "--help")
    assert help_text.exit_code == 0
    assert "pip install 'algebroproj-sym[study]'" in help_text.output
    assert completed("study", "") == []
    result = run("study", "scene")
    assert result.exit_code == 1
    assert "pip install 'algebroproj-sym[study]'" in result.stderr


@pytest.mark.parametrize(
    ("arguments", "meant"),
    [
        (("check", "fundamental1996"), "Did you mean fundamentals1996?"),
        (("check", "critical1996:0/beyond/divisors"), "Did you mean 0/beyond/divisor"),
        (("chekc",), "Did you mean 'check'?"),
    ],
)
def test_what_is_misspelled_is_asked_about(arguments, meant):
    result = run(*arguments)
    assert result.exit_code == 2
    assert meant in " ".join(result.output.split())


def test_files_are_written_whole_or_not_at_all(tmp_path):
    write_texts({"a": "old", "b": "old"}, tmp_path)
    with pytest.raises(TypeError):
        write_texts({"a": "new", "b": None}, tmp_path)
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {"a": "old", "b": "old"}


def test_an_interruption_while_files_are_put_in_place_comes_after_the_last(tmp_path, monkeypatch):
    replace = type(tmp_path).replace

    def interrupted(self, target):
        signal.raise_signal(signal.SIGINT)
        return replace(self, target)

    monkeypatch.setattr(type(tmp_path), "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_texts({"a": "new", "b": "new"}, tmp_path)
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {"a": "new", "b": "new"}


def wait_for(path, running):
    while not path.exists() and running.poll() is None:
        time.sleep(0.02)


@pytest.fixture
def slow(tmp_path):
    module = tmp_path / "slow.py"
    module.write_text(SLOW, encoding="utf-8")
    return module


@pytest.mark.parametrize("jobs", [pytest.param("1", marks=pytest.mark.whole), "2"])
def test_ctrl_c_ends_a_build_with_130_and_leaves_what_was_there(slow, tmp_path, jobs):
    out = tmp_path / "out"
    write_texts({"ledger.json": '{"schema": 1}\n', "report.md": "old\n"}, out)
    running = process("build", "--derivations", slow, "--name", "functions", "--out", out, "--jobs", jobs)
    wait_for(slow.with_suffix(".read"), running)
    time.sleep(0.5)
    assert running.poll() is None
    start = time.monotonic()
    running.send_signal(signal.SIGINT)
    _, errors = running.communicate(timeout=20)
    assert time.monotonic() - start < 10
    assert running.returncode in INTERRUPTED
    assert "Interrupted" in errors
    assert "Traceback" not in errors
    assert {path.name: path.read_text() for path in out.iterdir()} == {
        "ledger.json": '{"schema": 1}\n',
        "report.md": "old\n",
    }


def test_ctrl_c_while_verifying_leaves_complete_files_alone(right, tmp_path):
    out = tmp_path / "out"
    arguments = ("build", "--derivations", right, "--name", "functions", "--out", out, "--samples", "100000")
    running = process(*arguments)
    wait_for(out / "functions" / "py.typed", running)
    running.send_signal(signal.SIGINT)
    _, errors = running.communicate(timeout=60)
    assert running.returncode in INTERRUPTED, errors
    assert not [path for path in out.rglob("*") if "partial" in path.name]
    assert json.loads((out / "ledger.json").read_text(encoding="utf-8"))["summary"]["proved"] == 1
    for path in (out / "functions").glob("*.py"):
        compile(path.read_text(encoding="utf-8"), path, "exec")
    assert not (out / "report.md").exists()
