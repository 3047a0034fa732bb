"""The generated package is the same text wherever it is rendered, and its folder holds that text and nothing stale."""

import ast
import inspect
import json
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import pytest
import sympy

from algebroproj_sym import Section
from algebroproj_sym.declaring import drivers, kernels
from algebroproj_sym.expressions import over, vector
from algebroproj_sym.generating.backends.numpy import render
from algebroproj_sym.generating.backends.numpy.package import runtime_modules
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.description import LONGEST_FACTOR
from algebroproj_sym.generating.runtime.accuracy import sentences
from algebroproj_sym.generating.writing import PACKAGE, drift, write
from algebroproj_sym.verifying.shipped import function_of, load_package

HAND_WRITTEN = ("drivers.py", "epipolar.py", "five_pairs.py", "isolating.py", "poses.py", "solvers.py")
SHARED = {
    *("__init__.py", "py.typed"),
    *HAND_WRITTEN,
    *(
        f"_c/{name}"
        for name in ("compiled.c", "calls.h", "kernels.h", "solvers.h", "systems.h", "moves.h", "loops.h", "fours.h")
    ),
    *("_c/plain_kernels.h", "_c/plain_loops.h"),
    *(f"_runtime/{name}.py" for name in runtime_modules(["arctan2", "cos_sin", "systems"])),
}
SECTIONS = ("Parameters", "Returns", "Raises", "Notes", "Examples")


@pytest.fixture(scope="module")
def rendered(lowered):
    return render([lowered(kernel.qualified_name) for kernel in kernels()], drivers())


@pytest.fixture
def files():
    return render([lower(kernel("first.double")), lower(kernel("second.half"))])


def kernel(name):
    x, y = sympy.symbols("x y")
    return Section("demo", "1", "Demonstration").kernel(
        name,
        "A function.",
        arguments={"x": x, "p": vector(y)},
        derived=vector(over(x * y, y), x + y),
        form=vector(x, x + y),
        claims=["1.1", "1.2#part"],
        example={"x": "0.5", "p": ("0.25",)},
        describe={"x": "A length in meters.", "p": "A point."},
    )


def functions_of(text):
    """Return the public functions; each has a private body, and a signature."""
    return [n for n in ast.parse(text).body if isinstance(n, ast.FunctionDef) and not n.name.startswith("_")]


def file_of(name, node):
    """Return the file that a file of the package imports from."""
    return (Path(name).parent / f"{node.module.replace('.', '/')}.py").as_posix()


def names_in(folder):
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def test_every_module_of_the_kernels_is_a_file(rendered):
    assert set(rendered) == SHARED | {f"{kernel.module}.py" for kernel in kernels()}


def test_every_kernel_is_a_function_in_the_order_of_its_declaration(rendered):
    for module in {kernel.module for kernel in kernels()}:
        declared = [kernel.name for kernel in kernels() if kernel.module == module]
        assert [function.name for function in functions_of(rendered[f"{module}.py"])] == declared


def test_every_function_is_exported(rendered):
    for name, text in rendered.items():
        if name not in SHARED:
            assigned = {n.targets[0].id: n.value for n in ast.parse(text).body if isinstance(n, ast.Assign)}
            exported = assigned.pop("__all__")
            upper = [f"_{function.name.upper()}" for function in functions_of(text)]
            assert {f"{name}_SIGNATURE" for name in upper} <= {*assigned}
            assert {*assigned} <= {f"{name}_{what}" for name in upper for what in ("SIGNATURE", "FACTORS")}
            hand_written = [driver.name for driver in drivers() if f"{driver.module}.py" == name]
            assert ast.literal_eval(exported) == [function.name for function in functions_of(text)] + hand_written


def test_the_order_of_the_kernels_of_other_modules_does_not_matter(files):
    assert render([lower(kernel("second.half")), lower(kernel("first.double"))]) == files


def test_every_module_imports_numpy_and_its_own_package_only(rendered):
    modules = {name: text for name, text in rendered.items() if name.endswith(".py")}
    for name, text in modules.items():
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.Import):
                assert {alias.name.partition(".")[0] for alias in node.names} <= {"numpy", *sys.stdlib_module_names}, (
                    name
                )
            elif isinstance(node, ast.ImportFrom):
                own = node.level and (node.module is None or file_of(name, node) in rendered)
                assert own or node.level == 0, name
                assert own or node.module.partition(".")[0] in {"numpy", *sys.stdlib_module_names}, name


def test_every_imported_name_of_the_own_package_exists(rendered):
    imported = [n for n in ast.parse(rendered["__init__.py"]).body if isinstance(n, ast.ImportFrom)]
    modules = {f"{alias.name}.py" for node in imported if node.module is None for alias in node.names}
    assert modules == set(rendered) - SHARED
    assert {file_of("__init__.py", node) for node in imported if node.module is not None and node.level} <= SHARED


def test_every_file_says_that_it_is_generated(rendered):
    for name, text in rendered.items():
        if name in HAND_WRITTEN:
            assert "hand-written" in ast.get_docstring(ast.parse(text))
        elif name.endswith(".py"):
            assert "do not edit" in ast.get_docstring(ast.parse(text)), name


def test_every_function_documents_itself_in_all_sections(rendered):
    for name in set(rendered) - SHARED:
        for function in functions_of(rendered[name]):
            lines = ast.get_docstring(function).splitlines()
            headings = [above for above, line in pairwise(lines) if above and set(line) == {"-"}]
            assert tuple(headings) == SECTIONS, function.name


def test_every_function_describes_its_arguments_and_cites_its_claims(rendered):
    for kernel in kernels():
        (function,) = [f for f in functions_of(rendered[f"{kernel.module}.py"]) if f.name == kernel.name]
        docstring = ast.get_docstring(function)
        assert [argument.arg for argument in function.args.args] == [argument.name for argument in kernel.arguments]
        assert docstring.startswith(kernel.summary)
        assert f"{kernel.paper}, section {kernel.section}" in docstring
        assert all(f"({number})" in docstring for number in kernel.claims)
        assert all(
            f"{name} : array_like" in docstring and about in docstring for name, about in kernel.describe.items()
        )


def test_every_function_names_its_singularities(rendered, lowered):
    for kernel in kernels():
        low = lowered(kernel.qualified_name)
        (function,) = [f for f in functions_of(rendered[f"{kernel.module}.py"]) if f.name == kernel.name]
        docstring = " ".join(ast.get_docstring(function).split())
        short = [factor for factor in low.hypotheses if len(str(factor)) <= LONGEST_FACTOR]
        assert all(f"``{factor}``" in docstring for factor in short)
        assert ("a factor of a denominator above" in docstring) is (len(short) < len(low.hypotheses))
        linear = any(stage.primitive in ("solve", "null_vector") for stage in kernel.stages)
        assert ("Where the linear system is singular" in docstring) is linear
        assert ("no input is singular" in docstring.lower()) is (low.hypotheses == () and not linear)


def test_lines_end_without_spaces_and_files_with_a_newline(rendered):
    for name, text in rendered.items():
        assert all(line == line.rstrip() for line in text.splitlines()), name
        assert text == "" or text.endswith("\n"), name


def test_the_committed_package_is_what_is_rendered(rendered, repository):
    assert drift(rendered, repository / "generated" / PACKAGE) == []


def test_writing_leaves_the_files_and_nothing_else(files, tmp_path):
    folder = tmp_path / "deep" / PACKAGE
    write(files, folder)
    assert names_in(folder) == set(files)
    assert {name: (folder / name).read_text(encoding="utf-8") for name in files} == files
    assert drift(files, folder) == []


def test_writing_again_replaces_what_was_changed(files, tmp_path):
    write(files, tmp_path)
    (tmp_path / "first.py").write_text("changed")
    write(files, tmp_path)
    assert drift(files, tmp_path) == []
    assert names_in(tmp_path) == set(files)


def test_writing_removes_generated_modules_that_are_no_longer_wanted(files, tmp_path):
    write(files, tmp_path)
    fewer = render([lower(kernel("first.double"))])
    write(fewer, tmp_path)
    assert names_in(tmp_path) == set(fewer) == set(files) - {"second.py"}


def test_writing_leaves_foreign_files_alone(files, tmp_path):
    foreign = {"mine.py": "x = 1\n", "notes.txt": files["first.py"], "data.json": "{}"}
    for name, text in foreign.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder" / "inner.py").write_text(files["first.py"])
    write(files, tmp_path)
    assert {name: (tmp_path / name).read_text() for name in foreign} == foreign
    assert (tmp_path / "folder" / "inner.py").is_file()


def test_drift_of_a_folder_that_does_not_exist_is_everything(files, tmp_path):
    assert drift(files, tmp_path / "nowhere") == sorted(files)


@pytest.mark.parametrize("name", ["first.py", "__init__.py", "_runtime/evaluation.py", "py.typed"])
def test_drift_finds_a_changed_and_a_missing_file(files, tmp_path, name):
    write(files, tmp_path)
    (tmp_path / name).write_text(files[name] + "\n")
    assert drift(files, tmp_path) == [name]
    (tmp_path / name).unlink()
    assert drift(files, tmp_path) == [name]


def test_drift_finds_a_superfluous_module(files, tmp_path):
    write(files, tmp_path)
    (tmp_path / "stale.py").write_text("")
    assert drift(files, tmp_path) == ["stale.py"]


def test_drift_finds_several_at_once_and_changes_nothing(files, tmp_path):
    write(files, tmp_path)
    (tmp_path / "first.py").unlink()
    (tmp_path / "second.py").write_text("")
    (tmp_path / "third.py").write_text("")
    assert drift(files, tmp_path) == ["first.py", "second.py", "third.py"]
    assert names_in(tmp_path) == (set(files) | {"third.py"}) - {"first.py"}


def test_drift_does_not_mind_compiled_files(files, tmp_path):
    write(files, tmp_path)
    (tmp_path / "__pycache__").mkdir()
    (tmp_path / "__pycache__" / "first.cpython-311.pyc").write_bytes(b"")
    assert drift(files, tmp_path) == []


def test_the_example_of_a_docstring_is_its_result(files):
    docstring = ast.get_docstring(functions_of(files["first.py"])[0])
    assert ">>> double(0.5, [0.25]).round(6).tolist()\n[0.5, 0.75]" in docstring


def test_docstrings_tell_the_errors_that_are_recorded(repository):
    """The errors are in one file of the package; what is rendered does not depend on them."""
    record = json.loads((repository / "generated" / PACKAGE / "accuracy.json").read_text(encoding="utf-8"))
    figures = {entry["function"]: entry for entry in record["functions"]}
    assert figures.keys() == {kernel.qualified_name for kernel in kernels()}
    for kernel in kernels():
        function = function_of(kernel, load_package())
        told = sentences(figures[kernel.qualified_name], kernel.solves_systems)
        documentation = " ".join(inspect.getdoc(function).split())
        assert all(sentence in documentation for sentence in told), kernel.qualified_name
        assert "Measured error" not in inspect.getsource(function)


def test_help_shows_the_errors(capsys):
    help(function_of(kernels(("optics.scale",))[0], load_package()))
    assert "Measured error in float64: " in capsys.readouterr().out


def test_without_a_record_docstrings_tell_no_errors_and_with_one_its_own(files, tmp_path):
    write(files, tmp_path / "made")
    assert "Measured error" not in load_package(tmp_path, "made").second.half.__doc__
    figures = {"samples": 7, "median_ulp": 0.25, "max_ulp": 0.5, "max_ratio": 1.0}
    record = {"functions": [{"function": "second.half", "all": figures}]}
    (tmp_path / "made" / "accuracy.json").write_text(json.dumps(record), encoding="utf-8")
    package = load_package(tmp_path, "made")
    assert "0.25 ULP in the median, at most 0.5 ULP (7 samples" in package.second.half.__doc__
    assert "Measured error" not in package.first.double.__doc__


def test_a_change_of_one_kernel_changes_its_module_and_the_c_source_only(files):
    """The digest, by which a compiled module is known to belong to this source, changes with the C source."""
    changed = render([replace_form(kernel("first.double")), lower(kernel("second.half"))])
    differing = {name for name in files if files[name] != changed[name]}
    c_source = {"_c/kernels.h", "_c/plain_kernels.h", "_c/compiled.c", "_runtime/backend.py"}
    assert {"first.py"} <= differing <= {"first.py"} | c_source


def replace_form(declared):
    (result,) = declared.results
    x, y = declared.symbols
    return lower(replace(declared, results=(replace(result, form=vector(over(x * y, y), x + y)),)))
