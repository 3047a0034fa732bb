"""A stage of the pipeline imports earlier stages only."""

import ast
import sys
from pathlib import Path

import pytest

STAGES = (
    *(
        "files",
        "papers",
        "replaying",
        "expressions",
        "proving",
        "processes",
        "reading",
        "declaring",
        "showing",
        "generating",
        "verifying",
        "mutating",
        "auditing",
    ),
    *("study", "reporting", "pipeline", "exporting", "scaffolding", "cli", "plugin"),
)

STAGES_OF_READING = (
    *("lexing", "documents", "parsing", "prose", "defining", "deriving"),
    *("asking", "remembering", "ways", "judging", "reporting"),
)


def imported(path: Path) -> set[tuple[str, str]]:
    """Return each module that a file imports anywhere, also in a function, with a name that it takes from it, or ""."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {(alias.name, "") for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found |= {(node.module or "", alias.name) for alias in node.names}
    return found


def imported_stages(path: Path) -> set[str]:
    own = (f"{module}.{name}".split(".") for module, name in imported(path) if module.startswith("algebroproj_sym"))
    return {parts[1] for parts in own} & {*STAGES}


def module_name(path: Path, repository: Path) -> str:
    parts = path.relative_to(repository).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def circle(imports: dict[str, set[str]]) -> list[str]:
    """Return modules each of which imports the next one, and the last one the first; none if there are none."""
    left = {name: {*others} & imports.keys() for name, others in imports.items()}
    while ends := [name for name, others in left.items() if not others & left.keys()]:
        for name in ends:
            del left[name]
    found = [min(left)] if left else []
    while found and (following := min(left[found[-1]] & left.keys())) not in found:
        found.append(following)
    return found[found.index(following) :] if found else []


def test_circles_are_found() -> None:
    assert circle({"a": {"b"}, "b": {"c"}, "c": {"d"}, "d": {"b"}, "e": {"a"}}) == ["b", "c", "d"]
    assert circle({"a": {"a"}}) == ["a"]
    assert circle({"a": {"b", "c"}, "b": {"c"}, "c": {"sympy"}}) == []


def test_no_module_imports_one_that_imports_it(repository: Path) -> None:
    files = {module_name(path, repository): path for path in (repository / "algebroproj_sym").rglob("*.py")}
    imports = {
        name: {inner if (inner := f"{module}.{each}") in files else module for module, each in imported(path)}
        for name, path in files.items()
    }
    assert sum(map(len, imports.values())) > len(files)
    assert circle(imports) == []


def test_every_part_of_the_package_is_a_stage(repository: Path) -> None:
    root = repository / "algebroproj_sym"
    found = {path.stem for path in root.glob("*.py")} | {path.parent.name for path in root.glob("*/__init__.py")}
    assert found - {"__init__", "__main__"} == {*STAGES}


@pytest.mark.parametrize("stage", STAGES)
def test_a_stage_imports_no_later_one(stage: str, repository: Path) -> None:
    root = repository / "algebroproj_sym"
    files = [root / f"{stage}.py"] if (root / f"{stage}.py").exists() else sorted((root / stage).rglob("*.py"))
    assert files
    allowed = set(STAGES[: STAGES.index(stage) + 1])
    for file in files:
        assert imported_stages(file) <= allowed, file


def test_a_stage_of_reading_imports_no_later_one(repository: Path) -> None:
    root = repository / "algebroproj_sym" / "reading"
    assert {path.parent.name for path in root.glob("*/__init__.py")} == {*STAGES_OF_READING}
    for place, stage in enumerate(STAGES_OF_READING):
        for file in (root / stage).glob("*.py"):
            own = [
                module.split(".")[2] for module, _ in imported(file) if module.startswith("algebroproj_sym.reading.")
            ]
            assert {*own} <= {*STAGES_OF_READING[: place + 1]}, file


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
