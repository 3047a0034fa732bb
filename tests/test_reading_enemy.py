r"""True documents that look like false ones, of which nothing may be called a contradiction, and false ones.

Each true one has an equation that differs in one place from a consequence of what stands above it, and is true all the
same: of another case, limit, medium, body, convention, or meaning of a letter.
"""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

ENERGY = r"The energy is \[ E := \frac12 m v^2 + \frac12 k x^2. \] "
LENS = r"The power of a lens is \[ P := \frac{1}{a} + \frac{1}{b}. \] "
WAVE = r"A wave is given by \[ y = A \sin(k x - w t). \] "
TURN = r"\[ R = \begin{pmatrix} \cos t & -\sin t \\ \sin t & \cos t \end{pmatrix}. \] "
SUM = r"The total is \[ s := a + b. \] "
SPEED = r"A source that rests is heard at \[ f := \frac{c}{l}. \] "

TRUE = {
    # A case that words name, before or behind the equation.
    "a case before": SUM + r"If the signs are opposite, this gives \[ s^2 = a^2 - 2ab + b^2. \]",
    "a case behind": SUM + r"Hence \[ s^2 = a^2 - 2ab + b^2 \] if $b$ is negative.",
    "a case in brackets": SUM + r"Hence \[ s^2 = a^2 + 3ab + b^2 \quad (a = 0). \]",
    "a case in a text": SUM + r"Hence \[ s^2 = a^2 + 3ab + b^2 \text{ for } b = 0. \]",
    "at rest": ENERGY + r"At rest we get \[ E = \frac12 k x^2. \]",
    "without": ENERGY + r"Without the spring this becomes \[ E = \frac12 m v^2 + \frac12 x^2. \]",
    "in the absence": ENERGY + r"In the absence of the spring this becomes \[ 2E = m v^2 - k x^2. \]",
    "provided": SUM + r"Thus \[ s^2 = a^2 - 2ab + b^2, \] provided that one of them is zero.",
    "only": SUM + r"Only on the axis we have \[ s^2 = a^2 - 2ab + b^2. \]",
    "during": ENERGY + r"During the fall it follows that \[ 2E = m v^2 - k x^2. \]",
    "for example": SUM + r"For example, with $b = 0$ we get \[ s^2 = a^2 + ab + b^2. \]",
    "assume": SUM + r"We assume that nothing is in the second vessel. Hence \[ s^2 = a^2 - 2ab + b^2. \]",
    "at the edge": SUM + r"At the boundary we have \[ s^2 = a^2 - 2 a b + b^2. \]",
    "initially": ENERGY + r"Initially we have \[ 2E = m v^2 - k x^2. \]",
    "a value": SUM + r"With $b=0$ it follows that \[ s^2 = a^2 - 2 a b + b^2. \]",
    "a unit": SUM + r"In units in which $a$ is one, this gives \[ s^2 = a^2 + 2b + b^2. \]",
    "small angles": r"\[ c := \cos u. \] To second order this gives \[ 2 c = 2 \sin u. \]",
    "leading order": SUM + r"To leading order we obtain \[ s^2 = a^2 + 2ab - b^2. \]",
    "about": SUM + r"Roughly, this gives \[ s^2 = a^2 + 2ab - b^2. \]",
    "dropped": SUM + r"Dropping the last term, we obtain \[ s^2 = a^2 + 2ab + b^3. \]",
    "ignored": SUM + r"If friction is ignored, we obtain \[ s^2 = a^2 + 2ab + b^3. \]",
    # Another thing.
    "another wave": WAVE
    + r"Hence it moves to the right. A wave that moves to the left is \[ y = A \sin(k x + w t). \]",
    "the left wave": WAVE + r"The reflected wave gives \[ y = A \sin(k x + w t). \]",
    "recedes": SPEED + r"A source that recedes gives \[ f = \frac{c}{2l}. \]",
    "recedes, with letters": r"A source that approaches is heard at \[ f = g \frac{c}{c - v}. \] "
    r"A source that recedes gives \[ f = g \frac{c}{c + v}. \]",
    "approaches": r"The speed is \[ w := u + v. \] A source that recedes becomes \[ 2w = 2u - 2v. \]",
    "a diverging lens": LENS + r"A lens that diverges has \[ P = \frac1a - \frac1b. \]",
    "a ring": r"A disc has the moment \[ I := \frac12 m r^2. \] A ring gives \[ 2I = 2 m r^2. \]",
    "parallel": r"Resistors in series give \[ R := r_1 + r_2. \] Resistors in parallel give "
    r"\[ \frac1R = \frac{1}{r_1} + \frac{1}{r_2}. \]",
    "the sphere": r"The volume of a cylinder is \[ V := \pi r^2 h. \] A cone gives \[ 3 V = \pi r^2 h. \]",
    "the other medium": r"The index is \[ n = c/v. \] The water gives \[ n = c/(2v). \]",
    "the lower sign": SUM + r"The lower sign gives \[ s^2 = a^2 - 2ab + b^2. \]",
    "the other root": r"\[ x = -p + q. \] The other branch gives \[ x = -p - q. \]",
    "respectively": SUM + r"The sum and the difference have, respectively, \[ s^2 = a^2 - 2ab + b^2. \]",
    "clockwise": TURN + r"A turn clockwise gives "
    r"\[ R = \begin{pmatrix} \cos t & \sin t \\ -\sin t & \cos t \end{pmatrix}. \]",
    "an active turn": TURN + r"As a passive turn it becomes "
    r"\[ R = \begin{pmatrix} \cos t & \sin t \\ -\sin t & \cos t \end{pmatrix}. \]",
    "the plane": r"In space the trace is \[ t := a + b + c. \] In the plane this gives \[ 2t = 2a + 2b - c. \]",
    "the old formula": SUM + r"Earlier authors find \[ s^2 = a^2 - 2ab + b^2. \]",
    "a wrong formula": SUM + r"A beginner writes \[ s^2 = a^2 + b^2. \] This leads to an error.",
    "not": SUM + r"It is not true that, hence, \[ s^2 = a^2 - 2ab + b^2. \]",
    "a question": SUM + r"Does it follow that \[ s^2 = a^2 - 2ab + b^2? \]",
    "in terms of": SUM + r"In terms of its parts, the difference gives \[ s^2 = a^2 - 2ab + b^2. \]",
    # Another meaning of a letter.
    "a new section": SUM + r"\section{Differences} Hence \[ s^2 = a^2 - 2ab + b^2. \]",
    "a new paragraph": SUM + r"\paragraph{Differences} The difference $s$ gives \[ s^2 = a^2 - 2ab + b^2. \]",
    "now": SUM + r"Now let $s$ be the difference. Hence \[ s^2 = a^2 - 2ab + b^2. \]",
    "denotes": SUM + r"From here on $s$ denotes the difference. We get \[ s^2 = a^2 - 2ab + b^2. \]",
    "with the new": SUM + r"With the new $b$, the negative of the old one, we get \[ s^2 = a^2 - 2ab + b^2. \]",
    "replaced": SUM + r"Replacing $b$ by $-b$ gives \[ s^2 = a^2 - 2ab + b^2. \]",
    "changed": SUM + r"Changing the sign of $b$ gives \[ s^2 = a^2 - 2ab + b^2. \]",
    "switched": SUM + r"Exchanging the roles yields \[ s^2 = a^2 - 2ab + b^2. \]",
    "scaled": SUM + r"After rescaling $a$ we obtain \[ s^2 = 4a^2 + 2ab + b^2. \]",
    "shifted": r"\[ y := (x + 1)^2. \] Shifting the origin yields \[ y = x^2 + 2x - 1. \]",
    "an inline definition": SUM + r"Where $s = a - b$ we get \[ s^2 = a^2 - 2ab + b^2. \]",
    "now, within the text": SUM + r"Now $s = a - b$, and hence \[ s^2 = a^2 - 2ab + b^2. \]",
    "a value within the text": SUM + r"Here $a = 0$ and $s = b$. We get \[ s^2 = a^2 - 2ab + b^2. \]",
    "defined again": SUM + r"\[ s := a - b \] \[ s^2 = a^2 - 2ab + b^2. \]",
    "defined again, by itself": SUM + r"\[ s := 2 s - 2 b \] \[ s := b + s + a - 2a \]",
    "given again": r"\[ x = a + b. \] \[ x = a - b. \] Hence \[ x^2 = a^2 - 2ab + b^2. \]",
    "two roots beside each other": r"\[ x = a + b, \quad x = a - b. \]",
    "two roots, and what follows": r"\[ x = a + b, \quad x = a - b. \] Hence \[ 2 x = 2a - 2b. \]",
    # Sentences that began before, arrows and chains.
    "a sentence that goes on": r"If $b$ is negative, we have \[ s = a + b \] and hence \[ s^2 = a^2 - 2ab + b^2. \]",
    "a ring that goes on": r"A disc has \[ I := \frac12 m r^2, \] whereas for a ring \[ 2 I = 2 m r^2. \]",
    "an arrow": r"\[ y^2 = x^2 \Rightarrow y = x. \]",
    "an arrow to a case": SUM + r"\[ b = 0 \Rightarrow s = a - b. \]",
    "a chain in a case": SUM + r"If $b = 0$, we have \[ y = s^2 = a^2 - 2ab + b^2. \]",
    "a chain to a condition": r"\[ y = 2x - 2a = 0. \]",
    "a chain to first order": r"\[ y = (1 + e)^2 = 1 + 2e. \]",
    "a chain to a value": r"\[ y = a^2 = 4. \]",
    "a chain with an index": r"\[ y = x_1 + x_2 = x_2 + x_3. \]",
    "a letter given by a law": r"\[ p = r t + q. \] \[ c := p - q. \] At the wall it follows that \[ 2 c = r t. \]",
    "a case given by a law": r"For a gas $p v = r t$. \[ p v = r t. \] A solid gives \[ 2 p v = r t. \]",
    # Conditions and laws.
    "a condition": r"\[ b = \frac{a f}{a - f}. \] The beam is parallel if \[ a = f. \]",
    "rest": r"\[ p := m v. \] If the body rests, \[ v = 0. \] Hence it has no momentum. Otherwise \[ 2 p = 2 m v. \]",
    "rest, then not": r"If the body rests, \[ v = 0. \] A body that moves has \[ \frac12 m v^2 = m g h. \]",
    "two laws": r"\[ F = m a \] Hooke's law gives \[ F = -k x. \]",
    "a stationary point": r"\[ y := x^2 - 2 a x. \] Setting the derivative to zero gives \[ 2x - 2a = 0. \]",
    "an average": SUM + r"The mean gives \[ 2 s = a + b. \]",
    "a limit": r"\[ w := \frac{1 + e}{1 - e}. \] For a circle this becomes \[ w = \frac{1 + e}{1 + e}. \]",
    "an equilibrium": ENERGY + r"In equilibrium we find \[ 2E = m v^2 - k x^2. \]",
    "a boundary value": r"\[ u = a x + b. \] The wall gives \[ u = a x - b. \]",
    "rounded": r"\[ s := \frac13. \] Hence \[ s = 0.333. \]",
    "a congruence": r"\[ s := 7. \] Hence \[ s = 2 \pmod 5. \]",
    "logarithms": r"\[ L := \ln a + \ln b. \] Hence \[ L = \log(ab). \]",
    # Chains, with a case that hardly shows.
    "a dropped term in a chain": r"\[ y = (1 + e)^2 - 1 = 2e + e^2 = 2e. \]",
    "a chain to first order in words": r"To first order, \begin{align} \sin x &= x - x^3/6 \\ "
    r"&= x. \end{align}",
    "a chain that ends at rest": r"At rest, \begin{align} E &= \frac12 m v^2 + m g h \\ "
    r"&= m g h. \end{align}",
    "a chain with a fixed point": r"A fixed point has \[ x = 2x - x^2 = x^2. \]",
    "a chain with a root": r"\[ y = \sqrt{x^2} = x. \]",
    "a chain modulo": r"Modulo 5 we have \[ 2^4 = 16 = 1. \]",
    "a chain of equal halves": r"Both halves are equal, so \[ y = a + b = 2 a. \]",
    "a chain of a period": r"\[ y = u(t + T) = u(t). \]",
    "a chain of an even function": r"For even functions \[ y = g(x) + h(-x) = g(x) + h(x). \]",
    # Letters that a sentence lets be something.
    "a letter let": SUM + r"Let $b$ be zero. Hence \[ s^2 = a^2 - 2ab + b^2. \]",
    "let of a product": SUM + r"Let $a b = 0$. Hence \[ s^2 = a^2 - 2ab + b^2. \]",
    "let the difference": SUM + r"Let $s = a - b$ from here on. Hence \[ s^2 = a^2 - 2ab + b^2. \]",
    "let of a set": r"Let $x \in \{0, 1\}$ and \[ y := x^2. \] Hence \[ y = x. \]",
    "let of an interval": r"\[ y := \sqrt{x^2}. \] Let $x \in [-1, 0]$. Hence \[ y = -x. \]",
    # What is computed has a name in its sentence.
    "a determinant of another one": r"\[ R = \begin{pmatrix} c & -s \\ s & c \end{pmatrix}. \] "
    r"The determinant of the mirrored one is \[ \det R = -c^2 - s^2. \]",
    "a determinant where": r"\[ A = \begin{pmatrix} a & b \\ b & a \end{pmatrix}. \] "
    r"Its determinant, for a sum of zero, is \[ \det A = a^2 + b^2. \]",
    "a unit determinant": r"\[ A = \begin{pmatrix} a & b \\ c & d \end{pmatrix}. \] "
    r"Its determinant is \[ \det A = 1. \]",
    "a length of one": r"\[ \mathbf{n} = \begin{pmatrix} x \\ y \end{pmatrix}. \] "
    r"Its length is \[ \|\mathbf{n}\| = 1. \]",
    "an orthogonal inverse": r"\[ R = \begin{pmatrix} c & -s \\ s & c \end{pmatrix}. \] Its inverse is "
    r"\[ R^{-1} = \begin{pmatrix} c & s \\ -s & c \end{pmatrix}. \]",
    # Derivatives.
    "a prime for another frame": r"The frequency is \[ f(v) = \frac{c}{c - v}. \] In the other frame it is "
    r"\[ f'(v) = \frac{c}{c + v}. \]",
    "a prime for the image": r"\[ I(x) = x^2 + 1. \] The image after the filter is \[ I'(x) = 2 x + 1. \]",
    "a prime without words": r"\[ f(x) = x^2. \] \[ f'(x) = x^2 + 1. \]",
    "a stationary value": r"\[ f(x) = x^2 - 2 a x. \] The derivative is zero there: \[ f'(x) = 0. \]",
    "a value of the derivative": r"\[ f(x) = x^2 + a x. \] The derivative at the origin is \[ f'(x) = a. \]",
    "a derivative along a curve": r"\[ z = \frac{d}{dx} (x^2 + y^2) = 2x + 2 y \frac{dy}{dx}. \]",
    "a derivative with a prime": r"\[ z = \frac{d}{dx} (x y) = y + x y'. \]",
    "a derivative along the motion": r"\[ z = \frac{d}{dt} (t x) = x + t \dot x. \]",
    "a derivative set to zero": r"\[ z = \frac{d}{dx} (x^2 - 2 a x) = 2x - 2a = 0. \]",
    # A value that an equation gives is one of its case.
    "a mean of another sample": r"The first sample has \[ E(X) = a + b. \] The second sample has \[ "
    r"E(X) = a - b. \] Hence \[ 2 E(X) = 2a - 2b. \]",
    "a value at another place": r"\[ y(0) = a. \] \[ y(1) = b. \] With the other ends \[ y(0) + y(1) = a - b. \]",
    "a mean with a condition": r"\[ E(X) = a + b. \] If $b = 0$, then \[ E(X)^2 = a^2 + a b. \]",
    "a square of another body": r"A disc has \[ k^2 = \frac12 r^2. \] A ring has \[ 2 k^2 = 2 r^2. \]",
    "a variance for independent ones": r"\[ \mathrm{Var}(X) = u + v + 2 w. \] Independent ones have "
    r"\[ \mathrm{Var}(X) = u + v. \]",
    "a norm in the limit": r"\[ \|\mathbf{a}\| = r + h. \] Far away this gives \[ \|\mathbf{a}\| = r. \]",
    "a determinant of its mirror": r"\[ \det A = a b. \] The mirror gives \[ \det A = - a b. \]",
    "a logarithm of another base": r"\[ \log(K) = a + b. \] Hence \[ \log(K) = 2a + 2b. \]",
    "a root of a square": r"\[ s^2 = a^2. \] Hence \[ s = a. \]",
    "two squares": r"\[ s^2 = a + b. \] Hence in the other medium \[ s^2 = a - b. \]",
    # The first equation that gives a letter is no contradiction to a law in which it stands.
    "a letter of a law": r"\[ p v = r t. \] A solid has \[ p = 2 r t. \]",
    "the roots of a function": r"We seek the roots of a function, $f(x) = 0$. Here it is \[ f(x) = x^2 - a. \]",
    "the roots of a function again": r"We seek, $f(x) = 0$. This gives \[ f(x) + a = x^2. \]",
    "a letter of two laws": r"\[ F = m a. \] A spring has \[ a = -k x. \]",
    "a letter given behind": r"\[ y = u v + w. \] where, for the left side, \[ w = u - v. \] and for "
    r"the right one \[ w = u + v. \]",
    "a letter of a sum": r"\[ s = \sum_{i=1}^n w_i x_i. \] Equal weights are \[ w_i = \frac1n. \] "
    r"Hence \[ s = \frac1n \sum_{i=1}^n x_i. \]",
    "a square of a new letter": r"\[ R^2 = x^2 + y^2. \] A hyperbola has \[ R^2 = x^2 - y^2. \]",
    # Sums, whose index hides in letters.
    "a sum with a weight": r"\[ w - i = c. \] Hence \[ \sum_{i=1}^n w x_i = c \sum_{i=1}^n x_i + "
    r"\sum_{i=1}^n i x_i. \]",
    "a sum from zero": r"\[ \sum_{i=0}^n c = n c + c. \] \[ \sum_{i=1}^n c = n c. \]",
    "a sum to its half": r"\[ S = \sum_{k=1}^n c. \] With half of the terms this gives \[ 2 S = n c. \]",
    # Second derivatives, binomials, factorials.
    "a second derivative along the motion": r"\[ z = \frac{d^2}{dt^2} (t x) = 2 \dot x + t \ddot x. \]",
    "a second derivative of another function": r"\[ f(x) = x^3. \] The second derivative of its "
    r"square is \[ f''(x) = 30 x^4. \]",
    "a second derivative set to zero": r"\[ z = \frac{d^2}{dx^2} (x^3 - a x^2) = 6x - 2a = 0. \]",
    "a binomial": r"\[ \binom{n}{k} = \binom{n - 1}{k} + \binom{n - 1}{k - 1}. \]",
    "a factorial": r"\[ g := n!. \] Hence \[ g = n (n - 1)!. \]",
    "a divergence": r"\[ \mathrm{KL}[P || Q] = a - b. \] The other way gives \[ \mathrm{KL}[Q || P] = b - a. \]",
    "an average in brackets": r"\[ \langle x \rangle = a. \] Hence \[ \langle x^2 \rangle = a^2 + s. \]",
}


@pytest.mark.parametrize("latex", TRUE.values(), ids=TRUE)
def test_what_may_be_true_is_not_called_a_contradiction(latex):
    found = read_document(document_of(latex), seconds=5)
    assert [each.read for each in found if each.verdict == "contradicts"] == []


NOTHING_FOLLOWS = [
    r"\[ E(X) = a. \] \[ E(X^2) = a^2. \]",
    r"\[ E(X) = a. \] \[ E(2 X) = 2 a. \]",
    r"\[ E(i) = a. \] \[ \sum_{i=1}^n E(i) = n a. \]",
    r"\[ E(x) = a. \] \[ \frac{d}{dx} (x E(x)) = a. \]",
    r"\[ f(x) := E(x) + 1. \] \[ E(x) = a. \] \[ f(2) = a + 1. \]",
    r"\[ s^2 = a. \] \[ s = -\sqrt{a}. \]",
    r"\[ s^2 = a^2. \] \[ s = a. \]",
    r"\[ p(a) = q a. \] \[ p(a, b) = q a. \]",
    r"\[ \binom{n}{k} = \binom{k}{n}. \]",
    r"\[ (n + 1)! = n! + 1. \]",
    r"\[ \mathrm{KL}[P || Q] = \mathrm{KL}[Q || P]. \]",
    r"\[ \langle x^2 \rangle = \langle x \rangle^2. \]",
    r"\[ f(x) = x^3. \] \[ \frac{d^2 f}{dx^2} = 3 x^2. \]",
    r"\[ y = \frac{d^2}{dx^2} x^3. \] \[ y = 3 x^2. \]",
    r"Here $\mathbf{x}$ is a vector. \[ f = \frac{1}{2^n} \mathbf{x}^T\mathbf{x}. \] \[ f = "
    r"\frac{1}{2^m} \mathbf{x}^T\mathbf{x}. \]",
    r"\[ \det A = a. \] \[ \det B = a. \]",
    r"\[ y(a) = 0. \] \[ y(b) = 0. \]",
    r"\[ X = a + b. \] \[ E(X) = c. \] \[ E(a + b) = 2 c. \]",
    r"The letters $v > w$. \[ v = w. \] If $x = 2$, \[ E(v) = 3. \] \section{Other} \[ E(v) = 3. \]",
]


@pytest.mark.parametrize("latex", NOTHING_FOLLOWS)
def test_what_does_not_follow_from_a_value_or_a_square_that_is_given_is_left_open(latex):
    assert read_document(document_of(latex), seconds=5)[-1].verdict not in ("follows", "contradicts")


MATRIX = r"\begin{bmatrix} a & b \\ c & d \end{bmatrix}"
FALSE = {
    "sign in a chain": r"\begin{align} (a+b)^2 &= a^2 + 2ab + b^2 \\ &= a^2 + b(2a + b) \\ "
    r"&= a^2 + b(2a - b) \end{align}",
    "whole sign in a chain": r"\begin{align} \frac1x - \frac1y &= -\frac{x - y}{xy} \\ "
    r"&= \frac{x - y}{xy}. \end{align}",
    "function in a chain": r"\begin{align*} \sin(2t) &= 2\tan t \cos^2 t \\ &= 2\tan t \sin^2 t \end{align*}",
    "product in a chain": r"\begin{align} (x-1)(x+1)(x^2+1) &= (x^2-1)(x^2+1) \\ &= x^4 + 1. \end{align}",
    "half of a side": r"\begin{align} s &= (a+b)^2 - (a-b)^2 \\ &= 4 a b \\ &= 2 ab \end{align}",
    "derivative in a chain": r"\begin{align} \frac{d}{dx} (x^3 + 2x) &= 3x^2 + 2 \\ &= 3x^2 + 3 \end{align}",
    "derivative itself": r"\[ y = \frac{d}{dx} (x^3 + 2x) = 3x^2 - 2. \]",
    "area": r"The area is \begin{align} A &= \pi (R^2 - r^2) \\ &= \pi (R - r)(R + r) \\ &= \pi (R - "
    r"r)^2. \end{align}",
    "exponent in a chain": r"\begin{align} (1 - q)(1 + q + q^2) &= 1 + q^2 - q^2 - q^3 \\ &= 1 - q^2. \end{align}",
    "cross product": r"\begin{align} \mathbf{a} \times \mathbf{b} &= -\mathbf{b} \times \mathbf{a} \\ "
    r"&= \mathbf{b} \times \mathbf{a}. \end{align} with $\mathbf{a}, \mathbf{b} \in \mathbb{R}^3$.",
    "numbers": r"It is known that \[ 2^{10} = 1000. \]",
    "matrices of numbers": r"\[ \begin{pmatrix} 1 & 2 \\ 3 & 4\end{pmatrix} "
    r"\begin{pmatrix} 0 & 1 \\ 1 & 0\end{pmatrix} "
    r"= \begin{pmatrix} 2 & 1 \\ 4 & 2\end{pmatrix} \]",
    "let": r"Let $c = a^2 + b^2$. We have \[ c - 2ab = (a + b)^2. \]",
    "sum and difference": r"Define \[ u := x + y, \quad v := x - y. \] Then \[ u v = x^2 + y^2. \]",
    "determinant": r"The rotation is " + TURN + r"Its determinant is \[ \det R = \cos^2 t - \sin^2 t. \]",
    "inverse": rf"With \[ A = {MATRIX} \] the inverse is "
    r"\[ A^{-1} = \frac{1}{ad - bc} \begin{bmatrix} d & b \\ -c & a \end{bmatrix}. \]",
    "trace": rf"We have \[ A = {MATRIX}. \] Its trace is \[ \operatorname{{tr}} A = a - d. \]",
    "derivative of a function": r"Let \[ f(x) = x^3 - 3x. \] Its derivative is \[ f'(x) = 3x^2 + 3. \]",
    "second derivative": r"We have \[ f(x) = x^3 - a x. \] Its derivatives are then \[ f''(x) = 6x^2. \]",
    "substitution": r"The energy is \[ T = \frac12 m v^2 \] where \[ v = r w. \] "
    r"It follows that \[ T = \frac12 m r w^2. \]",
    "second derivative of a polynomial": r"Let \[ f(x) = x^4 - a x. \] Its derivatives are \[ f''(x) = 12 x^3. \]",
    "second derivative in a chain": r"\[ y = \frac{d^2}{dx^2} (x^4 + x) = -12 x^2. \]",
    "partial derivative in a chain": r"\[ y = \frac{\partial^2}{\partial x^2} (b x^3) = -6 b x. \]",
    "third derivative in a chain": r"\[ y = \frac{d^3}{dx^3} x^5 = 61 x^2. \]",
    "binomial of numbers": r"\[ \binom{5}{2} = 15 \]",
    "choose": r"\[ {4 \choose 2} + 1 = 6 \]",
    "over": r"\[ {1 \over 2} + {1 \over 3} = {5 \over 7} \]",
    "over in a chain": r"\[ s = {1 \over a} - {1 \over b} = {a - b \over a b}. \]",
    "factorials of numbers": r"\[ 3! + 2! = 9 \]",
    "quotient of factorials": r"\[ \frac{5!}{3!} = 10 \]",
    "polar": r"\[ x = r\cos t, \quad y = r \sin t. \] Thus \[ x^2 + y^2 = 2 r^2. \]",
}


@pytest.mark.parametrize("latex", FALSE.values(), ids=FALSE)
def test_a_contradiction_that_a_reader_sees_is_called_one(latex):
    verdicts = [each.verdict for each in read_document(document_of(latex), seconds=5)]
    assert verdicts[-1] == "contradicts", verdicts
    assert verdicts.count("contradicts") == 1


def test_a_derivative_is_taken_before_its_place_is_put_in():
    found = read_document(
        document_of(r"\[ f(x) := a x. \] \[ f'(a) = a. \] \[ f'(2) = a. \] \[ f'(a) = 2a. \]"), seconds=5
    )
    assert [each.verdict for each in found[1:3]] == ["follows", "follows"]
    assert found[3].verdict != "follows"


def test_one_value_of_a_function_says_nothing_of_another_one():
    found = read_document(
        document_of(r"\[ y(a) = b \] \[ y(c) = b \] \[ y(a) - y(d) = 0 \] \[ y(a) - y(c) = 0 \]"), seconds=5
    )
    assert [each.verdict for each in found[:2]] == ["independent"] * 2
    assert [each.verdict == "follows" for each in found[2:]] == [False, True]
    assert found[3].links[0].rests_on == ("line 1",)
    found = read_document(document_of(r"\[ f(x) = a x. \] \[ f(a) = a^2. \] \[ f(2) = 4. \]"), seconds=5)
    assert [each.verdict for each in found] == ["definition", "follows", "independent"]


def test_a_vector_may_stand_for_itself_with_the_opposite_sign() -> None:
    column = r"\begin{bmatrix} %s \\ %s \\ %s \end{bmatrix}"
    given = r"\[ \mathbf{q} := " + column % ("-a", "b", "c")
    opposite, wrong = (read_document(document_of(given + " = " + column % each + r" \]"))[-1] for each in VECTORS)
    assert (opposite.verdict, wrong.verdict) == ("independent", "contradicts")


VECTORS = (("a", "-b", "-c"), ("-a", "-b", "c"))
