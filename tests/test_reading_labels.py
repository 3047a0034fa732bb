"""What stands above a letter: the number of a step, a power, or the sign of a transposed matrix."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

MOTION = (
    r"\[ \mathbf{q}^{t+1} = \mathbf{q}^t + \Delta t \dot{\mathbf{q}}^{t+1} \] "
    r"\[ M \dot{\mathbf{q}}^{t+1} = M \dot{\mathbf{q}}^t + \Delta t \mathbf{f}^{t+1} \] "
)
FRAMES = (
    r"From $B$ to $W$ it is \[ \begin{bmatrix} x^W \\ y^W \end{bmatrix} = "
    r"a \begin{bmatrix} x^B \\ y^B \end{bmatrix} + \begin{bmatrix} t_W \\ 0 \end{bmatrix} \] "
)
MESH = r"The loads satisfy \[ \vec{f}^{DL} = M_l^D \vec{u}^D. \] "
DRAG = r"\[ (C_D)_\mathrm{wing} = 2 q \] \[ C = a (C_D)_\mathrm{wing}^2 \] "
STEP = r"\[ u^{n+1} = u^n + h f^n \] "


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (DRAG + r"Hence \[ C = 4 a q^2. \]", True),
        (DRAG + r"Hence \[ C = 4 a q. \]", False),
        (DRAG + r"Hence \[ a (C_D)_\mathrm{tail}^2 = 4 a q^2. \]", False),
        (DRAG + r"Hence \[ a C_D^2 = 4 a q^2. \]", False),
        (MOTION + r"\[ M (\mathbf{q}^{t+1} - \mathbf{q}^t) = \Delta t M \dot{\mathbf{q}}^{t+1} \]", True),
        (MOTION + r"\[ M (\mathbf{q}^{t+1} - \mathbf{q}^t) = \Delta t M \dot{\mathbf{q}}^t \]", False),
        (
            r"\[ \dot{\mathbf{p}}^t_i = \frac{\mathbf{p}^t_i - \mathbf{p}^{t-\Delta t}_i}{\Delta t} \] "
            r"\[ \mathbf{p}^t_i = \mathbf{p}^{t-\Delta t}_i + \Delta t \dot{\mathbf{p}}^t_i \]",
            True,
        ),
        (
            r"\[ \theta^{t+1} = \theta^t - \eta v^t \] \[ v^t = \beta g^t + c \] "
            r"\[ \theta^{t+1} = \theta^t - \eta (\beta g^t + c) \]",
            True,
        ),
        (STEP + r"\[ f^n = -u^n \] \[ u^{n+1} = (1 - h) u^n \]", True),
        (FRAMES + r"Hence \[ x^W = a x^B + t_W. \]", True),
        (FRAMES + r"Hence \[ x^W = a x^B + b t_W. \]", False),
        (r"\[ a = x^N \] \[ b = y^N \] Hence \[ a b = (x y)^N. \] Thus \[ a b = x^N y^N. \]", True),
        (
            r"\[ \mathbf{r}^k = \mathbf{d}^o - \mathbf{A}^k \mathbf{p}^k. \] Here $k$ counts. Hence "
            r"\[ \mathbf{d}^o = \mathbf{r}^k + \mathbf{A}^k \mathbf{p}^k. \]",
            True,
        ),
        (
            r"\[ \mathbf{x}^k = \mathbf{A}^k \mathbf{y}. \] Hence \[ \mathbf{A} \mathbf{x}^k = \mathbf{A}^{k + "
            r"1} \mathbf{y}. \]",
            False,
        ),
        (STEP + r"\[ f = -u \] Hence \[ u^{n+1} = (1 - h) u^n. \]", False),
        (STEP + r"\[ f^n = -u^n \] Hence \[ f^2 = (u^2)^2. \]", False),
        (r"\[ x^{k+1} = x^k + h \] \[ x_k = 2 \] Hence \[ x^{k+1} = 2 + h. \]", False),
        (r"\[ p = x^{n+1} + x^n \] \[ p = x^n (1 + x) \]", True),
        (r"\[ U = \beta^t u + \beta^{t+1} v \] Hence \[ U = \beta^t u + \beta v. \]", False),
        (r"\[ \mathbf{x}^{t+1} = \mathbf{x}^t + \mathbf{d} \] \[ y^t z = a \] Hence \[ z y^t = a. \]", False),
        (r"\[ \mathbf{s} = A^t \mathbf{v} \] \[ \mathbf{s}^t = \mathbf{v}^t A \]", True),
        (MESH + r"Hence \[ \vec{u}^D = (M_l^D)^{-1} \vec{f}^{DL}. \]", True),
        (MESH + r"Hence \[ \vec{u}^D = M_l^{-D} \vec{f}^{DL}. \]", False),
        (MESH + r"Hence \[ \vec{u}^D = (M_l^{DL})^{-1} \vec{f}^{DL}. \]", False),
        (MESH + r"\[ K = M_l^D \] Hence \[ K = M_l \cdots M_l. \]", False),
        (MESH + r"\[ M_l = K \] Hence \[ \vec{f}^{DL} = K^D \vec{u}^D. \]", False),
        (MESH + r"Hence \[ M_l \vec{f}^{DL} = M_l^{D + 1} \vec{u}^D. \]", False),
    ],
)
def test_a_number_of_a_step_is_no_power(latex: str, follows: bool) -> None:
    assert (read_document(document_of(latex))[-1].verdict == "follows") is follows


@pytest.mark.parametrize(
    ("latex", "read"),
    [
        (r"\[ \mathbf{q}^{t+1} = \mathbf{q}^t + \mathbf{v} \]", "q_tplus1 = q_t + v"),
        (r"\[ s = \mathbf{a}^t \mathbf{b} \]", "s = a.T*b"),
        (r"\[ U = \beta^t u + \beta^{t+1} v \]", "U = beta.T*u + beta**(t + 1)*v"),
        (r"\[ x = a e^t \]", "x = a*e**t"),
    ],
)
def test_a_t_above_a_letter_counts_steps_where_the_next_one_is_named(latex: str, read: str) -> None:
    assert read_document(document_of(latex))[0].read == read


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("v(0)", "v(1)"),
        ("error (left)", "error (right)"),
        ("a, b", "a, d"),
        ("Höhe", "Größe"),
        (r"\% error", r"\% gain"),
        ("``left''", "``right''"),
    ],
)
def test_words_that_name_what_is_equal_are_not_left_out(one, other):
    apart = rf"\[ \text{{{one}}} = c \] Hence \[ \text{{{other}}} = c \]"
    rows = rf"\begin{{align}} s &= c \\ \text{{{other}}} &= c \end{{align}}"
    for text in (apart, rows):
        assert read_document(document_of(text, latex=True), seconds=5)[-1].verdict != "follows"


@pytest.mark.parametrize("words", ["or, in other words,", "(by symmetry)", "which is"])
def test_words_that_lead_to_a_relation_are_left_out(words):
    text = rf"\[ s = a + b \] \[ \text{{{words}}} = b + a \]"
    assert read_document(document_of(text, latex=True), seconds=5)[-1].verdict == "follows"


@pytest.mark.parametrize(
    "changed",
    [
        r"\text{new } s = a + b",
        r"\text{half of } s = a + b",
        r"\text{-}s = a + b",
        r"\text{--}s = a + b",
        r"s = a + b[1]",
        r"s = a(1) + b",
        r"s \overset{(mod 2)}{=} a + b",
        r"s \overset{\text{wrong}}{=} a + b",
        r"s \underset{\text{only in 2D}}{=} a + b",
        "\n\\iffalse + \\else - \\fi s = a + b",
    ],
)
def test_what_changes_an_equation_is_not_left_out(changed):
    text = rf"\[ s = a + b \] Hence \[ {changed} \]"
    assert read_document(document_of(text, latex=True), seconds=5)[-1].verdict != "follows"


def test_a_matrix_is_given_by_those_with_what_stands_above_a_vector() -> None:
    given = r"\[ M_{uD} = D_1 M_{uD}^D. \]"
    assert read_document(document_of(MESH + r"The routine returns " + given))[-1].verdict == "definition"
    assert read_document(document_of(r"The routine returns " + given))[-1].verdict != "definition"
