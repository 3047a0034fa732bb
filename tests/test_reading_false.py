"""Relations that do not hold, or that nothing decides: none may be said to follow."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

JACOBIAN = (
    r"Let $\theta = \|\boldsymbol\omega\|$. \[ \mathbf{J}_l(\boldsymbol\omega) := I_{3\times3} + "
    r"\frac{1 - \cos\theta}{\theta^2} \boldsymbol\omega^\wedge + "
    r"\frac{\theta - \sin\theta}{\theta^3} (\boldsymbol\omega^\wedge)^2 \] "
)


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ f(x) := \frac{dy}{dx} \] \[ f(2) = f(3) \]",
        r"\[ f(x) := x_1 + x_2 \] \[ f(y) = f(z) \]",
        r"\[ g := x^2 \] \[ f(x) := g + 1 \] \[ f(2) = f(3) \]",
        r"\[ f(x) := \foo{x} + x \] \[ f(y) - y = f(z) - z \]",
        r"\[ f(x) := \sum_{k=0}^x k \] \[ f(2) = f(3) \]",
        r"Let $n = 3$. \[ \sum_n n a_n = \sum_n 3 a_n \]",
        r"Let $n := 3$. \[ \sum_{n=0}^9 n = \sum_{n=0}^9 3 \]",
        r"Let $x := 2$. \[ \int_0^1 x^2 dx = \int_0^1 4 dx \]",
        r"Let $x := 2$. \[ \max_{x \in A} x = \max_{x \in A} 2 \]",
        r"\[ \left. f \right|_{x=0} = \left. f \right|_{x=1} \]",
        r"\[ S_{\{1\}} + 1 = S_1 + 1 \]",
        r"\[ p(x|y) = p(y|x) \]",
        r"\[ a \oplus b = b \oplus a \]",
        r"\[ \nabla \cdot (f \mathbf{v}) = \mathbf{v} \cdot \nabla f \]",
        r"\[ \partial_t (a b) = b \partial_t a \]",
        r"\[ \nabla^2 (a b) = a \nabla^2 b \]",
        r"\[ \operatorname{Var}(2 x) = 2 \operatorname{Var}(x) \]",
        r"\[ \mathbb{E}[x y] = x \mathbb{E}[y] \]",
        r"\[ E[x y] = x E[y] \]",
        r"\[ \Gamma(x + 1) = x \Gamma + \Gamma \]",
        r"\[ \mathrm{Cov}(a x, y) = a \mathrm{Cov}(x, y) \]",
        r"The quaternions $p$ and $q$ have \[ p q = q p. \]",
        r"Here $q$ is a unit quaternion, and $w$ is a vector. \[ \frac12 q w = \frac12 w q \]",
        r"The matrices $A$ and $B$ have \[ (A + B)^2 = A^2 + 2 A B + B^2. \]",
        r"\[ \mathbf{A} \uvec{b} = \uvec{b} \mathbf{A} \]",
        r"\[ (A B)' = (B A)' \]",
        r"\[ \det\boldsymbol\sigma = \mathrm{tr}\boldsymbol\sigma \]",
        r"\[ (\mathrm{tr}\boldsymbol\sigma)^2 = \mathrm{tr}(\boldsymbol\sigma^2) \]",
        r"\[ \mathbf{a}^T = \mathbf{a} \]",
        r"\[ \mathbf{a} \mathbf{b} = \mathbf{b} \mathbf{a} \]",
        r"\[ \mathbf{a}^3 \mathbf{b} = \mathbf{b} \mathbf{a}^3 \]",
        r"\[ \mathbf{a}^T \mathbf{b} = \mathbf{a} \mathbf{b}^T \]",
        r"\[ \mathbf{f}(x)^T = \mathbf{f}(x) \]",
        r"\[ \boldsymbol\sigma : \boldsymbol\tau = \mathrm{tr}(\boldsymbol\sigma \boldsymbol\tau) \]",
        r"The vectors $a$ and $b$ have \[ a b = b a. \]",
        r"\[ (\mathbf{A}\mathbf{B})^{-T} = \mathbf{B}^{-T} \mathbf{A}^{-T} \]",
        r"\[ e^{-T} = e^{-1} \]",
        JACOBIAN
        + r"\[ \mathbf{J}_l(-\boldsymbol\omega) = \exp(\boldsymbol\omega^\wedge) \mathbf{J}_l(\boldsymbol\omega) \]",
        r"\[ \mathbf{f}(\mathbf{x}) := \mathbf{A}\mathbf{x} + \mathbf{b} \] "
        r"\[ \mathbf{f}(\mathbf{x} + \mathbf{y}) = \mathbf{f}(\mathbf{x}) + \mathbf{f}(\mathbf{y}) \]",
        r"\[ \mathbf{c} = \mathbf{B}\mathbf{x} \text{ if } b = 0 \] "
        r"\[ \mathbf{f}(\mathbf{x}) := \mathbf{c} + \mathbf{x} \] "
        r"\[ \mathbf{f}(\mathbf{y}) - \mathbf{y} = \mathbf{f}(\mathbf{w}) - \mathbf{w} \]",
        r"\[ \mathbf{f}(\mathbf{x}) := \sum_i x_i \mathbf{a}_i \] "
        r"\[ \mathbf{f}(\mathbf{y}) = \mathbf{f}(\mathbf{w}) \]",
        r"\[ |2\mathbf{A}|^2 = 4|\mathbf{A}|^2 \]",
        r"\[ \mathbf{a}^2 \mathbf{b} = \mathbf{a} (\mathbf{a} \cdot \mathbf{b}) \]",
        r"Let $z$ be a complex number. \[ |z|^2 = z^2 \]",
        r"The amplitude $z = x + i y$ is complex. \[ |z|^4 = z^4 \]",
        r"The complex amplitude $z = x + i y$. \[ \sqrt{z^2} \sqrt{z^2} = z^2 \] \[ |z|^4 = z^4 \]",
        r"The operators $A$ and $B$ \[ A B = B A \]",
        r"\[ [A, B] = [B, A] \]",
        r"\[ \langle a | b \rangle = \langle b | a \rangle \]",
        r"\[ \binom{n}{k} = \binom{k}{n} \]",
        r"\[ f(g(x)) = g(f(x)) \]",
        r"\[ f \circ g = g \circ f \]",
        r"\[ \delta_{ij} = \delta_{ji} \]",
        r"\[ \epsilon_{ijk} = \epsilon_{jik} \]",
        r"\[ A_{ij} = A_{ji} \]",
        r"\[ \mathbf{T}_{ij} = \mathbf{T}_{ji} \]",
        r"\[ \{a, b\} = \{b, c\} \]",
        r"\[ \vec a \times \vec b = \vec b \times \vec a \]",
        r"\[ a \wedge b = b \wedge a \]",
        r"\[ q \otimes p = p \otimes q \]",
        r"\[ q \ast p = p \ast q \]",
        r"\[ x(t) \ast h(t) = h(t) \ast x(t) + 0 \]",
        r"\[ \lim_{x \to 0} f(x) = f(0) \]",
        r"\[ \nabla f g = g \nabla f \]",
        r"\[ \frac{\partial f}{\partial x} \frac{\partial x}{\partial f} = 1 \]",
        r"\[ \frac{\partial x}{\partial y}\frac{\partial y}{\partial z}\frac{\partial z}{\partial x} = 1 \]",
        r"\[ \int f \, dx \int g \, dx = \int f g \, dx \]",
        r"\[ \sum_i a_i \sum_i b_i = \sum_i a_i b_i \]",
        r"\[ \sum_i a_i^2 = (\sum_i a_i)^2 \]",
        r"\[ \sum_{i} a_i = \sum_{j} a_i \]",
        r"\[ \prod_i 2 a_i = 2 \prod_i a_i \]",
        r"\[ \mathbb{E}[x]^2 = \mathbb{E}[x^2] \]",
        r"\[ \langle x^2 \rangle = \langle x \rangle^2 \]",
        r"\[ \overline{x^2} = \bar{x}^2 \]",
        r"\[ \dot{(x y)} = \dot x \dot y \]",
        r"\[ \frac{d}{dt}(x y) = \frac{dx}{dt} y \]",
        r"\[ a \bmod b = a \]",
        r"\[ \lfloor x \rfloor = x \]",
        r"\[ \lceil x + 1 \rceil = x + 1 \]",
        r"\[ x^{(2)} = x^2 \]",
        r"\[ f^2(x) = f(x)^2 + f(f(x)) \]",
        r"\[ \sin^{-1} x = \frac{1}{\sin x} \]",
        r"\[ A^{*} = A \]",
        r"\[ A^\dagger A = A A^\dagger \]",
        r"\[ \mathbf{A}^+ \mathbf{A} = \mathbf{I} \]",
        r"\[ x' = x \]",
        r"\[ (x y)' = x' y' \]",
        r"\[ x_i y_i = x_j y_j \]",
        r"\[ |A B| = |B| |A| + |A| |B| - |A| |B| \] where $A$ is a set.",
        r"\[ P(A \cap B) = P(A) P(B) \]",
        r"\[ P(A|B) = P(B|A) \]",
        r"\[ a_{x} = \frac{\partial a}{\partial x} \]",
        r"\[ u_{xy} = u_x u_y \]",
        r"\[ \log_2 x = \log_3 x \]",
        r"\[ 1{,}000 = 1 \]",
        r"\[ F = 32,5 + a \] \[ F = 32,1 + b \]",
        r"\[ 3.14 = \pi \]",
        r"\[ 0.333 = 1/3 \]",
        r"\[ 10^{-3}\,\mathrm{km} = 1 \]",
        r"\[ 5\,\mathrm{m} = 5\,\mathrm{s} \]",
        r"\[ x \equiv x + 7 \pmod 7 \]",
        r"\[ f_{,i} = f_i \]",
        r"\[ R_1 R_2 = R_2 R_1 \] where $R_1$ and $R_2$ are rotation matrices.",
        r"The rotation $R$ and the vector $v$: \[ R v = v R \]",
        r"\[ \exp(A)\exp(B) = \exp(A + B) \] with matrices $A$ and $B$.",
        r"\[ e^{A} e^{B} = e^{B} e^{A} \] with matrices $A$ and $B$.",
        r"\[ e^{\mathbf{A}} e^{\mathbf{B}} = e^{\mathbf{A}+\mathbf{B}} \]",
        r"\[ \mathrm{tr}(A B) = \mathrm{tr}(A)\mathrm{tr}(B) \]",
        r"\[ \det(A + B) = \det A + \det B \]",
        r"\[ (A + B)^{-1} = A^{-1} + B^{-1} \]",
        r"\[ \mathbf{a}\cdot\mathbf{b}\,\mathbf{c} = \mathbf{a}\,\mathbf{b}\cdot\mathbf{c} \]",
        r"\[ \|\mathbf{a}+\mathbf{b}\| = \|\mathbf{a}\|+\|\mathbf{b}\| \]",
        r"\[ \mathbf{a}\mathbf{a}^T = \mathbf{a}^T\mathbf{a} \]",
        r"\[ x \sim y \] \[ x - y = 0 \]",
        r"\[ x \approx y \] \[ x - y = 0 \]",
        r"\[ x \propto y \] \[ x = y \]",
        r"\[ x \geq y \] \[ x = y \]",
        r"\[ x \to y \] \[ x = y \]",
        r"\[ x \mapsto x^2 \] \[ x = x^2 \]",
        r"\[ x \neq y \] \[ x - y = 0 \]",
        r"\[ x \overset{?}{=} y \] \[ x - y = 0 \]",
        r"It is false that \[ x = y \] \[ x - y = 0 \]",
        r"\[ x = y \] is wrong. \[ x - y = 0 \]",
        r"\[ x = y \text{ if } t > 0 \] \[ x - y = 0 \]",
        r"\[ x = \begin{cases} y & t > 0 \\ 0 & t \le 0 \end{cases} \] \[ x - y = 0 \]",
        r"\[ f(x) = x \quad \text{(1D)} \] \[ f(y) - y = 0 \]",
        r"% \[ x = y \]" "\n" r"\[ x - y = 0 \]",
        r"\iffalse \[ x = y \] \fi \[ x - y = 0 \]",
        r"\begin{verbatim} \[ x = y \] \end{verbatim} \[ x - y = 0 \]",
        r"\footnote{Not $x = y$.} \[ x - y = 0 \]",
        r"\newcommand{\x}{y} \[ x - \x = 0 \]",
        r"\[ u_{i,j} = u_{ij} \]",
        r"\[ u_{,x} = u_x \]",
        r"\[ a \overset{!}{=} b \] \[ a = b + c - c \] \[ c a = c b + 1 \]",
        r"\[ A = \begin{bmatrix} 0 & 0 \\ 0 & 0 \end{bmatrix}, \quad A x = b \] Hence \[ x = A^{-1} b. \]",
        r"\[ A = \begin{bmatrix} 1 & 2 \\ 2 & 4 \end{bmatrix} \] \[ A x = b \] Hence \[ x = A^{-1} b. \]",
        r"\[ A = \begin{bmatrix} a & b \\ 2 a & 2 b \end{bmatrix} \] \[ A x = c \] Hence \[ x = A^{-1} c. \]",
        r"\[ \mathbf{P} = \mathbf{I} - \mathbf{n} \mathbf{n}^T, \quad \mathbf{y} = \mathbf{P} \mathbf{x} \] "
        r"where $\mathbf{n}$ is a unit vector. Hence \[ \mathbf{x} = \mathbf{P}^{-1} \mathbf{y}. \]",
        r"\[ \mathbf{P} = \mathbf{I} - \mathbf{n} \mathbf{n}^T, \quad \mathbf{n}^T \mathbf{n} = 1 \] "
        r"\[ \mathbf{y} = \mathbf{P} \mathbf{x} \] Hence \[ \mathbf{x} = \mathbf{P}^{-1} \mathbf{y}. \]",
        r"\[ u = c x_k \] \[ x_{k+1} = a x_k + u \] Hence \[ x_{k+2} = a x_{k+1} + c x_k. \]",
        r"\[ x_{k+1} = a x_k + u \] \[ u = -c x_k \] Hence \[ x_{k+2} = a x_{k+1} + u. \]",
        r"\[ K = \frac{P_k}{P_k + R} \] \[ x_{k+1} = x_k + K (z_k - x_k) \] Hence "
        r"\[ x_{k+2} = x_{k+1} + K (z_{k+1} - x_{k+1}). \]",
        r"\[ c = x_k \] Hence \[ \frac1n \sum_{k=1}^n (x_k - c)^2 = 0. \]",
        r"\[ c = d + 1 \] \[ d = a_i \] Hence \[ \sum_{i=1}^n c x_i = c \sum_{i=1}^n x_i. \]",
        r"\[ c = a_i \] Hence \[ \prod_{i=1}^n c = \prod_{i=1}^n a_i. \]",
        r"\[ c = a_i \] Hence \[ \max_i c = \max_i a_i. \]",
        r"\[ s = \sum_j a_{ij} \] Hence \[ \sum_i \sum_j s = \sum_i \sum_j \sum_j a_{ij}. \]",
        r"\[ \mathbf{u} = \mathbf{x}_i \] Hence "
        r"\[ \sum_i \mathbf{u}^T \mathbf{y}_i = \mathbf{u}^T \sum_i \mathbf{y}_i. \]",
        r"\[ \dot x = A x + B u, \quad u = -K x \] Hence \[ \dot x = A x - K B x. \]",
        r"\[ x_{k+1} = F x_k + G u_k + w_k \] \[ u_k = -K x_k \] Hence \[ x_{k+1} = F x_k - K G x_k + w_k. \]",
        r"\[ \dot z = A z + L (y - C z), \quad y = C x \] Hence \[ \dot z = A z + C L (x - z). \]",
        r"\[ T_{12} = T_1^{-1} T_2 \] Hence \[ T_{12} = T_2 T_1^{-1}. \]",
        r"\[ A X = X B \] Hence \[ A = B. \]",
        r"\[ x_b = C_{ba} x_a, \quad x_c = C_{cb} x_b \] Hence \[ x_c = C_{ba} C_{cb} x_a. \]",
        r"Here $G(s) = C (s I - A)^{-1} B$. \[ G = C F B \] Hence \[ G = B C F. \]",
        r"\[ y = a \] is not the same as \[ = b. \] Hence \[ a = b. \]",
        r"\[ \mathbf{H} = \mathbf{X} (\mathbf{X}^T \mathbf{X})^{-1} \mathbf{X}^T \] Hence "
        r"\[ \mathbf{H} = \mathbf{X} \mathbf{X}^{-1} \mathbf{X}^{-T} \mathbf{X}^T. \]",
    ],
)
def test_what_does_not_hold_does_not_follow(latex):
    assert read_document(document_of(latex))[-1].verdict not in ("follows", "contradicts")


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ f(x) := x^2 + 1 \] \[ f(2) = 5 \]",
        r"\[ f(x, y) := x y \] \[ f(2, 3) = 6 \]",
        r"\[ \mathbf{\hat s} + \hat{\mathbf{s}} = 2 \mathbf{\hat{s}} \]",
        r"\[ \sum_n 2 a_n = 2 \sum_n a_n \]",
        r"\[ 2 \operatorname{Var}(x + y) - \operatorname{Var}(x + y) = \operatorname{Var}(x + y) \]",
        r"The matrices $A$ and $B$ have \[ (A + B)^2 = A^2 + A B + B A + B^2. \]",
        r"\[ (\mathrm{tr}\boldsymbol\sigma)^2 - \mathrm{tr}(\boldsymbol\sigma)\mathrm{tr}(\boldsymbol\sigma) = 0 \]",
        r"\[ \boldsymbol\sigma : \boldsymbol\tau = \mathrm{tr}(\boldsymbol\tau^T \boldsymbol\sigma) \]",
        r"\[ \mathbf{S} = J \mathbf{F}^{-1} \boldsymbol\sigma \mathbf{F}^{-T} \] "
        r"\[ \boldsymbol\sigma = \frac1J \mathbf{F} \mathbf{S} \mathbf{F}^T \]",
        r"Let $R \in SO(3)$. \[ T := \begin{bmatrix} R & \mathbf{t} \\ \mathbf{0}^T & 1 \end{bmatrix} \] "
        r"\[ T^{-1} = \begin{bmatrix} R^T & -R^T \mathbf{t} \\ \mathbf{0} & 1 \end{bmatrix} \]",
        r"For a rotation matrix $R$ \[ T := \begin{bmatrix} R & \mathbf{t} \\ \mathbf{0} & 1 \end{bmatrix} \] "
        r"\[ T^{-1} = \begin{bmatrix} R^T & -R^T \mathbf{t} \\ \mathbf{0} & 1 \end{bmatrix} \]",
        r"\[ \mathbf{A}\mathbf{0} = \mathbf{0} \]",
        r"\[ \sum_{i=1}^n (\hat{y}_i - \hat{z}_i)^2 = \sum_{i=1}^n \hat{y}_i^2 - 2 \sum_{i=1}^n \hat{y}_i \hat{z}_i "
        r"+ \sum_{i=1}^n \hat{z}_i^2 \]",
        JACOBIAN + r"\[ \mathbf{J}_l(\boldsymbol\omega) = \mathbf{J}_l(-\boldsymbol\omega)^T \]",
        JACOBIAN
        + r"\[ \mathbf{J}_l(\boldsymbol\omega) = \exp(\boldsymbol\omega^\wedge) \mathbf{J}_l(-\boldsymbol\omega) \]",
        r"\[ \mathbf{f}(\mathbf{x}) := \mathbf{A}\mathbf{x} \] "
        r"\[ \mathbf{f}(\mathbf{x} + \mathbf{y}) = \mathbf{f}(\mathbf{x}) + \mathbf{f}(\mathbf{y}) \]",
        r"\[ (\mathbf{a} + \mathbf{b})^2 = \mathbf{a}^2 + 2\mathbf{a}\cdot\mathbf{b} + \mathbf{b}^2 \]",
        r"\[ |2\mathbf{a}|^2 = 4|\mathbf{a}|^2 \]",
        r"\[ (\mathbf{A}\mathbf{B})^{-\top} = \mathbf{A}^{-\top} \mathbf{B}^{-\top} \]",
        r"\[ \boldsymbol\omega^T \boldsymbol\alpha = \boldsymbol\alpha^T \boldsymbol\omega \]",
        r"\[ \mathbf{s} = \boldsymbol\sigma - \frac13 \mathrm{tr}(\boldsymbol\sigma) I_{3\times3} \] "
        r"\[ \mathrm{tr}\,\mathbf{s} = 0 \]",
        r"\[ \exp([\mathbf{a}]_\times)^T \exp([\mathbf{a}]_\times) = I_{3\times3} \]",
        r"Let $\theta = \|\mathbf{a}\|$. "
        r"\[ \exp([\mathbf{a}]_\times) = I_{3\times3} + \frac{\sin\theta}{\theta} [\mathbf{a}]_\times + "
        r"\frac{1 - \cos\theta}{\theta^2} [\mathbf{a}]_\times^2 \]",
        r"\[ \dot x = A x + B u, \quad u = -K x \] Hence \[ \dot x = (A - B K) x. \]",
        r"\[ T_{12} = T_1^{-1} T_2 \] Hence \[ T_2 = T_1 T_{12}. \]",
        r"\[ x_b = C_{ba} x_a, \quad x_c = C_{cb} x_b \] Hence \[ x_c = C_{cb} C_{ba} x_a. \]",
        r"\[ v = R i + L p \] \[ i = G v \] Hence \[ v = \frac{L p}{1 - G R}. \]",
        r"\[ y = A c + B s \] Hence \[ y^2 = A^2 c^2 + 2 A B c s + B^2 s^2. \]",
    ],
)
def test_what_holds_follows(latex):
    assert read_document(document_of(latex))[-1].verdict == "follows"


def test_values_of_functions_of_vectors_that_differ_contradict():
    false = r"\[ \mathbf{J}_l(\boldsymbol\omega) = \mathbf{J}_l(-\boldsymbol\omega) \]"
    assert read_document(document_of(JACOBIAN + false))[-1].verdict == "contradicts"


def test_a_value_at_zero_is_no_product():
    (found,) = read_document(document_of(r"\[ z_1(0) - z_3(0) \cdot 0.5 = 0 \]"), seconds=5)
    assert found.verdict not in ("follows", "contradicts")


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (r"x_{11,2} = x_{1,12}", False),
        (r"x_{k+1,2} = x_{k+12}", False),
        (r"x_{A,BC} = x_{AB,C}", False),
        (r"x_{i_{1},2} = x_{i_{12}}", False),
        (r"x^{11,2} = x^{1,12}", False),
        (r"x^{(11,2)} = x^{(1,12)}", False),
        (r"x_{1,2} = x_{12}", True),
        (r"x_{11,2} = x_{11, 2}", True),
    ],
)
def test_a_comma_parts_indices_of_several_signs(latex, follows):
    (found,) = read_document(document_of(rf"\[ {latex} \]"))
    assert (found.verdict == "follows") is follows
