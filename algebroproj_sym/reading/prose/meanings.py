r"""What words say of letters and signs by which an equation says something else than it looks like.

``y = \sigma(w + b)`` is no product where the text calls σ an activation, and ``x = y`` is no equality of numbers where
everything is modulo 4.  Such an equation is read, but not decided.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from lark import Token, Tree

from algebroproj_sym.reading.documents.displays import Display
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.lexing.commands import OF_ANGLES
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.grammar import IN_BRACKETS, Formula, Parsed, symbols_in, trees_in
from algebroproj_sym.reading.parsing.repeating import atom_of, paired_in, repeated_in, summed_silently, twice_in
from algebroproj_sym.reading.prose.acting import acted_on
from algebroproj_sym.reading.prose.devices import heard, says
from algebroproj_sym.reading.prose.inner import products_in
from algebroproj_sym.reading.prose.phrases import SET, called, symbols_in_list

ITERATE = "a power of a function may mean that it is applied again"
VARIES = "may be a different number each time"
_SIGNS = (
    ("<modular>", "", "numbers may be equal modulo another one"),
    ("<integer-division>", r"/|\\[dt]?frac", "a division of integers may drop a remainder"),
    ("<other-signs>", "", "its signs may not mean what they mean for numbers"),
    *(
        (
            rf"\$\s*{sign}\s*\$ (?:means|denotes|stands|marks|is)\b",
            latex,
            "one of its signs may not mean what it means for numbers",
        )
        for sign, latex in (("!", "!"), (r"\+", r"\+"), ("/", r"/|\\[dt]?frac"), (r"\\cdot", r"(?<![_^{])\\cdot"))
    ),
    *(
        (
            rf"(?<![a-z])\\?{name}\$? (?:denotes|means|stands for)\b"
            r"(?![^.;]*\b(?:co)?(?:sine|tangent|logarithm|exponential|function\b(?! of)|inverse|base))",
            rf"\\?(?<![a-z]){name}(?![a-z])",
            f"{name} may not be the function of that name",
        )
        for name in ("sin", "cos", "tan", "exp", "log", "ln")
    ),
    ("<differential>", r"\\[dt]?frac\s*\{\s*d", "d may be a factor"),
    (
        "<whole-parts>",
        r"\[(?!\s*\\begin)|\\\{|\\lbrack|\\lbrace",
        "a bracket may stand for an integer or a fractional part",
    ),
    ("<bracket-products>", r"(?<![a-zA-Z}])(?:\(|\[)[^()\[\],]+,[^()\[\],]+(?:\)|\])", "a bracket may be a product"),
    ("<complex-products>", r"\\langle[^|]+,[^|]+\\rangle", "an inner product may be of complex vectors"),
    (
        "<composition>",
        r"(\\[a-zA-Z]+|[a-zA-Z]|\})\s*(?:_(?:\w|\{[^{}]*\})\s*)?\^\s*\{?\s*[2-9]\s*\}?\s*(?:\\left\s*)?\(",
        ITERATE,
    ),
    ("<exclusive-or>", r"\^", "a caret may be the exclusive or"),
    ("<concatenation>", "", "its products may not be products of numbers"),
    ("<other-digits>", r"\d\d", "its digits may have another base than ten"),
    (
        "<by-entries>",
        r"(?<!\\partial)(?<!\\partial )(?<!d)(?<!d )\\(?:mathbf|boldsymbol|vec|bm)\s*\{\s*[a-z]\s*\}\s*\^\s*\{?\s*2",
        "the square of a vector may be the square of each entry",
    ),
    ("<other-primes>", r"'\s*\(", "a prime may be something else than a derivative"),
    ("<convolution>", r"(?<![\^_{])(?:\*|\\ast|\\star)", "a star may be the convolution"),
)
"""What the text says, which LaTeX it concerns, and why an equation with it is not decided."""
_CONVENTION = heard("<convention>")
_SUPERSCRIPTS = heard("<superscripts>")
_BOUNDARY = re.compile(
    r"\bboundar[^.$]*\$\\partial|\$\\partial[^$]*\$ (?:be|is|denotes) (?:the|an?|its) [^.$]{0,30}\bboundar",
    re.IGNORECASE,
)
"""Words by which a curved d before a letter is its boundary."""
CHANGES = re.compile(r"/|dot|'")
"""What stands in the symbol of a derivative."""
_DEGREES = re.compile(
    r"\b(?:is|are|be|measured|given|expressed|angles?) in (?:degrees|gon|grads)\b|\bset to degrees\b"
    r"|\$,? (?:in degrees|[\[(](?:in )?(?:deg(?:rees?)?\b|\\(?:si|unit)\{\\degree\}|\$\^\\circ\$))|\$ *\| *deg",
    re.IGNORECASE,
)
_BASES = heard("<bases>")
_FILLER = re.compile(r"const(?:ant)?s?\.?|h\.?o\.?t\.?s?|(?:higher|lower)-?order-?(?:terms)?|noise|etc\.?")
"""Names that stand for another thing each time."""
_ORDER = re.compile(
    r"(?<![a-zA-Z\\_])(?<!_\{)(?:\\mathcal\s*\{?\s*)?[Oo]\s*\}?\s*(?:\\left\s*)?\("
    r"|\\(?:Theta|Omega)\s*(?:\\left\s*)?\((?=\s*(?:[nN]\b|\\log))"
)
_DRAW = re.compile(r"\\mathcal\s*\{?\s*[NU]\s*\}?\s*(?:\\left\s*)?\((?:(?!\\mid|\\vert)[^()|;])*\)")
_SIGN = (
    r"\$\s*(?:[-+*]|\\(?:wedge|vee|hat|check|oplus|ominus|otimes|odot|circ|boxplus|boxminus|times|cdot|star|ast))\s*\$"
)
_OF_SIGNS = re.compile(
    rf"\boperators:? {_SIGN}|{_SIGN} operators\b|"
    r"\b(?:hat|wedge|vee|skew(?:-symmetric)?|boxplus|boxminus|oplus) operators\b"
)
"""Operators that are signs: no letter with a hat stands for one."""
_DERIVATIVE = r"(?:derivative(?! (?:of|with)\b)|differentiation)"
_RATE = re.compile(r"[a-ce-z]_.+")
"""What is a derivative, and none that acts: ``u_x``."""
_EXPECTATIONS = r"(?:expectation|expected value)(?! (?:of|with)\b)"
_MEAN = re.compile(r"(?:\\math[a-z]+\{)?[EM]\}?")
"""How the operator of an expected value may look; another letter is a value."""
_OPERATORS = rf"(?:(?<!projection )(?<!rotation )operators?|{SET})"
_MAPS = r"(?:(?:maps?|mappings?)(?! of\b)|activations?|kernels?(?! (?:matri|evaluated\b)))"
_FUNCTIONS = rf"(?:(?:functions?|functionals?)(?! of\b)|{_MAPS})"
_SIGNALS = (
    r"(?:signals?|potentials?|distributions?|(?<=probability )densit(?:y|ies)|spectr(?:um|a)|(?:refractive )?index|"
    r"windows?|(?:frequency|impulse|step) responses?|shapes?|wave ?forms?|profiles?)"
)
_NUMBER = re.compile(r"\b(?:ratio|circle|number|constant|half)\b|3\.14")
_CLAUSE = re.compile(r"[,.;]")
_CALLED = re.compile(r"^\s*(?:is|are|be|denotes?|represents?)\b")
_IS_NAME_OF = re.compile(r"\b(?:the|an?) (?!value |factor |angle |phase |limit |interval )[a-z]{4,} $")
_EACH_TIME = re.compile(
    r"\$([^$=]*)\$[^.$]*\b(?:constants?|noise)\b[^.$]*"
    r"\b(?:each time(?! (?:step|interval|level|point|instant)s?\b)"
    r"|anew|afresh|from (?:one )?(?:line|place|equation) to|not necessarily the same"
    r"|need not be (?:equal|the same)|(?:each|every) occurrence)",
    re.IGNORECASE,
)
_INVERSE = re.compile(
    r"\$([^$^]+)\^\{?-1\}?\$ (?:be|is|denotes) (?:the |its )?inverse (?:map|mapping|function|transform)\b"
)
_MATERIAL = re.compile(r"D|\\mathcal\{D\}")
_DEPENDING = re.compile(
    r"\$([^$=]+)\$(?: of [^$.,;]*)? (?:depends? (?:only )?on|(?:rises|falls|grows|decreases|increases|varies) with)\b"
)
_AT_A_TIME = re.compile(
    r"\$([^$=]+)\$ (?:be|is|denotes?) (?:the |its )[a-z]+(?: [a-z]+)? at (?:the )?[a-z]+ \$([a-z])\$"
)
"""Words by which a letter before a bracket may be a function of what stands within it."""
_DEPENDS = re.compile(
    r"\$([^$]+)\$(?:,? (?:which|that))? (?:(?:is|are|be|being|as) (?:an? |the )?(?:\w+ ){0,2}functions? of"
    r"|(?:depends?|varies|changes) (?:\w+ )?(?:on|with)) (?:the \w+ )?\$([^$]+)\$"
)


_MOVES = re.compile(
    r"\$([^$=]+)\$ (?:also |itself )?(?:moves|changes|varies|rotates|grows|shrinks|drifts|decreases|increases|rises|"
    r"falls|decays)\b(?! with\b)"
)


def functions_called(statements: Iterable[Statement]) -> frozenset[str]:
    """Return the letters that words call functions: a bracket behind one is its argument."""
    every = tuple(statements)
    words = prose_of(every)
    spoken = [*_DEPENDING.findall(words), *(letter for letter, _ in _AT_A_TIME.findall(words))]
    return (
        called(every, _FUNCTIONS) | called(every, _SIGNALS) | {each for one in spoken for each in symbols_in_list(one)}
    )


def has_superscripts(words: str) -> bool:
    """Whether the text says that what stands above a letter is an index."""
    return _SUPERSCRIPTS.search(words) is not None


def axes_turn(words: str) -> bool:
    """Whether the text speaks of axes that turn or move."""
    return says("<axes-turn>", words)


def dependences(words: str) -> Iterator[tuple[str, str]]:
    """Yield the pairs of letters of which the first is said to be a function of the second; what moves is one of t."""
    yield from ((symbol, "t") for each in _MOVES.findall(words) for symbol in symbols_in_list(each))
    yield from ((symbol, "t") for symbol in sorted(acted_on(words)))
    for match in _DEPENDS.finditer(words):
        yield from ((one, other) for one in symbols_in_list(match[1]) for other in symbols_in_list(match[2]))


def prose_of(statements: Iterable[Statement]) -> str:
    """Return the text between the displays of a document, each part of it once."""
    displays: dict[int, Display] = {id(each.display): each.display for each in statements}
    words: list[str] = []
    for each in displays.values():
        if each.environment != "inline":
            words += [each.before]
    for last in [*displays.values()][-1:]:
        words += [last.before, f"${last.latex}$" if last.environment == "inline" else "", last.after]
    return " ".join(" ".join(words).split())


@dataclass(frozen=True)
class Meanings:
    """What the words of a document say of its letters and signs."""

    statements: Sequence[Statement]
    """All statements of the document."""
    words: str
    """The text between its displays."""
    equations: Sequence[Sequence[Formula]]
    """The sides of each of those that were read."""
    given: frozenset[str]
    """The symbols that are alone on the left somewhere."""
    iterated: frozenset[str]
    """The symbols that have the number of a step above them somewhere."""
    gives_products: bool
    """Whether the document says itself what an inner product is."""

    @cached_property
    def _paired(self) -> frozenset[str]:
        return paired_in(self.equations)

    @cached_property
    def _has_degrees(self) -> bool:
        return _DEGREES.search(self.words) is not None

    @cached_property
    def sides(self) -> Sequence[Formula]:
        """The sides of all."""
        return [side for sides in self.equations for side in sides]

    @cached_property
    def _has_bases(self) -> bool:
        return _BASES.search(self.words) is not None

    @cached_property
    def _has_operators(self) -> bool:
        return re.search(r"\boperators\b", _OF_SIGNS.sub("", self.words)) is not None

    @cached_property
    def has_convention(self) -> bool:
        """Whether words say that sums are taken over repeated indices."""
        return _CONVENTION.search(self.words) is not None

    @cached_property
    def _has_boundaries(self) -> bool:
        return _BOUNDARY.search(self.words) is not None

    @cached_property
    def _signs(self) -> list[tuple[re.Pattern[str], str]]:
        text = " ".join([self.words, *(each.latex for each in self.statements)])
        said = (each for each in _SIGNS if says(each[0], text))
        return [(re.compile(latex), reason) for _, latex, reason in said]

    @cached_property
    def _letters(self) -> dict[str, str]:
        """Letters that are no numbers, each with what it may be."""
        acting = {each for each in called(self.statements, _DERIVATIVE) if not _RATE.fullmatch(each)}
        means = {each for each in called(self.statements, _EXPECTATIONS) if _MEAN.fullmatch(split_symbol(each)[0])}
        found = dict.fromkeys(called(self.statements, _OPERATORS) | acting | means, "is not a number")
        for each in self.statements:
            before, after = each.display.before[-60:], each.display.after[:60]
            is_named = _CALLED.match(after) or _IS_NAME_OF.search(before)
            is_inline = each.display.environment == "inline" and each.latex.strip() == r"\pi"
            if is_inline and is_named and not _NUMBER.search(before[-20:] + _CLAUSE.split(after)[0]):
                found[r"\pi"] = "is not the number here: words call it something else"
        for match in _EACH_TIME.finditer(self.words):
            found |= dict.fromkeys(symbols_in_list(match[1]), VARIES)
        return found

    @cached_property
    def _applied(self) -> frozenset[str]:
        """The letters that have an argument somewhere."""
        return frozenset(str(call.children[0]) for side in self.sides for call in side.find_data("call"))

    @cached_property
    def _functions(self) -> frozenset[str]:
        """The letters that are functions: a factor is none that is called a function, and has no argument anywhere."""
        inverse = (symbol for each in _INVERSE.findall(self.words) for symbol in symbols_in_list(each))
        named = called(self.statements, _MAPS) | (called(self.statements, _FUNCTIONS) & self._applied)
        return frozenset((*inverse, *(each for each in named if not CHANGES.search(each))))

    @cached_property
    def _labelled(self) -> frozenset[tuple[str, bool]]:
        """The letters with a number, or a letter, above them that is said, or looks, to be an index."""
        found = {(symbol, True) for symbol in self.iterated}
        for side in self.sides:
            if side.data == "power" and atom_of(side.children[1]) in ("0", "1"):
                found.add((atom_of(side.children[0]), True))
        for each in self.statements:
            if each.display.environment == "inline":
                found |= {(symbol, True) for letter in _FIRST.findall(each.latex) for symbol in symbols_in_list(letter)}
            match = _NAMED.fullmatch(each.latex.strip())
            first = each.display.environment == "inline" and _OF_ORDER.match(each.display.after)
            if first and (coordinate := _SQUARE.fullmatch(each.latex.strip())):
                found |= {(symbol, True) for symbol in symbols_in_list(coordinate[1])}
            power = re.search(r"\b(?:powers?|exponential|monomials?|square\w*|varianc\w+)\b", each.display.after[:60])
            if match and each.display.environment == "inline" and _CALLED.match(each.display.after) and not power:
                numbers = (not match[1], _IN_ORDER.search(each.display.after[:30]) is not None)
                found |= {(symbol, flag) for symbol in symbols_in_list(match[1] or match[2]) for flag in numbers}
        return frozenset(found)

    def is_label(self, tree: Formula) -> bool:
        """Whether what stands above a letter is said, or looks, to be an index."""
        if tree.data != "power":
            return False
        base, exponent = map(atom_of, tree.children)
        return (base, exponent.isdigit()) in self._labelled

    @cached_property
    def _primes(self) -> frozenset[str]:
        """The letters by which words say that a prime is the derivative."""
        return frozenset(symbol for each in _PRIME.findall(self.words) for symbol in symbols_in_list(each))

    def _by_another(self, formula: Parsed) -> bool:
        """Whether a prime is the derivative by another letter than the argument of its function."""
        calls = [each for side in formula.sides for each in side.find_data("call") if "'" in str(each.children[0])]
        arguments = [{letter for part in trees_in(each) for letter in symbols_in(part)} for each in calls]
        return bool(self._primes) and any(letters and not letters & self._primes for letters in arguments)

    def reason(self, statement: Statement, formula: Parsed) -> str:
        """Return why an equation may say something else than it looks like; empty for no reason."""
        if self._by_another(formula):
            return "a prime is the derivative by another letter"
        latex = "".join(piece.text for piece in statement.pieces)
        for pattern, reason in self._signs:
            match = pattern.search(latex)
            if match and (reason != ITERATE or match[1] == "}" or match[1] in self._applied):
                return reason
        if self._has_boundaries and r"\partial_" in statement.display.latex.replace(" ", ""):
            return "∂ may be part of a boundary, and not a derivative"
        if self.gives_products and any(True for side in formula.sides for _ in products_in(side)):
            return "the document defines the inner product in its own way"
        if match := _MICRO.search(statement.latex):
            return f"{match[1]} may be a unit"
        if _TRANSFORM.search(latex):
            return "a letter before a brace may be an operator"
        if match := _ORDER.search(latex) or _DRAW.search(latex):
            return f"{match[0].rstrip('( ')}(...) {VARIES}"
        symbols = {symbol for side in formula.sides for symbol in symbols_in(side)}
        for symbol in sorted(symbols):
            if symbol == "const" and not any(symbol in map(atom_of, side.children) for side in _sums_in(formula.sides)):
                return f"{symbol} stands for a factor that the document does not give"
            if _FILLER.fullmatch(symbol) and symbol not in self.given:
                return f"{symbol} {VARIES}"
            if symbol in self._letters:
                return f"{symbol} {self._letters[symbol]}"
            if symbol.startswith(r"\hat{") and self._has_operators:
                return f"{symbol} may be an operator"
        index = summed_silently(formula.sides) or (twice_in(formula.sides) if self.has_convention else "")
        if index:
            return f"the index {index} {SUMMED}"
        thrice = {each for side in formula.sides for each in repeated_in(side, 3)}
        if paired := thrice & self._paired:
            return f"the index {min(paired)} stands three times in a term, and twice elsewhere"
        spaces = [side for relation, side in zip(formula.relations, formula.sides[1:], strict=True) if relation == "∈"]
        sides = [side for side in formula.sides if not any(side is space for space in spaces)]
        return next((reason for side in sides if (reason := self._of_tree(side, symbols))), "")

    def _of_tree(self, tree: Formula, symbols: set[str]) -> str:
        if tree.data == "run" and len(tree.children) == 2:
            one, other = tree.children
            if (
                _is_number(one)
                and isinstance(other, Tree)
                and other.data == "fraction"
                and all(map(_is_number, other.children))
            ):
                return "a number before a fraction may be added to it, as in 1 1/2"
        pairs = (pair for run in tree.find_data("run") for pair in pairwise(run.children))
        if any(_is_symbol(one) and _is_group(other) and _is_number(other) for one, other in pairs):
            return "a number in brackets may be the number of a sample"
        changes = any(map(CHANGES.search, symbols)) or any(True for _ in tree.find_data("slope"))
        for part in tree.iter_subtrees():
            head = str(part.children[0]) if part.children and isinstance(part.children[0], Token) else ""
            if part.data in ("function", "raised_function"):
                if changes and head in OF_ANGLES and self._has_degrees:
                    return "angles are in degrees"
                if head == "log" and self._has_bases:
                    return "the base of logarithms is not e"
            if part.data == "fraction" and all(_is_material(each) and not atom_of(each) for each in part.children):
                return "D may be a derivative"
            if self.is_label(part):
                return "a superscript may be an index"
            if part.data in ("run", "product", "power", "fraction", "quotient"):
                factors = {atom_of(each) for each in part.children} & self._functions
                if factors:
                    return f"{min(factors)} is a function, so it is not a factor"
        return ""


SUMMED = "may be summed over without a summation sign"
_PRIME = re.compile(r"\bprimes?\b[^.$]*\b(?:derivatives?|differentiation)\b[^.$]*\$([^$]*)\$", re.IGNORECASE)
_MICRO = re.compile(r"=\s*[\d.]+\s*(?:\\[,;: ]|~)?\s*(\\mu\s*(?:\\[,;:])?\s*[mgsAVFHJWN])\s*[.,]?\s*$")
_TRANSFORM = re.compile(r"\\(?:mathcal|mathscr|mathfrak)\s*\{?\s*[A-Z]\s*\}?\s*(?:\\left\s*)?(?:\\\{|\\lbrace)")


_NAMED = re.compile(
    r"((?:[a-zA-Z]|\\[a-z]+)(?:_\{?\w+\}?)?)\s*\^\s*\{?\s*[a-zA-Z]\s*\}?"
    r"|((?:[a-zA-Z]|\\[a-z]+)_\{?\w+\}?)\s*\^\s*\{?\s*\d\s*\}?"
)


_FIRST = re.compile(r"(?<![a-zA-Z\\])([a-zA-Z]|\\[a-z]+)\s*\^\s*(?:\{\s*1\s*\}|1)(?=\s*(?:,|$))")
"""A letter of a list with a one above it, which is no power: ``p^1, p^2``."""
_SQUARE = re.compile(r"([a-zA-Z]|\\[a-z]+)\s*\^\s*\{?\s*\d\s*\}?")
_OF_ORDER = re.compile(
    r"\s*(?:is|be|denotes?) (?:the |its )?(?:first|second|third|\w+th|\$\d\$-\w+) "
    r"(?:coordinate|component|entry|element)\b"
)
"""How words say that what stands above a letter is the number of a coordinate."""
_IN_ORDER = re.compile(r"^\s*(?:is|be|denotes?) (?:the|an?) \$\w+\$ ?-?th\b")
"""How words number what has an index: "$x^k$ is the $k$-th iterate"."""


def _sums_in(sides: Sequence[Formula]) -> Iterator[Formula]:
    """Yield the sums of an equation, and the sides that are none."""
    for side in sides:
        yield from (side, *side.find_data("sum")) if side.data != "run" else side.find_data("sum")


def _is_number(tree: object) -> bool:
    return atom_of(tree)[:1].isdigit()


def _is_symbol(tree: object) -> bool:
    return isinstance(tree, Tree) and tree.data == "symbol"


def _is_group(tree: object) -> bool:
    return isinstance(tree, Tree) and tree.data in IN_BRACKETS


def _is_material(tree: object) -> bool:
    """Whether a product begins with a D, or with a power of D, as above and below in Dx/Dt."""
    if not isinstance(tree, Tree) or not tree.children:
        return False
    if tree.data in ("run", "group", "power"):
        return _is_material(tree.children[0])
    return tree.data == "symbol" and _MATERIAL.fullmatch(split_symbol(str(tree.children[0]))[0]) is not None
