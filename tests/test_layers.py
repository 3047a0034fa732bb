"""A stage of the pipeline imports earlier stages only."""

import ast
from pathlib import Path

import pytest

STAGES = (
    "files",
    "expressions",
    "proving",
    "declaring",
    "generating",
    "verifying",
    "reporting",
    "pipeline",
    "scaffolding",
    "cli",
    "plugin",
)


def imported_stages(path: Path) -> set[str]:
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names |= {node.module or ""} | {f"{node.module}.{alias.name}" for alias in node.names}
    return {name.split(".")[1] for name in names if name.startswith("algebroproj_sym.") and name.count(".")} & {*STAGES}


@pytest.mark.parametrize("stage", STAGES)
def test_a_stage_imports_no_later_one(stage: str, repository: Path) -> None:
    root = repository / "algebroproj_sym"
    files = [root / f"{stage}.py"] if (root / f"{stage}.py").exists() else sorted((root / stage).rglob("*.py"))
    assert files
    allowed = set(STAGES[: STAGES.index(stage) + 1])
    for file in files:
        assert imported_stages(file) <= allowed, file


def test_the_machinery_knows_no_paper(repository: Path) -> None:
    for file in (repository / "algebroproj_sym").rglob("*.py"):
        assert "1996" not in file.read_text(encoding="utf-8"), file
