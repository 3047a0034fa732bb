"""Completion of selectors by the Tab key: papers, and the sections and numbers of a paper.

The modules are parsed, not run.
"""

from pathlib import Path

import click
from click.shell_completion import CompletionItem

from algebroproj_sym.papers import installed_papers, names_in, paper_folders


def selectors_like(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """Return the selectors that begin with the typed text.

    Bash ends a word at a colon: the part before it is an argument of its own.
    """
    given = list(context.params.get(parameter.name or "") or ())
    before = [word for word in given if word != ":"]
    if incomplete == ":" or given[-1:] == [":"]:
        part = incomplete.removeprefix(":")
        return [CompletionItem(name) for name in _names(before[-1] if before else "") if name.startswith(part)]
    source, colon, part = incomplete.rpartition(":")
    if colon:
        return [CompletionItem(f"{source}:{name}") for name in _names(source) if name.startswith(part)]
    papers = [CompletionItem(paper) for paper in installed_papers() if paper.startswith(incomplete)]
    return papers or [CompletionItem(incomplete, type="file")]


def _names(source: str) -> list[str]:
    """Return the sections and the numbers that are written in the modules of a paper, a folder or a file."""
    return list(dict.fromkeys(name for path in _modules(source) for name in names_in(path)))


def _modules(source: str) -> list[Path]:
    path = Path(source)
    if path.is_file():
        return [path]
    folders = paper_folders(source) if source in installed_papers() else {path}
    return [module for folder in sorted(folders) if folder.is_dir() for module in sorted(folder.rglob("*.py"))]
