"""Verdicts follow from what is proved and what is refuted, and the papers are judged as their derivations declare."""

import random
from dataclasses import replace
from fractions import Fraction

import pytest
import sympy
from cases import for_each

from algebroproj_sym import Section
from algebroproj_sym.declaring import VERDICTS, judge, select
from algebroproj_sym.expressions import TextForm, over, vector
from algebroproj_sym.proving import ENGINES

x, y = sympy.symbols("x y")
TRUE, WRONG, SQUARE = x**2 + 2 * x + 1, x**2 + 1, (x + 1) ** 2
CLAIMS = select()
SOME = [*{(claim.kind, claim.expected): claim for claim in CLAIMS}.values(), *CLAIMS[::24]]
PROVED_IDENTITIES = [
    claim
    for claim in CLAIMS
    if claim.kind == "identity" and claim.expected == "proved" and claim.section.startswith("1.")
]


def square(printed, engine="flint", **options):
    section = Section("demo", "1", "Squares")
    return judge(section.identity("1.1", "square", printed=printed, derived=SQUARE, **options), engine)


def without_rational_zero(printed, **options):
    """A claim whose print can be neither proved nor refuted: only complex numbers tell the sides apart."""
    section = Section("demo", "1", "Squares")
    return judge(section.vanishing("1.1", "no real zero", printed=printed, derived=x**2 + 1, **options))


@pytest.fixture(params=ENGINES)
def engine(request):
    return request.param


def test_what_holds_is_proved(engine):
    result = square(TRUE, engine)
    assert (result.verdict, result.as_declared, result.counterexample) == ("proved", True, None)


def test_what_fails_without_a_correction_is_false(engine):
    result = square(WRONG, engine, expect="false", instead="1.2")
    assert (result.verdict, result.as_declared) == ("false", True)
    assert result.counterexample[x] != 0


def test_what_fails_with_a_correction_that_holds_is_a_misprint(engine):
    result = square(WRONG, engine, expect="misprint", corrected=TRUE)
    assert (result.verdict, result.as_declared) == ("misprint", True)


def test_a_refuted_form_is_an_error_where_the_paper_shows_that_it_is_no_slip(engine):
    result = square(WRONG, engine, expect="error", corrected=TRUE)
    assert (result.verdict, result.as_declared) == ("error", True)
    assert result.certificate["refutation"]["method"] == "counterexample"
    assert square(TRUE, engine, expect="error", corrected=TRUE).verdict == "proved"
    assert square(WRONG, engine, expect="error", corrected=WRONG).verdict == "open"


def test_the_evidence_of_a_misprint_is_a_counterexample_and_the_proof_of_the_correction(engine):
    result = square(WRONG, engine, expect="misprint", corrected=TRUE)
    at = {x: sympy.Rational(result.counterexample[x])}
    assert WRONG.xreplace(at) != SQUARE.xreplace(at)
    assert result.certificate["method"] == "normal form"
    assert result.certificate["refutation"]["left"] == [str(WRONG.xreplace(at))]
    assert result.certificate["refutation"]["right"] == [str(SQUARE.xreplace(at))]


def test_a_wrong_correction_leaves_the_claim_open(engine):
    result = square(WRONG, engine, expect="misprint", corrected=x**2 - 2 * x + 1)
    assert (result.verdict, result.as_declared) == ("open", False)


def test_a_true_statement_is_no_misprint_whatever_is_declared(engine):
    result = square(TRUE, engine, expect="misprint", corrected=SQUARE)
    assert (result.verdict, result.as_declared) == ("proved", False)


def test_a_true_statement_is_not_false_whatever_is_declared(engine):
    result = square(TRUE, engine, expect="false", instead="1.2")
    assert (result.verdict, result.as_declared) == ("proved", False)


def test_a_false_statement_is_not_proved_whatever_is_declared(engine):
    result = square(WRONG, engine)
    assert (result.verdict, result.as_declared) == ("false", False)


def test_an_illegible_formula_needs_a_reconstruction_that_holds(engine):
    good = square(None, engine, expect="illegible", corrected=TRUE)
    assert (good.verdict, good.as_declared) == ("illegible", True)
    assert good.certificate["method"] == "normal form"
    bad = square(None, engine, expect="illegible", corrected=WRONG)
    assert (bad.verdict, bad.as_declared) == ("open", False)


def test_a_notation_is_a_definition(engine):
    claim = Section("demo", "1", "Squares").definition("1.1", "quotient", printed=over(x, y))
    result = judge(claim, engine)
    assert (result.verdict, result.as_declared) == ("definition", True)


def test_what_is_neither_proved_nor_refuted_is_open():
    result = without_rational_zero(())
    assert (result.verdict, result.as_declared) == ("open", False)


def test_a_misprint_needs_the_refutation_of_the_print_and_not_only_the_proof_of_the_correction():
    result = without_rational_zero((), expect="misprint", corrected=(x**2 + 1,))
    assert (result.verdict, result.as_declared) == ("open", False)
    assert without_rational_zero((x,), expect="misprint", corrected=(x**2 + 1,)).verdict == "misprint"


def test_no_correction_makes_an_open_claim_false():
    assert without_rational_zero((), expect="false", instead="1.2").verdict == "open"


def test_a_correction_is_read_with_the_same_abbreviations():
    claim = Section("demo", "1", "Squares").identity(
        "1.1", "square", printed=y + 1, corrected=y, where={y: TRUE}, derived=SQUARE, expect="misprint"
    )
    assert judge(claim).verdict == "misprint"


def test_a_judgement_keeps_claim_engine_and_hypotheses(engine):
    claim = Section("demo", "1", "Squares").identity("1.1", "quotient", printed=x, derived=over(x * y, y))
    result = judge(claim, engine)
    assert (result.claim, result.engine, result.hypotheses) == (claim, engine, (y,))
    assert result.seconds >= 0


def test_judging_twice_gives_the_same_evidence(engine):
    first, second = (square(WRONG, engine, expect="misprint", corrected=TRUE) for _ in range(2))
    assert replace(first, seconds=0.0) == replace(second, seconds=0.0)


@for_each("claim", SOME)
def test_claims_of_the_papers_are_judged_as_declared(claim):
    """A build, which fails otherwise, judges all of them."""
    result = judge(claim)
    assert result.verdict == claim.expected
    assert result.as_declared
    assert result.certificate


@for_each("claim", [claim for claim in CLAIMS if claim.section == "1.3"])
def test_the_other_engine_judges_section_1_3_alike(claim):
    assert judge(claim, "sympy").as_declared


def test_the_papers_hold_every_verdict_but_open():
    assert {claim.expected for claim in CLAIMS} == {*VERDICTS} - {"open"}


def test_there_are_identities_to_miswrite():
    assert {claim.section for claim in PROVED_IDENTITIES} == {f"1.{k}" for k in range(1, 7)}
    assert len(PROVED_IDENTITIES) > 100


@for_each("claim", PROVED_IDENTITIES[::3])
def test_a_wrong_transcription_is_not_proved(claim):
    if isinstance(claim.printed, TextForm):
        wrong = "1" if claim.printed.text == "0" else f"2*({claim.printed})"
        printed = replace(claim.printed, text=wrong)
    elif isinstance(claim.printed, sympy.MatrixBase):
        entries = list(claim.printed)
        place = random.Random(claim.number).randrange(len(entries))
        entries[place] = entries[place] + 1
        printed = sympy.ImmutableDenseMatrix(*claim.printed.shape, entries)
    else:
        printed = claim.printed + 1
    result = judge(replace(claim, printed=printed))
    assert result.verdict == "false"
    assert isinstance(result.counterexample, dict)
    if not claim.letters:
        assert all(isinstance(value, Fraction) for value in result.counterexample.values())


@for_each("claim", PROVED_IDENTITIES[::3])
def test_a_wrong_sign_of_a_whole_print_is_not_proved_unless_it_prints_zero(claim):
    if isinstance(claim.printed, TextForm):
        prints_zero, printed = claim.printed.text == "0", replace(claim.printed, text=f"-({claim.printed})")
    else:
        prints_zero, printed = claim.printed == 0 * claim.printed, -claim.printed
    assert judge(replace(claim, printed=printed)).verdict == ("proved" if prints_zero else "false")


def test_no_derived_matrix_is_the_printed_one():
    for claim in CLAIMS:
        if isinstance(claim.derived, sympy.MatrixBase) and claim.kind != "reference":
            assert claim.derived is not claim.printed, claim.number
            assert claim.derived is not claim.corrected, claim.number


def test_vectors_are_judged_entry_by_entry():
    section = Section("demo", "1", "Squares")
    claim = section.identity("1.1", "squares", printed=vector(x**2, WRONG), derived=vector(x * x, SQUARE))
    assert judge(claim).verdict == "false"
