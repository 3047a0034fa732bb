"""Identities that no one here wrote: every verdict is the declared one, and rests on evidence that is checked again."""

import json
import multiprocessing
import os
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path

import pytest
import sympy
from click.testing import CliRunner

from algebroproj_sym import prove
from algebroproj_sym.cli import main
from algebroproj_sym.expressions import entries, evaluate, parse, parse_zero, symbols_of
from algebroproj_sym.proving import Question, RationalFunction, RationalFunctionField, outcomes

CORPUS = Path(__file__).resolve().parent / "corpus"
FILES = ["ring", "field", "hypotheses", "geometry", "elliptic", "classical", "systems", "traps", "real", "plane"]
ITEMS = [(name, item) for name in FILES for item in json.loads((CORPUS / f"{name}.json").read_text(encoding="utf-8"))]
REPLAYED = 4_000


def read(item):
    constraints = [parse_zero(text) for text in item.get("constraints", [])]
    return parse(item["lhs"]), parse(item["rhs"]), constraints, [parse(text) for text in item.get("nonzero", [])]


def exact(expression, point):
    values = (sympy.sympify(entry).doit().subs(point) for entry in entries(expression))
    return [sympy.radsimp(sympy.expand(value)) for value in values]


def refutes(item, counterexample):
    """Whether a point lies on the constraints, off what is not zero, and tells the sides apart, by substitution."""
    lhs, rhs, constraints, nonzero = read(item)
    point = {s: sympy.Rational(str(v)) if isinstance(v, Fraction) else v for s, v in counterexample.items()}
    zero = [0]
    return (
        all(exact(constraint, point) == zero for constraint in constraints)
        and all(exact(unit, point) != zero for unit in nonzero)
        and exact(lhs, point) != exact(rhs, point)
    )


def multiplies_out(item, certificate):
    """Whether a certificate is right, step by step, in the other engine."""
    lhs, rhs, constraints, nonzero = read(item)
    field = RationalFunctionField(symbols_of((lhs, rhs, *constraints, *nonzero)), "sympy")

    def value(expression):
        return evaluate(expression, field.variables, field.lift)

    def top(expression):
        return RationalFunction(field, value(expression)[0].numerator, ())

    def read_top(text):
        return top(parse(text))

    zero = list(map(read_top, certificate["generators"]))
    assert [g.numerator for g in zero] == [field.primitive(top(form).numerator) for form in constraints]
    claims = [read_top(text) for text in certificate["claims"]]
    differences = zip(value(lhs), value(rhs), strict=True)
    assert [claim.numerator for claim in claims] == [field.primitive((a - b).numerator) for a, b in differences]
    units = [RationalFunction(field, polynomial, ()) for polynomial in field.factors] + list(map(top, nonzero))
    moved = certificate.get("translations", [])
    assert all(
        is_translated(field, polynomial, along["along"]) for polynomial in claims + zero + units for along in moved
    )
    origin = field.variables | {sympy.Symbol(along["zero"]): field.lift(Fraction(0)) for along in moved}

    def at_origin(polynomial):
        return evaluate(field.expression(polynomial.numerator), origin, field.lift)[0]

    def combined(texts):
        terms = [read_top(text) * at_origin(g) for text, g in zip(texts, zero, strict=True)]
        return sum(terms, field.lift(Fraction(0)))

    def is_product_of_units(polynomial):
        known = [factor for unit in units for factor, _ in field.irreducible(at_origin(unit).numerator)[1]]
        factors = field.irreducible(polynomial.numerator)[1] if polynomial.numerator else [(None, 1)]
        return all(factor in known for factor, _ in factors)

    for step in certificate.get("steps", []):
        squares = [(Fraction(weight), read_top(root)) for weight, root in step.get("squares", [])]
        total = sum((weight * root * root for weight, root in squares), field.lift(Fraction(0)))
        assert all(weight > 0 for weight, _ in squares)
        if "product" in step:
            unit, product = read_top(step["not zero"]), read_top(step["product"])
            assert is_product_of_units(product)
            assert (product - combined(step["cofactors"]) - read_top(step["factor"]) * unit).is_zero
            units.append(unit)
        elif "not zero" in step:
            unit = read_top(step["not zero"])
            assert (unit - total).is_zero
            assert any(root.numerator.is_ground and root.numerator for _, root in squares)
            units.append(unit)
        else:
            multiplier = read_top(step["multiplier"])
            assert is_product_of_units(multiplier)
            assert (multiplier * at_origin(total) - combined(step["cofactors"])).is_zero
            assert all(is_translated(field, root, along["along"]) for _, root in squares for along in moved)
            zero += [root for _, root in squares]
    multiplier = value(parse(certificate["multiplier"]))[0]
    assert is_product_of_units(multiplier)
    return all(
        (at_origin(claim) ** part["exponent"] * multiplier ** part["power"] - combined(part["cofactors"])).is_zero
        for claim, part in zip(claims, certificate["entries"], strict=True)
    )


def is_translated(field, polynomial, along):
    """Whether a polynomial does not change when all variables move along a direction by one, and by two."""
    form = field.expression(polynomial.numerator)
    for far in (1, 2):
        steps = {sympy.Symbol(name): far * Fraction(value) for name, value in along.items()}
        place = {symbol: value + steps.get(symbol, Fraction(0)) for symbol, value in field.variables.items()}
        if not (evaluate(form, place, field.lift)[0] - polynomial).is_zero:
            return False
    return True


NUMBERS = ("witness", "extension", "translations")


def polynomials_in(node, key=""):
    """Yield the texts of a certificate that are no numbers; the weight of a square is one."""
    if isinstance(node, str):
        yield node
    elif key == "squares":
        yield from (root for _, root in node)
    elif isinstance(node, dict):
        for name, value in node.items():
            yield from () if name in NUMBERS else polynomials_in(value, name)
    elif isinstance(node, list | tuple):
        for value in node:
            yield from polynomials_in(value)


@pytest.mark.parametrize(("file", "item"), ITEMS, ids=[f"{file}: {item['name']}" for file, item in ITEMS])
def test_every_verdict_is_the_declared_one_and_rests_on_evidence(file, item):
    arguments = {"constraints": item.get("constraints", ()), "nonzero": item.get("nonzero", ())}
    proof = prove(item["lhs"], item["rhs"], **arguments)
    assert proof.verdict == item["expected"]
    if proof.verdict == "refuted":
        assert refutes(item, proof.counterexample)
    if proof.verdict == "open":
        assert proof.certificate["reason"]
    if proof.verdict == "proved":
        assert not [text for text in polynomials_in(proof.certificate) if "/" in text]
    size = len(json.dumps(proof.certificate))
    if proof.verdict == "proved" and "multiplier" in proof.certificate and size < REPLAYED:
        assert multiplies_out(item, proof.certificate)


def test_the_corpus_is_large_and_says_where_it_comes_from():
    everything = [item for path in CORPUS.glob("*.json") for item in json.loads(path.read_text(encoding="utf-8"))]
    assert len(everything) >= 400
    assert all(item["source"] and item["licence"] for item in everything)
    readme = (CORPUS / "README.md").read_text(encoding="utf-8")
    assert all(item["source"].split(",")[0] in readme for item in everything)
    names = [item["name"] for item in everything]
    assert len(set(names)) == len(names)


# -- the command ------------------------------------------------------------------------------------------------------


def run(*arguments):
    return CliRunner().invoke(main, ["check", *map(str, arguments)])


@pytest.fixture
def file(tmp_path):
    def write(content, name="mine.json"):
        path = tmp_path / name
        path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
        return path

    return write


SQUARE = {"lhs": "(a + b)^2", "rhs": "a^2 + 2*a*b + b^2"}
DREAM = {"name": "dream", "lhs": "(a + b)^2", "rhs": "a^2 + b^2"}
SLOW = {"name": "slow", "lhs": "(a+b+c+d+1/e)^90", "rhs": "(1/e+b+c+d+a)^90"}


def test_decided_as_declared_exits_with_0(file):
    path = file([SQUARE | {"expected": "proved"}, DREAM | {"expected": "refuted"}, DREAM])
    result = run(path)
    assert result.exit_code == 0, result.output
    assert "mine[0]" in result.output
    assert "3 identities: 1 proved, 2 refuted; all verdicts are as declared" in result.output


def test_json_is_one_object(file):
    result = run(file([SQUARE, {"lhs": "x", "rhs": "1", "constraints": ["x^2 = 2"]}]), "--format", "json")
    record = json.loads(result.stdout)
    assert result.exit_code == 0
    assert record["summary"] == {"proved": 1, "refuted": 1}
    assert [item["method"] for item in record["identities"]] == ["normal form", "counterexample"]
    assert record["identities"][1]["counterexample"] == {"x": "r"}
    assert record["identities"][1]["certificate"]["extension"] == {
        "coefficients": ["1", "0", "-2"],
        "root between": ["-2", "-1"],
    }


@pytest.mark.parametrize("item", [DREAM | {"expected": "proved"}, SQUARE | {"constraints": ["1"]}])
def test_what_is_not_as_declared_or_not_decided_exits_with_1(file, item):
    assert run(file([item])).exit_code == 1


def test_an_identity_that_takes_too_long_is_open_and_says_so(file):
    start = time.monotonic()
    result = run(file([SLOW, DREAM]), "--seconds", "1", "--format", "json")
    slow, dream = json.loads(result.stdout)["identities"]
    assert (slow["verdict"], slow["reason"]) == ("open", "no decision within 1 s")
    assert dream["verdict"] == "refuted"
    assert result.exit_code == 1
    assert time.monotonic() - start < 60


def test_what_fails_is_an_error_and_no_verdict(file):
    result = run(file([{"lhs": "1/((x+1)^2-x^2-2*x-1)", "rhs": "1"}]), "--format", "json")
    (item,) = json.loads(result.stdout)["identities"]
    assert item["verdict"] == "error"
    assert "UndefinedError" in item["reason"]
    assert result.exit_code == 1


def test_an_engine_that_fails_is_an_error_for_each_question():
    questions = [Question("x", "x"), Question("x", "y")]
    assert [outcome.verdict for outcome in outcomes(questions, seconds=60)] == ["proved", "refuted"]
    assert [outcome.verdict for outcome in outcomes(questions, seconds=60, engine="nosuch")] == ["error", "error"]


def test_a_worker_that_dies_is_an_error_and_the_next_question_is_decided():
    found = outcomes([Question("x", "x"), Question("x", "y"), Question("y", "y")], seconds=60)
    first = next(found)
    (process,) = multiprocessing.active_children()
    process.kill()
    process.join()
    assert first.verdict == "proved"
    rest = list(found)
    assert all(outcome.verdict in ("error", "refuted", "proved") for outcome in rest)
    assert (rest[0].verdict, rest[1].verdict) in {("error", "proved"), ("refuted", "error"), ("refuted", "proved")}


MALFORMED = {
    "no JSON": ("{", "expected JSON"),
    "no list": ({"lhs": "x"}, "expected a list of objects, got an object"),
    "no object": ([3], "item 0: expected an object, got a number"),
    "no side": ([SQUARE, {"lhs": "x"}], "item 1 (mine[1]), key 'rhs': expected text, got nothing"),
    "no text": ([{"lhs": 1, "rhs": "1"}], "key 'lhs': expected text, got a number"),
    "no grammar": ([{"name": "n", "lhs": "x", "rhs": "2x"}], "item 0 (n), key 'rhs', position 1: expected an operator"),
    "constraint": ([SQUARE | {"constraints": ["a", "b +"]}], "key 'constraints', entry 1, position 3: expected"),
    "one constraint": ([SQUARE | {"constraints": "a"}], "key 'constraints': expected a list of text, got text"),
    "misspelt": ([SQUARE | {"constraint": ["a"]}], "expected the key 'constraints', got 'constraint'"),
    "expected": ([SQUARE | {"expected": "true"}], "key 'expected': expected one of proved, refuted, open, got 'true'"),
    "variables": ([SQUARE | {"variables": ["a"]}], "key 'lhs', position 5: expected one of the variables a, got 'b'"),
    "shapes": ([{"lhs": "[[x, y]]", "rhs": "x"}], "key 'rhs': expected the shape of 'lhs', got (1, 2) and ()"),
    "witness": ([SQUARE | {"witness": {"a": "0.x"}}], "key 'witness', entry 'a', position 2: expected an operator"),
    "deep": ("[" * 100_000, "expected JSON"),
}


@pytest.mark.parametrize(("content", "message"), MALFORMED.values(), ids=MALFORMED)
def test_a_malformed_file_exits_with_2_and_names_file_item_and_key(file, content, message):
    path = file(content)
    result = run(path)
    assert result.exit_code == 2
    assert message in result.output
    assert str(path) in result.output


def test_a_missing_file_and_a_mixture_are_wrong_usage(file):
    assert run("missing.json").exit_code == 2
    assert run(file([SQUARE]), "fundamentals1996").exit_code == 2


def test_the_verdicts_do_not_depend_on_workers_or_the_hash_seed(file):
    path = file([SQUARE, DREAM, {"lhs": "x", "rhs": "y", "constraints": ["x^2 + y^2 = 3"]}])
    records = []
    for seed, jobs in (("1", "1"), ("2", "2")):
        command = [sys.executable, "-m", "algebroproj_sym", "check", str(path), "--format", "json", "--jobs", jobs]
        environment = os.environ | {"PYTHONHASHSEED": seed}
        output = subprocess.run(command, capture_output=True, check=True, env=environment).stdout
        records.append([item | {"seconds": 0} for item in json.loads(output)["identities"]])
    assert records[0] == records[1]
