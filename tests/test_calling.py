"""How bodies are called: in blocks, into any memory, and with arrays of other libraries."""

import sys
import threading
import tracemalloc
import warnings
from fractions import Fraction
from itertools import product

import array_api_strict
import mpmath
import numpy as np
import pytest
import sympy
from cases import for_each
from hypothesis import given
from hypothesis import strategies as st

import algebroproj
from algebroproj import collinearity, correlation, metric, normal_case, optics, projection, space
from algebroproj_sym.declaring import kernels
from algebroproj_sym.generating.runtime import evaluation, threads
from algebroproj_sym.generating.runtime.evaluation import Signature, evaluate
from algebroproj_sym.generating.runtime.namespace import is_traced
from algebroproj_sym.verifying.shipped import function_of, load_package, without_twin

PAIR = Signature("pair", (("x", (2,)), ("M", (2, 2)), ("s", ())), ((), (2, 2)), block=7)
SHAPES = [(), (1,), (5,), (30,), (3, 1), (1, 4), (6, 5), (2, 1, 5)]


def pair(x0, x1, m00, m01, m10, m11, s):
    """Return a number and a matrix with constant entries and one that depends on a single argument."""
    return x0 * m00 + x1 * m01 / s, x0 / m10, 0, s, m11 * x1 - 1


def drawn(shape, seed, dtype=np.float64):
    return np.random.default_rng(seed).uniform(0.5, 2, shape).astype(dtype)


def plainly(x, m, s):
    """Evaluate point by point."""
    batch = np.broadcast_shapes(x.shape[:-1], m.shape[:-2], s.shape)
    x, m, s = np.broadcast_to(x, (*batch, 2)), np.broadcast_to(m, (*batch, 2, 2)), np.broadcast_to(s, batch)
    first, second = np.empty(batch, x.dtype), np.empty((*batch, 2, 2), x.dtype)
    for index in np.ndindex(*batch):
        value, *entries = pair(*x[index], *m[index].ravel(), s[index])
        first[index], second[index] = value, np.reshape(entries, (2, 2))
    return first, second


def arguments(batches, dtype=np.float64):
    cores = [core for _, core in PAIR.arguments]
    return [drawn(batch + core, k, dtype) for k, (batch, core) in enumerate(zip(batches, cores, strict=True))]


def broadcastable(batches):
    try:
        np.broadcast_shapes(*batches)
    except ValueError:
        return False
    return True


batches = st.tuples(*[st.sampled_from(SHAPES)] * 3).filter(broadcastable)


@given(batches, st.integers(1, 40), st.sampled_from([np.float32, np.float64, np.longdouble, np.complex128]))
def test_blocks_of_any_size_give_the_bits_of_single_points(shapes, block, dtype):
    given_arguments = arguments(shapes, dtype)
    results = evaluate(Signature("pair", PAIR.arguments, PAIR.results, block), pair, given_arguments)
    for result, expected in zip(results, plainly(*given_arguments), strict=True):
        assert result.dtype == dtype
        np.testing.assert_array_equal(result, expected)


LAYOUTS = {
    "C": lambda shape: np.empty(shape),
    "Fortran": lambda shape: np.empty(shape, order="F"),
    "every other": lambda shape: np.empty([2 * length for length in shape])[
        (..., *[slice(None, None, 2)] * len(shape))
    ],
    "backwards": lambda shape: np.empty(shape)[(..., *[slice(None, None, -1)] * len(shape))],
}


@pytest.mark.parametrize("layout", LAYOUTS)
@given(batches)
def test_out_of_any_layout_is_filled_and_returned(layout, shapes):
    given_arguments = arguments(shapes)
    expected = plainly(*given_arguments)
    out = tuple(LAYOUTS[layout](value.shape) for value in expected)
    results = evaluate(PAIR, pair, given_arguments, out)
    assert all(result is array for result, array in zip(results, out, strict=True))
    for result, value in zip(results, expected, strict=True):
        np.testing.assert_array_equal(result, value)


FORWARDS, BACKWARDS = slice(None), slice(None, None, -1)


@pytest.mark.parametrize(
    ("before", "after"),
    [*product([FORWARDS, BACKWARDS], repeat=2), (slice(3, None), slice(None, -3)), (slice(None, -3), slice(3, None))],
)
def test_out_may_share_memory_with_the_arguments(before, after):
    points = drawn((30000, 3), 1)
    center, image = np.array([0.5, 0.25, 2.0]), np.array([0.25, 0.5])
    mu = projection.mu_from_center(center, image)
    expected = optics.image_point(0.15, points[before].copy())
    assert optics.image_point(0.15, points[before], out=points[after]).base is points
    np.testing.assert_array_equal(points[after], expected)
    plane = drawn((20000, 3), 2)
    image_points = projection.project(plane.copy(), mu, image)
    projection.project(plane, mu, image, out=plane[:, :2])
    np.testing.assert_array_equal(plane[:, :2], image_points)


def test_several_results_take_several_arrays():
    matrices = drawn((5, 3, 3), 4)
    out = np.empty((5, 2)), np.empty((5, 2))
    assert correlation.epipoles(matrices, out=out)[1] is out[1]
    for result, expected in zip(out, correlation.epipoles(matrices), strict=True):
        np.testing.assert_array_equal(result, expected)


def test_a_single_point_fills_its_array():
    out = np.empty(3)
    assert optics.image_point(0.15, [1.0, 2.0, 3.0], out=out) is out
    np.testing.assert_array_equal(out, optics.image_point(0.15, [1.0, 2.0, 3.0]))


def test_the_same_array_for_two_results_is_refused():
    matrices, out = drawn((5, 3, 3), 4), np.empty((5, 4))
    with pytest.raises(ValueError, match="epipoles: expected arrays of their own as out, got some that share memory"):
        correlation.epipoles(matrices, out=(out[:, :2], out[:, 1:3]))
    correlation.epipoles(matrices, out=(out[:, ::2], out[:, 1::2]))
    np.testing.assert_array_equal(out[:, 1::2], correlation.epipoles(matrices)[1])


@pytest.mark.parametrize("wrapper", ["dd", "bounds", "hypotheses", "plain", "rounded", None])
def test_masked_arrays_are_refused_by_the_name_of_the_argument(wrapper):
    function = getattr(algebroproj, wrapper)(optics.scale) if wrapper else optics.scale
    masked = np.ma.array([1.0, 2.0], mask=[True, False])
    with pytest.raises(TypeError, match="scale: expected an array without a mask for x3, got a masked array"):
        function(np.ones(2), masked)


def test_a_masked_array_for_the_result_is_refused():
    with pytest.raises(TypeError, match="scale: expected an array without a mask as out, got a masked array"):
        optics.scale(np.ones(2), np.ones(2), out=np.ma.array([1.0, 2.0]))


def test_masked_quadrics_are_refused():
    with pytest.raises(TypeError, match="classify: expected an array without a mask for Q, got a masked array"):
        algebroproj.critical.classify(np.ma.array(np.eye(4)))


# Integers among objects


def test_integers_among_objects_stay_exact():
    scale = optics.scale
    assert scale(10**30, 3 * 10**30) == Fraction(1, 4)
    assert scale(np.array([1, 2], object), 2).tolist() == [Fraction(1, 3), Fraction(1, 2)]
    assert scale(np.array(1, object), np.int64(2)) == Fraction(1, 3)
    assert scale(Fraction(1), True) == Fraction(1, 2)
    assert scale(mpmath.mpf(1), 2) == mpmath.mpf(1) / 3
    assert scale(sympy.Symbol("f"), 2).subs("f", 1) == sympy.Rational(1, 3)
    assert all(type(value) is Fraction for value in optics.lens_matrix(np.array(2, object)).flat)


def test_what_is_exact_goes_exactly_from_function_to_function():
    exact = np.vectorize(Fraction, otypes=[object])
    y0, u3 = exact([0.5, 0.25, 2.0]), exact([0.25, 0.5])
    matrix = correlation.correlation_from_cameras(y0, u3, exact([0.25, 0.75, 1.5]), exact([0.5, 0.125]))
    _, mu_left, mu_right = normal_case.from_correlation(matrix)
    for tau in (mu_left, mu_right):
        mapped = normal_case.map_points(tau, np.array([1, 2], object))
        assert all(isinstance(value, Fraction) for value in (*tau, *mapped))


@pytest.mark.parametrize("function", [collinearity.similarity, metric.rotation_left, metric.rotations_from_correlation])
def test_elementary_functions_take_machine_numbers(function):
    shapes = [core for _, core in function.__globals__[f"_{function.__name__.upper()}_SIGNATURE"].arguments]
    name = f"{function.__name__}: expected machine numbers"
    with pytest.raises(TypeError, match=name):
        function(*(np.full(shape, Fraction(1, 2), object) for shape in shapes))


# What a compiler may do


class Var:
    """The name of a number in a compiled program."""


class DynamicJaxprTracer:
    """Stands for a number where ``jax.jit`` compiles."""

    dtype, shape, ndim = np.dtype(np.float64), (), 0

    def __array_namespace__(self, **_):
        return array_api_strict


class NewDynamicJaxprTracer(DynamicJaxprTracer):
    """As JAX has it since 0.10.2."""

    val = Var()


class LinearizeTracer(DynamicJaxprTracer):
    """Stands for a number of which there is a derivative."""

    primal = DynamicJaxprTracer()


TRACERS = [DynamicJaxprTracer, NewDynamicJaxprTracer, LinearizeTracer]


@pytest.mark.parametrize("tracer", TRACERS)
def test_jit_is_refused_where_it_would_compile_the_extra_digits_away(tracer, monkeypatch):
    for kind in (Var, *TRACERS):
        monkeypatch.setattr(kind, "__module__", "jax._src.interpreters.partial_eval")
    with pytest.raises(TypeError, match=r"tau: expected arrays, got a tracer: jax\.jit would compile"):
        normal_case.tau(tracer(), tracer())
    with pytest.raises(Exception, match=r"^(?!.*jit)"):
        algebroproj.plain(normal_case.tau)(tracer(), tracer())


def test_a_derivative_of_numbers_is_not_taken_for_jit(monkeypatch):
    monkeypatch.setattr(LinearizeTracer, "__module__", "jax._src.interpreters.ad")
    monkeypatch.setattr(LinearizeTracer, "primal", np.ones(3))
    assert not is_traced(LinearizeTracer())


@pytest.mark.parametrize(
    ("out", "error", "message"),
    [
        (np.empty((4, 2)), ValueError, r"image_point: expected out of shape \(4, 3\), got shape \(4, 2\)"),
        (np.empty((2, 4, 3)), ValueError, r"expected out of shape \(4, 3\), got shape \(2, 4, 3\)"),
        (np.empty((4, 3), np.float32), TypeError, "expected out of dtype float64, got dtype float32"),
        ([[0.0] * 3] * 4, TypeError, "expected an array as out, got list"),
        ((np.empty((4, 3)), np.empty((4, 3))), TypeError, "expected an array as out, got tuple"),
        (np.broadcast_to(np.empty(3), (4, 3)), ValueError, "expected out to be writeable"),
    ],
)
def test_an_out_that_does_not_fit_is_named(out, error, message):
    with pytest.raises(error, match=message):
        optics.image_point(0.15, np.ones((4, 3)), out=out)


@pytest.mark.parametrize("out", [(np.empty(3), None), ([0.0] * 3, np.empty(3)), (np.empty(3),)])
def test_several_results_need_as_many_arrays(out):
    with pytest.raises(TypeError, match="epipoles: expected a tuple of 2 arrays as out, got tuple"):
        correlation.epipoles(np.eye(3), out=out)


def test_no_array_of_the_size_of_the_batch_is_made_beside_the_result():
    count = 2**20
    points, mu, image = drawn((count, 3), 1), np.array([0.5, 0.25, 2.0]), np.array([0.25, 0.5])
    program = projection.project.__globals__["_project"]
    out = np.empty((count, 2))
    signature = Signature("project", (("y", (3,)), ("mu", (3,)), ("u3", (2,))), ((2,),))
    tracemalloc.start()
    evaluate(signature, program, (points, mu, image), out)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < points.nbytes / 3 / 2


# Other libraries

KERNELS = {kernel.qualified_name: kernel for kernel in kernels()}
STRICT = array_api_strict


def strict(array):
    return STRICT.asarray(array)


@for_each("name", [*KERNELS][::4])
@for_each("dtype", [np.float32, np.float64])
def test_every_function_takes_arrays_of_the_standard(name, dtype):
    function = function_of(KERNELS[name], load_package())
    ours = [drawn((4, *argument.shape), k, dtype) for k, argument in enumerate(KERNELS[name].arguments)]
    theirs = function(*map(strict, ours))
    expected = function(*ours)
    for result, value in zip(*((r if isinstance(r, tuple) else (r,)) for r in (theirs, expected)), strict=True):
        assert type(result) is type(strict(0.0))
        assert result.dtype == getattr(STRICT, np.dtype(dtype).name)
        np.testing.assert_array_equal(np.asarray(result), value)


def test_arrays_of_the_standard_meet_scalars_lists_and_numpy():
    depths = strict(np.linspace(1, 2, 5))
    np.testing.assert_array_equal(np.asarray(optics.scale(2, depths)), optics.scale(2, np.linspace(1, 2, 5)))
    points = strict(drawn((5, 3), 1))
    mixed = optics.image_point(np.array(0.25), points)
    np.testing.assert_array_equal(np.asarray(mixed), optics.image_point(0.25, np.asarray(points)))
    assert space.homography(strict([1, 2, 3, 4])).dtype == STRICT.float64
    assert normal_case.transform(strict(np.ones((3, 2), np.float32))).dtype == STRICT.float32


def test_batches_of_the_standard_broadcast_and_keep_constant_entries():
    result = projection.camera_matrix(strict(drawn((3, 1, 3), 1)), strict(drawn((4, 2), 2)))
    assert tuple(result.shape) == (3, 4, 3, 4)
    assert tuple(metric.rotation_left(strict(np.ones((0, 2))), 0.5).shape) == (0, 2, 3, 3)


def test_what_the_standard_does_not_allow_is_named():
    with pytest.raises(TypeError, match="image_point: expected no out with arrays of array_api_strict"):
        optics.image_point(0.15, strict([1.0, 2.0, 3.0]), out=np.empty(3))
    with pytest.raises(ValueError, match=r"image_point: expected x of shape \(\.\.\., 3\), got shape \(2,\)"):
        optics.image_point(0.15, strict([1.0, 2.0]))


def test_arrays_of_two_libraries_do_not_meet():
    class Other:
        def __array_namespace__(self):
            return np

    with pytest.raises(TypeError, match="scale: expected arrays of one library, got Array, Other"):
        optics.scale(strict(1.0), Other())


def test_a_singular_member_of_the_standard_leaves_the_others_alone():
    left, right = drawn((3, 5, 2), 1), drawn((3, 5, 2), 2)
    left[1, 1], right[1, 1] = left[1, 0], right[1, 0]
    with np.errstate(all="ignore"):
        result = np.asarray(correlation.correlation_matrix(strict(left), strict(right)))
    assert np.isfinite(result).all(axis=(1, 2)).tolist() == [True, False, True]


@for_each("name", KERNELS)
def test_every_function_takes_tensors_of_torch(name):
    torch = pytest.importorskip("torch")
    pytest.importorskip("array_api_compat")
    function = function_of(KERNELS[name], load_package())
    ours = [drawn((4, *argument.shape), k) for k, argument in enumerate(KERNELS[name].arguments)]
    for version in (function, algebroproj.plain(function)):
        theirs = version(*map(torch.asarray, ours))
        expected = version(*ours)
        for result, value in zip(*((r if isinstance(r, tuple) else (r,)) for r in (theirs, expected)), strict=True):
            assert isinstance(result, torch.Tensor)
            assert result.dtype == torch.float64
            np.testing.assert_allclose(result.numpy(), value, rtol=1e-12)


def test_tensors_need_what_speaks_for_them(monkeypatch):
    class Tensor:
        pass

    Tensor.__module__ = "torch"
    monkeypatch.setitem(sys.modules, "array_api_compat.torch", None)
    with pytest.raises(TypeError, match="expected the package array-api-compat"):
        optics.scale(1.0, Tensor())


@for_each("function", [optics.scale, projection.mu_from_center, correlation.epipoles])
@for_each("dtype", [np.float32, np.float64, np.complex128, object])
def test_a_single_point_is_written_to_out_by_the_numpy_source_as_well(function, dtype):
    source = without_twin(function)
    signature = function.__globals__[f"_{function.__name__.upper()}_SIGNATURE"]
    generator = np.random.default_rng(8)
    given = [generator.uniform(1, 2, core).astype(dtype) for _, core in signature.arguments]
    results = [np.empty(core, dtype) for core in signature.results]
    out = tuple(results) if len(results) > 1 else results[0]
    wanted = source(*given)
    assert source(*given, out=out) is out
    for result, expected in zip(results, wanted if len(results) > 1 else (wanted,), strict=True):
        np.testing.assert_array_equal(result, expected)


MANY = threads.POINTS


@pytest.fixture
def three_cores(monkeypatch):
    """Pretend that there are three cores; make sure that compiled functions ask for them."""
    asked = []
    monkeypatch.setattr(algebroproj._runtime.threads, "_cores", lambda: asked.append(True) or 3)
    yield
    assert asked or algebroproj.backend() == "numpy"


def test_the_points_of_a_large_batch_are_computed_in_a_thread_for_each_core(monkeypatch):
    monkeypatch.setattr(threads, "_cores", lambda: 3)
    seen, meeting = [], threading.Barrier(3, timeout=60)

    def twin(x, y, out):
        meeting.wait()
        seen.append((threading.get_ident(), x.shape, y.shape))
        np.add(x, y, out=out[0])

    monkeypatch.setattr(evaluation, "calls", {twin: lambda *given: None})
    total = Signature("total", (("x", ()), ("y", ())), ((),), twin=twin)
    x, y = drawn((2, MANY), 1), drawn((2, 1), 2)
    out = np.empty((2, MANY))
    assert evaluate(total, lambda x, y: (x + y,), (x, y), out) is out
    np.testing.assert_array_equal(out, x + y)
    assert len({thread for thread, _, _ in seen}) == 3
    assert sum(shape[1] for _, shape, _ in seen) == MANY
    assert {shape for _, _, shape in seen} == {(2, 1)}


@pytest.mark.parametrize("batches", [((MANY + 1,), (MANY + 1,)), ((MANY,), ()), ((2, 1), (MANY,)), ((MANY, 1), (2,))])
def test_a_large_batch_has_the_bits_of_small_ones(batches, three_cores):
    centers, images = (drawn((*batch, core), k) for k, (batch, core) in enumerate(zip(batches, (3, 2), strict=True)))
    batch = np.broadcast_shapes(*batches)
    found = projection.projection_matrix(centers, images)
    every = (
        np.broadcast_to(array, (*batch, array.shape[-1])).reshape(-1, array.shape[-1]) for array in (centers, images)
    )
    pieces = zip(*(np.array_split(array, 40) for array in every), strict=True)
    expected = np.concatenate([projection.projection_matrix(*piece) for piece in pieces])
    np.testing.assert_array_equal(found.reshape(expected.shape), expected)


def test_a_large_batch_may_be_written_over_the_arguments(three_cores):
    points = drawn((MANY + 5, 3), 3)
    expected = optics.image_point(0.15, points[::-1].copy())
    assert optics.image_point(0.15, points[::-1], out=points) is points
    np.testing.assert_array_equal(points, expected)


def test_threads_heed_how_the_caller_treats_errors(three_cores):
    f = np.ones(MANY)
    x3 = np.zeros(MANY)
    x3[-1] = -1
    with np.errstate(all="raise"), pytest.raises(FloatingPointError):
        optics.scale(f, x3)
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("error")
        assert np.isinf(optics.scale(f, x3)[-1])
