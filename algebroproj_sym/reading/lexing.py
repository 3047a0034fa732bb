r"""LaTeX of a formula as tokens of the grammar, each with its place in the source.

What LaTeX leaves to the eye is decided here: how far the argument of ``\sin x y`` goes, which ``|`` opens, whether
``f(x)`` is a value or a product.  What only concerns the looks is dropped.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from lark import Token

MAX_NESTING = 30
MAX_PIECES = 20_000
MAX_DIGITS = 1_000

_PIECE = re.compile(r"\\[a-zA-Z]+\*?|\\.|\s+|.", re.DOTALL)
_GREEK = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi "
    "omega varepsilon varphi varrho vartheta varkappa varpi varsigma"
)
GREEK = frozenset(f"\\{name}" for low in _GREEK.split() for name in (low, low.capitalize()))
_LETTERS = GREEK | {r"\ell", r"\hbar", r"\imath", r"\jmath", r"\nabla", r"\infty", r"\emptyset"}
_BOLD = {
    r"\bm": r"\mathbf",
    r"\boldsymbol": r"\mathbf",
    r"\pmb": r"\mathbf",
    r"\bs": r"\mathbf",
    r"\textbf": r"\mathbf",
    r"\cal": r"\mathcal",
    r"\bf": r"\mathbf",
    r"\bold": r"\mathbf",
    r"\mathbfit": r"\mathbf",
}


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_STYLES = _words(
    r"\mathbf \mathcal \mathscr \mathfrak \mathbb \mathds \mathsf \mathit \mathtt \tilde \bar \hat \dot \ddot \dddot "
    r"\vec \overline \underline \widehat \widetilde \check \breve \mathring \acute \grave \overrightarrow"
)
_UPRIGHT = _words(r"\mathrm \operatorname \operatorname* \text \textrm \mathop \textit")
_DROPPED = _words(
    r"\left \right \displaystyle \textstyle \scriptstyle \big \Big \bigg \Bigg \bigl \bigr \Bigl \Bigr \biggl \biggr "
    r"\Biggl \Biggr \middle \limits \nolimits \nonumber \notag \rm \it \mathord \mathbin \, \; \: \! ~ \/ \hfill "
    r"\hline \mathrm \allowbreak \nobreak \relax \protect \ensuremath \strut \mathstrut \scriptscriptstyle"
)
_DROPPED |= {"\\\n"}
_WIDE = frozenset((r"\quad", r"\qquad", "\\ "))
_WITH_ARGUMENT = _words(r"\hspace \vspace \label \phantom \hphantom \vphantom \tag \tag*")
_NO_LETTERS = _words(
    r"\forall \exists \mid \cup \cap \setminus \wedge \vee \bullet \because \therefore \over \atop \choose \hbox "
    r"\begin \end \lfloor \rfloor \lceil \rceil \langle \rangle \neg \land \lor \asymp \prec \succ \supset \subseteq "
    r"\supseteq \def \let \newcommand \color \bmod \mod \pmod \top \not \overbrace \underbrace \stackrel \overset "
    r"\underset \substack \binom"
)
"""Commands that stand for no letter."""
_BEFORE_LETTER = _words(r"\leftexp \leftidx \prescript \presuper")
_FRACTIONS = _words(r"\frac \dfrac \tfrac \cfrac")
_BIG = _words(r"\sum \prod \int \iint \iiint \oint \lim \max \min \sup \inf \bigcup \bigcap \argmin \argmax")
FUNCTIONS = _words(
    "sin cos tan cot sec csc arcsin arccos arctan arccot asin acos atan atan2 arctan2 sinh cosh tanh coth arcsinh "
    "arccosh arctanh arsinh arcosh artanh sech csch exp log ln lg det tr trace Tr diag rank sign sgn adj sinc"
)
_SIGNS = {"+": "+", "-": "-", "−": "-", r"\pm": "±", r"\mp": "∓"}
RELATIONS = dict(
    pair.split("#")
    for pair in sorted(
        _words(
            r"=#= :=#:= =:#=: \equiv#≡ \triangleq#:= \coloneqq#:= \doteq#:= <#< >#> \lt#< \gt#> \le#<= \leq#<= \ge#>= "
            r"\geq#>= \leqslant#<= \geqslant#>= \ll#≪ \gg#≫ \ne#!= \neq#!= \approx#≈ \simeq#≈ \cong#≅ \sim#~ \propto#∝ "
            r"\in#∈ \notin#∉ \to#→ \rightarrow#→ \longrightarrow#→ \leadsto#→ \leftarrow#← \mapsto#↦ \Rightarrow#⇒ "
            r"\Longrightarrow#⇒ \implies#⇒ \Leftrightarrow#⇔ \iff#⇔ \leftrightarrow#↔ \perp#⟂ \bot#⟂ \subset#⊂"
        )
    )
)
_TRANSPOSED = _words(r"T t \top \intercal \mathsf{T} \mathsfT \sfT \mathtt{T} \trans")

_MARKS = {**dict.fromkeys(_TRANSPOSED, "T"), r"\wedge": "hat", r"\times": "hat", r"\vee": "vee"}
_PART_OF_NAME = re.compile(
    r"\(.*\)|\\math(?:cal|scr|frak|bb)\W.*|[-+*]|\\(?:star|ast|dagger|circ|perp|parallel|prime)|\[.*\]"
)
_MATRIX = re.compile(r"\\begin\{(?:[bpvVB]?matrix\*?|smallmatrix|array)\}")
_OPENING = {"(": "LP", "[": "LS", r"\{": "LB", r"\lbrace": "LB", r"\lbrack": "LS", r"\langle": "ANGLE_OPEN"}
_CLOSING = {")": "RP", "]": "RS", r"\}": "RB", r"\rbrace": "RB", r"\rbrack": "RS", r"\rangle": "ANGLE_CLOSE"}
_BARS = {"|": "BAR", r"\vert": "BAR", r"\lvert": "BAR", r"\rvert": "BAR"} | dict.fromkeys(
    (r"\|", r"\Vert", r"\lVert", r"\rVert"), "NORM"
)
ARGUMENT = "LaTeX leaves open how far the argument of a function goes"
_AXIS = r"[xyzA-SU-Z]"
_INDICES = re.compile(r"(?:[a-zA-Z]|\\[a-zA-Z]+){2,}")
_LETTER = re.compile(r"[a-zA-Z]|\\[a-zA-Z]+")
_VALUE_ENDS = frozenset(
    ("NUMBER", "SYMBOL", "OPAQUE", "CLOSE", "RP", "RS", "RB", "BAR_CLOSE", "NORM_CLOSE", "ANGLE_CLOSE", "END", "MARK")
)
_DIFFERENTIALS = frozenset(("d", r"\partial", r"\delta", r"\Delta", r"\mathrm{d}"))


class Piece(NamedTuple):
    """A control sequence or a character, and where it stands in the source."""

    text: str
    place: int


class UnreadableError(ValueError):
    """A text is no formula that the grammar reads, or has a name that no table explains.

    Attributes
    ----------
    place : int or None
        Where reading stopped, counted in characters from the beginning of the source.
    """

    def __init__(self, message: str, place: int | None = None) -> None:
        super().__init__(message)
        self.place = place


def pieces_of(latex: str, place: int = 0) -> list[Piece]:
    r"""Return the control sequences and characters of a text that begins at a place; ``\begin{name}`` is one.

    Examples
    --------
    >>> [piece.text for piece in pieces_of(r"\frac12 \begin{cases}")]
    ['\\frac', '1', '2', ' ', '\\begin{cases}']
    """
    found = [Piece(each.group(), place + each.start()) for each in _PIECE.finditer(latex)]
    return _with_environments(found)


def _with_environments(pieces: Sequence[Piece]) -> list[Piece]:
    joined: list[Piece] = []
    index = 0
    while index < len(pieces):
        text, place = pieces[index]
        if text in (r"\begin", r"\end"):
            opening = next((i for i in range(index + 1, len(pieces)) if not pieces[i].text.isspace()), len(pieces))
            closing = next((i for i in range(opening, min(opening + 30, len(pieces))) if pieces[i].text == "}"), None)
            if closing is not None and pieces[opening].text == "{":
                text += "".join(piece.text for piece in pieces[opening : closing + 1])
                index = closing
        joined.append(Piece(text, place))
        index += 1
    return joined


def split_symbol(symbol: str) -> tuple[str, int, str, str]:
    r"""Return letter, number of primes, subscript and superscript of a symbol.

    Examples
    --------
    >>> split_symbol(r"\mu_{j1}''^T")
    ('\\mu', 2, 'j1', 'T')
    """
    word = re.match(r"[a-zA-Z]*", symbol)[0]  # type: ignore[index]  # it always matches
    rest = symbol[len(word) :] if len(word) > 1 else symbol
    lexer = _Lexer(pieces_of(rest), lambda name: False, None, True)
    letter = word if len(word) > 1 else lexer.letter()
    return (letter, *lexer.scripts())


def written(letter: str, primes: int, subscript: str, superscript: str) -> str:
    r"""Return the one way in which tables write a symbol.

    Examples
    --------
    >>> written("\\mu", 2, "31", "")
    "\\mu_{31}''"
    """
    below = f"_{{{subscript}}}" if len(subscript) > 1 else f"_{subscript}" if subscript else ""
    above = f"^{{{superscript}}}" if len(superscript) > 1 else f"^{superscript}" if superscript else ""
    return f"{letter}{below}{chr(39) * primes}{above}"


def tokens_of(
    pieces: Sequence[Piece],
    known: Callable[[str], bool],
    functions: Collection[str] | None = None,
    wide_arguments: bool = True,
) -> tuple[list[Token], str]:
    """Return the tokens of a formula, and what the reader had to choose, such as how far an argument goes.

    Parameters
    ----------
    pieces : sequence of Piece
        As `pieces_of` gives them.
    known : callable
        Whether a symbol with a superscript is a name of its own, and no power.
    functions : collection of str, optional
        The letters that are functions; without it, letters before brackets are factors, and d is no differential.
    wide_arguments : bool
        Whether the argument of a function goes on over letters that follow one another.

    Raises
    ------
    UnreadableError
        Naming the place: where a command is not known, a bracket is missing or there is more than there may be.
    """
    if len(pieces) > MAX_PIECES:
        raise UnreadableError(f"expected a formula of at most {MAX_PIECES} pieces, got {len(pieces)}", pieces[0].place)
    lexer = _Lexer(list(pieces), known, functions, wide_arguments)
    lexer.until_end()
    return lexer.out, lexer.chose


@dataclass
class _Lexer:
    pieces: list[Piece]
    known: Callable[[str], bool]
    functions: Collection[str] | None
    wide: bool
    depth: int = 0
    index: int = 0
    chose: str = ""
    out: list[Token] = field(default_factory=list)
    opened: list[str] = field(default_factory=list)

    # -- pieces

    @property
    def text(self) -> str:
        return self.pieces[self.index].text if self.index < len(self.pieces) else ""

    @property
    def place(self) -> int:
        if not self.pieces:
            return 0
        return self.pieces[min(self.index, len(self.pieces) - 1)].place

    def peek(self, after: int = 0) -> str:
        """Return the next piece that is no space."""
        for piece in self.pieces[self.index + after :]:
            if not piece.text.isspace() and piece.text not in _DROPPED - {r"\mathrm", "~"}:
                return piece.text
        return ""

    def skip(self) -> None:
        while self.index < len(self.pieces) and self.text.isspace():
            self.index += 1

    def fail(self, message: str) -> UnreadableError:
        return UnreadableError(message, self.place)

    def group(self) -> list[Piece]:
        """Return the pieces of an argument: those between braces, or the next one."""
        self.skip()
        if self.index >= len(self.pieces):
            raise self.fail("expected an argument, got the end")
        if self.text != "{":
            return self.single()
        start, depth = self.index, 0
        while self.index < len(self.pieces):
            depth += (self.text == "{") - (self.text == "}")
            if depth > MAX_NESTING:
                raise self.fail(f"expected at most {MAX_NESTING} levels of nesting, got more")
            self.index += 1
            if depth == 0:
                return self.pieces[start + 1 : self.index - 1]
        raise UnreadableError("a brace is not closed", self.pieces[start].place)

    def single(self) -> list[Piece]:
        """Return a piece, with the arguments that it takes."""
        start = self.index
        self.index += 1
        taken = self.pieces[start].text
        if taken in _FRACTIONS:
            self.group()
            self.group()
        elif taken in _STYLES or taken in _UPRIGHT or taken in _BOLD or taken == r"\sqrt":
            self.group()
        return self.pieces[start : self.index]

    def option(self) -> list[Piece] | None:
        """Return the pieces of an optional argument in square brackets."""
        self.skip()
        if self.text != "[":
            return None
        start = self.index
        while self.text != "]":
            self.index += 1
            if self.index >= len(self.pieces):
                raise UnreadableError("a bracket is not closed", self.pieces[start].place)
        self.index += 1
        return self.pieces[start + 1 : self.index - 1]

    # -- tokens

    def emit(self, kind: str, value: str = "") -> None:
        self.out.append(Token(kind, value, start_pos=self.place))

    def inner(self, pieces: Sequence[Piece]) -> None:
        """Emit the tokens of an argument, in invisible brackets."""
        if self.depth >= MAX_NESTING:
            raise self.fail(f"expected at most {MAX_NESTING} levels of nesting, got more")
        lexer = _Lexer(list(pieces), self.known, self.functions, self.wide, self.depth + 1)
        lexer.until_end()
        self.chose = self.chose or lexer.chose
        self.emit("OPEN", "{")
        self.out += lexer.out
        self.emit("CLOSE", "}")

    def until_end(self) -> None:
        while self.index < len(self.pieces):
            self.step()
        if self.opened:
            raise self.fail(f"a bracket is not closed, of kind {self.opened[-1]}")
        self.out = _without_idle_separators(self.out)

    def ends_value(self) -> bool:
        return bool(self.out) and self.out[-1].type in _VALUE_ENDS

    def step(self) -> None:
        text = self.text
        if text in (r"\left", r"\right"):
            self.index += 1
            self.skip()
            self.index += self.text == "."
        elif text.isspace() or text in _DROPPED - {r"\mathrm"} or (text == r"\mathrm" and self.peek(1) != "{"):
            self.index += 1
        elif text in _WIDE:
            if self.opened:
                self.emit("SEPARATOR", " ")
            self.index += 1
        elif text in _WITH_ARGUMENT:
            self.index += 1
            self.group()
        elif self.is_symbol():
            self.symbol()
        elif text.isdigit() or (text == "." and self.peek(1).isdigit()):
            self.number()
        elif text in _FRACTIONS:
            self.fraction()
        elif text == r"\sqrt":
            self.root()
        elif text in _BIG:
            self.big()
        elif text.startswith("\\begin{"):
            self.environment()
        elif self.function_name():
            self.function()
        elif text in _OPENING or text in _CLOSING or text in _BARS:
            self.bracket()
        elif text == "{":
            self.braces()
        elif text in _BEFORE_LETTER:
            self.command_before_letter()
        elif text in ("_", "^"):
            self.before_letter()
        else:
            self.operator()

    def operator(self) -> None:
        text = self.text
        kinds = {"/": "SLASH", r"\cdot": "DOT", r"\times": "CROSS", "*": "DOT", "!": "FACTORIAL", r"\div": "SLASH"}
        kinds |= {"&": "AMP", r"\\": "ROW", ",": "SEPARATOR", ";": "SEPARATOR", r"\circ": "DOT", r"\otimes": "CIRCLED"}
        kinds |= {r"\oplus": "CIRCLED", r"\odot": "CIRCLED", r"\ominus": "CIRCLED", r"\star": "CIRCLED"}
        if text in _SIGNS:
            self.emit("SIGN", _SIGNS[text])
        elif text == ":" and self.peek(1) == "=":
            self.emit("RELATION", ":=")
            self.index += next(i for i, p in enumerate(self.pieces[self.index :]) if p.text == "=")
        elif text in (":", r"\colon"):
            self.emit("CIRCLED", ":")
        elif text in (r"\stackrel", r"\overset"):
            self.index += 1
            over = "".join(piece.text for piece in self.group())
            relation = "".join(piece.text for piece in self.group()).strip()
            if relation not in RELATIONS:
                raise self.fail(f"the command {text} is read above a relation only")
            self.emit("RELATION", ":=" if "def" in over or "triangle" in over else RELATIONS[relation])
            return
        elif text in RELATIONS:
            self.emit("RELATION", RELATIONS[text])
        elif text == r"\\":
            self.emit("ROW", text)
            self.index += 1
            if self.text == "[":
                self.option()
            return
        elif text in kinds:
            self.emit(kinds[text], text)
        elif text in (r"\ldots", r"\dots", r"\cdots", r"\vdots", r"\ddots", "…"):
            raise self.fail("an ellipsis is not read")
        elif self.functions is not None and self.is_unknown_letter():
            self.chose = f"the command {text} is not known"
            start = self.place
            self.index += 1
            self.scripted(text, start)
            return
        elif text.startswith("\\"):
            raise self.fail(f"the command {text} is not known")
        else:
            raise self.fail(f"expected a formula, got {text!r}")
        self.index += 1

    def number(self) -> None:
        start, digits = self.place, ""
        while self.index < len(self.pieces):
            text = self.text
            goes_on = (text == "." and "." not in digits) or (text.isspace() and digits)
            if not text.isdigit() and not (goes_on and self.peek(1).isdigit()):
                break
            digits += text.strip()
            self.index += 1
            self.index += self.is_thousand(digits)
        if len(digits) > MAX_DIGITS:
            raise UnreadableError(f"expected a number of at most {MAX_DIGITS} digits, got {len(digits)}", start)
        self.out.append(Token("NUMBER", digits, start_pos=start))
        self.after()

    def is_thousand(self, digits: str) -> bool:
        r"""Whether three digits follow after a thin space, as in ``1\,000``."""
        following = "".join(piece.text for piece in self.pieces[self.index + 1 : self.index + 5])
        return (
            self.text in (r"\,", r"\;", r"\:", "~") and digits.isdigit() and bool(re.match(r"\d{3}(?!\d)", following))
        )

    # -- symbols

    def is_symbol(self) -> bool:
        text = self.text
        if text in _UPRIGHT:
            return not self.function_name()
        return text.isalpha() or text in _LETTERS or text in _STYLES or text in _BOLD or text == r"\partial"

    def letter(self) -> str:
        """Return the letter, with its style and accents, as tables write it."""
        self.skip()
        text = _BOLD.get(self.text, self.text)
        self.index += 1
        if text in _STYLES or text in _UPRIGHT:
            inside = _bare(self.group())
            return (
                inside
                if text in _UPRIGHT and len(inside) > 1
                else inside
                if text in _UPRIGHT
                else f"{text}{{{inside}}}"
            )
        return text

    def scripts(self) -> tuple[int, str, str]:
        """Return the primes, the subscript and the superscript that follow."""
        primes, below, above = 0, "", ""
        self.raised: list[Piece] = []
        while True:
            here = self.index
            while self.text.isspace() or (self.text == "{" and self.peek(1) == "}" and self.next_is_script()):
                self.index += 1 if self.text.isspace() else 2
            if self.text == "'":
                self.index += 1
                primes += 1
            elif self.text == "_":
                self.index += 1
                below += _bare(self.group())
            elif self.text == "^" and not above:
                self.index += 1
                self.raised = self.group()
                inside = _bare(self.raised).replace(r"\prime", "'")
                primes += inside.count("'")
                above = inside.replace("'", "")
            else:
                self.index = here
                return primes, below, above

    def next_is_script(self) -> bool:
        rest = [piece.text for piece in self.pieces[self.index : self.index + 12] if not piece.text.isspace()]
        if rest[:2] != ["{", "}"] or len(rest) < 3 or rest[2] not in ("_", "^", "'"):
            return False
        return rest[2] != "^" or _is_behind(rest[3:])

    def symbol(self) -> None:
        start, command = self.place, self.text
        letter = self.letter()
        self.skip()
        if command.startswith(r"\operatorname") and (self.is_symbol() or self.text.isdigit() or self.function_name()):
            raise self.fail(f"the function {letter} is not known")
        self.scripted(letter, start)

    def scripted(self, letter: str, start: int) -> None:
        if self.functions is not None and letter in _DIFFERENTIALS and self.is_factor_symbol():
            self.differential(letter, start)
            return
        primes, below, above = self.scripts()
        whole = written(letter, primes, below, above)
        bare = written(letter, primes, below, "")
        if not above or self.known(whole):
            self.name(whole, start)
        elif re.fullmatch(r"\*(T|-1|\\top)", above):
            self.name(written(letter, primes, below, "*"), start, raised=True)
            self.power(above[1:], self.raised[1:])
        elif _PART_OF_NAME.fullmatch(above) or self.is_axis(letter, above):
            self.name(whole, start)
        elif self.functions is not None and self.has_indices(letter, below, above):
            self.chose = "letters above may be indices"
            self.name(whole, start)
        else:
            self.name(bare, start, raised=True)
            self.power(above, [piece for piece in self.raised if piece.text not in ("'", r"\prime")])
        self.after()

    def is_axis(self, letter: str, above: str) -> bool:
        r"""Whether what stands above a vector is an axis or a frame, as in ``\mathbf{e}^z``, and no power."""
        return self.functions is not None and letter.startswith(r"\mathbf{") and bool(re.fullmatch(_AXIS, above))

    def is_unknown_letter(self) -> bool:
        """Whether a command of the document that nothing defines may be a letter: it takes no argument."""
        named = re.fullmatch(r"\\[a-zA-Z]+", self.text) is not None
        return named and self.text not in _NO_LETTERS and self.peek(1) != "{"

    def has_indices(self, letter: str, below: str, above: str) -> bool:
        r"""Whether what stands above a letter may be indices, as in ``T^{\mu\nu}`` and ``g_\mu^\nu``, and no power."""
        if letter in ("e", r"\mathrm{e}") or above in _MARKS:
            return False
        letters = [*_LETTER.findall(above)]
        alone = all(each in GREEK or len(each) == 1 for each in letters)
        mixed = len(letters) == 1 and {above, below} <= GREEK
        return (_INDICES.fullmatch(above) is not None and alone) or mixed

    def is_factor_symbol(self) -> bool:
        here = self.text
        return bool(here) and (
            here.isalpha() or here in _LETTERS or here in _STYLES or here in _BOLD or here == r"\mathrm"
        )

    def differential(self, letter: str, start: int) -> None:
        inner = self.letter()
        primes, below, above = self.scripts()
        self.name(f"{letter} {written(inner, primes, below, '')}", start)
        if above:
            self.power(above, self.raised)
        self.after()

    def name(self, whole: str, start: int, *, raised: bool = False) -> None:
        before_bracket = self.functions is not None and not raised and self.peek() == "("
        called = before_bracket and (whole in (self.functions or ()) or self.is_argument())
        self.out.append(Token("CALLEE" if called else "SYMBOL", whole, start_pos=start))

    def is_argument(self) -> bool:
        """Whether the bracket that follows has one letter alone, or several values."""
        inside, depth = list[Piece](), 0
        for piece in self.pieces[self.index :]:
            depth += (piece.text == "(") - (piece.text == ")")
            if depth == 0 and inside:
                break
            inside.append(piece)
        body = [piece for piece in inside if not piece.text.isspace() and piece.text not in _DROPPED][1:]
        if any(piece.text in (",", ";") for piece in _outside_braces(body)):
            return True
        if not body or any(piece.text in "+-*/()=|" for piece in body):
            return False
        lexer = _Lexer(body, self.known, None, True)
        return lexer.is_symbol() and bool(lexer.letter()) and lexer.scripts() is not None and lexer.index == len(body)

    # -- powers and marks

    def power(self, above: str, raised: Sequence[Piece]) -> None:
        if above in _MARKS:
            self.emit("MARK", _MARKS[above])
        elif above == r"\circ" and self.out[-1].type == "NUMBER":
            if self.peek() in _UPRIGHT or self.peek() in ("C", "F"):
                raise self.fail("degrees of temperature are not read")
            degrees = self.out.pop()
            self.emit("OPEN", "{")
            self.out += [degrees, Token("SYMBOL", r"\pi", start_pos=degrees.start_pos)]
            self.emit("SLASH", "/")
            self.emit("NUMBER", "180")
            self.emit("CLOSE", "}")
        elif above:
            self.emit("SUP", "^")
            self.inner(raised)

    def after(self) -> None:
        """Read what is attached to a value: powers, marks, the subscript of a bracket."""
        while self.peek() in ("^", "_", "'") and self.out[-1].type != "CALLEE":
            self.skip()
            while self.text in _DROPPED:
                self.index += 1
                self.skip()
            mark = self.text
            self.index += 1
            if mark == "'":
                raise self.fail("a prime is read after a letter only")
            raised = self.group()
            inside = _bare(raised)
            if mark == "^":
                self.power(inside, raised)
            elif inside in (r"\times", r"\wedge"):
                self.emit("MARK", "hat")
            elif not (self.out[-1].type == "NORM_CLOSE" and inside in ("2", "F")):
                self.emit("MARK", f"_{inside}")

    # -- what has arguments

    def fraction(self) -> None:
        start = self.place
        self.index += 1
        above, below = self.group(), self.group()
        derivative = _derivative(_bare(above), _bare(below)) if self.functions is not None else None
        if derivative is None:
            self.out.append(Token("FRACTION", r"\frac", start_pos=start))
            self.inner(above)
            self.inner(below)
            self.after()
        elif derivative:
            self.out.append(Token("OPAQUE", derivative, start_pos=start))
            self.after()
        else:
            self.out.append(Token("BIG", f"{_bare(above)}/{_bare(below)}", start_pos=start))
            self.body()

    def root(self) -> None:
        self.emit("ROOT", r"\sqrt")
        self.index += 1
        degree = self.option()
        if degree is not None:
            self.emit("SUP", "^")
            self.inner(degree)
        self.inner(self.group())
        self.after()

    def big(self) -> None:
        start, name = self.place, self.text
        self.index += 1
        while self.text in (r"\limits", r"\nolimits"):
            self.index += 1
        _, below, above = self.scripts()
        limits = (f"_{{{below}}}" if below else "") + (f"^{{{above}}}" if above else "")
        self.out.append(Token("BIG", name + limits, start_pos=start))
        self.body()

    def body(self) -> None:
        """Emit what a sum, an integral or a derivative is of: all to the next sign, relation or end."""
        start, depth = self.index, 0
        while self.index < len(self.pieces):
            text = self.text
            if depth == 0 and self.index > start and (text in _SIGNS or text in RELATIONS or text in (",", "&", r"\\")):
                break
            deeper = text in ("(", "[", "{", r"\{") or text.startswith(r"\begin{")
            depth += deeper - (text in (")", "]", "}", r"\}") or text.startswith(r"\end{"))
            if depth < 0:
                break
            self.index += 1
        self.inner([piece for piece in self.pieces[start : self.index] if piece.text not in (r"\left", r"\right")])

    def function_name(self) -> str:
        """Return the name of the function that begins here; empty if none does."""
        text = self.text
        if text in _UPRIGHT:
            rest = self.pieces[self.index + 1 : self.index + 14]
            inside = re.match(r"\s*\{([a-zA-Z0-9]+)\}", "".join(piece.text for piece in rest))
            return inside[1] if inside and inside[1] in FUNCTIONS else ""
        return text[1:] if text.startswith("\\") and text[1:] in FUNCTIONS else ""

    def function(self) -> None:
        start, name = self.place, self.function_name()
        upright = self.text in _UPRIGHT
        self.index += 1
        if upright:
            self.group()
        primes, below, _ = self.scripts()
        if primes:
            raise self.fail("a prime is read after a letter only")
        mark, raised = len(self.out), self.raised
        self.out.append(Token("FUNCTION", name + (f"_{below}" if below else ""), start_pos=start))
        opening = self.peek()
        begin = self.index
        self.argument()
        if opening in ("(", "[", "|") and self.peek() == "^" and not raised:
            self.power_of_bracket(begin, mark)
        inside = self.out[mark + 2 : -1]
        if len(inside) == 1 and self.known(f"\\{name}{inside[0]}"):
            self.out[mark:] = [Token("SYMBOL", f"\\{name}{inside[0]}", start_pos=start)]
            if raised:
                self.emit("SUP", "^")
                self.inner(raised)
        elif raised:
            self.out[mark + 1 : mark + 1] = self.of(raised)
        self.after()

    def power_of_bracket(self, begin: int, mark: int) -> None:
        r"""Choose what is raised in ``\ln(x)^2``: the value of the function, or its argument."""
        self.chose = ARGUMENT
        if not self.wide:
            while self.text != "^":
                self.index += 1
            self.scripts()
            del self.out[mark + 1 :]
            self.inner(self.pieces[begin : self.index])

    def of(self, raised: Sequence[Piece]) -> list[Token]:
        """Return the tokens of an exponent."""
        lexer = _Lexer([], self.known, self.functions, self.wide, self.depth)
        lexer.emit("SUP", "^")
        lexer.inner(raised)
        return lexer.out

    def argument(self) -> None:
        """Emit the argument of a function: a bracket, or numbers and letters that follow one another."""
        while self.text.isspace() or self.text in _DROPPED - {r"\mathrm"}:
            self.index += 1
        start = self.index
        if self.text in ("(", "[", r"\{", "{", "|", r"\|") or _MATRIX.match(self.text):
            self.inner(self.bracketed())
            return
        values = 0
        while self.index < len(self.pieces):
            here = self.index
            if self.text.isspace():
                self.index += 1
                continue
            number = self.text.isdigit() or self.text == "."
            if not (number or self.text in _FRACTIONS or self.text == r"\sqrt" or self.is_symbol()):
                if self.index > start and self.peek() in ("(", "["):
                    self.chose = ARGUMENT
                break
            if values and not self.wide:
                self.chose = ARGUMENT
                break
            if values:
                self.chose = ARGUMENT
            if number:
                self.index += 1
                self.scripts() if self.text == "^" else None
                continue
            if self.text in _FRACTIONS or self.text == r"\sqrt":
                self.single()
            else:
                self.letter()
            self.scripts()
            values += 1
            if self.index == here:
                break
        if self.index == start:
            raise self.fail("expected the argument of a function")
        self.inner(self.pieces[start : self.index])

    def bracketed(self) -> list[Piece]:
        """Return the pieces of the bracket that begins here, without the bracket unless it is one of a value."""
        opening, start = self.text, self.index
        closing = {"(": ")", "[": "]", r"\{": r"\}", "{": "}"}.get(opening, opening)
        if _MATRIX.match(opening):
            closing = opening.replace("begin", "end")
        depth = 0
        while self.index < len(self.pieces):
            text = self.text
            self.index += 1
            if text == closing and (opening != closing or depth):
                depth -= 1
            elif text == opening:
                depth += 1
            if depth == 0:
                kept = self.pieces[start : self.index]
                inside = kept if opening in ("|", r"\|") or _MATRIX.match(opening) else kept[1:-1]
                return inside[:-1] if inside and inside[-1].text == r"\right" else inside
        raise UnreadableError("a bracket is not closed", self.pieces[start].place)

    def environment(self) -> None:
        name = self.text
        start = self.index
        self.index += 1
        if name == r"\begin{cases}":
            self.cases(start)
            return
        if not _MATRIX.match(name):
            raise UnreadableError(f"the environment {name} is not known inside a formula", self.pieces[start].place)
        if "array" in name:
            self.option()
            self.group()
        if self.depth >= MAX_NESTING:
            raise self.fail(f"expected at most {MAX_NESTING} levels of nesting, got more")
        inside = self.environment_body(name, start)
        lexer = _Lexer(inside, self.known, self.functions, self.wide, self.depth + 1)
        lexer.until_end()
        self.chose = self.chose or lexer.chose
        while lexer.out and lexer.out[-1].type == "ROW":
            lexer.out.pop()
        self.emit("BEGIN", name)
        self.out += lexer.out
        self.emit("END", name)
        self.after()

    def environment_body(self, name: str, start: int) -> list[Piece]:
        closing, depth, first = name.replace("begin", "end"), 1, self.index
        while self.index < len(self.pieces):
            depth += (self.text == name) - (self.text == closing)
            self.index += 1
            if depth == 0:
                return self.pieces[first : self.index - 1]
        raise UnreadableError(f"the environment {name} is not closed", self.pieces[start].place)

    def cases(self, start: int) -> None:
        body = self.environment_body(r"\begin{cases}", start)
        self.emit("CASES")
        for row in split_pieces(body, (r"\\",)):
            value, *condition = split_pieces(row, ("&", r"\text", r"\mbox", r"\textrm", ",", r"\quad", r"\qquad"))
            if not any(not piece.text.isspace() for piece in value):
                continue
            self.inner(value)
            self.emit("CONDITION", " ".join("".join(p.text for p in part).strip(" {}") for part in condition).strip())
        self.emit("ENDCASES")

    # -- brackets

    def bracket(self) -> None:
        text = self.text
        if text in _BARS:
            kind = _BARS[text]
            left = text.startswith(r"\l") or not (self.ends_value() and kind in self.opened)
            self.emit(f"{kind}_OPEN" if left else f"{kind}_CLOSE", text)
            if left:
                self.opened.append(kind)
            else:
                self.close(kind)
        elif text in _OPENING:
            self.emit(_OPENING[text], text)
            self.opened.append(_OPENING[text])
            left = True
        else:
            self.emit(_CLOSING[text], text)
            partner = next(kind for mark, kind in _OPENING.items() if _CLOSING[_partner(mark)] == _CLOSING[text])
            self.close(partner)
            left = False
        if len(self.opened) + self.depth > MAX_NESTING:
            raise self.fail(f"expected at most {MAX_NESTING} levels of nesting, got more")
        self.index += 1
        if not left:
            self.after()

    def close(self, kind: str) -> None:
        if not self.opened or self.opened[-1] != kind:
            raise self.fail("a bracket is closed that is not open")
        self.opened.pop()

    def braces(self) -> None:
        start, inside = self.place, self.group()
        lexer = _Lexer(inside, self.known, self.functions, self.wide, self.depth + 1)
        if lexer.keeps_room():
            return
        if self.peek() in ("_", "^", "'") and inside and lexer.depth < MAX_NESTING and lexer.is_lone_letter():
            self.scripted(lexer.letter(), start)
        elif any(not piece.text.isspace() for piece in inside):
            self.inner(inside)
            self.after()

    def keeps_room(self) -> bool:
        r"""Whether there is nothing but room, as before the frame in ``{\vphantom{\omega}}^{B}\omega``."""
        self.skip()
        if self.text not in (r"\phantom", r"\hphantom", r"\vphantom"):
            return False
        self.index += 1
        self.group()
        self.skip()
        alone, self.index = self.index == len(self.pieces), 0
        return alone

    def is_lone_letter(self) -> bool:
        """Whether there is nothing but a letter, with its style and accents."""
        self.skip()
        if not self.is_symbol():
            return False
        self.letter()
        self.skip()
        alone, self.index = self.index == len(self.pieces), 0
        return alone

    def before_letter(self) -> None:
        """Read scripts before their letter, as of a frame: they go first in those behind it."""
        if (
            self.text == "^"
            and self.ends_value()
            and _is_behind([piece.text for piece in self.pieces[self.index + 1 :]])
        ):
            self.after()
            return
        start = self.place
        first = {"_": "", "^": ""}
        while self.text in first:
            mark = self.text
            self.index += 1
            first[mark] += _bare(self.group())
            self.skip()
        self.with_scripts(first["_"], first["^"], start)

    def command_before_letter(self) -> None:
        r"""Read a letter with scripts before it, as in ``\leftexp{B}{\omega}`` and ``\prescript{a}{b}{R}``."""
        start, command = self.place, self.text
        self.index += 1
        above = _bare(self.group())
        below = _bare(self.group()) if command == r"\prescript" else ""
        above, _, marked = above.lstrip("^").partition("_")
        inside = self.group()
        behind = self.group() if command == r"\leftidx" and self.peek() == "{" else []
        rest = self.pieces[self.index :]
        lexer = _Lexer(inside, self.known, self.functions, self.wide, self.depth + 1)
        if lexer.depth < MAX_NESTING and lexer.is_lone_letter():
            self.pieces, self.index = [*inside, *behind, *rest], 0
            self.with_scripts(below or marked, above, start)
        else:
            self.inner(inside)
            self.after()

    def with_scripts(self, below: str, above: str, start: int) -> None:
        """Read a letter, and put scripts before its own."""
        self.skip()
        while self.text == "{" and not self.is_symbol():
            inside = self.group()
            self.pieces, self.index = [*inside, *self.pieces[self.index :]], 0
            self.skip()
        if self.functions is not None and not self.is_symbol() and self.is_unknown_letter():
            self.chose = f"the command {self.text} is not known"
        elif not self.is_symbol():
            raise self.fail("scripts are read beside a letter only")
        letter = self.letter()
        primes, own_below, own_above = self.scripts()
        subscript = f"{below}_{own_below}" if below else own_below
        if above:
            subscript = f"{above}^{subscript}"
        axis = own_above if self.is_axis(letter, own_above) else ""
        self.name(written(letter, primes, subscript, axis), start)
        if not axis:
            self.power(own_above, self.raised)
        self.after()


def _is_behind(script: Sequence[str]) -> bool:
    r"""Whether a script above belongs to what stands before it, as in ``(AB){}^T``: a mark of matrices or a number."""
    inside = list(script[1 : [*script, "}"].index("}")]) if script[:1] == ["{"] else list(script[:1])
    return "".join(inside) in _MARKS or inside[:1] == ["-"] or all(each.isdigit() for each in inside)


def _outside_braces(pieces: Sequence[Piece]) -> list[Piece]:
    kept, depth = list[Piece](), 0
    for piece in pieces:
        depth += (piece.text == "{") - (piece.text == "}")
        if depth == 0:
            kept.append(piece)
    return kept


def _partner(opening: str) -> str:
    pairs = {"(": ")", "[": "]", r"\{": r"\}", r"\lbrace": r"\}", r"\lbrack": "]", r"\langle": r"\rangle"}
    return pairs[opening]


def _bare(pieces: Sequence[Piece]) -> str:
    text = "".join(_BOLD.get(piece.text, piece.text) for piece in pieces)
    return re.sub(r"\\(?:mathrm|text|textrm|mathit|bf|rm|left|right|[,;:!])(?![a-z])|[{}\s,]", "", text)


def split_pieces(pieces: Sequence[Piece], marks: Collection[str], brackets: bool = True) -> list[list[Piece]]:
    """Return the parts between marks that stand in no brace or environment, and in no bracket if that matters."""
    parts: list[list[Piece]] = [[]]
    depth = 0
    for piece in pieces:
        text = piece.text
        depth += (text == "{" or (brackets and text in ("(", "[", r"\{")) or text.startswith(r"\begin{")) - (
            text == "}" or (brackets and text in (")", "]", r"\}")) or text.startswith(r"\end{")
        )
        if depth <= 0 and text in marks:
            parts.append([])
        else:
            parts[-1].append(piece)
    return parts


def _derivative(above: str, below: str) -> str | None:
    r"""Return the text of a derivative, empty for d/dx before what it is of; None if a fraction is none.

    Examples
    --------
    >>> _derivative("dy", "dx"), _derivative("\\partial", "\\partialx"), _derivative("d", "2")
    ('dy/dx', '', None)
    """
    sign = next((each for each in (r"\partial", "d") if above.startswith(each) and below.startswith(each)), None)
    if sign is None or len(below) == len(sign) or not re.match(r"[A-Za-z\\(]", below[len(sign) :]):
        return None
    rest = re.sub(r"^\^?\d*", "", above[len(sign) :])
    return f"{above}/{below}" if rest else ""


def _without_idle_separators(tokens: list[Token]) -> list[Token]:
    """Drop separators beside an operator or a bracket: wide spaces that separate nothing."""
    kept: list[Token] = []
    for place, token in enumerate(tokens):
        following = tokens[place + 1].type if place + 1 < len(tokens) else "ROW"
        if token.type == "SEPARATOR" and token.value == " ":
            before = kept[-1].type if kept else "ROW"
            idle = before not in _VALUE_ENDS or following in ("SIGN", "RELATION", "SLASH", "DOT", "CROSS", "AMP", "ROW")
            if idle or following in ("RP", "RS", "SEPARATOR"):
                continue
        kept.append(token)
    return kept
