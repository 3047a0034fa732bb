r"""In what range an equation holds, of what it speaks, and that two equations of two things are not put together."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def _follows(text: str) -> bool:
    return read_document(document_of(text), seconds=5)[-1].verdict == "follows"


GIVEN = [
    r"The profile is \[ u(y) = a y, \qquad 0 \le y \le 2. \]",
    r"The profile is \[ u(y) = a y, \quad y \in [0, 2). \]",
    r"For $0 \leq y < 2$ the profile is \[ u(y) = a y. \]",
    r"The profile is \[ u(y) = a y, \] where $|y| < 2$.",
    r"The profile is \[ u(y) = a y, \quad y \in (0, 2) \]",
]


@pytest.mark.parametrize("given", GIVEN)
@pytest.mark.parametrize(
    ("claim", "follows"),
    [
        ("u(1) = a", True),
        ("u(y) - a y = 0", True),
        ("u(y / 2) = a y / 2", True),
        ("u(5) = 5 a", False),
        ("u(-7) = -7 a", False),
    ],
)
def test_a_function_is_given_in_its_range_alone(given: str, claim: str, follows: bool) -> None:
    assert _follows(rf"{given} Hence \[ {claim}. \]") is follows


@pytest.mark.parametrize(
    ("text", "follows"),
    [
        (r"\[ w(s) = b s, \quad 0 \le s \le h \] Hence \[ w(3 h) = 3 b h. \]", False),
        (r"\[ w(s) = b s, \quad 0 \le s \le h \] Hence \[ w(h / 3) = b h / 3. \]", True),
        (r"\[ w(s) = b s, \quad 0 \le s < 1 \] With period one, hence \[ w(s + 1) = b s + b. \]", False),
        (r"\[ y = b s, \quad s > 0 \] With $s = -2$ we get \[ y = -2 b. \]", False),
        (r"\[ y = b s, \quad s > 0 \] With $s = 2$ we get \[ y = 2 b. \]", True),
        (r"\[ g(s) = w(s) + 1 \] \[ w(s) = b s, \quad s \ge 0 \] Hence \[ g(-4) = 1 - 4 b. \]", False),
    ],
)
def test_what_is_put_in_must_lie_in_the_range(text: str, follows: bool) -> None:
    assert _follows(text) is follows


@pytest.mark.parametrize(
    ("text", "follows"),
    [
        (r"Until it melts, \[ h(T) = c T. \] Hence after melting \[ h(2 T) = 2 c T. \]", False),
        (r"On the upper half the load is \[ q = c x. \] The lower half is bare. Hence \[ 2 q = 2 c x. \]", False),
        (r"In tank one \[ p = a h. \] In tank two \[ p = b h. \] Hence \[ a h = b h. \]", False),
        (r"In frame one, \[ (P, Q) = (a, b). \] In frame two, \[ (P, Q) = (c, d). \] Hence \[ a = c. \]", False),
        (r"Problem 1. \[ v = 2 t \] Problem 2. \[ s = v t \] Hence \[ s = 2 t^2. \]", False),
        (r"\[ x = a + b \] \[ b = a \] in the first branch only. In the second branch, hence \[ x = 2 a. \]", False),
        (r"Up to scale, \[ u = a X. \] Hence \[ 2 u = 2 a X. \]", False),
        (r"\[ y = a x \] Problem: let $a = 3$ and find $y$. In the text, hence \[ y = 3 x. \]", False),
        (r"In tank one \[ p = a h. \] Hence in tank one \[ 2 p = 2 a h. \]", True),
        (r"For simplicity, \[ p = a h. \] For wood, \[ 2 p = 2 a h. \]", True),
        (r"In section 2 we saw \[ p = a h. \] In equation 3 we see \[ 2 p = 2 a h. \]", True),
    ],
)
def test_what_holds_of_one_thing_proves_nothing_of_another(text: str, follows: bool) -> None:
    assert _follows(text) is follows


@pytest.mark.parametrize(
    ("thing", "follows"), [("for oak", False), ("an oak bar has", False), ("for pine", True), ("a pine bar has", True)]
)
def test_a_letter_that_is_given_of_another_thing_is_not_that_of_the_first(thing: str, follows: bool) -> None:
    before = (
        r"The density of oak is \[ \rho = 3 c. \] The density of pine is \[ \rho = 2 c. \] The mass is \[ m = \rho V \]"
    )
    assert _follows(rf"{before} Hence {thing} \[ m = 2 c V. \]") is follows


@pytest.mark.parametrize(
    ("words", "follows"),
    [
        ("Backward and forward quotients are", False),
        ("The slopes on both sides are", False),
        ("The balances are", True),
        ("We have the equations", True),
    ],
)
def test_rows_of_several_things_are_not_put_together(words: str, follows: bool) -> None:
    text = rf"{words} \begin{{align}} d h &= b - a \\ d h &= c - b \end{{align}}"
    text = text.replace("d h", "d")
    assert _follows(rf"{text} Hence \[ a + c = 2 b. \]") is follows
