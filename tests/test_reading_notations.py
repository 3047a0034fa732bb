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
        (r"\begin{matrix} x = a & y = b \\ u = c & v = d \end{matrix}", ["x = a", "y = b", "u = c", "v = d"]),
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
        ("ε = x̂ - ẋ + v⃗", ["varepsilon = x_hat - x_dot + v_vec"]),
        (r"s = 4\ \text{sinc}^2(a x)", ["s = 4*sinc(a*x)**2"]),
        (r"p = \int q(u) \text{d} u", [r"p = [\int](q(u)*d_u)"]),
        (r"\text{recall}_{n} = \frac{a}{b}", ["recall_n = a/b"]),
        (r"b = \delta (m + n)", ["b = delta(m + n)"]),
        (r"b = \delta (m + n), \quad a = \frac{b}{\delta}", ["b = delta*(m + n)", "a = b/delta"]),
        (r"(A B)' = C", ["(A*B)_prime = C"]),
        (r"p \oplus q = \ominus r", [r"p o q = [\ominus]*r"]),
        (r"h = \left.v\right)_0 r", ["h = v_at_0*r"]),
        (r"a = b \left[ c - \right. \\ &\hphantom{=} \quad \left. d \right]", ["a = b*(c - d)"]),
        (r"a = b{+}c {-} d", ["a = b + c - d"]),
        (r"x^{+} = \left| x - 1 \right| + \left\lvert y \right\lvert", ["x_plus = Abs(x - 1) + Abs(y)"]),
        (r"y = \ln\left| x \right| + \sin \lvert x \rvert", ["y = log(Abs(x)) + sin(Abs(x))"]),
        (r"\text{Pr}(\text{yes}|A) \times \text{Pr}(A) = c", ["Pr_textyes_A x Pr(A) = c"]),
        (r"n = \left\lfloor x \right\rfloor + \lceil y \rceil", ["n = floor(x) + ceil(y)"]),
        (r"\operatorname{Re} z = \Re z = c", ["Re(z) = Re(z) = c"]),
        (r"\mathrm{Re} = v d", ["Re = v*d"]),
        (r"C = \mathrm{KL} \left[ p(t|y) \, || \, p(t|m) \right]", ["C = KL_p_t_y_p_t_m"]),
        (r"F = \begin{pmatrix} x, & y \end{pmatrix}", ["F = [[x, y]]"]),
        (r"a = \begin{matrix} \end{matrix}", ["a = [[]]"]),
        (r"\mathrm{E_}(X) = a", ["E(X) = a"]),
        (r"T^{n+1,k} = \zeta_0^{\ell,0} + U^{\ast\ast}", ["T_nplus1_k = zeta_0_ell_0 + U_astast"]),
        (r"Mean(x) = a + SS_{\text{Total}}", ["Mean(x) = a + S*S_Total"]),
        (r"SS_{\text{Total}} = a", ["SS_Total = a"]),
        (r"AA^T = C", ["A*A.T = C"]),
        (r"\text{start}_{j} + \text{due}_{j} = c", ["start_j + due_j = c"]),
        (r"V = A^{k^\prime}", ["V = Ap**k"]),
        (r"a = \\ = b == c", ["a = b = c"]),
        (r"a = b . \avoidbreak", ["a = b"]),
        (r"a &= b && c &= d", ["a = b", "c = d"]),
        (r"m a &= b - c & & = d", ["m*a = b - c = d"]),
        (r"\begin{cases} x & = & 2 r \\ y & = & r \\ \end{cases}", ["x = 2*r", "y = r"]),
        (r"\left\{ \begin{array}{l} x=s \\ y=2 \end{array} , \ 0 \le s \right.", ["x = s", "y = 2", "0 <= s"]),
        (r"m = \begin{cases} \left\lbrace 0, 1 \right\rbrace , & x < 1 \\ 1 & x > 1 \end{cases}", None),
        (r"y = \nicefrac{1}{2}", ["y = 1/2"]),
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
        r"\lfloor x \rfloor = x",
        r"\left\lceil x + y \right\rceil = \lceil x \rceil + \lceil y \rceil",
        r"\Re (x y) = \Re x \Re y",
        r"\operatorname{Im} z = 0",
        r"\left. f \right)_0 - \left. f \right)_1 = 0",
        r"\left. f \right|_{x=0} - f = 0",
        r"2 p\left( y \left| x \right. \right) = 2 p\left( x \left| y \right. \right)",
    ],
)
def test_what_is_shown_only_is_never_decided(latex):
    (found,) = read_document(document_of(rf"\[ {latex} \]"))
    assert found.verdict in ("not decided", "independent")


def test_blocks_of_code_are_formulas_where_they_say_so():
    text = "A\n```math\na = b\n```\nand\n```{math}\n:label: two\nc = d\n```\nand\n```python\ne = f\n```\n"
    found = read_document(document_of(text, latex=False))
    assert [(each.line, each.number, each.read) for each in found] == [(2, "", "a = b"), (6, "two", "c = d")]


def test_markdown_may_take_a_backslash_of_a_line_break_away():
    found = read_document(document_of("$$ a = b + c \\\\\\\n = d - e $$", latex=False))
    assert [each.read for each in found] == ["a = b + c = d - e"]


def test_tags_of_html_are_no_words():
    text = '## Sums\n<span class="no">\n\n$$ a = b + c $$\n</span>\n\nThus <p>\n\n$$ a^2 = b^2 + 2 b c + c^2 $$\n'
    found = read_document(document_of(text, latex=False))
    assert found[-1].verdict == "follows"
    assert "class" not in found[-1].statement.display.before


def test_blocks_of_code_that_do_not_close_end_within_bounds():
    assert read_document(document_of("```math\n" * 20_000, latex=False)) == []


def test_a_display_that_begins_with_a_relation_goes_on_with_the_one_before_it():
    found = read_document(document_of(r"\[ a = b + c \] \[ = c + b \] So \[ = d \] \section{Next} Here \[ = e \]"))
    assert [each.read for each in found] == ["a = b + c", "b + c = c + b", "c + b = d", None]


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ H_0: \; \mu = m \] \[ \mu - m = 0 \]",
        r"\[ H_0: \quad \mu = m \] \[ 2 \mu = 2 m \]",
        r"\[ x \ge 0 : \quad y = x \] \[ y - x = 0 \]",
        r"\[ A : \; y = x, \quad z = x \] \[ z - x = 0 \]",
        r"\[ \text{Case 1:} \quad y = x \] \[ 2 y = 2 x \]",
        r"\[ \text{If } b = 0: \quad y = x \] \[ 2 y = 2 x \]",
        r"\[ \text{If } b = 0, \quad y = x \] \[ 2 b y = 0 \]",
        r"\[ \text{Suppose } y = x \] \[ 2 y = 2 x \]",
        r"\begin{align} \text{for } t > 0 && y &= x \\ \text{otherwise} && y &= -x \end{align} \[ 2 y = 2 x \]",
        r"For small $x$ we have \[ y = x. \] \section{Other} \[ 2 y = 2 x. \]",
        r"\[ x = y \text{ if } t > 0 \] \[ = z \] \[ x - z = 0 \]",
        r"\[ x = y \text{ Only}(t = 0) \] \[ x - y = 0 \]",
        r"\[ a = b \\% \quad = c" "\n" r"\] \[ a - c = 0 \]",
    ],
)
def test_an_equation_with_a_name_or_a_condition_is_no_premise(latex):
    assert read_document(document_of(latex))[-1].verdict not in ("follows", "contradicts")


def test_a_comment_in_a_formula_says_nothing():
    text = "$$ a = b \\\\ % = c\n d = e $$"
    assert [each.read for each in read_document(document_of(text, latex=False))] == ["a = b", "d = e"]
    assert read("\\begin{align} a &= b \\\\% c\n d &= e \\end{align}") == ["a = b", "d = e"]


@pytest.mark.parametrize(
    ("latex", "found"),
    [
        (r"\[ F - m g = m a \rightarrow \frac{F}{m} = a + g \]", ["independent", "follows"]),
        (r"\[ F - m g = m a \] \[ \rightarrow \] \[ \frac{F}{m} = a + g \]", ["independent", "follows"]),
        (
            r"\begin{align} 2 u &= v \\ & \rightarrow 4 u = 2 v \\ & \to 4 u = 3 v \end{align}",
            ["independent", "follows", "contradicts"],
        ),
        (r"\[ x_n = 1/n \rightarrow 0 \]", ["not decided"]),
        (r"\[ b = 0 \to c = a \]", ["not decided"]),
        (r"\[ f: A \to B = C \]", ["not decided"]),
        (r"\[ A \to B \] \[ C \to D \]", ["not decided", "not decided"]),
        (r"\[ \lim_{x \to 0} f(x) = 3 \]", ["not decided"]),
    ],
)
def test_an_arrow_between_equations_leads_from_one_to_the_next(latex, found):
    assert [each.verdict for each in read_document(document_of(latex))] == found
