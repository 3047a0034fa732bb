"""Functions without compensation: the same formulas, interfaces and errors, the same bits compiled and not."""

import inspect
import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import array_api_strict
import mpmath
import numpy as np
import pytest
import sympy
from cases import for_each

import algebroproj
from algebroproj import correlation, normal_case, optics, projection
from algebroproj_sym.declaring import ELEMENTARY, kernels
from algebroproj_sym.generating.backends.c import c_name, plain_files
from algebroproj_sym.generating.program import run
from algebroproj_sym.generating.runtime.systems import null_vector_once, solve_once
from algebroproj_sym.generating.samples import stratified
from algebroproj_sym.generating.writing import PACKAGE
from algebroproj_sym.verifying.accuracy import truths
from algebroproj_sym.verifying.c_execution import Meaning, NotUnderstoodError, plain_outputs, source_of
from algebroproj_sym.verifying.proof_of_c_source import plain_kernel_is_proved, solver_is_proved
from algebroproj_sym.verifying.proof_of_source import source_is_proved
from algebroproj_sym.verifying.shipped import call, function_of, without_twin
from algebroproj_sym.verifying.verification import SPECIAL, same_bits

KERNELS = {kernel.qualified_name: kernel for kernel in kernels()}
RATIONAL = [name for name, kernel in KERNELS.items() if {s.primitive for s in kernel.stages} <= {"let"}]
FOLDER = Path(__file__).resolve().parent.parent / "generated" / PACKAGE
SOURCE = source_of((FOLDER / "_c" / "plain_kernels.h").read_text(encoding="utf-8"))
DTYPES = (np.float32, np.float64, np.longdouble)
compiled = pytest.mark.skipif(algebroproj.backend() != "compiled", reason="the package was built without a C compiler")


def plain_of(kernel):
    return algebroproj.plain(function_of(kernel, algebroproj))


def numbers(shape, dtype, seed):
    """Draw numbers of which some are special."""
    generator = np.random.default_rng(seed)
    drawn = generator.uniform(-4, 4, shape).astype(dtype)
    with np.errstate(over="ignore"):
        special = generator.choice(np.array(SPECIAL), shape).astype(dtype)
    return np.where(generator.random(shape) < 0.02, special, drawn)


def arguments_of(kernel, dtype=np.float64, batch=(3003,)):
    """Draw arguments, so many that some points are left when a compiler has taken the others several at a time."""
    return [numbers((*batch, *a.shape), dtype, seed) for seed, a in enumerate(kernel.arguments)]


def assert_same(first, second):
    pairs = zip(*(each if isinstance(each, tuple) else (each,) for each in (first, second)), strict=True)
    assert all(same_bits(np.asarray(one), np.asarray(other)) for one, other in pairs)


# What is computed


@for_each("name", [*KERNELS][::4])
def test_the_python_source_is_proved_without_compensation(name):
    assert source_is_proved(KERNELS[name], algebroproj, plain=True)


@pytest.mark.sampled(12)
@pytest.mark.parametrize("name", RATIONAL)
def test_every_operation_of_the_program_rounds_once(name, lowered):
    low = lowered(name)
    values = {s.name: np.random.default_rng(k).uniform(0.1, 3, 50) for k, s in enumerate(low.kernel.symbols)}
    with np.errstate(all="ignore"):
        computed = call(plain_of(low.kernel), low.kernel, values)
        expected = np.broadcast_arrays(*run(low.plain, values, lambda _, rows: rows[0]), values[low.plain.inputs[0]])[
            :-1
        ]
    assert same_bits(computed, np.stack(expected, axis=-1).astype(float))


@compiled
@for_each("name", KERNELS)
def test_compiled_functions_give_the_bits_of_the_numpy_source(name):
    kernel = KERNELS[name]
    function, arguments = plain_of(kernel), arguments_of(kernel)
    with np.errstate(all="ignore"):
        assert_same(function(*arguments), without_twin(function)(*arguments))


@compiled
def test_all_functions_are_compiled_but_those_that_call_the_c_library():
    calling = {name for name, kernel in KERNELS.items() if ELEMENTARY.keys() & {s.primitive for s in kernel.stages}}
    assert {c_name(KERNELS[name]) for name in KERNELS.keys() - calling} == SOURCE.plains.keys()


@pytest.mark.parametrize("size", [1, 2, 5, 8])
def test_systems_are_solved_to_a_small_backward_error(size):
    system = np.random.default_rng(size).normal(size=(200, size, size + 1))
    solution = np.stack(solve_once(*np.moveaxis(system, 0, -1)), axis=-1)
    matrix, right = system[..., :-1], system[..., -1]
    residual = np.abs(np.einsum("nij,nj->ni", matrix, solution) - right).max(axis=-1)
    scale = np.abs(matrix).sum(axis=-1).max(axis=-1) * np.abs(solution).max(axis=-1)
    assert (residual <= 20 * size * np.finfo(float).eps * scale).all()
    vector = np.stack(null_vector_once(*np.moveaxis(system, 0, -1)), axis=-1)
    assert (np.abs(np.einsum("nij,nj->ni", system, vector)).max(axis=-1) <= 1e-12 * size).all()
    assert (np.abs(vector).max(axis=-1) == 1).all()


@pytest.mark.parametrize("name", ["projection.projection_matrix", "correlation.correlation_matrix"])
def test_bounds_hold_of_what_is_computed_without_compensation(name, lowered):
    low = lowered(name)
    samples = stratified(low, 10)
    values = {s.name: np.array([sample.values[s.name] for sample in samples]) for s in low.kernel.symbols}
    function = plain_of(low.kernel)
    bounded = algebroproj.bounds(function)
    computed, bounds = (call(lambda *a, part=part: bounded(*a)[part], low.kernel, values) for part in range(2))
    with np.errstate(all="ignore"):
        assert same_bits(computed, call(function, low.kernel, values))
    with mpmath.workdps(60):
        for row, truth in enumerate(truths(low, samples)):
            for value, bound, exact in zip(computed[row], bounds[row], truth.values, strict=True):
                assert not np.isfinite(bound) or abs(mpmath.mpf(value) - exact) <= mpmath.mpf(bound)
    assert np.isfinite(bounds).mean() > 0.5


def test_compensation_is_what_is_missing():
    near = [0.3, 0.3, 0.4 - 2.0**-50], [0.25, 0.125]
    exact = projection.mu_from_center(*(np.array([*map(Fraction, part)], object) for part in near))
    errors = [
        max(abs(Fraction(value) / true - 1) for value, true in zip(version(*near).tolist(), exact, strict=True))
        for version in (projection.mu_from_center, algebroproj.plain(projection.mu_from_center))
    ]
    assert errors[0] < 1e-15 < 1e-3 < errors[1]


# How it is called


@for_each("name", KERNELS)
def test_the_interface_is_that_of_the_function(name):
    function = function_of(KERNELS[name], algebroproj)
    plain = algebroproj.plain(function)
    assert inspect.signature(plain) == inspect.signature(function)
    assert (plain.__name__, plain.__module__) == (function.__name__, function.__module__)
    assert function.__doc__ in plain.__doc__


@for_each("name", ["projection.projection_matrix", "correlation.correlation_matrix"])
@for_each("count", [0, 1, 31, 32, 33, 64, 129, 20_000])
def test_batches_of_any_length_and_memory_of_any_layout(name, count):
    kernel = KERNELS[name]
    function = plain_of(kernel)
    arguments = arguments_of(kernel, batch=(count,))
    spread = [np.repeat(a, 2, axis=0)[::2] for a in arguments]
    mirrored = [np.asfortranarray(a) for a in arguments]
    with np.errstate(all="ignore"):
        expected = without_twin(function)(*arguments)
        assert_same(function(*arguments), expected)
        assert_same(function(*spread), expected)
        assert_same(function(*mirrored), expected)
        out = np.full((count, 3, 6), 7.0)[:, :, ::2]
        assert function(*arguments, out=out) is out
        assert_same(out, expected)
        other = np.full((3, 3, count), 7.0).transpose(2, 0, 1)
        assert_same(without_twin(function)(*arguments, out=other), expected)
    assert (out.base.reshape(count, 3, 6)[..., 1::2] == 7).all()


def test_leading_dimensions_broadcast():
    function = algebroproj.plain(projection.projection_matrix)
    y0, u3 = arguments_of(KERNELS["projection.projection_matrix"], batch=(40, 6))
    with np.errstate(all="ignore"):
        for arguments in ([y0[:, :1], u3[0]], [y0[0, 0], u3], [y0, u3[0, 0]], [y0[:1], u3[:, ::-1]]):
            filled = [
                np.broadcast_to(a, (*np.broadcast_shapes(*(b.shape[:-1] for b in arguments)), a.shape[-1]))
                for a in arguments
            ]
            expected = without_twin(function)(*map(np.ascontiguousarray, filled))
            assert_same(function(*arguments), expected)
            assert_same(without_twin(function)(*arguments), expected)


def test_results_may_share_memory_with_arguments():
    function = algebroproj.plain(normal_case.map_points)
    tau, u = arguments_of(KERNELS["normal_case.map_points"], batch=(300,))
    for version in (function, without_twin(function)):
        memory = np.concatenate([u, u])
        with np.errstate(all="ignore"):
            expected = version(tau, memory[10:310].copy())
            version(tau, memory[10:310], out=memory[:300])
        assert_same(memory[:300], expected)


def test_dtypes_are_those_of_the_function():
    scale = algebroproj.plain(optics.scale)
    for dtype in (np.float16, *DTYPES, np.complex64, np.complex128):
        assert scale(np.array([2, 3], dtype), np.array(5, dtype)).dtype == dtype
    assert scale([1, 2], 5).dtype == np.float64
    assert scale(Fraction(1), np.array(Fraction(2))) == Fraction(1, 3)


@pytest.mark.parametrize("name", ["projection.projection_matrix", "correlation.correlation_matrix"])
def test_arrays_of_the_standard(name):
    arguments = [np.abs(a) + 0.5 for a in arguments_of(KERNELS[name], batch=(4,))]
    function = plain_of(KERNELS[name])
    with np.errstate(all="ignore"):
        result = function(*map(array_api_strict.asarray, arguments))
        assert_same(np.asarray(result), function(*arguments))


def test_errors_are_those_of_the_function():
    y0, u3 = arguments_of(KERNELS["projection.projection_matrix"], batch=(3,))
    function = projection.projection_matrix
    cases = [((y0[:, :2], u3), {}), ((y0, u3[:2]), {}), ((y0, "a"), {}), ((y0, u3), {"out": np.empty(3)}), ((y0,), {})]
    for arguments, options in cases:
        messages = []
        for version in (function, algebroproj.plain(function)):
            with pytest.raises((TypeError, ValueError)) as caught:
                version(*arguments, **options)
            messages.append(str(caught.value))
        assert messages[0] == messages[1]


def test_singular_input_warns():
    function = algebroproj.plain(optics.scale)
    for version in (function, without_twin(function)):
        with pytest.warns(RuntimeWarning):
            version(np.array([1.0, 1.0]), np.array([2.0, -1.0]))


def test_what_is_no_generated_function_is_refused():
    with pytest.raises(TypeError, match="plain: expected a generated function, got sum"):
        algebroproj.plain(sum)


def test_functions_of_functions_take_it():
    third = algebroproj.dd(algebroproj.plain(optics.scale))(1.0, 2.0)
    assert (float(third.hi), float(third.lo)) == (1 / 3, 1.850371707708594e-17)
    assert algebroproj.hypotheses(algebroproj.plain(optics.scale))(1.0, 2.0) == algebroproj.hypotheses(optics.scale)(
        1.0, 2.0
    )


# The C source


@for_each("name", [name for name, kernel in KERNELS.items() if c_name(kernel) in SOURCE.plains][::4])
def test_the_c_source_is_proved(name):
    assert plain_kernel_is_proved(KERNELS[name], SOURCE)


@pytest.mark.parametrize(("primitive", "height"), [("solve", 5), ("null_vector", 8)])
def test_the_solvers_of_the_c_source_are_proved(primitive, height):
    assert solver_is_proved(SOURCE, primitive, height, once=True)


def is_accepted(kernel, source):
    try:
        return plain_kernel_is_proved(kernel, source)
    except NotUnderstoodError:
        return False


@pytest.mark.parametrize(
    "name",
    [
        "correlation.correlation_matrix",
        "projection.projection_matrix",
        pytest.param("critical.determinant", marks=pytest.mark.whole),
    ],
)
def test_each_exchange_of_an_operator_or_of_two_rows_or_entries_is_found(name, lowered):
    source = source_of(plain_files([lowered(name)], "")["plain_kernels.h"])
    ((kernel, body),) = source.plains.items()
    operators = list(re.finditer(r"(?<== )(\w+) ([-+*/]) (\w+)(?=;)", body))
    rows = list(
        re.finditer(r"= rows\[(\d+)\]\[i\]", body) if "rows" in body else re.finditer(r"out0\[i\]\[(\d+)\] =", body)
    )
    assert min(len(operators), len(rows)) > 5
    wrong = [
        f"{body[: p.start(2)]}{ {'+': '-', '-': '+', '*': '/', '/': '*'}[p[2]] }{body[p.end(2) :]}" for p in operators
    ]
    other = {p[1]: rows[k - 1][1] for k, p in enumerate(rows)}
    wrong += [f"{body[: p.start(1)]}{other[p[1]]}{body[p.end(1) :]}" for p in rows]
    for text in wrong:
        assert not is_accepted(KERNELS[name], replace(source, plains={kernel: text})), text


BODY = """PLAIN(f)(const real (*restrict in0)[2], real (*restrict out0)[1], const npy_intp points)
{
    real rows[1][32];
    for (npy_intp i = 0; i < points; i++) {
        const real x = in0[i][1];
        rows[0][i] = x;
    }
    for (npy_intp i = 0; i < points; i++) {
        out0[i][0] = rows[0][i];
    }
}

CALL(f, 32, (const real (*)[2])data[0] + first, (real (*)[1])data[1] + first)
"""


@for_each(
    ("old", "new"),
    [
        ("in0)[2]", "in0)[3]"),
        ("(*)[2]", "(*)[3]"),
        ("data[1] + first", "data[0] + first"),
        ("CALL(f, 32", "CALL(f, 64"),
        ("CALL(f, 32", "CALL(f, all"),
        ("CALL(f", "CALL(g"),
        ("rows[1][32]", "rows[0][32]"),
        ("in0[i][1]", "in0[i][2]"),
        ("in0[i][1]", "in0[0][1]"),
        ("in0[i][1]", "rows[0][i]"),
        ("out0[i][0] =", "out0[i][1] ="),
        ("out0[i][0] =", "in0[i][0] ="),
        ("out0[i][0] = rows[0][i]", "out0[i][0] = x"),
        ("out0[i][0] = rows[0][i]", "out0[i][0] = rows[i][0]"),
        ("out0[i][0] = rows[0][i]", "g(rows, out0)"),
        ("real rows", "int rows"),
    ],
)
def test_what_is_not_understood_is_refused(old, new):
    x = sympy.symbols("x0 x1")
    assert plain_outputs(source_of(BODY), "f", [x], [1], Meaning()) == [x[1]]
    assert BODY.count(old) == 1
    with pytest.raises(NotUnderstoodError):
        plain_outputs(source_of(BODY.replace(old, new)), "f", [x], [1], Meaning())


def test_two_functions_of_one_name_are_refused():
    function = BODY.partition("CALL")[0]
    with pytest.raises(NotUnderstoodError, match="two of f"):
        source_of(function + function.replace("PLAIN", "NARROW"))


@pytest.mark.parametrize(
    ("name", "head", "copied"),
    [
        ("affine.space_frame", "NARROW", False),  # twelve entries become sixteen, with hardly an operation
        ("projection.projection_matrix", "NARROW", False),
        ("normal_case.tau", "PLAIN", False),  # pairs of entries are in order
        ("orientation.intersect", "PLAIN", False),
        ("projection.reconstruction_matrix", "PLAIN", True),
        ("correlation.correlation_matrix", "PLAIN", True),  # elimination is much to compute
    ],
)
def test_entries_are_copied_and_vectors_are_long_where_there_is_enough_to_compute(name, head, copied, lowered):
    text = plain_files([lowered(name)], "")["plain_kernels.h"]
    assert f"\n{head}({name.replace('.', '_')})(" in text
    assert ("real rows[" in text) == copied


def test_on_ordinary_input_little_is_missing():
    left, right = np.random.default_rng(0).uniform(0.1, 0.9, (2, 100, 5, 2))
    refined = correlation.correlation_matrix(left, right)
    once = algebroproj.plain(correlation.correlation_matrix)(left, right)
    assert np.median(abs(once - refined)) < 1e-13
