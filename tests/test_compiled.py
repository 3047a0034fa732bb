"""The compiled functions give the same bits as the NumPy source, in any layout, and are chosen as the user wants."""

import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from cases import for_each

import algebroproj
from algebroproj._runtime.backend import calls
from algebroproj_sym.declaring import kernels
from algebroproj_sym.verifying.shipped import function_of, without_twin
from algebroproj_sym.verifying.verification import SPECIAL, same_bits

pytestmark = pytest.mark.skipif(
    algebroproj.backend() != "compiled", reason="the package was built without a C compiler"
)


def twin_of(kernel):
    return function_of(kernel, algebroproj).__globals__[f"_{kernel.name.upper()}_SIGNATURE"].twin


KERNELS = {kernel.qualified_name: kernel for kernel in kernels() if twin_of(kernel) is not None}
POINTS = 10_003  # more than one block of the NumPy source


def numbers(shape, dtype=np.float64, seed=0):
    """Draw numbers with all digits of the dtype; of the second half some are special."""
    generator = np.random.default_rng(seed)
    drawn = generator.uniform(-4, 4, shape).astype(dtype)
    drawn = drawn * (1 + generator.uniform(0, 1, shape).astype(dtype) * np.finfo(dtype).eps * 1024)
    with np.errstate(over="ignore"):
        special = generator.choice(np.array(SPECIAL), shape).astype(dtype)
    chance = generator.random(shape)
    chance[: shape[0] // 2] = 1
    return np.where(chance < 0.04, special, drawn)


def arguments_of(kernel, dtype=np.float64, batch=(POINTS,)):
    return [numbers((*batch, *a.shape), dtype, seed) for seed, a in enumerate(kernel.arguments)]


def both(kernel, arguments, **options):
    """Return the results of the compiled function and of the NumPy source, as tuples."""
    function = function_of(kernel, algebroproj)
    with np.errstate(all="ignore"):
        results = [version(*arguments, **options) for version in (function, without_twin(function))]
    return [as_tuple(result) for result in results]


def assert_same(kernel, arguments, **options):
    compiled, source = both(kernel, arguments, **options)
    assert len(compiled) == len(source)
    assert all(same_bits(np.asarray(c), np.asarray(s)) for c, s in zip(compiled, source, strict=True))


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", KERNELS)
def test_the_bits_are_those_of_the_numpy_source(name):
    assert_same(KERNELS[name], arguments_of(KERNELS[name]))


@pytest.mark.sampled(4)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("name", KERNELS)
def test_the_numpy_source_gives_a_batch_the_bits_of_its_points(name, dtype):
    """A batch is recorded and run in buffers; single points, and batches that broadcast, are not."""
    arguments = [a[-6:] for a in arguments_of(KERNELS[name], dtype)]
    source = without_twin(function_of(KERNELS[name], algebroproj))
    with np.errstate(all="ignore"):
        results = as_tuple(source(*arguments))
        points = [as_tuple(source(*(a[place] for a in arguments))) for place in range(6)]
        spread = as_tuple(source(arguments[0][:1], *arguments[1:]))
        first = as_tuple(source(np.repeat(arguments[0][:1], 6, axis=0), *arguments[1:]))
    assert all(same_bits(r, np.stack(p)) for r, p in zip(results, zip(*points, strict=True), strict=True))
    assert len(arguments) == 1 or all(map(same_bits, first, spread))


def as_tuple(result):
    return result if isinstance(result, tuple) else (result,)


def extremes(shape, seed):
    """Draw numbers of every size, and such as are none: a few among ordinary ones, and rows of them alone.

    What is infinite must not hide that something else is too large.
    """
    generator = np.random.default_rng(seed)
    limits = np.finfo(float)
    exponents = generator.integers(limits.minexp - limits.nmant, limits.maxexp, shape)
    with np.errstate(under="ignore"):
        large_and_small = np.ldexp(generator.uniform(-1, 1, shape), exponents)
    none = generator.choice(np.array([np.inf, -np.inf, np.nan]), shape)
    large_and_small = np.where(generator.random(shape) < 0.2, none, large_and_small)
    some = generator.random(shape) < generator.choice([0, 0.02, 0.2, 1], shape[0]).reshape(-1, *(1 for _ in shape[1:]))
    return np.where(some, large_and_small, generator.uniform(-4, 4, shape))


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", KERNELS)
def test_the_bits_are_the_same_where_products_and_halves_overflow_and_underflow(name):
    kernel = KERNELS[name]
    assert_same(kernel, [extremes((3000, *a.shape), seed) for seed, a in enumerate(kernel.arguments)])


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", KERNELS)
def test_the_bits_are_the_same_where_products_are_nearly_too_large(name):
    """Each number is near the root of the largest; of sums of such, products may overflow, and their halves before."""
    largest = np.finfo(float).max
    generator = np.random.default_rng(0)
    shapes = [(2000, *argument.shape) for argument in KERNELS[name].arguments]
    exponents = [generator.uniform(-0.02, 0.002, shape) for shape in shapes]
    with np.errstate(over="ignore"):
        arguments = [np.sqrt(largest) * largest**e for e in exponents]
    signs = [generator.choice([-1, 1], shape) for shape in shapes]
    assert_same(KERNELS[name], [argument * sign for argument, sign in zip(arguments, signs, strict=True)])


@pytest.mark.parametrize("infinite", [np.inf, -np.inf, np.nan])
def test_what_is_infinite_does_not_hide_that_something_else_is_too_large(infinite):
    matrices = np.random.default_rng(0).uniform(-4, 4, (1000, 4, 4))
    matrices[:, 0, 0], matrices[:, 3, 3] = infinite, 1e300
    assert_same(KERNELS["critical.invariants"], [matrices])


@pytest.mark.parametrize("name", ["projection.projection_matrix", "correlation.correlation_matrix"])
def test_floating_point_exceptions_are_those_of_a_block_alone_and_of_all_blocks_together(name):
    kernel = KERNELS[name]
    function = function_of(kernel, algebroproj)
    generator = np.random.default_rng(0)
    ordinary = [generator.uniform(0.1, 0.9, (128, *a.shape)) for a in kernel.arguments]
    extreme = [extremes((512, *a.shape), seed) for seed, a in enumerate(kernel.arguments)]
    arguments = [np.concatenate(parts) for parts in zip(ordinary, extreme, strict=True)]

    def raised(given):
        kinds = []
        with np.errstate(all="call", call=lambda kind, flag: kinds.append(kind)):
            function(*given)
        return set(kinds)

    alone = [raised([a[start : start + 64] for a in arguments]) for start in range(0, 640, 64)]
    assert raised(arguments) == set().union(*alone)
    assert len(set(map(frozenset, alone))) > 1


def test_double_precision_alone_runs_compiled():
    for kernel in KERNELS.values():
        assert {*"".join(twin_of(kernel).types)} == {*"d->"}


@pytest.fixture
def kernel():
    return KERNELS["projection.project"]


@pytest.mark.parametrize("count", [0, 1, 63, 64, 65, 129, 255, 256, 257, 260, 515])
def test_batches_of_any_length(kernel, count):
    assert_same(kernel, arguments_of(kernel, batch=(count,)))


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", KERNELS)
def test_points_that_make_up_no_block(name):
    arguments = arguments_of(KERNELS[name], batch=(300,))
    for start, stop in ((0, 3), (1, 5), (2, 9), (290, 300), (37, 300)):
        assert_same(KERNELS[name], [a[start:stop] for a in arguments])


@pytest.mark.sampled(12)
@pytest.mark.parametrize("name", [name for name, kernel in KERNELS.items() if len(kernel.arguments) > 1])
def test_one_point_of_an_argument_for_all_of_the_others(name):
    arguments = arguments_of(KERNELS[name], batch=(270,))
    for place, argument in enumerate(arguments):
        assert_same(KERNELS[name], [*arguments[:place], argument[5], *arguments[place + 1 :]])


class Subclass(np.ndarray):
    """Arrays that are no plain ones."""


PREPARED = {
    "a list": lambda y, mu, u3: (y.tolist(), mu, u3),
    "another dtype": lambda y, mu, u3: (y, mu.astype(np.float32), u3),
    "single precision": lambda y, mu, u3: tuple(a.astype(np.float32) for a in (y, mu, u3)),
    "integers": lambda y, mu, u3: (y.astype(int), mu.astype(int), u3.astype(int)),
    "complex numbers": lambda y, mu, u3: (y + 0j, mu + 0j, u3 + 0j),
    "bytes in the other order": lambda y, mu, u3: tuple(a.astype(a.dtype.newbyteorder()) for a in (y, mu, u3)),
    "another layout": lambda y, mu, u3: (y, np.asfortranarray(mu), u3),
    "every other point": lambda y, mu, u3: (y[::2], mu[::2], u3[::2]),
    "a subclass": lambda y, mu, u3: (y, mu.view(Subclass), u3),
    "leading shapes that broadcast": lambda y, mu, u3: (y, mu[0], u3),
    "another first leading shape": lambda y, mu, u3: (y[0], mu, u3),
    "another core shape": lambda y, mu, u3: (y, mu[:, :2].copy(), u3),
    "too few dimensions": lambda y, mu, u3: (y[0, 0], mu, u3),
    "addresses that are not aligned": lambda y, mu, u3: (unaligned(y), mu, u3),
}


def unaligned(array):
    """Return a copy whose numbers begin one byte late."""
    memory = np.empty(array.nbytes + 1, np.uint8)[1:].view(array.dtype).reshape(array.shape)
    memory[...] = array
    return memory


@pytest.mark.parametrize("prepared", PREPARED.values(), ids=PREPARED)
def test_a_short_call_leaves_to_numpy_what_needs_preparation(kernel, prepared):
    assert calls[twin_of(kernel)](*prepared(*arguments_of(kernel, batch=(6,)))) is None


@for_each("name", ["projection.project", "optics.scale", "correlation.epipoles", "critical.invariants"])
@for_each("batch", [(), (0,), (1,), (7,), (600,), (3, 1, 5), (2, 0)])
def test_a_short_call_gives_what_numpy_gives(name, batch):
    kernel = KERNELS[name]
    points = math.prod(batch)
    ordinary = [each[:points] for each in arguments_of(kernel, batch=(2 * points,))]
    arguments = [each.reshape((*batch, *a.shape)) for each, a in zip(ordinary, kernel.arguments, strict=True)]
    with np.errstate(all="ignore"):
        results = [calls[twin_of(kernel)](*arguments), twin_of(kernel)(*arguments)]
    short, long = (each if isinstance(each, tuple) else (each,) for each in results)
    assert [(type(one), one.shape, one.dtype) for one in short] == [(type(one), one.shape, one.dtype) for one in long]
    assert all(same_bits(np.asarray(one), np.asarray(other)) for one, other in zip(short, long, strict=True))


@pytest.mark.parametrize(
    "point", [(1.0, 1.0), (0.0, 0.0), (1e300, 1e-300), (1e-300, 1e-300), (np.inf, 1.0), (0.25, 0.5)]
)
def test_a_short_call_reports_floating_point_exceptions_as_numpy_does(point):
    twin = twin_of(KERNELS["optics.scale"])
    arguments = tuple(np.array([number]) for number in point)

    def reported(call):
        kinds = []
        with np.errstate(all="call", call=lambda kind, flag: kinds.append((kind, flag))):
            call()
        with np.errstate(all="raise"):
            try:
                call()
            except FloatingPointError as error:
                kinds.append(str(error))
        return kinds

    assert reported(lambda: calls[twin](*arguments)) == reported(lambda: twin(*arguments))


def test_a_short_call_keeps_no_reference(kernel):
    arguments = tuple(arguments_of(kernel, batch=(6,)))
    before = [sys.getrefcount(each) for each in (*arguments, twin_of(kernel))]
    with np.errstate(all="ignore"):
        result = calls[twin_of(kernel)](*arguments)
    assert sys.getrefcount(result) == 2
    assert result.base is None
    assert [sys.getrefcount(each) for each in (*arguments, twin_of(kernel))] == before


def test_a_short_call_of_too_few_or_too_many_arguments_gives_nothing(kernel):
    arguments = arguments_of(kernel, batch=(6,))
    assert calls[twin_of(kernel)]() is None
    assert calls[twin_of(kernel)](*arguments[:-1]) is None
    assert calls[twin_of(kernel)](*arguments, arguments[0]) is None


def test_the_layout_of_ufuncs_is_left_to_numpy():
    source = "".join(path.read_text(encoding="utf-8") for path in Path(algebroproj.__file__).parent.glob("_c/*"))
    assert "PyUFunc_FromFuncAndDataAndSignature" in source
    assert "PyUFuncObject" not in source


def test_several_leading_dimensions_that_broadcast(kernel):
    y, mu, u3 = arguments_of(kernel, batch=(5, 7))
    assert_same(kernel, [y, mu[:1], u3[0, 0]])
    assert_same(kernel, [y[0, 0], mu[:, :1], u3[0]])


def test_any_layout(kernel):
    y, mu, u3 = arguments_of(kernel, batch=(40, 6))
    assert_same(
        kernel, [y[::2, ::-1], np.asfortranarray(mu[1::2]), np.swapaxes(np.swapaxes(u3, 0, 1).copy(), 0, 1)[:20]]
    )


def test_scalars_lists_and_integers(kernel):
    y, mu, u3 = arguments_of(kernel, batch=())
    assert_same(kernel, [y.tolist(), mu, tuple(u3)])
    assert_same(kernel, [[1, 2, 3], [4, 5, 6], [7, 9]])
    assert_same(kernel, [np.array([1, 2, 3], np.int8), [4, 5, 6], np.array([7, 9], bool)])
    assert_same(KERNELS["correlation.epipoles"], [[[1, 2, 3], [4, 5, 6], [7, 8, 10]]])
    assert_same(KERNELS["optics.scale"], [2.0, np.float32([1, 2, 3])])
    assert_same(KERNELS["optics.scale"], [np.float64(2.0), np.float32([1, 2, 3])])


@pytest.mark.parametrize("dtype", [np.float16, np.float32, np.complex64, np.complex128, object, ">f8"])
def test_other_dtypes_run_the_numpy_source(kernel, dtype):
    arguments = [np.array([1, 2, 3], dtype), np.array([3, 4, 7], dtype), np.array([2, 5], dtype)]
    compiled, source = both(kernel, arguments)
    assert compiled[0].dtype == source[0].dtype
    assert compiled[0].tolist() == source[0].tolist()


def test_results_go_where_the_caller_wants_them(kernel):
    arguments = arguments_of(kernel, batch=(200,))
    out = np.full((200, 4), 7.0)[:, ::2]
    function = function_of(kernel, algebroproj)
    with np.errstate(all="ignore"):
        returned = function(*arguments, out=out)
        expected = without_twin(function)(*arguments)
    assert returned is out
    assert same_bits(out, expected)
    assert (out.base.reshape(200, 4)[:, 1::2] == 7).all()


def test_results_may_share_memory_with_arguments():
    kernel = KERNELS["normal_case.map_points"]
    tau, u = arguments_of(kernel, batch=(300,))
    function = function_of(kernel, algebroproj)
    memory = np.concatenate([u, u])
    with np.errstate(all="ignore"):
        expected = without_twin(function)(tau, memory[10:310].copy())
        function(tau, memory[10:310], out=memory[:300])
    assert same_bits(memory[:300], expected)


@pytest.mark.parametrize("offset", [0, 1, 2, 3, 5])
def test_results_may_lie_where_arguments_are(offset):
    u3 = arguments_of(KERNELS["projection.center_from_mu"], batch=(300,))[1]
    function = function_of(KERNELS["projection.center_from_mu"], algebroproj)
    memory = numbers((310 * 3,), seed=7)
    mu, out = memory[: 300 * 3].reshape(300, 3), memory[offset : 300 * 3 + offset].reshape(300, 3)
    with np.errstate(all="ignore"):
        expected = without_twin(function)(mu.copy(), u3)
        function(mu, u3, out=out)
    assert same_bits(out, expected)


def test_errors_are_those_of_the_numpy_source(kernel):
    y, mu, u3 = arguments_of(kernel, batch=(3,))
    function = function_of(kernel, algebroproj)
    for arguments in ([y[:, :2], mu, u3], [y, mu[:2], u3], [y, np.array("a"), u3]):
        messages = []
        for version in (function, without_twin(function)):
            with pytest.raises((TypeError, ValueError)) as caught:
                version(*arguments)
            messages.append(str(caught.value))
        assert messages[0] == messages[1]
    with pytest.raises(TypeError, match="out"):
        function(y, mu, u3, out=np.empty((3, 2), np.float32))


def test_singular_input_warns_and_regular_input_does_not():
    scale = function_of(KERNELS["optics.scale"], algebroproj)
    matrix = function_of(KERNELS["correlation.correlation_matrix"], algebroproj)
    with pytest.warns(RuntimeWarning):
        scale(np.array([1.0, 1.0]), np.array([2.0, -1.0]))
    generator = np.random.default_rng(1)
    with np.errstate(all="raise", under="ignore"):
        assert np.isfinite(matrix(*generator.uniform(0.1, 0.9, (2, 300, 5, 2)))).all()
        assert np.isfinite(matrix(*generator.uniform(0.1, 0.9, (2, 300, 5, 2)) * 1e60)).all()
        assert np.isnan(scale(np.array([np.nan]), np.array([1.0]))).all()


def run(backend, code="import algebroproj; print(algebroproj.backend())", **options):
    environment = {**os.environ, "ALGEBROPROJ_BACKEND": backend}
    command = [sys.executable, "-c", code]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False, **options)


@pytest.mark.parametrize("backend", ["numpy", "compiled"])
def test_the_environment_chooses(backend):
    assert run(backend).stdout.strip() == backend


def test_an_unknown_backend_is_refused():
    assert "ALGEBROPROJ_BACKEND: expected numpy or compiled, got 'cuda'" in run("cuda").stderr


COPIED = """
import shutil, sys
from pathlib import Path
import algebroproj
source, target = Path(algebroproj.__file__).parent, Path("copied")
shutil.copytree(source, target, ignore=shutil.ignore_patterns({ignored}))
if {stale}:
    text = (target / "_runtime" / "backend.py").read_text()
    (target / "_runtime" / "backend.py").write_text(text.replace("DIGEST = \\"", "DIGEST = \\"0"))
import os
os.environ["ALGEBROPROJ_BACKEND"] = "{wanted}"
sys.path.insert(0, ".")
import copied
print(copied.backend())
"""


@pytest.mark.parametrize(
    ("ignored", "stale", "why"),
    [('"_compiled.*"', False, "No module named"), ('"*.c"', True, "it was built from another source")],
)
def test_without_compiled_functions_of_this_source_numpy_runs(ignored, stale, why, tmp_path):
    assert run("numpy", COPIED.format(ignored=ignored, stale=stale, wanted=""), cwd=tmp_path).stdout == "numpy\n"


@pytest.mark.parametrize(
    ("ignored", "stale", "why"),
    [('"_compiled.*"', False, "No module named"), ('"*.c"', True, "it was built from another source")],
)
def test_compiled_functions_that_are_not_there_are_an_error_if_wanted(ignored, stale, why, tmp_path):
    failed = run("numpy", COPIED.format(ignored=ignored, stale=stale, wanted="compiled"), cwd=tmp_path)
    assert "ALGEBROPROJ_BACKEND: expected compiled functions, got none" in failed.stderr
    assert why in failed.stderr
