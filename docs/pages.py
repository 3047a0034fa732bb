"""Run the blocks of the pages and of the README, in their order and each page in an empty folder.

    python docs/pages.py [PAGE ...]

writes what the commands print today into the pages.  The tests compare instead of writing.

A block of the language ``console`` is a session, ``python`` a session of the interpreter or a module, whose first line
names the file, and ``json`` or ``latex`` with a title is a file.
"""

import doctest
import os
import re
import runpy
import shlex
import sys
import tempfile
import tomllib
from multiprocessing import get_context
from pathlib import Path

DOCS = Path(__file__).resolve().parent
README = DOCS.parent / "README.md"
PAGES = sorted(DOCS.rglob("*.md"))
PROGRAMS = {"algebroproj": "algebroproj_sym", "pytest": "pytest"}
STUDIES = [f"algebroproj_derivations.studies.{path.stem}" for path in DOCS.parent.glob("derivations/studies/[a-z]*.py")]
FORKS = get_context("forkserver")
# Most of what a command imports; what is not installed is passed over.
FORKS.set_forkserver_preload(["algebroproj_sym.cli.report", "distributed.cli.dask_worker", *sorted(STUDIES)])
BLOCK = re.compile(r'^```(\w+)(?: title="([^"]*)")?\n(.*?)^```$', re.MULTILINE | re.DOTALL)
COMMAND = re.compile(r"^\$ (.*)\n?((?:(?!\$ ).*\n?)*)", re.MULTILINE)


def blocks(page):
    """Return language, title and text of each block of a page."""
    return BLOCK.findall(page.read_text(encoding="utf-8"))


def lines(text):
    """Return the lines of an output, without spaces at their ends and without the time that pytest took."""
    return [re.sub(r" in [\d.]+s$", "", line.rstrip()) for line in text.rstrip().split("\n")]


def run(command, folder):
    """Return what a command prints, in a folder."""
    program, *arguments = shlex.split(command)
    if program == "rm":
        (folder / arguments[0]).unlink()
        return ""
    target = folder / arguments.pop() if ">" in arguments else None
    arguments = [argument for argument in arguments if argument != ">"]
    if program == "pytest":
        arguments += ["-p", "no:cacheprovider"]
    with tempfile.TemporaryDirectory() as name:
        process, printed = started(PROGRAMS[program], arguments, folder, Path(name))
        process.join()
        out, error = (path.read_text(encoding="utf-8") for path in printed)
    if target:
        target.write_text(out, encoding="utf-8")
    status = f"[exit status {process.exitcode}]\n" if process.exitcode else ""
    return ("" if target else out) + error + status


def started(program, arguments, folder, kept):
    """Return the process of a program that runs in a folder, and the files for what it prints, in another folder."""
    printed = [kept / "stdout", kept / "stderr"]
    process = FORKS.Process(target=perform_command, args=(program, arguments, folder, printed))
    process.start()
    return process, printed


def perform_command(program, arguments, folder, printed):
    """Do what `python -m` does, in a process that has imported most of the program."""
    for stream, path in zip((1, 2), printed, strict=True):
        os.dup2(os.open(path, os.O_WRONLY | os.O_CREAT), stream)
    os.chdir(folder)
    sys.path.insert(0, str(folder))
    sys.argv[1:] = arguments
    runpy.run_module(program, run_name="__main__", alter_sys=True)


def write(block, folder):
    """Write a module whose first line names it, append to it, or replace its last line."""
    heading, _, text = block.partition("\n")
    name, _, how = heading.removeprefix("# ").partition(", ")
    path = folder / name
    path.parent.mkdir(exist_ok=True)
    before = path.read_text(encoding="utf-8") if how else ""
    kept = "\n".join(before.rstrip("\n").split("\n")[:-1]) if how == "last line" else before
    path.write_text(f"{kept}\n{text}" if how else text, encoding="utf-8")


def interpret(block, names):
    """Run a session of the interpreter, whose output must be what is shown."""
    test = doctest.DocTestParser().get_doctest(block, names, "documentation", None, 0)
    assert test.examples
    runner = doctest.DocTestRunner()
    report = []
    failed = runner.run(test, out=report.append, clear_globs=False).failed
    assert failed == 0, "".join(report)
    names |= test.globs


def perform(page, folder, session):
    """Run the blocks of a page; a console block goes to ``session``, which returns what is to stand there."""
    names = {}

    def one(match):
        language, title, block = match.groups()
        if language == "console":
            return match[0].replace(block, session(block, folder))
        if language == "python" and block.startswith(">>> "):
            interpret(block, names)
        elif language == "python":
            write(block, folder)
        elif language in ("json", "latex"):
            (folder / title).write_text(block, encoding="utf-8")
        elif language == "toml":
            assert tomllib.loads(block)
        else:
            assert language in ("sh", "text"), language
        return match[0]

    return BLOCK.sub(one, page.read_text(encoding="utf-8"))


def compared(block, folder):
    """Run the commands of a block, which must print what is shown."""
    for command, output in COMMAND.findall(block):
        assert lines(run(command, folder)) == lines(output), command
    return block


def renewed(block, folder):
    """Run the commands of a block, and return them with what they print."""
    shown = ((command, "\n".join(lines(run(command, folder)))) for command, _ in COMMAND.findall(block))
    return "".join(f"$ {command}\n{output}\n" if output else f"$ {command}\n" for command, output in shown)


if __name__ == "__main__":
    for page in [Path(name).resolve() for name in sys.argv[1:]] or [README, *PAGES]:
        with tempfile.TemporaryDirectory() as name:
            os.chdir(name)
            sys.path.insert(0, name)
            text = perform(page, Path(name), renewed)
            sys.path.remove(name)
        page.write_text(text, encoding="utf-8")
