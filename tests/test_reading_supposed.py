r"""What the sentence of an equation supposes, roots, numbers put in for letters, and letters given in a case."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

SUM = r"The sum is \[ s = a + b. \] "
OSCILLATES = r"The law is \[ m \ddot x = - k x. \] "
FALLS = r"The balance is \[ \frac12 m v^2 = m g h. \] "


def verdicts(latex):
    return [each.verdict for each in read_document(document_of(latex), seconds=5)]


@pytest.mark.parametrize(
    "latex",
    [
        SUM + r"Since $b = 0$, the sum is \[ s = a. \]",
        SUM + r"If $b = 0$, then \[ s = a. \]",
        SUM + r"For $b = a$ we have \[ s = 2 a. \]",
        SUM + r"With $a = c$ and $b = d$ this becomes \[ s = c + d. \]",
        SUM + r"Now $b = c d$, so the sum is \[ s = a + c d. \]",
        SUM + r"Thus it is, where $b = c^2$, \[ s = a + c^2. \]",
        SUM + r"Substituting $b = c - a$ gives \[ s = c. \]",
        SUM + r"We can define $b = c^2$ as the new width, then: \[ s = a + c^2. \]",
        r"\[ s = \sum_{i=1}^n (x_i - a) (y_i - b) \] Since $a = 0$, it is \[ s = \sum_{i=1}^n x_i (y_i - b). \]",
        r"The height is \[ h = v t - g t^2. \] At $t = 0$ it is \[ h = 0. \]",
        r"It is \[ \frac{u}{c^2} + \frac{v}{d^2} = 0. \] If we use a grid where $c = d = h$, then \[ u + v = 0. \]",
        r"It is \[ m \ddot x = - k x. \] Introducing the parameter $w = \sqrt{k/m}$, \[ \ddot x + w^2 x = 0. \]",
        r"It is \[ p = \frac{P(A, B)}{P(B > u)}. \] Since $P(B > u) = 1 - u$, we have \[ p = \frac{P(A, B)}{1-u}. \]",
        r"It is \[ p = \frac{P(A, B)}{P(B)}. \] Since $P(B) = 1 - u$, it becomes \[ p = \frac{P(A, B)}{1-u}. \]",
        OSCILLATES + r"Hence we have \[ \ddot x + w^2 x = 0, \] where $w = \sqrt{k/m}$.",
        OSCILLATES + r"Hence we have \[ \ddot x + w^2 x = 0 \] with $w^2 = k/m$ and $T = 2 \pi / w$.",
        r"It is \[ a n + b \sum_i x_i = \sum_i y_i. \] Hence \[ a = y - b x \] "
        r"where $x = \frac1n \sum_i x_i$ is the mean and $y = \frac1n \sum_i y_i$.",
        SUM + r"Thus it is \[ s = a + c^2 \] where $b = c^2$ is the width.",
        SUM + r"Thus it is \[ s = a \] where $b = 0$.",
    ],
)
def test_an_equation_follows_with_what_its_own_sentence_supposes(latex):
    assert verdicts(latex)[-1] == "follows"


@pytest.mark.parametrize(
    "sentence",
    [
        "While for $b = 0$ it is trivial, in general",
        "For $b=0$ it is the old one, whereas the sum is",
        "Unless $b = 0$, it is",
        "It is not true that $b = 0$, and yet",
        "Since it isn't so that $b = 0$, we get",
        "As never $b = 0$, the sum is",
        "As $b = 0$ holds on the left, for the right we have",
        "If $b = 0$, then at the bottom we have",
        "The first lens has $b = 0$, and the second gives",
        "A lens has $b = 0$, and a mirror gives",
        "If $b = 0$, it is trivial. The sum is",
        "For $b = 0$ it is trivial; the sum is",
        "Except for $b = 0$, the sum is",
        "Whether $b = 0$ or more, the sum is",
        "Instead of $b = 0$, we have now",
        "Even where $b = 0$ fails, we have",
        "That $b = 0$ is refuted, and thus",
        "Until $b = 0$ is reached, the sum is",
        "We begin with $b = 0$ and then let it grow:",
        "If the condition $b = 0$ is lifted, the sum is",
        "When $b = 0$ no longer holds, the sum is",
        "If we relax $b = 0$, we get",
        "If $b = 0$ is violated, we get",
        "For $b = 0$ we are done, so let $b > 0$: then",
        r"We have $b = 0$ for the ring and $b \neq 0$ for the disc, so",
        "We have $b = 0$ for a ring and $b = 1$ for a disc, so a disc has",
        "From $b = 0$ to $b = 1$ the sum is",
        "Near $b = 0$ the sum is",
        "If we expand around $b = 0$, the sum is",
        "He writes $b = 0$, and we get",
        "A guess is $b = 0$, and the truth is",
        "For a ring $b = 0$, for a disc",
        "Having done $b = 0$, we find",
        "Besides $b = 0$, we have",
        "With $b = 0$ at the top, the sum at the bottom is",
        "Since $b^2 = 0$ is what he supposed, she has",
    ],
)
def test_a_sentence_that_speaks_of_another_case_supposes_nothing(sentence):
    assert verdicts(SUM + sentence + r" \[ s = a. \]")[-1] != "follows"


@pytest.mark.parametrize(
    "behind",
    [
        " where $b = 0$ at the top.",
        " where not $b = 0$ holds.",
        " where $b = 0$ is not true.",
        ". Where $b = 0$ we stop.",
        " everywhere. With $b = 0$, it is trivial.",
        " where, but for $b = 0$, it grows.",
        " unless $b = 0$.",
        " where $c$ is the width.\n\nFor a ring, where $b = 0$, it is another one.",
        " whereas $b = 0$ for a ring.",
        " where $a$ is the width, and later $b = 0$.",
        " where $a$ is the width and for a ring $b = 0$.",
        r" \section{Rings} where $b = 0$.",
        " where $b = 0$ if $c > 0$.",
    ],
)
def test_words_behind_an_equation_that_speak_of_another_case_suppose_nothing(behind):
    assert verdicts(SUM + r"Thus it is \[ s = a \]" + behind)[-1] != "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"The place is \[ y = x^2. \] As $x = 1$, its slope is \[ \frac{dy}{dx} = 0. \]",
        r"The integral is \[ F = \int_0^1 x \, dx. \] With $x = 0$ it is \[ F = \int_0^1 0 \, dx. \]",
        r"The sum is \[ F = \sum_{i=1}^n i. \] With $i = 1$ it is \[ F = \sum_{i=1}^n 1. \]",
        r"The law is \[ b x = b y. \] If $b = 0$, then \[ x = y. \]",
        r"The law is \[ (a - b) x = (a - b) y. \] If $a = b$, then \[ x = y. \]",
        r"The law is \[ b x = b y. \] Hence, since $b = 0$, we get \[ x = y. \]",
        r"The law is \[ f(x) = a x^2. \] With $x = 1$ we have \[ f'(x) = 0. \]",
        r"Since $a \equiv b \pmod 5$, we get \[ a = b. \]",
        SUM + r"Since $b \equiv 0$ modulo five, we get \[ s = a. \]",
        SUM + r"If $b = 0$, then \[ s = a. \] \section{Other} The sum is \[ 2 s = 2 a. \]",
    ],
)
def test_what_a_sentence_supposes_goes_into_no_derivative_integral_or_other_section(latex):
    assert verdicts(latex)[-1] != "follows"


def test_a_root_follows_from_its_square_where_both_have_one_sign():
    *_, root = read_document(document_of(FALLS + r"Hence the speed is \[ v = \sqrt{2 g h}. \]"), seconds=5)
    assert root.verdict == "follows"
    assert root.links[0].reason == "read as v = sqrt(2*g*h), as v**2 = sqrt(2*g*h)**2"
    assert "v >= 0" in root.links[0].hypotheses


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (r"It is \[ T^2 = \frac{c^2 l}{g}. \] Hence the period is \[ T = c \sqrt{\frac{l}{g}}. \]", True),
        (r"The root is \[ x^2 + b = 0. \] Hence \[ x = \pm \sqrt{-b}. \]", True),
        (r"The root is \[ x^2 = b. \] Hence \[ x = \pm 2\sqrt{b}. \]", False),
        (FALLS + r"Hence \[ v = \sqrt{2 g h}. \]", True),
        (FALLS + r"Let $v = -u^2 - 1$. Hence \[ v = \sqrt{2 g h}. \]", False),
        (r"It is \[ x = -3. \] Hence \[ x = \sqrt{9}. \]", False),
        (r"It is \[ x = -a^2 - 1. \] Hence \[ x = \sqrt{(a^2 + 1)^2}. \]", False),
        (FALLS + r"The negative root is \[ v = \sqrt{2 g h}. \]", False),
        (FALLS + r"Hence the speed is \[ v = \sqrt{g h}. \]", False),
        (FALLS + r"Hence \[ v = -\sqrt{2 g h}. \]", False),
        (r"It is \[ x^2 = 4 b. \] Hence \[ x = 2 + \sqrt{4 b}. \]", False),
        (r"The volume is \[ v^3 = c. \] Hence \[ v = \sqrt{c}. \]", False),
        (r"The velocity is $\mathbf{v}$. \[ \mathbf{v}^2 = 2 g. \] Hence \[ \mathbf{v} = \sqrt{2 g}. \]", False),
        (r"If it falls, \[ v^2 = 2 g h. \] If it rests, \[ v = \sqrt{2 g h}. \]", False),
        (r"\section{A} If it falls, \[ v^2 = 2 g h. \] \section{B} The wave has \[ v = \sqrt{2 g h}. \]", False),
        (r"The law is \[ p = r T \rightarrow p v = r T v. \]", True),
        (r"The law is \[ p = r T \rightarrow p v = r T. \]", False),
        (r"It jumps as \[ n = 2 \rightarrow n = 1. \]", False),
        (r"The map is \[ f : x = a \rightarrow y = x. \]", False),
        (r"The small wave has \[ d = \frac{a b}{c}. \label{a} \] It has \[ m d = \frac{p m}{a c}. \label{b} \] "
         r"By \eqref{a} and \eqref{b} \[ \frac{p}{a} = a b. \]", True),
        (r"If it rains, \[ d = a. \label{a} \] If not, \[ d = b. \label{b} \] "
         r"By \eqref{a} and \eqref{b} \[ a = b. \]", False),
        (r"It is \[ F = m a = 2 \cdot 3. \] Hence \[ m^2 = 4. \]", False),
        (r"The sum is \[ w_t = a. \] Its power is \[ w_t^n = a n. \]", False),
        (SUM + r"For the special case of a mirror, \[ b = c. \] \section{Other} The sum is \[ s = a + c. \]", False),
    ],
)  # fmt: skip
def test_roots_arrows_and_cited_cases(latex, follows):
    assert (verdicts(latex)[-1] == "follows") is follows


@pytest.mark.parametrize(
    "latex",
    [
        r"The force is \[ F = m a = 2 \cdot 3 = 6. \]",
        r"The line is \[ y = 41 + 0.59 x = 41 + 0.59 \times 85 = 91.15. \]",
        r"The sum is \[ y = a + b = (-3) + 4 = 1. \]",
        r"The force is \[ F = m a. \] \section{Example} For a stone, we have \[ F = 2 \cdot 3 = 6. \]",
        r"The speed is \[ v = \sqrt{2 g h}. \] With numbers, it is \[ v = \sqrt{2 \cdot 9.81 \cdot 3}. \]",
        r"The weights are $w_t$ and $w_t^n$. \[ w_t^n = a b_t^n. \]",
        r"The weights are $w_t$ and $w_t^{n+1}$. \[ w_t^{n+1} = a b_t^n. \]",
        r"We have \[ f(x) > 0. \] The fit is a line. In this case, \[ f(x) = a + b x. \]",
        r"We have \[ f(x) > 0. \] For the special case of a line, \[ f(x) = a + b x. \]",
        SUM + r"The sum in water is modeled as \[ s = c d. \]",
        r"\[ \mbox{first incident power on wall} = P r \]",
        r"\[ \Delta e^- = \frac{a-b}{c}, \quad \Delta e^+ = \frac{b - c}{c}. \]",
    ],
)
def test_an_equation_gives_its_letter_or_numbers_in_a_case(latex):
    assert verdicts(latex)[-1] == "definition"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ m = 5. \] \[ a = 3. \] The force is \[ F = m a = 2 \cdot 3. \]",
        r"The force is \[ F = m m = 2 \cdot 3. \]",
        r"The force is \[ F = m a = 2 + 3. \]",
        r"The force is \[ F = m a. \] For a stone, we have \[ F = 2 + 3. \]",
        r"\[ m = 5. \] The force is \[ F = m a. \] For a stone, we have \[ F = 2 \cdot 3. \]",
        r"The balance is \[ m a = 2 \cdot 3. \]",
        r"The sum is \[ F = a + b. \] It is \[ c = d = F = 0. \]",
        r"The force is \[ F = m a = 2 \cdot 3 = 7. \]",
        SUM + r"Hence the sum is \[ s = c d. \]",
    ],
)
def test_other_numbers_are_none_that_an_equation_gives(latex):
    assert verdicts(latex)[-1] not in ("definition", "follows")


def test_a_space_behind_a_line_break_begins_no_formula():
    assert [each.latex for each in document_of(r"Text\\[1em] and \[ a = b \] more\\[-2pt]").formulas] == [" a = b "]


def test_a_column_beside_a_letter_like_the_identity_is_read():
    assert verdicts(r"\[ I + \begin{bmatrix} y \\ u \end{bmatrix} = \begin{bmatrix} C x \\ u \end{bmatrix} \]")


def test_an_empty_cell_beside_a_vector_ends_no_reading():
    latex = r"\[ \text{diag}(\mathbf{x}) = \begin{bmatrix} x_1 & 0 \\ & x_2 \end{bmatrix} \]"
    assert verdicts(latex)[0] != "contradicts"


FACTORED = r"\[ \mathbf{x} = \mathbf{K}^{-1} \mathbf{b} \] "
HALVES = r" \[ \mathbf{b}^T \mathbf{x} = \mathbf{b}^T \mathbf{L}^{-T} \mathbf{L}^{-1} \mathbf{b} \]"


def test_what_the_text_says_of_a_new_matrix_holds_further_on():
    latex = FACTORED + r"where $\mathbf{L} \mathbf{L}^T = \mathbf{K}$. \[ c = d \] Hence" + HALVES
    assert verdicts(latex)[-1] == "follows"


@pytest.mark.parametrize(
    "words",
    [
        r"We ask where $\mathbf{L} \mathbf{L}^T = \mathbf{K}$ may hold. Then",
        r"Let $\mathbf{L} \mathbf{L}^T = \mathbf{K}$ if possible. In general",
        r"If it is large, let $\mathbf{L} \mathbf{L}^T = \mathbf{K}$. Then",
        r"One may not put $\mathbf{L} \mathbf{L}^T = \mathbf{K}$. Then",
        r"\[ \mathbf{L} = \mathbf{M} \mathbf{N} \] where $\mathbf{L} \mathbf{L}^T = \mathbf{K}$, or not. Then",
    ],
)
def test_it_does_not_where_words_follow_or_the_matrix_is_known(words):
    assert verdicts(FACTORED + words + HALVES)[-1] != "follows"


@pytest.mark.parametrize(
    ("behind", "follows"),
    [
        (r"in which $Q = B + C$ and $s = d$ is the load. Hence \[ y = \frac{d}{B + C}. \]", True),
        (r"in which $Q = B + C$ and $s = d$ is the load. Hence \[ y = \frac{d}{B - C}. \]", False),
        (r"Where $Q = 1$ is not assumed, more is said below. Hence \[ y = s. \]", False),
        (r"Now let $Q = 1$. Hence \[ y = s. \]", False),
    ],
)
def test_what_a_sentence_goes_on_to_say_of_letters_was_so_before(behind, follows):
    latex = rf"For the beam we have \[ Q y = s. \] {behind}"
    assert (read_document(document_of(latex))[-1].verdict == "follows") is follows


@pytest.mark.parametrize(
    ("words", "follows"),
    [("these are equivalent to those above.", True), ("these are worse than those above.", False)],
)
def test_letters_of_equations_that_are_called_the_same_are_put_in(words, follows):
    latex = (
        r"The rate is \[ c = \frac{1 - a}{b}. \] That leads to the alternate expression \[ c = f + g \] "
        rf"With $f = \frac{{1}}{{b}}$ and $g = -\frac{{a}}{{b}},$ {words}"
    )
    assert (read_document(document_of(latex))[-1].verdict == "follows") is follows
