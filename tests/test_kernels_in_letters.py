"""Kernels in letters: written out once, with arguments of which one triangle is read, in every language."""

import re
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
import sympy
from cases import for_each
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import BlockMatrix, Determinant, Identity, MatrixSymbol, Trace

import algebroproj
from algebroproj import metric
from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError
from algebroproj_sym.expressions.letters import Adjugate, Dot, Norm
from algebroproj_sym.generating.backends import BACKENDS
from algebroproj_sym.generating.backends.numpy import render
from algebroproj_sym.generating.choosing import lower, mirrored
from algebroproj_sym.generating.writing import PACKAGE, write
from algebroproj_sym.verifying.proof_of_cpp_source import cpp_source_is_proved
from algebroproj_sym.verifying.shipped import function_of, load_package
from algebroproj_sym.verifying.verification import verify

A, S, K, D = (
    MatrixSymbol(name, *shape) for name, shape in (("A", (2, 3)), ("S", (3, 3)), ("K", (3, 3)), ("D", (3, 3)))
)
P, G, H, x, y = (
    MatrixSymbol(n, *shape) for n, shape in (("P", (2, 2)), ("G", (2, 1)), ("H", (1, 2)), ("x", (2, 1)), ("y", (2, 1)))
)
R, n = MatrixSymbol("R", 3, 3), MatrixSymbol("n", 3, 1)
r, s = sympy.symbols("r s")


def declared(name, derived, arguments, properties=None, **options):
    def decimals(argument):
        if isinstance(argument, sympy.Symbol):
            return "0.75"
        rows = [[f"{1 + 2 * i + 3 * j}.{i * j}" for j in range(argument.cols)] for i in range(argument.rows)]
        return [entry for row in rows for entry in row] if argument.cols == 1 else rows

    section = Section("demo", "1", "Demonstration")
    section.kernel(
        f"demo.{name}",
        "A function.",
        arguments={str(argument): argument for argument in arguments},
        derived=derived,
        properties=properties or {},
        claims=["1.1"],
        example={str(argument): decimals(argument) for argument in arguments},
        describe={str(argument): "Some numbers." for argument in arguments},
        **options,
    )
    return section.kernels


KEPT = Identity(2) - G * H
KERNELS = {
    kernel.name: kernel
    for kernel in (
        *declared("propagated", A * S * A.T, [A, S], {S: "symmetric"}, jacobian=True),
        *declared("joseph", KEPT * P * KEPT.T + r * G * G.T, [G, H, P, r], {P: "symmetric"}),
        *declared("cayley", (Identity(3) + K).I * (Identity(3) - K), [K], {K: "skew"}),
        *declared("weighted", A * D.I * A.T, [A, D], {D: "diagonal"}),
        *declared("inverse", P.I, [P], {P: "symmetric"}, jacobian=True),
        *declared("turned", (R * S * R.T).I * n, [R, S, n], {R: "rotation", S: "positive definite"}),
        *declared("reflected", Identity(3) * Dot(n, n) - 2 * n * n.T, [n], {n: "unit"}),
        *declared("bracket", P * x * y.T - y * x.T * P, [P, x, y], {P: "symmetric"}),
        *declared("several", {"first": Trace(S) / s, "second": S * A.T}, [A, S, s], {"S": "symmetric"}),
    )
}
lowered_here = cache(lambda name: lower(KERNELS[name]))
every_kernel = pytest.mark.parametrize("name", KERNELS)


def upper(m):
    """Return the symmetric matrix with the upper triangle of another one."""
    return np.array([[m[min(i, j)][max(i, j)] for j in range(len(m))] for i in range(len(m))])


def skew(m):
    return np.array([[m[i][j] if i < j else -m[j][i] if j < i else 0 for j in range(len(m))] for i in range(len(m))])


def inverse(m):
    return np.array(sympy.Matrix(m).inv().applyfunc(sympy.Rational).tolist())


def exact(rows):
    return np.array(
        [[Fraction(int(e.p), int(e.q)) if isinstance(e, sympy.Rational) else e for e in row] for row in rows]
    )


def of_joseph(g, h, p, variance):
    column, row = g.reshape(2, 1), h.reshape(1, 2)
    kept = np.eye(2, dtype=int) - column @ row
    return kept @ upper(p) @ kept.T + variance * column @ column.T


ORACLES = {
    "propagated": lambda a, s: a @ upper(s) @ a.T,
    "joseph": of_joseph,
    "cayley": lambda k: exact(inverse(np.eye(3, dtype=int) + skew(k)) @ (np.eye(3, dtype=int) - skew(k))),
    "weighted": lambda a, d: a @ np.diag([1 / d[k][k] for k in range(3)]) @ a.T,
    "inverse": lambda p: exact(inverse(upper(p))),
    "turned": lambda r, s, n: r @ exact(inverse(upper(s))) @ r.T @ n,
    "reflected": lambda n: np.eye(3, dtype=int) - 2 * np.outer(n, n),
    "bracket": lambda p, x, y: np.outer(upper(p) @ x, y) - np.outer(y, upper(p) @ x),
}
NUMBERS = st.fractions(-4, 4, max_denominator=6).filter(bool)


def drawn(data, kernel):
    cores = [argument.shape for argument in kernel.arguments]
    return [
        np.array(data.draw(st.lists(NUMBERS, min_size=n, max_size=n)), dtype=object).reshape(core)
        for core in cores
        for n in [int(np.prod(core))]
    ]


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    folder = tmp_path_factory.mktemp("letters")
    write(render([*map(lowered_here, KERNELS)]), folder / PACKAGE)
    return load_package(folder)


@pytest.mark.parametrize("name", ORACLES)
@settings(max_examples=settings.default.max_examples // 3)
@given(data=st.data())
def test_on_fractions_a_function_gives_what_matrices_give(name, package, data):
    arguments = drawn(data, KERNELS[name])
    try:
        expected = ORACLES[name](*(argument if argument.shape else argument[()] for argument in arguments))
    except (ValueError, ZeroDivisionError):
        return
    found = getattr(package.demo, name)(*arguments)
    assert (found == expected).all()


@pytest.mark.sampled(3)
@every_kernel
def test_all_sources_are_proved_and_errors_are_within_the_bound(name, package):
    verified = verify(lowered_here(name), package, 6)
    assert verified.proved
    assert verified.accuracy.within_bound
    assert [*verified.silent] == ([1 + sum(k**2 for k in KERNELS[name].arguments[0].read)] if name == "cayley" else [])
    assert cpp_source_is_proved(lowered_here(name), BACKENDS["cpp"].render([*map(lowered_here, KERNELS)]))


@every_kernel
def test_entries_that_are_not_read_change_nothing(name, package):
    kernel = KERNELS[name]
    function = function_of(kernel, package)
    given = [np.asarray(kernel.example[argument.name], float) for argument in kernel.arguments]
    spoiled = [array.copy() for array in given]
    for array, argument in zip(spoiled, kernel.arguments, strict=True):
        unread = [str(symbol) not in map(str, argument.read) for symbol in argument.symbols]
        assert any(unread) == (argument.structure is not None)
        array[np.reshape(unread, array.shape)] = -777.25
    for wrap in (lambda f: f, package.dd, package.plain, package.bounds, package.rounded):
        before, after = (_parts(wrap(function)(*arrays)) for arrays in (given, spoiled))
        assert before == after
        assert np.isfinite(np.concatenate([np.frombuffer(part) for part in before])).all()
    lost = [np.where(array == -777.25, np.nan, array) for array in spoiled]
    assert _parts(function(*lost)) == _parts(function(*given))


def _parts(results):
    """Return the bytes of all numbers of what a function returns."""
    if isinstance(results, tuple):
        return [part for result in results for part in _parts(result)]
    parts = (results.hi, results.lo) if hasattr(results, "hi") else (results,)
    return [np.asarray(part, float).tobytes() for part in parts]


@pytest.mark.parametrize("name", ["propagated", "joseph", "weighted", "inverse"])
def test_a_symmetric_result_is_symmetric_to_the_last_bit(name, package):
    generator = np.random.default_rng(5)
    arguments = [generator.uniform(-2, 2, (500, *argument.shape)) for argument in KERNELS[name].arguments]
    found = getattr(package.demo, name)(*arguments)
    np.testing.assert_array_equal(found, np.swapaxes(found, -1, -2))


def test_a_skew_result_is_skew_to_the_last_bit(package):
    generator = np.random.default_rng(5)
    found = package.demo.bracket(*(generator.uniform(-2, 2, (500, *a.shape)) for a in KERNELS["bracket"].arguments))
    np.testing.assert_array_equal(found, -np.swapaxes(found, -1, -2))
    assert (found[:, 0, 0] == 0).all()


def test_values_lie_within_their_bounds_and_a_rounded_value_is_the_nearest(package):
    generator = np.random.default_rng(6)
    a, s = generator.uniform(-2, 2, (20, 2, 3)), generator.uniform(-2, 2, (20, 3, 3))
    fractions = [np.vectorize(Fraction, otypes=[object])(array) for array in (a, s)]
    exactly = np.array([ORACLES["propagated"](*each) for each in zip(*fractions, strict=True)])
    value, bound = package.bounds(package.demo.propagated)(a, s)
    errors = abs(np.vectorize(Fraction, otypes=[object])(value) - exactly)
    assert (errors <= np.vectorize(Fraction, otypes=[object])(bound)).all()
    np.testing.assert_array_equal(package.rounded(package.demo.propagated)(a, s), exactly.astype(float))


@pytest.mark.parametrize("name", ["propagated", "inverse"])
def test_a_jacobian_has_a_column_for_each_entry_and_zeros_for_those_that_are_not_read(name, package):
    kernel = KERNELS[name]
    generator = np.random.default_rng(7)
    arguments = [generator.uniform(0.5, 2, argument.shape) for argument in kernel.arguments]
    found = getattr(package.demo, f"{name}_jacobian")(*arguments)
    sizes = np.cumsum([0, *(argument.size for argument in arguments)])
    assert found.shape == (int(np.prod(kernel.results[0].shape)), sizes[-1])
    function, step = getattr(package.demo, name), 1e-30j
    for place, argument in enumerate(arguments):
        for entry in range(argument.size):
            moved = [array.astype(complex) for array in arguments]
            moved[place].reshape(-1)[entry] += step
            slopes = function(*moved).imag.reshape(-1) / 1e-30
            np.testing.assert_allclose(found[:, sizes[place] + entry], slopes, rtol=1e-12, atol=1e-12)
    read = {entry for argument in kernel.arguments for entry in argument.read}
    unread = [place for place, symbol in enumerate(kernel.symbols) if symbol not in read]
    assert unread
    assert not found[:, unread].any()


@pytest.mark.parametrize(
    ("name", "argument", "said"),
    [
        ("propagated", "S", "Taken as symmetric: the entries above the diagonal stand for those below it"),
        ("cayley", "K", "Taken as skew: the entries above the diagonal stand for the others, which are not read."),
        ("weighted", "D", "Taken as diagonal: the entries beside the diagonal are not read."),
        ("turned", "R", "Taken as a rotation: its transpose stands for its inverse."),
        ("turned", "S", "Taken as positive definite."),
        ("reflected", "n", "Taken as a unit vector: its length is not computed."),
    ],
)
def test_the_documentation_says_which_entries_are_read(name, argument, said, package):
    lines = function_of(KERNELS[name], package).__doc__.splitlines()
    about = lines[next(k for k, line in enumerate(lines) if line.strip().startswith(f"{argument} :")) + 1]
    assert said in about
    assert said in " ".join(re.sub("//", "", BACKENDS["cpp"].render([lowered_here(name)])["demo.hpp"]).split())


@pytest.mark.parametrize(
    ("derived", "kind", "equal"),
    [
        (R.I * n, "rotation", R.T * n),
        ((R.T).I * n, "orthogonal", R * n),
        ((R * S * R) ** -2, "rotation", R.T * S.I * R.T * R.T * S.I * R.T),
        ((R * S).T.I, "orthogonal", R * S.T.I),
        (Adjugate(R) * Determinant(R), "rotation", R.T),
        (2 * R * R.T, "orthogonal", 2 * Identity(3)),
        (R.T * R * R.T * S * R, "rotation", R.T * S * R),
        (Adjugate(R) * Determinant(R), "orthogonal", Adjugate(R) * Determinant(R)),
    ],
)
def test_orthogonal_letters_are_not_inverted(derived, kind, equal):
    arguments = [letter for letter in (R, S, n) if derived.has(letter)]
    kernels = [*declared("f", derived, arguments, {R: kind}), *declared("f", equal, [R, S, n])]
    first, second = (sympy.ImmutableMatrix(kernel.derived) for kernel in kernels)
    assert (first - second).applyfunc(sympy.expand) == sympy.zeros(*first.shape) or first == second


def test_what_is_equal_is_computed_once():
    kernel, *_ = declared("all_entries", A * K * A.T, [A, K])
    operations = [lower(each).plain.operations().total() for each in (kernel, KERNELS["propagated"])]
    assert operations == [30 + 20, 27 + 18]
    assert mirrored(kernel) == [kernel]
    assert len(mirrored(KERNELS["propagated"])) == 2


def test_a_symmetric_matrix_of_symbols_is_an_argument_too():
    a, b, c = sympy.symbols("a b c")
    told = {"claims": ["1"], "example": {"M": (("1", "2"), ("2", "3"))}, "describe": {"M": "A matrix."}}
    for rows, structure, read in [
        ([[a, b], [b, c]], "symmetric", (a, b, c)),
        ([[0, b], [-b, 0]], "skew", (b,)),
        ([[a, 0], [0, c]], "diagonal", (a, c)),
        ([[a, b], [c, sympy.Symbol("d")]], None, (a, b, c, sympy.Symbol("d"))),
    ]:
        matrix = sympy.Matrix(rows)
        kernel = Section("demo", "1", "D").kernel("demo.f", "F.", arguments={"M": matrix}, derived=matrix * 2, **told)
        assert (kernel.arguments[0].structure, kernel.arguments[0].read) == (structure, read)


@pytest.mark.parametrize(
    "rows", [[["a", "b"], ["b", "a"]], [["a", "b"], ["2*b", "c"]], [[0, "-b"], ["b", 0]], [[1, 0], [0, "c"]]]
)
def test_other_repetitions_are_refused_with_what_is_taken(rows):
    told = {"claims": ["1"], "example": {"M": (("1", "2"), ("2", "3"))}, "describe": {"M": "A matrix."}}
    matrix = sympy.Matrix(rows)
    with pytest.raises(
        DeclarationError, match=r"expected different plain symbols .* symmetric, skew or diagonal matrices"
    ):
        Section("demo", "1", "D").kernel("demo.f", "F.", arguments={"M": matrix}, derived=matrix, **told)


@for_each(
    ("derived", "properties", "message"),
    [
        (A * S * A.T * MatrixSymbol("B", 2, 2), {}, "derived: expected the letters of the arguments, got also B"),
        (A * S * A.T, {S: "idempotent"}, "S: expected diagonal, .* or nothing, .* got idempotent"),
        (A * S * A.T, {S: "rank 2"}, "S: expected diagonal, .* or nothing, .* got rank 2"),
        (A * S * A.T, {S: "pretty"}, "S: expected one of rotation, .* got 'pretty'"),
        (A * S * A.T, {A: "symmetric"}, "A: expected a square matrix as symmetric, got 2x3"),
        (A * S * A.T, {MatrixSymbol("B", 2, 2): "symmetric"}, r"expected letters that occur \(A, S\), got B"),
        (Norm(MatrixSymbol("v", 3, 1)), {}, "expected the letters of the arguments, got also v"),
        (S + Identity(3) * sympy.Symbol("t"), {}, "expected the symbols of the arguments, got also"),
    ],
)
def test_what_cannot_be_written_out_is_refused(derived, properties, message):
    with pytest.raises(DeclarationError, match=rf"^kernel demo\.f.*{message}"):
        declared("f", derived, [A, S], properties)


def test_lengths_are_refused():
    v = MatrixSymbol("v", 3, 1)
    with pytest.raises(DeclarationError, match=r"derived: expected rational functions of the entries, got norm"):
        declared("f", Norm(v) * v, [v])


def test_blocks_and_numbers_beside_letters_are_written_out():
    kernel, *_ = declared("f", BlockMatrix([[P, r * x]]), [P, x, r], {P: "symmetric"})
    names = [[str(entry) for entry in row] for row in kernel.derived.tolist()]
    assert names == [["P_11", "P_12", "r*x_1"], ["P_12", "P_22", "r*x_2"]]


def test_dispersions_of_the_papers_read_one_triangle_and_are_symmetric():
    rotation, image = metric.rotation_left(0.1, 0.2), [0.3, -0.2]
    blocks = np.random.default_rng(1).uniform(-1, 1, (3, 3))
    dispersion = blocks @ blocks.T
    whole = metric.normal_covariance(rotation, image, 1.5, dispersion, 0.25)
    np.testing.assert_array_equal(whole, metric.normal_covariance(rotation, image, 1.5, np.triu(dispersion), 0.25))
    assert whole[0, 1] == whole[1, 0]
    value, bound = algebroproj.bounds(metric.normal_covariance)(rotation, image, 1.5, np.triu(dispersion), 0.25)
    assert (abs(value - whole) <= bound).all()
