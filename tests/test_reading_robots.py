r"""Texts on cameras, on motion and on robots as textbooks have them: what they derive follows, and not with a misprint.

The mark ``@`` stands before a bold letter, and ``|>`` before an equation that follows.
"""

import pytest
from textbooks import follow, plain, with_misprint

from algebroproj_sym.reading import document_of, read_document

SPATIAL = r"""Let $E$ be a rotation matrix and $r$ the position vector. Motion vectors are transformed by
\[ X = \begin{bmatrix} E & 0 \\ 0 & E \end{bmatrix} \begin{bmatrix} 1 & 0 \\ -r\times & 1 \end{bmatrix} \] or
\[ Y = \begin{bmatrix} E & 0 \\ -E\, r\times & E \end{bmatrix}. \] Its inverse is |>\[ Y^{-1} =
\begin{bmatrix} E^{\mathrm T} & 0 \\ r\times E^{\mathrm T} & E^{\mathrm T} \end{bmatrix}. \]"""
INERTIA = r"""The angular momentum is \[ @h = @J @\omega + m @c \times @v + m @c \times (@\omega \times @c). \]
With the rotational inertia \[ @K = @J - m (@c\times)(@c\times) \] we have |>\[ @h = @K @\omega + m @c \times
@v. \]"""
AXIS = r"""With \[ @C = \cos\phi \, @1 + (1 - \cos\phi) @a @a^T + \sin\phi \, @a^\wedge, \] where $@a$ is the unit
axis, we have |>\[ @C = @1 + \sin\phi \, @a^\wedge + (1 - \cos\phi) @a^\wedge @a^\wedge. \] Taking the trace we
obtain |>\[ \operatorname{tr}(@C) = 2 \cos\phi + 1. \]"""
STEP = r"""The cost of a step is \[ f(\Delta @x) = \frac{1}{2} (@e + @J \Delta @x)^\top @W (@e + @J \Delta @x). \]
Since $@W$ is symmetric, its gradient is |>\[ \frac{\partial f}{\partial \Delta @x} = @J^\top @W @J \Delta @x +
@J^\top @W @e. \]"""
DEPTH = r"""The depth minimizes \[ J(s) = \|s @a + @b\|^2. \] Its derivative is |>\[ \frac{\partial J}{\partial s} =
2 s @a^\top @a + 2 @a^\top @b. \]"""
FILTER = r"""The gain is \[ @K = @P_{k+1|k} @H^\top @S^{-1} \] and the covariance \[ @P_{k+1|k+1} = (@I - @K @H)
@P_{k+1|k}. \] Substituting the gain, |>\[ @P_{k+1|k+1} = @P_{k+1|k} - @P_{k+1|k} @H^\top @S^{-1} @H
@P_{k+1|k}. \]"""
CART = r"""The masses $M$, $m$ and the length $l$ are constant. The Lagrangian is \[ L = \frac12 (M + m) \dot x^2 +
m l \dot x \dot\theta \cos\theta + \frac12 m l^2 \dot\theta^2 - m g l \cos\theta. \] Its derivatives are |>\[
\frac{\partial L}{\partial \dot x} = (M + m) \dot x + m l \dot\theta \cos\theta \] |>\[ \frac{\partial
L}{\partial \theta} = -m l \dot x \dot\theta \sin\theta + m g l \sin\theta \] and |>\[ \frac{\partial
L}{\partial x} = 0. \] With the momentum \[ P = (M + m) \dot x + m l \dot\theta \cos\theta \] we have |>\[ \dot
P = (M + m) \ddot x + m l \ddot\theta \cos\theta - m l \dot\theta^2 \sin\theta. \] The other equation of motion
is \[ m l \ddot x \cos\theta + m l^2 \ddot\theta - m g l \sin\theta = 0. \]"""
VIEWS = r"""A point $P = (X, Y, Z)^T$ has in the camera the coordinates \[ P_c = R P + t \] where $R$ is a rotation
matrix and $t$ the translation vector. For two cameras we have \[ P_2 = R P_1 + t. \] Taking the cross product with
$t$, |>\[ t \times P_2 = t \times R P_1, \] and the dot product with $P_2$, |>\[ P_2^T (t \times R P_1) = 0. \] With the
essential matrix \[ E = [t]_\times R \] this is |>\[ P_2^T E P_1 = 0. \]"""
TEXTS = {
    "views": VIEWS,
    "spatial": SPATIAL,
    "inertia": INERTIA,
    "axis": AXIS,
    "step": STEP,
    "depth": DEPTH,
    "filter": FILTER,
    "cart": CART,
}
MISPRINTS = [
    ("views", r"P_2^T (t", r"P_1^T (t"),
    ("views", r"P_2^T E P_1", r"P_1^T E P_2"),
    ("views", r"R P_1, \]", r"P_1, \]"),
    ("spatial", r"r\times E^{\mathrm T} &", r"-r\times E^{\mathrm T} &"),
    ("inertia", r"@K @\omega + m", r"@K @\omega - m"),
    ("axis", r"@1 + \sin\phi", r"@1 - \sin\phi"),
    ("axis", r"2 \cos\phi + 1", r"3 \cos\phi + 1"),
    ("step", r"\Delta @x + @J^\top", r"\Delta @x - @J^\top"),
    ("depth", r"= 2 s @a^\top", r"= s @a^\top"),
    ("filter", r"= @P_{k+1|k} - @P", r"= @P_{k+1|k} + @P"),
    ("cart", r"= -m l \dot x \dot\theta \sin", r"= m l \dot x \dot\theta \sin"),
    ("cart", r"- m l \dot\theta^2 \sin", r"+ m l \dot\theta^2 \sin"),
]
BENEATH = r"""Let $@R$ be a rotation matrix.

\[ @v = @u + @g s + @R @d \]

\[ @p = @q + @u s + \frac12 @g s^2 + @R @e \]

Hence \[ @d = @R^\top (@v - @u + @g s). \]

Likewise \[ @e = @R^\top (@p - @q - @u s - @g s^2). \]"""


def verdicts(text):
    return [each.verdict for each in read_document(document_of(plain(text)))]


@pytest.mark.usefixtures("verdicts_alone")
@pytest.mark.parametrize("name", TEXTS)
def test_what_a_textbook_derives_follows(name):
    found = verdicts(TEXTS[name])
    assert [each == "follows" for each in found] == follow(TEXTS[name]), found
    assert "contradicts" not in found


@pytest.mark.usefixtures("verdicts_alone")
@pytest.mark.parametrize(("name", "printed", "wrong"), MISPRINTS)
def test_no_misprint_of_a_textbook_follows(name, printed, wrong):
    text, place = with_misprint(TEXTS[name], printed, wrong)
    assert verdicts(text)[place] != "follows"


@pytest.mark.usefixtures("verdicts_alone")
@pytest.mark.parametrize(
    "text",
    [
        r"\[ y - x^2 = 0 \] \[ L = \frac12 m \dot x^2 - k y \] \[ \frac{\partial L}{\partial \dot x} = m \dot x \] "
        r"Hence \[ \frac{\partial L}{\partial x} = 0. \]",
        r"\[ L = \frac12 m \dot x^2 - k x \] \[ \frac{\partial L}{\partial \dot x} = m \dot x \] "
        r"Hence \[ \frac{\partial L}{\partial x} = 0. \]",
        r"\[ L = \frac12 m \dot x^2 \] \[ \frac{\partial L}{\partial \dot x} = m \dot x \] "
        r"Hence \[ \frac{\partial L}{\partial y} = 0. \]",
        r"\[ @a = s @c \] \[ J(s) = \|s @a + @b\|^2 \] Hence "
        r"\[ \frac{\partial J}{\partial s} = 2 s @a^\top @a + 2 @a^\top @b. \]",
        r"\[ @y = @1^\top @x \] \[ @K = @A - @1 @x^\top \] Hence \[ @K + @x^\top = @A. \]",
        r"\[ @w = @1 + @x \] Hence \[ @w^\top @w = @1 + 2 @x + @x^\top @x. \]",
        r"The mass $m$ and the thrust $F$ are constant, and the length $l$ is not. \[ p = m l \] Hence "
        r"\[ \dot p = 0. \]",
        r"Let $@a$ be an axis. \[ @C = @a @a^\top \] Hence \[ @C @a = @a. \]",
        r"\[ @M = \begin{bmatrix} @a\times & @b \end{bmatrix} \] Hence \[ @M = \begin{bmatrix} @b & @a\times "
        r"\end{bmatrix}. \]",
        r"\[ L = \frac12 m \dot x^2 - V \] where $V$ is the potential. "
        r"\[ \frac{\partial L}{\partial \dot x} = m \dot x \] Hence \[ \frac{\partial L}{\partial x} = 0. \]",
        r"\[ y = x^2 \] \[ T = \frac12 m (\dot x^2 + \dot y^2) \] \[ \frac{\partial T}{\partial \dot x} = m \dot x \] "
        r"Hence \[ \frac{\partial T}{\partial x} = 0. \]",
        r"A stochastic matrix has \[ P @1 = @1 \] Hence \[ P = @1. \]",
        r"A stochastic matrix has \[ P @1 = @1 \] Hence \[ P @x = @x. \]",
        r"\[ D = a_{i|j} b^i \] Hence \[ D = a_{j|i} b^j. \]",
    ],
)
def test_what_is_not_so_does_not_follow(text):
    assert verdicts(text)[-1] not in ("follows", "contradicts")


@pytest.mark.usefixtures("decided_here")
def test_what_rests_on_a_misprint_and_on_what_it_is_a_misprint_of_does_not_follow():
    assert "follows" not in verdicts(BENEATH)
    right = BENEATH.replace("- @u + @g s)", "- @u - @g s)").replace(r"- @g s^2)", r"- \frac12 @g s^2)")
    assert verdicts(right)[-2:] == ["follows", "follows"]


PROJECTOR = r"""The inertia is \[ @L = (@J @M^{-1} @J^\top)^{-1} \] and the inverse \[ @G = @M^{-1} @J^\top @L. \] It
satisfies \[ @J @G = @I. \] The projector is \[ @N = @I - @G @J \] and it holds that \[ @N @N = 2 @N. \]"""


@pytest.mark.usefixtures("verdicts_alone")
@pytest.mark.parametrize(
    "words",
    [
        "",
        "Since $@M$ is invertible, we proceed.",
        "The matrices $@M$ and $@W$ are square.",
        "The square root of $d$ is the scale.",
        "The square matrix $@M$ has full rank.",
        "$@J$ has full rank.",
        "Since $@J$ is not square, we proceed.",
        "$@J$ is invertible only if it is square.",
        "Let $@J$ be a matrix. The non-singular matrix $@M$ weights.",
        "The square of $@J$ is large.",
    ],
)
def test_a_letter_that_words_call_invertible_is_that_letter_alone(words):
    assert verdicts(f"{words} {PROJECTOR}")[-1] != "follows"


@pytest.mark.usefixtures("verdicts_alone")
@pytest.mark.parametrize(
    "words",
    ["The matrix $@J$ is invertible.", "Let $@M$ and $@J$ be square.", "For a square matrix $@J$ all is simple."],
)
def test_what_words_call_invertible_is_square(words):
    assert verdicts(f"{words} {PROJECTOR.replace('@N @N = 2 @N', '@N = @0')}")[-1] == "follows"


@pytest.mark.usefixtures("verdicts_alone")
@pytest.mark.parametrize(
    ("claim", "follows"),
    [
        (r"@p^T @t \times @p = 0", True),
        (r"@p^T \cdot @t \times @p = 0", True),
        (r"@p \cdot @t \times @p = 0", True),
        (r"@p \cdot @t \times @q = @p \times @t \cdot @q", True),
        (r"c @p^T @t \times @R @q = c @p^T [@t]_\times @R @q", True),
        (r"@p^T @t \times @q = @p^T @q \times @t", False),
        (r"@p \cdot @t \times @q = @p \cdot @q \times @t", False),
        (r"@R^T @t \times @p = @R^T (@t \times @p)", False),
        (r"@R @t \times @p = @R (@t \times @p)", False),
        (r"@p^T @t \times @q = (@p \times @t) @q", False),
    ],
)
def test_a_cross_goes_before_the_row_or_the_point_before_it(claim, follows):
    assert (verdicts(rf"It holds that \[ {claim}. \]")[-1] == "follows") is follows


@pytest.mark.usefixtures("verdicts_alone")
def test_printed_vectors_have_a_triple_product():
    text = r"Let \[ @a = \begin{pmatrix} x \\ y \\ 0 \end{pmatrix}, @b = \begin{pmatrix} 0 \\ z \\ 1 \end{pmatrix}. \]"
    assert verdicts(rf"{text} Hence \[ @b \cdot @a \times @b = 0. \]")[-1] == "follows"
    assert verdicts(rf"{text} Hence \[ @b \cdot @a \times @b = x. \]")[-1] != "follows"
