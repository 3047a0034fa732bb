"""Rows whose entries are held apart by ties, sizes below matrices, and what words and marks say of numbers."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def last_verdict(latex: str) -> str:
    return read_document(document_of(latex))[-1].verdict


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \mathbf{p} = (x ~ y ~ z)^\top \] \[ \mathbf{q} = 2 \mathbf{p} \] \[ \mathbf{q} = (2x ~ 2y ~ 2z)^\top \]",
        r"\[ \mathbf{t} = \left( t_x ~~ t'_y ~~ -1 \right)^T \] \[ \mathbf{t}^T \mathbf{t} = t_x^2 + t_y'^2 + 1 \]",
        r"The vector $(x, y, z)$ is a position. \[ u = \frac{2}{y} \] \[ u y = 2 \]",
        r"\[ \mathbf{J} = \left. \frac{\partial \mathbf{f}}{\partial \mathbf{x}} \right|_{3 \times 3} \] "
        r"\[ \mathbf{y} = 2 \mathbf{J} \mathbf{v} \] "
        r"\[ \mathbf{y} = 2 \frac{\partial \mathbf{f}}{\partial \mathbf{x}} \mathbf{v} \]",
        r"\[ \mathbf{A} = \begin{pmatrix} a & b \\ c & d \end{pmatrix}_{2 \times 2} \] \[ \det \mathbf{A} = ad - bc \]",
        r"\[ \mathbf{A} = [\phi]^\wedge \] \[ c = \cos \phi \] \[ c^2 = 1 - \sin^2 \phi \]",
        r"The vector is $\mathbf{n}$. \[ \mathbf{a} = \pi \mathbf{n} \] \[ t = \pi \] \[ t^2 = \pi^2 \]",
    ],
)
def test_it_follows(latex: str) -> None:
    assert last_verdict(latex) == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"Here $A$ and $B$ are matrices. \[ C = (A ~ B)^T \] \[ C = A^T B^T \]",
        r"\[ \mathbf{p} = (x ~ y)^\top \] \[ \mathbf{p} = (y ~ x)^\top \]",
        r"\[ \mathbf{p} = (x ~ y)^\top \] \[ \mathbf{p} = x y \]",
        r"\[ \mathbf{p} = (\mathbf{a} ~ \mathbf{b})^\top \] \[ \mathbf{p} = \mathbf{a}^\top \mathbf{b}^\top \]",
        r"The vectors $x, y$ are given. \[ z = x^T y \] \[ z = y x^T \]",
        r"\[ \mathbf{A} = [\boldsymbol\theta]^\wedge \] \[ \theta = \sin \theta \] \[ \mathbf{A}^\top = \mathbf{A} \]",
        r"\[ A = [v]^\wedge \] \[ A^\top = A \]",
    ],
)
def test_it_does_not_follow(latex: str) -> None:
    assert last_verdict(latex) != "follows"


TWO = r"x = a & t = 0 \\ y = b & t = 1"
WIDE = TWO.replace("&", "& &")


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (rf"\[ \begin{{cases}} {TWO} \end{{cases}} \] Hence \[ a t = 0. \]", False),
        (rf"\[ \begin{{cases}} {TWO} \end{{cases}} \] Hence \[ x + y = a + b. \]", False),
        (rf"\[ \left\{{ \begin{{array}}{{ll}} {TWO} \end{{array}} \right. \] Hence \[ a t = 0. \]", False),
        (rf"\[ \left\{{ \begin{{matrix}} {TWO} \end{{matrix}} \right. \] Hence \[ a t = 0. \]", False),
        (r"\[ \begin{matrix} x = a & t = 0 \\ x = b & t = 1 \end{matrix} \] Hence \[ x - a = 0. \]", False),
        (r"\[ \begin{matrix} x = a & \text{if } t = 0 \\ y = b & u = 1 \end{matrix} \] Hence \[ x - a = 0. \]", False),
        (rf"\[ \begin{{cases}} {WIDE} \end{{cases}} \] Hence \[ a t = 0. \]", False),
        (rf"\[ \left\{{ \begin{{array}}{{lll}} {WIDE} \end{{array}} \right. \] Hence \[ a t = 0. \]", False),
        (rf"\[ \begin{{cases}} {TWO.replace('= a', '&= a')} \end{{cases}} \] Hence \[ a t = 0. \]", False),
        (rf"\[ \begin{{cases}} {TWO.replace('= a', '&=& a')} \end{{cases}} \] Hence \[ a t = 0. \]", False),
        (r"\[ \begin{cases} x &=& a t \\ y &=& b + c \end{cases} \] Hence \[ x + y = a t + b + c. \]", True),
        (r"\[ \begin{cases} x &= a t \\ y &= b + c \end{cases} \] Hence \[ x + y = a t + b + c. \]", True),
        (r"\[ \begin{matrix} x = a & y = b \\ u = c & v = d \end{matrix} \] Hence \[ x + v = a + d. \]", True),
    ],
)
def test_what_stands_in_the_second_column_of_cases_is_a_condition(latex: str, follows: bool) -> None:
    assert (last_verdict(latex) == "follows") == follows


@pytest.mark.parametrize(
    ("words", "follows"),
    [
        ("so that", True),
        ("and hence", True),
        ("which gives", True),
        ("if and only if", False),
        ("for all $a$, so", False),
        ("unless", False),
    ],
)
def test_words_that_lead_from_one_equation_to_the_next_are_no_condition(words: str, follows: bool) -> None:
    found = last_verdict(rf"\[ s = a + b \text{{ {words} }} s^2 = (a + b)^2 \]")
    assert (found == "follows") is follows


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\begin{align} 0 &= v - a s \\ s &= v/a \end{align}", "follows"),
        (r"The robot has $v > 0$. \[ v = a s, \quad s = v/a \]", "follows"),
        (r"\begin{align} 0 &= v - a s \\ s &= a/v \end{align}", "definition"),
        (r"\begin{align} 0 &= v - a s \\ s &:= 2 a \end{align}", "definition"),
    ],
)
def test_a_row_that_gives_a_letter_of_the_row_above_may_follow_from_it(latex: str, verdict: str) -> None:
    assert last_verdict(latex) == verdict


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (
            r"\begin{eqnarray} u = a - b & & w = c \\ v = e & & x = f \end{eqnarray}",
            ["u = a - b", "w = c", "v = e", "x = f"],
        ),
        (r"\begin{eqnarray} u &=& a && v &=& b \end{eqnarray}", ["u = a", "v = b"]),
        (r"\begin{eqnarray} u &=& a + && b \end{eqnarray}", ["u = a + b"]),
        (r"\begin{align} u &= a && = b \end{align}", ["u = a = b"]),
    ],
)
def test_an_empty_column_holds_equations_apart(latex: str, expected: list[str]) -> None:
    assert [each.read for each in read_document(document_of(latex))] == expected
