"""A-priori error bounds hold for every input that an adversary finds, and Coq accepts them and no smaller ones."""

import json
import math
import random
import re
import shutil
import subprocess
from dataclasses import replace
from fractions import Fraction
from importlib.resources import files as resources
from operator import add, mul, neg, sub, truediv
from pathlib import Path
from types import FunctionType

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import algebroproj
from algebroproj_sym.declaring import judge, kernels, select
from algebroproj_sym.exporting.compiling import CLASSICAL, assumptions, compiled
from algebroproj_sym.exporting.files import LIBRARY
from algebroproj_sym.exporting.rounding import CHECKER, accuracy_of, render
from algebroproj_sym.exporting.rounding.theorems import definitions, instance
from algebroproj_sym.files import write_texts
from algebroproj_sym.generating.backends.c import is_compiled
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.program import recorded, run
from algebroproj_sym.generating.ranges import reach
from algebroproj_sym.verifying.a_priori import ONE, Analysis, Bound, analysis
from algebroproj_sym.verifying.c_execution import Meaning, NotUnderstoodError, inline_value, source_of
from algebroproj_sym.verifying.condition_numbers import a_priori_record, as_record, conditions
from algebroproj_sym.verifying.shipped import call, function_of, load_package
from algebroproj_sym.verifying.straight_line import executed, numbered, straight_line, straight_line_of_c

FUNCTIONS = (
    "projection.mu_from_center",
    "projection.project",
    "affine.plane_coordinates",
    "correlation.epipoles",
    "projection.projection_determinant",
)
UNDERFLOW = 1e-250


def has_flocq():
    if shutil.which("coqc") is None:
        return False
    where = subprocess.run(["coqc", "-where"], capture_output=True, text=True, check=True).stdout.strip()
    return (Path(where) / "user-contrib" / "Flocq").is_dir()


needs_coq = pytest.mark.skipif(not has_flocq(), reason="Coq with Flocq is not installed: no theorem was compiled")


@pytest.fixture(scope="module", params=FUNCTIONS)
def chosen(request):
    (kernel,) = kernels([request.param])
    return lower(kernel)


def starting_point(generator, count):
    """Entries of very different sizes, or small integers with a disturbance in the last bits: sums then cancel."""
    if generator.random() < 0.5:
        return [generator.uniform(-2, 2) * 2.0 ** generator.randint(-20, 20) for _ in range(count)]
    return [generator.randint(-3, 3) * (1 + generator.randint(-8, 8) * 2.0**-52) or 0.5 for _ in range(count)]


def moved(generator, point):
    """Change a few bits of an entry, anywhere in the significand."""
    changed, place = list(point), generator.randrange(len(point))
    bits = int(np.float64(changed[place]).view(np.int64)) ^ (1 << generator.randrange(52))
    changed[place] = float(np.int64(bits).view(np.float64))
    return changed


def sized(line, arguments):
    """The exact value of each operation, and the same with absolute values of everything, so that no sum cancels."""
    values, sizes = {}, {}
    for number, (operator, operands) in line.operations.items():
        match operator:
            case "constant" | "input":
                values[number] = Fraction(operands[0]) if operator == "constant" else arguments[operands[0]]
                sizes[number] = abs(values[number])
                continue
            case "/":
                size = sizes[operands[0]] * sizes[operands[1]] / values[operands[1]] ** 2
            case "join":
                size = sizes[operands[0]]
            case "*" | "product_error":
                size = math.prod(sizes[operand] for operand in operands[:2]) + sum(sizes[o] for o in operands[2:])
            case _:
                size = sum(sizes[operand] for operand in operands)
        values[number], sizes[number] = MEANING[operator](*(values[operand] for operand in operands)), size
    return values, sizes


MEANING = {
    "+": add,
    "join": add,
    "-": sub,
    "*": mul,
    "/": truediv,
    "neg": neg,
    "product_error": lambda a, b, product: a * b - product,
}


def relative_error(bound, kappas):
    unit = Fraction(1, 2**53)
    t = bound.roundings * unit + sum(Fraction(c, ONE) * unit**2 * kappas[place] for place, c in bound.terms)
    return t / (1 - t) if t < 1 else None


def relative_errors(found, arguments):
    """The bound of the relative error of each result at a point; None where there is none."""
    values, sizes = sized(found.line, arguments)
    errors = []
    for bound in found.bounds:
        if bound is None or any(values[place] == 0 for place, _ in bound.terms):
            errors.append(None)
            continue
        errors.append(relative_error(bound, {place: sizes[place] / abs(values[place]) for place, _ in bound.terms}))
    return errors


def ratios(chosen, found, point):
    """The error of each result over its bound, where there is one and nothing underflows or is singular."""
    symbols = chosen.kernel.symbols
    exact_arguments = [Fraction(value) for value in point]
    try:
        bounds = relative_errors(found, exact_arguments)
        exact = run(chosen.plain, dict(zip([s.name for s in symbols], exact_arguments, strict=True)))
    except ZeroDivisionError:
        return []
    with np.errstate(all="ignore"):
        batch = {symbol.name: np.array([value]) for symbol, value in zip(symbols, point, strict=True)}
        computed = call(function_of(chosen.kernel, algebroproj), chosen.kernel, batch)[0].tolist()
    return [
        abs(Fraction(value) - truth) / (bound * abs(truth))
        for value, truth, bound in zip(computed, exact, bounds, strict=True)
        if bound and math.isfinite(value) and abs(truth) > UNDERFLOW
    ]


@pytest.mark.sampled(3)
def test_no_error_is_larger_than_its_bound(chosen):
    """Hill climbing over bits, from several points, never gets beyond the bound; it does get near."""
    found = analysis(straight_line(chosen))
    assert found.is_complete
    generator, largest = random.Random(18), Fraction(0)
    for _ in range(12):
        point = starting_point(generator, len(chosen.kernel.symbols))
        best = max(ratios(chosen, found, point), default=Fraction(0))
        for _ in range(60):
            candidate = moved(generator, point)
            ratio = max(ratios(chosen, found, candidate), default=Fraction(0))
            if ratio >= best:
                point, best = candidate, ratio
        largest = max(largest, best)
    assert Fraction(1, 8) < largest <= 1


def test_the_rule_of_an_error_names_the_operation_that_computes_it(chosen):
    found = analysis(straight_line(chosen))
    names = {"ErrorOfSum": "+", "ErrorOfDifference": "-", "ErrorOfProduct": "product_error"}
    errors = [fact for fact in found.certificate if fact.rule in names]
    assert len(errors) >= 5
    for fact in errors:
        assert found.line.operations[fact.arguments[0]][0] == names[fact.rule]


def extreme_point(generator, count, k):
    """Numbers from both ends of a range, or such that sums of some of them and 1 nearly cancel several times."""
    if generator.random() < 0.5:
        return [
            generator.choice((-1, 1)) * generator.uniform(1, 2) * 2.0 ** generator.choice((-k, 1 - k, 0, k - 1))
            for _ in range(count)
        ]
    point = [generator.uniform(0.1, 0.9) for _ in range(count)]
    for place in generator.sample(range(count), count // 2):
        point[place] = 1 - point[place - 1] + generator.choice((0.0, 2.0**-53, -(2.0**-52), 2.0**-80))
    return point


def test_the_bound_holds_at_the_ends_of_the_range_and_next_to_singular_points(chosen):
    """Where the hypotheses of the theorem hold, results are finite and no error is larger than the bound."""
    found, k = analysis(straight_line(chosen)), reach(chosen.program)
    generator, checked = random.Random(7), 0
    for _ in range(150):
        point = extreme_point(generator, len(chosen.kernel.symbols), k)
        try:
            values, sizes = sized(found.line, [Fraction(value) for value in point])
        except ZeroDivisionError:
            continue
        kappas = {place: sizes[place] / abs(value) for place, value in values.items() if value}
        if not all(d.result in kappas and applies(d, kappas) for d in found.divisors):
            continue
        with np.errstate(all="ignore"):
            batch = {symbol.name: np.array([value]) for symbol, value in zip(chosen.kernel.symbols, point, strict=True)}
            computed = call(function_of(chosen.kernel, algebroproj), chosen.kernel, batch)[0].tolist()
        for bound, value in zip(found.bounds, computed, strict=True):
            assert math.isfinite(value)
            if applies(bound, kappas):
                truth = values[bound.result]
                assert abs(Fraction(value) - truth) <= relative_error(bound, kappas) * abs(truth)
                checked += 1
    assert checked > 50


def applies(bound, kappas):
    return all(place in kappas for place, _ in bound.terms) and relative_error(bound, kappas) is not None


@pytest.mark.whole
def test_the_c_source_computes_what_was_analysed(lowered):
    """The lines of the C source, parsed, are the program that the bounds speak of, and each result has a bound."""
    rational = [low for kernel in kernels() if (low := lowered(kernel.qualified_name)).kernel.is_rational]
    assert len(rational) >= 74
    for low in rational:
        line = straight_line(low)
        if is_compiled(low):
            assert straight_line_of_c(low, algebroproj) == line
        assert analysis(line).is_complete, low.kernel.qualified_name


def c_text():
    return (Path(algebroproj.__file__).parent / "_c" / "kernels.h").read_text(encoding="utf-8")


def test_lines_that_round_in_another_way_are_refused():
    """A product that is added without rounding is no product and no sum."""
    low = lower(*kernels(["optics.scale"]))
    body = "const real x = in[0][i];\n const real y = in[1][i];\n const real z = x + y;\n out[0][i] = x / z;"
    text = f"KERNEL(optics_scale)\n{{\n    for (npy_intp i = 0; i < points; i++) {{\n {body}\n    }}\n}}\n"
    line = executed(low, source_of(text))
    assert [operator for operator, _ in line.operations.values()] == ["input", "input", "+", "/"]
    with pytest.raises(NotUnderstoodError, match="rounds once"):
        executed(low, source_of(text.replace("x + y", "multiply_add(x, y, x)")))
    with pytest.raises(NotUnderstoodError, match="decimal"):
        executed(low, source_of(text.replace("x + y", "x + 010")))


class Rounded(str):
    """A formula of rounded operations, as the theorems write it."""

    def _rounded(self, sign, other):
        return Rounded(f"RN ({self} {sign} {other})")

    def __add__(self, other):
        return self._rounded("+", other)

    def __sub__(self, other):
        return self._rounded("-", other)

    def __mul__(self, other):
        return self._rounded("*", other)


def test_the_lemma_of_the_error_of_a_product_speaks_of_the_operations_of_the_c_source():
    """Without fused operations the theorems are about another formula, which the lemma has term by term."""
    lemmas = (resources("algebroproj_sym.exporting.rounding") / "Rounding.v").read_text(encoding="utf-8")
    stated = lemmas.partition("Lemma split_product_error")[2].partition("let p := RN (a * b) in\n")[2]
    stated = stated.partition(" = a * b - p.")[0]
    for name in ("lower_half", "upper_half"):
        (meaning,) = re.findall(rf"Definition {name} x := (.+)\.\n", lemmas)
        stated = re.sub(rf"{name} ([ab])", lambda found, m=meaning: re.sub(r"\bx\b", found[1], m), stated)
    meaning = Meaning(constants={"splitter": Rounded("splitter")})
    found = inline_value(source_of(c_text()), "split_product_error", [Rounded(name) for name in "abp"], meaning)
    assert " ".join(stated.split()) == found
    (splitter,) = re.findall(r"Definition splitter := (\d+)\.", lemmas)
    assert f"#define splitter {splitter}.0\n" in (Path(algebroproj.__file__).parent / "_c" / "compiled.c").read_text()


def test_the_bound_of_a_formula_is_the_one_of_its_definition(chosen):
    """The condition numbers that are written are those that are evaluated."""
    found = analysis(straight_line(chosen))
    texts, where = conditions(found)
    generator = random.Random(1)
    arguments = [Fraction(generator.randint(1, 50), 7) for _ in found.line.inputs]
    names = dict(zip(found.line.inputs, arguments, strict=True))
    for name, text in where.items():
        names[name] = evaluated(text, names)
    kappas = {place: evaluated(text, names) for place, text in texts.items()}
    for bound, expected in zip(found.bounds, relative_errors(found, arguments), strict=True):
        assert relative_error(bound, kappas) == expected


def evaluated(text, names):
    """Evaluate an expression with bars for absolute values, which are never nested."""
    return eval(re.sub(r"\|([^|]*)\|", r"abs(\1)", text), {"abs": abs}, dict(names))


def test_a_sum_that_may_cancel_has_no_bound_without_compensation():
    line = numbered(recorded("xyz", lambda x, y, z: (x - y - z, x * y / z)))
    first, second = analysis(line).bounds
    assert first is None
    assert (second.roundings, second.terms) == (2, ())


def test_the_record_says_what_the_bounds_are():
    low = lower(*kernels(["projection.mu_from_center"]))
    record = as_record(analysis(straight_line(low)))
    first, second = record["results"][0]["terms"]
    assert record["results"][0]["roundings"] == 5
    assert (first["coefficient"], first["kappa"]) == (5.01, "(1 + |y01| + |y02| + |y03|)/|1 - y01 - y02 - y03|")
    assert (second["coefficient"], second["kappa"]) == (2.01, "(1 + |u31| + |u32|)/|1 - u31 - u32|")


@given(st.integers(1, 2**40))
def test_a_coefficient_of_three_digits_is_not_smaller_than_the_proved_one(coefficient):
    line = numbered(recorded("x", lambda x: (x,)))
    (result,) = as_record(Analysis(line, (Bound(1, 0, ((1, coefficient),)),), (), ()))["results"]
    (term,) = result["terms"]
    assert 0 <= term["coefficient"] - coefficient / ONE <= 0.01 * coefficient / ONE


def test_the_record_in_the_package_is_what_is_found_now(repository, chosen):
    text = (repository / "generated" / "algebroproj" / "accuracy.json").read_text(encoding="utf-8")
    known = {entry["function"]: entry.get("a_priori") for entry in json.loads(text)["functions"]}
    assert known[chosen.kernel.qualified_name] == a_priori_record(chosen)


@pytest.mark.whole
def test_the_whole_record_in_the_package_is_what_a_build_finds(repository, built):
    """Bounds are not measured: a record of them is right, or it is wrong."""
    texts = (
        (folder / "accuracy.json").read_text(encoding="utf-8")
        for folder in (repository / "generated/algebroproj", built)
    )
    known, found = (
        {entry["function"]: entry.get("a_priori") for entry in json.loads(text)["functions"]} for text in texts
    )
    assert known == found


def test_a_bound_is_that_of_the_package_of_the_function():
    """A function of another package does not get the record of this one."""
    assert str(algebroproj.a_priori(algebroproj.optics.scale)[0]) == "2 u"
    names = {**algebroproj.optics.scale.__globals__, "__file__": "elsewhere/optics.py"}
    other = FunctionType(algebroproj.optics.scale.__code__, names, "scale")
    assert algebroproj.a_priori(other) == ()
    with pytest.raises(TypeError, match="a_priori: expected a generated function"):
        algebroproj.a_priori(math.sin)


def test_what_is_told_of_a_function_can_be_kept_and_changed_by_nobody_else():
    """Bounds are values: equal ones have equal hashes, and changing one changes no later answer."""
    first, second = (algebroproj.a_priori(algebroproj.projection.project) for _ in range(2))
    assert {*first} == {*second}
    expected = dict(second[0].where)
    first[0].where["s"] = "changed"
    assert algebroproj.a_priori(algebroproj.projection.project)[0].where == second[0].where == expected


@pytest.mark.parametrize("changed", ["bounds", "dd", "hypotheses", "plain", "rounded"])
def test_a_changed_function_has_no_bound_of_the_function_itself(changed, tmp_path):
    """Without compensation nothing bounds the error of a sum that cancels."""
    shutil.copytree(Path(algebroproj.__file__).parent, tmp_path / "other")
    for package in (algebroproj, load_package(tmp_path, "other")):
        other = getattr(package, changed)(package.projection.mu_from_center)
        with pytest.raises(TypeError, match=rf"a_priori: expected a generated function, got {changed}\(projection.mu_"):
            algebroproj.a_priori(other)


def mutants(found: Analysis):
    """Programs, certificates and bounds that say something else: operations, constants and bounds are changed."""
    line = found.line
    for name in ("bounds", "divisors"):
        bounds = getattr(found, name)
        for place, bound in enumerate(bounds):
            smaller = [replace(bound, roundings=bound.roundings - 1)] if bound.roundings else []
            for k, (number, coefficient) in enumerate(bound.terms):
                others = bound.terms[:k], bound.terms[k + 1 :]
                smaller.append(replace(bound, terms=(*others[0], (number, coefficient - 1), *others[1])))
                smaller.append(replace(bound, terms=(*others[0], *others[1])))
            for mutant in smaller:
                yield replace(found, **{name: (*bounds[:place], mutant, *bounds[place + 1 :])})
    for place in range(len(found.divisors)):
        yield replace(found, divisors=found.divisors[:place] + found.divisors[place + 1 :])
    other = {"+": "-", "-": "+", "*": "/", "/": "*", "neg": "product_error", "join": "+"}
    used = {number for fact in found.certificate for number in fact.arguments if isinstance(number, int)}
    for number, (operator, operands) in line.operations.items():
        changed = None
        if operator in ("+", "-", "/", "join") and number in used:
            changed = other[operator], operands
        if operator == "product_error" and operands[0] != operands[1]:
            changed = operator, (operands[0], operands[0], operands[2])
        if operator == "constant":
            changed = operator, (2**60 + 1,)
        if changed is not None:
            yield replace(found, line=replace(line, operations={**line.operations, number: changed}))
    for place, fact in enumerate(found.certificate):
        if place % 7 == 0 and not any(fact in other.arguments for other in found.certificate):
            yield replace(found, certificate=found.certificate[:place] + found.certificate[place + 1 :])


def wrongly_joined(found: Analysis):
    """Programs that say of the second number of a sum that it was only rounded off the first: bounds get smaller."""
    line = found.line
    for number in {fact.arguments[0] for fact in found.certificate if fact.rule == "SumOf"}:
        operations = {**line.operations, number: ("join", line.operations[number][1])}
        yield replace(found, line=replace(line, operations=operations))


def test_a_file_says_what_its_numbers_stand_for(chosen):
    """A reader of a theorem finds the arguments and the entries of the results."""
    found = accuracy_of(chosen, algebroproj)
    text = render([found])[f"{found.name}.v"]
    for place, symbol in enumerate(chosen.kernel.symbols, start=1):
        assert f"Input {place} is {symbol}" in text
    for place, number in enumerate(found.analysis.line.outputs, start=1):
        assert f"entry {place} is {number}" in text


def test_a_function_without_a_bound_has_no_file(chosen):
    found = accuracy_of(chosen, algebroproj)
    unknown = replace(found, analysis=replace(found.analysis, bounds=(None,) * len(found.analysis.bounds)))
    assert render([found]).keys() - render([unknown]) == {f"{found.name}.v"}


def test_a_file_names_the_claims_that_its_formula_rests_on(chosen):
    """Each selector is that of a claim, and the claim is decided as it says."""
    found = accuracy_of(chosen, algebroproj)
    text = " ".join(render([found])[f"{found.name}.v"].split())
    selectors = text.partition("these claims of the ledger: ")[2].partition(". ")[0].split(", ")
    assert selectors == [f"{chosen.kernel.paper}:{number}" for number in chosen.kernel.claims]
    for selector in selectors:
        (claim,) = [claim for claim in select([selector]) if f"{claim.paper}:{claim.number}" == selector]
        assert judge(claim).verdict == claim.expected


def test_arguments_that_cannot_be_are_not_looked_for_without_end():
    line = numbered(recorded("x", lambda x: (1 / (x - x),)))
    with pytest.raises(ValueError, match="no divisor is zero, found none in"):
        instance(analysis(line), 9, bool)


@pytest.fixture
def checker(made_once, tmp_path):
    """A folder with the compiled files that all theorems about rounding need."""

    def compile_all(folder):
        write_texts(render([]), folder)
        assert not any(found.error for name in CHECKER for found in compiled(folder, [name]))

    return shutil.copytree(made_once("checker", compile_all), tmp_path / "checker")


@pytest.mark.whole
@needs_coq
def test_coq_accepts_the_bounds_and_rejects_mutants(checker):
    """The theorems are accepted, rest on the listed axioms; mutants, wider ranges and singular points fail."""
    names = ("projection.mu_from_center", "normal_case.from_orientation", "projection.projection_determinant")
    chosen = [lower(*kernels([name])) for name in names]
    found = [accuracy_of(low, algebroproj) for low in chosen]
    write_texts(render(found), checker)
    assert not any(result.error for result in compiled(checker, [each.name for each in found]))
    assumed = assumptions(checker, CLASSICAL)
    assert not assumed.error
    assert set(assumed.axioms) <= CLASSICAL
    parts = ["From Coq Require Import ZArith NArith PArith List.\n"]
    parts.append(f"From {LIBRARY} Require Import Checker Machine Instances.\n")
    parts.append(f"From {LIBRARY} Require Import Exact {found[0].name}.\nFrom {LIBRARY} Require Formulas.\n")
    parts.append("Import ListNotations.\nOpen Scope positive_scope.\n")
    (analysed, k), changed = (found[0].analysis, found[0].reach), [*mutants(found[0].analysis)]
    (divided, narrow), others = (found[2].analysis, found[2].reach), [*mutants(found[2].analysis)]
    others += wrongly_joined(found[1].analysis)
    for place, mutant in enumerate([analysed, *changed, divided, *others]):
        parts.append(definitions(str(place), mutant))
    checks = [range_check(0, k), instance_check(k, instance(analysed, 9, bool)), range_check(0, 0), formula_check()]
    checks.append(range_check(len(changed) + 1, narrow))
    checks += [
        range_check(place, k)
        for place, mutant in enumerate(changed, start=1)
        if not has_a_product_for_a_quotient(analysed, mutant)
    ]
    checks += [range_check(len(changed) + 1 + place, narrow) for place in range(1, len(others) + 1)]
    checks += [range_check(0, wrong) for wrong in (k + 1, 2 * k, 1023, 5000)]
    singular = [1, 0, 0, 5, 4], [7, -5, 7, 8, -7], [2**53 + 1, -5, 7, 8, 4]
    checks += [instance_check(k, numbers) for numbers in singular]
    checks += [instance_check(3, [9, -5, 7, 8, 4]), instance_check(-1, [0, 0, 0, 0, 0])]
    checks += [formula_check(lines=f"lines{place}") for place in computing_something_else(analysed, changed)]
    checks += [formula_check(formulas=f"(Formulas.{operation} :: tl {FORMULAS})") for operation in OTHER_FORMULAS]
    checks += [formula_check(formulas=f"(rev {FORMULAS})"), formula_check(factors="(tl Trees.factors)")]
    parts.append(f"Definition all := [{'; '.join(checks)}].\n")
    parts.append("Eval vm_compute in map fst (filter snd (combine (seq 0 (length all)) all)).\n")
    (checker / "mutants.v").write_text("\n".join(parts), encoding="utf-8")
    command = ["coqc", "-q", "-R", ".", LIBRARY, "mutants.v"]
    said = subprocess.run(command, cwd=checker, capture_output=True, text=True, check=True).stdout
    assert len(checks) > 100
    assert "= [0%nat; 1%nat; 2%nat; 3%nat; 4%nat]" in " ".join(said.split())


def program(*operations):
    return "[" + "; ".join(f"({place}, {text})" for place, text in enumerate(operations, start=1)) + "]"


SQUARED = [f"Mul {place} {place}" for place in range(2, 8)]
"""The second number of a program, raised to the power 64."""


@pytest.mark.whole
@needs_coq
def test_without_a_range_the_theorem_is_about_results_that_are_finite(checker):
    """There are arguments for which it says something; where a line overflows or underflows, it says nothing."""
    (kernel,) = kernels(["metric.normal_covariance"])
    found = accuracy_of(lower(kernel), algebroproj)
    assert found.reach is None
    write_texts(render([found]), checker)
    (result,) = compiled(checker, [found.name])
    assert not result.error
    assert set(assumptions(checker, CLASSICAL).axioms) <= CLASSICAL
    text = (checker / f"{found.name}.v").read_text(encoding="utf-8")
    for theorem in ("finite", "formula", "possible"):
        assert f"Theorem {found.name}_{theorem} :" in text
    overflowing = program("Input 1", "Neg 1", *SQUARED)
    underflowing = program("Constant 1", "Input 1", "Div 1 2", *(f"Mul {place} {place}" for place in range(3, 8)))
    checks = [
        f"runs {overflowing} [2]%Z",
        f"runs {overflowing} [2 ^ 15]%Z",
        f"runs {overflowing} [2 ^ 16]%Z",
        f"runs {underflowing} [2]%Z",
        f"runs {underflowing} [2 ^ 40]%Z",
        f"runs {underflowing} [0]%Z",
        f"runs {program('Input 1')} [2 ^ 53 + 1]%Z",
        f"runs {program('Neg 1', 'Input 1')} [1]%Z",
    ]
    parts = [f"From {LIBRARY} Require Import Checker Machine Instances.\n", "From Coq Require Import ZArith List."]
    parts += ["Import ListNotations.\nOpen Scope positive_scope.", f"Eval vm_compute in [{'; '.join(checks)}]."]
    (checker / "points.v").write_text("\n".join(parts), encoding="utf-8")
    command = ["coqc", "-q", "-R", ".", LIBRARY, "points.v"]
    said = subprocess.run(command, cwd=checker, capture_output=True, text=True, check=True).stdout
    assert "= [true; true; false; true; false; false; false; false]" in " ".join(said.split())


FORMULAS = "Trees.formulas"
OTHER_FORMULAS = [f"Opp (hd (Formulas.Int 0) {FORMULAS})", "Int 0", "Var 7", f"Abs (hd (Formulas.Int 0) {FORMULAS})"]


def formula_check(lines="lines0", formulas=FORMULAS, factors="Trees.factors"):
    return f"is_formula 5 {lines} splits {factors} (map fst bounds0) {formulas}"


def computing_something_else(analysed, changed):
    """The places of mutants whose lines have another exact value at some point."""
    point = [Fraction(value) for value in (2, 3, 5, 7, 11)]
    truth, _ = sized(analysed.line, point)
    for place, mutant in enumerate(changed, start=1):
        try:
            values, _ = sized(mutant.line, point)
        except ZeroDivisionError:
            continue
        if any(values[bound.result] != truth[bound.result] for bound in filter(None, analysed.bounds)):
            yield place


def has_a_product_for_a_quotient(analysed, mutant):
    """Both have the same bound for their rounding: such a mutant is only wrong in its formula."""
    before, after = analysed.line.operations, mutant.line.operations
    return any((before[number][0], after[number][0]) == ("/", "*") for number in before)


def range_check(place, k):
    return f"check_range ({k})%Z lines{place} certificate{place} bounds{place} divisors{place}"


def instance_check(k, numbers):
    return f"is_instance ({k})%Z lines0 bounds0 divisors0 [{'; '.join(map(str, numbers))}]%Z"
