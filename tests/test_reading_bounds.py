r"""Documents that take long: what is put in is bounded, and an equation over a bound is left open with a reason."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def of_functions(first: str, step: str, count: int, *, last: str) -> str:
    steps = " ".join(
        rf"\[ f_{{{place}}}(x) = {step}. \]".replace("F", f"f_{{{place - 1}}}") for place in range(1, count)
    )
    return rf"\[ f_0(x) = {first}. \] {steps} " + last.replace("F", f"f_{{{count - 1}}}")


LAST = r"\[ y = F(b). \] Hence \[ y = a b. \]"
HALVES = " + ".join(rf"F(x/{part})" for part in range(2, 7))


@pytest.mark.parametrize(
    ("latex", "reason"),
    [
        (of_functions("a x", HALVES, 8, last=LAST), "500 parts of values of functions"),
        (of_functions("x^2 + a", "F(F(x))", 12, last=LAST), "expected"),
        (of_functions("x^2 + a", "F(x) F(x) + x", 12, last=LAST), "expected"),
        (
            of_functions(r"a x, 0 \le x \le 1", "F(x/2) + F(x/3) + F(x/4)", 6, last=r"Hence \[ y - F(1/3) = 0. \]"),
            "200 values of functions that are defined for a range",
        ),
    ],
    ids=["sums", "compositions", "products", "ranges"],
)
def test_what_functions_of_functions_come_to_is_bounded(latex, reason, monkeypatch):
    for module in ("defining.vocabulary", "asking.sampling"):
        monkeypatch.setattr(f"algebroproj_sym.reading.{module}.MOST_PARTS", 500)
    last = read_document(document_of(latex), seconds=2)[-1]
    assert last.verdict == "not decided"
    assert reason in last.links[-1].reason


def test_a_range_is_looked_for_however_deep_functions_are_nested():
    latex = of_functions(r"a x, 0 \le x \le 1", "F(x)", 9, last=r"Hence \[ F(2) = 2 a. \]")
    assert read_document(document_of(latex), seconds=2)[-1].verdict == "not decided"


def test_a_sum_of_high_powers_of_sums_is_not_multiplied_out():
    term = "x_i"
    for _ in range(6):
        term = rf"\left({term} + \sum_{{j=1}}^n a_j\right)^2"
    latex = rf"\[ y = \sum_{{i=1}}^n {term}. \] Hence \[ y = \sum_{{i=1}}^n {term}. \]"
    assert read_document(document_of(latex), seconds=2)[-1].verdict == "follows"


@pytest.mark.parametrize(
    ("latex", "contradicts"),
    [(r"7 \pi/3 = \pi/3", False), (r"\pi/3 + \pi = \pi/3 - \pi", False), (r"\pi/3 = -\pi/3", True)],
)
def test_angles_may_differ_by_full_turns(latex, contradicts):
    (found,) = read_document(document_of(rf"Hence \[ u = {latex}. \]"), seconds=2)
    assert (found.verdict == "contradicts") is contradicts
    assert (found.links[-1].reason == "its sides may be angles that differ by full turns") is not contradicts
