"""Notations of documents: each is read, and what nothing computes is shown, and never decided."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")


def read(latex, **options):
    return [each.read for each in read_document(document_of(latex, **options))]


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"p(y|x) = p(x|y) p(y)/p(x)", ["p_y_x = p_x_y*p(y)/p(x)"]),
        (r"\mathrm{Pr}(X < a) = \frac12", ["Pr_X_a = 1/2"]),
        (r"y = \left\lbrace y_1, \ldots, y_n \right\rbrace", [r"y = [\lbrace y_1, \ldots, y_n \right\rbrace]"]),
        (r"s = x_1 + \cdots + x_n", [r"s = x_1 + [\cdots] + x_n"]),
        (r"s = x_1 + ... + x_n", [r"s = x_1 + [\ldots] + x_n"]),
        (r"a \overset{(3)}{=} b \stackrel{\text{def}}{=} c", ["a = b := c"]),
        (r"w = 1 - \mbox{$\displaystyle\frac{a}{b}$} \hskip 3mm [10^{-6}/\mbox{MPa}]", ["w = 1 - a/b"]),
        (r"w = \underbrace{a + b}_{\text{both}} c", ["w = (a + b)*c"]),
        (r"f = \left\{ \begin{array}{ll} 0 & \mbox{if $x<0$} \\ x & \mbox{else} \end{array} \right.", None),
        (r"\begin{cases} x = r \cos t \\ y = r \sin t \end{cases}", ["x = r*cos(t)", "y = r*sin(t)"]),
        (r"\left\{ \begin{array}{l} x = 2 r \\ y = r \end{array} \right.", ["x = 2*r", "y = r"]),
        (r"a = b \\ \Rightarrow \\ c = d", ["a = b", "c = d"]),
        (r"a = b \Leftrightarrow c = d", ["a = b", "c = d"]),
        (r"\vector{v} = \uvec{u}_r r", ["v = uvec_u_r*r"]),
        (r"m = \inner{x}{y}", [r"m = [\inner{x}{y}]"]),
        (r"\exp : \mathfrak{so}(3) \mapsto SO(3)", [r"[\exp : \mathfrak{so}(3)] → [SO(3)]"]),
        (r"\left. \frac{\partial f}{\partial x} \right|_{x=0} = c", ["(partialf_partialx)_at_x=0 = c"]),
        (r"a = {\displaystyle\sum_{i=1}^3} b_i^2", [r"a = [\sum_{i=1}^{3}](b_i**2)"]),
        (r"a = \sum_i \sum_j -2 b_{ij}", [r"a = [\sum_{i}]([\sum_{j}](-2*b_ij))"]),
        (r"a = \int | b + c |^2 dx", [r"a = [\int](Abs(b + c)**2*d_x)"]),
        (r"l = \log \prod_i p_i", [r"l = log([\prod_{i}](p_i))"]),
        (r"k = a ++ 1. + b", ["k = a + 1 + b"]),
        (r"y = α² + β · 30°", ["y = alpha**2 + beta*30*pi/180"]),
        (r"(A B)' = C", ["(A*B)_prime = C"]),
        (r"p \oplus q = \ominus r", [r"p o q = [\ominus]*r"]),
    ],
)
def test_a_notation_is_read(latex, expected):
    found = read(rf"\begin{{align}} {latex} \end{{align}}")
    assert None not in found
    assert expected in (None, found)


@pytest.mark.parametrize(
    "latex",
    [
        r"1 + x + \cdots = 1 - x + \cdots",
        r"1 + \cdots + x = x + \cdots + 1",
        r"(1, \ldots, n) = (1, \ldots, n)",
        r"\{x | x > 0\} = \{x | x > 0\}",
        r"\inv{A} \inv{B} = \inv{B} \inv{A}",
        r"\phi_0 \oplus b = \phi_0 \otimes b",
    ],
)
def test_what_is_shown_only_is_never_decided(latex):
    (found,) = read_document(document_of(rf"\[ {latex} \]"))
    assert found.verdict in ("not decided", "independent")


def test_blocks_of_code_are_formulas_where_they_say_so():
    text = "A\n```math\na = b\n```\nand\n```{math}\n:label: two\nc = d\n```\nand\n```python\ne = f\n```\n"
    found = read_document(document_of(text, latex=False))
    assert [(each.line, each.number, each.read) for each in found] == [(2, "", "a = b"), (6, "two", "c = d")]


def test_blocks_of_code_that_do_not_close_end_within_bounds():
    assert read_document(document_of("```math\n" * 20_000, latex=False)) == []
