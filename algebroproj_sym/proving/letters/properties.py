"""The properties that a letter may have, such as rotation, and what each says of the entries.

Entries are taken as functions of coordinates that reach every matrix of the kind, and nothing else: every rotation of
space is that of a quaternion which is not zero, every unit vector is the image of the first axis under a reflection.
Only those of a matrix of given rank also reach lower ranks, near which there are always matrices of that rank.
What coordinates do not say is left as equations.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from algebroproj_sym.expressions.letters import LetterError, Shape, Term, made, minus, number, parse_letters

LARGEST_SIZE = 6
RANKS = {f"rank {rank}": rank for rank in range(1, LARGEST_SIZE + 1)}
PROPERTIES = (
    "rotation",
    "orthogonal",
    "symmetric",
    "skew",
    "unit",
    "positive definite",
    "diagonal",
    "idempotent",
    *RANKS,
)
_TOGETHER = (
    {"symmetric", "idempotent"},
    {"symmetric", "orthogonal"},
    {"positive definite", "diagonal"},
)
_IMPLIED = {"positive definite": "symmetric", "diagonal": "symmetric", "rotation": "orthogonal"}


@dataclass(frozen=True)
class Letter:
    """A vector or matrix that is named."""

    name: str
    """Its name."""
    shape: Shape
    """Rows and columns."""
    properties: frozenset[str]
    """What it is declared to be, see `PROPERTIES`, and what follows from that."""

    @property
    def term(self) -> Term:
        """The letter as a term."""
        return Term("letter", self.shape, (), self.name)

    @property
    def rank(self) -> int | None:
        """Its rank, if that is declared."""
        return next((rank for name, rank in RANKS.items() if name in self.properties), None)

    @property
    def declared(self) -> list[str]:
        """What it is declared to be, without what follows."""
        implied = {_IMPLIED[one] for one in self.properties if one in _IMPLIED}
        return sorted(self.properties - implied)


def declared_letters(shapes: Mapping[str, Shape], properties: Mapping[str, Any]) -> dict[str, Letter]:
    """Return the letters of a statement with their properties.

    It raises `LetterError` if a name does not occur, a property is unknown or of another shape, or two properties are
    not decided together.

    Examples
    --------
    >>> sorted(declared_letters({"R": (3, 3)}, {"R": "rotation"})["R"].properties)
    ['orthogonal', 'rotation']
    >>> declared_letters({"R": (3, 1)}, {"R": "rotation"})
    Traceback (most recent call last):
    ...
    algebroproj_sym.expressions.letters.terms.LetterError: properties, R: expected a square matrix as rotation, got 3x1
    """
    for name in properties:
        if name not in shapes:
            known = ", ".join(sorted(shapes)) or "none"
            raise LetterError(f"properties: expected letters that occur ({known}), got {name}")
    found = {name: _properties(name, shape, properties.get(name, ())) for name, shape in shapes.items()}
    return {name: Letter(name, shape, found[name]) for name, shape in shapes.items()}


def _properties(name: str, shape: Shape, given: Any) -> frozenset[str]:
    listed = (given,) if isinstance(given, str) else given
    if not isinstance(listed, Sequence | set | frozenset) or not all(isinstance(one, str) for one in listed):
        raise LetterError(f"properties, {name}: expected a property or a tuple of them, got {given!r}")
    for one in listed:
        if one not in PROPERTIES:
            raise LetterError(f"properties, {name}: expected one of {', '.join(PROPERTIES)}, got {one!r}")
        good, kind = _kind(one, shape)
        if not good:
            raise LetterError(f"properties, {name}: expected a {kind} as {one}, got {shape[0]}x{shape[1]}")
    found = {*listed}
    core = found - {_IMPLIED[one] for one in found if one in _IMPLIED}
    if len(core) > 1 and core not in _TOGETHER:
        raise LetterError(
            f"properties, {name}: expected one property or two of {_listed(_TOGETHER)}, got {', '.join(sorted(core))}"
        )
    return frozenset(found | {_IMPLIED[one] for one in found if one in _IMPLIED})


def _kind(one: str, shape: Shape) -> tuple[bool, str]:
    """Return whether a shape is one of those that a property asks for, and which these are."""
    if one == "unit":
        return shape[1] == 1, "column vector"
    if one in RANKS:
        fits = all(size >= RANKS[one] for size in shape if isinstance(size, int))
        return fits, f"matrix with {RANKS[one]} rows and columns or more"
    return shape[0] == shape[1], "square matrix"


def _listed(sets: Iterable[set[str]]) -> str:
    return "; ".join(" and ".join(sorted(each)) for each in sets)


@dataclass(frozen=True)
class Coordinates:
    """The entries of a letter, as functions of numbers."""

    entries: Term
    """The matrix."""
    names: tuple[str, ...]
    """The numbers."""
    signs: tuple[str, ...] = ()
    """Those of them that are 1 or -1."""
    equations: tuple[Term, ...] = ()
    """What is zero besides, in the letter."""


def coordinates(letter: Letter) -> Coordinates:
    """Return the entries of a letter of fixed size.

    Examples
    --------
    >>> from algebroproj_sym.expressions.letters import letters_text
    >>> letters_text(coordinates(Letter("A", (2, 2), frozenset({"symmetric"}))).entries)
    'block([A_11, A_12], [A_12, A_22])'
    >>> letters_text(coordinates(Letter("R", (3, 3), frozenset({"rotation", "orthogonal"}))).entries)
    'rotation(block([R_q0], [R_q1], [R_q2], [R_q3]))'
    """
    rows, columns = letter.shape
    if not isinstance(rows, int) or not isinstance(columns, int) or max(rows, columns) > LARGEST_SIZE:
        raise LetterError(
            f"{letter.name}: expected a size of at most {LARGEST_SIZE} for a proof by entries, got {rows}x{columns}"
        )
    properties, name = letter.properties, letter.name
    if {"symmetric", "orthogonal"} <= properties or rows > 3 or "orthogonal" not in properties:
        if letter.rank is not None:
            return _product(name, rows, columns, letter.rank)
        found = _unit(name, rows) if "unit" in properties else _entries(letter, rows, columns)
        return Coordinates(found.entries, found.names, found.signs, _equations(letter))
    return _orthogonal(letter, rows)


def _entries(letter: Letter, rows: int, columns: int) -> Coordinates:
    properties, name = letter.properties, letter.name
    vector = columns == 1

    def entry(i: int, j: int) -> str:
        if "diagonal" in properties and i != j:
            return "0"
        if "skew" in properties:
            return "0" if i == j else f"{name}_{i}{j}" if i < j else f"-{name}_{j}{i}"
        if "symmetric" in properties and i > j:
            i, j = j, i
        return f"{name}_{i}" if vector else f"{name}_{i}{j}"

    texts = [[entry(i, j) for j in range(1, columns + 1)] for i in range(1, rows + 1)]
    names = sorted({text.lstrip("-") for row in texts for text in row} - {"0"})
    return Coordinates(_block(texts), tuple(names))


def _product(name: str, rows: int, columns: int, rank: int) -> Coordinates:
    """Return the product of two matrices: it reaches all matrices of a rank, and those of lower rank."""
    left = [[f"{name}_a{i}{k}" for k in range(1, rank + 1)] for i in range(1, rows + 1)]
    right = [[f"{name}_b{k}{j}" for j in range(1, columns + 1)] for k in range(1, rank + 1)]
    names = [each for row in (*left, *right) for each in row]
    return Coordinates(made("product", _block(left), _block(right)), tuple(names))


def _unit(name: str, size: int) -> Coordinates:
    """Return the first column of the reflection along a vector that is not zero."""
    if size == 1:
        return Coordinates(_block([[f"{name}_s"]]), (f"{name}_s",), (f"{name}_s",))
    names = tuple(f"{name}_h{k}" for k in range(1, size + 1))
    column = ", ".join(f"[{each}]" for each in names)
    first = ", ".join(f"[{int(k == 0)}]" for k in range(size))
    square = " + ".join(f"{each}**2" for each in names)
    return Coordinates(_read(f"block({first}) - 2*{names[0]}*block({column})*({square})**-1"), names)


def _orthogonal(letter: Letter, size: int) -> Coordinates:
    """Return a rotation, the last column of which may have another sign."""
    name = letter.name
    if size == 1:
        rotation, names = "block([1])", list[str]()
    elif size == 2:
        a, b = names = [f"{name}_q0", f"{name}_q1"]
        square, product = f"{a}**2 - {b}**2", f"2*{a}*{b}"
        rotation = f"({a}**2 + {b}**2)**-1*block([{square}, -{product}], [{product}, {square}])"
    else:
        names = [f"{name}_q{k}" for k in range(4)]
        rotation = f"rotation(block({', '.join(f'[{each}]' for each in names)}))"
    if "rotation" in letter.properties:
        return Coordinates(_read(rotation), tuple(names))
    sign = f"{name}_s"
    diagonal = ", ".join(f"[{sign if k == size - 1 else 1}]" for k in range(size))
    return Coordinates(_read(f"{rotation}*diag(block({diagonal}))"), (*names, sign), (sign,))


def _equations(letter: Letter) -> tuple[Term, ...]:
    """Return what is zero in a letter, where its coordinates do not say it."""
    matrix, found = letter.term, []
    if "orthogonal" in letter.properties:
        found.append(minus(made("product", matrix, made("transpose", matrix)), made("eye", value=letter.shape[:1])))
    if "rotation" in letter.properties:
        found.append(minus(made("det", matrix), number(1)))
    if "idempotent" in letter.properties:
        found.append(minus(made("product", matrix, matrix), matrix))
    return tuple(found)


def _read(text: str) -> Term:
    return parse_letters(text, {})


def _block(texts: list[list[str]]) -> Term:
    rows = ", ".join(f"[{', '.join(row)}]" for row in texts)
    return _read(f"block({rows})")
