"""References within a paper: right, or a misprint whose correction is known."""

import json

import pytest
import sympy
from cases import for_each
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError, judge, statement_text
from algebroproj_sym.proving import ENGINES
from algebroproj_sym.reporting.ledger import claim_record, ledger


def declared(printed, meant, **options):
    return Section("demo", "1", "Demonstration").reference("1/ref", "a title", printed=printed, meant=meant, **options)


def row(reference):
    return sympy.Matrix([[int(part) for part in reference.split(".")]])


references = st.lists(st.integers(0, 30), min_size=1, max_size=4).map(lambda parts: ".".join(map(str, parts)))


@given(st.sampled_from(ENGINES), references)
def test_a_reference_to_what_is_meant_is_proved(engine, number):
    judgement = judge(declared(number, number), engine)
    assert judgement.verdict == "proved"
    assert judgement.as_declared
    assert judgement.claim.corrected is None
    assert judgement.counterexample is None


@given(st.sampled_from(ENGINES), references, references)
def test_a_reference_to_something_else_is_a_misprint_with_its_correction(engine, printed, meant):
    if printed == meant:
        return
    judgement = judge(declared(printed, meant), engine)
    assert judgement.verdict == "misprint"
    assert judgement.as_declared
    assert sympy.Matrix(judgement.claim.corrected) == row(meant)


def test_the_misprint_of_the_contract():
    judgement = judge(declared("2.2.3", "2.3.3"))
    assert (judgement.claim.kind, judgement.verdict, judgement.claim.expected) == ("reference", "misprint", "misprint")


@pytest.mark.parametrize(
    ("printed", "meant"),
    [("2.3", "2.3.3"), ("2.3.3", "2.3"), ("1.1", "1.10"), ("1.10", "1.1"), ("12", "1.2"), ("1.2", "2.1"), ("0", "0.0")],
)
def test_numbers_are_compared_one_by_one_and_none_is_left_out(printed, meant):
    assert judge(declared(printed, meant)).verdict == "misprint"


def test_who_expects_a_wrong_reference_to_be_right_is_told():
    judgement = judge(declared("2.2.3", "2.3.3", expect="proved"))
    assert judgement.verdict == "misprint"
    assert not judgement.as_declared


def test_a_right_reference_is_no_misprint():
    with pytest.raises(DeclarationError, match="corrected: expected a form for a claim declared misprint"):
        declared("2.2.3", "2.2.3", expect="misprint")


@for_each(
    "malformed",
    ["", ".", "2.", ".2", "2..3", "2.3.", " 2.3", "2.3 ", "2.3\n", "2,3", "2.a", "2.3a", "(2.3)", "-2.3", "2.3#4", "x"],
)
def test_malformed_text_is_refused_on_either_side(malformed):
    with pytest.raises(DeclarationError, match=r"^claim demo:1/ref, printed: expected the text of a reference such as"):
        declared(malformed, "2.3")
    with pytest.raises(DeclarationError, match=r"^claim demo:1/ref, meant: expected the text of a reference such as"):
        declared("2.3", malformed)


@pytest.mark.parametrize("value", [2, 2.3, None, sympy.Rational(23, 10), ("2", "3"), ["2.3"], b"2.3"])
def test_only_text_is_a_reference(value):
    with pytest.raises(DeclarationError, match="expected the text of a reference"):
        declared(value, "2.3")
    with pytest.raises(DeclarationError, match="expected the text of a reference"):
        declared("2.3", value)


def test_the_section_keeps_the_claim_with_its_title_and_note():
    section = Section("demo", "1", "Demonstration")
    claim = section.reference("1/ref", "where it stands", printed="1.2", meant="1.3", note="There is no 1.2.")
    assert section.claims == [claim]
    assert (claim.title, claim.note) == ("where it stands", "There is no 1.2.")
    with pytest.raises(DeclarationError, match="expected each number once, got this one twice"):
        section.reference("1/ref", "again", printed="1.2", meant="1.2")


@given(references, references)
def test_the_ledger_has_text_that_sympy_parses_back(printed, meant):
    record = json.loads(json.dumps(claim_record(judge(declared(printed, meant)))))
    assert sympy.sympify(record["printed"]) == row(printed)
    assert sympy.sympify(record["derived"]) == row(meant)
    assert (record["corrected"] is None) == (printed == meant)
    if printed != meant:
        assert sympy.sympify(record["corrected"]) == row(meant)


def test_the_text_of_a_reference_is_that_of_its_numbers():
    claim = declared("2.2.3", "2.3.3")
    assert [sympy.sympify(statement_text(form)) for form in (claim.printed, claim.corrected)] == [
        row("2.2.3"),
        row("2.3.3"),
    ]


def test_the_summary_counts_references_by_their_verdicts():
    judgements = [judge(declared(printed, "1.2")) for printed in ("1.2", "1.3", "1.4")]
    assert ledger(judgements)["summary"] == {"proved": 1, "misprint": 2}
