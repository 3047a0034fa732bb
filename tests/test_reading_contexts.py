"""What holds at the top is not put into what holds at the bottom."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def verdicts(text, *, latex=True):
    return [each.verdict for each in read_document(document_of(text, latex=latex), seconds=5)]


@pytest.mark.parametrize(
    "text",
    [
        r"\[ E = \frac{1}{2} m v^2 + m g h \] At the top, \[ v = 0 \] At the bottom, \[ h = 0 \] \[ E = 0 \]",
        r"\[ E = \frac12 m v^2 + m g h \] At the top, let $v = 0$. At the bottom, let $h = 0$. \[ E = 0 \]",
        r"In equilibrium, the fraction is \[ q = \frac{a}{a + b}. \] In general, \[ q (a + b) = a. \]",
        r"At the wall \[ u = 0 \] Far away \[ u = U \] \[ U = 0 \]",
        r"Left boundary: \[ y = 0 \] Right boundary: \[ y + x = 1 \] \[ x = 1 \]",
        r"Model 1: \[ y = a x + b \] Model 2: \[ y = c x \] \[ a x + b = c x \]",
        r"The old method uses \[ h = 2k \] The new method uses \[ h + k = 1 \] \[ 3k = 1 \]",
        r"For a lens with $f>0$, \[ a = 2f \] For a mirror, \[ b = a/2 \] \[ b = f \]",
        r"Without damping \[ \omega = k \] With damping \[ \omega = k - d \] \[ d = 0 \]",
        r"In the limit $k\to 0$, \[ w = 1 \] In the limit $k\to\infty$, \[ w = k \] \[ k = 1 \]",
        r"On the left \[ q = 1 \] on the right \[ q = r \] \[ r = 1 \]",
        r"If $b = 0$, \[ s = a. \] Otherwise \[ s^2 = a^2. \]",
        r"Before the collision \[ p = m v \] After the collision \[ p = 2 m w \] \[ m v = 2 m w \]",
        r"In the first medium \[ n = \sin a \] In the second medium \[ n = 2\sin b \] \[ 3 \sin a = 6 \sin b \]",
        r"\textbf{Example 1.} \[ x = 2 y \] \textbf{Example 2.} \[ x = 3 y \] \[ 2 y = 3 y \]",
        r"For $x>0$ \[ y = x \] For $x<0$ \[ y = -x \] \[ 2 x = 0 \]",
        r"In air \[ n = 1 \] In water \[ n = k \] \[ k = 1 \]",
        r"For the sphere \[ V = a^3 \] for the cube \[ V = b^3 \] \[ a^3 = b^3 \]",
        r"Observer one measures \[ t = T \] Observer two measures \[ t = g T \] \[ (g - 1) T = 0 \]",
        r"\[ f(x) = a x \] \[ a - x = 1 \] \[ f(3) = 3x + 3 \]",
    ],
)
def test_what_holds_somewhere_proves_nothing_elsewhere(text):
    assert verdicts(text)[-1] not in ("follows", "contradicts")


@pytest.mark.parametrize(
    "text",
    [
        r"\[ E = \frac{1}{2} m v^2 + m g h \] At the top, \[ v = 0 \] Hence \[ E = m g h \]",
        r"\[ E = \frac12 m v^2 + m g h \] At the top, let $v = 0$. \[ E = m g h \]",
        r"At the wall \[ u = a b \] After some algebra, we get \[ u c = a b c \]",
        r"Model 1: \[ y = a x + b \] In model 1 we have \[ y - b = a x \]",
        r"For a lens, \[ a = 2f \] On the other hand \[ a^2 = 4 f^2 \]",
        r"With the abbreviation \[ s = a + b \] With $s$ we obtain \[ s^2 = a^2 + 2ab + b^2 \]",
        r"At the top \[ v = a \tag{1} \] At the bottom, from (1), \[ v^2 = a^2 \]",
    ],
)
def test_what_holds_somewhere_holds_there_and_where_it_is_cited(text):
    assert verdicts(text)[-1] == "follows"


def test_a_role_of_myst_cites_an_equation():
    text = "At the top\n\n```{math}\n:label: speed\nv = a\n```\n\nAt the bottom, from {eq}`speed`,\n\n$$ v^2 = a^2 $$\n"
    assert verdicts(text, latex=False)[-1] == "follows"
