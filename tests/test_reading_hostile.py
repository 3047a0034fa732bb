r"""Documents that ask to be misread: the last equation of each does not follow from what stands above it.

A letter, a sign or a superscript means something else than it looks like, words take an equation back, or it stands in
a comment, a quotation or a list of cases.
"""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")

DOCUMENTS = {
    "degrees": (
        r"The signal is \[ y = \sin\theta, \] where $\theta$ is in degrees. Its slope is \[ "
        r"\frac{dy}{d\theta} = \cos\theta. \]",
        True,
    ),
    "logarithm to base ten": (
        r"The level is \[ L = 10 \log P, \] where the logarithm is to base ten. Hence \[ \frac{dL}{dP} = "
        r"\frac{10}{P}. \]",
        True,
    ),
    "iterates as superscripts": (
        r"The iterates carry their number as a superscript. \[ x^1 = b \] The next one is \[ x^2 - b^2 = 0. \]",
        True,
    ),
    "the first iterate": (
        r"The number of the iterate is written as a superscript. We start from \[ x^0 - 1 = 0. "
        r"\]",
        True,
    ),
    "satellites as superscripts": (
        r"Let $\rho^s$ be the range to satellite $s$. The first two are \[ \rho^1 = c t \] and \[ \rho^2 "
        r"= c^2 t^2. \]",
        True,
    ),
    "frames as exponents": (
        r"Let $x^a$ and $x^b$ be the abscissas in the images $a$ and $b$. The entry is \[ w = x^a x^b. "
        r"\] Thus \[ w = x^{a+b}. \]",
        True,
    ),
    "from frame to frame": (
        r"Let $T_1^2$ be the motion from frame 1 to frame 2, \[ T_1^2 = a b. \] From frame 1 to frame 4 "
        r"it is \[ T_1^4 = a^2 b^2. \]",
        True,
    ),
    "the eccentricity": (
        r"Let $e$ be the eccentricity. \[ y = e^x \] Its derivative is \[ \frac{dy}{dx} = e^x. \]",
        True,
    ),
    "the index i": (r"The index $i$ runs over the images. The weight is \[ w = i^2. \] Hence \[ w = -1. \]", True),
    "the weight pi": (r"Let $\pi$ be the weight of the first component. \[ w = \cos\pi \] Hence \[ w = -1. \]", True),
    "the exponent T": (r"Interest is paid for $T$ years. The capital is \[ y = x^T. \] Hence \[ y = x. \]", True),
    "half the baseline": (
        r"The depth is \[ Z = \frac{b f}{p}. \] From here on $b$ is half the baseline. Thus \[ p Z = b f. \]",
        True,
    ),
    "a determinant in bars": (
        r"Let $A$ be a $3\times3$ matrix, and $|A|$ its determinant. \[ d = |2A| \] Hence \[ d = 2|A|. \]",
        True,
    ),
    "a count in bars": (
        r"Let $\|x\|_0$ be the number of entries of $x$ that are not zero. \[ n = \|2x\|_0 \] Hence \[ n "
        r"= 2\|x\|_0. \]",
        True,
    ),
    "equal up to a factor": (
        r"Here $=$ means equality up to a factor. \[ x = K X \] and also \[ x = 2 K X. \] Hence \[ K X = 0. \]",
        True,
    ),
    "modulo four": (r"All computations are modulo 4. \[ 2x = 2y \] Hence \[ x = y. \]", True),
    "division of integers": (
        r"Here $/$ is the division of integers, without the remainder. \[ q = n/2 \] Hence \[ 2q = n. \]",
        True,
    ),
    "logical or": (r"Here $+$ is the logical or. \[ z = x + x \] Hence \[ z = 2x. \]", True),
    "max-plus": (
        r"In the max-plus algebra the sum of two numbers is the larger one. \[ y = a + a \] Hence \[ y = 2a. \]",
        True,
    ),
    "Minkowski sum": (
        r"Let $A$ and $B$ be sets, and $A + B$ their Minkowski sum. \[ C = A + B \] Hence \[ A = C - B. \]",
        True,
    ),
    "composition": (r"The product of two maps is their composition. \[ h = f g \] Hence \[ h = g f. \]", True),
    "the nearest integer": (
        r"The ambiguity is fixed to \[ N = [a], \] where $[a]$ is the nearest integer. Hence \[ N - a = 0. \]",
        True,
    ),
    "the fractional part": (
        r"Let $\{x\}$ be the fractional part of $x$. \[ u = \{x + 1\} \] Hence \[ u = \{x\} + 1. \]",
        True,
    ),
    "the positive part": (r"With the positive part we get \[ y = (a)_+ + (-a)_+. \] Hence \[ y = 0. \]", True),
    "an activation": (
        r"The neuron gives \[ y = \sigma(w x + b), \] where $\sigma$ is the activation. Hence \[ y = "
        r"\sigma w x + \sigma b. \]",
        True,
    ),
    "a signal": (r"We take the sample \[ u = s(t + h) \] of the signal $s$. Hence \[ u = s t + s h. \]", True),
    "a kernel": (r"\[ k = \phi(x - c) \] Here $\phi$ is a radial basis function. \[ k = \phi x - \phi c \]", True),
    "the operator D": (r"Let $D$ be the derivative. \[ y = D x^2 \] Hence \[ y = x D x. \]", True),
    "a functional derivative": (r"The gradient is \[ g = \frac{\delta S}{\delta q}. \] Hence \[ g q = S. \]", True),
    "a delta for the partial derivative": (
        "The Jacobian is\n\n$$ H = \\frac{\\delta h}{\\delta x} $$\n\nThus\n\n$$ H x = h $$\n",
        False,
    ),
    "a bare sine": ("The step is\n\n$$ y = sin(a + b) - sin(a) $$\n\nand therefore\n\n$$ y = sin(b) $$\n", False),
    "a bare sine of twice": (r"\[ y = sin(2x) \] Hence \[ y = 2 sin(x). \]", True),
    "a bare exponential": (r"\[ p = exp(a + b) \] Hence \[ p = exp(a) + exp(b). \]", True),
    "a sine in a text": (r"\[ y = \text{sin}(2x) \] Hence \[ y = 2\,\text{sin}(x). \]", True),
    "an exponential in a text": (r"The density is \[ p = c\,\text{exp}\{-x^2\}. \] Hence \[ p = c. \]", True),
    "a determinant in a text": (r"\[ c = \text{det}(2A) \] Hence \[ c = 2\,\text{det}(A). \]", True),
    "rank": (r"\[ r = \operatorname{rank}(2A) \] Hence \[ r = 2\operatorname{rank}(A). \]", True),
    "the inverse map": (r"Let $f^{-1}$ be the inverse map. \[ y = f^{-1} \] Hence \[ y f = 1. \]", True),
    "atan2": (r"\[ \phi = \operatorname{atan2}(y, x) \] Hence \[ \phi = \arctan\frac{y}{x}. \]", True),
    "a held pressure": (
        r"\[ U = a T + b V \] At constant pressure \[ \left(\frac{\partial U}{\partial T}\right)_p = a. \]",
        True,
    ),
    "jerk": ("The required jerk is\n\n$$ jerk = j $$\n\nThus\n\n$$ e r k = 1 $$\n", False),
    "giga and mega": (r"\[ E = 2\text{ GPa}, \quad p = 2\text{ MPa}. \] Hence \[ E = p. \]", True),
    "kilometres": (r"\[ a = 5\,\mathrm{km} \] \[ b = 5\,\mathrm{m} \] Hence \[ a - b = 0. \]", True),
    "decibels": (r"The gain is \[ G = 3\text{ dB}. \] Hence the output is \[ y = G x = 3 x. \]", True),
    "a right angle": (r"\[ \alpha = 90^\circ \] Hence \[ 2\alpha = 180. \]", True),
    "constants in a text": (
        r"\[ u = f + \text{const} \] \[ v = g + \text{const} \] Hence \[ u - v = f - g. "
        r"\]",
        True,
    ),
    "noise in a text": (r"\[ x = a + \text{noise} \] \[ y = b + \text{noise} \] Hence \[ x - y = a - b. \]", True),
    "noise as letters": ("$$ x = a + noise $$\n\n$$ y = b + noise $$\n\nHence\n\n$$ x - y = a - b $$\n", False),
    "higher terms": (
        r"\[ u = a x + \text{h.o.t.} \] \[ v = b x + \text{h.o.t.} \] Hence \[ u - v = (a - b) x. \]",
        True,
    ),
    "the order of the error": (r"\[ u = a + O(h) \] \[ v = b + O(h) \] Hence \[ u - v = a - b. \]", True),
    "the order of the error, curly": (
        r"\[ u = a + \mathcal{O}(h^2) \] \[ v = b + \mathcal{O}(h^2) \] Hence \[ u - v = a - b. \]",
        True,
    ),
    "entries that do not matter": (
        r"\[ A = \begin{pmatrix} 1 & * \\ 0 & 1 \end{pmatrix}, \quad B = \begin{pmatrix} 1 & * \\ 0 & 1 "
        r"\end{pmatrix}. \] Hence \[ A = B. \]",
        True,
    ),
    "plus or minus twice": (r"\[ x = a \pm b \] \[ y = a \pm b \] Hence \[ x = y. \]", True),
    "two constants of integration": (
        r"\[ u = x + C \] \[ v = y + C \] Here $C$ is any constant, each time another one. \[ u - v = x - y \]",
        True,
    ),
    "or": (r"The roots are \[ x = a \quad\text{or}\quad x = b. \] Hence \[ 2x = 2a. \]", True),
    "or in a box": (r"The roots are \[ x = a \mbox{ or } x = -a. \] Hence \[ x - a = 0. \]", True),
    "an update": ("Each step of the descent is\n\n$$ x = x - \\alpha g $$\n\nHence\n\n$$ \\alpha g = 0 $$\n", False),
    "a counter": (r"In the loop we set \[ n = n + k. \] Hence \[ k = 0. \]", True),
    "a skip between lines": (r"\begin{align} a &= b \\[1ex] s &= 2a \end{align} Hence \[ e x s = 2a. \]", True),
    "an exponential behind a determinant": (
        r"\[ p = \text{det}(S)^2 \text{exp}\{-q\}. \] Hence \[ 2p = 2\det(S)^2. \]",
        True,
    ),
    "a slash": (r"\[ y = a/2b \] Hence \[ y = \frac{a b}{2}. \]", True),
    "the scope of a sum": (r"\[ S = \sum_{i=1}^n x_i + c \] Hence \[ S = \sum_{i=1}^n (x_i + c). \]", True),
    "a sine without brackets": (r"\[ u = \sin x y \] Hence \[ u = y \sin x. \]", True),
    "a squared fraction": (r"\[ y = \frac{a}{j}^2 \] Hence \[ y = \frac{a}{j^2}. \]", True),
    "a shifted sum": (r"\[ S = \sum_{i=1}^n x_{i+1} \] Hence \[ S = \sum_{i=2}^n x_i. \]", True),
    "pairs": (r"Let $a_{ij} = a_{ji}$. \[ S = \sum_{i<j} a_{ij} \] Hence \[ S = \frac12 \sum_{i,j} a_{ij}. \]", True),
    "the trace of delta": (r"Repeated indices are summed. \[ t = \delta_{ii} \] Hence \[ t = 1. \]", True),
    "division under a silent sum": (
        r"Repeated indices are summed. \[ y_i = a_{ij} x_j \] Hence \[ a_{ij} = \frac{y_i}{x_j}. \]",
        True,
    ),
    "a trace under the summation convention": (
        r"We use the summation convention. \[ s = a_{ii} b \] Let \[ a_{ij} = c_i d_j. \] Hence \[ s = c_1 d_1 b. \]",
        True,
    ),
    "a bracket under the summation convention": (
        r"We use the summation convention. \[ s = a_i (b_i + c) \] Hence \[ \frac{s}{a_i} = b_i + c. \]",
        True,
    ),
    "a root under the summation convention": (
        r"We use the summation convention. \[ s = a_i^2 \] Hence \[ s - a_1^2 = a_i^2 - a_1^2. \]",
        True,
    ),
    "a square under a silent sum": (
        r"Repeated indices are summed. \[ s = a_i b_i \] Hence \[ s^2 = a_i a_i b_i b_i. \]",
        True,
    ),
    "a derivative by each letter of a sum": (
        r"\[ S = \sum_{i=1}^n x_i^2 \] Hence \[ \frac{\partial S}{\partial x_i} = 2 \sum_{i=1}^n x_i. \]",
        True,
    ),
    "a quadratic form": (
        r"\[ f = \mathbf{x}^T \mathbf{A} \mathbf{x} \] Hence \[ \frac{\partial f}{\partial \mathbf{x}} = "
        r"2 \mathbf{A} \mathbf{x}. \]",
        True,
    ),
    "a letter that depends": (r"\[ z = x y, \] where $y$ is a function of $x$. Hence \[ \frac{dz}{dx} = y. \]", True),
    "cancelled cross product": (
        r"\[ \mathbf{a} \times \mathbf{b} = \mathbf{a} \times \mathbf{c} \] Hence \[ \mathbf{b} = \mathbf{c}. \]",
        True,
    ),
    "a projector": (r"Let $P$ be a projector. \[ P^2 = P \] Hence \[ P = 1. \]", True),
    "a radius on the axis": (r"\[ r = \sqrt{x^2 + y^2} \] On the axis $y = 0$. Hence \[ r = x. \]", True),
    "real parts": (r"\[ a = \mathrm{Re}(z w) \] Hence \[ a = \mathrm{Re}(z)\,\mathrm{Re}(w). \]", True),
    "arguments": (r"\[ \phi = \arg(z w) \] Hence \[ \phi = \arg z + \arg w. \]", True),
    "a full turn": (r"\[ u = e^{2\pi i x} \] Hence \[ u = 1. \]", True),
    "excluded": (r"\[ s = a + b \] The case $b = 0$ is excluded. Hence \[ s = a. \]", True),
    "the null hypothesis": (r"\[ s = a + b \] The null hypothesis is $b = 0$. Hence \[ s = a. \]", True),
    "whether or not": (r"\[ s = a + b \] It does not matter whether $b = 0$ or not. Hence \[ s = a. \]", True),
    "instead of": (r"\[ s = a + b \] We take a small $b$ instead of $b = 0$. Hence \[ s = a. \]", True),
    "the default": (r"\[ s = a + b \] The default is $b = 0$. With the option \texttt{-v} we get \[ s = a. \]", True),
    "even": (r"\[ s = a + b \] Even $b = 0$ is allowed. Hence \[ s = a. \]", True),
    "either": (r"\[ s = a + b \] Either $b = 0$ or $a = 0$. Hence \[ s = a. \]", True),
    "the set of points": (r"\[ s = a + b \] The points with $b = 0$ form a line. Elsewhere, too, \[ s = a. \]", True),
    "lines": (r"\[ s = a + b \] Lines with $b = 0$ are vertical. Our line has \[ s = a. \]", True),
    "close to": (r"\[ F = m g \] The value is close to $g = 10$. Hence \[ F = 10 m. \]", True),
    "unless": (
        r"Unless the shutter is global, \[ t = t_0 + k r. \] With a global shutter \[ t - t_0 = k r. "
        r"\]",
        True,
    ),
    "would": (r"\[ x = y \] would hold only if the camera did not move. Here it moves: \[ 2x = 2y. \]", True),
    "refuted": (r"The claim of Smith, \[ s = a + b, \] has been refuted. Thus \[ s - a = b. \]", True),
    "tempted": (r"One is tempted to write \[ s = a + b. \] Thus \[ s - a = b. \]", True),
    "for contradiction": (
        r"Suppose, for contradiction, that \[ p = 2 q. \] This is absurd. Hence \[ p - q = q. \]",
        True,
    ),
    "an erratum": (
        r"\begin{equation} s = a + b \end{equation} Erratum: in (1), read $-b$ for $b$. \[ s - a = b \]",
        True,
    ),
    "an earlier version": (
        r"An earlier version of this text had \[ k = a - b. \] This was a slip. \[ k + b = a \]",
        True,
    ),
    "neither": (r"Neither \[ s = a + b \] nor \[ s = a - b \] is right. \[ s - a = b \]", True),
    "a cited sign": (r"In the convention of Wolf, \[ c = -f. \] Ours has the opposite sign. \[ c + f = 0 \]", True),
    "an axis turned round": (
        r"In the old system, where $z$ points down, \[ z = -h. \] In the new one $z$ points up. \[ z + h = 0 \]",
        True,
    ),
    "small angles": (
        r"For small angles $\sin\theta = \theta$. \[ y = l \sin\theta \] For any angle \[ y = l\theta. \]",
        True,
    ),
    "first order within the text": (
        r"\[ y = (1 + x)^3 \] To first order $y = 1 + 3x$. Exactly, \[ y - 1 = 3x. \]",
        True,
    ),
    "a list of cases": (
        r"\begin{itemize} \item[indoors] \[ q = 1 \] \item[outdoors] \[ q = r \] \end{itemize} Hence \[ r = 1. \]",
        True,
    ),
    "a list in markdown": (
        "- indoors:\n\n  $$ q = 1 $$\n\n- outdoors:\n\n  $$ q = r $$\n\nHence\n\n$$ r = 1 $$\n",
        False,
    ),
    "a footnote": (r"\[ y = k x \]\footnote{In older texts $k = -1$.} Hence \[ y = -x. \]", True),
    "a comment in HTML": ("<!-- $$ a = b $$ -->\n\nHence\n\n$$ a - b = 0 $$\n", False),
    "a comment in HTML of lines": ("<!---\n$$\na = b\n$$\n--->\n\nHence\n\n$$ a - b = 0 $$\n", False),
    "struck out": ("~~The law is $a = b$.~~ We have\n\n$$ s = a + b $$\n\nHence\n\n$$ s = 2a $$\n", False),
    "cancelled": (r"\[ s = a + \cancel{b} \] Hence \[ s = a + b. \]", True),
    "a quotation in markdown": (
        "> Smith finds\n>\n> $$ s = a - b $$\n\nThis is wrong. We have\n\n$$ s + b = a $$\n",
        False,
    ),
    "a comment environment": (r"\begin{comment} \[ a = b \] \end{comment} Hence \[ a - b = 0. \]", True),
    "a table": (
        "| place | value |\n|---|---|\n| left | $x = a$ |\n| right | $x = b$ |\n\nHence\n\n$$ x - a = 0 $$\n",
        False,
    ),
    "a heading for each camera": (
        "## Pinhole\n\n$$ r = f t $$\n\n## Fisheye\n\n$$ r = f a $$\n\n## Result\n\n$$ f t = f a $$\n",
        False,
    ),
    "one index of a sum": (r"\[ y = \sum_{i} x_i \] At $i = 1$ \[ x_i = 0 \] Hence \[ y = 0 \]", True),
    "two frames": (
        r"The velocity in frame A is \[ v = u. \] The velocity in frame B is \[ v = u - w. \] Hence \[ w + 1 = 1. \]",
        True,
    ),
    "samples in square brackets": (
        r"\[ x[n] = a n \] \[ x[n-k] = b \] Hence \[ x (n - k) = b \]",
        True,
    ),
    "the second and the third iterate": (
        r"\[ x^{k+1} = x^k + h \] \[ x^2 = a \] Hence \[ x^3 = a x \]",
        True,
    ),
}


@pytest.mark.parametrize("name", DOCUMENTS)
def test_what_only_looks_like_a_consequence_does_not_follow(name: str) -> None:
    text, latex = DOCUMENTS[name]
    found = read_document(document_of(text, latex=latex))
    assert found[-1].verdict not in ("follows", "contradicts")


@pytest.mark.parametrize(
    "latex",
    [
        r"In a tropical climate \[ q = a b. \] Hence \[ q c = a b c. \]",
        r"The superscript $T$ denotes the transpose. \[ s = r^2 \] Hence \[ s^2 = r^4. \]",
        r"The values of $u$ are set. \[ s = u + v \] Hence \[ s^2 = u^2 + 2 u v + v^2. \]",
        r"Let $m$ be a function of the mass. \[ p = m v \] Hence \[ p w = m v w. \]",
        r"We use the summation convention. \[ s = a_i b_i \] \[ d = u + v \] Hence \[ d^2 = u^2 + 2 u v + v^2. \]",
        r"The list may have repeated indices. \[ s_i = u_i + v_j \] Hence \[ 2 s_i = 2 u_i + 2 v_j. \]",
        r"The angles are modulo $2\pi$. \[ s = a + b \] Hence \[ 2 s = 2 a + 2 b. \]",
        r"\[ noise = a b \] Hence \[ 2 noise = 2 a b. \]",
        r"The error of the clock is \[ e = a - b. \] This is small. Hence \[ e + b = a. \]",
        r"\[ s = a + b \] This is what we need. Hence \[ s - a = b. \]",
        r"\[ E = M + e \sin E \] Hence \[ E - e \sin E = M. \]",
        r"If we put the values in, \[ s = a + b. \] Then \[ s - a = b. \]",
        r"\[ x[n+1] = x[n] + h v[n] \] Hence \[ x[n+1] - x[n] = h v[n]. \]",
        r"\[ x^{k+1} = x^k + h^2 \] Hence \[ x^{k+1} - x^k = h^2. \]",
        r"\[ \text{gain} = \frac{u}{v} \] Hence \[ v\,\text{gain} = u. \]",
        r"\[ x = a \quad\text{and}\quad y = 2 a \] Hence \[ y = 2 x. \]",
    ],
)
def test_such_words_hide_no_consequence_that_they_do_not_concern(latex: str) -> None:
    assert read_document(document_of(latex))[-1].verdict == "follows"


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        # Nothing says that a letter does not change, or words say that it does.
        (r"\[ v = r \omega \] Hence \[ \dot v = r \dot\omega. \]", False),
        (r"Both $r$ and $\omega$ change with time. \[ v = r \omega \] Hence \[ \dot v = r \dot\omega. \]", False),
        (r"Note that $r$ is not constant. \[ v = r \omega \] Hence \[ \dot v = r \dot\omega. \]", False),
        (r"If $r$ is constant, it turns. \[ v = r \omega \] Hence \[ \dot v = r \dot\omega. \]", False),
        (r"With piecewise constant $r$ \[ v = r \omega \] Hence \[ \dot v = r \dot\omega. \]", False),
        (r"$r$ is constant along the rod. \[ v = r \omega \] Hence \[ \dot v = r \dot\omega. \]", False),
        (r"The stiffness $k$ varies. \[ M = k w \] Hence \[ \frac{dM}{dx} = k \frac{dw}{dx}. \]", False),
        (r"\[ k = \frac{K}{L} \] Hence \[ \dot k = \frac{\dot K}{L}. \]", False),
        (r"The radius $r$ is constant. \[ v = r \omega \] Hence \[ \dot v = r \dot\omega. \]", True),
        (
            r"The letters $m$, $a$ and $r$ do not change. \[ v = a r \omega \] Hence \[ \dot v = a r \dot\omega. \]",
            True,
        ),
        (r"Let $r$ be constant. \[ v = r \omega \] Hence \[ \frac{dv}{dt} = r \frac{d\omega}{dt}. \]", True),
        (r"\[ x = a t^2 + b \] Hence \[ \dot x = 2 a t. \] The time is $t$.", True),
        # A letter is given twice.
        (r"For long beams \[ w = a L. \] For short beams \[ w = a L + b. \] Hence \[ b = 0. \]", False),
        (r"Step 1: \[ x = a + b. \] Step 2: \[ x = a - b. \] Hence \[ b = 0. \]", False),
        (r"The bounds are \begin{align} x &= a - d \\ x &= a + d \end{align} Hence \[ d = 0. \]", False),
        (r"The vertices are \[ x = 0, \quad x = a. \] Hence \[ a = 0. \]", False),
        (
            r"Two of them are \begin{align} s &= \frac{q}{n} \\ s &= \frac{q}{n - 1} \end{align} Hence \[ q = 0. \]",
            False,
        ),
        (r"\[ y = a x + b \] \[ y = c x + d \] Hence \[ (a - c) x = d - b. \]", True),
        (r"\[ y = a (b + c) \] \[ y = a b + a c \] \[ z = 2 y \] Hence \[ z = 2 a b + 2 a c. \]", True),
    ],
)
def test_what_changes_is_not_fixed_and_what_is_given_twice_is_not_put_together(latex: str, follows: bool) -> None:
    assert (read_document(document_of(latex))[-1].verdict == "follows") == follows


SPRINGS = r"\section{Springs} The stiffness is \[ k = 2 m. \] It is given for each spring of the set. \section{Waves} "


@pytest.mark.parametrize(
    ("words", "follows"),
    [
        (r"We have \[ w = c k, \] where $k$ is the wave number. Hence", False),
        (r"We have \[ w = c k. \] Here $k$ denotes the wave number. Hence", False),
        (r"We have \[ w = c k. \] Its letters: $k$: wave number. Hence", False),
        (r"The wave number is $k = 3 n$, and \[ w = c k. \] Hence", False),
        (r"We have \[ w = c k, \] where $k$ is the stiffness. Hence", True),
        (r"We have \[ w = c k. \] Hence", True),
    ],
)
def test_a_letter_that_another_section_calls_something_else_is_not_what_it_was(words, follows):
    found = read_document(document_of(rf"{SPRINGS}{words} \[ w = 2 c m. \]"), seconds=5)
    assert (found[-1].verdict == "follows") is follows


@pytest.mark.parametrize(
    "words",
    [
        "Now the mass is doubled. Hence",
        "After the collision the mass has doubled. Hence",
        "In terms of the reduced mass we get",
    ],
)
def test_an_equation_of_what_has_changed_contradicts_nothing(words):
    found = read_document(document_of(rf"The momentum is \[ p = m v. \] {words} \[ p = 2 m v. \]"), seconds=5)
    assert found[-1].verdict == "independent"


@pytest.mark.parametrize(
    ("words", "follows"),
    [
        ("A point is critical if \\[ g = 0. \\]", False),
        ("The rays meet unless \\[ g = 0. \\]", False),
        ("The estimator is unbiased provided that \\[ g = 0. \\]", False),
        ("Whether or not \\[ g = 0, \\] it is small.", False),
        ("A harmonic function satisfies \\[ g = 0. \\]", False),
        ("Balance requires \\[ g = 0. \\]", False),
        ("The goal of the control is \\[ g = 0. \\]", False),
        ("Minimise $f$ subject to \\[ g = 0. \\]", False),
        ("We solve \\[ g = 0 \\] by Newton's method.", False),
        ("The points for which \\[ g = 0 \\] are called critical.", False),
        (r"The rules are \begin{itemize} \item stop if \[ g = 0 \] \item go on \end{itemize}", False),
        ("A point is critical if \\[ g = 0. \\] On this sphere \\[ s = 2 a. \\]", False),
        ("A body is in balance if \\[ g = m a. \\] Without balance \\[ d = e - 2 m a. \\]", False),
        ("The criterion of rest is \\[ g = 0. \\]", False),
        ("The condition for balance reads \\[ g = 0. \\]", False),
        ("A test of balance is \\[ g = 0. \\]", False),
        ("The initial condition is \\[ g = 0. \\]", True),
        ("The condition for a minimum is \\[ g = 0. \\]", True),
        ("Suppose that \\[ g = 0. \\]", True),
        ("Hence \\[ g = 0. \\]", True),
        ("\\[ g = 0 \\]", True),
    ],
)
def test_an_equation_that_is_the_condition_of_its_sentence_serves_no_later_one(words, follows):
    found = read_document(document_of(rf"{words} The step is \[ h = 2 g + d. \] Hence \[ h = d. \]"), seconds=5)
    assert (found[-1].verdict == "follows") is follows


@pytest.mark.parametrize(
    "latex",
    [
        r"The flow is steady if \[ q = 0. \] Then \[ r = q + s. \] Hence \[ r = s. \]",
        r"If \[ q = 0, \] the balance \[ r = q + s \] becomes \[ r = s. \]",
        r"The balance is \[ r = q + s. \] The flow is steady if \[ q = 0. \] In this case \[ r = s. \]",
        r"The balance is \[ r = q + s. \] The flow is steady if \[ q = 0. \tag{3} \] By (3), \[ r = s. \]",
        r"When the beam is loaded we have \[ w = q l. \] The moment is \[ M = w l/8. \] Hence \[ M = q l^2/8. \]",
    ],
)
def test_a_condition_serves_its_own_sentence_one_that_goes_on_from_it_and_where_it_is_cited(latex):
    assert read_document(document_of(latex), seconds=5)[-1].verdict == "follows"


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (
            r"\[ f = x y, \quad s = x + y \] As a function of $x$ and $s$, \[ \frac{\partial f}{\partial x} = y. \]",
            False,
        ),
        (r"\[ f = x y, \quad s = x + y \] Keeping $s$ fixed, \[ \frac{\partial f}{\partial x} = y. \]", False),
        (r"\[ x = r \cos\theta \] At fixed $x$, \[ \frac{\partial x}{\partial\theta} = -r \sin\theta. \]", False),
        (r"On the line $x + y = 1$, \[ f = x y. \] Hence \[ \frac{df}{dx} = y. \]", False),
        (r"The mass $m$ is constant. \[ p = m v \] Here $m$ grows with time. \[ \dot p = m \dot v \]", False),
        (r"The mass $m$ is constant. For the rocket it is not. \[ p = m v \] \[ \dot p = m \dot v \]", False),
        (r"The mass $m$ is constant. \[ p = m v \] \[ \dot p = m \dot v \]", True),
        (r"\[ f = x y \] As a function of $x$ and $y$, \[ \frac{\partial f}{\partial x} = y. \]", True),
        (r"\[ f = x y \] At fixed $y$, \[ \frac{\partial f}{\partial x} = y. \]", True),
    ],
)
def test_a_derivative_is_taken_of_the_letters_that_its_sentence_names_and_of_none_that_change(latex, follows):
    assert (read_document(document_of(latex), seconds=5)[-1].verdict == "follows") is follows


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (r"Find the $t$ for which \[ s = v t. \] For all $t$, \[ s = v t. \]", False),
        (r"Solve \[ x^2 = 2 x. \] The identity \[ x^2 = 2 x \] holds for all $x$.", False),
        (r"At the optimum \[ A x = b. \] Away from the optimum \[ A x = b. \]", False),
        (r"The constraint is \[ g = a. \] With the penalty method it is violated: \[ g = a. \]", False),
        (r"At the optimum \[ A x = b. \] We recall that \[ A x = b. \]", True),
    ],
)
def test_an_equation_that_is_said_of_more_is_not_the_same_one(latex, follows):
    assert (read_document(document_of(latex), seconds=5)[-1].verdict == "follows") is follows
