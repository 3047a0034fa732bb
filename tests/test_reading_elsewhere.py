"""What words say of a letter late, or in another section, where it is called something else."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")


def last_of(latex):
    return read_document(document_of(latex, latex=True), seconds=5)[-1]


@pytest.mark.parametrize(
    ("first", "second", "follows"),
    [
        ("The matrix $R$ is a rotation matrix.", "Here $R$ denotes the covariance of the noise.", False),
        ("The matrix $R$ is a rotation matrix.", "The measurement noise $R$ is large.", False),
        ("The matrix $R$ is an orthogonal matrix.", "Here $R$ is the set of residuals.", False),
        ("The matrix $R$ is a rotation matrix.", "Here $R$ is the attitude of the camera.", True),
        ("The matrix $R$ is a rotation matrix.", "The camera is at rest.", True),
    ],
)
def test_a_property_does_not_hold_where_another_section_calls_the_letter_something_else(first, second, follows):
    text = rf"\section{{A}} {first} \section{{B}} {second} \[ R^T R = I. \]"
    assert (last_of(text).verdict == "follows") is follows


@pytest.mark.parametrize(
    ("behind", "follows"),
    [
        ("The letters denote: $M$ mass matrix, $N$ damping matrix.", False),
        ("Letters: $M$ matrix, $N$ vector.", False),
        ("The letters denote: $M$ mass, $N$ damping.", True),
        ("We use $M$ rows of a matrix.", True),
    ],
)
def test_a_list_behind_equations_calls_letters_matrices(behind, follows):
    text = rf"\[ S = (M - N)(M + N) \] Hence \[ S = M^2 - N^2. \] {behind}"
    assert (last_of(text).verdict == "follows") is follows
