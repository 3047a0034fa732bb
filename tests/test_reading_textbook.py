r"""How textbooks on estimation, cameras and motion say things: in a clause, by an accent, by a usual letter."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

WIDTH = r"The width is \[ x = a b. \] "
HAT = (
    r"Let $w \in \mathbb{R}^3$, $a \in \mathbb{R}^3$ and $b \in \mathbb{R}^3$ be vectors. The hat operator is "
    r"\[ \hat w = \begin{bmatrix} 0 & -w_3 & w_2 \\ w_3 & 0 & -w_1 \\ -w_2 & w_1 & 0 \end{bmatrix}. \] "
)
TURNS = (
    r"Let $R$ be a rotation matrix with $\dot R = R [w]_\times$, where $w$ is the angular velocity. "
    r"The position is \[ u = R r. \] Differentiating, we get "
)
FILTER = (
    r"The covariance is \[ S = H P H^T + Q. \] The gain is \[ K = P H^T S^{-1}. \] The updated covariance is "
    r"\[ M = (I - K H) P (I - K H)^T + K Q K^T. \] "
)
MOVED = r"Let $z$ be a random vector with mean $m = E[z]$. The covariance is \[ C = E[(z - m) (z - m)^T]. \] "
SCENE = r"The points are related by the rigid motion \[ y = R x + t. \] "


def last(latex):
    return read_document(document_of(latex), seconds=5)[-1]


@pytest.mark.parametrize(
    "latex",
    [
        # A quantity with its formula is the subject of the sentence, or stands in a clause.
        WIDTH + r"The area $h = x c$ evaluates to \[ h = a b c. \]",
        WIDTH + r"The angular momentum is $h = x c$, that is, \[ h = a b c. \]",
        WIDTH + r"The rotated vector $h = x c$ has the components \[ h = a b c. \]",
        WIDTH + r"With the inertial acceleration $g = x c$ this becomes \[ h g = a b c h. \]",
        WIDTH + r"With the depths $u$ and $v$ we have $x = r u$ and $b = r v$, hence \[ u = a v. \]",
        r"The force is \[ f = m g + n. \] In the absence of a load ($n = 0$) it is \[ f = m g. \]",
        # It is solved for a value of a function.
        r"The image is \[ x = f \tan u. \] Then \[ \tan u = \frac xf. \]",
        r"Let \[ x = a (\cos E - e). \] The distance is \[ r = a (1 - e \cos E). \] Comparing with $x = r \cos u$ and "
        r"$y = r \sin u$, the anomaly satisfies \[ \cos u = \frac{\cos E - e}{1 - e \cos E}. \]",
        r"The weight is \[ w = \frac{a}{a + b}. \] The mean is \[ x = (1 - w) z + w u. \] It is also "
        r"\[ x = z + K (u - z), \qquad K = \frac{a}{a + b}. \]",
        r"The length is \[ r = u + v = a b. \] With $u = r c$ we get \[ u = a b c. \]",
        # An accent of which a printed matrix says that it is a cross product.
        HAT + r"We have \[ \hat a \hat b = b a^T - (a^T b) I. \]",
        HAT + r"We have \[ \hat a \hat b - \hat b \hat a = \widehat{a \times b}. \]",
        HAT + r"If $R \in SO(3)$ is a rotation matrix, then \[ R \hat w R^T = \widehat{R w}. \]",
        r"With depths $p$ and $q$, and vectors $x$ and $y$, \[ p y = q R x + t. \] Hence "
        r"\[ p [t]_\times y = q [t]_\times R x. \]",
        r"The matrix is \[ F = K_2^{-\top} E K_1^{-1}. \] Hence \[ K_2^\top F K_1 = E. \]",
        # Thin letters beside a cross.
        TURNS + r"\[ \dot u = R (\dot r + w \times r). \]",
        TURNS + r"\[ \dot u = R (\dot r + w \times r). \] Differentiating again, we get "
        r"\[ \ddot u = R (\ddot r + 2 w \times \dot r + \dot w \times r + w \times (w \times r)). \]",
        # What is usual.
        FILTER + r"For the optimal gain this simplifies to \[ M = (I - K H) P. \]",
        r"The filter has the vectors \begin{align} y_k &= z_k - H x_k^-, \\ s_k &= c y_k. \end{align} Hence "
        r"\[ s_k = c z_k - c H x_k^-. \]",
        SCENE + r"The essential matrix is \[ E = [t]_\times R. \] It satisfies \[ E E^T = [t]_\times [t]_\times^T. \]",
        # What is zero, and what is minimized.
        r"The sum is \[ S = \sum_{i=1}^n (x_i - m)^2. \] Its derivative is "
        r"\[ \frac{\partial S}{\partial m} = -2 \sum_{i=1}^n (x_i - m), \] which vanishes for "
        r"\[ \hat m = \frac1n \sum_{i=1}^n x_i. \]",
        r"We look for the vector $x$ that minimizes \[ J(x) = \|A x - b\|^2. \] It is "
        r"\[ J(x) = x^T A^T A x - 2 x^T A^T b + b^T b. \]",
        r"We minimize \[ J(x) = \|A x - b\|^2. \] The gradient is \[ \nabla J(x) = 2 A^T (A x - b), \] the Hessian is "
        r"\[ \nabla^2 J(x) = 2 A^T A. \] Setting the gradient to zero gives \[ A^T A \hat x = A^T b. \]",
    ],
)
def test_what_textbooks_say_in_passing_serves(latex):
    assert last(latex).verdict == "follows"


@pytest.mark.parametrize(
    ("latex", "supposed"),
    [
        (MOVED + r"With $y = A z$ and mean $n = A m$ we have \[ E[(y - n) (y - n)^T] = A C A^T. \]", "A is not random"),
        (FILTER + r"Hence \[ M = P - K S K^T. \]", "P is symmetric"),
        (SCENE + r"The inverse motion is \[ x = R^T (y - t). \]", "R is a rotation"),
    ],
)
def test_what_a_letter_is_usually_becomes_a_hypothesis(latex, supposed):
    found = last(latex)
    assert found.verdict == "follows"
    assert supposed in found.links[-1].hypotheses


@pytest.mark.parametrize(
    "latex",
    [
        WIDTH + r"The first lens has the width $h = x c$, and the other lens \[ h = a b c. \]",
        WIDTH + r"The area $h = x c$ of the old lens was wrong, and the area is \[ h = a b c. \]",
        WIDTH + r"The area $h = x c$ is never reached, and it is \[ h = a b c. \]",
        WIDTH + r"A lens is good with the width $h = x c$, and a mirror has \[ h = a b c. \]",
        WIDTH + r"Unlike the area $x = a c$, \[ b = c. \]",
        WIDTH + r"Besides the plane ($b = 1$), we have \[ x = a. \]",
        WIDTH + r"In the plane ($b = 1$) it is trivial, but at the top \[ x = a. \]",
        WIDTH + r"For a ring ($b = 1$) it is known, whereas for a disc we have \[ x = a. \]",
        WIDTH + r"Comparing with $x = 2 a$ for the other lens, we see that \[ b = 2. \]",
        r"The law is \[ c \sin u = d, \quad c = 0. \] Hence \[ \sin u = \frac dc. \]",
        r"The estimate is \[ \hat x = a + b. \] " + HAT + r"We have \[ \hat x y = - \hat y x. \]",
        r"Let $a$ and $b$ be vectors, and \[ c = a \times b. \] Hence \[ c = b \times a. \]",
        r"The angular velocity is $w$. The area is \[ A = l \times h. \] Hence \[ l \times h + h \times l = 0. \]",
        # Another R, another P, and what words say of them.
        r"The noise has the covariance $R$. The gain is \[ K = P R^{-1}. \] Hence \[ K = P R^T. \]",
        r"The cross covariance is \[ D = P_{xy} B. \] Hence \[ D = P_{xy}^T B. \]",
        r"The product is \[ D = P B. \] Hence \[ D = P^T B. \]",
        r"The matrix is \[ E = R A. \] Hence \[ R^T E = A. \]",
        r"The error has a covariance. The chain has the transition matrix $P$. \[ D = P B. \] Hence \[ D = P^T B. \]",
        r"The covariance has a QR decomposition \[ C = Q R. \] Hence \[ C = Q^T R. \]",
        MOVED + r"With a random matrix $A$ and $y = A z$, $n = A m$ we have \[ E[(y - n) (y - n)^T] = A C A^T. \]",
        r"The sum is \[ S = \sum_{i=1}^n (x_i - m)^2. \] Its derivative is "
        r"\[ \frac{\partial S}{\partial m} = -2 \sum_{i=1}^n (x_i - m), \] which never vanishes for "
        r"\[ \hat m = \frac1n \sum_{i=1}^n x_i. \]",
        r"We look for the angle at which \[ f(x) = a b. \] We have \[ f(x) c = a b c. \]",
    ],
)
def test_what_is_said_of_another_case_or_letter_serves_nothing(latex):
    assert last(latex).verdict != "follows"
