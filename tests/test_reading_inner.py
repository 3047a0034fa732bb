r"""Inner products ``\langle f, g \rangle``: they are linear in each vector, and no products of numbers or matrices."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

LINE = (
    r"The parameters have \[ (z - (z^T \mathbb{1} - b x^T \mathbb{1}) \mathbb{1} - b x)^T x = 0 \] "
    r"\[ z^T x - (z^T \mathbb{1} - b x^T \mathbb{1}) \mathbb{1}^T x - b x^T x = 0 \] Hence "
)
CENTRED = (
    r"The mean is \[ m = \frac1n \mathbf{1}^T \mathbf x \] and "
    r"\[ \mathbf C = \mathbf I - \frac1n \mathbf 1 \mathbf 1^T \] Hence "
)
BELOW = r"{x^T x - (\mathbb{1}^T x)^2} \]"
FOLLOWS = {
    "a line through points": LINE + r"\[ b = \frac{z^T x - (x^T \mathbb{1}) (z^T \mathbb{1})}" + BELOW,
    "the centring matrix": CENTRED + r"\[ \mathbf C \mathbf x = \mathbf x - m \mathbf 1 \]",
    "the coefficient of a projection": (
        r"The inner product is zero, as the rest is orthogonal: \[ \langle x, f - c x \rangle = 0 \] so by linearity "
        r"\[ \langle x, f \rangle - c \langle x, x \rangle = 0 \] Hence "
        r"\[ c = \frac{\langle x, f \rangle}{\langle x, x \rangle} \]"
    ),
    "of arrows": (
        r"Here we have \[ \langle \vec u, \vec f - c_k \vec u \rangle = 0 \] Hence "
        r"\[ c_k = \frac{\langle \vec u, \vec f \rangle}{\langle \vec u, \vec u \rangle} \]"
    ),
    "the square of a sum": (
        r"With the scalar product we have \[ \langle a + b, a + b \rangle = \langle a, a \rangle "
        r"+ 2 \langle a, b \rangle + \langle b, b \rangle \]"
    ),
    "the projection on a line": (
        r"The rest is orthogonal to \[ \mathbf p = c \mathbf a \] so that \[ \mathbf a^T (\mathbf b - c \mathbf a) "
        r"= 0 \] Hence \[ c = \frac{\mathbf a^T \mathbf b}{\mathbf a^T \mathbf a} \]"
    ),
    "a number between rows and columns": (
        r"We have \[ \mathbf u^T \mathbf A \mathbf u s + \mathbf u^T \mathbf b = 0 \] so \[ "
        r"s = -\frac{\mathbf u^T \mathbf b}{\mathbf u^T \mathbf A \mathbf u} \]"
    ),
    "a transpose": r"\[ \langle \mathbf A \mathbf x, \mathbf y \rangle = \mathbf x^T \mathbf A^T \mathbf y \]",
    "of matrices": r"\[ \langle \mathbf A, \mathbf B \rangle = \mathrm{tr}(\mathbf A^T \mathbf B) \]",
}
MISLEADING = {
    "a line with a wrong sign": LINE + r"\[ b = \frac{z^T x + (x^T \mathbb{1}) (z^T \mathbb{1})}" + BELOW,
    "a sum with a row": (r"We have \[ f = x^T \mathbf{1} + g \] and the matrix $g$. Hence \[ g = g^T \]"),
    "a column of numbers": LINE
    + r"\[ b = \frac{x^T x - (\mathbb{1}^T x)^2}{z^T x - (x^T \mathbb{1}) (z^T \mathbb{1})} \]",
    "ones are not one": CENTRED + r"\[ \mathbf 1^T \mathbf 1 = 1 \]",
    "a row of ones": CENTRED + r"\[ \mathbf C \mathbf x = \mathbf x - m \mathbf 1^T \]",
    "ones are no identity": CENTRED + r"\[ \mathbf C \mathbf x = \mathbf x - \frac1n \mathbf x \]",
    "Cauchy and Schwarz": (
        r"The inner product has \[ \langle f, g \rangle^2 = \langle f, f \rangle \langle g, g \rangle \]"
    ),
    "without words": r"\[ \langle f, g \rangle^2 = \langle f, f \rangle \langle g, g \rangle \]",
    "a pair": r"A pair is \[ \langle a, b \rangle = \langle b, a \rangle \]",
    "no product of matrices": r"Here $A$ and $B$ are matrices. \[ \langle A, B \rangle = A B \]",
    "no product of bold matrices": r"\[ \langle \mathbf A, \mathbf B \rangle = \mathbf A \mathbf B \]",
    "given otherwise": (
        r"The inner product is \[ \langle \mathbf x, \mathbf y \rangle := \mathbf x^T M \mathbf y \] Hence "
        r"\[ \langle \mathbf x, \mathbf y \rangle = \mathbf x^T \mathbf y \]"
    ),
    "given otherwise behind it": (
        r"The inner product has \[ \langle A x, y \rangle = \langle x, A^T y \rangle \] where "
        r"\[ \langle x, y \rangle = x^T M y \]"
    ),
    "complex vectors": (r"For complex vectors the inner product has \[ \langle a, b \rangle = \langle b, a \rangle \]"),
    "complex signals": r"The inner product of complex signals is \[ \langle x, c y \rangle = c \langle x, y \rangle \]",
    "orthogonal vectors": (
        r"We have \[ \mathbf a^T (\mathbf b - c \mathbf d) = 0 \] for orthogonal $\mathbf a$ and $\mathbf d$. Hence "
        r"\[ c = \frac{\mathbf a^T \mathbf b}{\mathbf a^T \mathbf d} \]"
    ),
    "vectors that are perpendicular": (
        r"The vector $x$ is perpendicular to $y$. The inner product has \[ \langle x, f - c y \rangle = 0 \] Hence "
        r"\[ c = \frac{\langle x, f \rangle}{\langle x, y \rangle} \]"
    ),
    "an associative product": (r"The scalar product has \[ \langle a, b \rangle c = a \langle b, c \rangle \]"),
    "a number times a matrix": r"\[ c \mathbf A \mathbf b = \mathbf d \] Hence \[ c = \mathbf A^{-1} \mathbf d \]",
    "conjugated": (r"The inner product is conjugate symmetric. \[ \langle c a, b \rangle = c \langle a, b \rangle \]"),
    "a wrong sign": (
        r"The inner product is zero: \[ \langle x, f - c x \rangle = 0 \] Hence "
        r"\[ c = -\frac{\langle x, f \rangle}{\langle x, x \rangle} \]"
    ),
    "the other vector below": (
        r"The inner product is zero: \[ \langle x, f - c x \rangle = 0 \] Hence "
        r"\[ c = \frac{\langle x, f \rangle}{\langle f, f \rangle} \]"
    ),
    "functions with arguments": (
        r"The inner product of functions such as $f(t)$ and $g(t)$ has \[ \langle f, g \rangle = f g \]"
    ),
    "no factor of numbers": r"The dot product has \[ \langle a b, c \rangle = \langle b a, c \rangle \]",
    "a factor that is zero": (
        r"We have \[ c \mathbf a^T \mathbf b - c \mathbf b^T \mathbf a = d \] Hence \[ c = 2 d \]"
    ),
    "a factor that is zero, and a sum": (
        r"We have \[ c (\mathbf a^T \mathbf b - \mathbf b^T \mathbf a) = d + 1 \] Hence \[ c + d = c \]"
    ),
    "an equation of vectors has no quotient": (
        r"We have \[ c \mathbf a = \mathbf b \] Hence \[ c = \frac{\mathbf a^T \mathbf b}{\mathbf b^T \mathbf b} \]"
    ),
    "a choice": (r"We have \[ c (c - \mathbf a^T \mathbf b) = 0 \] Hence \[ c = \mathbf a^T \mathbf b \]"),
    "two factors that may be zero": (
        r"We have \[ (\mathbf a^T \mathbf b - c) (\mathbf a^T \mathbf d - s) = 0 \] Hence "
        r"\[ c = \mathbf a^T \mathbf b \]"
    ),
    "a commutator": r"Here $A$ and $B$ commute. \[ \langle A, B \rangle = \langle B, A \rangle + A \]",
}


@pytest.mark.parametrize("document", FOLLOWS.values(), ids=FOLLOWS)
def test_follows(document):
    assert read_document(document_of(document))[-1].verdict == "follows"


@pytest.mark.parametrize("document", MISLEADING.values(), ids=MISLEADING)
def test_does_not_follow(document):
    assert read_document(document_of(document))[-1].verdict not in ("follows", "contradicts")
