"""A matrix of the cross product, or a column with a block, that is printed says what the components of a vector are."""

import pytest
from cases import for_each

from algebroproj_sym.reading import document_of, read_document
from algebroproj_sym.reading.defining.kinds import kinds_of
from algebroproj_sym.reading.parsing.grammar import parsed

pytestmark = pytest.mark.usefixtures("verdicts_alone")

_MATRIX = r"= \begin{bmatrix} 0 & -w_3 & w_2 \\ w_3 & 0 & -w_1 \\ -w_2 & w_1 & 0 \end{bmatrix} \] "
_BRACKET = r"\[ [\mathbf w]_\times " + _MATRIX
_FUNCTION = r"\[ S(\mathbf w) " + _MATRIX + r"Let $R$ be a rotation matrix. "
_BOLD = r"The rate $\mathbf w$ is a vector. \[ \hat{\mathbf w} " + _MATRIX
_HAT = r"The rate $w$ is a vector. \[ \hat w " + _MATRIX


def verdicts(latex):
    return [each.verdict for each in read_document(document_of(latex))]


@for_each(
    "latex",
    [
        _BRACKET + r"\[ \mathbf w^T \mathbf w = w_1^2 + w_2^2 + w_3^2 \]",
        _BRACKET + r"\[ \mathbf w^T [\mathbf w]_\times = 0 \]",
        r"The vector is used. \[ a = \mathbf w^T \mathbf b + w_1 \] where "
        + _BRACKET
        + r"\[ \mathbf w^T \mathbf w = w_1^2 + w_2^2 + w_3^2 \]",
        _FUNCTION + r"\[ S(\mathbf w) \mathbf b = \mathbf w \times \mathbf b \]",
        _FUNCTION + r"\[ S(\mathbf a) \mathbf b = -S(\mathbf b) \mathbf a \]",
        _FUNCTION + r"\[ S(\mathbf a + \mathbf b) = S(\mathbf a) + S(\mathbf b) \]",
        _FUNCTION + r"\[ R S(\mathbf w) R^T = S(R \mathbf w) \]",
        _FUNCTION + r"\[ S(\mathbf a) S(\mathbf b) = \mathbf b \mathbf a^T - \mathbf a^T \mathbf b I_{3 \times 3} \]",
        _HAT + r"\[ \hat w^3 = -(w^T w) \hat w \]",
        _HAT + r"\[ \hat w w = 0 \]",
        _BOLD + r"\[ \hat{\mathbf a} \mathbf b = -\hat{\mathbf b} \mathbf a \]",
        _BOLD + r"\[ \hat{\mathbf w}_{B/N} \mathbf b = \mathbf w_{B/N} \times \mathbf b \]",
    ],
)
def test_a_printed_matrix_of_the_cross_product_defines_it(latex):
    first, *_, last = verdicts(latex)
    assert (first, last) == ("definition", "follows")


@for_each(
    "latex",
    [
        _BRACKET + r"\[ \mathbf w^T \mathbf w = w_1^2 + w_2^2 - w_3^2 \]",
        _FUNCTION + r"\[ S(\mathbf a) \mathbf b = S(\mathbf b) \mathbf a \]",
        _FUNCTION + r"\[ R^T S(\mathbf w) R = S(R \mathbf w) \]",
        _FUNCTION + r"\[ S(\mathbf a) S(\mathbf b) = \mathbf a \mathbf b^T - \mathbf a^T \mathbf b I_{3 \times 3} \]",
        _FUNCTION.replace("-w_2 & w_1", "w_2 & w_1") + r"\[ S(\mathbf a) \mathbf b = -S(\mathbf b) \mathbf a \]",
        _FUNCTION.replace("w_1", "v_1") + r"\[ S(\mathbf a) \mathbf b = -S(\mathbf b) \mathbf a \]",
        _FUNCTION.replace("w_1", "x").replace("w_3", "w_1").replace("x", "w_3") + r"\[ S(\mathbf a) \mathbf a = 0 \]",
        r"\[ S(\mathbf a) \mathbf b = -S(\mathbf b) \mathbf a \] " + _FUNCTION,
        r"\[ \mathbf w^T \mathbf w = w_1^2 + w_2^2 + w_3^2 \] " + _BRACKET,
        _HAT.replace("w_1", "v_1") + r"\[ \hat w w = 0 \]",
        _HAT + r"\[ \hat v v = 0 \]",
        _BOLD.replace("w_1", "v_1") + r"\[ \hat{\mathbf a} \mathbf b = -\hat{\mathbf b} \mathbf a \]",
        "It would be wrong to write " + _FUNCTION + r"Hence \[ S(\mathbf a) \mathbf b = -S(\mathbf b) \mathbf a \]",
        "Do not write " + _FUNCTION + r"Hence \[ S(\mathbf a) \mathbf b = -S(\mathbf b) \mathbf a \]",
    ],
)
def test_another_matrix_or_one_further_down_does_not(latex):
    found = verdicts(latex)
    assert "follows" not in found
    assert "contradicts" not in found


_BLOCK = (
    r"\[ n = s^2 \] \[ \mathbf q := \begin{bmatrix} s \\ \mathbf v \end{bmatrix}"
    r" = \begin{bmatrix} s \\ x \\ y \\ z \end{bmatrix} \] Hence "
)
_LENGTH = r"\[ \mathbf v^T \mathbf v = x^2 + y^2 + z^2 \]"


def test_a_column_tells_the_components_of_its_block():
    assert verdicts(_BLOCK + _LENGTH) == ["definition", "definition", "follows"]


@for_each(
    "latex",
    [
        _BLOCK + _LENGTH.replace("z^2", "s^2"),
        _BLOCK.replace(r"x \\ y", r"y \\ x \\ x") + _LENGTH,
        _BLOCK.replace(r"s \\ x", r"t \\ x") + _LENGTH,
        _LENGTH + _BLOCK + "it is.",
    ],
)
def test_another_column_does_not(latex):
    assert "follows" not in verdicts(latex)


_TILDE = (
    r"The momentum is \[ \mathbf h = \mathbf r \times \mathbf p. \] The tilde matrix $[\tilde{\mathbf r}]$ is usual. "
)


@for_each(
    "latex",
    [
        _TILDE + r"Hence \[ \mathbf h = [\tilde{\mathbf r}] \mathbf p. \]",
        _TILDE + r"We have \[ [\tilde{\mathbf r}] \mathbf a = -[\tilde{\mathbf a}] \mathbf r. \]",
        _TILDE
        + r"We have \[ \mathbf a^T [\mathbf{\tilde r}_{B/N}] = -\left([\tilde{\mathbf r}_{B/N}] \mathbf a\right)^T. \]",
    ],
)
def test_a_tilde_in_square_brackets_marks_a_cross_product(latex):
    assert verdicts(latex)[-1] == "follows"


@for_each(
    "latex",
    [
        _TILDE + r"Hence \[ \mathbf h = -[\tilde{\mathbf r}] \mathbf p. \]",
        _TILDE
        + r"\[ \mathbf r = \tilde{\mathbf r} + \mathbf e \] Hence \[ \mathbf h = [\tilde{\mathbf r}] \mathbf p. \]",
        _TILDE.replace(r"\times", "+")
        + r"We have \[ [\tilde{\mathbf r}] \mathbf a = -[\tilde{\mathbf a}] \mathbf r. \]",
        _TILDE.replace(r"\mathbf r \times", r"\mathbf q \times")
        + r"We have \[ [\tilde{\mathbf r}] [\tilde{\mathbf r}]^T = -[\tilde{\mathbf r}]^2. \]",
    ],
)
def test_another_tilde_does_not(latex):
    assert verdicts(latex)[-1] not in ("follows", "contradicts")


_MOMENTUM = (
    r"The momentum is \[ @h = \sum_{i=1}^n m_i (@c + @q_i) \times (@u + @w_i). \] Multiplying out gives \[ @h = "
)
_PARTS = (
    r"M @c \times @u + @c \times \sum_{i=1}^n m_i @w_i + \left(\sum_{i=1}^n m_i @q_i\right) \times @u"
    r" + \sum_{i=1}^n m_i @q_i \times @w_i. \]"
).replace("M", r"\left(\sum_{i=1}^n m_i\right)")


def test_a_cross_product_in_a_sum_is_taken_term_by_term():
    first, last = verdicts((_MOMENTUM + _PARTS).replace("@", r"\mathbf "))
    assert (first, last) == ("definition", "follows")


@for_each(
    ("one", "other"),
    [
        (r"\right) \times @u +", r"\right) \times @u -"),
        (r"@u + @c", "@u - @c"),
        (r"@q_i \times @w_i", r"@w_i \times @q_i"),
    ],
)
def test_its_factors_keep_their_order(one, other):
    assert one in _PARTS
    assert verdicts((_MOMENTUM + _PARTS.replace(one, other)).replace("@", r"\mathbf "))[-1] != "follows"


def test_a_small_letter_before_the_matrix_of_a_cross_product_is_a_number():
    torque = parsed(r"(m [\mathbf c]_\times + \mathbf C) \mathbf a = \mathbf f")
    assert "m" not in kinds_of([torque], set(), "", frozenset()).open
