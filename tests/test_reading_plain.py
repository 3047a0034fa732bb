r"""Documents in the plain style of papers and lecture notes that were misread: nothing false follows from them."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

MISLEADING = {
    "more measurements than states": (
        r"There are more measurements than states. \[ \mathbf{z} = \mathbf{H} \mathbf{x} \] "
        r"Hence \[ \mathbf{x} - \mathbf{H}^{-1} \mathbf{z} = 0. \]",
        True,
    ),
    "a fraction in equilibrium": (
        r"In equilibrium, the fraction is \[ x = a / b. \] Away from equilibrium \[ b x - a = 0. \]",
        True,
    ),
    "only in winter": (r"In winter the demand is \[ d = a + b. \] In summer we therefore have \[ d - a = b. \]", True),
    "a Gauss-Newton step": (
        r"\[ \mathbf{J}^T \mathbf{J} \boldsymbol{\delta} = -\mathbf{J}^T \mathbf{r} \] Hence \[ \mathbf{J} "
        r"\boldsymbol{\delta} = -\mathbf{r}. \]",
        True,
    ),
    "a weighted normal equation": (
        r"\[ \mathbf{A}^T \mathbf{W} \mathbf{A} \mathbf{x} = \mathbf{A}^T \mathbf{W} \mathbf{b} \] Hence \[ "
        r"\mathbf{A} \mathbf{x} = \mathbf{b}. \]",
        True,
    ),
    "normal equations by name": (r"\[ N x = A^T P b, \quad N = A^T P A \] Hence \[ A x = b. \]", True),
    "thin normal equations": (
        r"The design matrix $A$ has more rows than columns, and the vector $x$ obeys \[ A^T A x = A^T b. \] "
        r"Hence \[ A x = b. \]",
        True,
    ),
    "a wide system": (
        r"\[ \mathbf{A} \mathbf{x} = \mathbf{A} \mathbf{y}, \] where $\mathbf{A}$ has a null space. Hence "
        r"\[ \mathbf{x} = \mathbf{y}. \]",
        True,
    ),
    "observed minus computed": (
        r"The observed range is \[ r = a. \] The computed range is \[ r = b. \] The residual is therefore "
        r"\[ a - b = 0. \]",
        True,
    ),
    "players": (r"Player 1 chooses \[ x = a. \] Player 2 chooses \[ x = b. \] Hence \[ a - b = 0. \]", True),
    "hypotheses": (
        r"Under $H_0$ the mean is \[ m = a. \] Under $H_1$ the mean is \[ m = b. \] Hence \[ a - b = 0. \]",
        True,
    ),
    "the skater": (
        (
            r"The angular momentum of the skater is \[ L = I \omega. \] As she draws in her arms, \[ \dot L = I "
            r"\dot\omega. \]"
        ),
        True,
    ),
    "plates moving apart": (
        (
            r"The energy of the capacitor is \[ E = \frac12 C U^2. \] While the plates move apart, it changes at "
            r"the rate \[ \dot E = C U \dot U. \]"
        ),
        True,
    ),
    "a growing raindrop": (
        (
            r"A raindrop falls through the fog and gathers water. Its momentum is \[ p = m v. \] Differentiating, "
            r"\[ \dot p = m \dot v. \]"
        ),
        True,
    ),
    "a hardening spring": (
        (
            r"The force is \[ F = k x. \] The spring hardens as it is stretched, so its stiffness follows from \[ "
            r"\frac{dF}{dx} = k. \]"
        ),
        True,
    ),
    "noise twice": (
        (
            r"Let $\varepsilon$ denote noise, drawn anew each time. \[ u = a + \varepsilon \] \[ v = b + "
            r"\varepsilon \] Hence \[ u - v = a - b. \]"
        ),
        True,
    ),
    "constants of estimates": (
        (
            r"As usual, $c$ denotes constants that need not be equal at each occurrence. \[ u = c v \] \[ w = c z "
            r"\] Hence \[ u z = w v. \]"
        ),
        True,
    ),
    "dropping the tildes": (
        (
            r"With the length $L$ as unit we set \[ \tilde x = x / L. \] For brevity we drop the tilde from here on. "
            r"The load is then \[ p = x^2. \] Hence \[ p = L^2 \tilde x^2. \]"
        ),
        True,
    ),
    "micrometres and friction": (
        (
            r"The roughness is \[ x = 5 \mu m. \] The friction force on a mass $m$ is \[ F = \mu m g. \] Hence \[ F = "
            r"\frac{x g}{5}. \]"
        ),
        True,
    ),
    "each and all": (r"Each of the two springs carries \[ F = k x. \] Together they carry \[ F = k x. \]", True),
    "one lamp and three": (r"One lamp takes the power \[ P = U I. \] Three such lamps take \[ P = U I. \]", True),
    "its reciprocal": (r"The conductance is \[ y = a + b. \] Its reciprocal is \[ y = a + b. \]", True),
    "per atom": (r"The energy of the crystal is \[ E = N u. \] The energy per atom is \[ E = N u. \]", True),
    "no pair of materials": (
        (
            r"The relation \[ a = b, \] which was printed in 1970 and which many books repeat, was shown by Jones to "
            r"hold for no pair of materials. Hence \[ a - b = 0. \]"
        ),
        True,
    ),
    "none of the samples": (r"None of the samples satisfied \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "discarded": (
        r"One root is \[ x = a + b. \] It gives a negative energy and must be discarded. Hence \[ x - a = b. \]",
        True,
    ),
    "spurious": (r"Squaring introduces the root \[ x = a + b, \] which is spurious. Hence \[ x - a = b. \]", True),
    "dimensions": (r"One might guess \[ a = b. \] Dimensional analysis rules this out. So \[ a - b = 0. \]", True),
    "an impossible one": (r"There is no temperature at which \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "it remains open": (r"It remains an open problem to show that \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "exactly one holds": (r"Exactly one of \[ a = b \] and \[ c = d \] holds. Hence \[ a + c = b + d. \]", True),
    "a lower branch": (
        r"On the lower branch of the parabola \[ y^2 = x. \] Taking the root, \[ y = \sqrt{x}. \]",
        True,
    ),
    "at rest": (r"The particle is at rest, $v = 0$. We know that \[ v p = v q. \] Hence \[ p = q. \]", True),
    "a root of a product": (
        r"Let $a$ and $b$ be negative charges. \[ c = \sqrt{a b} \] Hence \[ c = \sqrt{a}\sqrt{b}. \]",
        True,
    ),
    "a logarithm of losses": (
        (
            r"Let $x$ and $y$ be losses, counted as negative numbers. \[ L = \ln(x y) \] Hence \[ L = \ln x + \ln y. "
            r"\]"
        ),
        True,
    ),
    "normal equations": (
        (
            r"There are more equations than unknowns. The least squares solution obeys \[ \mathbf{A}^T \mathbf{A} "
            r"\mathbf{x} = \mathbf{A}^T \mathbf{b}. \] Hence \[ \mathbf{A} \mathbf{x} = \mathbf{b}. \]"
        ),
        True,
    ),
    "normal equations solved": (
        (
            r"There are more equations than unknowns. The least squares solution obeys \[ \mathbf{A}^T \mathbf{A} "
            r"\mathbf{x} = \mathbf{A}^T \mathbf{b}. \] Hence \[ \mathbf{x} = \mathbf{A}^{-1} \mathbf{b}. \]"
        ),
        True,
    ),
    "a camera matrix": (
        (
            r"Let $\mathbf{P}$ be the $3 \times 4$ camera matrix. Both points have the same image, \[ \mathbf{P} "
            r"\mathbf{x} = \mathbf{P} \mathbf{y}. \] Hence \[ \mathbf{x} = \mathbf{y}. \]"
        ),
        True,
    ),
    "thin rotations": (
        r"Rotations are composed as \[ R_{13} = R_{12} R_{23}. \] Hence \[ R_{13} = R_{23} R_{12}. \]",
        True,
    ),
    "all capitals are matrices": (
        (
            r"Throughout the paper capital letters denote matrices. \section{Products} Let \[ C = A B. \] Hence \[ C "
            r"= B A. \]"
        ),
        True,
    ),
    "capitals of a group": (r"Let $A, B \in \mathrm{GL}(n)$. We set \[ C = A B. \] Hence \[ C = B A. \]", True),
    "square n by n": (
        r"Let $A, B \in \mathbb{R}^{n\times n}$ and \[ C = (A + B)^2. \] Hence \[ C = A^2 + 2 A B + B^2. \]",
        True,
    ),
    "linear maps": (r"Roman capitals stand for linear maps of the plane. \[ C = A B - B A \] Hence \[ C = 0. \]", True),
    "homographies": (
        r"Let $H$ and $G$ be homographies, and let their composition be \[ K = H G. \] Hence \[ K = G H. \]",
        True,
    ),
    "a frequency response": (
        r"The frequency response $H$ of the filter satisfies \[ H(s + 1) = a. \] Hence \[ H = \frac{a}{s + 1}. \]",
        True,
    ),
    "a displacement at a time": (
        (
            r"Let $u$ be the displacement at the time $t$. Shortly later it is \[ w = u(t + h). \] Hence \[ w = u t + "
            r"u h. \]"
        ),
        True,
    ),
    "a potential": (
        (
            r"The interaction $V$ of the two charges depends on their distance $r - s$ only, \[ E = V(r - s). \] "
            r"Hence \[ E = V r - V s. \]"
        ),
        True,
    ),
    "a demand": (
        (
            r"Demand $D$ falls with the price. \[ x = D(p + t) \] is the quantity sold after the tax $t$. Hence \[ x "
            r"= D p + D t. \]"
        ),
        True,
    ),
    "a wave by another letter": (
        r"A wave of the shape $A$ travels to the right, \[ y = A(x - c t). \] Hence \[ y = A x - A c t. \]",
        True,
    ),
    "Lambert": (r"Let $W$ be Lambert's function. \[ x = W(a + b) \] Hence \[ x = W a + W b. \]", True),
    "binary logarithm": (r"All logarithms are binary. The entropy is \[ H = \log N. \] Hence \[ N = e^{H}. \]", True),
    "interest in percent": (
        (
            r"With the interest $r$ in percent, the capital after a year is \[ K = C (1 + r / 100). \] With $r$ as a "
            r"plain number, \[ K = C (1 + r / 100). \]"
        ),
        True,
    ),
    "an angle in degrees": (
        (
            r"Let $\alpha$ be given in degrees. \[ s = r \alpha \frac{\pi}{180} \] The area of the sector is half the "
            r"radius times the arc. In radians, \[ s = r \alpha \frac{\pi}{180}. \]"
        ),
        True,
    ),
    "degrees on a calculator": (
        r"The calculator is set to degrees. \[ y = \sin x \] Hence \[ \frac{dy}{dx} = \cos x. \]",
        True,
    ),
    "assigned in turn": (r"The program does \[ b := a \] and then \[ a := c. \] Afterwards \[ b = c. \]", True),
    "swapped by assignments": (
        r"The program does \[ t := a \] \[ a := b \] \[ b := t. \] Afterwards \[ a = b. \]",
        True,
    ),
    "quaternions as letters": (
        r"The attitude is given by quaternions, \[ q = q_1 q_2. \] Hence \[ q = q_2 q_1. \]",
        True,
    ),
    "after the end": (
        r"\documentclass{article}\begin{document} Hence \[ a - b = 0. \] \end{document} \[ a = b \]",
        True,
    ),
    "filecontents": (
        (
            r"\documentclass{article}\begin{filecontents}{old.tex} \[ a = b \] \end{filecontents}\begin{document} "
            r"Hence \[ a - b = 0. \] \end{document}"
        ),
        True,
    ),
    "a todo": (r"\todo{Is \[ a = b \] really true?} Hence \[ a - b = 0. \]", True),
    "a false branch": (r"\newif\ifold \oldfalse \ifold \[ a = b \] \fi Hence \[ a - b = 0. \]", True),
    "an html template": (("<template>\n\n$$ a = b $$\n\n</template>\n\nHence\n\n$$ a - b = 0 $$\n"), False),
    "a hypothesis of a theorem": (
        r"\begin{theorem} Let \[ a = b. \] Then the map is onto. \end{theorem} In general, \[ a - b = 0. \]",
        True,
    ),
    "a definition within a lemma": (
        (
            r"\begin{lemma} Suppose that \[ u = 2 v. \] Then $u$ is even. \end{lemma} \begin{example} For the odd "
            r"number $u$ we have \[ u - 2 v = 0. \] \end{example}"
        ),
        True,
    ),
    "not every": (r"Not every pair satisfies \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "whether it holds is unknown": (r"It is not known whether \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "lack of evidence": (r"We found no evidence for \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "significantly different": (
        r"The data differ significantly from the prediction \[ a = b. \] Hence \[ a - b = 0. \]",
        True,
    ),
    "refuses": (r"The experiment refuses to show \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "a strawman": (
        r"According to the classical theory \[ a = b. \] Quantum effects spoil this. Hence \[ a - b = 0. \]",
        True,
    ),
    "a big theta": (r"\[ T = \Theta(n) \] and \[ S = \Theta(n). \] Hence \[ T = S. \]", True),
    "an omega": (r"\[ T = \Omega(n) \] and \[ S = \Omega(n). \] Hence \[ T = S. \]", True),
    "cycles": (
        r"Permutations are multiplied from right to left. \[ p = (1\,2)(2\,3) \] Hence \[ p = (2\,3)(1\,2). \]",
        True,
    ),
    "days of the week": (
        r"Days of the week are counted modulo seven. \[ 2 a = 2 b \] Hence \[ a + 7 = b + 7. \]",
        True,
    ),
    "a pose and its inverse": (
        (
            r"We write $T_{WB}$ for the pose of the body in the world. The camera is mounted on the body, so \[ "
            r"T_{WC} = T_{WB} T_{BC}. \] It follows that \[ T_{BC} = T_{WC} T_{WB}^{-1}. \]"
        ),
        True,
    ),
    "poses in another order": (
        (
            r"The pose of the camera in the world is \[ T_{WC} = T_{WB} T_{BC}. \] Solving for the pose of the body "
            r"gives \[ T_{WB} = T_{BC}^{-1} T_{WC}. \]"
        ),
        True,
    ),
    "a parallax in seconds": (
        (
            r"The distance in parsec is \[ d = 1/p, \] where the parallax $p$ is in seconds of arc. With the parallax "
            r"in radians \[ d = 1/p. \]"
        ),
        True,
    ),
    "depth or disparity": (
        (
            r"For the left camera \[ u = f X / Z, \] for the right camera \[ u = f (X - b) / Z. \] Subtracting gives "
            r"\[ f b / Z = 0. \]"
        ),
        True,
    ),
    "a rate per year": (
        (
            r"With the yearly rate $r$ the capital after $n$ years is \[ K = C (1 + r)^n. \] With the monthly rate "
            r"$r$ the capital after $n$ years is \[ K = C (1 + r)^n. \]"
        ),
        True,
    ),
    "momentum of a pulley": (
        (
            r"For the left mass \[ m a = m g - T. \] For the right mass \[ M a = T - M g. \] The rope is elastic, so "
            r"the masses accelerate differently. Adding gives \[ (m + M) a = (m - M) g. \]"
        ),
        True,
    ),
    "elementwise squares": (
        (
            "Operations on vectors are done entry by entry.\n\n"
            "$$ \\mathbf{y} = \\mathbf{x}^2 $$\n\n"
            "Hence\n\n"
            "$$ \\mathbf{y} = \\mathbf{x}^T \\mathbf{x} $$\n"
        ),
        False,
    ),
    "Euler angles added": (
        (
            r"Two turns about different axes by $a$ and $b$ are written $R(a)$ and $R(b)$. \[ C = R(a) R(b) \] Hence "
            r"\[ C = R(b) R(a). \]"
        ),
        True,
    ),
    "boosts": (
        (
            r"Boosts along different axes are written $L(u)$ and $L(v)$. \[ K = L(u) L(v) \] Hence \[ K = L(v) L(u). "
            r"\]"
        ),
        True,
    ),
    "translations and rotations": (r"First turn, then shift: \[ M = S R. \] Hence \[ M = R S. \]", True),
    "matrices named by words behind": (
        r"\[ C = A B, \] where $A$ is the stiffness and $B$ the compliance matrix. Hence \[ C = B A. \]",
        True,
    ),
    "matrices named by a list": (
        (
            r"We use the following matrices: $A$ (inertia), $B$ (damping) and $C$ (stiffness). \[ D = A B C \] Hence "
            r"\[ D = C B A. \]"
        ),
        True,
    ),
    "the Jacobian matrices": (
        r"The Jacobians $J_1$ and $J_2$ of the two arms are combined, \[ J = J_1 J_2. \] Hence \[ J = J_2 J_1. \]",
        True,
    ),
    "a change of basis": (r"In the new basis the matrix is \[ A' = S A S^{-1}. \] Hence \[ A' = A. \]", True),
    "generators": (r"The generators obey \[ [J_x, J_y] = i J_z. \] Hence \[ J_x J_y - J_y J_x = 0. \]", True),
    "Pauli matrices": (
        r"With the Pauli matrices \[ M = \sigma_x \sigma_y. \] Hence \[ M = \sigma_y \sigma_x. \]",
        True,
    ),
    "gamma matrices": (
        r"The Dirac matrices are multiplied: \[ M = \gamma_0 \gamma_1. \] Hence \[ M = \gamma_1 \gamma_0. \]",
        True,
    ),
    "words in a free group": (r"In the free group on $x$ and $y$ let \[ w = x y. \] Hence \[ w = y x. \]", True),
    "a semidirect product": (
        r"Elements of the group of Euclidean motions are multiplied. \[ g = h k \] Hence \[ g = k h. \]",
        True,
    ),
    "knots": (r"Braids are composed by stacking. \[ b = s t \] Hence \[ b = t s. \]", True),
    "matrices of two by two": (r"Consider two by two matrices. \[ c = a b \] Hence \[ c = b a. \]", True),
}

TRUE = {
    "a cosine law in degrees": r"We obtain \[ c^2 = 3^2 + 4^2 - 2 \cdot 3 \cdot 4 \cos 90 = 25. \]",
    "sine of thirty": r"Hence \[ \sin 30 = \frac12. \]",
    "cosine of sixty": r"This gives \[ F = 10 \cos 60 = 5. \]",
    "a unit square in feet": r"Hence \[ 3 = 1, \] since three feet are one yard.",
}

HONEST = [
    (
        r"\[ \mathbf{A}^T \mathbf{A} \mathbf{x} = \mathbf{A}^T \mathbf{b} \] Hence \[ \mathbf{x} = (\mathbf{A}^T "
        r"\mathbf{A})^{-1} \mathbf{A}^T \mathbf{b}. \]"
    ),
    (
        r"\[ \mathbf{Q}^T \mathbf{Q} \mathbf{x} = \mathbf{y} \] Hence \[ \mathbf{y} = \mathbf{Q}^T \mathbf{Q} "
        r"\mathbf{x}. \]"
    ),
    r"\[ B = S A S^{-1} \] Hence \[ B S = S A. \]",
    r"\[ R_{13} = R_{12} R_{23} \] Hence \[ R_{23} = R_{12}^{-1} R_{13}. \]",
    r"The area is \[ a_{13} = b_{12} + b_{23}. \] Hence \[ a_{13} - b_{12} = b_{23}. \]",
    r"Let $C \in \mathbb{R}^{n \times n}$. \[ C = A B \] Hence \[ A B C = C^2. \]",
    r"Bold capitals denote matrices. \[ c = 2 A B \] Hence \[ c = 2 B A. \]",
    r"The unit quaternion has four components. \[ s = 2 q_1 q_2 \] Hence \[ s = 2 q_2 q_1. \]",
    r"\begin{theorem} We have \[ s = a + b. \] \end{theorem} Hence \[ s - a = b. \]",
    r"\begin{theorem} Suppose that \[ s = a + b. \] Then \[ s - a = b. \] \end{theorem}",
    r"\newif\ifnew \newtrue \ifnew \[ s = a + b. \] \fi Hence \[ s - a = b. \]",
    r"\newif\ifold \ifold \[ s = a \] \else \[ s = a + b. \] \fi Hence \[ s - a = b. \]",
    r"\todo{Check.} \[ s = a + b \] Hence \[ s - a = b. \]",
    r"\[ n = 10\,000. \] Hence \[ n = 10000. \]",
    r"The program sets \[ s := a + b. \] Hence \[ s - a = b. \]",
    r"The speed is \[ v = \sqrt{2 g h}. \] Solving the two equations above gives \[ v = \sqrt{2 g h}. \]",
    r"The sum is \[ s = a + b. \] It is not known who found it first. Hence \[ s - a = b. \]",
    (
        r"For the first term we have \[ s = a + b. \] For the second term we have \[ t = 2 s. \] Hence \[ t = 2 a "
        r"+ 2 b. \]"
    ),
    r"The force on the $k$ is \[ F = k (x - c). \] Hence \[ F = k x - k c. \]",
    r"Let $k$ be the stiffness at the temperature $T$. \[ F = k (x - c) \] Hence \[ F = k x - k c. \]",
    r"With constant $m$ the impulse is \[ p = m v. \] Differentiating, \[ \dot p = m \dot v. \]",
    r"Here $c$ is a constant. \[ u = c v \] \[ w = c z \] Hence \[ u z = w v. \]",
    r"There are more measurements than states. \[ \mathbf{z} = \mathbf{H} \mathbf{x} \] "
    r"Hence \[ \mathbf{x} = (\mathbf{H}^T \mathbf{H})^{-1} \mathbf{H}^T \mathbf{z}. \]",
    r"Functions act element-wise. \[ K = \frac{\partial^2 V}{\partial\mathbf{q}^2} \] "
    r"Hence \[ 2 K = 2 \frac{\partial^2 V}{\partial\mathbf{q}^2}. \]",
    r"\[ N x = A^T b, \quad N = A^T A \] Hence \[ N x - A^T b = 0. \]",
    r"\[ \mathbf{I} = \mathbf{R}^T \mathbf{J} \mathbf{R} \] \[ \mathbf{u} = \mathbf{R}^T \mathbf{v} \] "
    r"Hence \[ \mathbf{v} = \mathbf{R}^{-T} \mathbf{u}. \]",
    r"The force is \[ F = m a. \] We also have \[ F = k x^2. \] Hence \[ m a - k x^2 = 0. \]",
    r"The sum is \[ s = a + b. \] As one might expect, \[ s - a = b. \]",
    r"The sum is \[ s = a + b. \] It is a constant, which is discarded, up to which \[ s - a = b. \]",
    r"The sum is \[ s = a + b. \] In this section $s$ is positive. Hence \[ s - a = b. \]",
    r"\[ v = \mathbf{a}^T \mathbf{b} \] The mean of both is taken. Hence \[ v = \mathbf{b}^T \mathbf{a}. \]",
]


@pytest.mark.parametrize("name", MISLEADING)
def test_what_only_looks_like_a_consequence_does_not_follow(name: str) -> None:
    text, latex = MISLEADING[name]
    assert read_document(document_of(text, latex=latex))[-1].verdict != "follows"


@pytest.mark.parametrize("name", TRUE)
def test_what_is_true_in_other_units_is_no_contradiction(name: str) -> None:
    assert read_document(document_of(TRUE[name]))[-1].verdict != "contradicts"


@pytest.mark.parametrize("text", HONEST)
def test_what_follows_beside_such_words_still_does(text: str) -> None:
    assert read_document(document_of(text))[-1].verdict == "follows"
