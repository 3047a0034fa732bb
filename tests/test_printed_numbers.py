"""No printed number passes but the one that is printed: each of its digits is changed to each other one."""

import re
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym import Section
from algebroproj_sym.declaring import judge, select
from algebroproj_sym.declaring.kinds import KINDS
from algebroproj_sym.expressions import ROUNDINGS, rounded
from algebroproj_sym.mutating.explanations import explanations
from algebroproj_sym.mutating.forms import changed_digits
from algebroproj_sym.replaying import replay_claim
from algebroproj_sym.reporting.ledger import ledger


@pytest.fixture(scope="module")
def proved():
    cells = [claim for claim in select() if claim.kind == "numeric"]
    return [claim for claim in cells if judge(claim).verdict == "proved"]


def test_no_change_of_a_digit_passes_that_is_not_listed_with_its_reason(proved):
    tried, passed = 0, set()
    for claim in proved:
        for _, changed in changed_digits(f"{claim.printed:f}"):
            tried += 1
            if KINDS["numeric"].compare(claim, Decimal(changed), "flint").verdict != "refuted":
                passed.add((f"{claim.paper}:{claim.number}", changed))
    listed = {(entry.claim, entry.form) for entry in explanations()}
    assert passed <= listed
    assert tried > 50_000


@pytest.mark.parametrize(("cells", "decisive"), [(r"4/b#left\.R\d\d", 5), (r"4/b#.*\.right\.u2", 3)])
def test_what_is_cut_off_is_a_whole_table_and_would_not_hold_rounded(proved, cells, decisive):
    found = [claim for claim in proved if claim.paper == "fundamentals1996" and re.fullmatch(cells, claim.number)]
    assert {claim.rounding for claim in found} == {"cut"}
    rounded = [judge(replace(claim, rounding="nearest")).verdict for claim in found]
    assert rounded.count("false") == decisive


def test_nothing_else_is_cut_off(proved):
    assert sum(claim.rounding == "cut" for claim in proved) == 9 + 14


@given(
    st.fractions(-9, 9) | st.decimals(-9, 9, places=3).map(Fraction),
    st.decimals(-9, 9, places=2).map(lambda number: f"{number:f}"),
    st.sampled_from(ROUNDINGS),
)
def test_the_replay_accepts_what_is_rounded_and_nothing_else(exact, printed, rounding):
    derived = sympy.Rational(exact.numerator, exact.denominator)
    section = Section("demo", "1", "Demonstration")
    texts = {printed, f"{rounded(exact, 2, rounding):f}"}
    for place, text in enumerate(sorted(texts)):
        claim = section.numeric(f"1.{place}", "", printed=text, derived=derived, rounding=rounding)
        record = ledger([judge(claim)], timed=False)["claims"][0] | {"verdict": "proved", "expected": "proved"}
        holds = Decimal(text) == rounded(exact, 2, rounding)
        assert (replay_claim(record).status == "replayed") is holds
        forged = record | {"certificate": {"method": "exact rounding", "rounded": text}}
        assert (replay_claim(forged).status == "replayed") is holds
