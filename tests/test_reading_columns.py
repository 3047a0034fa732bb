"""Printed columns that are put in as a whole, frames that cancel, and derivatives with their letter below the sign."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def column(*entries):
    return r"\begin{bmatrix}" + r"\\".join(entries) + r"\end{bmatrix}"


def shown(text):
    return rf" \[ {text} \] "


PIXEL, POINT, IDEAL = column("u", "v", "1"), column("X", "Y", "Z"), column("x", "y", "1")
CAMERA = (
    shown(rf"{PIXEL} = \mathbf{{K}} {IDEAL}")
    + shown(rf"{IDEAL} = \frac{{1}}{{Z}} {POINT}")
    + shown(rf"{POINT} = \mathbf{{R}} {column('A', 'B', 'C')} + \mathbf t")
    + "Hence"
)
DIRECTION = column(r"\mathbf p", "0")
P, Q, R = (column(rf"\mathbf {each}", "1") for each in "pqr")
HOMOGENEOUS = shown(rf"{P} = \mathbf H {Q}") + shown(rf"{Q} = \mathbf G {R}") + "Hence"
CHAIN = r"The frames give \[ x^a = R^a_b x^b + t^a_b \] \[ x^b = R^b_c x^c + t^b_c \] Hence"
WAVE = r"The wave obeys \[ \partial_t u + c \partial_x u = 0. \] Hence"
ENERGY = r"The energy is \[ E = \frac12 a x^2 + b t. \] Hence"


def last_of(latex):
    return read_document(document_of(latex, latex=True), seconds=5)[-1].links[-1]


@pytest.mark.parametrize(
    "latex",
    [
        CAMERA + shown(rf"{PIXEL} = \frac1Z \mathbf K {POINT}"),
        CAMERA + shown(rf"{PIXEL} = \frac1Z \mathbf K (\mathbf R {column('A', 'B', 'C')} + \mathbf t)"),
        HOMOGENEOUS + shown(rf"{P} = \mathbf H \mathbf G {R}"),
        HOMOGENEOUS + shown(rf"{R} = \mathbf G^{{-1}} \mathbf H^{{-1}} {P}"),
        CHAIN + shown(r"x^a = R^a_b R^b_c x^c + R^a_b t^b_c + t^a_b"),
        WAVE + shown(r"\partial_t u = - c \, \partial_x u"),
        ENERGY + shown(r"\partial_x E = a x"),
        ENERGY + shown(r"\partial_{xx} E + \partial_t E = a + b"),
        r"The chain rule gives \[ \frac{\partial f}{\partial x_1} \frac{\partial x_1}{\partial x_1} = "
        r"\frac{\partial f}{\partial x_1} \]",
    ],
)
def test_it_follows(latex):
    assert last_of(latex).verdict == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        CAMERA + shown(rf"{PIXEL} = \mathbf K {POINT}"),
        CAMERA + shown(rf"{PIXEL} = \frac1Z \mathbf R (\mathbf K {column('A', 'B', 'C')} + \mathbf t)"),
        CAMERA + shown(rf"{column('v', 'u', '1')} = \frac1Z \mathbf K {POINT}"),
        HOMOGENEOUS + shown(rf"{P} = \mathbf G \mathbf H {R}"),
        HOMOGENEOUS + shown(rf"{R} = \mathbf H^{{-1}} \mathbf G^{{-1}} {P}"),
        HOMOGENEOUS + shown(rf"{DIRECTION} = \mathbf H \mathbf G {R}"),
        shown(rf"{column('a', 'b')} {column('c', 'd')} = {column('u', 'v')} {column('x', 'y')}")
        + r"Hence \[ a c = u x \]",
        shown(rf"s = {P}^T M {R}") + "Hence" + shown(rf"s = {R}^T M {P}"),
        r"\[ \left[\begin{array}{c} a \\ b \end{array}\right] \left[\begin{array}{c} c \\ d \end{array}\right]"
        r" = \left[\begin{array}{c} u \\ v \end{array}\right] \left[\begin{array}{c} x \\ y \end{array}\right] \]"
        r" Hence \[ a c = u x \]",
        CHAIN + shown(r"x^a = R^b_c R^a_b x^c + R^a_b t^b_c + t^a_b"),
        CHAIN + shown(r"x^a = R^a_b R^b_c x^c + R^b_c t^b_c + t^a_b"),
        WAVE + shown(r"\partial_t u = c \, \partial_x u"),
        ENERGY + shown(r"\partial_x E = a t"),
        r"\[ \partial_x a b = b \partial_x a \]",
        r"\[ \partial_x u^2 = u \partial_x u \]",
        r"\[ \frac{\partial x_i}{\partial x_i} = 1 \]",
        r"\[ \frac{\partial x_1}{\partial x_2} = 1 \]",
        r"\[ \frac{\partial \mathbf x}{\partial \mathbf x} = 1 \]",
    ],
)
def test_it_does_not_follow(latex):
    assert last_of(latex).verdict not in ("follows", "contradicts")
