r"""Texts of photogrammetry as textbooks have them: what they derive follows, and not with a misprint.

The mark ``@`` stands before a bold letter, and ``|>`` before an equation that follows.
"""

import pytest
from textbooks import follow, plain, with_misprint

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")
DEPTH = r"""Let $B$ be the base and $c$ the principal distance. The image coordinates are \[ x' = c \frac{X}{Z}
\] \[ x''
= c \frac{X - B}{Z} \] The parallax is \[ p = x' - x''. \] Hence |>\[ Z = \frac{c B}{p} \] |>\[ X = \frac{B
x'}{p} \] By error propagation |>\[ \frac{\partial Z}{\partial p} = -\frac{c B}{p^2} \] |>\[ \frac{\partial
Z}{\partial p} = -\frac{Z^2}{c B} \]"""
COLLINEARITY = r"""Let $(X_0, Y_0)$ be the projection centre and $c$ the principal distance. Define \[ U =
r_{11} (X - X_0) +
r_{21} (Y - Y_0) \] \[ W = r_{13} (X - X_0) + r_{23} (Y - Y_0). \] The equation is \[ x = x_0 - c \frac{U}{W}.
\] The partial derivatives with respect to the projection centre are |>\[ \frac{\partial x}{\partial X_0} =
-\frac{c}{W^2} (r_{13} U - r_{11} W) \] and |>\[ \frac{\partial x}{\partial c} = -\frac{U}{W}. \] Solving for
the coordinates gives |>\[ X = X_0 - (Y - Y_0) \frac{r_{21} c + r_{23} (x - x_0)}{r_{11} c + r_{13} (x -
x_0)}. \]"""
ESSENTIAL = r"""Let $@R$ be a rotation and $@t$ the base vector. The points satisfy \[ @y = @R @x + @t. \]
Multiplying by
$[@t]_\times$ gives |>\[ [@t]_\times @y = [@t]_\times @R @x \] The essential matrix is \[ @E = [@t]_\times @R.
\] Hence |>\[ @y^\top @E @x = 0 \] |>\[ @E^\top @t = \mathbf{0} \] |>\[ \det @E = 0 \] |>\[ @E @E^\top =
(@t^\top @t) @I - @t @t^\top \] |>\[ \mathrm{tr}(@E @E^\top) = 2 @t^\top @t \] |>\[ @E @E^\top @E =
\frac{1}{2} \mathrm{tr}(@E @E^\top) @E \]"""
ADJUSTMENT = r"""The residuals \[ @v = @A @x - @l \] have the weight matrix $@P$, which is symmetric. We minimise \[ q =
@v^\top @P @v. \] Inserting gives |>\[ q = @x^\top @A^\top @P @A @x - 2 @x^\top @A^\top @P @l + @l^\top @P @l.
\] Its gradient is |>\[ \frac{\partial q}{\partial @x} = 2 @A^\top @P @A @x - 2 @A^\top @P @l. \] The
redundancy matrix \[ @Q = @I - @A (@A^\top @P @A)^{-1} @A^\top @P \] is idempotent, |>\[ @Q @Q = @Q. \]"""
ELLIPSOID = r"""The coordinates are \[ X = (N + h) \cos\varphi \cos\lambda \] \[ Y = (N + h) \cos\varphi
\sin\lambda. \] Hence
|>\[ \sqrt{X^2 + Y^2} = (N + h) \cos\varphi \] |>\[ \tan\lambda = \frac{Y}{X} \] |>\[ N = \frac{X}{\cos\varphi
\cos\lambda} - h. \]"""
THIN = r"""The observation equations are \[ v = A x - l \] with the symmetric weight matrix $P$. Inserting gives
|>\[ v^T P v = x^T A^T P A x - 2 x^T A^T P l + l^T P l. \] With $N = A^T P A$ and $n = A^T P l$ the
normal equations are \[ N x = n \] with the solution |>\[ x = N^{-1} n. \] Then |>\[ v^T P v = l^T P l -
n^T x. \]"""
LEAST_SQUARES = r"""The cost is |>\[ \|A x - b\|^2 = x^\top A^\top A x - 2 b^\top A x + b^\top b. \]"""
CAMERA = r"""The rotation matrix is \[ R = \begin{pmatrix} \cos\varphi \cos\kappa & -\cos\varphi \sin\kappa &
\sin\varphi \\ \cos\omega\sin\kappa + \sin\omega\sin\varphi\cos\kappa & \cos\omega\cos\kappa -
\sin\omega\sin\varphi\sin\kappa & -\sin\omega\cos\varphi \\ \sin\omega\sin\kappa -
\cos\omega\sin\varphi\cos\kappa & \sin\omega\cos\kappa + \cos\omega\sin\varphi\sin\kappa &
\cos\omega\cos\varphi \end{pmatrix}. \] Its elements satisfy |>\[ r_{11} r_{12} + r_{21} r_{22} + r_{31}
r_{32} = 0 \] and |>\[ r_{11} r_{22} - r_{12} r_{21} = r_{33}. \] The angles are |>\[ \varphi = \arcsin
r_{13} \] |>\[ \omega = \arctan\frac{-r_{23}}{r_{33}} \] |>\[ \kappa =
\arctan\left(-\frac{r_{12}}{r_{11}}\right). \]"""
TEXTS = {
    "thin": THIN,
    "least squares": LEAST_SQUARES,
    "camera": CAMERA,
    "depth": DEPTH,
    "collinearity": COLLINEARITY,
    "essential": ESSENTIAL,
    "adjustment": ADJUSTMENT,
    "ellipsoid": ELLIPSOID,
}
MISPRINTS = [
    ("thin", r"- 2 x^T A^T P l", r"- x^T A^T P l"),
    ("thin", r"l^T P l - n^T x", r"l^T P l + n^T x"),
    ("thin", r"x = N^{-1} n", r"x = N n"),
    ("least squares", r"- 2 b^\top A x", r"- 2 b A x"),
    ("camera", r"= r_{33}", r"= r_{31}"),
    ("camera", r"\arcsin r_{13}", r"\arccos r_{13}"),
    ("camera", r"\frac{-r_{23}}{r_{33}}", r"\frac{r_{23}}{r_{33}}"),
    ("depth", r"= -\frac{Z^2}{c B}", r"= \frac{Z^2}{c B}"),
    ("depth", r"X = \frac{B x'}{p}", r"X = \frac{B x''}{p}"),
    ("collinearity", "r_{13} U - r_{11} W)", "r_{13} U + r_{11} W)"),
    ("collinearity", r"\frac{r_{21} c +", r"\frac{r_{12} c +"),
    ("essential", r"= 2 @t^\top @t", r"= @t^\top @t"),
    ("essential", r"@I - @t @t^\top", r"@I + @t @t^\top"),
    ("essential", r"@E^\top @t = ", r"@E @t = "),
    ("adjustment", r"- 2 @x^\top", r"- @x^\top"),
    ("ellipsoid", r"= (N + h) \cos\varphi \]", r"= (N + h) \sin\varphi \]"),
    ("ellipsoid", r"\frac{Y}{X}", r"\frac{X}{Y}"),
]


def verdicts(text: str) -> list[str]:
    return [each.verdict for each in read_document(document_of(plain(text)))]


@pytest.mark.parametrize("name", TEXTS)
def test_what_a_textbook_derives_follows(name):
    found = verdicts(TEXTS[name])
    assert [each == "follows" for each in found] == follow(TEXTS[name]), found


@pytest.mark.parametrize(("name", "printed", "wrong"), MISPRINTS)
def test_no_misprint_of_a_textbook_follows(name, printed, wrong):
    text, place = with_misprint(TEXTS[name], printed, wrong)
    assert verdicts(text)[place] != "follows"


@pytest.mark.parametrize(
    "text",
    [
        r"\[ x + y = 1 \] \[ p = 2 x + a y \] Hence \[ \frac{\partial x}{\partial p} = \frac{1}{2}. \]",
        r"\[ p = 2 x + a y, \quad y = 3 x. \] Hence \[ \frac{\partial x}{\partial p} = \frac{1}{2}. \]",
        r"\[ p = 2 x + a(x). \] Hence \[ \frac{\partial x}{\partial p} = \frac{1}{2}. \]",
        r"\[ p = k x, \qquad \frac{dk}{dx} = c. \] Hence \[ \frac{\partial x}{\partial p} = \frac{1}{k}. \]",
        r"\[ p = k x. \] Hence \[ \frac{dx}{dp} = \frac{1}{k}. \]",
    ],
)
def test_nothing_follows_by_an_inverse_where_more_depends_on_the_letter(text):
    assert read_document(document_of(text))[-1].verdict != "follows"


def test_an_inverse_names_what_does_not_change():
    *_, last = read_document(
        document_of(r"\[ d = \frac{f b}{Z} \] Hence \[ \frac{\partial Z}{\partial d} = -\frac{Z^2}{f b}. \]")
    )
    assert last.links[0].rests_on == ("line 1", "the derivative of line 1, where b, f do not change")


def test_an_angle_is_no_rotation():
    text = r"Turned by the rotation $\Omega$ we have \[ y = \Omega x. \] Hence \[ \Omega^T y = x. \]"
    assert read_document(document_of(text))[-1].verdict != "follows"


def test_hypotheses_have_the_functions_of_the_text():
    text = (
        r"\[ X = (N + h) \cos\varphi \] \[ p = X + b N, \quad q = X - b N \] Hence "
        r"\[ N = \frac{p - q}{2 b}, \quad h = \frac{p + q}{2 \cos\varphi} - \frac{p - q}{2 b}. \]"
    )
    hypotheses = [name for each in read_document(document_of(text)) for link in each.links for name in link.hypotheses]
    assert any("cos(varphi)" in each for each in hypotheses)
    assert not any("whole" in each for each in hypotheses)
