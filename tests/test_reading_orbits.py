r"""Texts on orbits, attitudes and motions as specifications have them: what they derive follows, and no misprint does.

The mark ``@`` stands before a bold letter, and ``|>`` before an equation that follows.
"""

import pytest
from textbooks import follow, plain, with_misprint

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")
EQUINOCTIAL = r"""The elements are defined as \[ p = a (1 - e^2) \] \[ f = e \cos(\omega + \Omega) \] \[ g = e
\sin(\omega + \Omega) \] \[ h = \tan(i/2) \cos\Omega \] \[ k = \tan(i/2) \sin\Omega \] \[ w = 1 + f \cos L + g
\sin L. \] The classical elements are |>\[ e = \sqrt{f^2 + g^2} \] |>\[ a = \frac{p}{1 - f^2 - g^2} \] |>\[ i = 2
\arctan\sqrt{h^2 + k^2} \] |>\[ \Omega = \operatorname{atan2}(k, h) \] |>\[ \omega + \Omega =
\operatorname{atan2}(g, f). \] The partial derivative is |>\[ \frac{\partial w}{\partial L} = g \cos L - f \sin L.
\]"""
GRAVITY = r"""The acceleration by a point mass is \[ @a = -\frac{\mu}{r^3} @r \] with $r = \|@r\|$. Its gradient
is |>\[ \frac{\partial @a}{\partial @r} = -\frac{\mu}{r^3} @I + \frac{3\mu}{r^5} @r @r^T. \]"""
RATES = r"""The state is \[ r = \frac{p}{w} \] \[ x = r \cos\delta \] \[ y = r \sin\delta. \] Then |>\[ \dot x = \dot
r \cos\delta - r \dot\delta \sin\delta \] |>\[ \dot y = \dot r \sin\delta + r \dot\delta \cos\delta \] |>\[ x \dot y
- y \dot x = r^2 \dot\delta \] |>\[ \dot r = \frac{x \dot x + y \dot y}{r}. \]"""
VELOCITY_FRAME = r"""Let \[ v = \|@v\|. \] The axis is \[ @u = \frac{@v}{v}. \] Its derivative is |>\[ \dot{@u} =
\frac{@a}{v} - \frac{@v}{v^3} (@v \cdot @a) \] where $@a = \dot{@v}$ is the acceleration."""
QUATERNION = r"""The quaternion is $@q = (q_1, q_2, q_3, q_4)^T$ with $q_1^2 + q_2^2 + q_3^2 + q_4^2 = 1$. The matrix
is \[ @R = \begin{bmatrix} q_1^2 - q_2^2 - q_3^2 + q_4^2 & 2(q_1 q_2 + q_3 q_4) & 2(q_1 q_3 - q_2 q_4) \\ 2 (q_1 q_2 -
q_3 q_4) & -q_1^2 + q_2^2 - q_3^2 + q_4^2 & 2 (q_2 q_3 + q_1 q_4) \\ 2 (q_1 q_3 + q_2 q_4) & 2 (q_2 q_3 - q_1 q_4) &
-q_1^2 - q_2^2 + q_3^2 + q_4^2 \end{bmatrix}. \] Its trace is |>\[ \operatorname{tr}(@R) = 4 q_4^2 - 1 \] Hence
|>\[ q_4 = \frac{1}{2}\sqrt{1 + \operatorname{tr}(@R)} \] |>\[ q_1 = \frac{R_{23} - R_{32}}{4 q_4}. \]"""
RODRIGUES = r"""Let $@w$ be a unit vector. \[ [@w]_\times = \begin{bmatrix} 0 & -w_3 & w_2 \\ w_3 & 0 & -w_1 \\ -w_2 &
w_1 & 0 \end{bmatrix} \] The rotation matrix is \[ @R = @I + [@w]_\times \sin\theta + [@w]_\times^2 (1 - \cos\theta) =
\begin{bmatrix} \cos\theta + w_1^2 (1 - \cos\theta) & -w_3 \sin\theta + w_1 w_2 (1 - \cos\theta) & w_2 \sin\theta + w_1
w_3 (1 - \cos\theta) \\ w_3 \sin\theta + w_1 w_2 (1 - \cos\theta) & \cos\theta + w_2^2 (1 - \cos\theta) & -w_1
\sin\theta + w_2 w_3 (1 - \cos\theta) \\ -w_2 \sin\theta + w_1 w_3 (1 - \cos\theta) & w_1 \sin\theta + w_2 w_3 (1 -
\cos\theta) & \cos\theta + w_3^2 (1 - \cos\theta) \end{bmatrix}. \] The angle is found from the trace: |>\[ \theta =
\arccos\left(\frac{\operatorname{tr}(@R) - 1}{2}\right) \] and the axis is |>\[ @w = \frac{1}{2\sin\theta}
\begin{bmatrix} r_{32} - r_{23} \\ r_{13} - r_{31} \\ r_{21} - r_{12} \end{bmatrix}. \]"""
GROUP = r"""The rotation satisfies $@R(t) @R(t)^T = @I$. Differentiating with respect to time gives |>\[ \dot{@R}(t)
@R(t)^T + @R(t) \dot{@R}(t)^T = 0. \] Let $@n$ be a unit vector. Then |>\[ \sum_{k=0}^\infty \frac{1}{k!} (\theta
@n^\wedge)^k = \cos\theta @I + (1 - \cos\theta) @n @n^T + \sin\theta @n^\wedge. \]"""
TRAJECTORY = r"""The polynomial is \[ s(u) = 6 u^5 - 15 u^4 + 10 u^3. \] Its derivatives are |>\[ \dot s(u) = 30 u^4
- 60 u^3 + 30 u^2 \] |>\[ \ddot s(u) = 120 u^3 - 180 u^2 + 60 u. \]"""
TEXTS = {
    "equinoctial": EQUINOCTIAL,
    "gravity": GRAVITY,
    "rates": RATES,
    "velocity frame": VELOCITY_FRAME,
    "quaternion": QUATERNION,
    "rodrigues": RODRIGUES,
    "group": GROUP,
    "trajectory": TRAJECTORY,
}
MISPRINTS = [
    ("equinoctial", r"e = \sqrt{f^2 + g^2}", r"e = \sqrt{f^2 - g^2}"),
    ("equinoctial", r"\operatorname{atan2}(k, h)", r"\operatorname{atan2}(h, k)"),
    ("equinoctial", r"i = 2 \arctan\sqrt", r"i = \arctan\sqrt"),
    ("equinoctial", r"= g \cos L - f \sin L", r"= g \cos L + f \sin L"),
    ("gravity", r"\frac{3\mu}{r^5}", r"\frac{3\mu}{r^3}"),
    ("gravity", r"= -\frac{\mu}{r^3} @I", r"= \frac{\mu}{r^3} @I"),
    ("rates", r"- r \dot\delta \sin\delta", r"+ r \dot\delta \sin\delta"),
    ("rates", r"= \frac{x \dot x + y \dot y}{r}", r"= \frac{x \dot x + y \dot y}{r^2}"),
    ("velocity frame", r"\frac{@v}{v^3}", r"\frac{@v}{v^2}"),
    ("quaternion", r"= 4 q_4^2 - 1", r"= 4 q_4^2 + 1"),
    ("quaternion", r"\frac{1}{2}\sqrt{1 + ", r"\frac{1}{2}\sqrt{1 - "),
    ("quaternion", r"R_{23} - R_{32}", r"R_{32} - R_{23}"),
    ("rodrigues", r"(@R) - 1}{2}", r"(@R) + 1}{2}"),
    ("rodrigues", r"r_{32} - r_{23}", r"r_{23} - r_{32}"),
    ("group", r"+ @R(t) \dot{@R}(t)^T = 0", r"- @R(t) \dot{@R}(t)^T = 0"),
    ("group", r"(1 - \cos\theta) @n @n^T", r"(1 + \cos\theta) @n @n^T"),
    ("trajectory", r"+ 30 u^2", r"+ 30 u"),
]


def readings(text):
    return read_document(document_of(plain(text)))


@pytest.mark.parametrize("name", TEXTS)
def test_what_a_specification_derives_follows(name):
    found = [each.verdict for each in readings(TEXTS[name])]
    assert [each == "follows" for each in found] == follow(TEXTS[name]), found


@pytest.mark.parametrize(("name", "printed", "wrong"), MISPRINTS)
def test_no_misprint_of_a_specification_follows(name, printed, wrong):
    text, place = with_misprint(TEXTS[name], printed, wrong)
    assert readings(text)[place].verdict != "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ x = -2. \] Hence \[ x = \sqrt{4}. \]",
        r"\[ x = -a^2 - 1. \] Hence \[ x = \sqrt{(a^2 + 1)^2}. \]",
        r"\[ a = -1. \] Hence \[ a = \arccos(\cos 1). \]",
        r"\[ x^2 = b. \] The negative root is \[ x = \sqrt{b}. \]",
        r"\[ s(u) = u^2. \] The rates are $\dot u = c$ and \[ \dot s(u) = 2 u. \]",
        r"\[ g(x) = x^3. \] Then \[ g^{-1}(x) = 1/x^3. \]",
        r"\[ p = r T, \quad T = a + b h, \quad r = c T. \] Hence \[ \frac{\partial p}{\partial T} = 2 c T. \]",
        r"As the drop grows, \[ p = m v. \] Differentiating gives \[ \dot p = m \dot v. \]",
        r"The distances are $r_{12} = r_{21} = d$. \[ R = \begin{pmatrix} 1 & a \\ b & 1 \end{pmatrix} \] "
        r"\[ r_{12} = a \]",
        r"\[ R = \begin{pmatrix} 1 & a \\ b & 1 \end{pmatrix} \] If it is small, \[ R = \begin{pmatrix} 1 & c \\ d & 1 "
        r"\end{pmatrix}. \] Hence \[ R_{12} = c \]",
        r"The angle lies in $\pi/2 < a < 3\pi/2$. \[ x = r \cos a \] \[ y = r \sin a \] Hence "
        r"\[ a = \arctan\frac{y}{x}. \]",
        r"Let $v$ be negative. \[ v^2 = 2 g h \] Hence \[ v = \sqrt{2 g h}. \]",
        r"Let $v < 0$. \[ v^2 = 2 g h \] Hence \[ v = \sqrt{2 g h}. \]",
        r"Consider a vector $(a, b)$, for instance with $a^2 + b^2 = 1$. \[ (a + b)^2 = 1 + 2 a b \]",
    ],
)
def test_what_only_looks_so_does_not_follow(latex):
    assert readings(latex)[-1].verdict != "follows"


def test_an_angle_in_a_narrower_range_follows():
    latex = (
        r"The angle lies in $0 < a < \pi/2$. \[ x = r \cos a \] \[ y = r \sin a \] Hence \[ a = \arctan\frac{y}{x}. \]"
    )
    assert readings(latex)[-1].verdict == "follows"


def test_hypotheses_say_where_an_angle_and_a_root_lie():
    angle, root = (
        readings(r"\[ x = r \cos a \] \[ y = r \sin a \] Hence " + last)[-1].links[0].hypotheses
        for last in (r"\[ a = \operatorname{atan2}(y, x) \]", r"\[ r = \sqrt{x^2 + y^2} \]")
    )
    assert angle[:2] == ("-pi < a <= pi", "y*sin(a) + x*cos(a) > 0")
    assert root[0] == "r >= 0"


def test_entries_rest_on_the_printed_matrix_and_on_how_they_are_called():
    matrix = r"\[ R = \begin{pmatrix} \cos a & -\sin a \\ \sin a & \cos a \end{pmatrix} \]"
    for entries, name in ((r"r_{11}^2 + r_{12}^2", "r"), (r"R_{00}^2 + R_{01}^2", "R")):
        *_, last = readings(matrix + rf"Hence \[ {entries} = 1. \]")
        assert last.links[0].rests_on == (f"line 1, with {name}_ij as the entry of R in row i and column j",)


def test_what_is_differentiated_is_said_to_hold_always():
    *_, last = readings(r"The point moves on \[ x^2 + y^2 = c. \] Differentiating gives \[ x \dot x + y \dot y = 0. \]")
    assert last.links[0].hypotheses[0] == "line 1 holds for every t"
    assert last.links[0].rests_on == ("the derivative of line 1, where c does not change",)


def test_a_model_in_a_new_section_is_given_anew():
    section = r"\section{Model} The inverse is \[ \pi^{-1}(\mathbf u) = \begin{pmatrix} m_x \\ m_y \end{pmatrix} \] "
    latex = r"Let $\pi(\mathbf x) = \mathbf x$. " + section + r"\[ m_x = u + a \] \[ m_y = v + b \]" + section
    assert {each.verdict for each in readings(latex + r"\[ m_x = (u + c)^3 / d \] \[ m_y = \ln v \]")} == {"definition"}


def test_an_eccentricity_is_not_the_number_of_euler():
    *_, last = readings(
        r"\[ e^2 = 1 - b^2/a^2 \] \[ N = a/\sqrt{1 - e^2 u} \] \[ w = e^{y/R} \] Hence \[ N^2 (1 - e^2 u) = a^2. \]"
    )
    assert last.verdict == "follows"
    assert not any("exp" in each for each in last.links[0].hypotheses)


def test_waves_of_many_numbers_are_compared_in_seconds():
    latex = (
        r"\[ q = \ln\tan\left(\frac{\pi}{4} + \frac{\varphi}{2}\right) \] \[ x = R \lambda \] \[ y = R q \] With $k = "
        r"\frac{2}{1 + \cos c}$ we have \[ x = R k \sin c \cos\theta \] \[ \rho = \sqrt{x^2 + y^2} = 2 "
        r"R \tan\frac{c}{2}. \]"
    )
    assert readings(latex)[-1].links[-1].verdict == "independent"
