"""Notations of documents whose macros and packages are elsewhere: what they look like is what is read."""

from __future__ import annotations

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def texts(latex: str) -> list[str | None]:
    return [each.read for each in read_document(document_of(latex))]


@pytest.mark.parametrize(
    ("written", "plain"),
    [
        (
            r"H = -\frac{a}{r^2} \pdv{r}(r^2 \pdv{f}{r})",
            r"H = -\frac{a}{r^2} \frac{\partial}{\partial r}(r^2 \frac{\partial f}{\partial r})",
        ),
        (r"K = -\frac{1}{2} \dv[2]{t} + \frac{l}{t^2}", r"K = -\frac{1}{2} \frac{d^2}{dt^2} + \frac{l}{t^2}"),
        (r"y = \cos[2](x) + \tan[-1](z)", r"y = \cos^2(x) + \tan^{-1}(z)"),
        (r"\lefteqn{a b} = c", r"a b = c"),
        (r"h = {\bm{\nabla}} \cdot u + {\bf\nabla} \cdot v", r"h = \nabla \cdot u + \nabla \cdot v"),
        (r"P = I - J^\# J - J^{\#} K", r"P = I - J^\sharp J - J^\sharp K"),
        (r"x_\mrm{p} = 2 \mcal{E}", r"x_{\mathrm{p}} = 2 \mathcal{E}"),
        (r"L = \frac{l}{\sqrt{\Re_l}} + \frac{\Re}{2}", r"L = \frac{l}{\sqrt{\mathrm{Re}_l}} + \frac{\mathrm{Re}}{2}"),
        (r"F = \frac{A(\%)}{c}", r"F = \frac{A}{c}"),
        (r"m = <x + y> + c", r"m = \langle x + y \rangle + c"),
        (r"v = \overset{.}{x} + \overset{\sim}{y}", r"v = \dot{x} + \tilde{y}"),
        (r"P = \overset{a \rightarrow b}{\mathbf M} x", r"P = \mathbf{M}^{(a \rightarrow b)} x"),
        (r"a = \frac{b}{2 (c - d). }", r"a = \frac{b}{2 (c - d)}"),
        (r"\mathllap{a}^{\land} = \mathrlap{b} + S’", r"a^{\wedge} = b + S'"),
        (r"a = b + 1 => b = a - 1", r"a = b + 1 \Rightarrow b = a - 1"),
        (
            r"A = \begin{bmatrix} | & | \\ a & b \end{bmatrix}",
            r"A = \begin{bmatrix} \vdots & \vdots \\ a & b \end{bmatrix}",
        ),
        (
            r"A = \begin{pmatrix} --- & a & --- \\ b & \vdots & c \end{pmatrix}",
            r"A = \begin{pmatrix} \cdots & a & \cdots \\ b & \vdots & c \end{pmatrix}",
        ),
        (
            r"x = \begin{smallmatrix} (\, a & b \,) \end{smallmatrix}",
            r"x = \begin{smallmatrix} a & b \end{smallmatrix}",
        ),
        (r"x = \begin{bmatrix} (a + b) & (c + d) \end{bmatrix}", r"x = \begin{bmatrix} a + b & c + d \end{bmatrix}"),
        (r"{a = b + c}.", r"a = b + c"),
        (r"T_r = T_a + q\,.{\label{eq:heat}}", r"T_r = T_a + q"),
        (r"a = \mbox{INT[D}+0.5] b", r"a = \mathrm{INT}[D+0.5] b"),
        (r"a = \mbox{mod\{INT[D}+0.5],7\}", r"a = \mathrm{mod}\{\mathrm{INT}[D+0.5],7\}"),
        (r"L^{\rm comp.} = a b", r"L^{\mathrm{comp}} = a b"),
        (r"\text{SNR}^2 = \frac{a^2 + b}{b^2}", r"\mathrm{SNR}^2 = \frac{a^2 + b}{b^2}"),
        (r"\mathbf n = c \vu*{x} + s \vu*{y}", r"\mathbf n = c \hat{\mathbf{x}} + s \hat{\mathbf{y}}"),
        (r"\mbox{\boldmath{$\alpha$}} = \mbox{\boldmath $\beta$} c", r"\boldsymbol{\alpha} = \boldsymbol{\beta} c"),
        (r"n = \underbrace{(a}_{\text{in}} * \underbrace{b)}_{\text{out}}", r"n = (a * b)"),
        (r"f = \text{Shift Up} \circ \text{Turn}.", r"f = \mathrm{ShiftUp} \circ \mathrm{Turn}"),
        (r"n = \underbrace{(a\rule[-9pt]{0pt}{5pt}}_{\text{in}} + b) c", r"n = (a + b) c"),
        (r"n = a \rule{0pt}{5pt} b", r"n = a b"),
        (r"t = 0.8\,sec", r"t = 0.8\,\mathrm{s}"),
        (r"Depth_{1} = a Depth_2 + b", r"\mathrm{Depth}_1 = a \mathrm{Depth}_2 + b"),
        (r"\underbrace{a = b}_{\text{mean}}, \quad c = d", r"a = b, \quad c = d"),
        (r"a = \eval{x}_{t}", r"a = \left.x\right|_{t}"),
        (r"c = \left|\hspace{-1pt}a\hspace{-1pt}\right|", r"c = \left|a\right|"),
        (r"m = \left<x + y\right>", r"m = \langle x + y \rangle"),
        (r"c = \frac{\overset{\large\rightharpoonup}{\small{V}}}{2}", r"c = \frac{\vec{V}}{2}"),
        (r"m = \underset{\text{at first}}{\underbrace{\quad a b\quad}} + c", r"m = {a b} + c"),
        (r"F = \frac{a}{b}.\index{a kernel!of something}", r"F = \frac{a}{b}"),
        (r"\makebox[\textwidth][c]{$ F = a b $}", r"F = a b"),
        (r"x = \paren*{a + b} c", r"x = (a + b) c"),
        (r"x = \exp\paren{a + b}", r"x = \exp(a + b)"),
        (r"x = \bbrack{a + b} c", r"x = [a + b] c"),
        (r"x = a^{\kl*} + b", r"x = a^{\kl *} + b"),
        (r"A = \mqty[a & b \\ c & d]", r"A = \begin{bmatrix} a & b \\ c & d \end{bmatrix}"),
        (
            r"A = \mqty(a & (b + c) \\ c & d) \qq{and} b = c",
            r"A = \pmatrix{a & (b + c) \\ c & d} \quad\text{and}\quad b = c",
        ),
        (r"A = a \qc b = c", r"A = a, \quad b = c"),
        (r"n = 16,777,216", r"n = 16777216"),
        (r"R_1{(t)} = 16,777,216", r"R_1(t) = 16777216"),
        (r"n = 10 \times -1 + 2", r"n = 10 \times (-1) + 2"),
        (r"n = x \cdot -2.5", r"n = x \cdot (-2.5)"),
        (r"A = \begin{bmatrix} a \\ b. \end{bmatrix}", r"A = \begin{bmatrix} a \\ b \end{bmatrix}"),
        (r"A = \begin{pmatrix} a, & b \\ c, & d \end{pmatrix}", r"A = \begin{pmatrix} a & b \\ c & d \end{pmatrix}"),
        (r"A = \begin{pmatrix} a, b + c, d \end{pmatrix}", r"A = \begin{pmatrix} a & b + c & d \end{pmatrix}"),
        (r"E = m \times \text{some factor}", r"E = m \times \mathrm{some factor}"),
        (r"\ma J = \ve a^T \ve b", r"\mathbf J = \mathbf a^T \mathbf b"),
        (r"\ve = a + b \ve x", r"\ve = a + b \ve x"),
        (r"\min_t \, - f + g", r"\min_t -f + g"),
        (r"f = R \del{\frac{x}{L}}^k + \sbr{a + b} c", r"f = R \left(\frac{x}{L}\right)^k + \left[a + b\right] c"),
        (r"\Dot{\Bar{\boldsymbol{\beta}}} = a \Hat{x}", r"\dot{\bar{\boldsymbol{\beta}}} = a \hat{x}"),
        (r"\setlength{\arraycolsep}{2pt} a = b \newline + c \IEEEyesnumber \allowdisplaybreaks", r"a = b + c"),
        (r"a &= b \displaybreak[0] \\ &+ c", r"a &= b \\ &+ c"),
        (r"{\hspace{0em}}^A X_B = a \hspace{0pt}^B x", r"{}^A X_B = a \,{}^B x"),
        (r"y = \mathbf{z}_{\mathsmaller{B}}^{\mathsmaller{\top}} x", r"y = \mathbf{z}_B^\top x"),
        (r"e_A = \log \lambda_A, \qquad A = 1, 2, 3", r"e_A = \log \lambda_A"),
        (r"\Delta{}u = 2 \Delta{}t^2", r"\Delta u = 2 \Delta t^2"),
        (r"c = \frac{f}{k}\> \sin t", r"c = \frac{f}{k} \sin t"),
        (r"q = (-½ m + a₀ b₁⁴) c", r"q = (-\frac{1}{2} m + a_0 b_1^4) c"),
        (r"g \buildrel {\text{def}}\over{=} a b", r"g \overset{\text{def}}{=} a b"),
        (r"a &= b \\* &+ c", r"a &= b \\ &+ c"),
        (r"y = \underset{i \to}{\mathrm{softmax}}(x)", r"y = \mathrm{softmax}_{i \to}(x)"),
        (r"\label{x} {N}(t, s) = a", r"N(t, s) = a"),
        (r"y = \ln\det A", r"y = \ln(\det A)"),
        (r"y = \left(\det A^{-1}\right)^2", r"y = (\det(A^{-1}))^2"),
        (r"A = \frac{1}{2} \| \ a \ \| + b", r"A = \frac{1}{2} \|a\| + b"),
        (r"A = \begin{pmatrix} 0,1,0 \\ 1,0,0 \end{pmatrix}", r"A = \begin{pmatrix} 0&1&0 \\ 1&0&0 \end{pmatrix}"),
        (r"X = \set*{a + b} c", r"X = \{a + b\} c"),
        (r"x = a \pmod{m}", r"x = a \bmod m"),
        (r"x = \wide{f(y)} + \wide x", r"x = \left\lVert f(y) \right\rVert + \left\lVert x \right\rVert"),
        (r"\ourhighbox{F = a b}", r"F = a b"),
        (r"{\dot s}(t, u) = a", r"\dot s(t, u) = a"),
        (r"RCut(S) = a b + b c + c u + u t", r"\mathrm{RCut}(S) = a b + b c + c u + u t"),
        (r"\texttt{mean} = a + b", r"\mathrm{mean} = a + b"),
        (r"p = \frac{\mid a\mid^2 - \mid b\mid^2}{c}", r"p = \frac{|a|^2 - |b|^2}{c}"),
        (r"i \in [1..N]", r"i \in [1, \ldots, N]"),
        (r"y = \log \xyz{a}{b} + c", r"y = \log(\xyz{a}{b}) + c"),
        (r"y = \tr \xyz \, z", r"y = \tr(\xyz) z"),
        ("x = a \\times \\\\ \\times b", "x = a \\times b"),
    ],
)
def test_a_notation_is_read_as_the_plain_one(written: str, plain: str) -> None:
    wide = r"\newcommand{\wide}[1]{\left\lVert#1\right\rVert}"
    found = texts(rf"{wide} \begin{{align}} {written} \end{{align}}")
    assert found == texts(rf"\begin{{align}} {plain} \end{{align}}")
    assert all(found)


@pytest.mark.parametrize(
    "latex",
    [
        r"x = 1,234",
        r"(x, y) = (10,200,300)",
        r"A = \begin{pmatrix} a, b \\ c \end{pmatrix}",
        r"A = \begin{pmatrix} 1,5 \\ 2,5 \end{pmatrix}",
    ],
)
def test_what_may_be_a_list_is_no_number_and_no_row(latex: str) -> None:
    assert all(text is None or "[1, 5]" not in text for text in texts(rf"\[ {latex} \]"))
    assert all(text is None or "1234" not in text for text in texts(rf"\[ {latex} \]"))
    assert all(text is None or "10200300" not in text for text in texts(rf"\[ {latex} \]"))


def test_a_picture_is_no_equation() -> None:
    latex = r"\[ \begin{tikzpicture} \draw (0,0) -- (1,0); \end{tikzpicture} \] \[ x = a \]"
    assert texts(latex) == ["x = a"]


def test_operators_stand_in_a_matrix() -> None:
    (text,) = texts(r"\[ L = \begin{pmatrix} \frac{\partial}{\partial x} & 0 \\ 0 & \frac{d}{d y} + c \end{pmatrix} \]")
    assert text == r"L = [[[\frac{\partial}{\partialx}], 0], [0, [\frac{d}{dy}] + c]]"


@pytest.mark.parametrize(
    ("written", "plain"),
    [
        (r"\newcommand{\T}{\ensuremath{\mathrm{T}}} \[ a = x^\T y \]", r"\[ a = x^\mathrm{T} y \]"),
        (
            r"\newcommand{\diag}{{\ensuremath{\mathrm{diag}}}} \[ D = \diag(a)\,\left[ b \right] \]",
            r"\[ D = \mathrm{diag}(a) [b] \]",
        ),
        (r"\def\mean<#1>{\|#1\|} \[ a = \mean<x + y> + c \]", r"\[ a = \|x + y\| + c \]"),
        (
            r"\def\tab#1={#1\;&=} \begin{align} \tab a = b \\ \tab = c \end{align}",
            r"\begin{align} a &= b \\ &= c \end{align}",
        ),
        (r"\[ a = \int_D f \text{ d} x \]", r"\[ a = \int_D f \, \mathrm{d} x \]"),
        (r"\[ a = \intop_0^L f \, dx \]", r"\[ a = \int_0^L f \, dx \]"),
        (r"\def\D{\mathrm{d} } \[ {\D \over \D  x} x^2 = 2 x \]", r"\[ \frac{d}{dx} x^2 = 2 x \]"),
        (r"\[ {d \over dx} x^2 = {\frac{a}{b}} c \]", r"\[ \frac{d}{dx} x^2 = \frac{a}{b} c \]"),
        (r"\[ x_{} = y^{} + {}_{}z \]", r"\[ x = y + z \]"),
        (r"\[ p = \mid k \mid^2 + a \]", r"\[ p = |k|^2 + a \]"),
        (r"\begin{align} {}&= a \\ {}&= b \end{align}", r"\begin{align} &= a \\ &= b \end{align}"),
        (r"\[ {N}(w, t) = {\cal L}(w, t) \]", r"\[ N(w, t) = \mathcal{L}(w, t) \]"),
        (r"\[ x^{N}(t) = \sqrt{N}(t) \]", r"\[ x^{N} (t) = \sqrt{N} (t) \]"),
        (r"\[ M_{i}(t) = \mathbf{H}(t) + V_{a}(x) \]", r"\[ M_i (t) = \mathbf H (t) + V_a (x) \]"),
        (r"\[ c = 2 - -10 \]", r"\[ c = 2 - (-10) \]"),
        (r"\begin{align} \MoveEqLeft a = b \end{align}", r"\begin{align} a = b \end{align}"),
        (r"\[ a \not= b \] \[ x \not\in A \]", r"\[ a \ne b \] \[ x \notin A \]"),
        (r"\begin{align} \MoveEqLeft[10] a = b \end{align}", r"\begin{align} a = b \end{align}"),
    ],
)
def test_a_document_with_a_notation_is_read_as_one_without(written: str, plain: str) -> None:
    assert texts(written) == texts(plain)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\[ m = -k \in (-1, 0] \]", ["m = -k ∈ [(-1, 0]]"]),
        (r"\[ T = [0, t) \]", ["T = [[0, t)]"]),
        (r"\[ a = \bigoplus_{j=0}^{n} W_j \]", [r"a = [\bigoplus_{j=0}^{n}](W_j)"]),
        (r"\[ a = b \bigoplus c \]", ["a = b o c"]),
        (r"\begin{align} u &:= a b \\ &:= c b \end{align}", ["u := a*b := c*b"]),
        (r"\begin{eqnarray} \bigg[ a + b + & & \\ c + d \bigg] u &=& v \end{eqnarray}", ["(a + b + c + d)*u = v"]),
        (r"\begin{eqnarray} a + b + \\ \nonumber c = d \end{eqnarray}", ["a + b + c = d"]),
    ],
)
def test_what_rows_and_brackets_leave_open_is_read(latex: str, expected: list[str]) -> None:
    assert texts(latex) == expected


def test_kets_are_letters() -> None:
    assert texts(r"\newcommand{\ket}[1]{|#1\rangle} \[ \ket{u} = a \left|v\right\rangle + |w_i\rangle \]") == [
        r"ket_u = a*ket_v + [\ket{w_i}]"
    ]


def test_an_equation_may_name_the_arguments_of_its_letter() -> None:
    found = read_document(
        document_of(r"We use \begin{align} x_1 &= x_1(t, a) = R \cos t, & x_2 &= x_2(t) = a t. \end{align}")
    )
    assert [each.verdict for each in found] == ["definition", "definition"]


def test_a_zero_above_a_letter_names_the_start() -> None:
    found = read_document(document_of(r"\[ p^0 = a b \] \[ q = \sqrt{p^0} + 1 \] Hence \[ q = \sqrt{a b} + 1 \]"))
    assert [each.verdict for each in found] == ["definition", "definition", "follows"]
    powers = read_document(document_of(r"\[ p = x^0 + x^1 + x^2 \] Hence \[ p = 1 + x + x^2 \]"))
    assert powers[-1].verdict == "follows"


def test_an_equation_that_cannot_be_read_may_give_its_letter_anew() -> None:
    before = r"\[ f = 2 a \] The sum is \[ z = y + f \]"
    unread = r"In the second pass it is \[ f = 3 a) + b \]"
    after = r"Hence \[ z - y = 2 a \]"
    assert read_document(document_of(before + after))[-1].verdict == "follows"
    assert read_document(document_of(before + unread + after))[-1].verdict != "follows"


@pytest.mark.parametrize(("power", "verdict"), [("2", "follows"), ("3", "independent")])
def test_a_chain_with_a_link_that_fails_gives_nothing_within_its_display(power: str, verdict: str) -> None:
    chain = rf"\frac{{1 - x}}{{2}} = \frac{{a^2}}{{r^2 + a^{power}}} = \frac{{1}}{{1 + (r/a)^2}}"
    latex = rf"\[ {chain}; \quad \frac{{1 + x}}{{2}} = \frac{{r^2}}{{r^2 + a^2}}. \]"
    found = read_document(document_of("With " + latex))
    assert found[-1].verdict == verdict


def test_words_below_letters_tell_them_apart() -> None:
    latex = r"\[ \underset{\text{before}}{v} = \underset{\text{after}}{v} \]"
    assert read_document(document_of(latex))[-1].verdict != "follows"


def test_operators_do_not_commute() -> None:
    latex = r"\[ \left(\frac{d}{dx} + a\right) f = f \left(\frac{d}{dx} + a\right) \]"
    assert read_document(document_of(latex))[-1].verdict != "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ A = \begin{minipage}{5cm} \verb|a| \end{minipage} \]"
        r" \[ B = \begin{minipage}{5cm} \verb|b| \end{minipage} \]"
        r" Hence \[ A = B. \]",
        r"\[ y = x + 3 \pmod 4 \] Hence \[ y - x = 3. \]",
        r"\[ y = (a b)^{n,+} \qquad z = (a b)^{n,-} \] Hence \[ y = z. \]",
    ],
)
def test_what_is_only_read_gives_nothing(latex: str) -> None:
    assert read_document(document_of(latex))[-1].verdict not in ("follows", "contradicts")


def test_a_congruence_contradicts_nothing() -> None:
    found = read_document(document_of(r"Let $x = 7$. Then \[ x = 3 \pmod{4}. \]"))
    assert found[-1].verdict not in ("contradicts", "follows")


def test_an_argument_that_has_one_reading_only_is_read_so():
    latex = r"\[ L = a - \log 2 \cosh \frac{1}{2} \sum_k z_k \] \[ L - a = - \log 2 \cosh \frac{1}{2} \sum_k z_k \]"
    found = read_document(document_of(latex), seconds=5)
    assert [each.verdict for each in found] == ["definition", "follows"]


@pytest.mark.parametrize(
    "display",
    [
        "\\begin{equation} a = b + c \\end {equation}",
        "\\begin {align*} a = b + c \\end\t{align*}",
        "\\begin{xalignat}{2} a &= b + c \\end{xalignat}",
    ],
)
def test_a_display_ends_where_its_mark_ends(display):
    found = read_document(document_of(rf"Let {display} and $d$ be two sums. Hence \[ a - b = c. \]"))
    assert [(each.read, each.verdict) for each in found] == [("a = b + c", "definition"), ("a - b = c", "follows")]


@pytest.mark.parametrize(
    "text",
    [
        "The sum is \n\\\\[\na = b + c\n\\\\]\nof two. Hence\n\n\\\\[ a - b = c \\\\]\n",
        "Let \\\\(b\\\\) be a number. $$ a = b + c $$ Hence $$ a - b = c $$",
    ],
)
def test_marks_of_formulas_with_two_backslashes_in_markdown(text):
    found = read_document(document_of(text, latex=False))
    assert [(each.read, each.verdict) for each in found] == [("a = b + c", "definition"), ("a - b = c", "follows")]


def test_an_escaped_underscore_of_markdown_begins_a_subscript():
    [found] = read_document(document_of(r"$$ x\_1 = a\_2 + b\_i $$", latex=False))
    assert found.read == "x_1 = a_2 + b_i"


@pytest.mark.parametrize(
    ("unit", "name"),
    [
        (r"\mathrm{m/s^2}", "m_per_s_2"),
        (r"\mathrm{km/h}", "km_per_h"),
        (r"\mathrm{\kilo\metre\per\hour}", "kilometreperhour"),
    ],
)
def test_the_name_of_a_unit_is_whole(unit, name):
    assert texts(rf"\[ g = 9.81\,{unit} \]") == [f"g = 9.81*{name}"]


@pytest.mark.parametrize(
    ("above", "left"),
    [
        (r"The strain is \[ @e = @e^\theta + @e^p. \]", r"@e^\theta(t)"),
        (r"The point is \[ @x = @a t + @b. \]", r"@x^\varphi(@x)"),
        (r"The increment is \[ \Delta@e = @B @r. \]", r"\Delta@e^p"),
    ],
)
def test_a_vector_with_a_label_is_another_one(above, left):
    text = rf"{above} We have \[ {left} = 2 @u + c @v. \]".replace("@", r"\boldsymbol ")
    assert [each.verdict for each in read_document(document_of(text))] == ["definition", "definition"]


def test_a_set_may_be_a_value_in_a_case():
    assert texts(r"\[ T = \begin{cases} 3 & a < 2 \\ \{x \in R | x < 2\} & a > 2 \end{cases} \]") != [None]


def test_the_number_of_a_space_is_no_number_of_a_sample():
    found = read_document(
        document_of(r"\[ g = a b \in SE(3) \] \[ S := \begin{bmatrix} 0 & z \\ -z & 0 \end{bmatrix} \in so(2) \]")
    )
    assert [each.verdict for each in found] == ["definition", "definition"]


def test_a_tensor_applied_to_a_number_is_told_in_words():
    stress = r"The stress of tensors is \[ \dot s = C : \dot e = C : (a - b) \] "
    first, _ = read_document(document_of(rf"{stress} \[ C = \lambda I \otimes I + 2 \mu \mathbf{{I}} \]"))
    assert "reduce()" not in first.links[1].reason


def test_what_states_nothing_within_a_line_of_markdown_is_no_display():
    text = "The matrix $$A$$ of $$\\phi$$ is\n\n$$ A = \\phi I $$\n\nIn short, $$a = b$$ holds.\n\n$$A \\phi$$\n"
    found = document_of(text, latex=False).formulas
    environments = ["inline", "inline", "display", "display", "display"]
    assert [each.environment for each in found] == environments
