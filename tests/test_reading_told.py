"""Equations that say what their left side is: by cases, by sets, beside a condition, anew, and by the words before."""

from __future__ import annotations

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def verdict(latex: str) -> str:
    return read_document(document_of(latex), seconds=5)[-1].verdict


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ f(r) = \begin{cases} 0 & r < a \\ 1 & r \ge a \end{cases} \]",
        r"\[ R_i = \{x \in S : E(x) = i\} \]",
        r"\[ H = \|H\| \begin{bmatrix} \cos I \\ \sin I \end{bmatrix} \]",
        r"\[ p(v) = \sum_h p(v, h) \]",
        r"\[ \omega(t) = \omega(0) + A(t) \]",
        r"\[ f(x) = p(x | y) \]",
        r"\[ \a(\p) = \p + b \]",
        r"If $u > 0$: \[ B = n u \] If $u < 0$: \[ B = n v \]",
        r"\[ D = a. \] For the said thin case, the number $D$ results in \[ D = E n. \]",
        r"If we have $n$ exposures this generalises to \[ C = n c. \]",
        r"If we set $u = n$ and $v = m$ we can write \[ C = u c. \]",
        r"Under this assumption we have \[ C = u c. \]",
        r"The error between what is true and the estimates provided by the agent is \[ r = c - d. \]",
        r"The displacement is \[ r_2 - r_1 = \begin{pmatrix} x \\ y \end{pmatrix}. \]",
        r"We define it as \[ \langle f, g \rangle = \int_a^b f(x) g(x) dx. \]",
        r"\[ S^0 = a b. \] \[ S = c. \] \[ S^0 = d b. \]",
        r"\[ z = y - x. \] \section{Back} \[ y = 2 z + u. \]",
        r"\[ F = -k x. \] Newton's law is \[ F = m a. \]",
        r"\begin{itemize} \item \[ K(x) = x. \] \item \[ K(x) = \frac{\sin x}{x}. \] \end{itemize}",
    ],
)
def test_what_is_told_is_a_definition(latex: str) -> None:
    assert verdict(latex) == "definition"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ f(r) + f(s) = b \] \[ f(r) = 0 \]",
        r"\[ x = |x| \]",
        r"\[ x = x + 1 \]",
        r"\[ F(a) = F(a - \pi) + N \]",
        r"\[ V(x) = r(x) + g V(y) \]",
        r"\[ x + b = c. \] A point is critical if and only if we have \[ x = a b. \]",
        r"\[ x + b = c. \] The rod rests if its ends are free and it has \[ x = a b. \]",
        r"\[ x + b = c. \] If it is known that it becomes \[ x = a b. \]",
        r"\[ x + b = c. \] When the two ends are such that they have \[ x = a b. \]",
        r"\[ x + b = c. \] The wheel rests if $u > 0$ and \[ x = a b. \]",
        r"\[ x + b = c. \] The solution exists provided that \[ x = a b. \]",
        r"Conservation of momentum is \[ m a - F = k x. \]",
        r"The condition for rest is \[ m a - F = k x. \]",
        r"\[ F = -k x. \] Hence \[ F = k x. \]",
        r"\[ F = a b. \] In fact, \[ F = a + b. \]",
        r"\[ \Prob{X = x} \]",
        r"\[ \cancel{X = x} \]",
    ],
)
def test_a_condition_a_law_or_a_number_is_none(latex: str) -> None:
    assert verdict(latex) != "definition"


def test_what_is_said_to_follow_and_fails_stays_a_new_statement() -> None:
    assert verdict(r"\[ y = b + w x. \] Hence \[ y = b - w x. \]") in ("contradicts", "independent")


@pytest.mark.parametrize(
    ("words", "follows"),
    [
        (r"Here $V$ is the set voltage.", True),
        (r"Here $V$ is the set of voltages.", False),
        (r"Here $V$ is the set.", False),
        (r"Here $V$ is an event.", False),
        (r"Let $V$ be the derivative.", False),
    ],
)
def test_what_is_set_is_a_number_and_a_set_is_none(words: str, follows: bool) -> None:
    assert (verdict(rf"{words} \[ m = q V r. \] Hence \[ m - V q r = 0. \]") == "follows") == follows


def test_the_rate_of_a_letter_is_a_number() -> None:
    latex = r"The derivative $u_x$ is constant. \[ m = q u_x r. \] Hence \[ m - u_x q r = 0. \]"
    assert verdict(latex) == "follows"
    assert verdict(latex.replace("u_x", "D_x")) != "follows"


@pytest.mark.parametrize(
    ("words", "follows"),
    [
        (r"The reactor has the residence time $u = V/q$.", True),
        (r"The beam has the length $u = V/q$ if it is cold.", False),
        (r"The beam has the length $u = V/q$, but only when it is cold.", False),
        (r"Some use the incorrect speed $u = V/q$.", False),
        (r"Is the speed $u = V/q$?", False),
        (r"Is the speed $u = V/q$ in a wide pipe?", False),
        (r"We do not use the effective mass $u = V/q$ here.", False),
        (r"In the old units the reduced mass $u = V/q$ was used.", False),
    ],
)
def test_a_quantity_with_an_adjective_is_given_within_the_text(words, follows):
    latex = words + r" The force is \[ F = u g. \] Hence \[ F = \frac{V g}{q}. \]"
    assert (verdict(latex) == "follows") is follows
