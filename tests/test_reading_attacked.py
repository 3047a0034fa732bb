r"""Documents whose last equation would follow from the letters alone, and does not by the words or the mathematics.

Beside each is one that looks like it, and in which the last equation follows.
"""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

AXES = r"\[ \mathbf{r} = x \mathbf{e}_1 + y \mathbf{e}_2 \] Hence "
RATE = r"\[ \dot{\mathbf{r}} = \dot x \mathbf{e}_1 + \dot y \mathbf{e}_2. \]"
START = r"At $t = 0$ we have \[ x = x_0. \] "

MISLEADING = {
    "do not write": r"Do not write \[ c = a + b. \] Hence \[ 2 c = 2 a + 2 b. \]",
    "an eigenvector": r"\[ A x = \lambda x \] Hence \[ A = \lambda I. \]",
    "an eigenvector by words": r"Let $v$ be an eigenvector of $M$: \[ M v = \lambda v \] Hence \[ M = \lambda. \]",
    "a generalised eigenvector": r"\[ K u = \omega^2 M u \] Hence \[ K = \omega^2 M. \]",
    "an eigenvector put in": r"\[ A x = \lambda x \] \[ B = A + C \] Hence \[ B = \lambda I + C. \]",
    "an eigenvector of the transpose": r"\[ A v = \lambda v \] Hence \[ v^T A = \lambda v^T. \]",
    "an index three times": r"\[ a = u_i v_i \] \[ b = a w_i \] Hence \[ b = u_i v_i w_i. \]",
    "the square of a sum": r"\[ s = u_i v_i \] \[ r = s^2 \] Hence \[ r = u_i^2 v_i^2. \]",
    "the square of a trace": r"\[ p = \sigma_{kk} \] \[ q = p^2 \] Hence \[ q = \sigma_{kk} \sigma_{kk}. \]",
    "a function at the end": r"\[ f = x y \] Hence \[ \frac{df}{dx} = y, \] where $y$ depends on $x$.",
    "axes that turn": rf"The vectors $\mathbf{{e}}_1$ and $\mathbf{{e}}_2$ turn with the body. {AXES}{RATE}",
    "axes of a frame": rf"The body frame has the unit vectors $\mathbf{{e}}_1$ and $\mathbf{{e}}_2$. {AXES}{RATE}",
    "axes told behind": rf"{AXES}{RATE} Here $\mathbf{{e}}_1$ and $\mathbf{{e}}_2$ are the axes of the rotating frame.",
    "the interior": r"On the boundary, \[ u = 0. \] In the interior the flux is \[ q = k u + f \] \[ q = f. \]",
    "another time": rf"{START}At time $t$ the energy is \[ V = k x^2. \] Hence \[ V = k x_0^2. \]",
    "after the start": rf"{START}After the impact the energy is \[ V = k x^2. \] Hence \[ V = k x_0^2. \]",
    "a finite number": r"In the limit of large $N$, \[ s = b. \] For finite $N$ the error is "
    r"\[ e = s c. \] Hence \[ e = b c. \]",
    "what should be reached": r"The drive should reach \[ y = r. \] The error is \[ e = r - y. \] Hence \[ e = 0. \]",
    "what is to be followed": r"The arm is to follow \[ y = r. \] The error is \[ e = r - y. \] Hence \[ e = 0. \]",
    "two planets": r"For the Earth, \[ u = 4c. \] For Mars the speed is \[ v = u r. \] Hence \[ v = 4 c r. \]",
    "in another medium": r"In the simulation we set \[ k = 2. \] In the experiment we have "
    r"\[ x = k F. \] Hence \[ x = 2F. \]",
    "above and below": r"At the surface \[ p = a. \] Below the surface we have \[ q = p + z. \] So \[ q = a + z. \]",
    "what stood for another thing": r"In Chapter 2 the letter $h$ stood for the altitude, \[ h = r - R. \] "
    r"Here $h$ is the angular momentum, \[ p = h^2. \] Hence \[ p = (r - R)^2. \]",
    "the speed of sound": r"The speed of sound is $c$. The length is \[ l = c f. \] "
    r"The heat with the specific heat $c$ is \[ Q = m c. \] Hence \[ Q f = m l. \]",
    "a mode of vibration": r"\[ K \phi = p G \phi \] Hence \[ p = \frac{K}{G}. \]",
}

FOLLOWING = {
    "an eigenvector twice": r"\[ A v = \lambda v \] Hence \[ A A v = \lambda^2 v. \]",
    "weights": r"\[ \rho V g = m g \] Hence \[ \rho V = m. \]",
    "an index that is counted": r"\[ p_i = m_i v_i \] \[ K_i = p_i v_i / 2 \] Hence \[ K_i = m_i v_i^2/2. \]",
    "another function at the end": r"\[ f = x y \] Hence \[ \frac{df}{dx} = y, \] where $z$ depends on $x$.",
    "axes that rest": AXES + RATE,
    "the interior alone": r"In the interior the flux is \[ q = k u + f. \] Hence \[ q - f = k u. \]",
    "the same time": rf"{START}At $t = 0$ the energy is \[ V = k x^2. \] Hence \[ V = k x_0^2. \]",
    "two things of one body": r"For the momentum we get \[ p = m v. \] For the energy we get "
    r"\[ E = p v. \] Hence \[ E = m v^2. \]",
    "the speed of sound alone": r"The speed of sound is $c$. The length is \[ l = c f. \] "
    r"The pressure with the speed $c$ is \[ q = m c. \] Hence \[ q f = m l. \]",
    "any number": r"For finite $N$ we have \[ s = b. \] The error is \[ e = s c. \] Hence \[ e = b c. \]",
}


@pytest.mark.parametrize("name", MISLEADING)
def test_what_follows_by_its_letters_alone_does_not_follow(name: str) -> None:
    assert read_document(document_of(MISLEADING[name]))[-1].verdict != "follows"


@pytest.mark.parametrize("name", FOLLOWING)
def test_what_only_looks_like_that_follows(name: str) -> None:
    assert read_document(document_of(FOLLOWING[name]))[-1].verdict == "follows"
