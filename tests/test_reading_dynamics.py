r"""Texts of rigid-body dynamics as textbooks have them: what they derive follows, and not with a misprint.

The mark ``@`` stands before a bold letter, and ``|>`` before an equation that follows.
"""

import pytest
from textbooks import follow, plain, with_misprint

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")
NEWTON_EULER = r"""Consider a rigid body of constant mass $m$. Let $@v$ be the velocity of its center of
mass and $@F$ the total force. The linear momentum is \[ @p = m @v. \] Newton's law states that \[ \dot{@p}
= @F. \] Since the mass is constant, differentiating gives |>\[ m \dot{@v} = @F. \] The angular momentum
about the center of mass is \[ @H = @J @\omega, \] where $@J$ is the inertia matrix, which is constant in
the body frame. In the body frame Euler's law reads \[ \dot{@H} + @\omega \times @H = @M, \] where $@M$ is
the external torque. Since $@J$ is constant, we obtain |>\[ @J \dot{@\omega} + @\omega \times @J @\omega =
@M. \] Solving for the angular acceleration gives |>\[ \dot{@\omega} = @J^{-1} (@M - @\omega \times @J
@\omega). \] The rotational kinetic energy is \[ T = \frac{1}{2} @\omega^\top @J @\omega. \] As $@J$ is
symmetric, |>\[ \dot{T} = @\omega^\top @M. \]"""
STEINER = r"""Let $@d$ be the vector from the point $O$ to the center of mass. With the skew-symmetric
matrix $[@d]_\times$ of the cross product, the parallel axis theorem states that the inertia matrix about
$O$ is \[ @J_O = @J_C - m [@d]_\times [@d]_\times. \] Hence |>\[ @J_O = @J_C + m (@d^\top @d @I - @d
@d^\top) \] and |>\[ @J_O @d = @J_C @d. \]"""
SPATIAL = r"""Let ${}^A R_B$ be the rotation matrix of the frame $B$, and ${}^A o_B \in \mathbb{R}^3$
its origin. The pose is the homogeneous matrix \[ {}^A H_B = \begin{bmatrix} {}^A R_B & {}^A o_B \\ 0_{1
\times 3} & 1 \end{bmatrix}. \] Its inverse is |>\[ {}^A H_B^{-1} = \begin{bmatrix} {}^A R_B^\top & -{}^A
R_B^\top {}^A o_B \\ 0_{1 \times 3} & 1 \end{bmatrix}. \] Its time derivative is |>\[ {}^A \dot H_B =
\begin{bmatrix} {}^A \dot R_B & {}^A \dot o_B \\ 0_{1 \times 3} & 0 \end{bmatrix}. \] Multiplying from the
left by the inverse we obtain |>\[ {}^A H_B^{-1} {}^A \dot H_B = \begin{bmatrix} {}^A R_B^\top {}^A \dot R_B
& {}^A R_B^\top {}^A \dot o_B \\ 0_{1 \times 3} & 0 \end{bmatrix}. \] Multiplying from the right leads to
|>\[ {}^A \dot H_B {}^A H_B^{-1} = \begin{bmatrix} {}^A \dot R_B {}^A R_B^\top & {}^A \dot o_B - {}^A \dot
R_B {}^A R_B^\top {}^A o_B \\ 0_{1 \times 3} & 0 \end{bmatrix}. \]"""
TWIST = r"""Let $v, \omega \in \mathbb{R}^3$. The twist is \[ \xi = \begin{bmatrix} v \\ \omega
\end{bmatrix} \] and its hat is \[ \xi^\wedge = \begin{bmatrix} \omega^\wedge & v \\ 0_{1 \times 3} & 0
\end{bmatrix}. \] Let $R$ be a rotation matrix and $p \in \mathbb{R}^3$. Define \[ H = \begin{bmatrix} R & p
\\ 0_{1 \times 3} & 1 \end{bmatrix} \] and the adjoint matrix \[ X = \begin{bmatrix} R & p^\wedge R \\ 0_{3
\times 3} & R \end{bmatrix}. \] Its inverse is |>\[ X^{-1} = \begin{bmatrix} R^\top & -R^\top p^\wedge \\
0_{3 \times 3} & R^\top \end{bmatrix}. \] The rotation of the cross product is |>\[ R \omega^\wedge R^\top =
(R \omega)^\wedge. \] Hence |>\[ H \xi^\wedge H^{-1} = \begin{bmatrix} (R \omega)^\wedge & R v - (R
\omega)^\wedge p \\ 0_{1 \times 3} & 0 \end{bmatrix}. \]"""
TWO_BODY = r"""With the constant gravitational parameter $\mu$, the equation of motion of the relative
position $@r$ with the length $r = \|@r\|$ is \[ \ddot{@r} = -\frac{\mu}{r^3} @r. \] The specific angular
momentum is \[ @h = @r \times \dot{@r}. \] Taking the time derivative gives |>\[ \dot{@h} = @r \times
\ddot{@r} \] and with the equation of motion |>\[ \dot{@h} = @0. \] The specific energy is \[ E =
\frac{1}{2} \dot{@r} \cdot \dot{@r} - \frac{\mu}{r}. \] Its time derivative is |>\[ \dot{E} = \dot{@r} \cdot
\ddot{@r} + \frac{\mu}{r^2} \dot{r}. \] Since $r \dot{r} = @r \cdot \dot{@r}$, the energy is conserved: |>\[
\dot{E} = 0. \]"""
HILL = r"""In the rotating frame of the target with the constant rate $n$ the linearised equations
of motion are \[ \ddot{x} - 2 n \dot{y} - 3 n^2 x = 0 \] \[ \ddot{y} + 2 n \dot{x} = 0 \] \[ \ddot{z} + n^2
z = 0. \] From the second equation the quantity \[ C = \dot{y} + 2 n x \] is constant, since |>\[ \dot{C} =
0. \] Substituting it into the first equation yields |>\[ \ddot{x} + n^2 x = 2 n C. \] A test motion has the
path \[ w = A \cos n t + B \sin n t \] with constants $A$ and $B$. Its velocity is |>\[ \dot{w} = -A n \sin
n t + B n \cos n t. \]"""
ATTITUDE = r"""Let $@R$ be the rotation matrix from the body frame to the inertial frame and $@\omega$
the angular velocity in the body frame. The attitude kinematics are \[ \dot{@R} = @R [@\omega]_\times. \]
Let $@x$ be a point fixed in the body, so its inertial position is \[ @y = @R @x, \] where $@x$ is constant.
Differentiating, |>\[ \dot{@y} = @R (@\omega \times @x). \] In the inertial frame the angular velocity is \[
@w = @R @\omega. \] Then |>\[ \dot{@R} = [@w]_\times @R \] and |>\[ \dot{@w} = @R \dot{@\omega}. \]"""
EULER = r"""With roll $\phi$, pitch $\theta$ and yaw $\psi$ the body rates are \[ p = \dot\phi -
\dot\psi \sin\theta \] \[ q = \dot\theta \cos\phi + \dot\psi \cos\theta \sin\phi \] \[ r = -\dot\theta
\sin\phi + \dot\psi \cos\theta \cos\phi. \] Solving these equations for the rates of the angles gives |>\[
\dot\psi = \frac{q \sin\phi + r \cos\phi}{\cos\theta} \] |>\[ \dot\theta = q \cos\phi - r \sin\phi \] |>\[
\dot\phi = p + (q \sin\phi + r \cos\phi) \tan\theta. \]"""
TWO_LINKS = r"""Consider a planar arm with two links of the constant lengths $l_1$ and $l_2$, and point
masses $m_1$ and $m_2$ at their ends. The position of the second mass is \[ x_2 = l_1 \cos q_1 + l_2
\cos(q_1 + q_2) \] \[ y_2 = l_1 \sin q_1 + l_2 \sin(q_1 + q_2). \] Differentiating with respect to time
gives |>\[ \dot{x}_2 = -l_1 \dot{q}_1 \sin q_1 - l_2 (\dot{q}_1 + \dot{q}_2) \sin(q_1 + q_2) \] |>\[
\dot{y}_2 = l_1 \dot{q}_1 \cos q_1 + l_2 (\dot{q}_1 + \dot{q}_2) \cos(q_1 + q_2). \] Hence |>\[ \dot{x}_2^2
+ \dot{y}_2^2 = l_1^2 \dot{q}_1^2 + l_2^2 (\dot{q}_1 + \dot{q}_2)^2 + 2 l_1 l_2 \dot{q}_1 (\dot{q}_1 +
\dot{q}_2) \cos q_2. \] The Jacobian has the determinant \[ D = \frac{\partial x_2}{\partial q_1}
\frac{\partial y_2}{\partial q_2} - \frac{\partial x_2}{\partial q_2} \frac{\partial y_2}{\partial q_1}. \]
It is |>\[ D = l_1 l_2 \sin q_2. \]"""
LAGRANGE = r"""The Lagrangian of a manipulator is \[ L = \frac{1}{2} \dot{@q}^\top @M(@q) \dot{@q} -
V(@q). \] The generalized momentum is |>\[ \frac{\partial L}{\partial \dot{@q}} = @M(@q) \dot{@q}, \] since
$@M$ is symmetric. The equations of motion are \[ @M(@q) \ddot{@q} + @C(@q, \dot{@q}) \dot{@q} + @g(@q) =
@\tau. \] Solving for the joint accelerations gives |>\[ \ddot{@q} = @M(@q)^{-1} (@\tau - @C(@q, \dot{@q})
\dot{@q} - @g(@q)). \]"""
MIXING = r"""Each rotor has the thrust \[ f_i = k \Omega_i^2 \] and the drag torque \[ \tau_i = c
\Omega_i^2. \] With $\kappa = c/k$ it is |>\[ \tau_i = \kappa f_i. \] The total thrust and the torques are
\[ \begin{bmatrix} T \\ \tau_x \\ \tau_y \\ \tau_z \end{bmatrix} = \begin{bmatrix} 1 & 1 & 1 & 1 \\ 0 & l &
0 & -l \\ -l & 0 & l & 0 \\ \kappa & -\kappa & \kappa & -\kappa \end{bmatrix} \begin{bmatrix} f_1 \\ f_2 \\
f_3 \\ f_4 \end{bmatrix}. \] Solving for the thrusts gives |>\[ f_1 = \frac{T}{4} - \frac{\tau_y}{2 l} +
\frac{\tau_z}{4 \kappa} \] |>\[ f_2 = \frac{T}{4} + \frac{\tau_x}{2 l} - \frac{\tau_z}{4 \kappa}. \]"""
MOMENT = r"""The angular momentum about the fixed point $O$ is \[ @L = @r \times @p + @I @\Omega, \]
where $@r$ is the position of the center of mass. The moment of the forces about $O$ is \[ @M = @M_S + @r
\times @F. \] The momentum is $@p = m @v$, where $@v = \dot{@r}$ is the velocity and $m$ is constant. Then
the first term has the derivative |>\[ \frac{d}{dt}(@r \times @p) = @r \times \dot{@p}. \] Euler's laws
state that \[ \dot{@p} = @F \] and \[ \dot{@L} = @M. \] Let $@K = @I @\Omega$ be the spin. Then \[ \dot{@L}
= @r \times \dot{@p} + \dot{@K}. \] Hence |>\[ \dot{@K} = @M_S. \]"""
ROTATING = r"""Let $@R$ be the rotation matrix from the rotating frame to the inertial frame, with \[
\dot{@R} = @R [@\omega]_\times. \] A vector $@u$ in the rotating frame has the inertial coordinates \[ @y =
@R @u. \] Differentiating gives the rule |>\[ \dot{@y} = @R (\dot{@u} + @\omega \times @u). \]
Differentiating once more, we obtain |>\[ \ddot{@y} = @R (\ddot{@u} + 2 @\omega \times \dot{@u} +
\dot{@\omega} \times @u + @\omega \times (@\omega \times @u)). \] For vectors, Jacobi's identity reads |>\[
@a \times (@b \times @c) + @b \times (@c \times @a) + @c \times (@a \times @b) = @0. \]"""
TEXTS = {
    "newton_euler": NEWTON_EULER,
    "steiner": STEINER,
    "spatial": SPATIAL,
    "twist": TWIST,
    "two_body": TWO_BODY,
    "hill": HILL,
    "attitude": ATTITUDE,
    "euler": EULER,
    "two_links": TWO_LINKS,
    "lagrange": LAGRANGE,
    "mixing": MIXING,
    "moment": MOMENT,
    "rotating": ROTATING,
}
MISPRINTS = [
    ("newton_euler", r"m \dot{@v} = @F", r"m \dot{@v} = -@F"),
    ("newton_euler", r"= @J^{-1} (@M - @\omega \times", r"= @J^{-1} (@M + @\omega \times"),
    ("newton_euler", r"\dot{T} = @\omega^\top @M", r"\dot{T} = \frac{1}{2} @\omega^\top @M"),
    ("steiner", r"+ m (@d^\top @d @I - @d @d^\top)", r"+ m (@d^\top @d @I + @d @d^\top)"),
    ("spatial", r"-{}^A R_B^\top {}^A o_B", r"-{}^A R_B {}^A o_B"),
    ("spatial", r"{}^A \dot o_B - {}^A \dot R_B", r"{}^A \dot o_B + {}^A \dot R_B"),
    ("twist", r"-R^\top p^\wedge", r"R^\top p^\wedge"),
    ("twist", r"R v - (R \omega)^\wedge p", r"R v + (R \omega)^\wedge p"),
    ("twist", r"R \omega^\wedge R^\top = ", r"R \omega^\wedge R = "),
    ("two_body", r"\dot{@h} = @r \times \ddot{@r}", r"\dot{@h} = \dot{@r} \times \ddot{@r}"),
    ("two_body", r"+ \frac{\mu}{r^2} \dot{r}", r"+ \frac{\mu}{r} \dot{r}"),
    ("hill", r"\ddot{x} + n^2 x = 2 n C", r"\ddot{x} - n^2 x = 2 n C"),
    ("hill", r"\dot{w} = -A n", r"\dot{w} = A n"),
    ("attitude", r"\dot{@R} = [@w]_\times @R \]", r"\dot{@R} = @R [@w]_\times \]"),
    ("attitude", r"@R (@\omega \times @x)", r"@R (@x \times @\omega)"),
    ("euler", r"\dot\theta = q \cos\phi - r \sin\phi", r"\dot\theta = q \cos\phi + r \sin\phi"),
    ("two_links", r"+ 2 l_1 l_2 \dot{q}_1", r"+ l_1 l_2 \dot{q}_1"),
    ("two_links", r"D = l_1 l_2 \sin q_2", r"D = l_1 l_2 \cos q_2"),
    ("lagrange", r"= @M(@q) \dot{@q}, \]", r"= 2 @M(@q) \dot{@q}, \]"),
    ("mixing", r"f_1 = \frac{T}{4} - \frac{\tau_y}{2 l}", r"f_1 = \frac{T}{4} + \frac{\tau_y}{2 l}"),
    ("moment", r"= @r \times \dot{@p}. \] Euler", r"= \dot{@r} \times \dot{@p}. \] Euler"),
    ("moment", r"\dot{@K} = @M_S", r"\dot{@K} = -@M_S"),
    ("rotating", r"2 @\omega \times \dot{@u}", r"@\omega \times \dot{@u}"),
    ("rotating", r"+ @c \times (@a \times @b)", r"+ @c \times (@b \times @a)"),
]


def verdicts(text: str) -> list[str]:
    return [each.verdict for each in read_document(document_of(plain(text)))]


@pytest.mark.parametrize("name", TEXTS)
def test_what_a_textbook_derives_follows(name):
    found = verdicts(TEXTS[name])
    assert [each == "follows" for each in found] == follow(TEXTS[name]), found
    assert "contradicts" not in found


@pytest.mark.parametrize(("name", "printed", "wrong"), MISPRINTS)
def test_no_misprint_of_a_textbook_follows(name, printed, wrong):
    text, place = with_misprint(TEXTS[name], printed, wrong)
    assert verdicts(text)[place] != "follows"


@pytest.mark.parametrize(
    "text",
    [
        r"\[ @p = m @v \] Newton's law is \[ \dot{@p} = @F. \] Hence \[ m \dot{@v} = @F. \]",
        r"The mass $m$ is constant. \[ @p = m @v \] The law is \[ \dot{@p} = @F. \] Hence \[ m @v = @F. \]",
        r"A constant wind drives $k$. \[ p = k v \] Then \[ \frac{d}{dt} p = k \dot{v}. \]",
        r"\[ \frac{d}{dt} (k v) = k \dot{v} \]",
        r"\[ \frac{d}{dt} (@a \times @b) = \dot{@a} \times @b + \dot{@b} \times @a \]",
        r"\[ \frac{d}{dt} (@A @b) = @A \dot{@b} + @b \dot{@A} \]",
        r"The matrix $@M(@q_0)$ is symmetric. \[ @p = @M(@q) @v \] Hence \[ @p^\top = @v^\top @M(@q). \]",
        r"The matrix $@M(@q)$ is not symmetric. \[ @p = @M(@q) @v \] Hence \[ @p^\top = @v^\top @M(@q). \]",
        r"Let $@R(@q)$ be a rotation matrix. \[ @y = @R(@q) @x \] Hence \[ @x = @R(@q) @y. \]",
        r"Let $@I$ be the inertia matrix. \[ @H = @I \cdot @w \] Hence \[ @w \times @H = -@I \cdot @w \times @w. \] "
        r"Hence \[ @u \times @H = @u \times @w \cdot @I. \]",
        r"\[ \mathrm{v} = \begin{bmatrix} v \\ w \end{bmatrix}, \quad v = a b. \] Hence \[ \mathrm{v} = a b. \]",
        r"\[ \begin{bmatrix} v \\ w \end{bmatrix}^\wedge := \begin{bmatrix} w^\wedge & v \\ 0 & 0 \end{bmatrix} \] "
        r"Hence \[ \begin{bmatrix} @a \\ @b \end{bmatrix}^\wedge \begin{bmatrix} @x \\ 1 \end{bmatrix} = "
        r"\begin{bmatrix} @a^\wedge @x + @b \\ 0 \end{bmatrix}. \]",
        r"\[ \dot{R} := \frac{d}{dt} R \] \[ R = A B \] Hence \[ \dot{R} = \dot{A} \dot{B}. \]",
        r"\[ M = \begin{bmatrix} @A & @B \\ 0 & @D \end{bmatrix} \] Hence "
        r"\[ M^{-1} = \begin{bmatrix} @A^{-1} & -@A^{-1} @D^{-1} @B \\ 0 & @D^{-1} \end{bmatrix}. \]",
    ],
)
def test_what_is_not_so_does_not_follow(text):
    assert verdicts(text)[-1] not in ("follows", "contradicts")


@pytest.mark.parametrize(
    "text",
    [
        r"With constant $m$ \[ @p = m @v. \] Newton's law is \[ \dot{@p} = @F. \] Hence \[ m \dot{@v} = @F. \]",
        r"With the constant angular rate $n$ \[ \ddot{y} + 2 n \dot{x} = 0. \] Let \[ C = \dot{y} + 2 n x. \] "
        r"Then \[ \dot{C} = 0. \]",
        r"For the constant link lengths $a$ and $b$ \[ x = a \cos p + b \cos q. \] "
        r"Then \[ \dot{x} = -a \dot{p} \sin p - b \dot{q} \sin q. \]",
        r"\[ @v = \dot{@r}, \quad @p = m @v. \] Then \[ \frac{d}{dt} (@r \times @p) = @r \times \dot{@p}. \]",
        r"The mass matrix $@M(@q)$ is symmetric. \[ @p = @M(@q) @v \] Hence \[ @p^\top = @v^\top @M(@q). \]",
        r"Let $@R(\theta)$ be a rotation matrix. \[ @y = @R(\theta) @x \] Hence \[ @x = @R(\theta)^\top @y. \]",
        r"Let $@I$ be the inertia matrix. \[ @H = @I \cdot @w \] Hence \[ @w \times @H = @w \times @I \cdot @w. \]",
        r"\[ \begin{bmatrix} v \\ w \end{bmatrix}^\wedge := \begin{bmatrix} w^\wedge & v \\ 0 & 0 \end{bmatrix} \] "
        r"Hence \[ \begin{bmatrix} @a \\ @b \end{bmatrix}^\wedge \begin{bmatrix} @x \\ 1 \end{bmatrix} = "
        r"\begin{bmatrix} @b^\wedge @x + @a \\ 0 \end{bmatrix}. \]",
        r"\[ M = \begin{bmatrix} @A & @B \\ 0 & @D \end{bmatrix} \] Hence "
        r"\[ M^{-1} = \begin{bmatrix} @A^{-1} & -@A^{-1} @B @D^{-1} \\ 0 & @D^{-1} \end{bmatrix}. \]",
        r"\[ \dot{@R} := \frac{d}{dt} @R \] \[ @R = @A @B \] Hence \[ \dot{@R} = \dot{@A} @B + @A \dot{@B}. \]",
    ],
)
def test_what_is_so_follows(text):
    assert verdicts(text)[-1] == "follows"


def test_upright_letters_are_others_than_slanted_ones():
    *_, last = read_document(document_of(r"\[ v = a \] \[ {}^B {\rm v} = b + v \] \[ {\rm v} = c \]"))
    assert last.verdict == "definition"
