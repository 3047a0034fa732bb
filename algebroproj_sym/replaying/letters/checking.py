"""Checking statements in letters: counterexamples and witnesses by exact matrices, proofs in words and by entries."""

import re
from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import product
from typing import Any

from algebroproj_sym.replaying.consequences import Question, is_zero, require_consequence
from algebroproj_sym.replaying.evaluation import Algebra, evaluate
from algebroproj_sym.replaying.field import Element, Field
from algebroproj_sym.replaying.letters.derivatives import without_derivatives
from algebroproj_sym.replaying.letters.matrices import Coordinates, Entries, Matrix, has_properties
from algebroproj_sym.replaying.letters.reading import Node, changed, constant, made, parts_of, read
from algebroproj_sym.replaying.letters.series import has_functions, without_functions
from algebroproj_sym.replaying.letters.statement import (
    Statement,
    conditions,
    stated,
    without_definitions,
    without_lengths,
)
from algebroproj_sym.replaying.letters.turns import Turn
from algebroproj_sym.replaying.letters.words import Poly, Words
from algebroproj_sym.replaying.rejection import Rejected, require, require_keys
from algebroproj_sym.replaying.text import integer, number, parse, texts

RULES: Mapping[str, tuple[str, str]] = {
    "orthogonal rows": ("A*A.T - eye(n)", "orthogonal"),
    "orthogonal columns": ("A.T*A - eye(n)", "orthogonal"),
    "idempotent": ("A*A - A", "idempotent"),
    "unit": ("dot(A, A) - 1", "unit"),
    "diagonal matrices": ("A*B - B*A", "diagonal"),
    "determinant of a rotation": ("det(A) - 1", "rotation"),
    "determinant of an orthogonal matrix": ("det(A)**2 - 1", "orthogonal"),
    "left inverse": ("A**-1*A - eye(n)", ""),
    "right inverse": ("A*A**-1 - eye(n)", ""),
    "determinant of an inverse": ("det(A**-1)*det(A) - 1", ""),
    "adjugate of a regular matrix": ("det(A)*A**-1 - adj(A)", ""),
    "determinant of a product": ("det(A*B) - det(A)*det(B)", ""),
    "determinant of a rank-one update": ("det(A + B*C.T) - det(A) - C.T*adj(A)*B", ""),
    "Schur complements": ("det(A)*det(D - C*A**-1*B) - det(D)*det(A - B*D**-1*C)", ""),
    "left adjugate": ("adj(A)*A - det(A)*eye(n)", ""),
    "right adjugate": ("A*adj(A) - det(A)*eye(n)", ""),
    "two cross products": ("skew(A)*skew(B) - B*A.T + dot(A, B)*eye(3)", ""),
    "exchanged cross product": ("skew(A)*B + skew(B)*A", ""),
    "nested cross product": ("skew(skew(A)*B) - B*A.T + A*B.T", ""),
    "rotated cross product": ("skew(A*B)*A - A*skew(B)", "rotation"),
}
"""What is zero for A, B, C, D, and which property the letter A needs, and B too if both are diagonal.

n is the number of rows of A.
"""
_SQUARE = {"determinant of a product": "AB", "determinant of a rank-one update": "A", "Schur complements": "AD"}


def require_in_letters(record: Mapping[str, Any]) -> None:
    """Require that the verdict on a statement in letters follows from its evidence."""
    given, certificate = stated(record), record["certificate"]
    statement = without_definitions(without_derivatives(without_lengths(given)))
    if record["verdict"] == "refuted":
        require(certificate["method"] == "counterexample", "expected the method 'counterexample'")
        require(record["hypotheses"] == [], "a counterexample needs no hypotheses")
        if has_functions(statement):
            require_keys(certificate, {"method", "angle"})
            point = _AtPoint(given, statement, record["counterexample"], number(certificate["angle"]))
            require(point.left != point.right, "the two sides do not differ")
            return
        require_keys(certificate, {"method", "left", "right"})
        _require_difference(_AtPoint(given, statement, record["counterexample"]), certificate)
        return
    require(record["counterexample"] is None, "what is proved has no counterexample")
    shapes = {name: letter.shape for name, letter in statement.letters.items()}
    listed = [read(text, shapes) for text in texts(record["hypotheses"])]
    require(
        {*listed} == conditions(statement) and len({*listed}) == len(listed),
        "the hypotheses are not those of the forms",
    )
    checks = {"words": _require_words, "entries": _require_entries}
    require(certificate["method"] in checks, f"there is no method {certificate['method']!r}")
    evidence, plain, angle = {**certificate, "shapes": _scope(given)}, statement, Fraction(1)
    if has_functions(statement):
        require({"angles", "angle"} <= evidence.keys(), "expected the angles of the functions")
        plain, angle = without_functions(statement, evidence.pop("angles")), number(evidence.pop("angle"))
    checks[certificate["method"]](plain, evidence)
    witness = _AtPoint(given, statement, certificate["witness"], angle)
    require(witness.left == witness.right, "the sides differ at the witness")


# -- exact matrices


class _AtPoint:
    """Both sides at a point, where all conditions hold."""

    def __init__(self, given: Statement, statement: Statement, point: Any, angle: Fraction = Fraction(1)) -> None:
        require(isinstance(point, Mapping), "expected a point")
        named = given.sizes
        turn = Turn(angle) if has_functions(statement) else None
        given = given if turn is None else statement
        symbols = {part.value for node in given.nodes for part in parts_of(node) if part.kind == "symbol"} - named
        expected = named | symbols | given.letters.keys()
        require(point.keys() == expected, "the point has not a value for every letter and number, and no other")
        sizes = {name: integer(point[name]) for name in named}
        require(all(size > 0 for size in sizes.values()), "a size is not positive")
        entry = (lambda name, text: number(text)) if turn is None else turn.read
        letters = {name: _rows(point[name], partial(entry, name)) for name in given.letters}
        for name, letter in given.letters.items():
            shape = tuple(size if isinstance(size, int) else sizes[size] for size in letter.shape)
            same = (len(letters[name]), len(letters[name][0])) == shape
            require(same and has_properties(letter, letters[name]), f"{name} is not what it is declared to be")
        numbers = {name: entry(name, point[name]) for name in symbols}
        entries = Entries(Algebra(numbers.__getitem__, Fraction), letters, sizes, turn)
        for node in without_derivatives(given).constraints:
            require(not any(map(any, entries.of(node))), "the point violates a constraint")
        if turn is not None:
            self._require_homogeneous(statement, turn)
        for node in given.nonzero:
            require(entries.scalar(node) != 0, "something vanishes at the point that must not")
        self.left, self.right = entries.of(statement.left), entries.of(statement.right)

    def _require_homogeneous(self, statement: Statement, turn: Turn) -> None:
        """Require that what is zero with a number in the place of an angle is zero at the angle."""
        turn.require_pure()
        known = all(turn.degree(node) is not None for node in statement.constraints)
        require(known, "a constraint that is not homogeneous in an angle")
        letters = turn.names & statement.letters.keys()
        plain = all(statement.letters[name].properties <= {"skew"} for name in letters)
        require(plain, "a letter with properties is a multiple of an angle")


def _rows(value: Any, entry: Callable[[Any], Fraction] = number) -> Matrix:
    good = isinstance(value, list) and all(isinstance(row, list) and row for row in value)
    require(good and len({len(row) for row in value}) == 1, "expected the rows of a matrix")
    return [[entry(text) for text in row] for row in value]


def _require_difference(point: _AtPoint, certificate: Mapping[str, Any]) -> None:
    require(_rows(certificate["left"]) == point.left, "the left side has another value at the point")
    require(_rows(certificate["right"]) == point.right, "the right side has another value at the point")
    require(point.left != point.right, "the two sides do not differ")


def _scope(given: Statement) -> str:
    shapes = {tuple(map(str, letter.shape)) for letter in given.letters.values()}
    return f"for {' and '.join('x'.join(shape) for shape in sorted(shapes, reverse=True))}" if shapes else ""


# -- words


def _require_words(statement: Statement, certificate: Mapping[str, Any]) -> None:
    """Check that the difference of the sides is a sum of multiples of what is zero."""
    require_keys(certificate, {"method", "rules", "sums", "scope", "witness", "shapes"})
    words = Words(statement.letters)
    claim = words.plus(words.poly(statement.left), words.poly(statement.right), -1)
    constraints = [words.poly(node) for node in statement.constraints]
    words.close()
    shapes = {name: letter.shape for name, letter in statement.letters.items()}
    zeros = [_rule(words, shapes, rule, constraints) for rule in certificate["rules"]]
    require(bool(certificate["sums"]), "a proof has no sums")
    for multiples in certificate["sums"]:
        total = None
        for multiple in multiples:
            part = _multiple(words, shapes, multiple, zeros)
            require(total is None or total.shape == part.shape, "terms of different shape")
            total = part if total is None else words.plus(total, part)
        zeros.append(words.constant(0, claim.shape) if total is None else total)
    require(zeros[-1] == claim, "the last sum is not the difference of the sides")
    expected = certificate["shapes"] if words.is_sized else "for every size"
    require(certificate["scope"] == expected, f"the proof holds {expected or 'for these numbers'}")


def _rule(words: Words, shapes: Mapping[str, Any], rule: Mapping[str, Any], constraints: Sequence[Poly]) -> Poly:
    require_keys(rule, {"rule", "of"}, {"transposed"})
    require(rule.get("transposed", True) is True, "expected a rule, or its transpose")
    zero = _zero(words, shapes, rule["rule"], rule["of"], constraints)
    return words.transpose(zero) if "transposed" in rule else zero


def _zero(words: Words, shapes: Mapping[str, Any], name: Any, of: Any, constraints: Sequence[Poly]) -> Poly:
    if name == "constraint":
        (place,) = map(integer, of)
        require(0 <= place < len(constraints), "there is no such constraint")
        return constraints[place]
    require(name in RULES, f"there is no rule {name!r}")
    text, needed = RULES[name]
    needed_letters = sorted({*re.findall(r"\b[A-D]\b", text)})
    require(len(texts(of)) == len(needed_letters), "a rule is of other parts")
    arguments = dict(zip(needed_letters, (read(part, shapes) for part in of), strict=True))
    if needed:
        _require_property(words, arguments["A"], needed, turned=name == "rotated cross product")
    if needed == "diagonal":
        _require_property(words, arguments["B"], needed, turned=False)
    if name in _SQUARE:
        sizes = [arguments[letter].shape for letter in _SQUARE[name]]
        require(all(rows == columns for rows, columns in sizes), f"{name}: expected square matrices")
        require(name != "determinant of a product" or sizes[0] == sizes[1], f"{name}: expected matrices of one size")
    size = arguments["A"].shape[0]
    template = read(text.replace("(n)", f"({size})"), {key: node.shape for key, node in arguments.items()})
    return words.poly(changed(template, lambda node: arguments[node.value] if node.kind == "letter" else None))


def _require_property(words: Words, node: Node, needed: str, turned: bool) -> None:
    """Require a letter that is declared to have a property; where that is the same, it may be transposed."""
    node = node.parts[0] if turned and node.kind == "transpose" else node
    declared = node.kind == "letter" and needed in words.letters[node.value].properties
    require(declared, f"no letter that is declared {needed}")


def _multiple(words: Words, shapes: Mapping[str, Any], part: Mapping[str, Any], zeros: Sequence[Poly]) -> Poly:
    require_keys(part, {"of"}, {"times", "left", "right", "trace", "then"})
    place = integer(part["of"])
    require(0 <= place < len(zeros), "a sum of what is not yet zero")
    given = {key: words.poly(read(part[key], shapes)) for key in ("times", "left", "right", "then") if key in part}
    result = zeros[place]
    if "left" in given:
        result = words.times(given["left"], result)
    if "right" in given:
        result = words.times(result, given["right"])
    if "trace" in part:
        require(part["trace"] is True and result.shape[0] == result.shape[1], "a trace of what is not square")
        result = words.trace(result)
    if "times" in given:
        require(given["times"].shape == (1, 1), "expected a multiple by a number")
        result = words.times(given["times"], result)
    return words.times(result, given["then"]) if "then" in given else result


# -- entries


def _require_entries(statement: Statement, certificate: Mapping[str, Any]) -> None:
    """Check the expansion of the letters, and the proof about their entries."""
    used = {part.value for node in statement.nodes for part in parts_of(node) if part.kind == "letter"}
    statement = replace(
        statement, letters={name: statement.letters[name] for name in statement.letters if name in used}
    )
    free = {name: Coordinates(name, letter) for name, letter in statement.letters.items()}
    symbols = {part.value for node in statement.nodes for part in parts_of(node) if part.kind == "symbol"}
    names = [*symbols, *statement.letters, *(name for each in free.values() for name in each.names)]
    require(len({*names}) == len(names), "two numbers of one name")
    signs = [name for each in free.values() for name in each.signs]
    equations = [*statement.constraints, *_equations(statement, free)]
    require(certificate["scope"] == certificate["shapes"], "the scope is not that of the letters")
    require(isinstance(certificate["entries"], Mapping), "entries: expected those of each letter")
    require(certificate["entries"].keys() == free.keys(), "entries of other letters")
    numbers = {*names} - statement.letters.keys()
    if equations:
        _require_constrained(statement, certificate, free, equations, signs, numbers)
        return
    require_keys(certificate, {"method", "entries", "denominators", "scope", "witness", "shapes"})
    field = Field(numbers, certificate["denominators"])
    for chosen in product((1, -1), repeat=len(signs)):
        values = {name: field.number(Fraction(sign)) for name, sign in zip(signs, chosen, strict=True)}
        algebra = _with_values(field, values)
        entries = _expanded(free, certificate["entries"], algebra)
        pairs = zip(_flat(entries.of(statement.left)), _flat(entries.of(statement.right)), strict=True)
        require(all((a - b).is_zero for a, b in pairs), "the two sides differ")
    field.require_listed()


def _with_values(field: Field, values: Mapping[str, Element]) -> Algebra:
    return Algebra(lambda name: values[name] if name in values else field.symbol(name), field.number)


def _expanded(free: Mapping[str, Coordinates], given: Mapping[str, Any], algebra: Algebra) -> Entries:
    """Return the entries of nodes, after those of the letters were compared with the given ones."""
    letters = {name: each.matrix(algebra) for name, each in free.items()}
    shown = Entries(algebra, {}, {})
    for name, rows in letters.items():
        node = read(given[name], {})
        require(node.shape == (len(rows), len(rows[0])), f"{name} is expanded into another shape")
        for own, other in zip(_flat(rows), _flat(shown.of(node)), strict=True):
            require(is_zero(own - other), f"{name} is not expanded into its entries")
    return Entries(algebra, letters, {})


def _flat(matrix: Matrix) -> list[Any]:
    return [entry for row in matrix for entry in row]


def _equations(statement: Statement, free: Mapping[str, Coordinates]) -> list[Node]:
    """Return what is zero in letters of which the coordinates do not say it."""
    found = []
    for name, letter in statement.letters.items():
        node = Node("letter", letter.shape, (), name)
        if "orthogonal" in letter.properties and not free[name].turns:
            square = made("product", node, made("transpose", node))
            found.append(made("sum", square, made("product", constant(-1), made("eye", value=letter.shape[:1]))))
            if "rotation" in letter.properties:
                found.append(made("sum", made("det", node), constant(-1)))
        if "idempotent" in letter.properties:
            found.append(made("sum", made("product", node, node), made("product", constant(-1), node)))
    return found


def _require_constrained(
    statement: Statement,
    certificate: Mapping[str, Any],
    free: Mapping[str, Coordinates],
    equations: Sequence[Node],
    signs: Sequence[str],
    numbers: Set[str],
) -> None:
    """Check what follows from equations between the entries."""
    require_keys(certificate, {"method", "entries", "equations", "conditions", "proof", "scope", "witness", "shapes"})
    proof = certificate["proof"]
    if not isinstance(proof, Mapping):
        raise Rejected("expected the proof about the entries")
    field = Field(numbers, proof["denominators"])
    entries = _expanded(free, certificate["entries"], field.algebra)
    own = [entry for node in equations for entry in _flat(entries.of(node)) if not entry.is_zero]
    own += [field.symbol(name) ** 2 - field.number(Fraction(1)) for name in signs]
    conditions = [entries.scalar(node) for node in statement.nonzero]
    for side in (statement.left, statement.right):
        entries.of(side)
    require({*range(field.listed)} <= field.used, "the proof lists a divisor by which the statement does not divide")
    listed = [parse(text) for text in texts(certificate["equations"])]
    given = [evaluate(form, field.algebra)[0] for form in listed]
    require(_covers(own, given) and _covers(given, own), "the equations are not those of the letters")
    units = [parse(text) for text in texts(certificate["conditions"])]
    values = [evaluate(form, field.algebra)[0] for form in units]
    require(_covers(conditions, values), "a condition is missing")
    require(_covers(values, conditions), "a condition too many")

    def sides(algebra: Algebra) -> tuple[list[Any], list[Any]]:
        inner = Entries(algebra, {name: each.matrix(algebra) for name, each in free.items()}, {})
        return _flat(inner.of(statement.left)), _flat(inner.of(statement.right))

    require_consequence(Question(sides, listed, units, {*numbers}, proof["denominators"]), proof)


def _covers(values: Sequence[Element], others: Sequence[Element]) -> bool:
    return all(any((value - other).is_zero for other in others) for value in values)
