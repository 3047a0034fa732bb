r"""Letters of frames: ``{}^A R^B``, ``{}^A \omega {}^B``, and the column ``[v]_A`` of a vector in a frame."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

_ROTATED = r"\[ {}^d R^a = {}^d R^c \, {}^c R^a \] \[ [\mathbf{v}]_d = {}^d R^a [\mathbf{v}]_a \] So "
_RATES = r"\[ {}^A \vec\omega {}^C = {}^A \vec\omega {}^B + {}^B \vec\omega {}^C \] "


def verdicts(latex: str) -> list[str]:
    return [each.verdict for each in read_document(document_of(latex))]


@pytest.mark.parametrize(
    "latex",
    [
        _ROTATED + r"\[ [\mathbf{v}]_d = {}^d R^c \, {}^c R^a [\mathbf{v}]_a \]",
        _ROTATED + r"\[ [\mathbf{v}]_d^T = [\mathbf{v}]_a^T ({}^d R^a)^T \]",
        _RATES + r"So \[ {}^A \vec\omega {}^C - {}^B \vec\omega {}^C = {}^A \vec\omega {}^B \]",
        _RATES + r"So \[ {}^A\vec\omega{}^C = {}^A\vec\omega^B + {}^B\vec\omega^C \]",
    ],
)
def test_a_letter_with_a_frame_before_it_has_the_one_behind_it_in_its_name(latex):
    first, *_, last = verdicts(latex)
    assert (first, last) == ("definition", "follows")


@pytest.mark.parametrize(
    "latex",
    [
        _ROTATED + r"\[ [\mathbf{v}]_d = {}^c R^a \, {}^d R^c [\mathbf{v}]_a \]",
        _ROTATED + r"\[ [\mathbf{v}]_d = {}^d R^c \, {}^c R^a [\mathbf{v}]_d \]",
        _ROTATED + r"\[ [\mathbf{v}]_d = {}^d R^c \, {}^a R^c [\mathbf{v}]_a \]",
        _ROTATED + r"\[ [\mathbf{v}]_d = [\mathbf{v}]_a \]",
        _ROTATED + r"\[ [\mathbf{v}]_d = [\mathbf{w}]_d \]",
        _ROTATED + r"\[ [\mathbf{v}]_d = {}^d R^a \mathbf{v} \]",
        r"\[ \mathbf{v} = \mathbf{w} \] So \[ [\mathbf{v}]_a = \mathbf{w} \]",
        r"\[ {}^d R^a \, {}^c R^d = {}^c R^d \, {}^d R^a \]",
        r"\[ {}^A R^B = a \] So \[ {}^B R^A = a \]",
        r"\[ {}^A p {}^B q = c \] So \[ {}^A p^B q = c \]",
        r"\[ {}^A R^T = a \] So \[ {}^A R = a \]",
        r"\[ [\mathbf{v}]_a = t \mathbf{c} \] So \[ [\dot{\mathbf{v}}]_a = \mathbf{c} \]",
        r"\[ \begin{bmatrix} 1 \\ 0 \end{bmatrix}_a = \begin{bmatrix} 1 \\ 0 \end{bmatrix}_b \]",
        _RATES + r"So \[ {}^C \vec\omega {}^A = {}^A \vec\omega {}^B + {}^B \vec\omega {}^C \]",
    ],
)
def test_another_frame_is_another_letter(latex):
    assert verdicts(latex)[-1] not in ("follows", "contradicts")


def test_a_frame_before_the_next_letter_is_of_that_letter():
    document = document_of(r"\[ s = {}^A p {}^B q \]")
    assert read_document(document)[0].read == "s = p_A*q_B"


@pytest.mark.parametrize("space", [r"\,", r"\;", r"\: "])
def test_a_frame_behind_a_thin_space_is_of_the_letter_behind_it(space):
    document = document_of(rf"\[ \mathbf{{u}} = \mathbf{{R}}(q){space}^B_A\mathbf{{v}} \]")
    assert read_document(document)[0].read == "u = R(q)*v_B_A"


def test_a_power_or_a_mark_behind_a_thin_space_is_of_what_stands_before_it():
    document = document_of(r"\[ y = x\,^2 a + A\,^T b + (c d)\,^n \] \[ z = \sin(30\,^\circ) x \]")
    assert [each.read for each in read_document(document)] == ["y = x**2*a + A.T*b + (c*d)**n", "z = sin(30*pi/180)*x"]
    assert read_document(document_of(r"\[ T = 20\,^\circ C \]"))[0].verdict == "not read"


def test_a_star_above_a_letter_with_a_frame_is_part_of_its_name():
    given = r"\[ {}^A h = {}^A X^{*}_B \, {}^B h \] \[ {}^B h = {}^B I \, {}^B v \]"
    latex = given + r" Hence \[ {}^A h = {}^A X^{*}_B \, {}^B I \, {}^B v \]"
    assert [each.verdict for each in read_document(document_of(latex))] == ["definition", "definition", "follows"]
    latex = latex.replace(r"Hence \[ {}^A h = {}^A X^{*}_B", r"Hence \[ {}^A h = {}^A X_B")
    assert read_document(document_of(latex))[-1].verdict not in ("follows", "contradicts")
