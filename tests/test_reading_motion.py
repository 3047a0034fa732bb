r"""Derivatives of motions: dots of functions of time, the equations of Lagrange, and derivatives by two letters."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

SWING = r"The position is \[ x(t) = A \cos(\omega t). \] Hence "
PLAIN = r"The position is \[ x = A \cos(\omega t). \] Hence "
LAGRANGE = (
    r"The mass $m$ is constant. With \[ T = \frac12 m \dot x^2 \] and \[ V = \frac12 k x^2, \] "
    r"the Lagrangian is \[ L = T - V. \] "
    r"We have \[ \frac{\partial L}{\partial \dot x} = m \dot x. \] Hence "
)
POLAR = (
    r"With constant $m$ the Lagrangian is \[ L = \frac12 m (\dot r^2 + r^2 \dot\phi^2) - V. \] We have "
    r"\[ \frac{\partial L}{\partial \dot\phi} = m r^2 \dot\phi. \] Hence "
)
TURN = (
    r"The rotation is \[ R(\theta) = \begin{bmatrix} \cos\theta & -\sin\theta \\ \sin\theta & \cos\theta "
    r"\end{bmatrix}. \] Hence "
)
FIELD = r"We have \[ u(x, y) = x^2 y + y^3. \] Hence "
VARIANCE = (
    r"With the covariance matrix $\mathbf{S}$ we have \[ L(\mathbf{u}, \lambda) = \mathbf{u}^T \mathbf{S} \mathbf{u} + "
    r"\lambda (1 - \mathbf{u}^T \mathbf{u}). \] Hence "
)
BY_VECTOR = r"\frac{d L(\mathbf{u}, \lambda)}{d \mathbf{u}}"


def last(latex):
    return read_document(document_of(latex))[-1]


@pytest.mark.parametrize(
    ("above", "claim"),
    [
        (SWING, r"\dot x(t) = -A \omega \sin(\omega t)"),
        (TURN, r"R^T \dot R = \begin{bmatrix} 0 & -\dot\theta \\ \dot\theta & 0 \end{bmatrix}"),
        (SWING, r"\dot x = -A \omega \sin(\omega t)"),
        (SWING, r"\ddot x(t) = -\omega^2 x(t)"),
        (PLAIN, r"\dot x = -A \omega \sin(\omega t)"),
        (r"We have \[ f(x) = x^3 - 2 x. \] Hence ", r"f' = 3 x^2 - 2"),
        (LAGRANGE, r"\frac{\partial L}{\partial x} = -k x"),
        (LAGRANGE, r"\frac{d}{dt} \frac{\partial L}{\partial \dot x} = m \ddot x"),
        (
            LAGRANGE + r"\[ \frac{\partial L}{\partial x} = -k x. \] So ",
            r"\frac{d}{dt} (\frac{\partial L}{\partial \dot x}) - \frac{\partial L}{\partial x} = m \ddot x + k x",
        ),
        (POLAR, r"\frac{d}{dt} \frac{\partial L}{\partial \dot\phi} = m r^2 \ddot\phi + 2 m r \dot r \dot\phi"),
        (r"The mass $m$ is constant. The momentum is \[ p = m v. \] Hence ", r"\frac{d}{dt} p = m \dot v"),
        (FIELD, r"\frac{\partial^2 u}{\partial x \partial y} = 2 x"),
        (VARIANCE, rf"{BY_VECTOR} = 2 \mathbf{{S}} \mathbf{{u}} - 2 \lambda \mathbf{{u}}"),
    ],
)
def test_what_is_true_of_a_motion_follows(above, claim):
    assert last(rf"{above} \[ {claim}. \]").verdict == "follows"


@pytest.mark.parametrize(
    ("above", "claim"),
    [
        (TURN, r"R^T \dot R = \begin{bmatrix} 0 & \dot\theta \\ -\dot\theta & 0 \end{bmatrix}"),
        (SWING, r"\dot x(t) = A \omega \sin(\omega t)"),
        (SWING, r"\ddot x(t) = \omega^2 x(t)"),
        (SWING.replace("A", "A(t)"), r"\dot x(t) = -A(t) \omega \sin(\omega t)"),
        (r"We have \[ x(t) = A t^2 \] and \[ A = c t. \] Hence ", r"\dot x(t) = 2 A t"),
        (LAGRANGE, r"\frac{\partial L}{\partial x} = m \ddot x"),
        (LAGRANGE, r"\frac{dL}{dx} = -k x"),
        (r"The velocity is \[ \dot x = c x. \] " + LAGRANGE, r"\frac{\partial L}{\partial x} = -k x"),
        (LAGRANGE, r"\frac{d}{dt} \frac{\partial L}{\partial \dot x} = m \dot x"),
        (POLAR, r"\frac{d}{dt} \frac{\partial L}{\partial \dot\phi} = m r^2 \ddot\phi"),
        (r"The momentum is \[ p = m v. \] Hence ", r"\frac{d}{dt} p = m \dot v"),
        (
            r"The mass $m$ is constant. The momentum is \[ p = m v, \] where the tank leaks. Hence ",
            r"\frac{d}{dt} p = m \dot v",
        ),
        (r"The volume is \[ V = w h t, \] where $t$ is the thickness. Hence ", r"\dot V = \dot w h t + w h"),
        (FIELD, r"\frac{\partial^2 u}{\partial x \partial y} = 2 y"),
        (
            VARIANCE.replace("covariance", "cross covariance"),
            rf"{BY_VECTOR} = 2 \mathbf{{S}} \mathbf{{u}} - 2 \lambda \mathbf{{u}}",
        ),
        (
            r"The covariance matrix $P_{xy}$ is given. ",
            r"\mathbf{x}^T P_{xy} \mathbf{y} = \mathbf{y}^T P_{xy} \mathbf{x}",
        ),
        (VARIANCE, r"\frac{d L(\mathbf{u}, \mu)}{d \mathbf{u}} = 2 \mathbf{S} \mathbf{u} - 2 \lambda \mathbf{u}"),
    ],
)
def test_what_is_false_of_a_motion_does_not_follow(above, claim):
    assert last(rf"{above} \[ {claim}. \]").verdict != "follows"


def test_what_is_positive_definite_is_symmetric_as_well():
    latex = r"The covariance matrix $P$ is positive definite. Let $P$ be a positive definite matrix. Then "
    assert last(latex + r"\[ \mathbf{x}^T P \mathbf{y} = \mathbf{y}^T P \mathbf{x}. \]").verdict == "follows"


def test_a_new_letter_within_a_chain_is_what_stands_before_it():
    found = last(TURN + r"\[ R^T \dot R = W = \begin{bmatrix} 0 & -\dot\theta \\ \dot\theta & 0 \end{bmatrix} \]")
    assert [link.verdict for link in found.links] == ["definition", "follows"]
    false = last(TURN + r"\[ R^T \dot R = W = \begin{bmatrix} 0 & \dot\theta \\ -\dot\theta & 0 \end{bmatrix} \]")
    assert false.verdict not in ("definition", "follows")


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\[ \frac{dx}{dt} = v. \]", "definition"),
        (r"\[ \frac{d\vec r_i}{dt} = \vec v_i. \]", "definition"),
        (r"\[ \frac{dx}{dt} = v \] and \[ \frac{d^2x}{dt^2} = \frac{dv}{dt}. \]", "follows"),
        (r"\[ \frac{dx}{dt} = \infty. \]", "not decided"),
        (r"\[ \frac{dx}{dt} = x. \]", "independent"),
        (r"\[ y = v + 1 \] \[ \frac{dx}{dt} = v. \]", "definition"),
        (r"\[ y = v + 1 \] \[ v^2 = b c \] \[ \frac{dx}{dt} = v. \]", "independent"),
        (r"\[ x = b t \] \[ \frac{dx}{dt} = v. \]", "independent"),
        (r"At the turning point \[ \frac{dx}{dt} = v. \] If \[ \frac{dy}{dt} = w \] we stop.", "independent"),
        (r"The velocity is $v$. \[ \frac{dx}{dt} = v. \]", "definition"),
        (r"It is not true that \[ \frac{dx}{dt} = v. \]", "independent"),
    ],
)
def test_an_equation_of_a_rate_and_a_new_letter_names_the_rate(latex, verdict):
    assert last(latex).verdict == verdict


CIRCUIT = (
    r"In a circuit \[ R \frac{dq}{dt} + \frac{q}{C} = V. \] The charge is \[ q = C V \left(1 - e^{-t/(R C)}\right). \] "
    r"Since $R$, $C$ and $V$ are constant, "
)


@pytest.mark.parametrize(
    ("claim", "follows"),
    [
        (r"\frac{dq}{dt} = \frac{V}{R} e^{-t/(R C)}", True),
        (r"\frac{dq}{dt} = \frac{V}{R} e^{t/(R C)}", False),
        (r"\frac{dq}{dt} = \frac{V}{C} e^{-t/(R C)}", False),
    ],
)
def test_what_gives_a_letter_of_an_equation_of_motion_is_differentiated_beside_it(claim, follows):
    assert (last(rf"{CIRCUIT} \[ {claim}. \]").verdict == "follows") is follows
