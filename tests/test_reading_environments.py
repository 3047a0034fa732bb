"""Environments and commands that only set a formula: what they say of its looks is no factor of it."""

from __future__ import annotations

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def read(latex: str) -> list[str | None]:
    return [each.read for each in read_document(document_of(latex))]


@pytest.mark.parametrize(
    "latex",
    [
        r"\begin{IEEEeqnarray}{rCl} a &=& b \IEEEnonumber \\ c &=& d \end{IEEEeqnarray}",
        r"\begin{IEEEeqnarray*}{rCl'l} a &=& b \\ c &=& d \end{IEEEeqnarray*}",
        r"\begin{alignat}{2} a &= b &\quad c &= d \end{alignat}",
        r"\begin{alignat*}{2} a &= b \\ c &= d \end{alignat*}",
        r"\begin{empheq}[left=\empheqlbrace, box={\fbox}]{align} a &= b \\ c &= d \end{empheq}",
        r"\begin{equation}\begin{aligned}[t] a &= b \\ c &= d \end{aligned}\end{equation}",
        r"\be a = b \ee \bea c &=& d \eea",
        r"\beq a = b \eeq \[ {\small c = d} \]",
        r"\newcommand{\eq}[1]{\begin{equation}#1\end{equation}} \eq{a = b} \eq{c = d}",
        r"\newcommand\eqn[2]{\begin{equation}\label{#1}#2\end{equation}} \eqn{x}{a = b} \eqn{y} { c = d }",
        r"\def\eq#1{$$#1$$} \eq{a = b} \[ c = d \]",
        r"\newcommand\ba{\begin{equation}\begin{aligned}} \newcommand\ea{\end{aligned}\end{equation}} \ba a &= b \\ "
        r"c &= d \ea",
        r"\newenvironment{eqn}[1][x]{\begin{align}\label{#1}}{\end{align}} \begin{eqn}[y] a &= b \\ c &= d \end{eqn}",
        r"\newenvironment*{eqn*}{\begin{equation*}}{\end{equation*}} \begin{eqn*} a = b \end{eqn*} \[ c = d \]",
        r"\newenvironment{mat}{\begin{pmatrix}}{\end{pmatrix}} \newenvironment{note}{\textbf{Note}}{} \begin{note} So "
        r"$x = y$. \end{note} \[ a = b \] \[ c = d \]",
        r"\[ \left.\begin{aligned} a &= b \\ c &= d \end{aligned}\right\} \quad (1) \]",
        r"\begin{equation} \left. \begin{array}{rcl} a &=& b \\ c &=& d \end{array} \right\} \label{x} \end{equation}",
        r"\begin{subeqnarray} a &=& b \\ c &=& d \end{subeqnarray}",
        r"\[ \fbox{$a = b$} \] \[ \resizebox{\hsize}{!}{$c = d$} \]",
        r"\[ \scalebox{0.8}{$a = b$} \] \[ c = d \]",
        r"$$ a = b \eqno(1) $$ $$ c = d \leqno{(2)} $$",
    ],
)
def test_what_sets_a_formula_is_no_factor(latex: str) -> None:
    assert read(latex) == ["a = b", "c = d"]


def test_a_number_behind_a_formula_is_its_number() -> None:
    found = read_document(document_of(r"$$ s = a + b \eqno(4.2) $$ By (4.2) \[ s - a = b \ldots(7) \]"))
    assert [each.number for each in found] == ["4.2", "7"]
    assert found[1].links[0].rests_on == ("(4.2), line 1",)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"l = \log p(x, z) - \ln q(x; a)", "l = log(p(x, z)) - log(q(x, a))"),
        (r"a = \overset{\circ}{b} + \overset{\frown}{AB}", "a = mathringb + AB_overline"),
        (r"a = b \mathbin{/} c", "a = b/c"),
        (r"a = \textcolor{red}{b} \raisebox{1pt}{$c$}", "a = b*c"),
        (r"\|\mathbf v\|_W^2 = \mathbf v^T W \mathbf v", "(norm(v))_W**2 = v.T*W*v"),
        (r"{J_P}_i = {z'_a}_b^2", "J_P_i = z_a_bp**2"),
    ],
)
def test_a_formula_is_read(latex: str, expected: str) -> None:
    assert read(rf"\[ {latex} \]") == [expected]


FRAMES = r"The point is \[ \mathbf{p}^0 = \mathbf{o}_1^0 + R_1^0 \mathbf{q}^1 \] Hence "


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (r"\[ \mathbf{p}^0 - \mathbf{o}_1^0 = R_1^0 \mathbf{q}^1 \]", True),
        (r"\[ \dot{\mathbf{p}}^0 = \dot{\mathbf{o}}_1^0 + R_1^0 \dot{\mathbf{q}}^1 + \dot R_1^0 \mathbf{q}^1 \]", True),
        (r"\[ \dot{\mathbf{p}}^0 = \dot{\mathbf{o}}_1^0 + R_1^0 \dot{\mathbf{q}}^1 \]", False),
        (r"\[ \mathbf{p}^0 - \mathbf{o}_1^0 = \mathbf{q}^1 R_1^0 \]", False),
        (r"\[ \mathbf{p} - \mathbf{o}_1 = R_1 \mathbf{q} \]", False),
    ],
)
def test_a_number_above_a_vector_is_that_of_a_frame(latex: str, follows: bool) -> None:
    assert (read_document(document_of(FRAMES + latex))[-1].verdict == "follows") is follows


def test_a_number_above_a_vector_may_be_its_square_or_that_of_a_step() -> None:
    steps = r"\[ \mathbf v^1 = \mathbf v^0 + \mathbf a \] \[ E = \frac12 m \mathbf v^2 \] Hence "
    assert (
        read_document(document_of(steps + r"\[ \frac{\partial E}{\partial\mathbf v} = 0 \]"))[-1].verdict != "follows"
    )
    frames = r"\[ \mathbf p^0 = R_1^0 \mathbf p^1, \quad \mathbf p^1 = R_2^1 \mathbf p^2 \] Hence "
    for product, follows in (("R_1^0 R_2^1", True), ("R_2^1 R_1^0", False)):
        found = read_document(document_of(frames + rf"\[ \mathbf p^0 = {product} \mathbf p^2 \]"))
        assert (found[-1].verdict == "follows") is follows


def test_a_value_of_a_function_has_one_size() -> None:
    values = r"Here $J(\mathbf p)$ is the Jacobian matrix. \[ \mathbf d = -\frac12 J(\mathbf p)^T \lambda \] Hence "
    for sign, follows in (("", True), ("-", False)):
        latex = rf"\[ \mathbf d^T \mathbf d = {sign} \frac14 \lambda^T J(\mathbf p) J(\mathbf p)^T \lambda \]"
        assert (read_document(document_of(values + latex))[-1].verdict == "follows") is follows


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"R = I + \sin\theta K", "R = I + sin(theta)*K"),
        (r"v = -l \sin\theta_1 \dot\theta_1", "v = -l*sin(theta_1)*theta_dot_1"),
        (r"x = a \cos\omega t", "x = a*cos(omega*t)"),
        (r"x = a \cos\omega T + \sin 2 \theta", "x = a*cos(omega*T) + sin(2*theta)"),
    ],
)
def test_a_capital_or_a_rate_behind_an_angle_is_a_factor(latex: str, expected: str) -> None:
    assert read(rf"\[ {latex} \]") == [expected]


LOST = r"""It costs \$5. Then
\\$\Rightarrow$ we have
\\$a=b$ and \\[1em] so \[ c = d \]
A stray $ stands here.

\begin{equation} e = f \end{equation} and another $x
\[ g = h \] behind it."""


def test_no_display_is_lost_behind_a_dollar() -> None:
    assert read(LOST)[:2] == ["c = d", "e = f"]


def test_short_delimiters_and_braces_round_a_sign_are_read() -> None:
    assert read(r"\[ a = \l( b + c \r)^2 \]") == ["a = (b + c)**2"]
    assert read(r"\[ p = \Pr(\mathbf{x}{=}y) \]") == read(r"\[ p = \Pr(\mathbf{x}=y) \]")


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"P = f + \| \min(0, c) \|^2 + \frac{r}{2} \| d \|^2", r"P = f + norm([\min]([[0, c]]))**2 + r/2*norm(d)**2"),
        (r"d = \parallel b - c \parallel", "d = norm(b - c)"),
        (r"x = [a; b + c] \cdot \left[d, e; f, g\right]", "x = [[a], [b + c]]*[[d, e], [f, g]]"),
        (r"x = (a, [b; 1]) + h[c; d]", "x = [[a, [[b], [1]]]] + h*[[c, d]]"),
        (r"a = \mleft( b + c \mright) d", "a = (b + c)*d"),
        (r"f: A \ra B", r"[f: A] → [B]"),
    ],
)
def test_bars_and_arrows_are_read(latex: str, expected: str) -> None:
    assert read(rf"\[ {latex} \]") == [expected]


def test_lines_may_be_parallel() -> None:
    assert read(r"\[ a \parallel b \] \[ a \parallel b \parallel c \]") == ["a ∥ b", "a ∥ b ∥ c"]


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\begin{eqnarray} d &=& a + b \cr &=& c \end{eqnarray}", "d = a + b = c"),
        (r"$$ A = \pmatrix{a & b \cr c & d} $$", "A = [[a, b], [c, d]]"),
        (r"$$ f = \cases{a & if $b > 0$ \cr c & otherwise} $$", "f = Piecewise((a, if b > 0), (c, otherwise))"),
        (
            r"$$ f = \begin{cases} a & \text{, if } b < a_{1} \text{ and } b > 0, \\ c & \end{cases} $$",
            "f = Piecewise((a, if b < a_{1} and b > 0), (c, otherwise))",
        ),
        (r"$$ d = {\rm range}(a) $$", "d = range(a)"),
        (r"$$ x_{\rm max} = { \rm sin} a $$", "x_max = sin(a)"),
        (r"$$ \text{sin} x = x $$", "sin(x) = x"),
        (r"$$ \mbox{tr } A = a $$", "tr(A) = a"),
        (r"$$ \text{Var}\,x = x $$", "Var*x = x"),
        (r"$$ \text{round}(x) = x $$", "round(x) = x"),
        (r"$$ \text{y} x = x \text{z} $$", "y*x = x*z"),
        (r"$$ \alpha\text{z} = \Sigma\T + \Sigma\inv $$", "alpha*z = Sigma.T + Sigma**(-1)"),
        (r"$$ x = 5 \text{m} $$", "x = 5"),
        (r"$$ x_\text{a} = y^\text{T} $$", "x_a = y.T"),
        (r"$$ x_{\text{half}} = y_{a,\text{minus}} + z^\text{double} $$", "x_half = y_a_minus + z_double"),
        (r"$$ A = \text{Attention}(x) + \text{format}(y) $$", "A = Attention(x) + format(y)"),
        (r"$$ \text{Var}\left(x\right) = \text{Var}\!\left(y\right) $$", "Var(x) = Var(y)"),
        (r"$$ \text{round}\bigl(x\bigr) = \text{abs}\Big[y\Big] $$", "round(x) = abs(y)"),
        (r"$$ \text{atan2}(x, y) = \text{log}\;x + \text{ln}~y $$", "atan2(x, y) = log(x) + log(y)"),
        (r"$$ \text{velocity } v = v $$", "v = v"),
        (r"$$ \text{where}\, x = y $$", "x = y"),
    ],
)
def test_rows_and_words_of_plain_tex_are_read(latex: str, expected: str) -> None:
    assert read(latex) == [expected]


@pytest.mark.parametrize(
    "latex",
    [
        r"\text{the variance of } x = x",
        r"\text{twice } x = x",
        r"\text{(twice)} x = x",
        r"\text{Not: } x = x",
        r"x = x\text{ (squared)}",
        r"x = x\text{, squared}",
        r"\text{Not } x = x",
        r"\frac{\text{twice }x}{2} = \frac{x}{2}",
        r"-\text{half of the }x = -x",
        r"x = x \text{ minus } y",
        r"x = x \text{ squared}",
        r"x = x \text{ mod } 3",
        r"x = x \text{ XOR } y",
        r"x = x \text{ AND } y",
        r"x = x \text{ of } y",
    ],
)
def test_words_that_act_on_a_letter_are_not_left_out(latex: str) -> None:
    (found,) = read_document(document_of(f"$$ {latex} $$"))
    assert found.verdict == "not read"
    assert "act on the formula beside them" in found.reason


def test_an_environment_that_nothing_defines_is_a_display_if_it_holds_a_formula_and_no_words() -> None:
    text = r"""\begin{law}{gas}
    \label{eq:gas}
    p &= \frac{n R T}{V} \\[1em]
    q &= \frac{p}{2} \\(r)
    &= s
\end{law}
\begin{note} Here $a = \frac{b}{c}$. \end{note}
\begin{sketch} \draw (0, 0) -- (\x, {x = \frac{1}{2}}); \end{sketch}
\begin{diagram} A \arrow[r, "\alpha = 1"] & B \end{diagram}
\begin{python} a = b.frac(c) \end{python}
\[ \begin{rows} s = \frac{t}{2} \end{rows} \]"""
    found = read_document(document_of(text))
    assert [each.read for each in found[:3]] == ["p = n*R*T/V", "q = p/2", "r = s"]
    assert [each.line for each in found] == [1, 1, 1, 11]


def test_cases_with_a_left_side_are_a_display() -> None:
    (found,) = read_document(document_of(r"\begin{numcases}{y =} 1 & if $x > 0$ \\ 0 & otherwise \end{numcases}"))
    assert found.read == "y = Piecewise((1, if x > 0), (0, otherwise))"


@pytest.mark.parametrize("body", [r"\be\be", r"\begin{equation}\be", r"\begin{equation} a = b \ee\be"])
def test_a_display_that_expands_itself_ends(body: str) -> None:
    text = rf"\newcommand{{\be}}{{{body}}}\newcommand{{\ee}}{{\end{{equation}}}}"
    assert all(
        each.read is None or each.read == "a = b" for each in read_document(document_of(rf"{text} \be a = b \ee"))
    )


@pytest.mark.parametrize(
    ("latex", "expected"),
    [("0{,}5", "0.5"), ("32{,}45", "32.45"), ("0{,}125", "0.125"), ("12{,}345{,}678", "12345678"), ("12{,}345", None)],
)
def test_a_comma_in_braces_stands_before_decimals_or_thousands(latex: str, expected: str | None) -> None:
    assert read(rf"\[ a = {latex} b \]") == [expected and f"a = {expected}*b"]


def test_lines_are_those_of_the_file_where_a_display_is_expanded() -> None:
    text = "\\newcommand{\\eq}[2]{\\begin{equation}\n#1 = #2\n\\end{equation}}\n\\eq{a}\n{b}\n\\[\nc = d \\]"
    assert [(each.line, each.read) for each in read_document(document_of(text))] == [(4, "a = b"), (6, "c = d")]


@pytest.mark.parametrize(
    "latex",
    [
        r"\forall x: f(x) = a",
        r"\forall x \in S: \quad f(x) = a",
        r"\forall x, y \in \{1, 2\}, f(x) = a",
        r"\forall x\, f(x) = a",
        r"\forall x \, \in \, S \; f(x) = a",
        r"f(x) = a, \quad \forall \, x \, \in \, S",
        r"f(x) = a \quad \forall x > 0",
    ],
)
def test_what_holds_for_all_is_read(latex: str) -> None:
    assert read(rf"\[ {latex} \]") == ["f(x) = a"]


def test_no_display_with_a_relation_is_lost() -> None:
    (found,) = read_document(document_of(r"\[ \forall x. f(x) = a \]"))
    assert (found.verdict, found.reason) == ("not read", "line 1: no equation is found in it")
    assert read(r"\[ \text{These are words.} \]") == []
    assert read(r"\begin{align} f(x) &= a \\ & \forall \, x \, \in \, S \end{align}") == ["f(x) = a"]


def test_a_quotation_in_markdown_is_read() -> None:
    text = "Words.\n\n> A law:\n>\n> $$\n> a = b\n> $$\n\n$$ c\n> d $$\n"
    found = read_document(document_of(text, latex=False))
    assert [(each.line, each.read) for each in found] == [(5, "a = b"), (9, "c > d")]
    denied = "> $$\n> a = b\n> $$\n\nGalileo refuted this. Hence\n\n$$ a/b = 1 $$\n"
    assert read_document(document_of(denied, latex=False))[-1].verdict != "follows"


@pytest.mark.parametrize("latex", [r"\forall x" + "," * 19_000, r"f = a \quad \forall x" + "," * 19_000])
def test_a_quantifier_without_end_is_read_once(latex: str) -> None:
    assert len(read(rf"\[ {latex} \]")) <= 1


def test_what_macros_add_to_a_text_is_bounded() -> None:
    macros = rf"\newcommand{{\be}}{{\begin{{equation}} a = {'x + ' * 4_500}}}\newcommand{{\ee}}{{y \end{{equation}}}}"
    assert sum(len(each.latex) for each in document_of(macros + r"\be\ee " * 2_000).formulas) < 1_100_000
