r"""True documents that look like false ones: none of their equations may be called a contradiction.

Each has an equation that differs in one place from a consequence of what stands above it, and is true all the same: of
another case, limit, medium, body, convention, or meaning of a letter.
"""

import pytest

from algebroproj_sym.reading import document_of, read_document

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
}


@pytest.mark.parametrize("latex", TRUE.values(), ids=TRUE)
def test_what_may_be_true_is_not_called_a_contradiction(latex):
    found = read_document(document_of(latex), seconds=5)
    assert [each.read for each in found if each.verdict == "contradicts"] == []
