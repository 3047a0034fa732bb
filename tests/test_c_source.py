"""The C source says the same as the derivations, statement by statement; an error in it is found."""

import re
import shutil
import subprocess
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import pytest
import sympy
from cases import for_each

from algebroproj_sym import Section
from algebroproj_sym.declaring import ELEMENTARY, kernels
from algebroproj_sym.expressions import over, vector
from algebroproj_sym.generating.backends.c import c_files, c_name
from algebroproj_sym.generating.backends.c.printer import LONGEST, solver, stamped, statements
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.expansion import expanded
from algebroproj_sym.generating.program import Program, Step
from algebroproj_sym.generating.writing import PACKAGE
from algebroproj_sym.verifying.c_execution import Meaning, NotUnderstoodError, kernel_outputs, source_of
from algebroproj_sym.verifying.proof_of_c_source import (
    KERNELS,
    c_source_is_proved,
    kernel_is_proved,
    product_errors_are_proved,
    solver_is_proved,
)

FOLDER = Path(__file__).resolve().parent.parent / "generated" / PACKAGE / "_c"
TEXT = "".join((FOLDER / name).read_text(encoding="utf-8") for name in KERNELS)
SOURCE = source_of(TEXT)
COMPILED = {kernel.qualified_name: kernel for kernel in kernels() if c_name(kernel) in SOURCE.kernels}
SOLVERS = [("solve", 4), ("solve", 5), ("null_vector", 8)]


@pytest.fixture(scope="module")
def text():
    return TEXT


@pytest.fixture(scope="module")
def source():
    return SOURCE


def changed(text, old, new):
    assert text.count(old) == 1, old
    return source_of(text.replace(old, new))


def demonstration(name="second.half", symbols="x y"):
    x, y = sympy.symbols(symbols)
    return Section("demo", "1", "Demonstration").kernel(
        name,
        "A function.",
        arguments={str(x): x, "p": vector(y)},
        derived=vector(over(x, y), x + y),
        claims=["1.1"],
        example={str(x): "0.5", "p": ("0.25",)},
        describe={str(x): "A length in meters.", "p": "A point."},
    )


@pytest.mark.whole
def test_only_long_kernels_and_those_that_call_functions_of_the_c_library_are_left_out(lowered):
    left_out = {kernel.qualified_name for kernel in kernels()} - COMPILED.keys()
    calling = {k.qualified_name for k in kernels() if ELEMENTARY.keys() & {s.primitive for s in k.stages}}
    assert calling <= left_out
    for name in left_out - calling:
        assert len(expanded(lowered(name).program).steps) > LONGEST


def test_the_source_has_kernels_that_are_declared_and_no_other(source):
    assert source.kernels.keys() == {c_name(kernel) for kernel in COMPILED.values()}
    assert source.solvers.keys() == {f"{name}_{height}" for name, height in SOLVERS}


@pytest.mark.parametrize("name", [*COMPILED][::4])
def test_kernels_are_proved(name, source):
    """Some of them; a build does this for all."""
    assert kernel_is_proved(COMPILED[name], source)


@pytest.mark.parametrize(("name", "height"), SOLVERS)
def test_what_the_kernels_call_solves_linear_systems(name, height, source):
    assert solver_is_proved(source, name, height)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("up1 * upp1;", "up1 + upp1;"),
        ("const real up1 = in[0][i];", "const real up1 = in[1][i];"),
        ("out[0][i]", "out[1][i]"),
    ],
)
def test_a_planted_error_in_a_kernel_is_found(old, new):
    x, y = sympy.symbols("up1 upp1")
    kernel = Section("demo", "1", "Demonstration").kernel(
        "first.product",
        "A function.",
        arguments={"p": vector(x, y)},
        derived=vector(x * y, x),
        claims=["1.1"],
        example={"p": ("0.5", "0.25")},
        describe={"p": "A point."},
    )
    text = c_files([lower(kernel)], "")["kernels.h"]
    assert kernel_is_proved(kernel, source_of(text))
    wrong = changed(text, old, new)
    try:
        assert not kernel_is_proved(kernel, wrong)
    except NotUnderstoodError:
        assert new.startswith("out")


@pytest.mark.parametrize("name", ["correlation.correlation_matrix", "projection.projection_matrix"])
def test_each_exchange_of_one_operator_in_the_plain_source_of_a_kernel_is_found(name, lowered):
    plain = replace(lowered(name), program=lowered(name).plain)
    files = c_files([plain], "")
    source = source_of("".join(files[name] for name in KERNELS))
    (body,) = source.kernels.values()
    found = list(re.finditer(r"(?<== )(\w+) ([-+*/]) (\w+)(?=;)", body))
    assert len(found) > 20
    for place in found:
        other = {"+": "-", "-": "+", "*": "/", "/": "*"}[place[2]]
        wrong = f"{body[: place.start(2)]}{other}{body[place.end(2) :]}"
        assert not kernel_is_proved(COMPILED[name], replace(source, kernels={c_name(COMPILED[name]): wrong})), place


def small(primitive, refined):
    """Return the source of a function that solves systems of two equations, its name and its body."""
    parts = solver(primitive, 2, refined)
    head = "SOLVER" if refined else "SOLVER_ONCE"
    body = "\n".join(f"    {line}" for line in parts["body"])
    source = source_of(f"{head}({primitive}, 2, {parts['width']})\n{{\n{body}\n}}\n")
    ((name, body),) = source.solvers.items()
    return source, name, body


def is_found(source, name, body, primitive, refined):
    wrong = replace(source, solvers={name: body})
    try:
        return not solver_is_proved(wrong, primitive, 2, once=not refined)
    except NotUnderstoodError:
        return True


def magnitudes(body):
    """Return the names that stand for absolute values and what is computed from them: they decide the rank alone."""
    found = set()
    for name, value in re.findall(r"const real (\w+) = (.+);", body):
        operands = set(re.findall(r"[a-z]\w*", value.rpartition("?")[2]))
        if value.startswith("absolute(") or (operands and operands <= found):
            found.add(name)
    return found


@pytest.mark.parametrize("refined", [False, True])
@pytest.mark.parametrize("primitive", ["solve", "null_vector"])
def test_each_exchange_of_an_operator_or_of_a_choice_in_an_elimination_is_found(primitive, refined):
    """Elimination is what is done before the residual; of error terms, which are zero here, there are other tests.

    What decides the rank is held against NumPy, bit by bit, in test_rank.
    """
    source, name, body = small(primitive, refined)
    assert solver_is_proved(source, primitive, 2, once=not refined)
    elimination = body.partition("product_error")[0]
    if primitive == "null_vector" and not refined:
        elimination = elimination.rsplit("is_larger", 2)[0]  # the largest component is taken for 1
    sizes = magnitudes(body)
    assert bool(sizes) == refined
    places = list(re.finditer(r"(?<== )(\w+) ([-+*/]) (\w+)(?=;)", elimination))
    places = [place for place in places if sizes.isdisjoint(place.groups())]
    assert len(places) >= 6
    other = {"+": "-", "-": "+", "*": "+", "/": "*"}
    for place in places:
        wrong = f"{body[: place.start(2)]}{other[place[2]]}{body[place.end(2) :]}"
        assert is_found(source, name, wrong, primitive, refined), place
    first_comparison = re.search(r"const int (\w+) = is_larger", body)[1]
    choices = list(re.finditer(rf"{first_comparison} \? (\w+) : (\w+);", elimination))
    choices = [place for place in choices if sizes.isdisjoint(place.groups())]
    assert len(choices) >= 4
    for place in choices:
        wrong = f"{body[: place.start()]}{first_comparison} ? {place[2]} : {place[1]};{body[place.end() :]}"
        assert is_found(source, name, wrong, primitive, refined), place


@pytest.mark.parametrize("primitive", ["solve", "null_vector"])
def test_errors_planted_in_the_refinement_are_found(primitive):
    source, name, body = small(primitive, refined=True)
    negated = list(re.finditer(r"= -(\w+);", body))
    errors = list(re.finditer(r"product_error\((\w+), (\w+), (\w+)\)", body))
    corrected = list(re.finditer(r"const int \w+ = (\w+) - (\w+) == 0;", body))
    solution = list(re.finditer(r"solution\[(\d)\] = ", body))
    assert min(len(negated), len(errors), len(corrected), len(solution)) >= 2
    wrong = [f"{body[: p.start()]}= {p[1]};{body[p.end() :]}" for p in negated]
    wrong += [f"{body[: p.start()]}product_error({p[1]}, {p[1]}, {p[3]}){body[p.end() :]}" for p in errors]
    wrong += [f"{body[: p.start(1)]}{1 - int(p[1]) if int(p[1]) < 2 else 0}{body[p.end(1) :]}" for p in solution]
    for text in wrong:
        assert is_found(source, name, text, primitive, refined=True), text


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("const real a_low = a - a_high;", "const real a_low = a + a_high;"),
        ("(((a_high * b_high - p)", "(((a_high * b_high + p)"),
        ("multiply_add(a, b, -p)", "multiply_add(a, b, p)"),
    ],
)
def test_an_error_term_that_is_not_zero_in_real_arithmetic_is_found(old, new, text):
    wrong = changed(text, old, new)
    assert not (product_errors_are_proved(wrong) and solver_is_proved(wrong, "solve", 5))


def test_the_errors_of_products_are_proved(source):
    assert {"fused_product_error", "split_product_error"} <= source.inlines.keys()
    assert product_errors_are_proved(source)


@for_each(
    "body",
    [
        "out[0][i] = 1 / 2;",
        "out[0][i] = in[0][0];",
        "out[0][0] = in[0][i];",
        "out[0][i] = in[0][i + 1];",
        "const int x = in[0][i];\n        out[0][i] = x;",
        "const real x = in[0][i];\n        const real x = in[0][i];\n        out[0][i] = x;",
        "out[0][i] = sqrt(in[0][i]);",
        "out[0][i] = x;",
        "out[0][i] = in[0][i] ? in[0][i] : in[0][i];",
        "out[1][i] = in[0][i];",
        "out[0][i] = 0.5;",
        "if (i) out[0][i] = in[0][i];",
        "out[0][i] = in[0][i]",
    ],
)
def test_what_is_not_understood_is_refused(body):
    text = f"KERNEL(f)\n{{\n    for (npy_intp i = 0; i < points; i++) {{\n        {body}\n    }}\n}}\n"
    with pytest.raises(NotUnderstoodError):
        kernel_outputs(source_of(text), "f", [sympy.Symbol("x")], Meaning())


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("product_error(up1, upp1, t1)", "product_error(up1, up1, t1)"),
        ("range = within(range, up1);", "range = up1;"),
        ("range = within(range, up1);", "const real x = range;"),
        ("range = within(range, up1);", "range = within(up1, range);"),
        ("ranges[i] = range;", "out[1][i] = range;"),
        ("real range = headroom;", "real range = up1;"),
    ],
)
def test_the_range_of_operands_and_errors_of_other_products_are_refused_elsewhere(old, new):
    text = "KERNEL(f)\n{\n    for (npy_intp i = 0; i < points; i++) {\n        STATEMENTS\n    }\n}\n"
    lines = ["real range = headroom;", "const real up1 = in[0][i];", "const real upp1 = in[1][i];"]
    lines += ["const real t1 = up1 * upp1;", "const real t2 = product_error(up1, upp1, t1);", "out[0][i] = t2;"]
    right = text.replace("STATEMENTS", " ".join([*lines, "range = within(range, up1);", "ranges[i] = range;"]))
    symbols = [sympy.Symbol("x"), sympy.Symbol("y")]
    assert kernel_outputs(source_of(right), "f", symbols, Meaning()) == [0]
    with pytest.raises(NotUnderstoodError):
        kernel_outputs(changed(right, old, new), "f", symbols, Meaning())


@for_each("name", COMPILED)
def test_the_range_of_every_operand_of_a_product_whose_error_is_taken_is_kept(name, source):
    """Squares that are kept are less than a 4096th of the largest number: so products must be of fewer terms."""
    body = re.sub(r"constant\((\d+)\)", r"\1", source.kernels[c_name(COMPILED[name])])
    kept = {*re.findall(r"within\(range, (.+?)\)", body)}
    sums = {name: parts for name, *parts in re.findall(r"const real (\w+) = (\w+) [-+] (\w+);", body)}
    sums |= {name: [part] for name, part in re.findall(r"const real (\w+) = -(\w+);", body)}

    @cache
    def terms(operand):
        if operand.isdecimal():
            return max(int(operand), 1)
        return 1 if operand in kept else sum(map(terms, sums[operand]))

    for left, right in re.findall(r"product_error\((.+?), (.+?), .+?\)", body):
        assert terms(left) * terms(right) <= 1024


@pytest.mark.parametrize(("name", "height"), SOLVERS)
def test_the_range_of_every_operand_of_a_product_in_a_solver_is_kept(name, height, source):
    body = source.solvers[f"{name}_{height}"]
    operands = {operand for pair in re.findall(r"product_error\((.+?), (.+?), .+?\)", body) for operand in pair}
    assert operands == set(re.findall(r"within\(range, (.+?)\)", body))


@pytest.mark.parametrize("head", ["#define t0 0", "static int x;"])
def test_nothing_stands_between_the_functions(head):
    with pytest.raises(NotUnderstoodError, match="nothing but functions"):
        source_of(f"{head}\nKERNEL(f)\n{{\n}}\n")


def test_a_loop_over_other_points_is_refused():
    text = "KERNEL(f)\n{\n    for (npy_intp i = 1; i < points; i++) {\n        out[0][i] = 1;\n    }\n}\n"
    with pytest.raises(NotUnderstoodError, match="nothing but loops over them"):
        kernel_outputs(source_of(text), "f", [], Meaning())


def test_a_package_without_its_c_source_is_not_proved(tmp_path):
    package = SimpleNamespace(__file__=str(tmp_path / "__init__.py"))
    (tmp_path / "_c").mkdir()
    assert not c_source_is_proved(lower(demonstration()), package)
    files = c_files([lower(demonstration())], "")
    for name in KERNELS:
        assert not c_source_is_proved(lower(demonstration()), package)
        (tmp_path / "_c" / name).write_text(files[name], encoding="utf-8")
    assert c_source_is_proved(lower(demonstration()), package)


def test_names_that_c_does_not_leave_free_are_changed():
    kernel = demonstration(symbols="double value_0")
    text = c_files([lower(kernel)], "")["kernels.h"]
    assert "const real double" not in text
    assert kernel_is_proved(kernel, source_of(text))


def test_what_no_output_needs_is_not_computed():
    program = Program(("x", "y"), (Step("t0", "+", ("x", "y")), Step("t1", "neg", ("t0",))), ("x",))
    assert statements(program) == ["const real x = in[0][i];", "out[0][i] = x;"]


def test_constants_are_handed_to_functions_for_four_points_at_a_time_too():
    steps = (Step("t0", "*", ("x", 3)), Step("t1", "product_error", ("x", 3, "t0")))
    assert "const real t1 = product_error(x, constant(3), t0);" in statements(Program(("x",), steps, ("t1",)))


def test_the_digest_depends_on_every_c_file():
    files = {"a.c": "1", "b.h": "2", "c.py": "DIGEST_OF_THE_SOURCE"}
    digests = {stamped(files | change)["c.py"] for change in ({}, {"a.c": "3"}, {"b.h": "3"})}
    assert len(digests) == 3


@pytest.mark.parametrize("compiler", sorted({"cc", "clang"} & {name for name in ("cc", "clang") if shutil.which(name)}))
def test_the_formulas_are_c99_without_warnings(compiler, text, tmp_path):
    head = """
        #include <float.h>
        #include <math.h>
        #include <stddef.h>
        enum { BLOCK = 64 };
        typedef ptrdiff_t npy_intp;
        #define real double
        #define splitter 134217729.0
        #define headroom (DBL_MAX / 2)
        #define constant(number) number
        #define absolute fabs
        #define multiply_add fma
        #define product_error NAME(split_product_error)
        #define within(range, operand) multiply_add(operand, operand, range)
        #define is_larger(first, second) isgreater(fabs(first), fabs(second))
        #define NAME(name) name
        #define INLINE(name) static inline real name
        #define SOLVER(name, height, width) \\
            static inline real name##_##height( \\
                const real system[height][2 * height + 2], real solution[width], real range)
        #define KERNEL(name) \\
            void name(const real (*restrict)[BLOCK], real (*restrict)[BLOCK], real *restrict, const npy_intp); \\
            void name(const real (*restrict in)[BLOCK], real (*restrict out)[BLOCK], real *restrict ranges, \\
                      const npy_intp points)
    """
    file = tmp_path / "kernels.c"
    file.write_text(head + text, encoding="utf-8")
    options = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"]
    subprocess.run([compiler, *options, str(file)], check=True)
