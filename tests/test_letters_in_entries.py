"""Definitions and claims about ranks, zeros and structure take letters: shown so, and written out."""

import re

import pytest
import sympy
from cases import for_each
from sympy import Determinant, MatrixSymbol

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError, judge
from algebroproj_sym.expressions.letters import Dot, Norm, Skew
from algebroproj_sym.replaying import declaration_digest
from algebroproj_sym.replaying.ledger import replay_claim
from algebroproj_sym.reporting.explaining import explanation
from algebroproj_sym.reporting.ledger import claim_record
from algebroproj_sym.reporting.site.comparison import comparison
from algebroproj_sym.reporting.site.evidence import evidence
from algebroproj_sym.showing.display import markdown

R, A, B = (MatrixSymbol(name, 3, 3) for name in "RAB")
P, Q = MatrixSymbol("P", 2, 2), MatrixSymbol("Q", 2, 2)
t, n = MatrixSymbol("t", 3, 1), MatrixSymbol("n", 3, 1)
a, b, c = sympy.symbols("a b c")
OPPOSITE = sympy.Matrix([[0, -c, b], [c, 0, -a], [-b, a, 0]])


def verdict(kind, printed, derived, **options):
    section = Section("mine", "1", "Mine")
    claim = getattr(section, kind)("1.1", "a claim", printed=printed, derived=derived, expect="proved", **options)
    return judge(claim).verdict


@for_each(
    ("kind", "printed", "derived", "options", "expected"),
    [
        ("rank", 2, Skew(t) * R, {"kernel": [R.T * t], "properties": {R: "rotation"}}, "proved"),
        ("rank", 1, A, {"kernel": [], "properties": {A: "rank 2"}}, "false"),
        ("rank", 2, sympy.Identity(3) - n * n.T, {"kernel": [n], "properties": {n: "unit"}}, "proved"),
        ("structure", OPPOSITE, Skew(t), {}, "proved"),
        ("structure", OPPOSITE, A, {"properties": {A: "skew"}}, "proved"),
        ("structure", OPPOSITE, A, {"properties": {A: "symmetric"}}, "false"),
        ("structure", OPPOSITE, A - A.T, {}, "proved"),
        ("vanishing", (Determinant(P), Determinant(Q)), Determinant(P * Q), {}, "proved"),
        ("vanishing", (Determinant(P),), Determinant(P * Q), {}, "false"),
        ("vanishing", (Dot(t, n),), Determinant(sympy.Identity(3) - t * n.T) - 1, {}, "proved"),
    ],
)
def test_letters_are_written_out(kind, printed, derived, options, expected):
    found = verdict(kind, printed, derived, **options)
    assert (found == "proved") is (expected == "proved")


@pytest.mark.parametrize(
    ("derived", "properties", "message"),
    [
        (R * t, {R: "orthogonal"}, "R: expected one with free coordinates, .* got orthogonal"),
        (P, {P: "positive definite"}, "P: expected one with free coordinates, .* got positive definite"),
        (P, {P: "idempotent"}, "P: expected one with free coordinates, .* got idempotent"),
        (Norm(t) * t, {}, "norm"),
        (P, {A: "skew"}, r"expected letters that occur \(P\), got A"),
    ],
)
def test_what_has_no_coordinates_is_refused(derived, properties, message):
    with pytest.raises(DeclarationError, match=message):
        verdict("rank", 1, derived, properties=properties)


def record_of(kind, printed, derived, **options):
    section = Section("mine", "1", "Mine")
    forms = {"printed": printed} | ({} if derived is None else {"derived": derived})
    claim = getattr(section, kind)("1.1", "a claim", **forms, **options)
    return claim_record(judge(claim), timed=False)


ESSENTIAL = {"kernel": [R.T * t], "properties": {R: "rotation"}}


def test_letters_are_shown_and_entries_on_demand():
    section = Section("mine", "1", "Mine")
    judgement = judge(section.rank("1.1", "rank", printed=2, derived=Skew(t) * R, **ESSENTIAL))
    short, full = (explanation(judgement, "mine", (), full=full).plain for full in (False, True))
    assert "derived     skew(t)*R\n" in short
    assert "R is a 3x3 matrix (rotation)" in short
    assert "To see the entries, add --full." in short
    assert "R_q0" not in short + markdown(judgement)
    assert "entries of R: rotation(block([R_q0], [R_q1], [R_q2], [R_q3]))" in full
    assert "            = [" in full


@pytest.mark.extra("report")
def test_the_site_shows_letters_and_their_entries_beneath():
    section = Section("mine", "1", "Mine")
    judgement = judge(section.rank("1.1", "rank", printed=2, derived=Skew(t) * R, **ESSENTIAL))
    (_, (_, shown)), _ = comparison(judgement)
    assert "R_" not in shown
    assert [table.caption for table in evidence(judgement)[1]][:2] == ["Entries of the letters", "Written out"]


def test_factors_are_shown_in_letters():
    section = Section("mine", "1", "Mine")
    factors = {"printed": (Determinant(Q),), "nonzero": [Determinant(P)]}
    judgement = judge(section.vanishing("1.1", "factors", derived=Determinant(P * Q), **factors))
    assert judgement.verdict == "proved"
    assert r"\det\left(P Q\right) = 0 \iff \left(\det\left(Q\right)\right) = 0" in markdown(judgement)
    assert "P_" not in explanation(judgement, "mine", ()).plain


RANK = ("rank", 2, Skew(t) * R, ESSENTIAL)
FACTORS = ("vanishing", (Determinant(Q),), Determinant(P * Q), {"nonzero": [Determinant(P)]})
PATTERN = ("structure", OPPOSITE, A, {"properties": {A: "skew"}})
NOTATION = ("definition", R.T * t, None, {})


@pytest.mark.parametrize(("kind", "printed", "derived", "options"), [RANK, FACTORS, PATTERN, NOTATION])
def test_the_replay_writes_the_letters_out(kind, printed, derived, options):
    assert replay_claim(record_of(kind, printed, derived, **options)).status == "replayed"


@for_each(
    ("declared", "forged", "reason"),
    [
        (RANK, {"derived": "R*skew(t)"}, "the entries are not those"),
        (RANK, {"derived": "skew(t)"}, "a letter does not occur"),
        (RANK, {"derived": "skew(t)*R*t"}, "another shape"),
        (RANK, {"derived": "skew(t)*R + 0*R_q0*R"}, "two numbers of one name"),
        (RANK, {"letters": {"R": "3x3", "t": "3x1"}}, "R_11|does not occur in the statement"),
        (RANK, {"letters": {"R": "3x3 orthogonal", "t": "3x1"}}, "no free coordinates"),
        (RANK, {"letters": {"R": "3x3 rotation", "t": "3x1 unit"}}, "does not occur in the statement"),
        (RANK, {"printed": "2"}, "replayed"),
        (RANK, {"printed": "3"}, "the entries are not those"),
        (FACTORS, {"nonzero": []}, "another number of forms"),
        (FACTORS, {"nonzero": ["det(Q)"]}, "the entries are not those"),
        (FACTORS, {"printed": ["det(Q)", "det(P)"]}, "another number of forms"),
        (FACTORS, {"printed": ["det(P)"]}, "the entries are not those"),
        (PATTERN, {"letters": {"A": "3x3 symmetric"}}, "the entries are not those"),
        (PATTERN, {"letters": {"A": "3x3 positive definite"}}, "no free coordinates"),
        (PATTERN, {"letters": {"A": "3x3 idempotent"}}, "no free coordinates"),
        (PATTERN, {"letters": {}}, "nothing is stated"),
        (PATTERN, {"kernel": ["A"]}, "expected the entries"),
        (NOTATION, {"printed": "R*t"}, "the entries are not those"),
        (NOTATION, {"letters": {"R": "3x3 symmetric", "t": "3x1"}}, "the entries are not those|does not occur"),
    ],
)
def test_letters_that_are_not_those_of_the_entries_are_rejected(declared, forged, reason):
    kind, printed, derived, options = declared
    record = record_of(kind, printed, derived, **options)
    record["setting"] = {**record["setting"], "stated": {**record["setting"]["stated"], **forged}}
    found = replay_claim({**record, "declaration": declaration_digest(record)})
    assert re.search(reason, found.reason or found.status)


@pytest.mark.parametrize(
    ("printed", "derived"),
    [((Dot(t, n),), sympy.Symbol("t_1") * Dot(t, n)), ((sympy.Symbol("t_1"),), Dot(t, n))],
)
def test_a_number_with_the_name_of_an_entry_is_refused(printed, derived):
    with pytest.raises(DeclarationError, match="expected other names than those of entries of letters, got t_1"):
        verdict("vanishing", printed, derived)
