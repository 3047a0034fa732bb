"""Errors of counts, stages and their verification that were found by testing; a test that hangs is stopped."""

import signal

import numpy as np
import pytest
import sympy

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError, cos_sin, judge, let, null_vector, solution
from algebroproj_sym.expressions import Matrix, over, vector
from algebroproj_sym.generating.backends.numpy import render
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.runtime import systems
from algebroproj_sym.generating.samples import stratified
from algebroproj_sym.generating.writing import PACKAGE, write
from algebroproj_sym.verifying.proof_of_source import source_is_proved
from algebroproj_sym.verifying.shipped import load_package

x, y, z, a, b, c, d, e, s, phi = sympy.symbols("x y z a b c d e s phi")


@pytest.fixture(autouse=True)
def _limited():
    def stop(*_):
        raise TimeoutError("does not end")

    signal.signal(signal.SIGALRM, stop)
    signal.alarm(15)
    yield
    signal.alarm(0)


def of_xy(derived, through, **options):
    parts = {
        "arguments": {"x": x, "y": y},
        "example": {"x": "0.5", "y": "0.25"},
        "describe": {"x": "A number.", "y": "A number."},
    } | options
    return Section("demo", "1", "D").kernel("demo.f", "A.", derived=derived, through=through, claims=["1.1"], **parts)


def shipped(folder, kernel, *changes):
    files = render([lower(kernel)])
    for old, new in changes:
        assert old in files["demo.py"]
        files["demo.py"] = files["demo.py"].replace(old, new)
    write(files, folder / PACKAGE)
    return load_package(folder)


# generating/samples.py: `_near` never ends, or raises


@pytest.mark.parametrize(
    "matrix",
    [[[x, -y], [y, x]], [[1, x], [0, 1]], [[x, y], [x, y]]],
    ids=["not affine in any variable", "constant determinant", "always singular"],
)
def test_samples_near_a_singular_system_end(matrix):
    lowered = lower(of_xy(vector(a, b), [solution([a, b], Matrix(matrix), vector(1, y))]))
    assert len(stratified(lowered, 3)) >= 6


def test_samples_near_a_hypothesis_that_is_not_affine_end():
    assert len(stratified(lower(of_xy(over(1, x**2 + y**2), [])), 3)) >= 6


def test_samples_near_a_singular_system_with_divisions():
    lowered = lower(of_xy(vector(a, b), [solution([a, b], Matrix([[over(1, x), y], [y, x]]), vector(1, y))]))
    assert len(stratified(lowered, 3)) >= 6


# generating/runtime/systems.py


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_equal_equations_are_singular_whatever_their_entries():
    assert not np.isfinite(systems.solve([1.0, 49.0, 1.0], [1.0, 49.0, 2.0])).any()
    assert not np.isfinite(systems.null_vector([1.0, 49.0, 3.0], [1.0, 49.0, 3.0])).all()


def test_integers_are_numbers():
    assert [float(v) for v in systems.solve([2, 1, 4], [1, 3, 1])] == pytest.approx([2.2, -0.4])
    assert [float(v) for v in systems.null_vector([2, 3])] == pytest.approx([1, -2 / 3])


def test_a_constant_system_is_solved(tmp_path):
    kernel = of_xy(a * x, [solution([a, b], Matrix([[3, 1], [1, 2]]), vector(1, 1))])
    assert shipped(tmp_path, kernel).demo.f(1.0, 2.0) == pytest.approx(0.2)


# verifying/proof_of_source.py

TWO = of_xy(
    vector(a, b, c, d, e),
    [
        solution([a, b], Matrix([[x, y], [y + 1, x]]), vector(1, 2 * x)),
        null_vector([c, d, e], Matrix([[x, y, 1], [y, x, 2]])),
    ],
)


def test_another_primitive_function_is_not_proved(tmp_path):
    exchanged = [("b = solve(", "b = third("), ("e = null_vector(", "e = solve("), ("b = third(", "b = null_vector(")]
    assert not source_is_proved(TWO, shipped(tmp_path, TWO, *exchanged))


def test_rows_that_are_grouped_in_another_way_are_not_proved(tmp_path):
    kernel = of_xy(vector(a, b), [solution([a, b], Matrix([[x, y], [y + 1, x]]), vector(1, 2 * x))])
    regrouped = "        [x, y], [1, wide(y) + 1], [x, 2 * wide(x)],"
    package = shipped(tmp_path, kernel, ("        [x, y, 1],\n        [wide(y) + 1, x, 2 * wide(x)],", regrouped))
    assert not source_is_proved(kernel, package)


def test_a_call_too_many_is_not_proved(tmp_path):
    kernel = of_xy(c, [cos_sin(c, s, x)])
    assert not source_is_proved(
        kernel, shipped(tmp_path, kernel, ("    return (c,)", "    c, s = cos_sin(c)\n    return (c,)"))
    )


def test_a_module_without_the_primitive_function_is_not_proved(tmp_path):
    kernel = of_xy(c, [cos_sin(c, s, x)])
    changes = ("from ._runtime.cos_sin import cos_sin\n", ""), ("c, s = cos_sin(x)", "c, s = x, y")
    assert not source_is_proved(kernel, shipped(tmp_path, kernel, *changes))


# declaring: names


@pytest.mark.parametrize(
    "through",
    [[cos_sin(x, s, x)], [let({s: x}), let({s: y})], [let({s: x}), cos_sin(c, s, s)]],
    ids=["an argument", "twice", "an earlier result"],
)
def test_a_stage_gives_new_symbols(through):
    with pytest.raises(DeclarationError):
        of_xy(s * x, through)


@pytest.mark.parametrize("name", ["lambda", "out", "arguments", "cos_sin"])
def test_names_of_stages_are_free_in_the_generated_code(name):
    symbol = sympy.Symbol(name)
    with pytest.raises(DeclarationError):
        of_xy(symbol * c, [let({symbol: x}), cos_sin(c, s, y)])


@pytest.mark.parametrize("name", ["lambda", "a b", "t0", "arguments"])
def test_names_of_results_are_free_in_the_generated_code(name):
    with pytest.raises(DeclarationError):
        of_xy({name: x * y, "other": x * y + x}, [])


# declaring: nonsense is a DeclarationError


@pytest.mark.parametrize(
    "declare",
    [
        lambda: Section("demo", "1", "D").count(
            "1.1", "t", printed=1, derived=x * y, variables=[x, y], kernel=[vector(x)]
        ),
        lambda: Section("demo", "1", "D").count("1.1", "t", printed=x, derived=x * y, variables=[x, y]),
        lambda: Section("demo", "1", "D").count(
            "1.1", "t", printed=0, derived=x, variables=[x + 1], kernel=[vector(1)]
        ),
        lambda: Section("demo", "1", "D").rank("1.1", "t", printed=1, derived=x),
    ],
    ids=["direction too short", "symbol as count", "expression as variable (proved!)", "rank of a scalar"],
)
def test_nonsense_is_refused(declare):
    with pytest.raises(DeclarationError):
        judge(declare())


@pytest.mark.parametrize(
    "declare",
    [
        lambda: let({a: x}, form={b: x}),
        lambda: let({a: x}, form={a: x, b: y}),
        lambda: solution([a, b], Matrix([[x, y], [y, x]]), vector(1, 1), form=x),
    ],
    ids=["form for another name", "form for too many names", "scalar form"],
)
def test_forms_that_do_not_fit_are_refused(declare):
    with pytest.raises(DeclarationError):
        declare()


def test_a_single_equation_can_be_solved():
    assert solution([a], Matrix([[x]]), vector(y)).results == (a,)


# hypotheses and the oracle
