"""Among equal forms the generator takes the cheapest that errs little."""

from dataclasses import replace
from fractions import Fraction
from math import ulp

import numpy as np
import pytest
import sympy

import algebroproj
from algebroproj_sym.declaring import DeclarationError
from algebroproj_sym.declaring.kernel import declared_kernel
from algebroproj_sym.expressions import Matrix, evaluate, over, vector
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.compensation import compensated
from algebroproj_sym.generating.factored import factored
from algebroproj_sym.generating.lowering import LoweringError, lowered_form
from algebroproj_sym.generating.program import run
from algebroproj_sym.generating.samples import on_sum, stratified

x, y, z = sympy.symbols("x y z")
a, b = sympy.symbols("a b")


def kernel(derived, **parts):
    names = {"x": x, "y": y, "z": z}
    return declared_kernel(
        "paper",
        "1",
        "module.function",
        "A function.",
        derived=derived,
        arguments=names,
        describe=dict.fromkeys(names, "A number."),
        example=dict.fromkeys(names, "1.5"),
        claims=["1"],
        **parts,
    )


def operations(lowered):
    return sum(lowered.program.operations().values())


def test_a_cheaper_alternative_is_taken():
    long = (x + y) * (x + y) * z + (x + y) * x * z + (x + y) * y * z + 2 * z * z * (x + y)
    short = 2 * (x + y) * z * (x + y + z)
    chosen = lower(kernel(long, alternatives=[{"form": short}]))
    assert operations(chosen) <= operations(lowered_form(kernel(long, form=short)))
    assert chosen.forms > 1


def test_a_cheap_alternative_that_errs_more_is_not_taken(monkeypatch):
    """Twice the digits make up for any form of a short program, so they are taken away here."""
    monkeypatch.setattr("algebroproj_sym.generating.lowering.compensated", lambda program: program)
    monkeypatch.setattr("algebroproj_sym.generating.choosing.compensated", lambda program, throughout: program)
    monkeypatch.setattr("algebroproj_sym.generating.choosing.factored", lambda kernel: None)
    good = (x - y) * (x - y) * (x - y) * (x + y)
    expanded = x**4 - 2 * x**3 * y + 2 * x * y**3 - y**4
    assert lower(kernel(good, form=expanded, alternatives=[{"form": good}])).kernel.form == good
    assert lower(kernel(good, form=good, alternatives=[{"form": expanded}])).kernel.form == good


def test_an_alternative_brings_its_own_abbreviations():
    chosen = lower(kernel(x * y - x * z, alternatives=[{"form": x * a, "where": {a: y - z}}]))
    point = {"x": Fraction(3), "y": Fraction(5), "z": Fraction(7)}
    assert run(chosen.plain, point, lambda call, rows: rows[0]) == (-6,)


@pytest.mark.parametrize(
    ("other", "message"),
    [
        ({"form": a}, "got also"),
        ({"form": vector(x, y)}, r"expected a form of shape \(\)"),
        ({"form": x, "where": {x: y}}, "expected different names"),
    ],
)
def test_an_alternative_is_checked_as_a_form_is(other, message):
    with pytest.raises(DeclarationError, match=message):
        kernel(x * y, alternatives=[other])


def test_an_alternative_that_is_not_equal_is_refused():
    with pytest.raises(LoweringError, match="differs from the derivation"):
        lower(kernel(x * y, alternatives=[{"form": x * z}]))


def test_divisors_that_are_shared_divide_once():
    quotients = vector(*(over(entry, x * y + z) for entry in (x, y, z)))
    assert lower(kernel(quotients)).program.operations()["/"] == 1


def test_the_samples_decide_the_same_each_time():
    declared = kernel(Matrix([[over(x, y), over(z, y)], [over(x - z, y + z), over(x, y + z)]]))
    assert lower(declared) == lower(declared)


def test_a_derivative_is_factored():
    declared = kernel(over(1, x - y) - over(x + z, (x - y) ** 2), where={a: y + z})
    found = factored(declared)
    assert found.form == over(-a, (x - y) ** 2)
    assert found.where == ((a, y + z),)


def ulps(low, program):
    """Return the errors of a program at samples, entry by entry."""
    found = []
    for sample in stratified(low, 50):
        point = {symbol: Fraction(sample.values[symbol.name]) for symbol in low.kernel.symbols}
        truths = evaluate(low.kernel.derived, point)
        results = run(program, sample.values)
        found += [abs(Fraction(r) - t) / Fraction(ulp(t)) for r, t in zip(results, truths, strict=True)]
    return np.array(found, dtype=float)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", ["normal_case.from_orientation", "correlation.correlation_from_cameras"])
def test_no_entry_errs_much_more_than_with_twice_the_digits_throughout(name, lowered):
    """Not even where another one, so near several singularities that it may, errs by many units in the last place."""
    low = lowered(name)
    chosen, throughout = ulps(low, low.program), ulps(low, compensated(low.plain, throughout=True))
    assert throughout.max() > 4
    assert np.all(chosen <= np.fmax(4, 1.25 * throughout))


@pytest.mark.parametrize("name", ["projection.projection_matrix_jacobian", "metric.to_normal", "space.map_plane"])
def test_factored_forms_of_the_papers_are_what_is_derived(name, lowered):
    low = lowered(name)
    found = factored(low.kernel)
    for sample in stratified(low, 3):
        point = {symbol: Fraction(sample.values[symbol.name]) for symbol in low.kernel.symbols}
        known = dict(point)
        for symbol, expression in found.where:
            (known[symbol],) = evaluate(expression, known)
        assert evaluate(found.form, known) == evaluate(low.kernel.derived, point)


def test_long_factors_and_constant_fractions_have_no_factored_form():
    assert factored(kernel((x + y + z) ** 4 + x)) is None
    assert factored(kernel(vector(over(x, y), sympy.Rational(1, 2)))) is None


def test_no_form_is_chosen_where_results_are_not_exact_on_fractions(lowered):
    staged = lowered("metric.rotation_left")
    assert staged.forms == 1
    assert replace(staged.kernel, alternatives=(staged.kernel,)).stages


def test_a_form_that_keeps_exact_zeros_is_taken():
    """Of x/y - x z/y and x (1 - z)/y only the product is zero for z = 1, whatever x/y is rounded to."""
    low = lower(kernel(over(x, y + z) - over(x * z, y + z) + over(x - x * z, (y + z) ** 2)))
    samples = on_sum(1 - z, low.kernel.symbols, 200)
    assert len(samples) == 200
    for sample in samples:
        assert run(low.program, sample.values) == (0,)


def test_an_entry_of_a_derivative_is_zero_where_its_numerator_is():
    """The numerator of the entry is u30 (1 - uN32)."""
    generator = np.random.default_rng(5)
    u3, normal = generator.uniform(-4, 4, (2, 10_000, 2))
    normal[:, 1] = 1
    assert not np.any(algebroproj.normal_case.tau_jacobian(u3, normal)[:, 0, 2])
    normal[:, 1] = 1 + generator.integers(1, 9, 10_000) * 2.0**-52
    computed = algebroproj.normal_case.tau_jacobian(u3, normal)[:, 0, 2]
    for (a, b), (c, d), value in zip(u3.tolist(), normal.tolist(), computed.tolist(), strict=True):
        a, b, c, d = map(Fraction, (a, b, c, d))
        exact = (1 - a - b) * (1 - d) / (a * (1 - c - d) ** 2)
        assert abs(Fraction(value) - exact) <= 2 * Fraction(ulp(float(exact)))
