"""A stage of the pipeline imports earlier stages only."""

import ast
import sys
from pathlib import Path

import pytest

STAGES = (
    *(
        "files",
        "replaying",
        "expressions",
        "proving",
        "declaring",
        "auditing",
        "generating",
        "verifying",
        "mutating",
    ),
    *("study", "reporting", "processes", "pipeline", "exporting", "scaffolding", "cli", "plugin"),
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


def test_the_replay_shares_no_code_with_the_rest_and_needs_the_standard_library_alone(repository: Path) -> None:
    files = sorted((repository / "algebroproj_sym" / "replaying").rglob("*.py"))
    assert files
    for file in files:
        assert imported_stages(file) <= {"replaying"}, file
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                names = [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom):
                assert node.level == 0, file
                names = [node.module or ""]
            else:
                continue
            for name in names:
                own = name.startswith("algebroproj_sym.replaying")
                assert own or name.partition(".")[0] in sys.stdlib_module_names, (file, name)


def test_the_machinery_knows_no_paper(repository: Path) -> None:
    for file in (repository / "algebroproj_sym").rglob("*.py"):
        assert "1996" not in file.read_text(encoding="utf-8"), file
