"""C++ headers: proved as the C source is, and with the bits of the NumPy source."""

import re
import shutil
import subprocess
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from click.testing import CliRunner

import algebroproj
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import ELEMENTARY, kernels
from algebroproj_sym.generating.backends import BACKENDS
from algebroproj_sym.generating.backends.cpp import declaration, is_written, render
from algebroproj_sym.generating.samples import stratified
from algebroproj_sym.generating.writing import write
from algebroproj_sym.verifying.c_execution import NotUnderstoodError
from algebroproj_sym.verifying.proof_of_cpp_source import cpp_source_is_proved, function_is_proved, header_of
from algebroproj_sym.verifying.shipped import call, function_of, without_twin
from algebroproj_sym.verifying.verification import SPECIAL, same_bits

KERNELS = {kernel.qualified_name: kernel for kernel in kernels()}
COMPILER = shutil.which("g++")
OPTIONS = ["-std=c++17", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-O1"]
TYPES = {"float": np.float32, "double": np.float64, "long double": np.longdouble}
compiling = pytest.mark.skipif(COMPILER is None, reason="needs g++")
CALLING = {name for name, kernel in KERNELS.items() if ELEMENTARY.keys() & {s.primitive for s in kernel.stages}}
SOME = [
    *CALLING, "optics.image_point", "critical.determinant", "correlation.correlation_matrix",
    "projection.projection_matrix",
]  # fmt: skip


@pytest.fixture(scope="module")
def every(lowered):
    return [lowered(name) for name in KERNELS]


@pytest.fixture(scope="module")
def files(every):
    return render(every)


@pytest.mark.sampled(18)
@pytest.mark.parametrize("name", KERNELS)
def test_the_source_of_every_function_is_proved(name, lowered, files):
    assert cpp_source_is_proved(lowered(name), files)


def test_all_functions_are_there_but_those_that_are_too_long(every, files):
    shared = ("arithmetic.hpp", "elementary.hpp", "algebroproj.hpp")
    headers = {name: header_of(text) for name, text in files.items() if name not in shared}
    names = {f"{low.kernel.module}.{low.kernel.name}" for low in every if is_written(low)}
    modules = {name.partition(".")[0] for name in names}
    found = {f"{m}.{function}" for m in modules for function in headers[f"{m}.hpp"].bodies}
    assert found == names > CALLING


def refused(kernel, header):
    try:
        return not function_is_proved(kernel, header)
    except (NotUnderstoodError, KeyError):
        return True


@pytest.mark.parametrize("name", ["optics.image_point", "projection.projection_matrix", "correlation.epipoles"])
def test_each_change_of_an_operator_a_subscript_or_a_result_is_found(name, lowered):
    plain = replace(lowered(name), program=lowered(name).plain)
    kernel = plain.kernel
    header = header_of(render([plain])[f"{kernel.module}.hpp"])
    body = header.bodies[kernel.name]
    other = {"+": "-", "-": "+", "*": "+", "/": "*"}
    wrong = [
        f"{body[: place.start(1)]}{other[place[1]]}{body[place.end(1) :]}"
        for place in re.finditer(r"= \w+ ([-+*/]) \w+;", body)
    ]
    wrong += [
        f"{body[: place.start(1)]}{1 if place[1] == '0' else 0}{body[place.end(1) :]}"
        for place in re.finditer(r"\[(\d)\];", body)
    ]
    returned = re.search(r"return \{(.*)\};", body)[1].split(", ")
    for place in range(1, len(returned)):
        swapped = [*returned]
        swapped[place - 1], swapped[place] = swapped[place], swapped[place - 1]
        if swapped != returned:
            wrong.append(body.replace(", ".join(returned), ", ".join(swapped)))
    assert len(wrong) > 5
    assert function_is_proved(kernel, header)
    for text in wrong:
        assert refused(kernel, replace(header, bodies={kernel.name: text})), text


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("const real f, const std::array<real, 3> &x", "const std::array<real, 3> &x, const real f"),
        ("std::array<real, 3> image_point", "std::array<real, 4> image_point"),
        ("std::array<real, 3> &x", "std::array<real, 2> &x"),
        ("return {", "return {1 + "),
        ("return {", "if (f > 0) return {"),
        (
            "template <typename real>\nconstexpr std::array<real, 3> image_point",
            "#define t5 f\ntemplate <typename real>\nconstexpr std::array<real, 3> image_point",
        ),
        ("using namespace arithmetic;", "using namespace other;"),
    ],
)
def test_what_is_not_understood_is_refused(old, new, lowered, files):
    text = files["optics.hpp"]
    assert old in text
    assert not cpp_source_is_proved(lowered("optics.image_point"), files | {"optics.hpp": text.replace(old, new)})


SHARING = "correlation.general_correlation_matrix"


def test_what_functions_share_is_proved_with_them(lowered, files):
    assert cpp_source_is_proved(lowered(SHARING), files)


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("arithmetic.hpp", "const real a_low = a - a_high;", "const real a_low = a + a_high;"),
        ("arithmetic.hpp", "a_high * b_high - p", "a_high * b_high + p"),
        ("arithmetic.hpp", "constexpr real product_error(", "constexpr real another("),
        ("systems.hpp", "(&system)[8][18]", "(&system)[8][17]"),
        ("systems.hpp", "solution[8] =", "solution[7] ="),
    ],
)
def test_an_error_in_what_functions_share_is_found(file, old, new, lowered, files):
    assert files[file].count(old) >= 1
    assert not cpp_source_is_proved(lowered(SHARING), files | {file: files[file].replace(old, new)})


HEAD = """#include <cstdio>
#include <cstdlib>
#include "algebroproj.hpp"

template <typename type> type taken()
{
    type value{};
    if (std::fread(&value, sizeof value, 1, stdin) != 1) {
        std::abort();
    }
    return value;
}

template <typename type> void given(const type &value)
{
    std::fwrite(&value, sizeof value, 1, stdout);
}

int main()
{
"""


def program_of(kernels_, kind):
    """Return a program that reads the arguments of each function, point by point, and writes its results."""
    lines = [HEAD]
    for kernel in kernels_:
        names, head = declaration(kernel)
        types = [
            t.replace("real", kind)
            for t in re.findall(r"const (\S.*?) &?\w+(?: \[\[maybe_unused\]\])?(?:, (?=const)|\)$)", head)
        ]
        assert len(types) == len(names)
        lines.append("    for (long points = taken<long>(); points > 0; points--) {")
        lines += [f"        const auto {name} = taken<{t}>();" for name, t in zip(names.values(), types, strict=True)]
        lines.append(f"        given(algebroproj::{kernel.module}::{kernel.name}({', '.join(names.values())}));")
        lines.append("    }")
    return "\n".join([*lines, "    return 0;", "}", ""])


def values_of(low, dtype):
    """Return stratified samples, and special numbers in turn for each entry."""
    samples = [sample.values for sample in stratified(low, 4)]
    symbols = low.kernel.symbols
    samples += [samples[0] | {symbol.name: value} for symbol in symbols for value in SPECIAL]
    with np.errstate(all="ignore"):
        return {s.name: np.array([sample[s.name] for sample in samples]).astype(dtype) for s in symbols}


def computed_once(function):
    """Return the NumPy source without its second computation, where something over- or underflows: C++ has none."""
    source = without_twin(function)
    constant = f"_{source.__name__.upper()}_SIGNATURE"
    source.__globals__[constant] = replace(source.__globals__[constant], reach=None)
    return source


@compiling
@pytest.mark.whole
@pytest.mark.parametrize("kind", TYPES)
def test_every_function_gives_the_bits_of_the_numpy_source(kind, every, files, tmp_path):
    chosen = [low for low in every if is_written(low)]
    if kind != "double":  # what differs is the type alone: some functions are enough
        chosen = [low for low in chosen if low.kernel.qualified_name in SOME]
    dtype = TYPES[kind]
    write(files, tmp_path)
    (tmp_path / "main.cpp").write_text(program_of([low.kernel for low in chosen], kind))
    subprocess.run([COMPILER, *OPTIONS, "-o", "run", "main.cpp"], cwd=tmp_path, check=True)
    given, expected = [], []
    for low in chosen:
        values = values_of(low, dtype)
        entries = np.stack([values[symbol.name] for symbol in low.kernel.symbols], axis=-1)
        given.append(np.int64(len(entries)).tobytes() + entries.tobytes())
        with np.errstate(all="ignore"):
            expected.append(call(computed_once(function_of(low.kernel, algebroproj)), low.kernel, values))
    done = subprocess.run([tmp_path / "run"], input=b"".join(given), capture_output=True, check=True)
    results = np.frombuffer(done.stdout, dtype)
    assert results.size == sum(part.size for part in expected)
    start = 0
    for low, part in zip(chosen, expected, strict=True):
        computed = results[start : start + part.size].reshape(part.shape)
        start += part.size
        if low.kernel.qualified_name in CALLING:
            np.testing.assert_allclose(computed, part, 16 * np.finfo(dtype).eps, 0, err_msg=low.kernel.qualified_name)
        else:
            assert same_bits(computed, part), low.kernel.qualified_name


@compiling
def test_functions_run_while_a_program_is_compiled(files, tmp_path):
    write(files, tmp_path)
    (tmp_path / "main.cpp").write_text(
        '#include "algebroproj.hpp"\n'
        "constexpr auto image = algebroproj::optics::image_point(2.0, std::array<double, 3>{1.0, 2.0, 2.0});\n"
        "static_assert(image[0] == 0.5 && image[1] == 1.0 && image[2] == 1.0);\n"
        "int main() { return 0; }\n"
    )
    subprocess.run([COMPILER, *OPTIONS, "-o", "run", "main.cpp"], cwd=tmp_path, check=True)


@compiling
def test_the_example_of_the_documentation(repository, files, tmp_path):
    page = (repository / "docs" / "howto" / "use-from-cpp.md").read_text(encoding="utf-8")
    source = (repository / "docs" / "howto" / "use_from_cpp.cpp").read_text(encoding="utf-8")
    shown = re.search(r"^```text\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)[1]
    write(files, tmp_path / "algebroproj")
    (tmp_path / "main.cpp").write_text(source)
    subprocess.run([COMPILER, *OPTIONS, "-I.", "-o", "run", "main.cpp"], cwd=tmp_path, check=True)
    assert subprocess.run([tmp_path / "run"], capture_output=True, text=True, check=True).stdout == shown


def test_what_is_not_proved_is_not_written(tmp_path, repository, monkeypatch):
    derivation = str(repository / "derivations" / "fundamentals1996" / "s1_6_functions.py")
    wrong = {"render": lambda *given: {k: v.replace("f + xi3", "f - xi3") for k, v in render(*given).items()}}
    monkeypatch.setitem(BACKENDS, "cpp", SimpleNamespace(**wrong))
    arguments = ["generate", "--derivations", derivation, "--out", str(tmp_path), "--backend", "cpp"]
    done = CliRunner().invoke(main, arguments)
    assert done.exit_code == 1
    assert "to be proved, got optics.image_point" in done.output
    assert not (tmp_path / "algebroproj").exists()


def test_a_backend_is_its_folder_its_name_and_its_proof(repository):
    root = repository / "algebroproj_sym"
    naming = {path.relative_to(root).as_posix() for path in root.rglob("*.py") if "cpp" in path.read_text("utf-8")}
    outside = {name for name in naming if not name.startswith("generating/backends/cpp/")}
    proof = {"verifying/__init__.py", "verifying/proof_of_cpp_source.py", "cli/generate.py"}
    assert outside == {"generating/backends/__init__.py", *proof}


@pytest.mark.whole
def test_both_backends_may_write_to_one_folder(tmp_path, repository):
    derivation = str(repository / "derivations" / "fundamentals1996" / "s1_6_functions.py")
    arguments = ["generate", "--derivations", derivation, "--out", str(tmp_path), "--name", "lens"]
    for backend in ("numpy", "cpp", "numpy"):
        done = CliRunner().invoke(main, [*arguments, "--backend", backend])
        assert done.exit_code == 0, done.output
    for backend in ("numpy", "cpp"):
        assert CliRunner().invoke(main, [*arguments, "--backend", backend, "--check"]).exit_code == 0
    names = {path.name for path in (tmp_path / "lens").iterdir()}
    assert {"optics.py", "optics.hpp", "lens.hpp", "arithmetic.hpp", "_runtime"} <= names
    assert "namespace lens::optics {" in (tmp_path / "lens" / "optics.hpp").read_text()
