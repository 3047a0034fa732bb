"""Which letters are vectors and matrices: what is so for numbers alone does not follow of them."""

import pytest

from algebroproj_sym.reading import document_of, read_document
from algebroproj_sym.reading.defining.symbols import SymbolsFile
from algebroproj_sym.reading.remembering.survey import Survey

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def last_verdict(latex: str) -> str:
    return read_document(document_of(latex))[-1].verdict


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ A = \begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} \] "
        r"\[ B = \begin{bmatrix} 0 & 1 \\ 1 & 0 \end{bmatrix} \] \[ A B = B A \]",
        r"\[ A = \begin{bmatrix} a & b \\ c & d \end{bmatrix} \] \[ x = \begin{bmatrix} p \\ q \end{bmatrix} \] "
        r"\[ A^2 x = x A^2 \]",
        r"\[ \mathbf{y} = X \mathbf{b} \] \[ \mathbf{b} = \mathbf{y} X^{-1} \]",
        r"\[ \mathbf{y} = A B \mathbf{x} \] \[ \mathbf{y} = B A \mathbf{x} \]",
        r"\[ \mathbf{u} = A \mathbf{v} + B \mathbf{w} \] \[ C \mathbf{u} = A C \mathbf{v} + B C \mathbf{w} \]",
        r"\[ \mathbf{x}^T A \mathbf{y} = \mathbf{y}^T A \mathbf{x} \]",
        r"\[ \mathbf{r} = P H^T S^{-1} \mathbf{y} \] \[ \mathbf{r} = H^T P S^{-1} \mathbf{y} \]",
        r"\[ P = A P_0 A^T + Q \] \[ P = A A^T P_0 + Q \]",
        r"\[ S = H P H^T + R \] \[ K = P H^T S^{-1} \] \[ K S = S K \]",
        r"\[ S = H P H^T + R \] \[ K = P H^T S^{-1} \] \[ K = S^{-1} P H^T \]",
        r"\[ y = z - c \] Here $y$ is a vector. \[ K = P H^T S^{-1} \] \[ x = K y \] \[ x = H^T P S^{-1} y \]",
        r"\[ x_{k+1} = A x_k + B u_k \] where $x_k$ is the state vector. \[ A x_k = x_k A \]",
        r"The vectors are \[ \bar c = \bar a \times \bar b \] \[ \bar c = \bar b \times \bar a \]",
        r"The velocity vector is \[ \bar v = \bar\omega \times \bar r \] "
        r"\[ \bar\omega \times \bar v = \bar\omega^2 \bar r \]",
        r"\[ \underline v = \underline w \times \underline r \] \[ \underline v = \underline r \times \underline w \]",
        r"\[ \tilde a = \tilde\omega \times (\tilde\omega \times \tilde r) \] "
        r"\[ \tilde a = (\tilde\omega \times \tilde\omega) \times \tilde r \]",
        r"The velocity vector is \[ \frac{d\bar r}{dt} = \frac{\delta\bar r}{\delta t} + \bar\omega \times \bar r \] "
        r"\[ \bar\omega \times \frac{d\bar r}{dt} = \bar\omega\times\frac{\delta\bar r}{\delta t} "
        r"+ \bar r \times (\bar\omega \times \bar\omega) \]",
        r"The vector \[ \bar r_{12} = \bar r_2 - \bar r_1 \] "
        r"\[ \bar r_1 \times \bar r_{12} = \bar r_2 \times \bar r_1 \]",
        r"\[ \mathbf{F} = \frac{d\mathbf{p}}{dt} \] "
        r"\[ \mathbf{r} \times \mathbf{F} = \frac{d\mathbf{p}}{dt} \times \mathbf{r} \]",
        r"Here $A$ is a matrix. \[ b = A x \] \[ c = A b \] \[ c = x A A \]",
        r"Here $A$ and $B$ are matrices. \[ y = A x + B u \] \[ y = x A + u B \]",
        r"The Jacobian matrix is $J$. \[ d = J^{-1} e \] \[ d = e J^{-1} \]",
        r"\[ f = k^T x \] \[ f = x k^T \]",
        r"\[ f = ||\mathbf{x} - \mathbf{c}||^2 \] \[ f = ||\mathbf{x}||^2 + ||\mathbf{c}||^2 \]",
        r"\[ f = ||\mathbf{x}||||\mathbf{c}|| \] \[ f = ||\mathbf{x}^T\mathbf{c}|| \]",
        r"\[ S = x y^T \] \[ S = y^T x \]",
        r"\[ (X^T X)^{-1} X^T = X^{-1} \]",
        r"\[ \mathbf{x} = (A^T A)^{-1} A^T \mathbf{b} \] \[ \mathbf{x} = A^{-1} \mathbf{b} \]",
        r"\[ S = X^T X \] \[ \mathbf{b} = S^{-1} X^T \mathbf{y} \] \[ \mathbf{b} = X^{-1} \mathbf{y} \]",
        r"\[ \mathbf{L} = I \boldsymbol\omega \] "
        r"\[ \boldsymbol\omega \times \mathbf{L} = I \boldsymbol\omega \times \boldsymbol\omega \]",
        r"\[ \left(\frac{\partial\mathbf{f}}{\partial\mathbf{x}}\right)^T \mathbf{v} "
        r"= \mathbf{v}^T \frac{\partial\mathbf{f}}{\partial\mathbf{x}} \]",
        r"\[ \mathrm{diag}(\mathbf{A}, \mathbf{B})^T = \mathrm{diag}(\mathbf{A}, \mathbf{B}) \]",
        r"\[ \mathrm{diag}(\mathbf{x})^T = \mathrm{diag}(\mathbf{x}) \]",
        r"\[ A = \begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} \] "
        r"\[ \mathrm{diag}(5, A) = \begin{bmatrix} 1 & 2 & 0 \\ 3 & 4 & 0 \\ 0 & 0 & 5 \end{bmatrix} \]",
        r"Here $\omega$ and $\chi$ are rotations. \[ a = \cos(\omega^T n) \] "
        r"\[ b = \omega \chi \] \[ b = \chi \omega \]",
        r"Here $R$ and $S$ are rotations. \[ a = \sin R \sin S \] \[ b = R S \] \[ b = S R \]",
        r"The means are \[ \bar x = \frac1n\sum_{i=1}^n x_i \] \[ \bar y = \frac1n\sum_{i=1}^n y_i \] "
        r"They are no vectors: \[ \bar x \times \bar x = 0 \]",
    ],
)
def test_what_holds_of_numbers_alone_does_not_follow_of_vectors_and_matrices(latex):
    assert last_verdict(latex) != "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \mathbf{y} = X \mathbf{b} \] \[ \mathbf{b} = X^{-1} \mathbf{y} \]",
        r"\[ \mathbf{y} = P Q \mathbf{b} \] \[ \mathbf{c} = Q \mathbf{b} \] \[ \mathbf{y} = P \mathbf{c} \]",
        r"\[ S = H P H^T + R \] \[ K = P H^T S^{-1} \] \[ K S = P H^T \]",
        r"\[ x = u + P H^T S^{-1} y \] where $y$ is the residual vector. \[ K = P H^T S^{-1} \] \[ x = u + K y \]",
        r"\[ \mathbf{F} = G \frac{M m}{r^3} \mathbf{r} \] "
        r"\[ \mathbf{p} \times \mathbf{F} = G M m \frac{\mathbf{p} \times \mathbf{r}}{r^3} \]",
        r"The velocity vector is \[ \frac{d\bar r}{dt} = \frac{\delta\bar r}{\delta t} + \bar\omega \times \bar r \] "
        r"\[ \bar\omega \times \frac{d\bar r}{dt} = \bar\omega\times\frac{\delta\bar r}{\delta t} "
        r"+ \bar\omega \times (\bar\omega \times \bar r) \]",
        r"The vectors \[ \frac{\delta^2\bar r}{\delta t^2} = \bar g - \bar\omega \times \bar v \] "
        r"\[ \frac{\delta^2\bar r}{\delta t^2} = \bar v \times \bar\omega + \bar g \]",
        r"\[ \hat{x}_t = \bar{x}_t + \Delta{x}_t \] \[ \Delta{x}_t = P H^T y y^T \] "
        r"\[ \hat{x}_t = \bar{x}_t + P H^T y y^T \]",
        r"Here $A$ is a matrix. \[ b = A x \] \[ c = A b \] \[ c = A A x \]",
        r"The system matrix is $A$. \[ \dot x = A x + B u \] \[ y = C \dot x \] \[ y = C A x + C B u \]",
        r"\[ (X^T X)^{-1} X^T = X^{-1} \] where $X$ is square.",
        r"\[ g = J^T r \] \[ H = J^T J \] \[ d = -H^{-1} g \] \[ d = -(J^T J)^{-1} J^T r \]",
        r"\[ \mathbf{K} = (I - \mathbf{A})^{-1} \] \[ \mathbf{K}^{-1} = I - \mathbf{A} \]",
        r"Let $A = \begin{bsmallmatrix} 1 & 2 \\ 3 & 4 \end{bsmallmatrix}$ and $B = 5$. \[ \mathrm{diag}(A, B) = "
        r"\begin{bmatrix} A & 0 \\ 0 & B \end{bmatrix} = "
        r"\begin{bmatrix} 1 & 2 & 0 \\ 3 & 4 & 0 \\ 0 & 0 & 5 \end{bmatrix} \]",
        r"\[ \mathbf{v} = \frac{d\mathbf{r}}{dt} \] "
        r"\[ \mathbf{v}\cdot\mathbf{w} = \mathbf{w}\cdot\frac{d\mathbf{r}}{dt} \]",
        r"\[ p = \bar x \times 0.5 \] \[ p = 0.5 \times \bar x \]",
        r"\[ p = a \times b \] \[ p = b \times a \]",
        r"\[ \bar x = \frac1n\sum_{i=1}^n x_i \] \[ p = \bar x \times \bar y \] \[ p = \bar y \times \bar x \]",
        r"\[ f = ||\mathbf{x} - \mathbf{c}||^2 \] "
        r"\[ f = ||\mathbf{x}||^2 - 2 \mathbf{c}^T \mathbf{x} + ||\mathbf{c}||^2 \]",
        r"\[ s = \sum_i ||\mathbf{x}_i||^2 \] \[ a s = \sum_i a ||\mathbf{x}_i||^2 \]",
        r"Here $\Omega$ is defined by a rotation about $z$. \[ a = \sin\Omega + b \sin\Omega \] "
        r"\[ a = (1 + b) \sin\Omega \]",
        r"\[ \mathbf{y} = A\,\space\mathbf{x} \] \[ \mathbf{y} + \space\mathbf{y} = 2 A \mathbf{x} \]",
    ],
)
def test_what_holds_of_vectors_and_matrices_follows(latex):
    assert last_verdict(latex) == "follows"


def test_letters_are_of_one_kind_where_they_are_added_or_equal():
    kinds = Survey(
        document_of(r"Let $y$ be a vector. \[ y = z - h(x) \] \[ z = w + 2 v \] \[ n = 3 k \]"), SymbolsFile()
    ).kinds
    assert kinds.no_numbers == {"y", "z", "h", "w", "v"}


def test_a_sum_and_a_quotient_are_of_the_kind_of_their_letter():
    latex = r"\[ \mathbf{v} = \frac{p}{m} + q \] \[ q = \sum_i q_i \] \[ s = \frac{t}{k} \]"
    assert Survey(document_of(latex), SymbolsFile()).kinds.no_numbers == {r"\mathbf{v}", "p", "q", "q_i"}


def test_a_product_that_is_no_number_has_a_matrix():
    kinds = Survey(document_of(r"\[ \mathbf{C} = A B \] \[ d = E F \]"), SymbolsFile()).kinds
    assert kinds.open == {"A", "B"}


def test_the_letters_of_an_alphabet_that_is_declared_as_bold_are_bold():
    alphabet = r"\DeclareMathAlphabet{\mbfa}{OT1}{ptm}{b}{n} "
    latex = r"\[ \mbfa{y} = \mbfa{A} \mbfa{x} \] \[ \mbfa{y}^T = \mbfa{x}^T \mbfa{A}^T \]"
    assert last_verdict(alphabet + latex) == "follows"
    assert (
        last_verdict(alphabet + r"\[ \mbfa{y} = \mbfa{A} \mbfa{x} \] \[ \mbfa{y} = \mathbf{A} \mathbf{x} \]")
        != "follows"
    )
    assert (
        last_verdict(alphabet + r"\[ \mbfa{y} = \mbfa{A} \mbfa{B} \] \[ \mbfa{y} = \mbfa{B} \mbfa{A} \]") != "follows"
    )


def test_operators_that_are_signs_are_no_letters_with_a_hat():
    latex = r"\[ \hat a = b + c \] \[ \hat a - b = c \]"
    assert last_verdict(r"The operators $\wedge$ and $\vee$ are inverse. " + latex) == "follows"
    assert last_verdict(r"The operators $\hat a$ and $\hat b$ commute not. " + latex) != "follows"
    assert last_verdict("These are operators. " + latex) != "follows"


def test_the_accent_of_vectors_holds_for_all_letters_that_have_it_but_for_no_index():
    latex = r"\[ \bar v = \bar\omega \times (\bar\omega \times \bar r_{ij}) \] \[ m_{\bar a} = \hat m \]"
    kinds = Survey(document_of(latex), SymbolsFile()).kinds
    assert kinds.columns == {r"\bar{v}", r"\bar{\omega}", r"\bar{r}_{ij}"}


@pytest.mark.parametrize(
    ("latex", "found"),
    [
        (r"\[ \mathbf{y} = X \mathbf{b} \]", {"X"}),
        (r"\[ \mathbf{y} = (A + 2 B) (\mathbf{b} + \mathbf{c}) \]", {"A", "B"}),
        (r"\[ \mathbf{F} = \frac{M \mathbf{a}}{c} \]", set()),
        (r"\[ \mathbf{F} = M \mathbf{a} + \frac{\mathbf{c}}{M} \]", set()),
        (r"\[ \mathbf{F} = G \frac{M}{r^3} \mathbf{r} \]", set()),
        (r"\[ \mathbf{F} = m \mathbf{a} \]", set()),
    ],
)
def test_a_thin_capital_beside_a_vector_may_be_a_matrix_unless_it_is_a_number_elsewhere(latex, found):
    assert Survey(document_of(latex), SymbolsFile()).kinds.open == found


@pytest.mark.parametrize(
    ("latex", "found"),
    [
        (r"Set $\omega = 2$. \[ a = b \]", set()),
        (r"The set $A = B$. \[ a = b \]", {"A"}),
        (r"The numbers $\{x_i\}$ are a set. \[ a = b \]", set()),
        (r"The state vector is $x$. The rank of the matrix is $n$. \[ a = b \]", {"x"}),
    ],
)
def test_words_call_a_letter_a_vector_or_a_set(latex, found):
    assert Survey(document_of(latex), SymbolsFile()).kinds.no_numbers == found


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \mathbf{L} = \mathbf{r} \times \mathbf{p} \] "
        r"\[ \dot{\mathbf{L}} = \dot{\mathbf{r}} \times \mathbf{p} + \mathbf{r} \times \dot{\mathbf{p}} \]",
        r"\[ \mathbf{L} = \mathbf{r} \times \mathbf{p} \] \[ \frac{d\mathbf{L}}{dt} = "
        r"\frac{d\mathbf{r}}{dt} \times \mathbf{p} + \mathbf{r} \times \frac{d\mathbf{p}}{dt} \]",
        r"\[ \mathbf{r} = r \mathbf{e}_r \] \[ \dot{\mathbf{r}} = \dot r \mathbf{e}_r + r \dot{\mathbf{e}}_r \]",
        r"\[ \mathbf{e}_r = \cos\theta \mathbf{i} + \sin\theta \mathbf{j} \] "
        r"\[ \dot{\mathbf{e}}_r = \dot\theta (-\sin\theta \mathbf{i} + \cos\theta\mathbf{j}) \]",
        r"\[ \mathbf{v} = \frac{\mathbf{p}}{m} \] "
        r"\[ \dot{\mathbf{v}} = \frac{\dot{\mathbf{p}}}{m} - \frac{\dot m \mathbf{p}}{m^2} \]",
        r"\[ \mathbf{A} = \mathbf{B}^2 \] "
        r"\[ \dot{\mathbf{A}} = \dot{\mathbf{B}} \mathbf{B} + \mathbf{B} \dot{\mathbf{B}} \]",
        r"\[ \mathbf{r} = \mathbf{r}_0 + \mathbf{v} t + \frac12 \mathbf{a} t^2 \] "
        r"\[ \dot{\mathbf{r}} = \mathbf{v} + \mathbf{a} t \]",
        r"\[ \mathbf{r}(t) = x(t) \mathbf{e}_1 + y(t) \mathbf{e}_2 \] "
        r"\[ \frac{d\mathbf{r}(t)}{dt} = \frac{dx(t)}{dt} \mathbf{e}_1 + \frac{dy(t)}{dt} \mathbf{e}_2 \]",
        r"With constant $m$ and $g$ \[ E = \frac12 m v^2 + m g y \] "
        r"\[ \frac{dE}{dt} = m v \frac{dv}{dt} + m g \frac{dy}{dt} \]",
    ],
)
def test_the_derivative_of_vectors_is_taken_factor_by_factor(latex):
    assert last_verdict(latex) == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \mathbf{L} = \mathbf{r} \times \mathbf{p} \] "
        r"\[ \dot{\mathbf{L}} = \dot{\mathbf{r}} \times \mathbf{p} + \dot{\mathbf{p}} \times \mathbf{r} \]",
        r"\[ \mathbf{L} = \mathbf{r} \times \mathbf{p} \] "
        r"\[ \dot{\mathbf{L}} = \dot{\mathbf{r}} \times \dot{\mathbf{p}} \]",
        r"\[ \mathbf{r} = r \mathbf{e}_r \] \[ \dot{\mathbf{r}} = \dot r \mathbf{e}_r \]",
        r"\[ \mathbf{r} = r \hat{\mathbf{r}} \] \[ \dot{\mathbf{r}} = \dot r \hat{\mathbf{r}} \]",
        r"\[ \mathbf{p} = \mathbf{R} \mathbf{q} \] \[ \dot{\mathbf{p}} = \mathbf{R} \dot{\mathbf{q}} \]",
        r"\[ \mathbf{p} = R \mathbf{q} \] \[ \dot{\mathbf{p}} = R \dot{\mathbf{q}} \]",
        r"\[ \mathbf{v} = \boldsymbol\omega \times \mathbf{r} \] "
        r"\[ \dot{\mathbf{v}} = \boldsymbol\omega \times \dot{\mathbf{r}} \]",
        r"\[ \mathbf{A} = \mathbf{B}^2 \] \[ \dot{\mathbf{A}} = 2 \mathbf{B} \dot{\mathbf{B}} \]",
        r"\[ \mathbf{A} = \mathbf{B} \mathbf{C} \] "
        r"\[ \dot{\mathbf{A}} = \dot{\mathbf{B}} \mathbf{C} + \dot{\mathbf{C}} \mathbf{B} \]",
        r"At the start, \[ \mathbf{r} = \mathbf{r}_0 \] Later \[ \dot{\mathbf{r}} = 0 \]",
        r"\[ \mathbf{r} = x \mathbf{i} + y \mathbf{j} \] "
        r"\[ \ddot{\mathbf{r}} = \dot x \mathbf{i} + \dot y \mathbf{j} \]",
        r"\[ \mathbf{v} = \frac{\mathbf{p}}{m} \] "
        r"\[ \dot{\mathbf{v}} = \frac{\dot{\mathbf{p}}}{m} - \frac{\dot m \mathbf{p}}{m} \]",
        r"\[ \mathbf{y} = f(\mathbf{x}) \mathbf{x} \] \[ \dot{\mathbf{y}} = f(\mathbf{x}) \dot{\mathbf{x}} \]",
        r"\[ E = \frac12 m v^2 \] \[ \frac{dE}{dt} = m v \frac{dv}{dt} + v^2 \frac{dm}{dt} \]",
        r"\[ y = a x \] \[ a = x \] \[ \frac{dy}{dt} = a \frac{dx}{dt} \]",
    ],
)
def test_what_is_not_the_derivative_of_vectors_does_not_follow(latex):
    assert last_verdict(latex) != "follows"


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\[ s = ||\mathbf{x}_{k|k}||^2 \] \[ s = \mathbf{x}_{k|k}^T \mathbf{x}_{k|k} \]", "follows"),
        (r"\[ s = \frac{||\mathbf{x}||^2}{n} + |b| \] \[ s = \mathbf{x}^T\mathbf{x} / n + |b| \]", "follows"),
        (r"\[ s = \big|\big|\mathbf{x}\big|\big|^2 \] \[ s = \mathbf{x}^T\mathbf{x} \]", "follows"),
        (r"\[ s = ||\mathbf{x}_{k|k}|| \] \[ s = \mathbf{x}_{k|k}^T \mathbf{x}_{k|k} \]", "independent"),
        (r"\[ s = ||\mathbf{x}_{k|k}||^2 \] \[ s = \mathbf{x}_{k}^T \mathbf{x}_{k} \]", "definition"),
        (
            r"\[ \mathbf{R}^{W+} = \mathbf{Q} \mathbf{R}^W \] \[ \mathbf{Q}^{-1} \mathbf{R}^{W+} = \mathbf{R}^W \]",
            "follows",
        ),
        (
            r"\[ \mathbf{R}^{W+} = \mathbf{Q} \mathbf{R}^W \] \[ \mathbf{Q} \mathbf{R}^{W+} = \mathbf{R}^W \]",
            "independent",
        ),
        (r"\[ z = x^{a+} + b \] \[ z = x^{a-} + b \]", "independent"),
        (r"\[ z = x^{a+} x \] \[ z = x^{a+1} \]", "definition"),
    ],
)
def test_bars_of_indices_are_none_of_norms_and_a_sign_behind_a_frame_is_part_of_its_name(latex, verdict):
    assert last_verdict(latex) == verdict
