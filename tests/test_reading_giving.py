r"""Equations that give a letter beside words of a case, in another section, or as the value of a named function."""

import pytest

from algebroproj_sym.reading import document_at, document_of, read_document
from algebroproj_sym.reading.judging.deciding import NOT_DERIVED
from algebroproj_sym.reporting.readings import reading_lines

pytestmark = pytest.mark.usefixtures("verdicts_alone")

BEFORE = r"The area satisfies \[ A h = c b. \] "
USED = r"It turns for \[ b h > 0. \] "
SUM = r"\section{Sums} The sum is \[ s = a + b. \] "
NEXT = r"\section{Differences} "


def verdicts(latex):
    return [each.verdict for each in read_document(document_of(latex), seconds=5)]


@pytest.mark.parametrize(
    "latex",
    [
        r"The commands are in a list. \[ a_t = [a_t^1, \ldots, a_t^N] \]",
        r"The model is \[ M(q) \ddot q + C(q, \dot q) \dot q = B u \] where "
        r"\[ C(q, \dot q) = \begin{bmatrix} -m \sin(\theta) \dot\theta & 0 \\ 0 & 1 \end{bmatrix} \]",
        r"Now, if we let \[ r = y - f(x) \] the sum is small.",
        r"This is a special case of that one, with the matrix \[ J = 2 \pi G k I. \]",
        r"If $A$ is the area of the whole, then $t$ is the period: \[ T = \frac{2A}{h}. \]",
        BEFORE + r"In this case, we can write it as \[ f = 2 c b. \]",
        USED + r"Assuming that the thrust has the direction of the velocity, then \[ b = t v. \]",
        BEFORE + r"If the ellipse is closed, the radius is \[ b = a (1 - e). \]",
        USED + r"We assume that the gain has the following form \[ h = \frac{k^2}{m}. \]",
        BEFORE + r"The width is computed using \[ b = a (1 - e) \] If it is large, then the height is \[ h = a e \]",
        r"Then the variance of $X$ is \[ \mathrm{Var}(X) = p (1 - p). \]",
        r"The expected value is defined as \[ \mathrm{E}[g(X)] = \sum_x g(x) f(x). \]",
        r"The mean is \[ \mathrm{E}(X) = \lambda. \]",
        r"Then the entropy in nats is \[ \mathrm{H}(X) = a (1 - \ln a). \]",
        r"\[ m x = k. \] With the terms of the error, the residual is \[ x = y - z. \]",
        r"Then the density is \[ F(x) = \int_{-\infty}^x f(t) \, dt. \]",
        r"Then the mean is \[ E(X) = p. \] The mean is defined as \[ E(X) = \sum_x x f(x). \]",
        USED + r"Then the angle is \[ \cos h = \frac{a}{c}. \]",
        USED + r"The log-likelihood is \[ \ln p(y|m) = - \frac{n}{2} s. \]",
        USED + r"The velocity is \[ v(x) = \frac{\partial}{\partial x} \left\lbrace \phi(x, y) \right\rbrace. \]",
        SUM + NEXT + r"Here it is \[ s = 5 c \]",
        r"The activation is \[ h = \mathrm{RBF}(x w) = e^{-(x w)^2}. \]",
        r"\[ p = k T. \] If $q$ is small, the gain is \[ k(q) = a (1 - q_1) + b q_2. \]",
        r"\[ L(X) = A X. \] Let $A$ be \[ A = \left[\begin{array}{rr} 1 & 0 \\ 0 & 2 \end{array}\right]. \]",
        r"In equilibrium, when both are known, the fraction is \[ q = \frac{a}{a + b}. \]",
        r"The total cost is \[ J(\mathbf{x}) := \sum_i J_i(\mathbf{x}), \]",
        BEFORE + r"\[ b := f + A. \]",
        r"The next state is \[ \begin{pmatrix} x_{k+1} \\ y_{k+1} \end{pmatrix} = "
        r"\begin{pmatrix} a & 1 \\ 0 & b \end{pmatrix} \begin{pmatrix} x_k \\ y_k \end{pmatrix}. \]",
        r"Let $\Pi$ be the Exner function. \[ \theta = \frac{T}{\Pi} \]",
        r"The state is \[ \mathbf{x} = \begin{bmatrix} \mathbf{q} \\ \mathbf{u} \end{bmatrix} "
        r"= \begin{bmatrix} a \\ b \\ c \\ d \end{bmatrix}. \]",
        r"The map is \[ T \left( \begin{bmatrix} v_1 \\ v_2 \end{bmatrix} \right) "
        r"= \begin{bmatrix} 2 v_1 \\ 0 \\ v_2 \end{bmatrix}. \]",
        r"\[ A = \begin{bmatrix} 1 & 0 \\ 2 & 1 \end{bmatrix} \] " + NEXT + r"Let "
        r"\[ A = \begin{bmatrix} 1 & 2 \\ 2 & 3 \end{bmatrix} \]",
        r"The simplest model would be \[ b = f + g. \]",
        BEFORE + r"\[ \mathbf{v} = \begin{pmatrix} b \\ c \end{pmatrix} \in \mathbb{R}^2 \]",
        r"The operators $A$ and $B$ do not commute. One step is \[ s = e^{A h} e^{B h} u. \]",
        r"If we express the stiffness as \[ C = p A + q B. \]",
        r"\[ q(w, t) > g(w, t) \] The load is \[ q(w, t) = r I + s O. \]",
        r"\[ y = a b \] \[ \mathbf{e}_k(\mathbf{x}, y) := \mathbf{e}_k(\mathbf{x}) := \mathbf{e}(\mathbf{x}) \]",
        r"The Hessian is \[ \mathbf{H}^k = 2 \mathbf{A}^k + \mu \mathbf{R} \]",
        r"\[ \epsilon(\mathbf{x}) = \begin{cases} 1, & \mathbf{x} \in A, \\ 2, & \mathbf{x} \in B. \end{cases} \]",
        r"The speed after one step is \[ v(t + \Delta t) = v(t) + a(t) \Delta t. \]",
        r"The law of steel is \[ s = D e. \] Residual stresses are added in castings \[ s = D (e - f) + g. \]",
        r"\[ y = a x. \] It has \[ y = b + \sum_{i=1}^n \phi(b_i + w_i x) \]",
        r"We express it as \[ C = f A. \] Suppose that $f$ is known. The flux simplifies to \[ f = E A. \]",
        r"If we modify the model to have a quadratic term: \[ t = a + b x + c x^2 \]",
        r"This happens if it performs some orbits in a day: \[ R = I + \frac{N}{D} \]",
        r"We use the pressure (which is positive) instead of the mean: \[ p = -\frac{s}{3} \]",
        r"Functions compose. The mean is \[ \bar{n} = n \left[1 + \left(\frac{R}{p}\right)^2 (2 - 3 e)\right] \]",
        r"The expected value is \[ \langle F(x) \rangle = \int dx \, p(x) F(x) \]",
        r"The moments are \[ m_n \equiv \langle x^n \rangle = \int dx \, p(x) x^n \]",
        r"The length is \[ \|x\| = \sqrt{x_1^2 + x_2^2} \]",
        r"The correction is \[ \left[ u = L (r - x) \right] \]",
        r"The variation is \[ TV(y) = \sum_i |y_i - y_{i-1}| \]",
        r"The sides are \[ OP_1 = m \] \[ OP_2 = 1 - m \]",
        r"It is \[ \text{ROUGE-L}_{\text{recall}} = \frac{a}{b} \]",
        r"It is \[ r \pause = \frac{a}{b} \]",
        r"The rotation is \[ R_1{(t)} = \begin{bmatrix} 1 & t \\ 0 & 1 \end{bmatrix} \]",
        r"The expanded state is \[ (x_k)_e = \begin{bmatrix} x_k \\ x_{k-1} \end{bmatrix} \]",
        r"The mean is \[ m = 0 (0.98) + 1{,}000{,}000 (0.02) = 20000 \]",
        r"The index is \[ {\displaystyle i = {\frac {n (n + 2) + m}{2}}} \]",
        r"The first polynomial is \[ P_0(x) = 1 \]",
        r"The measurement is \[ h_p(x) = p_n \]",
        r"The variogram is \[ 2 \gamma(h) = \frac{a}{N} + h \]",
        r"The speed is \[ v = \frac{a}{b} \approx 3.2 \]",
        r"The sum is \[ p = \underset{1 \le i \le N}{\sum} a_i b_i \]",
        r"Functions $f(x)$ compose. The loss is \[ h = s^2 \left( \sqrt{1 + (r/s)^2} - 1 \right) \]",
        r"We introduce the Hamiltonian \[ \mathcal{H}(\mathbf{x}, \mathbf{p}) = \lambda_0 c + \lambda_1 f. \]",
    ],
)
def test_an_equation_that_gives_its_letter_is_a_definition(latex):
    assert verdicts(latex)[-1] == "definition"


@pytest.mark.parametrize(
    "latex",
    [
        BEFORE + r"The beam is parallel if \[ b = f. \]",
        BEFORE + r"The beam is parallel when, as above, \[ b = f. \]",
        BEFORE + r"The next figure shows this when \[ b = 2 f. \]",
        BEFORE + r"If $c$ is one, and $d$ is two, and \[ b = f, \] then it moves.",
        BEFORE + r"If $c = 1$, $d = 2$, \[ b = f, \] it moves.",
        BEFORE + r"Suppose \[ b = f. \]",
        BEFORE + r"Suppose that \[ b = f. \]",
        BEFORE + r"Let us assume that \[ b = f. \]",
        BEFORE + r"If we let \[ b = f \] it is small.",
        BEFORE + r"The root is \[ x = g(x^2). \]",
        BEFORE + r"The point is \[ x = A \begin{bmatrix} x^2 \\ 1 \end{bmatrix}. \]",
        BEFORE + r"It is approximately \[ b = f. \]",
        BEFORE + r"Neglecting the mass, the width is \[ b = f. \]",
        BEFORE + r"In the limit, we have \[ b = f. \]",
        BEFORE + r"Without drag, the width is \[ b = f. \]",
        BEFORE + r"Setting the derivative to zero, we have \[ b = f. \]",
        BEFORE + r"At rest, it is \[ b = f. \]",
        BEFORE + r"It cannot be that \[ b = f. \] This is false.",
        BEFORE + r"The width is \[ b = f \] if the beam is parallel.",
        BEFORE + r"The width is \[ b = f \] If $t > 0$.",
        BEFORE + r"It stops unless, say, \[ b = f. \]",
        r"\[ y'' = c y. \] The string is held, so \[ y(0) = a. \]",
        r"\[ \mathrm{Var}(X) = 0. \]",
        r"\[ h'' = c h. \] The string is held, so \[ h(L) = a. \]",
        BEFORE + r"The pole is where \[ \cos b = 0. \]",
        BEFORE + r"It turns if \[ \ln b = f. \]",
        r"The angle has \[ \cos t = \sin u. \] The angle has \[ \cos t = \tan u. \]",
        BEFORE + r"The identity is \[ \sin (2 f) = 2 g. \]",
        r"\[ \mathrm{E}(a X) = a \mathrm{E}(X). \]",
        BEFORE + r"If \[ t = b + c, \] it stops.",
        r"\[ \|x\| = a. \] Hence \[ \|x + y\| = a + b. \]",
        r"\[ \langle x \rangle = a. \] Hence \[ \langle x y \rangle = a b. \]",
        r"The speed is \[ v = a t. \] It stops if, say, \[ b = a + t. \]",
        r"\[ a = b. \] Rotations keep lengths: \[ \|R x\| = \|x\|. \]",
        r"It is \[ P V = n T. \] Here $P$ is the pressure. \[ PV = 3 E. \]",
        BEFORE + r"It is wrong that \[ t := b + c. \]",
        r"The sum is of numbers modulo 4. \[ 2 x = 2 y. \] Hence \[ x = y. \]",
        r"\[ a = b. \] \[ \mathbf{x} + \mathbf{y} = \begin{bmatrix} a \\ b \end{bmatrix}. \]",
        r"\[ a = 2 b. \] Then \[ a \in \mathbb{R}. \]",
        r"The value is known. \[ x(n - k) = b. \]",
        r"\[ a b = 1. \] If it is large, \[ b = 2 c. \]",
        r"\[ c < b. \] If it is large, \[ b = 2 c. \]",
        r"\[ h = \sigma(b) = 2 b. \] \[ h = \sigma(b) = 3 b. \]",
        r"\[ x'' = -x. \] \[ \begin{pmatrix} x \\ t \end{pmatrix} = \begin{pmatrix} x \\ a \end{pmatrix}. \]",
    ],
)
def test_a_condition_and_what_holds_but_roughly_gives_no_letter(latex):
    found = verdicts(latex)
    assert "definition" not in found[1:]
    assert found[-1] != "follows"


def test_a_definition_that_is_said_to_follow_says_that_it_was_not_derived():
    found = read_document(document_of(USED + r"Hence we have \[ b = \int_0^1 k \, dx. \]"), seconds=5)
    assert (found[-1].verdict, found[-1].links[0].reason) == ("definition", NOT_DERIVED)
    assert f"definition: {NOT_DERIVED} (line 1)" in reading_lines("a.tex", found, full=False)


@pytest.mark.parametrize(
    "latex",
    [
        SUM + NEXT + r"Let the difference be \[ s = a - b. \] Hence \[ s^2 = a^2 + 2ab + b^2. \]",
        SUM + r"\[ d = 2 s. \] " + NEXT + r"The difference is \[ s = a - b. \] Hence \[ d - 2a = 2 b. \]",
        SUM + r"\[ d = 2 s. \] " + NEXT + r"The difference is \[ s = a - b. \] Hence \[ d - 2a = -2 b. \]",
        SUM + r"\[ s + c = d. \] " + NEXT + r"The difference is \[ s = a - b. \] Hence \[ a - b + c - d = 0. \]",
        SUM + NEXT + r"Suppose now \[ s = a - b. \] Hence \[ 2 s = 2 a + 2 b. \]",
        SUM + NEXT + r"If $b = 0$, then \[ s = a. \] " + r"\section{Other} \[ s - a = 0. \]",
        SUM + NEXT + r"For $b = 0$ we have \[ s = a. \] " + r"\section{Other} \[ 2 s - 2 a = 0. \]",
        r"\section{A} \[ A = \begin{pmatrix} 1 & 0 \\ 0 & 1 \end{pmatrix} \] \section{B} Another matrix is "
        r"\[ A = \begin{pmatrix} 2 & 0 \\ 0 & 2 \end{pmatrix}. \] Its determinant is \[ \det A = 1. \]",
        r"\section{A} \[ f(x) = x^2. \] \section{B} Now \[ f(x) = x^3. \] Hence \[ f(2) = 4. \]",
        r"\section{A} \[ f(x) = x^2. \] \section{B} Now \[ f(x) = x^3. \] Hence \[ f'(x) = 2 x. \]",
        r"\section{A} \[ E(X) = a. \] \section{B} Another one has \[ E(X) = b. \] \[ 2 E(X) = 2 a. \]",
        r"If the sign is positive, then \[ x = a + b. \] \section{Other} If it is negative, then \[ x - a - b = 0. \]",
        r"If the coin is fair, then \[ \mathrm{E}(X) = p. \] \section{Other} \[ 2 \mathrm{E}(X) - 2 p = 0. \]",
        SUM + r"Now we define \[ s = a - b. \] Far away, \[ s^2 = a^2 + 2ab + b^2. \]",
        SUM + r"\[ s + c = d. \] Now we define \[ s = a - b. \] Hence \[ a - b + c - d = 0. \]",
        SUM + r"\[ d = 2 s. \] From now on, $s$ is defined as \[ s = a - b. \] Hence \[ d = 2 a - 2 b. \]",
        r"\[ F(x) = \int_0^x f(t) \, dt. \] \[ F(2) = F(3). \]",
        r"\[ F(x) = \int_0^x f(t) \, dt. \] \[ \frac{dF}{dx} = 0. \]",
        r"\[ \mathrm{Var}(X) = p (1 - p). \] \[ \mathrm{Var}(Y) = p (1 - p). \]",
        r"\[ \mathrm{E}(X) = p. \] \[ \mathrm{E}(X^2) = p^2. \]",
        r"\[ \mathrm{E}[g(X)] = p. \] \[ \mathrm{E}[h(X)] = p. \]",
        r"\[ \mathrm{Var}(X) = p. \] \[ \mathrm{Var}(2 X) = 2 p. \]",
        SUM + NEXT + r"We assume the form \[ s = a - b. \] " + r"\section{Back} \[ (a + b) - s = 0. \]",
    ],
)
def test_what_a_letter_was_in_another_section_or_case_proves_nothing(latex):
    assert verdicts(latex)[-1] not in ("follows", "contradicts")


@pytest.mark.parametrize(
    "latex",
    [
        SUM + r"\[ d = 2 s. \] " + NEXT + r"Again \[ s = b + a. \] Hence \[ d - 2a = 2b. \]",
        SUM + NEXT + r"The difference is \[ s = a - b. \] Hence \[ s^2 = a^2 - 2ab + b^2. \]",
        SUM + NEXT + r"Hence \[ s^2 = a^2 + 2ab + b^2. \]",
        SUM + NEXT + r"It is also \[ s = 5 c. \] Hence \[ s^2 = a^2 + 2ab + b^2. \]",
        r"\[ \mathrm{Var}(X) = p (1 - p). \] Hence \[ 2 \mathrm{Var}(X) = 2 p - 2 p^2. \]",
    ],
)
def test_what_a_letter_still_is_proves(latex):
    assert verdicts(latex)[-1] == "follows"


@pytest.mark.parametrize(
    ("text", "follows"),
    [
        ("The two lengths are\n\n* $a = b + c$\n* $d = b - c$\n\n$$ a + d = 2 b $$\n", True),
        ("The two lengths are\n\n1. $a = b + c$,\n2. $d = b - c$.\n\n$$ a + d = 2 b $$\n", True),
        ("If the rod is short, they are\n\n* $a = b + c$\n* $d = b - c$\n\nIn general, $$ a + d = 2 b $$\n", False),
        ("There are two cases:\n\n* $a = b + c$\n* $a = b - c$\n\n$$ a - c = b $$\n", False),
        ("Which one is wrong?\n\n* $a = b + c$\n* $d = b - c$\n\n$$ a + d = 2 b $$\n", False),
    ],
)
def test_an_inline_formula_that_is_an_item_of_a_list_gives_its_letter(tmp_path, text, follows):
    (tmp_path / "lengths.md").write_text(text, encoding="utf-8")
    readings = read_document(document_at(tmp_path / "lengths.md"))
    assert (readings[-1].verdict == "follows") == follows


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\[ k = p x \] and \[ k = a z \] Hence \[ x = \frac{a z}{p}. \]", "follows"),
        (r"\[ k = p x \] and \[ k = a z \] Hence \[ x = \frac{a z}{2 p}. \]", "contradicts"),
        (r"\[ k = p x \] and \[ k = a z \] Here \[ x = \frac{a z}{p}. \]", "follows"),
        (r"\[ k = p x \] and \[ k = a z \] Here \[ x = \frac{a z}{2 p}. \]", "independent"),
        (r"The mass is \[ m = a t \] with the thickness $t$. Hence \[ \dot{m} = a. \]", "definition"),
        (r"At time $t$ the mass is \[ m = r t. \] The rate $r$ decreases. Hence \[ \dot{m} = r. \]", "definition"),
    ],
)
def test_what_is_said_to_follow_is_derived_before_it_gives_its_letter(latex, verdict):
    assert verdicts(latex)[-1] == verdict


def test_a_letter_that_is_given_by_itself_is_named_as_the_reason():
    (found,) = read_document(document_of(r"\[ g = \begin{bmatrix} 0 \\ -g \\ 0 \end{bmatrix} \]"), seconds=5)
    assert found.links[0].reason == "a letter in it is defined by itself, or its formula is nested too deeply"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ s = D e. \] Hence \[ s = D e + g. \]",
        r"\[ f(x + h) = f(x) + h f'(x) \]",
        r"\[ y = a x. \] It is wrong that \[ y = b + \sum_{i=1}^n \phi(b_i + w_i x). \]",
    ],
)
def test_an_equation_that_fails_or_is_taken_back_gives_no_letter_anew(latex):
    assert verdicts(latex)[-1] != "definition"


NEW = [
    r"\chi^2(m) = \frac{(m - a)^2}{d^2}",
    r"\mathcal{C}^N_S(F) = \{t \in S : F t = 0\}",
    r"R^z = \sum_c z_c^T D^z_c z_c",
    r"w_{ij} = a_{ik} b_{kj}",
    r"u \oplus v = \log(e^u + e^v)",
    r"(\mathcal{D} u)(a, b) = \int_0^\infty u(a + t b) dt",
]


@pytest.mark.parametrize("latex", NEW)
def test_what_no_display_above_has_is_given_though_nobody_computes_it(latex):
    assert verdicts(rf"The quantity is \[ {latex}. \]") == ["definition"]


@pytest.mark.parametrize("latex", NEW)
def test_nor_does_what_is_denied_give_it(latex):
    assert verdicts(rf"It is not true that \[ {latex}. \]") != ["definition"]


def test_an_operation_gives_another_one_and_not_itself():
    once, again = r"x \oplus y = \max(x, y)", r"x \otimes y = a(x \oplus y)"
    assert verdicts(rf"\[ {once} \] \[ {again} \]") == ["definition", "definition"]
    assert verdicts(r"\[ x \oplus y = y \oplus x \]") != ["definition"]
    assert verdicts(rf"\[ {again} \] \[ {once} \]")[-1] != "definition"


@pytest.mark.parametrize("latex", ["2 (3) = 6", "2 (3 + 4) = 14 a", r"\sqrt{2} (3) = x", r"2 \oplus 3 = a"])
def test_a_left_side_without_a_letter_names_none(latex):
    assert verdicts(rf"\[ {latex} \]") != ["definition"]


VALUES = [
    r"E[N_1] = h E[T_1]",
    r"E[N] = \sum_{j=1,2} E[N_j]",
    r"{B_k}_{ii} = x_i - {B_o}_{ii}",
    r"V_t^0(a) = \max_c (c + b V_{t+1}^0(a'))",
]


@pytest.mark.parametrize("latex", VALUES)
def test_a_value_of_its_own_is_given_though_its_letter_has_others(latex):
    above = r"\[ E[T_2] = B_k + V_t. \] "
    assert verdicts(rf"{above} The quantity is \[ {latex}. \]")[-1] == "definition"
    assert verdicts(rf"{above} It is not true that \[ {latex}. \]")[-1] != "definition"


def test_a_constant_factor_may_be_any_and_a_constant_term_may_be_another_one():
    assert verdicts(r"The opacity is \[ k = \mathrm{const}\, r^m T^{-n}. \]") == ["definition"]
    assert verdicts(r"It is \[ k = r + \mathrm{const}. \]") == ["not decided"]


def test_a_density_with_a_condition_is_no_draw():
    assert verdicts(r"We have \[ f(x \mid s) = \sum_i \log \mathcal{N}\left(x_i \mid m, s\right). \]") == ["definition"]
    assert verdicts(r"We have \[ x = \mathcal{N}\left(m, s\right). \]") == ["not decided"]


@pytest.mark.parametrize("value", [r"\frac1n \sum_i f(x_i)", r"L(v) + \nabla L(v) (u - v)"])
def test_what_stands_roughly_for_a_value_is_given_behind_it(value):
    assert verdicts(rf"We estimate the loss as \[ L(u) \approx G(u) = {value}. \]") == ["definition"]
    assert verdicts(rf"It is not true that \[ L(u) \approx G(u) = {value}. \]") != ["definition"]


@pytest.mark.parametrize("latex", ["P(A) = a P(B) + P(C)", "V(x) = r + a V(y)"])
def test_a_probability_or_the_value_of_a_state_is_not_given_by_others(latex):
    assert verdicts(rf"\[ P(C) + V(z) = 1 \] \[ {latex} \]")[-1] != "definition"


WITH_SIGNS = [
    r"The weight is \[ w(t) = \begin{cases} w & \text{$t \leq r$}, \\ 2 w & \text{$t > r$} \end{cases} \]",
    r"The weight is \[ w(t) = \begin{cases} a \text{$t \leq r$}, \\ 2 a \text{$t > r$} \end{cases} \]",
    r"It is \[ w = \begin{cases} a \in U, & \text{if } r = 0, \\ b \in V, & \text{otherwise} \end{cases} \]",
    r"Let \[ A = \left( \begin{array}{cc} 2. & 1. \\ 0.5 & 4. \end{array} \right). \]",
    r"The gain is \[ partial\_gain(x) = e^{g \cdot x} \]",
    r"The new speeds are \begin{eqnarray} u^{n+1} = v^n - h q & & v^{n+1} = w^n - g q \end{eqnarray}",
    r"\[ x_i^p F_i^p(x) > 0. \] The excess is \[ F_i^p(x) = G_i^p(x) - \bar{G}^p(x). \]",
    r"\[ m^p \bar{F}^p(x) > 0. \] The mean is \[ \bar{F}^p(x) = \frac{1}{m^p} \sum_{j \in S^p} x_j^p G_j^p(x). \]",
    r"\[ \mathcal{F} > 0. \] The information is \[ \mathcal{F}(\boldsymbol{\pi}) = \frac{n^k}{\prod_{i=1}^k \pi_i} \]",
    r"The state is \[ (u^{n+1}, v^{n+1}) = L_{u,v}^{-1} (u^n, v^n) \]",
    r"\[ q = h_c^2 + f \] The strain is \[ h_c^2 = \frac{2 G}{3 f^2}. \]",
    r"The weight is \[ w(t) = \begin{cases} \begin{cases} a & \text{$t \leq r$}, \\ b & \text{$t > r$} \end{cases} & "
    r"\text{$h < k$} \\ c & \text{$h \geq k$} \end{cases} \]",
    r"\[ x \sim N(a, v). \] Taking the limit allows any, where the first value is \[ v = p + k q. \]",
    r"\[ v + u > 0. \] If it is large, hence \[ v = \begin{pmatrix} v_0 \\ v_1 \end{pmatrix}. \]",
]


@pytest.mark.parametrize("latex", WITH_SIGNS)
def test_a_letter_is_given_whatever_signs_stand_at_it_or_in_its_value(latex):
    assert verdicts(latex)[-1] == "definition"


@pytest.mark.parametrize(
    "words",
    [
        "Instead, we write the step again, with the times at their places:",
        "We take the weights ($w = 1$ if $j$ is near) and compute:",
        "When $t > 0$,",
    ],
)
def test_words_that_do_not_limit_an_equation_let_it_give_its_letter(words):
    assert verdicts(rf"{USED} {words} \[ b = f \oplus g. \]")[-1] == "definition"


@pytest.mark.parametrize(
    "latex",
    [
        r"The velocity is \[ u = \sum_i u_i = \sum_i m_i g_i. \]",
        r"We have \[ d = x - y = u - v. \]",
        r"\[ a > 0. \] The step is \[ h = a x = y. \]",
    ],
)
def test_a_link_behind_what_gives_a_letter_says_what_new_letters_are(latex):
    assert verdicts(latex)[-1] == "definition"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ x + y > 0. \] We have \[ d = x - y = y - x. \]",
        r"We have \[ s = (x + y)^2 = x^2 + y^2. \]",
        r"\[ x y = u v. \] It is wrong that \[ d = x - y = q. \]",
        r"We have \[ a + b = c = 2 c. \]",
        r"\[ a > 0. \] We have \[ d = a x - y = 0. \]",
        r"\[ a > 0. \] We have \[ d = a x - y = \mathbf{0}. \]",
        r"\[ R > 0. \] We have \[ d = R x = \dot{R} x. \]",
        r"\[ k > 0. \] We have \[ d = \int_0^L k x \, dx = k L. \]",
        r"\[ a > 0. \] The step is \[ h = a x < y. \]",
        r"We have \[ q = 1 \wedge r = s. \]",
    ],
)
def test_a_link_without_new_letters_on_one_side_alone_is_asked(latex):
    assert verdicts(latex)[-1] != "definition"
