"""Exact matrices with properties: where counterexamples are looked for, and how they are checked."""

import random
from collections.abc import Mapping
from fractions import Fraction

from algebroproj_sym.expressions.exact import fmpq_matrix
from algebroproj_sym.expressions.letters import parse_letters
from algebroproj_sym.proving.letters.entries import Field, Rows, entries_of
from algebroproj_sym.proving.letters.properties import RANKS, Letter

NUMBERS = Field(Fraction)


def example(letter: Letter, sizes: Mapping[str, int], generator: random.Random, attempt: int) -> Rows | None:
    """Return random exact entries of a letter that has all its properties; None if this attempt fails.

    Examples
    --------
    >>> rotation = Letter("R", (3, 3), frozenset({"rotation", "orthogonal"}))
    >>> has_properties(rotation, example(rotation, {}, random.Random(1), 0))
    True
    """
    rows, columns = (size if isinstance(size, int) else sizes[size] for size in letter.shape)
    try:
        found = _example(letter, rows, columns, generator, 2 + attempt // 4)
    except ZeroDivisionError:
        return None
    return found if has_properties(letter, found) else None


def sparse(letter: Letter, sizes: Mapping[str, int], generator: random.Random) -> Rows:
    """Return entries of a letter without properties of which most are zero, as nilpotent matrices have."""
    rows, columns = (size if isinstance(size, int) else sizes[size] for size in letter.shape)
    values = (*[Fraction(0)] * generator.randint(1, 8), Fraction(1), Fraction(-1), Fraction(2))
    return [[generator.choice(values) for _ in range(columns)] for _ in range(rows)]


def _example(letter: Letter, rows: int, columns: int, generator: random.Random, height: int) -> Rows:
    properties = letter.properties

    def random_rows(width: int = columns, number: int = rows) -> Rows:
        return [[Fraction(generator.randint(-height, height)) for _ in range(width)] for _ in range(number)]

    def made(text: str, **letters: Rows) -> Rows:
        shapes = {name: (len(value), len(value[0])) for name, value in letters.items()}
        return entries_of(parse_letters(text, shapes), letters, {}, NUMBERS)

    def projection() -> Rows:
        rank = generator.randint(0, rows)
        basis = random_rows(rank) if rank else []
        return made("B*(B.T*B)**-1*B.T", B=basis) if rank else made(f"zeros({rows}, {rows})")

    def signs() -> Rows:
        diagonal = [[Fraction(generator.choice((-1, 1)))] for _ in range(rows)]
        return made("diag(v)", v=diagonal)

    if letter.rank is not None:
        return made("B*C", B=random_rows(letter.rank), C=random_rows(number=letter.rank))
    free = random_rows()
    if "unit" in properties:
        return made(f"({_first(rows)}) - 2*h[0, 0]*h*dot(h, h)**-1", h=free) if rows > 1 else signs()
    if {"symmetric", "orthogonal"} <= properties:
        return made(f"eye({rows}) - 2*P", P=projection())
    if "orthogonal" in properties:
        cayley = made(f"(eye({rows}) + A - A.T)**-1*(eye({rows}) - A + A.T)", A=free)
        return cayley if "rotation" in properties else made("R*S", R=cayley, S=signs())
    if "positive definite" in properties:
        if "diagonal" in properties:
            return made("diag(v)", v=[[Fraction(generator.randint(1, height + 1))] for _ in range(rows)])
        return made(f"A*A.T + eye({rows})", A=free)
    if "diagonal" in properties:
        return made("diag(v)", v=[row[:1] for row in free])
    if {"symmetric", "idempotent"} <= properties:
        return projection()
    if "idempotent" in properties:
        kept = made("diag(v)", v=[[Fraction(generator.randint(0, 1))] for _ in range(rows)])
        return made("A*D*A**-1", A=free, D=kept)
    if "symmetric" in properties:
        return made("A + A.T", A=free)
    return made("A - A.T", A=free) if "skew" in properties else free


def _first(size: int) -> str:
    return f"block({', '.join(f'[{int(k == 0)}]' for k in range(size))})"


def has_properties(letter: Letter, rows: Rows) -> bool:
    """Whether exact entries have all the properties of a letter."""
    properties, size = letter.properties, len(rows)
    transposed = [[*column] for column in zip(*rows, strict=True)]
    identity = [[Fraction(i == j) for j in range(size)] for i in range(size)]
    shapes = {"A": (size, len(rows[0]))}

    leading = ([row[:k] for row in rows[:k]] for k in range(1, size + 1))

    def value(text: str) -> Rows:
        return entries_of(parse_letters(text, shapes), {"A": rows}, {}, NUMBERS)

    checks = {
        "orthogonal": lambda: value("A*A.T") == identity,
        "rotation": lambda: value("det(A)") == [[1]],
        "symmetric": lambda: transposed == rows,
        "skew": lambda: value("A + A.T") == value(f"zeros({size}, {size})"),
        "unit": lambda: value("dot(A, A)") == [[1]],
        "idempotent": lambda: value("A*A") == rows,
        "diagonal": lambda: all(i == j or entry == 0 for i, row in enumerate(rows) for j, entry in enumerate(row)),
        "positive definite": lambda: all(fmpq_matrix(part).det() > 0 for part in leading),
    }
    return all(checks[one]() for one in properties - RANKS.keys()) and letter.rank in (None, fmpq_matrix(rows).rank())
