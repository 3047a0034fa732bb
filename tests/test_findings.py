"""Findings: the grave ones first, each once, with what follows and the numbers that are proved."""

import pytest
import sympy
from sympy.abc import x, y

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError, grade_of, judge
from algebroproj_sym.reporting.findings import findings, gathered, values_at_counterexample


@pytest.fixture
def section():
    section = Section("demo", "1", "Squares")
    wrong = {"printed": x + 1, "derived": x - 1, "corrected": x - 1}
    section.identity("1.1", "a sign", **wrong, expect="misprint")
    section.identity("1.2", "the sign again", **wrong, expect="error", same_as="1.1", follows="It is {1.4}.")
    section.identity("1.3", "a step", **wrong, expect="error", follows="The area is {1.4} and not {1.5}.")
    section.numeric("1.4", "a number", printed="0.3", derived=x * 0 + 3 / (x * 0 + 10))
    section.numeric(
        "1.5", "a digit", printed="0.7", derived=x * 0 + 3 / (x * 0 + 10), corrected="0.3", expect="misprint"
    )
    section.identity("1.6", "true", printed=x + y, derived=y + x)
    section.identity("1.7", "untrue", printed=x, derived=y, expect="false", instead="1.6")
    return section


def test_the_grave_findings_come_first_and_each_once(section):
    found = gathered([judge(claim) for claim in section.claims])
    assert [(finding.claim.number, finding.grade, len(finding.others)) for finding in found] == [
        ("1.1", "results", 1),
        ("1.3", "results", 0),
        ("1.5", "slip", 0),
        ("1.7", "formula", 0),
    ]
    text = findings([judge(claim) for claim in section.claims])
    places = [text.index(f"({number})") for number in ("1.1", "1.3", "1.7", "1.5")]
    assert places == sorted(places)
    assert "The same finding: (1.2)." in text
    assert "5 of 7 claims" in text


def test_numbers_in_what_follows_are_those_that_are_right(section):
    (found,) = [f for f in gathered([judge(claim) for claim in section.claims]) if f.claim.number == "1.3"]
    assert found.follows == "The area is 0.3 and not 0.3."


def test_a_number_that_was_not_judged_is_named(section):
    (found,) = gathered([judge(claim) for claim in section.claims if claim.number == "1.3"])
    assert found.follows == "The area is (1.4) and not (1.5)."


def test_without_words_the_values_at_the_counterexample_follow(section):
    (found,) = [f for f in gathered([judge(claim) for claim in section.claims]) if f.claim.number == "1.1"]
    value = found.first.counterexample[x]
    assert found.follows == f"At x = {value} it is {value - 1}. The printed form gives {value + 1}."


def test_values_at_a_counterexample_of_many_coordinates_are_not_told():
    section = Section("demo", "1", "Sums")
    few, many = sum(sympy.symbols("a:2")), sum(sympy.symbols("a:9"))
    claims = [section.identity(f"1.{n}", "", printed=s + 1, derived=s) for n, s in enumerate((few, many), start=1)]
    told = [values_at_counterexample(judge(claim)) for claim in claims]
    assert told[0].startswith("At a0 = ")
    assert told[1] == ""


def test_a_declared_grade_counts_more_than_the_rule():
    section = Section("demo", "1", "Squares")
    claim = section.identity("1.1", "", printed=x, derived=y, expect="false", instead="1.1", grade="results")
    assert grade_of(claim) == "results"


@pytest.mark.parametrize("options", [{"grade": "grave"}, {"follows": "It is so."}, {"same_as": "1.2"}])
def test_what_makes_no_finding_is_refused(options):
    section = Section("demo", "1", "Squares")
    expected = {"expect": "false", "instead": "1.1"} if options.get("grade") else {}
    with pytest.raises(DeclarationError, match=next(iter(options))):
        section.identity("1.1", "", printed=x, derived=x, **expected, **options)


def test_matrices_at_a_counterexample_are_not_told():
    section = Section("demo", "1", "Squares")
    a, b = sympy.MatrixSymbol("a", 2, 1), sympy.MatrixSymbol("b", 2, 1)
    wrong = section.identity("1.1", "a sign", printed=a - b, derived=a + b, corrected=a + b, expect="misprint")
    text = findings([judge(wrong)])
    assert "printed -b + a, corrected a + b`" in text
    assert "Matrix" not in text
