"""What a sentence states within the text serves what follows it, as long as no words speak of another thing."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

SQUARE = r"\[ c^2 = a^2 - 2 a b + b^2. \]"
FORCE = r"The force is \[ F = k x. \] "
DIVIDED = r"Hence \[ a = \frac{k}{m} x. \]"


def verdict_of(latex):
    return read_document(document_of(latex, latex=True))[-1].verdict


@pytest.mark.parametrize(
    "latex",
    [
        "We have $c = a - b$. Hence " + SQUARE,
        "It follows that $c = a - b$. Now " + SQUARE,
        "It follows that $d = 2$ and $c = a - b$. So " + SQUARE,
        "Note that $c = a - b$. We get " + SQUARE,
        r"We have $\mathbf c = \mathbf a - \mathbf b$. Hence "
        r"\[ \mathbf c^T \mathbf c = \mathbf a^T \mathbf a - 2 \mathbf a^T \mathbf b + \mathbf b^T \mathbf b. \]",
        r"The polynomial is \[ p(x) = 3 + c (x-1). \] From $p(0)$ we find $c = 10$. Thus \[ p(x) = 3 + 10 (x-1). \]",
        FORCE + r"On the other hand, \[ F = m a. \] " + DIVIDED,
        FORCE + r"By the conservation of momentum, \[ F = m a. \] " + DIVIDED,
    ],
)
def test_what_is_stated_within_the_text_serves(latex):
    assert verdict_of(latex) == "follows"


@pytest.mark.parametrize(
    "words",
    [
        "At the boundary we have $c = a - b$. In the interior ",
        "If $a > b$, then $c = a - b$. So ",
        "For the first mass we have $c = a - b$. For the second mass ",
        "Suppose we have $c = a - b$. Otherwise ",
        "In one dimension we have $c = a - b$. In general ",
        "The student writes that $c = a - b$. We get ",
        "We have $c = a - b$. Let $c = a + b$. Then ",
        "In model A we have $c = a - b$. In model B ",
        "Then $c = a - b$ is wrong. We get ",
        "We have $c = a - b$ for small $a$. We get ",
        "When the switch is open we have $c = a - b$. The current is ",
        "With no friction we have $c = a - b$. With friction ",
        "At low speed we have $c = a - b$. At high speed ",
        r"We have $c = a - b$. \section{Beams} Now let $c$ be the width of a beam. ",
        "We have $c = a - b$. Now the letter $c$ denotes a capacity. ",
        "We have $c = a - b$. This is wrong. We get ",
        r"We have $c = a - b$. The capacity is \[ c = a + b. \] Hence ",
        r"The capacity is \[ c = a + b. \] For a wall we have $c = a - b$. Hence ",
        r"The capacity is \[ c = a + b. \] We have $c = a - b$. Hence ",
        r"We have $c \neq a - b$. Hence ",
        "Do we have $c = a - b$? ",
        "In the example we have $c = a - b$. The general result is ",
        "Smith obtains $c = a - b$. Our result is ",
        "For gold we have $c = a - b$. For silver ",
        "Initially we have $c = a - b$. Finally ",
        "On Earth we have $c = a - b$. On Mars ",
        "We have $c = a - b$ on Earth. On Mars ",
        "Later we get $c = a - b$. At the beginning ",
        "We have $c = a - b$, the width of the left beam. The right beam has ",
        "For Bob we have $c = a - b$. For Alice ",
        "Thus $c = a - b$, assuming no wind. In general, ",
        "We have $c = a - b$ and the other one has $c = a + b$. So ",
        "We have $c = a - b$ or $c = a + b$. So ",
        "In the old notation, we have $c = a - b$. Then ",
        "By Pythagoras, we would have $c = a - b$. Then ",
        "During the flight we have $c = a - b$. After landing ",
        "Then $c = a - b$, which contradicts the assumption. Hence ",
        "Thus $c = a - b$, a contradiction. We conclude ",
        "Then $c = a - b$. But this is impossible. Hence ",
        "We have $c = a - b$. The second device has ",
        "Consider a disk. We have $c = a - b$. Consider a ring. We have ",
        "A disk is heavy. We have $c = a - b$. A ring is light. It has ",
    ],
)
def test_what_is_stated_of_another_thing_does_not(words):
    assert verdict_of(words + SQUARE) != "follows"


@pytest.mark.parametrize(
    ("words", "then", "verdict"),
    [
        ("While $K$ is the energy, it is", "The speed is", "follows"),
        ("While it stands,", "It drives off.", "independent"),
        ("While $v$ is small, we have", "In general,", "independent"),
    ],
)
def test_while_is_no_time_where_it_names_a_letter(words, then, verdict):
    energy, speed = r"\[ K = \frac12 m v^2. \]", r"\[ v = w l. \] Hence \[ K = \frac12 m w^2 l^2. \]"
    assert verdict_of(f"{words} {energy} {then} {speed}") == verdict


@pytest.mark.parametrize(
    "latex",
    [
        r"We have $x = 1$. For every $x$, the area is \[ S = a x. \] So \[ S = a. \]",
        r"We find $x = 1$ by a simulation. The area is \[ S = a x. \] So \[ S = a. \]",
        FORCE + r"On the other body, \[ F = m a. \] " + DIVIDED,
        FORCE + r"For the balance of the second beam, \[ F = m a. \] " + DIVIDED,
        FORCE + r"On the other hand, for the wall the force is \[ F = m a. \] " + DIVIDED,
    ],
)
def test_nor_does_what_holds_of_a_case(latex):
    assert verdict_of(latex) != "follows"


def test_each_time_step_is_no_other_constant_each_time():
    text = r"The rate at $t$ is held constant over each time step. \[ v = a t \] Hence \[ 2 v = 2 a t \]"
    assert read_document(document_of(text))[-1].verdict == "follows"
