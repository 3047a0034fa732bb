"""Completion of selectors by the Tab key: papers, and the sections and numbers of a paper.

The modules are parsed, not run.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import click
from click.shell_completion import CompletionItem

KINDS = frozenset(
    {
        "identity",
        "up_to_scale",
        "structure",
        "vanishing",
        "rank",
        "count",
        "limit",
        "numeric",
        "reference",
        "definition",
    }
)


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
    papers = [CompletionItem(paper) for paper in _papers() if paper.startswith(incomplete)]
    return papers or [CompletionItem(incomplete, type="file")]


def _papers() -> tuple[str, ...]:
    from algebroproj_sym.declaring import installed_papers

    return installed_papers()


def _names(source: str) -> list[str]:
    """Return the sections and the numbers that are written in the modules of a paper, a folder or a file."""
    return list(dict.fromkeys(name for path in _modules(source) for name in _written(path)))


def _modules(source: str) -> list[Path]:
    from algebroproj_sym.declaring import paper_folders

    path = Path(source)
    if path.is_file():
        return [path]
    folders = paper_folders(source) if source in _papers() else {path}
    return [module for folder in sorted(folders) if folder.is_dir() for module in sorted(folder.rglob("*.py"))]


def _written(path: Path) -> Iterator[str]:
    try:
        calls = [node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.Call)]
    except (OSError, SyntaxError, ValueError):
        return
    calls.sort(key=lambda call: (call.lineno, call.col_offset))
    for call in calls:
        place = {"Section": 1}.get(call.func.id) if isinstance(call.func, ast.Name) else None
        if isinstance(call.func, ast.Attribute) and call.func.attr in KINDS:
            place = 0
        if place is not None and len(call.args) > place and isinstance(call.args[place], ast.Constant):
            yield str(call.args[place].value)  # type: ignore[attr-defined]
