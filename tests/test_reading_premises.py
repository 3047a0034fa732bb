"""Equations rest on equations above them, derivatives are computed, sums are linear; and nothing true contradicts."""

import pytest

from algebroproj_sym.declaring import DeclarationError
from algebroproj_sym.declaring.quotes import quotations
from algebroproj_sym.reading import document_at, document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")


def last(latex, *, reading=document_of):
    return read_document(reading(latex), seconds=10)[-1]


ENERGY = r"""Here $m$ and $k$ are constant. \[ T := \frac12 m \dot x^2 + \frac12 k x^2 \]
The letter $\ddot x = a$ is used. """
ORBIT = r"""The letters $h > p > \mu$ are used.
\[ h = 2 \mu p \] \begin{equation} p = a(1-e^2) \label{p} \end{equation} """
ROTATIONS = r"""\[ \begin{bmatrix}\cos z & -\sin z & 0\\ \sin z & \cos z & 0\\ 0&0&1\end{bmatrix}
\begin{bmatrix}\cos y\\ 0\\ -\sin y\end{bmatrix} = \begin{bmatrix}\cos y\cos z\\ \cos y\sin z\\ -\sin %s\end{bmatrix}
= \begin{bmatrix}\cos z\cos y\\ \sin z\cos y\\ -\sin %s\end{bmatrix} \]"""


@pytest.mark.parametrize(
    "latex",
    [
        ORBIT + r"Hence \[ h = 2 \mu a (1-e^2) \]",
        ENERGY + r"\[ \frac{\partial T}{\partial x} = k x \]",
        ENERGY + r"\[ \dot T = m \dot x \ddot x + k x \dot x \]",
        r"\[ f(x) := x^3 + \sin x \] \[ \frac{d f}{d x} = 3x^2 + \cos x \]",
        r"\[ f(x) := x^3 \] \[ \frac{d^2 f}{d x^2} = f''(x) \]",
        ENERGY + r"\[ \frac{d T}{d t} = m \dot x \ddot x + k x \dot x \] The rate is $\dot T$.",
        r"\[ \frac{d\mathbf{r}}{dt} + \frac{d^2\mathbf{r}}{dt^2} = \dot{\mathbf{r}} + \ddot{\mathbf{r}} \]",
        r"\[ E(X) = a + b \] \[ E(X^2) = 2 a b \] \[ V(X) = E(X^2) - E(X)^2 \] \[ V(X) = -a^2 - b^2 \]",
        r"\[ s^2 = a b \] \[ c := s^2 c_1 \] \[ c = a b c_1 \]",
        r"\[ F = {n \choose k} p^k \] \[ 2 F = 2 \binom{n}{k} p^k \]",
        r"\[ p(a) = q a \] \[ p(a, b) = 2 p(a) b \] \[ p(a, b) + p(a) = (2b + 1) q a \]",
        r"\[ \mathbf{c} := \sum_{j=1}^n m_j (\mathbf{r}_j + \mathbf{w}\times\mathbf{d}) \]"
        r"\[ \mathbf{c} = \sum_{j=1}^n m_j \mathbf{r}_j + \mathbf{w}\times\mathbf{d} \sum_{j=1}^n m_j \]",
        r"\[ \mathbf{c} := \sum_{j=1}^n m_j l_j \mathbf{r}_j \] \[ \mathbf{c} = \sum_{j=1}^n l_j m_j \mathbf{r}_j \]",
        r"\[ \dot{\bm r} = \bm a \times \bm b \] \[ \dot{\bm r} = -\bm b \times \bm a \]",
        r"\[ {\vphantom{\bm w}}^{B}{\bm w} = 2 \bm a \] \[ \bm a = \frac12 {}^{B}\bm w \]",
    ],
)
def test_what_follows_from_what_stands_above_follows(latex):
    assert last(latex).verdict == "follows"


CIRCLE = "$$ c^2 + s^2 = 1 $$\n" r"\[ Q := \begin{pmatrix} c & -s \\ s & c \end{pmatrix} \] "


def test_what_holds_under_an_equation_above_follows():
    proved = last(CIRCLE + r"\[ Q^T Q = \mathbf{I} \]")
    assert proved.verdict == "follows"
    assert proved.links[0].rests_on == ("line 2", "line 1")
    assert last(CIRCLE + r"\[ \det Q = c^4 + s^2 + c^2 s^2 \]").verdict == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        CIRCLE + r"\[ Q^T Q = 2\mathbf{I} \]",
        CIRCLE + r"\[ Q Q = \mathbf{I} \]",
        r"\[ c^2 + s^2 = -1 \] \[ c^4 - s^4 = s^2 - c^2 \]",
        r"\[ c^2 + s^2 = 1 \] If $c = s$, then \[ c^2 - s^2 = 1 \] \[ c^4 - s^4 = 1 \]",
    ],
)
def test_what_fails_under_an_equation_above_does_not_follow(latex):
    assert last(latex).verdict in ("independent", "not decided")


TRUE_OF_ANOTHER_THING = {
    "another wave": r"\[ x = x_0 + v t. \] Hence it moves to the right. A second wave travels as \[ x = x_0 - v t. \]",
    "another body": r"A disc of mass $m$ has \[ I = \frac12 m r^2. \] A ring has \[ 2 I = 2 m r^2. \]",
    "another phase": r"Two waves in phase have the amplitude \[ c = a + b. \] "
    r"Two waves out of phase have the intensity \[ c^2 = a^2 - 2ab + b^2. \]",
    "another medium": r"The index is \[ n = c/v. \] For the second medium we have \[ n = c/(2v). \]",
}


@pytest.mark.parametrize("latex", TRUE_OF_ANOTHER_THING.values(), ids=TRUE_OF_ANOTHER_THING)
def test_what_is_true_of_another_thing_contradicts_nothing(latex):
    assert last(latex).verdict not in ("contradicts", "follows")


def test_nothing_follows_from_what_contradicts():
    assert last(r"\[ S := a+b+c \] \[ S = a+b-c \] \[ S-a = b-c \]").verdict == "independent"


def test_the_verdict_names_what_it_rests_on():
    (link,) = last(ORBIT + r"Hence \[ h = 2 \mu a (1-e^2) \]").links
    assert link.rests_on == ("(1), line 2", "line 2")
    (link,) = last(ENERGY + r"\[ \dot T = m \dot x \ddot x + k x \dot x \]").links
    assert "the derivative of line 1, where k, m do not change" in link.rests_on


@pytest.mark.parametrize(
    ("latex", "suggestion"),
    [
        (ORBIT + r"Substituting \eqref{p} yields \[ h = 2 \mu a (1+e^2) \]", "1 - e**2 instead of 1 + e**2"),
        (ENERGY + r"Hence \[ \frac{\partial T}{\partial x} = 2 k x \]", "1 instead of 2"),
        (r"The letters $x > y$. \[ x = y + 1 \] Thus \[ y = x + 1 \]", "x - 1 instead of x + 1"),
        (ROTATIONS % ("z", "z"), "y instead of z"),
    ],
)
def test_a_slip_in_what_is_said_to_follow_is_found(latex, suggestion):
    reading = last(latex)
    assert reading.verdict == "contradicts"
    assert suggestion in {link.suggestion for link in reading.links}


@pytest.mark.parametrize(
    "latex",
    [
        ORBIT + r"Another orbit has \[ h = 2 \mu a (1+e^2) \]",
        ORBIT + r"\section{Other} Hence \[ h = 2 \mu a (1+e^2) \]",
        ENERGY + r"In steady motion \[ \dot T = 0 \]",
        ENERGY + r"If $m$ changes, then hence \[ \dot T = m \dot x \ddot x + k x \dot x + \dot m \dot x^2 / 3\]",
        r"The sum is \[ \bm c := \sum_{j=1}^n m_j \bm r_j \] hence \[ \bm c = \sum_{j=1}^k m_j \bm r_j \]",
        r"\[ \mathbf{c} := \sum_{j=1}^n m_j \mathbf{r}_j \] Hence \[ \mathbf{c} = m_j \sum_{j=1}^n \mathbf{r}_j \]",
        r"The tilde is an estimate. \[ \mathbf{h} := \tilde{\mathbf{w}} \] Hence \[ \mathbf{h} = -\mathbf{w} \]",
        r"\[ x^2 + y^2 = 2 x y \]",
    ],
)
def test_what_may_be_meant_otherwise_contradicts_nothing(latex):
    assert last(latex).verdict != "contradicts"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \mathbf{c} := \sum_{j=1}^n m_j \mathbf{r}_j \] \[ \mathbf{c} = m_j \sum_{j=1}^n \mathbf{r}_j \]",
        r"\[ \mathbf{c} := \sum_{j=1}^n \mathbf{r}_{jk} \] \[ \mathbf{c} = n \mathbf{r}_{jk} \]",
        r"\[ \mathbf{c} := \sum_j \sum_k b_{jk} \mathbf{r}_k \] \[ \mathbf{c} = \sum_k b_{jk} \sum_j \mathbf{r}_k \]",
        r"The letters $x > y$. \[ x = y + 1 \] Thus \[ y = x + 1 \]",
        r"\[ g := y^2 \] \[ f := x g \] where \[ x = g \] \[ \frac{\partial f}{\partial y} = x \]",
        r"\[ f := a x \] \[ \frac{\partial f}{\partial x} = a + x \]",
        r"\[ f := |x| \] \[ \frac{\partial f}{\partial x} = 1 \]",
        r"\[ \mathbf{h} := \tilde{\mathbf{w}}\mathbf{d} \] \[ \mathbf{h} = \mathbf{w}\times\mathbf{d} \]",
    ],
)
def test_what_does_not_follow_does_not(latex):
    assert last(latex).verdict != "follows"


def test_a_misprint_of_a_published_document_is_found(repository):
    first, second = read_document(document_at(repository / "examples" / "reading" / "euler_angles.tex"))
    assert (first.verdict, second.verdict) == ("follows", "contradicts")
    assert second.links[-1].suggestion == "y instead of z"


def test_a_table_gives_a_quote_for_each_row_and_its_cells(tmp_path):
    file = tmp_path / "quotes.toml"
    table = '[[table]]\nname = "4/a"\nline = 7\ncolumns = ["X", "y", "z"]\ngiven = ["X"]\nnames = { "$O$" = "O" }\n'
    file.write_text(table + 'rows = """\n1\t2.50\t-0.10\t3\n$O$\t\t0.20\n"""\n', encoding="utf-8")
    found = quotations(tmp_path)
    assert found.rows("4/a", "X", "y") == {"1": ("2.50", "-0.10")}
    assert found.rows("4/a", "y") == {"1": ("-0.10",), "O": ("0.20",)}
    assert found.quotes["4/a#O.y"].line == 8
    assert found.quotes.keys() == {"4/a#1.y", "4/a#1.z", "4/a#O.y"}
    assert found.decimals("4/a#1.z") == ("2.50", "-0.10")


def test_a_row_with_too_many_cells_is_refused(tmp_path):
    rows = '[[table]]\nname = "a"\nline = 1\ncolumns = ["x"]\nrows = "1\\t2\\t3"\n'
    (tmp_path / "quotes.toml").write_text(rows, encoding="utf-8")
    with pytest.raises(DeclarationError, match=r"expected 1 cells.*got 2"):
        quotations(tmp_path)


BERNOULLI = r"\[ p_0 + \frac12 r u^2 = p + \frac12 r w^2 \] \[ c := \frac{p - p_0}{\frac12 r u^2} \]"


@pytest.mark.parametrize(
    ("latex", "hypothesis"),
    [
        (BERNOULLI + r"\[ c = 1 - \left(\frac{w}{u}\right)^2 \]", "u"),
        (r"The letters $s > q > r$. \[ s (q - r) = \frac12 (q^2 - r^2) \Rightarrow s = \frac12 (q + r) \]", "q - r"),
        (r"The letters $x > v > w$. \[ x + y L = v \] \[ x - y L = w \] \[ 2 y L = v - w \]", ""),
        (r"\[ f(x, y) = g \] \[ f(x, y) = x^2 y \] \[ u = \frac{\partial f}{\partial y} = x^2 \]", ""),
    ],
)
def test_an_equation_gives_each_letter_in_which_it_is_linear(latex, hypothesis):
    reading = last(latex)
    assert reading.links[-1].verdict == "follows"
    assert reading.links[-1].rests_on
    assert not hypothesis or hypothesis in reading.links[-1].hypotheses


@pytest.mark.parametrize(
    "latex",
    [
        r"The letters $x > y$. \[ x^2 = y^2 \] \[ x = y \]",
        r"The letters $x > y > z$. \[ x z = y z \] \[ x = y + z \]",
        r"The letters $x > y$. \[ x (\sin^2 y + \cos^2 y - 1) = 0 \] \[ x = 0 \]",
        r"The letters $x > y > z$. \[ (z - z) x = y \] \[ x = y \]",
        r"The letters $x > y > z$. \[ \left(\frac{2z}{2y} - \frac{z}{y}\right) x = y \] \[ x = y \]",
        r"The letters $x > y$. \[ x + y = 1 \quad \text{for } y > 2 \] \[ x = 1 - y \]",
        r"The letters $x > y$. \[ x + 2 y = 1 \] \section{Other} \[ 2 x = 2 - 4 y \]",
    ],
)
def test_an_equation_gives_no_letter_that_it_does_not(latex):
    assert last(latex).verdict != "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ P = K x \] where \[ K = a + b. \]",
        r"The camera $K$ has \[ K x = y. \] It is \[ K = \begin{pmatrix} a & b \\ 0 & c \end{pmatrix}. \]",
        r"\[ x = [a] b \] where \[ [a] = c. \]",
        r"\[ p + v = q. \] The volume $v$ is given by \[ v = a b c. \]",
        r"\[ p = v q. \] The height and the width give \[ v = a b c. \]",
        r"\[ s^2 = a^2 + b^2. \]",
    ],
)
def test_a_letter_that_is_introduced_is_defined(latex):
    assert last(latex).verdict == "definition"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ p := m v. \] The body rests if \[ v = 0. \]",
        r"If the body rests, \[ v = 0. \]",
        r"\[ p := m v. \] If the body rests, $v = 0$. In general \[ 2 v = 3. \]",
        r"The letters $v > m$. The body has two speeds, where for the first \[ v = 3. \]",
        r"\[ p + v = 2 q a b c. \] On the other side \[ v = a b c. \]",
        r"\[ 2 p = v q + v. \] At rest \[ v = a b. \]",
        r"\[ v = a. \] \section{Other} \[ v = 2 a. \]",
        r"\[ 2 s = v q + v. \] \[ v^2 = 2 a. \]",
        r"\[ f(x) = x^3. \] The cube has \[ f'(x) = 2 x. \]",
    ],
)
def test_a_letter_in_a_case_is_not(latex):
    assert last(latex).verdict != "definition"


def test_a_way_that_would_follow_is_suggested_though_nothing_contradicts():
    (link,) = last(BERNOULLI + r"For the plate \[ c = 1 + \left(\frac{w}{u}\right)^2 \]").links
    assert link.verdict == "independent"
    assert link.suggestion == "1 - (w/u)**2 instead of 1 + (w/u)**2"


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        (r"The mean motion is $n = \sqrt{\mu/a^3}$.", "follows"),
        (r"The mean motion is $n = \sqrt{\mu/a^3}$. \[ n = 2 \pi/P \]", "independent"),
        (r"A condition is $n = \sqrt{\mu/a^3}$.", "independent"),
        (r"The mean motion is not $n = \sqrt{\mu/a^3}$.", "independent"),
        (r"At a point there is $n = \sqrt{\mu/a^3}$ if $\mu = 1$. Elsewhere $n = 2 a$.", "independent"),
    ],
)
def test_the_only_equation_that_gives_a_letter_in_words_defines_it(words, verdict):
    assert last(words + r" Hence \[ n^2 a^3 = \mu \]").verdict == verdict
