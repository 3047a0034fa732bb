"""Documents on cameras: the signs that they use, and what several of their equations say together."""

from __future__ import annotations

import pytest

from algebroproj_sym.reading import Reading, document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")


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
    ],
)
def test_it_does_not_follow(latex: str) -> None:
    assert last(latex).verdict != "follows"


OTHER_SIZE = r"""\section{Introduction} The matrix is \[ H = K \left[R | T\right] \] where $R$ is a rotation, $T$ a vector.
\section{Lines} Let $C$ be a symmetric matrix. \[ l = C x \] \[ x' = H x \] \[ l' = H^{-T} l \] \[ C' = H^{-T} C H^{-1} \] """


def test_a_section_may_use_a_letter_with_another_size() -> None:
    assert last(OTHER_SIZE + r"Hence \[ C' x' = l' \]").verdict == "follows"
    assert last(OTHER_SIZE + r"Hence \[ C' x' = l \]").verdict != "follows"
