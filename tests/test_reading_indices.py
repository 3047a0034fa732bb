r"""Equations at another index: what follows from them, and what only looks so."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

FOLLOWS = {
    "two steps of a recurrence": (
        r"The recurrence is \[ x_{k+1} = a x_k + b \] so \[ x_{k+2} = a^2 x_k + a b + b \] and \[ x_1 = a "
        r"x_0 + b \] \[ x_2 = a^2 x_0 + a b + b \]"
    ),
    "neighbours of a point": (
        r"Laplace's equation gives \[ u_{i+1,j} + u_{i,j+1} + u_{i-1,j} + u_{i,j-1} - 4 u_{i,j} = 0 \] We "
        r"can write \[ u_{2,1} + u_{1,2} + u_{0,1} + u_{1,0} - 4u_{1,1} = 0 \]"
    ),
    "second differences": (r"We have \[ y_{n+1} - 2 y_n + y_{n-1} = c \] It follows that \[ y_3 - 2 y_2 + y_1 = c \]"),
    "indices of a grid": (
        r"To do this mapping \[ k_{i,j} = j n + i \] we have \[ k_{i-1,j} = j n + i - 1 \] \[ k_{i,j+1} = "
        r"(j+1) n + i \] and for the center \[ k_{1,1} = 1 \cdot n + 1 \]"
    ),
    "prices at the end": (
        r"The price is \[ p_t = d_t + \delta p_{t+1} \] so that \[ p_0 = d_0 + \delta p_1 \] \[ p_{T-1} = "
        r"d_{T-1} + \delta p_T \]"
    ),
    "powers with a step above them": (
        r"The power is \[ P_s^{(k)} = a_s r P_w^{(k-1)} \] \[ P_w^{(k)} = a_w r P_w^{(k-1)} + c P_s^{(k-1)} "
        r"\] Therefore \[ P_w^{(k)} = a_w r P_w^{(k-1)} + c a_s r P_w^{(k-2)} \]"
    ),
    "letters with two indices": (
        r"We measure \[ y_i = \theta(s_i) + e_i \] We have \[ y_i - y_j = \theta(s_i) - \theta(s_j) + e_i - e_j \]"
    ),
    "indices that differ": (
        r"We measure \[ y_i = \theta(s_i) + e_i \] For $i \neq j$ we have "
        r"\[ y_i - y_j = \theta(s_i) - \theta(s_j) + e_i - e_j \]"
    ),
    "a sum over the index": (
        r"We have the sum $d = \sum_i d_i$ and \[ y_i = a d_i \] Hence \[ y_1 - y_2 = a (d_1 - d_2) \]"
    ),
}
MISLEADING = {
    "a wrong sign with two indices": (
        r"We measure \[ y_i = \theta(s_i) + e_i \] We have \[ y_i - y_j = \theta(s_i) - \theta(s_j) + e_i + e_j \]"
    ),
    "the input and the junction": (
        r"The input voltage is \[ v_i = r_i c \] The junction has the values $v_j$ and $r_j$. Hence \[ v_j = r_j c \]"
    ),
    "one letter with two indices alone": (
        r"The outer pressure is \[ p_k = a b \] The inner one is $p_i$. Hence \[ p_i = a b \]"
    ),
    "an index that is a number": r"We have \[ a_i = i b_i \] and there is $a_j$. Hence \[ a_j = i b_j \]",
    "a function that is drawn": (
        r"We measure \[ y_i = \theta(s_i) + e_i \] where $\theta$ is drawn anew for each $i$. "
        r"We have \[ y_i - y_j = \theta(s_i) - \theta(s_j) + e_i - e_j \]"
    ),
    "a range that begins later": (
        r"The gains are \[ x_k = a_k b \] for $k = 1, 2, \dots, n$. The start is a reference. Then \[ x_0 = "
        r"a_0 b \]"
    ),
    "entries off the diagonal": (
        r"The off-diagonal entries are \[ a_{ij} = m_i m_j \] with $i = 1, \dots, n$ and $j = 1, \dots, n$. "
        r"Then \[ a_{11} = m_1 m_1 \]"
    ),
    "labels that are no indices": (
        r"For the weight we have \[ F_g = m_g g \] and for the spring \[ F_s = m_s s \] so the sum is \[ F_k "
        r"= m_k k \] with $k = 1, 2, \dots$ as a number."
    ),
    "two indices that differ": (
        r"The entries are \[ a_{ij} = m_i m_j, \quad i \neq j \] where $i, j = 1, \dots, n$, so with "
        r"$\sum_{i=1}^n a_{ij} = 1$ we find \[ a_{11} = m_1 m_1 \]"
    ),
    "noise": (
        r"The random walk is \[ x_{k+1} = a x_k + w \] where $w$ is noise. Then \[ x_{k+2} = a^2 x_k + a w + "
        r"w \]"
    ),
    "a factor with the index": (
        r"The recurrence is \[ x_{k+1} = a x_k \] The factor is \[ a = c k \] Then \[ x_{k+2} = a^2 x_k \]"
    ),
    "a factor that depends on it by words": (
        r"The recurrence is \[ x_{k+1} = a x_k \] where $a$ depends on $k$. Then \[ x_{k+2} = a^2 x_k \]"
    ),
    "another section": (
        r"Newton's iteration is \[ x_{k+1} = x_k - h f_k \] \section{Gradient} The gradient method uses another "
        r"iterate, and therefore \[ x_{k+2} = x_{k+1} - h f_{k+1} \]"
    ),
    "a negative index": r"For $n \ge 2$ we have \[ F_n = F_{n-1} + F_{n-2} \] Then \[ F_1 = F_0 + F_{-1} \]",
    "a strict lower bound": r"For $n > 2$ we have \[ T_n = 2 T_{n-1} \] Then \[ T_2 = 2 T_1 \]",
    "interior points": (
        r"At the interior points \[ u_{i+1} - 2 u_i + u_{i-1} = 0 \] with $i = 0, 1, \dots, n$. Hence \[ u_2 "
        r"- 2 u_1 + u_0 = 0 \]"
    ),
    "a sum up to the index": (
        r"The partial sums are \[ s_n = \sum_{k=1}^n a_k \] Then \[ s_{n+1} = \sum_{k=1}^{n} a_{k+1} \]"
    ),
    "every second step": (
        r"Every second step \[ x_{k+1} = x_k + h \] The other steps do nothing, so \[ x_{k+2} = x_k + 2h \]"
    ),
    "the last step": (
        r"The steps are \[ x_{k+1} = x_k + h \] The last step is cut. Thus $k = 0, 1, \dots, 9$ and \[ "
        r"x_{11} = x_{10} + h \]"
    ),
    "a label of an input": (
        r"The voltage at the input is \[ V_i = R I_i \] and at node $1$, where $\sum_{i=1}^n I_i = 0$, it "
        r"differs: \[ V_1 = R I_1 \]"
    ),
    "a mean": r"The mean is \[ y_m = a x_m \] The sum over all is $\sum_{m=1}^M x_m = 0$ and \[ y_n = a x_n \]",
    "an index within an integral": (
        r"Let \[ a_k = \int_0^1 x^k dx \] with $\sum_{k=0}^N a_k = 1$. Then \[ a_2 = \int_0^1 x^k dx \]"
    ),
    "another model": r"In model A \[ x_{k+1} = a x_k \] In model B \[ x_{k+2} = a x_{k+1} \]",
    "even numbers only": r"For even $k$ \[ x_{k+1} = a x_k \] Then \[ x_{k+2} = a x_{k+1} \]",
    "what does not hold at the start": (
        r"The rule is \[ x_{k+1} = a x_k \] It does not hold at the start. There \[ x_1 = a x_0 \]"
    ),
    "an index that stands there twice": (
        r"We define \[ c_{i} = b_i + b_j \] with $\sum_i \sum_j c_i = 1$. Then \[ c_{j} = b_j + b_j \]"
    ),
    "a power that is another one": (
        r"The polynomials are \[ p_n = x^n \] with $\sum_{n=0}^N p_n = y$. Then \[ p_2 = x \cdot 2 \]"
    ),
    "where it has no value": (
        r"It holds \[ b_k = \frac{1}{k - 1} \] with $\sum_{k=2}^n b_k = s$. Then \[ b_1 = \frac{1}{1 - 1} \]"
    ),
}


@pytest.mark.parametrize("name", FOLLOWS)
def test_an_equation_holds_at_another_index(name):
    last = read_document(document_of(FOLLOWS[name]))[-1]
    assert (last.read is not None, last.verdict) == (True, "follows")


@pytest.mark.parametrize("name", MISLEADING)
def test_an_equation_does_not_hold_at_every_index(name):
    last = read_document(document_of(MISLEADING[name]))[-1]
    assert last.read is not None
    assert last.verdict in ("independent", "not decided", "definition")
