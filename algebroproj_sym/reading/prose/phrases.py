r"""Phrases by which a document says what a letter is: its size, or a property such as that of a rotation.

::

    $\mathbf{x} \in \mathbb{R}^3$, $R \in SO(3)$             sizes, and a rotation
    $R$ is a rotation matrix, the rotation matrix $R$,       likewise orthogonal, symmetric, skew-symmetric,
    $n$ is a unit vector, the unit vector $n$                positive definite and diagonal matrices
    $I$ is the identity matrix, the identity matrix $I$
    $P$ and $Q$ are symmetric matrices                       likewise
    the covariance matrix $P$                                a symmetric matrix

Behind "if", "when", "unless", "not" or "whether" a phrase says nothing.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import TypeVar

from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.lexing.pieces import UnreadableError, pieces_of, split_pieces
from algebroproj_sym.reading.parsing.factors import LIKE_IDENTITY
from algebroproj_sym.reading.parsing.grammar import parsed, symbols_in, without_brackets
from algebroproj_sym.reading.prose.devices import heard, says

_KINDS = (
    "rotation",
    "positive definite",
    "skew",
    "symmetric",
    "orthogonal",
    "diagonal",
    "unit",
    "identity",
    "covariance",
)
_ANY = "|".join(f"(<is-{kind.replace(' ', '-')}>)" for kind in _KINDS)
_SEVERAL = re.sub("vector|quaternion", r"\g<0>s", heard(_ANY).pattern.replace("matrix", "matrices"))
_AFTER = heard(
    rf"^\$?\s*(?:, (?:which|that) )?(?:is|denotes|represents)\s+(?:an? |the )?(?:{_ANY})(?![\w-])", re.NOFLAG
)
_BESIDE = heard(rf"^\$?,?\s*(?:an?|the) (?:{_ANY})(?=\s*(?:[.,;:)]|and\b|$))", re.NOFLAG)
_ARE = re.compile(
    r"^\$?\s*(?:(?:,|and|,\s*and)\s*\$[^$]*\$\s*)*are\s+(?:the )?"
    rf"(?:{_SEVERAL})(?![\w-])"
)
_BE = heard(rf"^\$?\s*be\s+(?:an? |the )?(?:{_ANY})(?![\w-])", re.NOFLAG)
_LET = re.compile(r"\blet(?: the \w+)?\s*\$?$", re.IGNORECASE)
_BEFORE = heard(rf"(?<![\w-])(?:{_ANY})\s*$", re.NOFLAG)
_OF = re.compile(r"\bof (?:the |an? )?[\w -]*$")
_OF_TWO = re.compile(r"[_^]\{?[^{}]*?(\w)\W*(?!\1)\w")
"""What is below the covariance matrix of one thing with another one, which is not symmetric."""
_ADJECTIVES = ("skew", "symmetric", "diagonal", "positive definite")
"""What may belong to another noun, unless "matrix" follows."""
_DOUBTS = heard(r"\b<if doubts>\b[^.]*$")
_NO = heard(r"\b<no>\b(?: [\w-]+){0,3} ?\$?$")
_NOT = re.compile(r"^\$?\s*(?:(?:does|do|is|are|need|can|must) ?not|fails|is (?:false|wrong|impossible))\b")
_OF_IT = re.compile(
    r"\bof(?: the| an?)?(?: (?:matrix|matrices|vectors?|tensors?))?\s*(?:\$[^$]*\$\s*(?:,|and|,\s*and)\s*)*$"
)
"""What is said of the square of a letter is not said of the letter."""
_CAPITAL = re.compile(r"(?:\\[a-z]+\{)?[A-Z](?![a-z])")
_SET = re.compile(r"(?:\bSet|\b(?:we|us|and|to|then|now|can|may|let|if|[Bb]y) set) ?$")
"""How an order or a choice ends, as in "Set x = 2": it speaks of no set."""
_THE = r"(?:^|[.;:,] ?|\b(?:where|and|with|let|that|so) )(?:the|an?|our|its) (?:(?!of |in |to |from )[\w-]+ ){0,3}"
_VECTORS = r"matri(?:x|ces)|vectors?|tensors?"
Value = TypeVar("Value")
_SPACE_OF = re.compile(
    r"^\s*(.+?)\s*\\in\s*\\(?:mathbb|R|mathbf)\s*\{?\s*R?\s*\}?\s*\^\s*\{?\s*(\d)\s*(?:\\times\s*(\d))?\s*\}?\s*$"
)
_OF_MATRICES = re.compile(
    r"^\s*(.+?)\s*\\in\s*(?:\\(?:mathbb|mathbf)\s*\{?\s*[RC]\s*\}?\s*\^\s*\{\s*[a-zA-Z]\s*\\times\s*[a-zA-Z]\s*\}"
    r"|(?:\\(?:mathrm|mathbf|text|operatorname|mathbb|mathcal)\s*)?\{?\s*(?:[GS]L|S?[OUE]|Sp|M_n|M_\{n\})\s*\}?\s*\()"
)
_VECTOR_SPACE = re.compile(
    r"^\s*(.+?)\s*\\in\s*(?:\\(?:mathbb|mathbf|Bbb)\s*\{?\s*[RC]\s*\}?|\\R(?![a-zA-Z]))\s*\^\s*\{?\s*(?:[a-zA-Z]|[2-9]|\d+\s*\\times|\d\d)"
)
_COMPLEX = re.compile(r"^\s*(.+?)\s*\\in\s*\\(?:mathbb|mathbf|Bbb)\s*\{?\s*C\b")
_REAL = re.compile(
    r"^\s*(.+?)\s*\\in\s*(?:\\(?:mathbb|mathbf|Bbb)\s*\{?\s*[RZNQ]\b|(?:\\left\s*)?[\[(]|\\R(?![a-zA-Z]))(?!\s*\}?\s*\^)"
)
_OF_SUMS = ("symmetric", "positive definite", "diagonal")
"""The properties that covariances may have."""
_IS_CALLED = re.compile(
    r"^\$?\s*(?:now |here |then )?(?:is|be|denotes|represents|stands for|means)\s+(?:now |here )?"
    r"(?:the|an?|our|its)\s+([^.,;$]*)"
)
_OF_NOISE = re.compile(r"\b(?:noise|(?:co)?variance|resistance|radius|gas constant|range)\s*$", re.IGNORECASE)
_LISTED_BEFORE = re.compile(r"(?:^|[:,;(]|\band)\s*$")
_LISTED_BEHIND = re.compile(
    r"^ ?(?:(?!of|in|the|an?|and|with|for|times|is|as|by)[a-z-]+ ){0,2}(?:matrix|vector|tensor)\s*(?:[.,;)]|$)"
)
"""How a list calls a letter: "$M$ mass matrix,"."""
_ROTATIONS = re.compile(
    r"^\s*(.+?)\s*\\in\s*(?:\\(?:mathrm|mathbf|text|operatorname|mathbb)\s*)?\{?\s*SO\s*\}?\s*\(\s*([23])\s*\)\s*$"
)


def _beside(statement: Statement) -> tuple[str, str]:
    """Return the words before a formula and behind it, on one line."""
    return " ".join(statement.display.before.split()), " ".join(statement.display.after.split())


def _inline(statements: Iterable[Statement]) -> Iterator[Statement]:
    """Yield the formulas within the text."""
    return (each for each in statements if each.display.environment == "inline")


def sizes_in(statements: Iterable[Statement]) -> dict[str, tuple[int, int]]:
    """Return symbols with their rows and columns; without those of which a document says two things."""
    return _agreed(_sizes(statements))


def properties_in(statements: Iterable[Statement]) -> dict[str, tuple[str, ...]]:
    """Return symbols with what they are; without those of which a document says two things."""
    every = tuple(statements)
    parts = [(pair, each.display.part) for each in every for pair in _properties((each,))]
    strong = {symbol for (symbol, (kind,)), _ in parts if kind in ("positive definite", "diagonal")}
    said = ((symbol, kinds) for (symbol, kinds), _ in parts if kinds != ("symmetric",) or symbol not in strong)
    own = {symbol: part for (symbol, _), part in parts}
    others = {symbol for symbol, part in _called_otherwise(every) if part != own.get(symbol, part)}
    agreed = _agreed(said)
    return {symbol: kinds for symbol, kinds in agreed.items() if symbol not in others or kinds[0] in _OF_SUMS}


def _called_otherwise(statements: Iterable[Statement]) -> Iterator[tuple[str, int]]:
    """Yield the letters that words call something that has none of the properties, each with its section."""
    for each in _inline(statements):
        before, after = _beside(each)
        behind = _IS_CALLED.match(after)
        if _OF_NOISE.search(before) or (behind and not heard("<has-property>").search(behind[1])):
            yield from ((symbol, each.display.part) for symbol in symbols_in_list(each.latex, 1))


SET = (
    r"(?:(?:(?<=the )|(?<=a ))"
    r"set(?! (?!(?:of|in|is|are|has|and|with|on|over|that|which|where|for|to|as|from|such)\b)[a-z])"
    r"|(?<!data )sets|events?)"
)
"""Words for a set, and not for a value that is set, as "the set voltage"."""


def matrices_in(statements: Iterable[Statement], angles: frozenset[str]) -> frozenset[str]:
    r"""Return the symbols that are said to be vectors, matrices, operators or quaternions: their order matters.

    An angle is no rotation: "$\Omega$ is defined by a rotation", or it is the angle of one.
    """
    every = tuple(statements)
    return frozenset().union(
        called(
            every,
            rf"(?:{_VECTORS}|quaternions?|operators?|{SET}|groups?|maps?|"
            r"homograph(?:y|ies))",
            of_time=True,
        ),
        called(every, r"(?:rotations?|permutations?|strings?|reflections?|transformations?)") - angles,
        (symbol for each in every if (match := _OF_MATRICES.match(each.latex)) for symbol in symbols_in_list(match[1])),
    )


def vectors_in(statements: Iterable[Statement]) -> frozenset[str]:
    """Return the symbols that are said to be vectors or matrices, or of a space: what is added to them is one, too."""
    every = tuple(statements)
    members = (side for each in every if (match := _VECTOR_SPACE.match(each.latex)) for side in match[1].split("="))
    return called(every, rf"(?:{_VECTORS})", of_time=True).union(
        (symbol for each in members for symbol in symbols_in_list(each)),
        (symbol for each in _inline(every) if _is_listed(each) for symbol in symbols_in_list(each.latex, 1)),
    )


def _is_listed(statement: Statement) -> bool:
    """Whether a list of letters calls a formula a vector or a matrix, without a verb."""
    before, after = _beside(statement)
    return _LISTED_BEFORE.search(before) is not None and _LISTED_BEHIND.match(after) is not None


def columns_in(statements: Iterable[Statement]) -> frozenset[str]:
    r"""Return the symbols that are said to be vectors, in words or as in ``x \in \mathbb{R}^n``, and no rows."""
    every = tuple(statements)
    columns = (each for each in every if r"\times" not in each.latex.partition(r"\in")[2] and not _is_denied(each))
    members = _members(columns, _VECTOR_SPACE)
    others = called(every, r"(?:matri(?:x|ces)|tensors?|row[- ]vectors?|rows?)")
    return (called(every, r"vectors?(?! (?:sub)?spaces?| bundles?| fields?)") | members) - others


def complexes_in(statements: Sequence[Statement]) -> frozenset[str]:
    r"""Return the symbols that are said to be complex, in words or as in ``z \in \mathbb{C}``."""
    return called(statements, r"complex(?: (?:[a-z-]+|number|variable)s?)?") | _members(statements, _COMPLEX)


def reals_in(statements: Sequence[Statement]) -> frozenset[str]:
    r"""Return the symbols that are said to be real, in words or as in ``x \in \mathbb{R}`` and ``x \in [0, 1]``."""
    real = r"(?:real|positive|negative|nonnegative|non-negative)(?: (?:[a-z-]+|number|variable)s?)?"
    return called(statements, real) | _members(statements, _REAL)


def _members(statements: Iterable[Statement], of: re.Pattern[str]) -> frozenset[str]:
    """Return the symbols that formulas put into a set."""
    found = (match[1] for each in statements if (match := of.match(each.latex)))
    return frozenset(symbol for each in found for symbol in symbols_in_list(each))


_AND_OTHERS = r"(?:\$[^$]*\$ ?(?:, ?and|,|and) ?)*"
_NO_THING = (
    r"(?!(?:of|in|for|and|with|or|on|by|to|from|at|as|is|are|but|while|when|where|if|than|that|the|an?|along|over|under"
    r"|about|around|between|across|through|towards?|per|near|up|within)\b)"
)
_KIND = r"(?:[a-z-]+(?:al|ar|ic|ed|ive|ous|ary)|link|total|mean) "
"""An adjective, or a noun that is none of a verb, as in "constant angular rate" and unlike "constant wind drives"."""
_CONSTANT_BEFORE = re.compile(
    rf"(?<![\w-])(?<!wise )(?<!ly )(?<!most )(?:constants? {_AND_OTHERS}"
    rf"|(?:constant|fixed) (?:{_KIND})?{_NO_THING}(?:[a-z-]*(?:[^s\W]|ss|us|is) |[a-z-]+s {_AND_OTHERS}))$",
    re.IGNORECASE,
)
_CONSTANT_BEHIND = re.compile(
    r"(?:(?:, ?and|,|and) ?(?:the (?:[a-z]+ ){1,2})?\$[^$]*\$ ?)*"
    r"(?:(?:is|are|being|stays?|remains?|be) (?:(?:both|all|taken|assumed|kept|held|to be|as|a) )*(?:constants?|fixed)"
    r"|(?:does|do) not change)(?: (?:in|with) time\b)?(?:\s*[.,;:)]| (?:and|so)\b|$)",
    re.IGNORECASE,
)


def constants_in(statements: Iterable[Statement]) -> frozenset[str]:
    """Return the symbols that words call constant, as in "with constant $m$ and $k$" and "$m$ is fixed"."""
    found, changing = set[str](), set[str]()
    for each in _inline(statements):
        before, after = _beside(each)
        sentence = re.split(r"[.;]", f"{before} "[-200:])[-1]
        if heard("<varies>").match(after):
            changing |= {*symbols_in_list(each.latex)}
        if not (_DOUBTS.search(sentence) or _NO.search(before)) and (
            _CONSTANT_BEFORE.search(sentence) or _CONSTANT_BEHIND.match(after)
        ):
            found |= {*symbols_in_list(each.latex)}
    return frozenset(found - changing)


def called(statements: Iterable[Statement], things: str, *, of_time: bool = False) -> frozenset[str]:
    """Return the symbols that words before or behind them call by a name, perhaps A where they speak of ``A(t)``."""
    is_before = re.compile(
        rf"(?:\b{things}|{_THE}{things} (?:is|are|be))\s*(?:\$[^$]*\$\s*(?:,|and|,\s*and)\s*)*$", re.IGNORECASE
    )
    is_behind = re.compile(
        r"^\$?\s*(?:(?:is|denotes|represents)|(?:(?:,|and|,\s*and)\s*\$[^$]*\$\s*)*(?:are|denote|be|represent))"
        rf"\s+(?:(?:[a-zA-Z'’-]+|\$[^$]*\$) ){{0,3}}{things}\b",
        re.IGNORECASE,
    )
    found = set[str]()
    for each in _inline(statements):
        before, after = _beside(each)
        excluded = each.latex.lstrip().startswith(r"\{") or ("=" in each.latex and _SET.search(before))
        if not excluded and (is_before.search(before[-200:]) or is_behind.match(after)):
            named = each.latex.partition("=")[0]
            found |= {*symbols_in_list(re.sub(r"\(\s*t\s*\)", "", named) if of_time else named)}
    return frozenset(found)


_IDENTITY = re.compile(r"identity|unit(?:y)? matri|unity", re.IGNORECASE)


def named_otherwise(statements: Iterable[Statement]) -> frozenset[str]:
    """Return the letters I that stand alone within the text, where no word says that they are the identity."""
    found, identities = set[str](), set[str]()
    for each in _inline(statements):
        letters = {*filter(LIKE_IDENTITY.fullmatch, symbols_in_list(each.latex))}
        words = f"{each.display.before[-80:]} {each.display.after[:80]}"
        (identities if _IDENTITY.search(words) else found).update(letters)
    return frozenset(found - identities)


def _agreed(found: Iterable[tuple[str, Value]]) -> dict[str, Value]:
    said: dict[str, set[Value]] = {}
    for symbol, value in found:
        said.setdefault(symbol, set()).add(value)
    return {symbol: values.pop() for symbol, values in said.items() if len(values) == 1}


def _sizes(statements: Iterable[Statement]) -> Iterator[tuple[str, tuple[int, int]]]:
    for each in statements:
        if _is_denied(each):
            continue
        if match := _SPACE_OF.match(each.latex):
            yield from ((symbol, (int(match[2]), int(match[3] or 1))) for symbol in symbols_in_list(match[1]))
        elif match := _ROTATIONS.match(each.latex):
            yield from ((symbol, (int(match[2]), int(match[2]))) for symbol in symbols_in_list(match[1]))


_ARGUMENTS = re.compile(r"(?<=[A-Z}])\s*\((?:[a-z,\s]|\\[a-z]+(?:\{(?:[a-z]|\\[a-z]+)\})?)+\)\s*$")
"""Letters without scripts: what is said of a matrix with them holds for all values."""


def _properties(statements: Iterable[Statement]) -> Iterator[tuple[str, tuple[str, ...]]]:
    for each in statements:
        if match := _ROTATIONS.match(each.latex):
            yield from ((symbol, ("rotation",)) for symbol in symbols_in_list(match[1]) if not _is_denied(each))
        elif each.display.environment == "inline" and (kind := _kind_of(each)):
            for symbol in symbols_in_list(_ARGUMENTS.sub("", each.latex), 1):
                if kind == "covariance" and not _OF_TWO.search(symbol):
                    yield symbol, ("symmetric",)
                elif kind != "covariance" and "dot" not in symbol:
                    yield symbol, (kind,)


def _is_denied(statement: Statement) -> bool:
    """Whether the words beside a formula say that it does not hold."""
    before, after = _beside(statement)
    return bool(_NO.search(before) or _NOT.match(after))


def _kind_of(statement: Statement) -> str:
    before, after = _beside(statement)
    if _DOUBTS.search(before[-200:]):
        return ""
    if (
        match := _AFTER.match(after)
        or _BESIDE.match(after)
        or _ARE.match(after)
        or (_LET.search(before) and _BE.match(after))
    ):
        doubtful = _OF_IT.search(before) or says(r"^\s*\$|^[^.;]*\b<if limits>\b", after[match.end() :])
        return "" if doubtful or _is_turn(statement, match[0]) else _KINDS[(match.lastindex or 1) - 1]
    match = _BEFORE.search(before)
    if match is None or _OF.search(before[: match.start()]) or _is_turn(statement, match[0]):
        return ""
    kind = _KINDS[(match.lastindex or 1) - 1]
    return "" if kind in _ADJECTIVES and not match[0].strip().endswith("matrix") else kind


def _is_turn(statement: Statement, words: str) -> bool:
    """Whether words call a letter a rotation, and the letter is none of a matrix: it may be an angle."""
    called = words.strip().endswith("rotation")
    return called and not all(map(_CAPITAL.match, symbols_in_list(statement.latex)))


def symbols_of(latex: str) -> list[str]:
    """Return the symbols of a formula; none if it cannot be read."""
    try:
        return symbols_in(parsed(pieces_of(latex)).sides[0])
    except UnreadableError:
        return []


def symbols_in_list(latex: str, most: int = 9) -> Iterator[str]:
    """Yield the symbols of a list such as ``a, b``, if it has no more than so many and nothing else.

    ``(x, y, z)`` is one vector, and no list of vectors.
    """
    parts = split_pieces(pieces_of(latex), (",",))
    for part in parts if len(parts) <= most else ():
        try:
            tree = without_brackets(parsed(part).sides[0])
        except UnreadableError:
            continue
        if tree.data == "symbol":
            yield str(tree.children[0])
