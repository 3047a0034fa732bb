r"""Documents of an outsider that were misread: what only looks like a consequence, or like a contradiction."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

MISLEADING = {
    "unequal in code": ("The two keys differ:\n\n$$ a != b $$\n\nHence\n\n$$ b = a! $$\n", False),
    "equal in distribution": (
        r"Both throws have the same law, \[ X \stackrel{d}{=} Y. \] Hence \[ X - Y = 0. \]",
        True,
    ),
    "dotted equality": (r"To first order \[ u \doteq v. \] Hence \[ u - v = 0. \]", True),
    "equal in the limit, over the sign": (
        r"For the sequence \[ a_n \overset{n\to\infty}{=} a. \] Hence \[ a_n - a = 0. \]",
        True,
    ),
    "negated by a text": (r"We know that \[ \text{not } a = b. \] Hence \[ a - b = 0. \]", True),
    "a jump": (
        r"Across the shock the jump is \[ j = \llbracket u v \rrbracket. \] Hence \[ j = u \llbracket v \rrbracket. \]",
        True,
    ),
    "a Fourier transform in braces": (r"Let \[ Y = \mathcal{F}\{x h\}. \] Hence \[ Y = \mathcal{F}\{x\}\, h. \]", True),
    "samples in round brackets": (r"The first sample is \[ x(1) = a. \] The second sample is \[ x(2) = 2a. \]", True),
    "polar coordinates": (
        r"The temperature of the plate is \[ T(x, y) = k (x^2 + y^2). \] In polar coordinates it is "
        r"\[ T(r, \theta) = k (r^2 + \theta^2). \]",
        True,
    ),
    "a product that is zero": (r"Since $a$ vanishes, $a = 0$. Then \[ a b = a c. \] Hence \[ b = c. \]", True),
    "a conjugate": (r"A bar is the complex conjugate. \[ w = \bar z + z \] Hence \[ \frac{dw}{dz} = 1. \]", True),
    "strings": (r"The product of two strings is their concatenation. \[ w = u v \] Hence \[ w = v u. \]", True),
    "permutations": (r"Let $s$ and $t$ be permutations. \[ c = s t \] Hence \[ c = t s. \]", True),
    "operators with hats": (
        r"The operators of place and momentum give \[ D = \hat x \hat p - \hat p \hat x. \] Hence \[ D = 0. \]",
        True,
    ),
    "a metric and its inverse": (
        r"The metric and its inverse satisfy \[ g_{ij} g^{jk} = \delta_i^k. \] Hence \[ g^{jk} = "
        r"\frac{\delta_i^k}{g_{ij}}. \]",
        True,
    ),
    "a linear map by entries": (
        r"The matrix $A = (a_{ij})$ maps $x$ to \[ y_i = a_{ij} x_j. \] Hence \[ x_j = \frac{y_i}{a_{ij}}. \]",
        True,
    ),
    "a current": (r"Ohm's law is \[ U = R I. \] Hence \[ U = R. \]", True),
    "angles by three points": (r"The line bisects the angle, \[ \angle PQR = \angle RQS. \] Hence \[ P = S. \]", True),
    "the pH": (r"The solution has \[ pH = pK. \] Hence \[ H = K. \]", True),
    "scientific notation": ("The count is\n\n$$ n = 1e3 $$\n\nHence\n\n$$ n = 3e $$\n", False),
    "scientific notation with a minus": ("The step is\n\n$$ h = 10e-3 $$\n\nHence\n\n$$ h + 3 = 10e $$\n", False),
    "a power that is exclusive or": (
        "As in C, `^` is the exclusive or:\n\n$$ y = a^2 $$\n\nHence\n\n$$ y = a a $$\n",
        False,
    ),
    "binary numbers": (r"The numbers here are binary. \[ n = 10 \] Hence \[ 2n = 20. \]", True),
    "a mixed number": (r"The rod has the length \[ l = 2\frac12. \] Hence \[ l = 1. \]", True),
    "pi is 3.14": (r"With \[ \pi = 3.14 \] we get \[ a\pi = 3.14 a. \]", True),
    "the parallax": (r"A star with the parallax $\pi$ moves by \[ w = \cos 2\pi. \] Hence \[ w = 1. \]", True),
    "a macro in a group": (r"\def\x{a} {\def\x{b}} The value is \[ y = \x. \] Hence \[ y = b. \]", True),
    "provided, and there already": (
        r"\newcommand{\x}{a} \providecommand{\x}{b} The value is \[ y = \x. \] Hence \[ y = b. \]",
        True,
    ),
    "an example environment": (
        r"The sum is \[ s = a + b. \] \begin{example} Let $b = 0$. Then all is clear. \end{example} Hence \[ s = a. \]",
        True,
    ),
    "an indented block of code": ("We type\n\n    $$ a = b $$\n\nHence\n\n$$ a - b = 0 $$\n", False),
    "a warning box": (
        "The sum is\n\n$$ s = a + b $$\n\n:::{warning}\nDo not set $b = 0$.\n:::\n\nHence\n\n$$ s = a $$\n",
        False,
    ),
    "a quotation of another": (
        "Aristotle held:\n\n> $$ v = k m $$\n\nGalileo refuted this. Hence\n\n$$ \\frac{v}{m} = k $$\n",
        False,
    ),
    "students": (r"Students often write \[ (a + b)^2 = a^2 + b^2. \] Hence \[ 2 a b = 0. \]", True),
    "find the error": (r"Find the error: \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "a conjecture displayed": (r"\textbf{Conjecture.} \[ a = b \] Hence \[ a - b = 0. \]", True),
    "a goal": (r"We want to show that \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "nobody": (r"Nobody has ever measured \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "wrongly": (r"Wolf wrongly states \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "a folk formula": (r"The folk formula \[ a = b \] is off by a factor. Hence \[ a - b = 0. \]", True),
    "not always": (r"It is not always the case that \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "fails": (r"The law \[ a = b \] fails at high speed. At high speed \[ a - b = 0. \]", True),
    "up to a constant": (r"\[ u = f \] up to a constant. Hence \[ u - f = 0. \]", True),
    "on average": (r"On average \[ u = f. \] Hence \[ u - f = 0. \]", True),
    "to leading order behind": (r"\[ u = f \] to leading order. Hence \[ u - f = 0. \]", True),
    "roughly behind": (r"\[ u = f, \] roughly. Hence \[ u - f = 0. \]", True),
    "plus noise behind": (r"\[ u = f \] plus some noise. \[ v = f \] plus some noise. Hence \[ u = v. \]", True),
    "almost everywhere": (r"Almost everywhere \[ u = f. \] At the point in question \[ u - f = 0. \]", True),
    "a wish": (r"Ideally \[ u = f. \] Hence \[ u - f = 0. \]", True),
    "a contradiction is sought": (
        r"Assume the opposite, \[ p = 2q. \] We shall find a contradiction. \[ p - q = q \]",
        True,
    ),
    "imagine": (r"Imagine that \[ a = b. \] It is not so. \[ a - b = 0 \]", True),
    "a joke": (r"An old joke has it that \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "the first attempt": (r"Our first attempt was \[ a = b. \] It did not work. \[ a - b = 0 \]", True),
    "a quote environment": (
        r"\begin{quote} Aristotle: \[ v = k m. \] \end{quote} Galileo found otherwise. \[ \frac{v}{m} = k \]",
        True,
    ),
    "a new b": (r"The area is \[ s = a b. \] From now on we write $b$ for $2b$. Then \[ s = a b. \]", True),
    "another meaning": (
        r"The area is \[ s = a b. \] In this paragraph $b$ has another meaning: it is half the width. \[ s = a b \]",
        True,
    ),
    "a sign replaced": (r"The curve is \[ y = x^3 + 1. \] Replacing $x$ by $-x$ gives \[ y = x^3 + 1. \]", True),
    "swapped": (r"The ratio is \[ y = a/b. \] Swapping $a$ and $b$ gives \[ y = a/b. \]", True),
    "doubled": (r"The area is \[ s = a b. \] After doubling $b$ the area is \[ s = a b. \]", True),
    "rescaled": (r"The way is \[ x = v t. \] We measure $t$ in minutes from here on. Then \[ x = v t. \]", True),
    "densities": (r"The densities are $p(x)$ and $p(y)$. \[ p(x) = 2x \] Hence \[ p(y) = 2y. \]", True),
    "a logarithm of a square": (r"\[ u = \ln x^2, \] where $x$ may be negative. Hence \[ u = 2 \ln x. \]", True),
    "a primed sum": (
        r"A prime at the sum says that the first term is halved, \[ S = \sum_{i=0}^n{}' a. \] Hence \[ S "
        r"= (n+1) a. \]",
        True,
    ),
    "a cited equation that is another one": (
        r"\begin{equation} a = b \end{equation} \section{Here} \[ x = 1 \] \[ y = 2 \] Unlike in (1), \[ "
        r"2a = 2b. \]",
        True,
    ),
    "two opinions": (r"In my opinion \[ h - a = 0. \] In her opinion \[ h - b = 0. \] Hence \[ a = b. \]", True),
    "two observers": (r"Alice measures \[ h - a = 0. \] Bob measures \[ h - b = 0. \] Hence \[ a = b. \]", True),
    "two bodies": (r"A sphere has \[ h - a = 0. \] A cylinder has \[ h - b = 0. \] Hence \[ a = b. \]", True),
    "two years": (r"In 1990 \[ h - a = 0. \] In 2000 \[ h - b = 0. \] Hence \[ a = b. \]", True),
    "two particles": (r"For protons \[ h - a = 0. \] For electrons \[ h - b = 0. \] Hence \[ a = b. \]", True),
    "two items": (r"\item Sphere: \[ h - a = 0. \] \item Cube: \[ h - b = 0. \] Hence \[ a = b. \]", True),
    "a rumour": (r"Rumour has it that \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "a bug": (r"The old code had the bug \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "what is doubtful": (r"It is doubtful that \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "opponents": (r"Our opponents hold \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "what happens sometimes": (r"Sometimes \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "large and small samples": (r"For large samples \[ a = b. \] For small samples \[ a - b = 0. \]", True),
    "exchanged roles": (
        r"The ratio is \[ r = a/b. \] With the roles of $a$ and $b$ exchanged, \[ r = a/b. \]",
        True,
    ),
    "a numbered iterate": (
        r"Let $x^k$ be the $k$-th iterate. \[ x^2 = a x^1 + b \] Hence \[ x^2 = a x + b. \]",
        True,
    ),
    "a matrix exponential": (
        r"Let $A(t)$ be a matrix. \[ \Phi = e^{A} \] Hence \[ \dot\Phi = \dot A e^{A}. \]",
        True,
    ),
    "a square of a matrix of time": (
        r"Let $A(t)$ be a matrix. \[ B = A^2 \] Hence \[ \dot B = 2 A \dot A. \]",
        True,
    ),
    "no full rank": (
        r"The matrix $\mathbf A$ does not have full rank. \[ \mathbf A \mathbf x = \mathbf b \] Hence "
        r"\[ \mathbf x = \mathbf A^{-1} \mathbf b. \]",
        True,
    ),
    "rank two": (
        r"The matrix $\mathbf E$ has rank two. \[ \mathbf E \mathbf x = \mathbf l \] Hence "
        r"\[ \mathbf x = \mathbf E^{-1} \mathbf l. \]",
        True,
    ),
    "a projection": (
        r"Let $\mathbf P$ be a projection matrix. \[ \mathbf P \mathbf x = \mathbf P \mathbf y \] Hence "
        r"\[ \mathbf x = \mathbf y. \]",
        True,
    ),
    "a left inverse": (
        r"\[ \mathbf L \mathbf A = \mathbf I \] where $\mathbf A$ is tall. Hence \[ \mathbf A \mathbf L = \mathbf I \]",
        True,
    ),
    "zero divisors": (
        r"Let $A$ and $B$ be matrices with \[ A B = 0. \] If $A$ is not zero, then \[ B = 0. \]",
        True,
    ),
    "a product with its own letter that is zero": (r"\[ x (x - a) = 0 \] Hence \[ x = a. \]", True),
    "a sum on both sides": (r"\[ (s - m) x = (s - m) y \] Hence \[ x = y. \]", True),
    "an eigenvector": (r"\[ (\mathbf A - l \mathbf I) \mathbf v = 0 \] Hence \[ \mathbf v = 0. \]", True),
    "a sum of matrices on both sides": (
        r"\[ (\mathbf A - \mathbf B) \mathbf X = (\mathbf A - \mathbf B) \mathbf Y \] So \[ \mathbf X = \mathbf Y \]",
        True,
    ),
    "a sum of matrices behind both sides": (
        r"\[ \mathbf S (\mathbf X - \mathbf Y) = \mathbf M (\mathbf X - \mathbf Y) \] So \[ \mathbf S = \mathbf M \]",
        True,
    ),
    "a product of sums that is zero": (r"\[ (x - a)(y - b) = 0 \] Hence \[ x = a. \]", True),
    "what is enough": (r"It is enough that \[ a = b. \] Hence \[ a - b = 0. \]", True),
    "a letter defined again": (
        r"\[ r = a + b \] In what follows we redefine $r$ as another radius. Hence \[ r - a = b. \]",
        True,
    ),
    "now let": (r"\[ r = a + b \] Now let $r = a - b$. Hence \[ r - a = b. \]", True),
    "let it be something else in the next section": (
        r"\section{One} \[ c = a + b \] \section{Two} Let $c$ be the speed of light. Then \[ c - a = b. \]",
        True,
    ),
    "the other branch of a switch": (
        "\\iftrue\n\\[ g = a - b \\]\n\\else\n\\[ g = a + b \\]\n\\fi\nHence \\[ g - a = b. \\]",
        True,
    ),
    "a macro in a group by words": (
        r"\newcommand{\V}{a} \begingroup \renewcommand{\V}{b} \endgroup \[ y = \V \] Hence \[ y = b. \]",
        True,
    ),
    "a macro in an environment": (
        r"\newcommand{\V}{a} \begin{center} \def\V{b} \[ y = \V \] \end{center} Hence \[ y = \V. \]",
        True,
    ),
    "a demand over the sign": (r"We want \[ y \overset{!}{=} a. \] It turns out that \[ y - a = 0. \]", True),
    "a named point": (r"At the point $P$ we have \[ u = a. \] At the point $Q$ therefore \[ u - a = 0. \]", True),
    "steady and transient": (
        r"In the steady state \[ u = R c. \] During the transient it follows that \[ u - R c = 0. \]",
        True,
    ),
    "at rest and in motion": (r"At rest \[ F = k x. \] In motion we have therefore \[ F - k x = 0. \]", True),
    "compressible flow": (
        r"For incompressible flow \[ p + q = c. \] For compressible flow it follows that \[ p = c - q. \]",
        True,
    ),
    "front matter": ("---\ntitle: $y = a + b$\n---\n\nHence\n\n$$ y - a = b. $$", False),
    "a moving support": (
        r"\[ E = \frac12 k (x - s)^2 \] where the support $s$ moves. Hence \[ \dot E = k (x - s) \dot x. \]",
        True,
    ),
    "a macro defined for all groups": (
        r"\def\x{a} {\gdef\x{b}} The length is \[ l = 2\x. \] Hence \[ l = 2 a. \]",
        True,
    ),
    "a macro copied for all groups": (
        r"\newcommand{\x}{a} \newcommand{\z}{b} {\global\let\x\z} \[ l = 2\x \] Hence \[ l = 2 a. \]",
        True,
    ),
    "macros exchanged": (
        r"\newcommand{\p}{a} \newcommand{\q}{b} \let\tmp\p \let\p\q \let\q\tmp "
        r"\[ s = \p + 2\q \] Hence \[ s = a + 2 b. \]",
        True,
    ),
    "a test of TeX": (r"\ifnum 1>2 \[ k = a b. \] \fi The load is \[ q = k c. \] Hence \[ q = a b c. \]", True),
    "deleted": (r"\deleted{We have \[ k = a b. \]} The load is \[ q = k c. \] Hence \[ q = a b c. \]", True),
    "replaced": (
        r"\replaced{No \[ k = a + b. \]}{We have \[ k = a b. \]} The load is \[ q = k c. \] Hence \[ q = a b c. \]",
        True,
    ),
    "an excluded version": (
        r"\excludeversion{old} \begin{old} \[ k = a b. \] \end{old} The load is \[ q = k c. \] Hence \[ q = a b c. \]",
        True,
    ),
    "a tag that denies": (r"\[ k = a b \tag{wrong} \] The load is \[ q = k c. \] Hence \[ q = a b c. \]", True),
    "two models in one display": (
        r"\begin{align} \text{Model A:}\quad k &= a b \\ \text{Model B:}\quad q &= k c \end{align} Hence "
        r"\[ q = a b c. \]",
        True,
    ),
    "words below a brace": (
        r"\[ \underbrace{k = a b}_{\text{wrong}} \] The load is \[ q = k c. \] Hence \[ q = a b c. \]",
        True,
    ),
    "an emphasised condition": (
        r"\[ k = a b \] \emph{only if} the rod is soft. The load is \[ q = k c. \] Hence \[ q = a b c. \]",
        True,
    ),
    "operators before kets": (
        r"\[ |\phi\rangle = A |\psi\rangle, \quad |\chi\rangle = B |\phi\rangle \] Hence "
        r"\[ |\chi\rangle = A B |\psi\rangle. \]",
        True,
    ),
    "a list of vertices": (r"The vertices are $p^1, p^2, p^3$. \[ e = p^2 - p^1 \] Hence \[ e = p (p - 1). \]", True),
    "a substitution by an arrow": (r"\[ y = x^2 + 1 \] After $x \to x + 1$ we have \[ y = x^2 + 1. \]", True),
    "degrees in brackets": (
        r"Let $\varphi$ [deg] be the latitude. \[ x = \cos\varphi \] Hence \[ \frac{dx}{d\varphi} = -\sin\varphi. \]",
        True,
    ),
    "degrees in a table": (
        "| $\\varphi$ | degrees |\n\n$$ x = \\cos\\varphi $$\n\nHence\n\n"
        "$$ \\frac{dx}{d\\varphi} = -\\sin\\varphi $$\n",
        False,
    ),
    "gon": (
        r"The direction $\varphi$ is measured in gon. \[ x = \cos\varphi \] Hence "
        r"\[ \frac{dx}{d\varphi} = -\sin\varphi. \]",
        True,
    ),
    **{
        f"behind an empty line: {words}": (
            f"{lead}\n\n$$ k = a b $$\n\n{words}\n\nThe load is\n\n$$ q = k c $$\n\nHence\n\n$$ q = a b c $$\n",
            False,
        )
        for lead, words in (
            ("To write", "would be wrong."),
            ("The equation", "is false."),
            ("We have", "if the rod is long. A short rod has no stiffness."),
            ("We have", "up to a factor."),
        )
    },
}

TRUE = {
    "another unit behind an empty line": "The price is\n\n$$ p := 3 $$\n\nThis gives\n\n$$ p = 300 $$\n\nin cents.\n",
    "a case behind an empty line": "The sum is\n\n$$ s := a + b $$\n\nHence\n\n"
    "$$ s^2 = a^2 - 2ab + b^2 $$\n\nif $b = 0$.\n",
    "a case in a tag": r"The sum is \[ s := a + b. \] Hence \[ s^2 = a^2 - 2 a b + b^2 \tag{for $b = 0$} \]",
    "a clock of twelve hours": r"On the clock, nine and five are two. So the equation gives \[ 9 + 5 = 2. \]",
    "binary": r"The numbers are binary. Adding gives \[ 1 + 1 = 10. \]",
    "two elements": r"In the field of two elements \[ 1 + 1 = 0. \]",
    "saturation": r"Bytes saturate. Adding gives \[ 200 + 100 = 255. \]",
    "overflow": r"Bytes wrap around. Adding gives \[ 255 + 1 = 0. \]",
    "tropical": r"In tropical arithmetic \[ 3 + 3 = 3. \]",
    "thousands": r"The number of points is \[ 1,000 = 10^3. \]",
    "quoted nonsense": r"Dividing by zero one would get the absurd \[ 1 = 2. \]",
    "Orwell": r"Winston had to believe that \[ 2 + 2 = 5. \]",
    "a full turn": r"The direction is \[ \theta = 270^\circ = -90^\circ. \]",
    "half a turn": r"The direction is \[ \theta = \pi = -\pi. \]",
    "an argument": r"The phase is \[ \phi = \frac{3\pi}{2} = -\frac{\pi}{2}. \]",
    "thin vectors": r"The area vector is \[ c = a \times b = -b \times a. \]",
    "Grassmann numbers": r"The Grassmann numbers give \[ c = a b = -b a. \]",
    "a substituted sign": r"The sum is \[ s = a + b. \] Substituting $-b$ for $b$ gives \[ s = a - b. \]",
}


@pytest.mark.parametrize("name", MISLEADING)
def test_what_only_looks_like_a_consequence_does_not_follow(name: str) -> None:
    text, latex = MISLEADING[name]
    assert read_document(document_of(text, latex=latex))[-1].verdict != "follows"


@pytest.mark.parametrize("name", TRUE)
def test_what_is_true_of_another_arithmetic_or_sign_is_no_contradiction(name: str) -> None:
    assert read_document(document_of(TRUE[name], latex="$$" not in TRUE[name]))[-1].verdict != "contradicts"


@pytest.mark.parametrize(
    "latex",
    [
        r"Replacing $x$ by $y$ is allowed. \[ s = a + b \] Hence \[ s - a = b. \]",
        r"\\[0.3em] The sum is \[ s = a + b. \] Hence \[ s - a = b. \]",
        r"\[ f(x) = x^2 \] Hence \[ f(y) = y^2. \]",
        r"\[ p(x) = a x \] Hence \[ p(2) = 2a. \]",
        r"\[ y = a \overset{(1)}{=} b \] Hence \[ y - b = 0. \]",
        r"\begin{quote} Let $b = 2a$. \end{quote} \[ s = a + b \] Hence \[ s - a = b. \]",
        r"\[ y_i = a x_i \] Hence \[ 2 y_i = 2 a x_i. \]",
        r"\[ S = \sum_{j=1}^n a_j x_j \] Hence \[ 2S = 2 \sum_{j=1}^n a_j x_j. \]",
        r"The student's sum is \[ s = a + b. \] Hence \[ s - a = b. \]",
        r"\newcommand{\x}{a} {\renewcommand{\x}{b} \[ z = 2\x \]} \[ y = \x \] Hence \[ 2y = 2a. \]",
        r"\newcommand{\x}{a} \begin{it} \renewcommand{\x}{b} \[ z = \x \] \end{it} \[ y = \x \] Hence \[ 2y = 2a. \]",
        r"\[ k (x - a) = 0 \] Hence \[ x = a. \]",
        r"\iftrue \[ g = a - b \] \else \[ g = a + b \] \fi Hence \[ g - a = -b. \]",
        r"For ideal gases \[ p + q = c. \] Hence \[ p = c - q. \]",
        r"\section{One} Let $c$ be a speed, \[ c = a + b. \] Hence \[ c - a = b. \]",
        r"$\mathbf F$ has full rank. \[ \mathbf F \mathbf x = \mathbf l \] \[ \mathbf x = \mathbf F^{-1} \mathbf l \]",
    ],
)
def test_such_words_hide_no_consequence_that_they_do_not_concern(latex: str) -> None:
    assert read_document(document_of(latex))[-1].verdict == "follows"


def test_an_empty_entry_beside_a_derivative_by_a_vector_is_read() -> None:
    left, right = r"\frac{\partial f}{\partial \mathbf{x}}", r"\begin{pmatrix} & 1 \end{pmatrix}"
    found = read_document(document_of(rf"Let $\mathbf{{x}}$ be a vector. \[ {left} = {right} \]"))
    assert [each.verdict for each in found] == ["not decided"]


@pytest.mark.parametrize(
    "latex",
    [
        r"The iterates of $f$ are studied. \[ f(x) = 2 x \] \[ f^2(x) = 4 x^2 \]",
        r"\[ f(x) = 2 x \] Here $f^2 = f \circ f$. \[ f^2(x) = 4 x^2 \]",
        r"\[ f(x) = 2 x \] \[ f^2(x) = f(f(x)) \] \[ f^2(x) = 4 x^2 \]",
        r"Here $+$ means the union. \[ C = A + B \] Hence \[ C - B = A. \]",
    ],
)
def test_an_iterate_is_no_power_and_a_sum_no_product(latex: str) -> None:
    assert read_document(document_of(latex))[-1].verdict != "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ w(z) = a + b z \] \[ w^2(z) = a^2 + 2 a b z + b^2 z^2 \]",
        r"\[ d^2_\sigma(z) = p + q z^2 \] \[ d^2_\sigma(z) - p = q z^2 \]",
        r"\[ h = q_v h_v + q_l h_l \] \[ h - q_l h_l = q_v h_v \]",
        r"\[ L^\uparrow = (1 - e) L^\downarrow + e s \] \[ L^\uparrow - e s = (1 - e) L^\downarrow \]",
        r"$$ \begin{eqnarray} u &=& a + b \end{eqnarray} $$ \[ u - b = a \]",
        r"Concatenate the two vectors. \[ a = b + c \] \[ 2 a = 2 b + 2 c \]",
        r"where $\cdot$ stands for v or p \[ c_{\cdot m} = a + b \] \[ 2 c_{\cdot m} = 2 a + 2 b \]",
    ],
)
def test_what_looks_like_an_iterate_or_another_sign_is_none(latex: str) -> None:
    assert read_document(document_of(latex))[-1].verdict == "follows"
