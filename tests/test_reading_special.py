"""Values and products that are special: a letter that is its own square, and factors that anticommute."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def last_of(latex):
    return read_document(document_of(latex, latex=True), seconds=5)[-1]


@pytest.mark.parametrize(
    ("words", "given", "claim"),
    [
        ("Let the pieces be so.", "p := y^2", "p = y"),
        ("", "q := w^3", "q = w"),
        ("", "J := w^2 I", "J = w I"),
        ("", r"J := \frac{w^2}{n}", r"J = \frac{w}{n}"),
        (r"Let $P \in \mathbb{R}^{3\times3}$ be so.", "Q := P^2", "Q = P"),
        ("", "s := m^2 + a", "s = m + a"),
        ("", "c := a b", "c = -b a"),
        ("", "c := a b + d", "c = d - b a"),
        ("", r"\omega := 2 \alpha\beta", r"\omega = -2 \beta\alpha"),
        ("", "w := u v r", "w = -v u r"),
    ],
)
def test_sides_with_the_same_factors_but_for_their_powers_or_their_order_contradict_nothing(words, given, claim):
    found = last_of(rf"{words} Define \[ {given}. \] Hence \[ {claim}. \]")
    assert found.verdict == "independent"
    assert "order of the factors" in found.links[0].reason or "its own square" in found.links[0].reason


@pytest.mark.parametrize(
    "word",
    ["The mask $m$ is used.", "Every element is idempotent.", "The units anticommute.", "Let $m$ be a truth value."],
)
def test_where_words_speak_of_special_values_or_products_nothing_contradicts(word):
    plain = r"Define \[ q := (1 - m)^2. \] Hence \[ q = 1 - m. \]"
    assert last_of(f"{word} {plain}").verdict == "independent"


@pytest.mark.parametrize(
    ("given", "claim"), [("c := a b", "c = -a b"), ("c := 2 a b", "c = 3 a b"), ("c := a + b", "c = a - b")]
)
def test_another_sign_or_number_still_contradicts(given, claim):
    assert last_of(rf"Define \[ {given}. \] Hence \[ {claim}. \]").verdict == "contradicts"


def test_a_power_that_is_lost_beside_one_that_is_kept_still_contradicts():
    assert last_of(r"Define \[ T := m r^2 w^2. \] Hence \[ T = m r w^2. \]").verdict == "contradicts"
