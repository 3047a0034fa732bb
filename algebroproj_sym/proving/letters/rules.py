"""The rules of words: what is zero by a definition, by a declared property, or by a law of three dimensions.

Each rule is a text in A, B, C, D, with n rows of A.  Inverses are those of the statement.
"""

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from itertools import combinations, product

from algebroproj_sym.expressions.letters import Shape, Term, parse_letters
from algebroproj_sym.proving.letters.statements import replaced
from algebroproj_sym.proving.letters.words import (
    Algebra,
    Atom,
    NotWordsError,
    Poly,
    Scalar,
    Word,
    atoms_of,
    constant,
    of_key,
)

RULES: Mapping[str, str] = {
    "orthogonal rows": "A*A.T - eye(n)",
    "orthogonal columns": "A.T*A - eye(n)",
    "idempotent": "A*A - A",
    "unit": "dot(A, A) - 1",
    "diagonal matrices": "A*B - B*A",
    "left inverse": "A**-1*A - eye(n)",
    "right inverse": "A*A**-1 - eye(n)",
    "left adjugate": "adj(A)*A - det(A)*eye(n)",
    "right adjugate": "A*adj(A) - det(A)*eye(n)",
    "determinant of a rotation": "det(A) - 1",
    "determinant of an orthogonal matrix": "det(A)**2 - 1",
    "determinant of an inverse": "det(A**-1)*det(A) - 1",
    "adjugate of a regular matrix": "det(A)*A**-1 - adj(A)",
    "determinant of a product": "det(A*B) - det(A)*det(B)",
    "determinant of a rank-one update": "det(A + B*C.T) - det(A) - C.T*adj(A)*B",
    "Schur complements": "det(A)*det(D - C*A**-1*B) - det(D)*det(A - B*D**-1*C)",
    "two cross products": "skew(A)*skew(B) - B*A.T + dot(A, B)*eye(3)",
    "exchanged cross product": "skew(A)*B + skew(B)*A",
    "nested cross product": "skew(skew(A)*B) - B*A.T + A*B.T",
    "rotated cross product": "skew(A*B)*A - A*skew(B)",
}
CONSTRAINT = "constraint"
ROUNDS = 3


@dataclass(frozen=True)
class Rule:
    """Something that is zero."""

    name: str
    """Which rule gives it: one of `RULES`, or a constraint."""
    of: tuple[Poly | int, ...]
    """For what; the place of a constraint."""
    poly: Poly
    """What is zero."""
    transposed: bool = False
    """Whether it is the transpose of what the rule gives."""


def rules_for(algebra: Algebra, polys: Sequence[Poly], constraints: Sequence[Poly]) -> list[Rule]:
    """Return the rules for what occurs in some polynomials, and in constraints.

    Examples
    --------
    >>> from algebroproj_sym.proving.letters.properties import Letter
    >>> letter = Letter("n", (3, 1), frozenset({"unit"}))
    >>> algebra = Algebra({"n": letter})
    >>> [rule.name for rule in rules_for(algebra, [algebra.poly(letter.term)], [])]
    ['unit']
    """
    parts = dict.fromkeys(part for poly in (*polys, *constraints) for part in atoms_of(poly))
    given, new = list[Rule](), [*parts]
    for _ in range(ROUNDS):
        further = [rule for name, of in _instances(algebra, new) if (rule := _rule(algebra, name, of, parts))]
        given += further
        new = [*dict.fromkeys(part for rule in further for part in atoms_of(rule.poly) if part.kind in ("det", "adj"))]
        new = [part for part in new if part not in parts]
        parts |= dict.fromkeys(new)
    given += [Rule(CONSTRAINT, (place,), constraint) for place, constraint in enumerate(constraints)]
    found: dict[tuple[object, ...], Rule] = {}
    others = [replace(rule, poly=algebra.transposed(rule.poly), transposed=True) for rule in given]
    for rule in (*given, *others):
        if rule.poly and not (rule.transposed and (-rule.poly).key in found):
            found.setdefault(rule.poly.key, rule)
    return [*found.values()]


def rule_in(algebra: Algebra, rule: Rule, constraints: Sequence[Poly]) -> Poly:
    """Return what a rule says is zero, computed in some algebra."""
    (first, *_), parts = rule.of, [part for part in rule.of if isinstance(part, Poly)]
    poly = constraints[first] if isinstance(first, int) else _of_rule(algebra, rule.name, parts)
    return algebra.transposed(poly) if rule.transposed else poly


def _rule(algebra: Algebra, name: str, of: tuple[Poly, ...], parts: Container[object]) -> Rule | None:
    """Return a rule, unless it speaks of inverses that do not occur."""
    try:
        poly = _of_rule(algebra, name, of)
    except (NotWordsError, ZeroDivisionError):
        return None
    known = all(part in parts for part in atoms_of(poly) if part.kind in ("inverse", "reciprocal"))
    return Rule(name, of, poly) if known else None


def _of_rule(algebra: Algebra, name: str, of: Sequence[Poly]) -> Poly:
    arguments = dict(zip("ABCD", map(algebra.term, of), strict=False))
    shapes = tuple((letter, term.shape) for letter, term in arguments.items())
    template = _template(name, shapes)
    return algebra.poly(replaced(template, lambda part: arguments.get(part.value) if part.kind == "letter" else None))


@cache
def _template(name: str, shapes: tuple[tuple[str, Shape], ...]) -> Term:
    return parse_letters(RULES[name].replace("(n)", f"({shapes[0][1][0]})"), dict(shapes))


def _instances(algebra: Algebra, parts: Sequence[Atom | Scalar]) -> Iterator[tuple[str, tuple[Poly, ...]]]:
    for name in dict.fromkeys(str(part.key) for part in parts if part.kind == "letter"):
        letter = algebra.letters[name]
        for rule in ("orthogonal rows", "orthogonal columns", "idempotent", "unit"):
            if rule.partition(" ")[0] in letter.properties:
                yield rule, (algebra.poly(letter.term),)
    diagonal = [letter for letter in algebra.letters.values() if "diagonal" in letter.properties]
    for first, second in combinations(diagonal, 2):
        if first.shape == second.shape:
            yield "diagonal matrices", (algebra.poly(first.term), algebra.poly(second.term))
    for part in parts:
        base = of_key(part.key) if part.kind in ("inverse", "adj", "reciprocal", "det") else None
        if base is not None and part.kind == "det":
            yield from _of_determinant(algebra, base)
        elif base is not None:
            base = algebra.transposed(base) if isinstance(part, Atom) and part.transposed else base
            noun = "adjugate" if part.kind == "adj" else "inverse"
            yield f"left {noun}", (base,)
            yield f"right {noun}", (base,)
            yield "adjugate of a regular matrix", (base,)
    if any(part.kind == "skew" for part in parts):
        yield from _of_cross_products(algebra, [part for part in parts if isinstance(part, Atom)])


def _of_determinant(algebra: Algebra, base: Poly) -> Iterator[tuple[str, tuple[Poly, ...]]]:
    for _, word in base.terms:
        if len(base.terms) == len(word) == 1:
            (atom,) = word
            properties = algebra.letters[str(atom.key)].properties if atom.kind == "letter" else ()
            if atom.kind == "inverse":
                yield "determinant of an inverse", (of_key(atom.key),)
            elif "rotation" in properties:
                yield "determinant of a rotation", (base,)
            elif "orthogonal" in properties:
                yield "determinant of an orthogonal matrix", (base,)
    if len(base.terms) > 1:
        yield from _of_determinant_of_sum(algebra, base)


def _of_determinant_of_sum(algebra: Algebra, base: Poly) -> Iterator[tuple[str, tuple[Poly, ...]]]:
    """Yield what factors are taken out of a sum, and what is an update of the rest of it."""
    for place in (0, -1):
        ends = {word[place] if word else None for _, word in base.terms}
        (end, *others) = ends
        if end is not None and not others and end.rows == end.columns:
            rest = {(scalars, word[1:] if place == 0 else word[:-1]): c for (scalars, word), c in base.terms.items()}
            factors = algebra.of_word(base.shape, (end,)), Poly(base.shape, rest)
            yield "determinant of a product", factors if place == 0 else (factors[1], factors[0])
    for (scalars, word), value in base.terms.items():
        term = Poly(base.shape, {(scalars, word): value})
        for cut in range(1, len(word)):
            left = Poly((base.shape[0], word[cut].rows), {(scalars, word[:cut]): value})
            right = Poly((word[cut].rows, base.shape[0]), {((), word[cut:]): Fraction(1)})
            if word[cut].rows == 1:
                yield "determinant of a rank-one update", (base - term, left, algebra.transposed(right))
            yield "Schur complements", (base - term, -left, right, constant(1, (word[cut].rows,) * 2))
            if word[cut].kind == "inverse" and cut + 1 < len(word):
                middle = algebra.transposed(of_key(word[cut].key)) if word[cut].transposed else of_key(word[cut].key)
                after = Poly((word[cut].rows, base.shape[0]), {((), word[cut + 1 :]): Fraction(1)})
                yield "Schur complements", (base - term, -left, after, middle)


def _of_cross_products(algebra: Algebra, atoms: Sequence[Atom]) -> Iterator[tuple[str, tuple[Poly, ...]]]:
    words: dict[Word, None] = {}
    for atom in atoms:
        if atom.kind == "skew":
            words[atom.key] = None  # type: ignore[index]
        elif atom.kind == "letter" and {atom.rows, atom.columns} == {3, 1}:
            words[(Atom("letter", atom.key, False, 3, 1),)] = None
    vectors = [*map(_vector, words)]
    for pair in product(vectors, repeat=2):
        yield "two cross products", pair
        yield "exchanged cross product", pair
    for word in words:
        if word[0].kind == "skew":
            yield "nested cross product", (_vector(word[0].key), _vector(word[1:]))
    for letter in algebra.letters.values():
        if "rotation" in letter.properties and letter.shape == (3, 3):
            matrix = algebra.poly(letter.term)
            for turn, vector in product((matrix, algebra.transposed(matrix)), vectors):
                yield "rotated cross product", (turn, vector)


def _vector(word: object) -> Poly:
    return Poly((3, 1), {((), word): Fraction(1)})  # type: ignore[dict-item]
