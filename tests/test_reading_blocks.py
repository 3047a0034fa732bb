"""Matrices of blocks whose sizes nothing says: they are added and multiplied block by block."""

import pytest

from algebroproj_sym.reading import document_of, read_document
from algebroproj_sym.reading.defining.symbols import SymbolsFile
from algebroproj_sym.reading.lexing.pieces import pieces_of, with_blocks
from algebroproj_sym.reading.remembering.survey import Survey

pytestmark = pytest.mark.usefixtures("verdicts_alone")

_GIVEN = (
    r"\[ \mathbf{z} = \begin{bmatrix} \mathbf{x} \\ \boldsymbol{\mu} \end{bmatrix} \] "
    r"\[ \mathbf{L} = \begin{bmatrix} \mathbf{A} & \mathbf{B} \\ 0 & \mathbf{A}^T \end{bmatrix} \] "
)


def last(latex: str) -> str:
    return read_document(document_of(_GIVEN + latex))[-1].verdict


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \mathbf{L} \mathbf{z} = \begin{bmatrix} \mathbf{A} \mathbf{x} + \mathbf{B} \boldsymbol{\mu} \\ "
        r"\mathbf{A}^T \boldsymbol{\mu} \end{bmatrix} \]",
        r"\[ \mathbf{L}^T = \begin{bmatrix} \mathbf{A}^T & 0 \\ \mathbf{B}^T & \mathbf{A} \end{bmatrix} \]",
        r"\[ \mathbf{z}^T \mathbf{z} = \mathbf{x}^T \mathbf{x} + \boldsymbol{\mu}^T \boldsymbol{\mu} \]",
        r"\[ \mathbf{z}^T \mathbf{L} \mathbf{z} = \mathbf{x}^T \mathbf{A} \mathbf{x} + \mathbf{x}^T \mathbf{B} "
        r"\boldsymbol{\mu} + \boldsymbol{\mu}^T \mathbf{A}^T \boldsymbol{\mu} \]",
        r"\[ 3 \mathbf{z} - a \mathbf{z} = (3 - a) \begin{bmatrix} \mathbf{x} \\ \boldsymbol{\mu} \end{bmatrix} \]",
        r"\[ \mathbf{z} - \begin{bmatrix} \mathbf{x} \\ \boldsymbol{\mu} \end{bmatrix} = 0 \]",
        r"\[ \mathbf{y} = \mathbf{C} \mathbf{x} \] "
        r"\[ \mathbf{y} = \begin{bmatrix} \mathbf{C} & 0 \end{bmatrix} \mathbf{z} \]",
    ],
)
def test_blocks_are_added_and_multiplied_one_by_one(latex):
    assert last(latex) == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \mathbf{L} \mathbf{z} = \begin{bmatrix} \mathbf{A} \mathbf{x} + \mathbf{B} \boldsymbol{\mu} \\ "
        r"\mathbf{A} \boldsymbol{\mu} \end{bmatrix} \]",
        r"\[ \mathbf{L} \mathbf{z} = \begin{bmatrix} \mathbf{A} \mathbf{x} \\ \mathbf{A}^T \boldsymbol{\mu} "
        r"\end{bmatrix} \]",
        r"\[ \mathbf{L} \mathbf{z} = \begin{bmatrix} \mathbf{x} \mathbf{A} + \boldsymbol{\mu} \mathbf{B} \\ "
        r"\boldsymbol{\mu} \mathbf{A}^T \end{bmatrix} \]",
        r"\[ \mathbf{L}^T = \begin{bmatrix} \mathbf{A}^T & \mathbf{B}^T \\ 0 & \mathbf{A} \end{bmatrix} \]",
        r"\[ \mathbf{L}^{-1} = \begin{bmatrix} \mathbf{A}^{-1} & \mathbf{B}^{-1} \\ 0 & \mathbf{A}^{-T} "
        r"\end{bmatrix} \]",
        r"\[ \mathbf{z} \mathbf{z}^T = \mathbf{x}^T \mathbf{x} + \boldsymbol{\mu}^T \boldsymbol{\mu} \]",
        r"\[ \mathbf{z}^T \mathbf{z} = \mathbf{x}^T \mathbf{x} + \mathbf{x}^T \boldsymbol{\mu} \]",
        r"\[ \mathbf{z} = \begin{bmatrix} \boldsymbol{\mu} \\ \mathbf{x} \end{bmatrix} \]",
        r"\[ \mathbf{z} - \begin{bmatrix} \mathbf{x} \\ \boldsymbol{\mu} \end{bmatrix} = 1 \]",
        r"\[ \mathbf{z} - \begin{bmatrix} \mathbf{x} \\ 0 \end{bmatrix} = 0 \]",
        r"\[ 2 \mathbf{z} = \begin{bmatrix} 2 \mathbf{x} \\ \boldsymbol{\mu} \end{bmatrix} \]",
        r"\[ \mathbf{L} = \begin{bmatrix} \mathbf{A} & \mathbf{B} & 0 \\ 0 & \mathbf{A}^T & 0 \end{bmatrix} \]",
        r"\[ |\mathbf{L}| = |\mathbf{A}| |\mathbf{A}| - |\mathbf{B}| \]",
    ],
)
def test_what_is_true_of_no_blocks_does_not_follow(latex):
    assert last(latex) not in ("follows", "contradicts")


_RIGID = r"Let $R \in SO(3)$. \[ T = \begin{bmatrix} R & t \\ \mathbf{0}^T & 1 \end{bmatrix} \] "


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ T \begin{bmatrix} p \\ 1 \end{bmatrix} = \begin{bmatrix} R p + t \\ 1 \end{bmatrix} \]",
        r"\[ T T = \begin{bmatrix} R R & R t + t \\ 0 & 1 \end{bmatrix} \]",
        r"\[ T^{-1} = \begin{bmatrix} R^T & -R^T t \\ 0 & 1 \end{bmatrix} \]",
        r"\[ T T^{-1} = \begin{bmatrix} I & 0 \\ 0 & 1 \end{bmatrix} \]",
        r"\[ T \begin{bmatrix} \mathbf{v} \\ 0 \end{bmatrix} = \begin{bmatrix} R \mathbf{v} \\ 0 \end{bmatrix} \]",
    ],
)
def test_thin_letters_beside_blocks_may_be_blocks_and_have_the_size_that_is_left(latex):
    assert read_document(document_of(_RIGID + latex))[-1].verdict == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ T \begin{bmatrix} p \\ 1 \end{bmatrix} = \begin{bmatrix} R p \\ 1 \end{bmatrix} \]",
        r"\[ T \begin{bmatrix} p \\ 1 \end{bmatrix} = \begin{bmatrix} p R + t \\ 1 \end{bmatrix} \]",
        r"\[ T T = \begin{bmatrix} R R & t R + t \\ 0 & 1 \end{bmatrix} \]",
        r"\[ T^{-1} = \begin{bmatrix} R^T & -t R^T \\ 0 & 1 \end{bmatrix} \]",
        r"\[ T^{-1} = \begin{bmatrix} R^T & -R t \\ 0 & 1 \end{bmatrix} \]",
        r"\[ T^T = \begin{bmatrix} R^T & 0 \\ t & 1 \end{bmatrix} \]",
        r"\[ \begin{bmatrix} p \\ 1 \end{bmatrix} T = \begin{bmatrix} R p + t \\ 1 \end{bmatrix} \]",
        r"\[ T \begin{bmatrix} p \\ q \end{bmatrix} = \begin{bmatrix} R p + t \\ q \end{bmatrix} \]",
        r"\[ T \begin{bmatrix} 1 \\ p \end{bmatrix} = \begin{bmatrix} 1 \\ R p + t \end{bmatrix} \]",
    ],
)
def test_what_is_false_of_blocks_does_not_follow(latex):
    assert read_document(document_of(_RIGID + latex))[-1].verdict != "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ M^{-1} = \begin{bmatrix} A^{-1} & -b A^{-1} \\ \mathbf{0}^T & 1 \end{bmatrix} \]",
        r"\[ M M = \begin{bmatrix} A^2 & 2 A b \\ \mathbf{0}^T & 1 \end{bmatrix} \]",
    ],
)
def test_a_capital_beside_blocks_is_no_number(latex):
    given = r"\[ M = \begin{bmatrix} A & b \\ \mathbf{0}^T & 1 \end{bmatrix} \] "
    assert read_document(document_of(given + latex))[-1].verdict != "follows"


def test_entries_beside_the_letter_of_a_function_are_no_blocks():
    given = r"\[ f(p, q) = \begin{bmatrix} u \\ v \end{bmatrix} \] "
    latex = r"\[ \mathbf{w} = \begin{bmatrix} f & r \\ s & t \end{bmatrix} \mathbf{z} \]"
    kinds = Survey(document_of(given + latex), SymbolsFile()).kinds
    assert not kinds.open & {"r", "s", "t"}


CAMERA = (
    r"Let $R$ be a rotation matrix. The camera matrix is \[ P = K [R \mid t]. \] The centre is \[ C = -R^T t. \] "
    r"The point is \[ \mathbf{p} = \begin{bmatrix} \mathbf{x} \\ 1 \end{bmatrix}. \] Hence "
)


@pytest.mark.parametrize(
    ("claim", "follows"),
    [
        (r"P = K \left[ R | -R C \right]", True),
        (r"P = K R [I | -C]", True),
        (r"P \mathbf{p} = K (R \mathbf{x} + t)", True),
        (r"P \mathbf{p} = K R (\mathbf{x} - C)", True),
        (r"P = K [R | R C]", False),
        (r"P = R K [I | -C]", False),
        (r"P = K R [I | C]", False),
        (r"P \mathbf{p} = (R \mathbf{x} + t) K", False),
        (r"P \mathbf{p} = K (R^T \mathbf{x} + t)", False),
    ],
)
def test_two_blocks_beside_a_bar_are_a_row(claim, follows):
    found = read_document(document_of(rf"{CAMERA} \[ {claim}. \]"))[-1]
    assert (found.verdict == "follows") == follows


@pytest.mark.parametrize("letter", "EPHI")
def test_a_bar_behind_the_letter_of_a_probability_is_a_condition(letter):
    latex = (
        rf"\[ {letter}[X | Y] = a + b \] \[ {letter}[X | Y]^2 = (a + b)^2 \] \[ {letter}[X | Y] = {letter} [X | Y] \]"
    )
    first, second, _ = read_document(document_of(latex))
    assert (first.verdict, second.verdict) == ("definition", "follows")


@pytest.mark.parametrize(
    ("claim", "follows"),
    [
        (r"\begin{bmatrix} \mathbf{A} \\ \mathbf{B} \end{bmatrix} \mathbf{x} = \mathbf{u}", True),
        (r"\mathbf{x}^T \begin{bmatrix} \mathbf{A}^T & \mathbf{B}^T \end{bmatrix} = \mathbf{u}^T", True),
        (r"\begin{bmatrix} \mathbf{B} \\ \mathbf{A} \end{bmatrix} \mathbf{x} = \mathbf{u}", False),
        (r"\mathbf{x}^T \begin{bmatrix} \mathbf{A} & \mathbf{B} \end{bmatrix} = \mathbf{u}^T", False),
    ],
)
def test_a_column_of_blocks_times_a_vector_is_one(claim, follows):
    given = r"\[ \mathbf{u} = \begin{bmatrix} \mathbf{A} \mathbf{x} \\ \mathbf{B} \mathbf{x} \end{bmatrix} \] "
    found = read_document(document_of(rf"{given} Hence \[ {claim}. \]"))[-1]
    assert (found.verdict == "follows") == follows


@pytest.mark.parametrize("latex", ["[" * 1500 + "A | b" + "]" * 1500, "[A " * 1500 + "|" + "]" * 1500, "[" * 9000])
def test_brackets_without_end_are_looked_through_once(latex):
    pieces = pieces_of(latex)
    assert len(with_blocks(pieces)) == len(pieces)


def test_a_row_of_blocks_has_no_other_sign_for_a_bracket_at_the_end():
    text = r"[R | t] x \right"
    assert "".join(each.text for each in with_blocks(pieces_of(text))).endswith(r"\right")


_NORMAL = (
    r"\[ \begin{bmatrix} \mathbf{A} & \mathbf{B} \\ \mathbf{B}^T & \mathbf{0} \end{bmatrix} "
    r"\begin{bmatrix} \mathbf{x} \\ \mathbf{y} \end{bmatrix} = \begin{bmatrix} \mathbf{f} \\ \mathbf{g} "
    r"\end{bmatrix}. \] "
    "Hence "
)
_RULE = (
    r"\[ \begin{bmatrix} \mathbf{C} & \mathbf{D} \\ \mathbf{E} & \mathbf{F} \end{bmatrix} "
    r"\begin{bmatrix} \mathbf{g} \\ \mathbf{h} \end{bmatrix} + \begin{bmatrix} \mathbf{t} \\ \mathbf{v} "
    r"\end{bmatrix} "
    r"= \begin{bmatrix} \mathbf{0} \\ \mathbf{0} \end{bmatrix} \Rightarrow "
)


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (
            _NORMAL
            + r"\[ \mathbf{B}^T \mathbf{A}^{-1} \mathbf{B} \mathbf{y} = \mathbf{B}^T \mathbf{A}^{-1} \mathbf{f} "
            r"- \mathbf{g}. \]",
            True,
        ),
        (
            _NORMAL + r"\[ \mathbf{B}^T \mathbf{A}^{-1} \mathbf{B} \mathbf{y} = \mathbf{g} - \mathbf{B}^T "
            r"\mathbf{A}^{-1} \mathbf{f}. \]",
            False,
        ),
        (_NORMAL + r"\[ \mathbf{x} = \mathbf{A}^{-1} \mathbf{f}. \]", False),
        (_NORMAL + r"\[ \mathbf{y} = \mathbf{B}^{-1} (\mathbf{f} + \mathbf{A} \mathbf{x}). \]", False),
        (
            _RULE + r"(\mathbf{F} - \mathbf{E} \mathbf{C}^{-1} \mathbf{D}) \mathbf{h} + \mathbf{v} - \mathbf{E} "
            r"\mathbf{C}^{-1} \mathbf{t} = \mathbf{0}. \]",
            True,
        ),
        (
            _RULE + r"(\mathbf{F} - \mathbf{D} \mathbf{C}^{-1} \mathbf{E}) \mathbf{h} + \mathbf{v} - \mathbf{E} "
            r"\mathbf{C}^{-1} \mathbf{t} = \mathbf{0}. \]",
            False,
        ),
        (
            r"\[ \mathbf{q} = \mathbf{K} \mathbf{g}. \] This leads to \[ \mathbf{q} = \mathbf{C} \mathbf{D} "
            r"\mathbf{g}. \] "
            r"in which $\mathbf{K} = \mathbf{C} \mathbf{D}$.",
            True,
        ),
    ],
)
def test_an_equation_of_blocks_is_one_for_each_block(latex, follows):
    assert (read_document(document_of(latex))[-1].verdict == "follows") is follows
