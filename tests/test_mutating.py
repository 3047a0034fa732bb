"""Mutation: the checks notice single changes of claims and of generated functions."""

import inspect
import json
from dataclasses import replace
from itertools import product

import pytest
import sympy
from click.testing import CliRunner

from algebroproj import optics, projection
from algebroproj_sym import Section
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import kernels, select
from algebroproj_sym.expressions import Matrix, over, vector
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.mutating.claims import MutantFate, MutatedClaim, _fate, mutate_claim
from algebroproj_sym.mutating.explanations import Explanation, explanations, superfluous, with_reasons
from algebroproj_sym.mutating.forms import mutants
from algebroproj_sym.mutating.kernels import mutate_kernel
from algebroproj_sym.mutating.sources import SourceMutant, recompiled, source_mutants
from algebroproj_sym.verifying.proof_of_source import at_points, in_general
from algebroproj_sym.verifying.shipped import function_of, load_package

x, y, u1, u2, up1, upp1 = sympy.symbols("x y u1 u2 up1 upp1")


def declared(kind, printed, derived, **options):
    return getattr(Section("demo", "1", "Squares"), kind)("1.1", "", printed=printed, derived=derived, **options)


def fates(claim, **options):
    return {fate.form: fate.fate for fate in mutate_claim(claim, **options).fates}


def test_every_place_of_an_expression_is_changed():
    changes = {mutant.change for mutant in mutants(declared("identity", u1 * up1 / u2 + 2, u1 * up1 / u2 + 2))}
    assert {"sign of 2", "index: u1 for u2", "prime: up1 for u1", "factor u1", "integer 2"} <= changes
    assert "numerator and denominator exchanged" in changes


def test_primes_are_exchanged():
    forms = {mutant.form for mutant in mutants(declared("identity", up1 + 1, up1 + 1, nonzero=[upp1]))}
    assert -up1 + 1 in forms
    forms = {mutant.form for mutant in mutants(declared("identity", up1 + x * upp1, up1 + x * upp1))}
    assert upp1 + x * upp1 in forms
    assert up1 + x * up1 in forms


def test_entries_of_a_matrix_are_exchanged_and_left_out():
    forms = {mutant.form for mutant in mutants(declared("identity", vector(x, y), vector(x, y)))}
    assert {vector(y, x), vector(0, y), vector(x, 0), vector(-x, y)} >= forms >= {vector(y, x), vector(0, y)}


def test_no_change_leaves_the_form_as_it_is():
    claim = declared("identity", x / y + x**2, x / y + x**2)
    forms = [mutant.form for mutant in mutants(claim)]
    assert claim.printed not in forms
    assert len(forms) == len(set(forms))


def test_a_wrong_form_is_refuted_and_an_equal_one_recognised():
    found = fates(declared("identity", (x - y) ** 2 * sympy.Integer(1), (y - x) ** 2))
    assert set(found.values()) == {"refuted"}
    circle = declared(
        "identity",
        x**2,
        1 - y**2,
        constraints=[x**2 + y**2 - 1],
        witness={x: sympy.Rational(3, 5), y: sympy.Rational(4, 5)},
    )
    assert fates(circle)["x**3"] == "refuted"
    scaled = fates(declared("up_to_scale", vector(x * y, y), vector(x, 1)))
    assert scaled["Matrix([[x], [y]])"] == "refuted"


def test_an_equivalent_change_is_proved_the_same_statement():
    symmetric = fates(declared("up_to_scale", vector(-x, 0), vector(x, 0)))
    assert symmetric["Matrix([[x], [0]])"] == "equivalent"
    pattern = fates(declared("structure", Matrix([[0, u1], [-u1, u2]]), Matrix([[0, x], [-x, y]])))
    assert pattern["Matrix([[0, -u1], [-u1, u2]])"] == "refuted"
    assert pattern["Matrix([[0, u1], [-u1, -u2]])"] == "equivalent"
    factors = fates(declared("vanishing", (x + y, y**2), (x + y) * y))
    assert factors["(x + y, y**3)"] == "equivalent"
    assert factors["(x - y, y**2)"] == "refuted"


@pytest.mark.parametrize(
    ("kind", "printed", "derived", "options"),
    [
        ("rank", 1, Matrix([[x, y], [2 * x, 2 * y]]), {"kernel": [vector(y, -x)]}),
        ("count", 1, vector(x, x**2), {"variables": [x]}),
        ("limit", x + u1, x + u1 + y, {"variable": y}),
        ("numeric", "0.33", sympy.Rational(1, 3), {}),
    ],
)
def test_changes_of_other_kinds_are_refuted(kind, printed, derived, options):
    found = fates(declared(kind, printed, derived, **options))
    assert found
    assert set(found.values()) == {"refuted"}


def test_every_digit_of_a_number_is_changed():
    found = mutants(declared("numeric", "-0.19", sympy.Rational(-19, 100)))
    digits = {f"{a}.{b}{c}" for a, b, c in product(range(10), repeat=3) if (a != 0) + (b != 1) + (c != 9) == 1}
    assert {str(mutant.form) for mutant in found} == {f"-{number}" for number in digits} | {"-0.20", "0.19"}


def test_what_holds_and_is_not_the_same_statement_survives():
    claim = declared("rank", 1, Matrix([[x, y], [2 * x, 2 * y]]), kernel=[vector(y, -x)])
    assert _fate(claim, claim.printed) == (
        "survived",
        "the changed form holds, but is not the same statement",
    )


def test_what_is_not_proved_has_no_mutants():
    claim = declared("identity", x, y, expect="false", instead="1.1")
    assert mutate_claim(claim).fates == ()


def test_the_choice_is_always_the_same():
    claim = declared("identity", x / y + u1 * u2, x / y + u1 * u2)
    first, second = (mutate_claim(claim, limit=4) for _ in range(2))
    assert first == second
    assert len(first.fates) == 4 < first.total


def test_changes_of_real_claims_are_refuted():
    found = [mutate_claim(claim, limit=3) for claim in select(["fundamentals1996:1.2"])]
    fates_found = [fate.fate for claim in found for fate in claim.fates]
    assert len(fates_found) > 20
    assert "survived" not in fates_found
    assert fates_found.count("refuted") > 0.9 * len(fates_found)


def test_sources_are_changed_in_single_places():
    lines = [mutant.line for mutant in source_mutants(projection.camera_matrix)]
    assert {"mu1 + 1", "1 - mu1", "mu2 - 1", "mu1", "-1", "mu1 - 0"} <= {*lines}
    assert not any("evaluate" in line or "return" in line for line in lines)


def test_a_changed_function_computes_something_else():
    changed = source_mutants(optics.scale)[0].compiled()
    assert changed(2.0, 3.0) != optics.scale(2.0, 3.0)


@pytest.mark.parametrize("name", ["optics.scale", "projection.mu_from_center", "correlation.epipolar_line_left"])
def test_changes_of_a_generated_function_are_noticed_twice(name):
    (kernel,) = kernels([name])
    found = mutate_kernel(lower(kernel), load_package(), limit=40, size=14)
    assert len(found.fates) == min(40, found.total)
    for fate in found.fates:
        assert fate.by_numbers or not fate.by_proof, fate
        assert fate.by_proof or "left out" in fate.change, fate
    assert sum(fate.by_proof for fate in found.fates) >= 0.7 * len(found.fates)


def test_a_changed_constant_entry_is_noticed_twice():
    (kernel,) = kernels(["optics.lens_matrix"])
    found = mutate_kernel(lower(kernel), load_package(), size=2)
    constants = [fate for fate in found.fates if fate.change == "number"]
    assert len(constants) == 12
    assert all(fate.by_numbers and fate.by_proof for fate in constants)


def test_leaving_out_digits_changes_no_real_number_and_costs_digits():
    (kernel,) = kernels(["projection.mu_from_center"])
    found = mutate_kernel(lower(kernel), load_package(), size=14)
    wide = [fate for fate in found.fates if fate.change == "wide left out"]
    assert wide
    assert all(fate.equivalent and fate.by_numbers for fate in wide)


def test_words_for_digits_are_left_out_one_by_one():
    lines = [mutant.line for mutant in source_mutants(projection.mu_from_center) if mutant.change == "wide left out"]
    source = inspect.getsource(projection._mu_from_center)
    assert len(lines) == source.count("wide(")
    assert len({*lines}) == len(lines)


@pytest.mark.parametrize("name", ["collinearity.coefficients", "optics.scale", "metric.rotation_right"])
def test_the_function_as_it_is_is_noticed_by_neither(name, monkeypatch):
    (kernel,) = kernels([name])
    function = function_of(kernel, load_package())
    unchanged = SourceMutant("none", "", lambda: recompiled(function))
    monkeypatch.setattr("algebroproj_sym.mutating.kernels.source_mutants", lambda function: [unchanged])
    (fate,) = mutate_kernel(lower(kernel), load_package(), size=2).fates
    assert fate.equivalent
    assert not fate.by_numbers


def test_a_source_that_is_wrong_before_it_is_changed_is_refused(monkeypatch):
    (kernel,) = kernels(["optics.scale"])
    wrong = source_mutants(optics.scale)[0].compiled()
    monkeypatch.setattr("algebroproj_sym.mutating.kernels.recompiled", lambda function: wrong)
    with pytest.raises(ValueError, match=r"optics\.scale: the source fails already"):
        mutate_kernel(lower(kernel), load_package(), size=2)


@pytest.mark.parametrize("name", ["optics.scale", "correlation.epipolar_line_left", "metric.rotation_right"])
def test_what_a_point_refutes_the_whole_source_refutes_too(name):
    (kernel,) = kernels([name])
    points, general = at_points(kernel, 2), in_general(kernel)
    refuted = 0
    for mutant in source_mutants(function_of(kernel, load_package()))[::3]:
        changed = mutant.compiled()
        if met(points, changed) is False:
            refuted += 1
            assert met([general], changed) is False, mutant.line
    assert refuted > 5 or name == "optics.scale"


def met(expectations, function):
    try:
        return all(expectation.is_met_by(function) for expectation in expectations)
    except (ZeroDivisionError, NameError, TypeError):
        return None


@pytest.mark.whole
def test_a_refuted_change_of_a_long_form_is_not_written_out():
    long = sum((i * x**i for i in range(2, 72)), start=over(-x, y) ** 2)
    found = mutate_claim(declared("identity", long, long)).fates
    assert {fate.form for fate in found if fate.fate == "refuted"} == {""}
    (same,) = [fate for fate in found if fate.fate == "equivalent"]
    assert same.form.startswith("over(x, y)**2") or "+ over(x, y)**2" in same.form


def run(*arguments):
    return CliRunner().invoke(main, ["mutate", *arguments])


def test_the_command_reports_scores():
    result = run("fundamentals1996:1.2.3", "--limit", "3")
    assert result.exit_code == 0
    assert "changed statements are refuted" in result.stdout
    assert "changed sources compute something else: " in result.stdout
    record = json.loads(run("fundamentals1996:1.2.3", "--limit", "3", "--only", "claims", "--format", "json").stdout)
    assert record["claims"]
    assert not record["functions"]


def test_a_selector_that_names_nothing_is_wrong_usage():
    assert run("nobody").exit_code == 2


def surviving(form="0.34"):
    return MutatedClaim("demo", "1.1", "numeric", 1, (MutantFate("last digit, one more", form, "survived", ""),))


def test_only_the_change_that_is_explained_is_explained():
    known = [Explanation("demo:1.1", "0.34", "A third, cut off.")]
    assert [fate.fate for fate in with_reasons([surviving()], known)[0].fates] == ["explained"]
    for other in (surviving("0.35"), replace(surviving(), number="1.2"), replace(surviving(), paper="other")):
        assert [fate.fate for fate in with_reasons([other], known)[0].fates] == ["survived"]
    refuted = replace(surviving(), fates=(MutantFate("last digit, one more", "0.34", "refuted"),))
    assert with_reasons([refuted], known) == [refuted]


def test_an_explanation_of_what_does_not_survive_is_superfluous():
    known = [Explanation("demo:1.1", "0.34", "A third, cut off.")]
    assert superfluous(with_reasons([surviving()], known), known) == []
    assert superfluous([replace(surviving(), fates=(MutantFate("sign", "0.34", "refuted"),))], known) == known
    assert superfluous([replace(surviving(), fates=(), total=1)], known) == []


def test_every_explanation_names_a_change_of_a_claim_and_gives_a_reason_of_its_own():
    claims = {f"{claim.paper}:{claim.number}": claim for claim in select()}
    for entry in explanations():
        claim = claims[entry.claim]
        assert entry.form in {str(mutant.form) for mutant in mutants(claim)}
        assert len(entry.why) > 60
    assert len({(entry.claim, entry.form) for entry in explanations()}) == len(explanations())


def test_the_command_knows_what_is_explained():
    explained = next(
        entry for entry in explanations() if entry.claim.startswith("fundamentals1996:4/i/beyond/direction#")
    )
    result = run(explained.claim, "--limit", "0", "--only", "claims", "--format", "json")
    assert result.exit_code == 0
    fates = {fate["form"]: fate for fate in json.loads(result.stdout)["claims"][0]["fates"]}
    assert fates[explained.form] | {"fate": "explained", "reason": explained.why} == fates[explained.form]
