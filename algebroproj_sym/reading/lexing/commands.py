"""The commands of LaTeX that a formula may have, and what they stand for."""

import re

MAX_NESTING = 30
MAX_PIECES = 20_000
MAX_DIGITS = 1_000
PIECE = re.compile(r"\\[a-zA-Z]+(?:\*(?=\s*[{\[(]))?|\\.|\s+|.", re.DOTALL)
_GREEK_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi "
    "omega varepsilon varphi varrho vartheta varkappa varpi varsigma"
)
GREEK = frozenset(
    f"\\{name}" for low in _GREEK_NAMES.split() for name in (low, low.capitalize(), f"var{low.capitalize()}")
)
LETTERS = GREEK | {r"\ell", r"\hbar", r"\imath", r"\jmath", r"\nabla", r"\infty", r"\emptyset"}
BOLD = {
    r"\bm": r"\mathbf",
    r"\boldsymbol": r"\mathbf",
    r"\pmb": r"\mathbf",
    r"\bs": r"\mathbf",
    r"\textbf": r"\mathbf",
    r"\cal": r"\mathcal",
    r"\bf": r"\mathbf",
    r"\bold": r"\mathbf",
    r"\mathbfit": r"\mathbf",
    r"\vector": r"\mathbf",
    r"\vect": r"\mathbf",
    r"\mat": r"\mathbf",
    r"\mbf": r"\mathbf",
    r"\vb": r"\mathbf",
    r"\va": r"\mathbf",
}


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


STYLES = _words(
    r"\mathbf \mathcal \mathscr \mathfrak \mathbb \mathds \mathsf \mathit \mathtt \tilde \bar \hat \dot \ddot \dddot "
    r"\vec \overline \underline \widehat \widetilde \check \breve \mathring \acute \grave \overrightarrow"
)
UPRIGHT = _words(r"\mathrm \operatorname \operatorname* \text \textrm \mathop \textit \texttt")
BOXES = _words(r"\mbox \hbox \textnormal \textup \textsf \text \textrm")
"""Boxes of words within a formula."""
DROPPED = _words(
    r"\left \right \displaystyle \textstyle \scriptstyle \big \Big \bigg \Bigg \bigl \bigr \Bigl \Bigr \biggl \biggr "
    r"\Biggl \Biggr \middle \limits \nolimits \nonumber \notag \rm \it \mathord \mathbin \, \; \: \! ~ \/ \hfill "
    r"\hline \mathrm \allowbreak \nobreak \relax \protect \strut \mathstrut \scriptscriptstyle "
    r"\pause"
)
DROPPED |= {"\\\n"}
WIDE = frozenset((r"\quad", r"\qquad", "\\ "))
WITH_ARGUMENT = _words(r"\hspace \vspace \label \phantom \hphantom \vphantom \tag \tag*")
NO_LETTERS = _words(
    r"\forall \exists \because \therefore \over \atop \choose \hbox "
    r"\begin \end \lfloor \rfloor \lceil \rceil \langle \rangle \neg "
    r"\def \let \newcommand \color \bmod \mod \pmod \top \not \overbrace \underbrace \stackrel \overset "
    r"\underset \substack \binom \angle \measuredangle \triangle"
)
"""Commands that stand for no letter."""
BEFORE_LETTER = _words(r"\leftexp \leftidx \prescript \presuper")
FRACTIONS = _words(r"\frac \dfrac \tfrac \cfrac")
BINOMIALS = _words(r"\binom \dbinom \tbinom")
BIG = _words(r"\sum \prod \int \iint \iiint \oint \lim \max \min \sup \inf \bigcup \bigcap \argmin \argmax")
FUNCTIONS = _words(
    "sin cos tan cot sec csc arcsin arccos arctan arccot asin acos atan atan2 arctan2 sinh cosh tanh coth arcsinh "
    "arccosh arctanh arsinh arcosh artanh sech csch exp log ln lg det tr trace Tr dev sym diag rank sign sgn adj sinc"
)
OPERATORS = _words(
    "var cov corr std mean avg min max sup inf lim arg vec grad div rot curl re im rk dim ker span pr erf erfc sat"
)
"""Words that act on what stands behind them, and are read as names."""
NAMED = _words("Re Im floor ceil jump")
"""Functions that are read by their upright names, and not computed."""
SIGNS = {"+": "+", "-": "-", "−": "-", r"\pm": "±", r"\mp": "∓"}
RELATIONS = dict(
    pair.split("#")
    for pair in sorted(
        _words(
            r"=#= :=#:= =:#=: \equiv#≡ \triangleq#:= \coloneqq#:= \eqqcolon#=: \doteq#:= <#< >#> \lt#< \gt#> \le#<= "
            r"\leq#<= \ge#>= \geq#>= \leqslant#<= \geqslant#>= \ll#≪ \gg#≫ \ne#!= \neq#!= \approx#≈ \simeq#≈ \cong#≅ "
            r"\sim#~ \propto#∝ \in#∈ \notin#∉ \ni#∋ \lesssim#≲ \gtrsim#≳ \hookrightarrow#→ \supset#⊃ \subseteq#⊆ "
            r"\supseteq#⊇ \asymp#≍ \prec#≺ \succ#≻ \parallel#∥ \longmapsto#↦ \Longleftrightarrow#⇔ \Leftarrow#⇐ \to#→ "
            r"\rightarrow#→ \longrightarrow#→ \leadsto#→ \leftarrow#← \mapsto#↦ \Rightarrow#⇒ \Longrightarrow#⇒ "
            r"\implies#⇒ \gets#← \questeq#≟ \Leftrightarrow#⇔ \iff#⇔ \leftrightarrow#↔ \perp#⟂ \bot#⟂ \subset#⊂"
        )
    )
)
MAPS = tuple(command for command, sign in RELATIONS.items() if sign in ("→", "↦"))
OF_ANGLES = ("sin", "cos", "tan", "cot", "sec", "csc")
VECTOR_STYLE = r"\\(?:mathbf|vec|overrightarrow)"
TRANSPOSED = _words(r"T t \top \intercal \mathsf{T} \mathsfT \sfT \mathtt{T} \trans")
MARKS = {**dict.fromkeys(TRANSPOSED, "T"), **dict.fromkeys((r"\wedge", r"\land", r"\times"), "hat"), r"\vee": "vee"}
PART_OF_NAME = re.compile(
    r"\(.*\)|(?:\*|\\ast)+|\\math(?:cal|scr|frak|bb)\W.*|(?:[a-zA-Z0-9,]|\\[a-zA-Z]+(?![a-zA-Z]))*[-+*]"
    r"|\\(?:pm|mp|star|dagger|ddagger|sharp|flat|natural|circ|perp|parallel|prime|(?:up|down|left|right)arrow)|\[.*\]"
)
MATRIX = re.compile(r"\\begin\{(?:[bpvVB]?(?:small)?matrix\*?|array)\}")
OPENING = {"(": "LP", "[": "LS", r"\{": "LB", r"\lbrace": "LB", r"\lbrack": "LS", r"\langle": "ANGLE_OPEN"}
CLOSING = {")": "RP", "]": "RS", r"\}": "RB", r"\rbrace": "RB", r"\rbrack": "RS", r"\rangle": "ANGLE_CLOSE"}
CLOSING_BARS = {r"\lvert": r"\rvert", r"\lVert": r"\rVert", "|": "|", r"\|": r"\|"}
"""How a bar that begins the argument of a function is closed."""
BARS = {"|": "BAR", r"\vert": "BAR", r"\lvert": "BAR", r"\rvert": "BAR"} | dict.fromkeys(
    (r"\|", r"\Vert", r"\lVert", r"\rVert"), "NORM"
)
ARGUMENT = "LaTeX leaves open how far the argument of a function goes"
AXIS = r"[xyzA-SU-Z]"
SIZE = re.compile(r"\d+\\times\d+")
"""What says below a matrix how many rows and columns it has."""
VALUE_ENDS = frozenset(
    (
        "NUMBER",
        "SYMBOL",
        "OPAQUE",
        "SHOWN",
        "CLOSE",
        "RP",
        "RS",
        "RB",
        "BAR_CLOSE",
        "NORM_CLOSE",
        "ANGLE_CLOSE",
        "END",
        "MARK",
    )
)
ELLIPSES = frozenset((r"\ldots", r"\dots", r"\cdots", r"\vdots", r"\ddots", r"\dotsc", r"\dotsb", "…"))
CIRCLED = _words(
    r"\circ \otimes \oplus \odot \ominus \star \ast \bullet \cup \cap \setminus \backslash \land \lor \wedge \vee \mid "
    r"\boxplus \boxminus \bigoplus \bigotimes \bmod \colon :"
)
"""Signs between two values that are read, and not computed."""
DIFFERENTIALS = frozenset(("d", r"\partial", r"\delta", r"\Delta", r"\mathrm{d}"))
