"""Documents on cameras: the signs that they use, and what several of their equations say together."""

from __future__ import annotations

import pytest

from algebroproj_sym.reading import Reading, document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def last(latex: str) -> Reading:
    return read_document(document_of(latex))[-1]


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"y = x + \triangle x", "y = x + Delta_x"),
        (r"g = \triangledown_x f", "g = nabla_x*f"),
        (r"x\prime = f \frac{X}{Z}", "xp = f*X/Z"),
        (r"x^{\prime\prime} = f^\prime x", "xpp = fp*x"),
        (r"R = I - [\alpha \times] + \left(\beta\times\right)^T", "R = I - hat(alpha) + hat(beta).T"),
        (r"K = a b\text{,} \quad H = a + b\text{.}", "H = a + b"),
        (r"M x = k x \ldots(7)", "M*x = k*x"),
        (r"P = K \left[\; R\;\;|\;\;-R C\;\right]", "P = K*[[R, -R*C]]"),
        (r"([\mathbf a]_\times)^T = (a_{\times})", "hat(a).T = a_times"),
    ],
)
def test_a_sign_is_read(latex: str, expected: str) -> None:
    assert last(rf"\[ {latex} \]").read == expected


def test_the_corners_of_a_triangle_are_no_difference() -> None:
    assert last(r"\[ F = \triangle ABC \]").verdict == "not read"


def test_markdown_escapes_signs_where_it_escapes_the_ends_of_rows() -> None:
    text = "$$ x = \\begin{bmatrix} a \\\\\\\\ b \\end{bmatrix} $$ $$ f = a,\\\\; g = b $$"
    found = read_document(document_of(text, latex=False))
    assert [each.read for each in found] == ["x = [[a], [b]]", "f = a", "g = b"]


MATRICES = (
    r"""Let $H$ and $M$ be matrices. \[ \vec{l'} = H^{-T}\cdot \vec{l} \] \[ \vec{p'} = H \cdot \vec p \] Hence """
)
TRIANGLES = r"""\[ s_1^2 + s_3^2 - 2 s_1 s_3\cos(\beta) = b^2 \] \[ s_1^2 + s_2^2 - 2 s_1 s_2\cos(\gamma) = c^2 \]
We define \[ u = \frac{s_2}{s_1}, \quad v = \frac{s_3}{s_1} \] This gives """
TURNED = r"\[ x \cos t + y \sin t = p \] \[ - x \sin t + y \cos t = q \] Hence "


@pytest.mark.parametrize(
    "latex",
    [
        MATRICES + r"\[ \vec{l'}^T\cdot\vec{p'} = \vec{l}^T\cdot\vec{p} \]",
        MATRICES
        + r"\[ (H\cdot\vec{p})^T\cdot M \cdot H\cdot\vec{p} = \vec{p}^T\cdot H^T\cdot M \cdot H\cdot\vec{p} \]",
        TRIANGLES + r"\[ s_1^2 = \frac{b^2}{1 + v^2 - 2v\cos(\beta)} \]",
        TRIANGLES
        + r"\[ s_1^2 = \frac{b^2}{1 + v^2 - 2v\cos(\beta)} \] \[ s_1^2 = \frac{c^2}{1 + u^2 - 2u\cos(\gamma)} \]",
        TURNED + r"\[ x = p \cos t - q \sin t \]",
        TURNED + r"\[ x^2 + y^2 = p^2 + q^2 \]",
    ],
)
def test_it_follows(latex: str) -> None:
    assert last(latex).verdict == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"Let $\vec f, \vec r$ be vectors. \[ w = \vec f \cdot \vec r \] \[ w = \vec f \vec r \]",
        MATRICES + r"\[ \vec{l'}^T\cdot\vec{p'} = \vec{p}^T\cdot H \cdot\vec{l} \]",
        TRIANGLES + r"\[ s_1^2 = \frac{b^2}{1 + v^2 + 2v\cos(\beta)} \]",
        TURNED + r"\[ x = p \cos t + q \sin t \]",
        TURNED + r"\[ x^2 = p^2 + q^2 \]",
        r"\[ a \cos s = p \] \[ a \sin t = q \] Hence \[ a^2 = p^2 + q^2 \]",
        r"""\section{One} Here $\mathbf u \in \mathbb{R}^3$ and $\mathbf v \in \mathbb{R}^3$.
        \[ A = \mathbf u \mathbf v^T \]
        \section{Two} Let \[ \mathbf y = A \mathbf x \] Hence \[ \mathbf x = A^{-1} \mathbf y \]""",
    ],
)
def test_it_does_not_follow(latex: str) -> None:
    assert last(latex).verdict != "follows"


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (
            r"v = \dv{x}{t} + \dv[2]{x}{t} + \pd{f}{x}",
            r"v = \frac{dx}{dt} + \frac{d^2x}{dt^2} + \frac{\partial f}{\partial x}",
        ),
        (r"a = \abs*{b} + \norm*{\vb*{c}} \half", r"a = |b| + \|\mathbf{c}\| \frac12"),
        (r"x = A\T b + A\inv C^{\T}", r"x = A^T b + A^{-1} C^T"),
        (r"a = \SI{3.5e-3}{\meter} + \num{2e3}", r"a = 3.5 \cdot 10^{-3} \mathrm{\meter} + 2 \cdot 10^3"),
        (r"a = \qty(b + c) \vu b", r"a = (b + c) \vu b"),
        (r"a \mathrel{\mathop:}= \lfloor b \times \rfloor c", r"a := [b]_\times c"),
        (
            r"\dot{\mathbf R} = \mathbf R \lfloor \mathbf w \times \rfloor",
            r"\dot{\mathbf R} = \mathbf R [\mathbf w]_\times",
        ),
        (r"T = \operatorname{p_{u 1}} \cos{u} + \operatorname{p_{u 2}}", r"T = p_{u 1} \cos{u} + p_{u 2}"),
        (
            r"a = \begin{dcases} b & c > 0 \\ d & c \le 0 \end{dcases}",
            r"a = \begin{cases} b & c > 0 \\ d & c \le 0 \end{cases}",
        ),
        (r"a = \begin{bmatrix*}[r] b \\ c \end{bmatrix*}", r"a = \begin{bmatrix} b \\ c \end{bmatrix}"),
        (r"x = \underset{y}{\operatorname{arg\,min}} f", r"x = \argmin_{y} f"),
        (r"R = {}^{W}\!R_{B}", r"R = {}^{W} R_{B}"),
    ],
)
def test_a_command_of_a_package_is_read_as_what_it_stands_for(latex: str, expected: str) -> None:
    one, other = (last(rf"\[ {each} \]").read for each in (latex, expected))
    assert one is not None
    assert one == other


def test_commands_that_a_document_defines_go_first() -> None:
    own = (
        r"\newcommand{\half}{h} \DeclarePairedDelimiter{\size}{\lVert}{\rVert} \NewDocumentCommand\twice{O{2} m}{#1 #2}"
    )
    assert last(own + r"\[ a = \half \size*{b} \twice{c} \twice[3]{d} \]").read == "a = h*norm(b)*2*c*3*d"


def test_the_size_of_zeros_and_of_an_identity_is_no_other_letter() -> None:
    turned = r"""Let $\mathbf{R}$ be a rotation matrix.
    \[ \mathbf T = \begin{bmatrix} \mathbf R & \mathbf t \\ \mathbf 0_{1\times 3} & 1 \end{bmatrix} \] Hence """
    inverse = r"\begin{bmatrix} \mathbf R^T & %s \mathbf R^T \mathbf t \\ \mathbf 0_{1\times 3} & 1 \end{bmatrix}"
    assert last(turned + rf"\[ \mathbf T^{{-1}} = {inverse % '-'} \]").verdict == "follows"
    assert last(turned + rf"\[ \mathbf T^{{-1}} = {inverse % ''} \]").verdict != "follows"
    assert last(turned + r"\[ \mathbf R \mathbf R^T = \mathbf{I}_3 \]").verdict == "follows"


MODEL = r"The point $(x, y)$ lies on the line \[ a x + b y + c = 0 \] "


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (MODEL + r"The measured one is \[ x = \bar x + \Delta x \]", "definition"),
        (MODEL + r"A scaled one is \[ x = \lambda u \]", "definition"),
        (MODEL + r"If \[ x = \lambda u \] it is seen.", "independent"),
        (MODEL + r"It is not true that \[ x = \lambda u \]", "independent"),
        (MODEL + r"We have \[ x = a b \]", "independent"),
        (MODEL + r"With \[ x = u \] and \[ x = u^2 \]", "independent"),
    ],
)
def test_an_equation_with_a_new_letter_says_what_it_is(latex: str, verdict: str) -> None:
    assert last(latex).verdict == verdict
