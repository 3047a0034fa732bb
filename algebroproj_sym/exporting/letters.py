"""Claims about matrices as letters, written out in entries, with the definitions among their constraints put in."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from algebroproj_sym.exporting.refusal import Silent
from algebroproj_sym.replaying.evaluation import Algebra
from algebroproj_sym.replaying.letters.derivatives import without_derivatives
from algebroproj_sym.replaying.letters.matrices import Coordinates, Entries, Matrix
from algebroproj_sym.replaying.letters.reading import parts_of
from algebroproj_sym.replaying.letters.series import has_functions
from algebroproj_sym.replaying.letters.statement import (
    Statement,
    conditions,
    stated,
    without_definitions,
    without_lengths,
)


@dataclass(frozen=True)
class _Text:
    """An expression as text, which is put together by the operators of an algebra."""

    text: str

    def __add__(self, other: _Text) -> _Text:
        if "0" in (self.text, other.text):
            return other if self.text == "0" else self
        return _Text(f"({self.text} + {other.text})")

    def __sub__(self, other: _Text) -> _Text:
        return self + -other

    def __neg__(self) -> _Text:
        return self if self.text == "0" else _Text(f"(-{self.text})")

    def __mul__(self, other: _Text) -> _Text:
        if "0" in (self.text, other.text):
            return _Text("0")
        if "1" in (self.text, other.text):
            return other if self.text == "1" else self
        return _Text(f"{self.text}*{other.text}")

    def __truediv__(self, other: _Text) -> _Text:
        return _Text("0") if self.text == "0" else _Text(f"({self.text}/({other.text}))")


def in_entries(record: Mapping[str, Any]) -> dict[str, Any]:
    """Return the record of an identity in letters as one about entries: rational functions, without constraints.

    It raises `Silent` if the claim is of another kind, a size is a letter, there are functions of angles, a constraint
    defines nothing, or a point is about a rotation.
    """
    kind, verdict, certificate = record["kind"], record["verdict"], record["certificate"]
    proportional = kind == "identity up to scale"
    refuted = verdict in ("misprint", "error", "false")
    if not kind.startswith("identity") or (proportional and refuted) or certificate is None:
        raise Silent("no theorem is written yet for a claim in letters of this kind or verdict")
    named = {name: _stated(record, name) for name in ("printed", "corrected") if record[name] is not None}
    coordinates = _coordinates(*named.values())
    algebra = Algebra(_Text, lambda value: _Text(str(Fraction(value))))
    entries = Entries(algebra, {name: each.matrix(algebra) for name, each in coordinates.items()}, {})
    forms = {name: _written(entries.of(statement.left)) for name, statement in named.items()}
    derived, *others = {_written(entries.of(statement.right)) for statement in named.values()}
    if others:
        raise Silent("no theorem is written yet for lengths that are squared in one form alone")
    used = [entries.scalar(each).text for each in set().union(*map(conditions, named.values()))]
    words = {*re.findall(r"\w+", " ".join([*forms.values(), derived, *used]))}
    used += [_square(each.names) for each in coordinates.values() if _divides(each) and words & {*each.names}]
    changed = {"kind": "identity", "setting": {}, "derived": derived, "hypotheses": sorted(used)}
    if proportional:
        (statement,) = named.values()
        changed |= {"kind": kind, "certificate": {"pivot": _pivot(statement, certificate["nonzero at"]["point"])}}
    if refuted:
        refutation = certificate if verdict == "false" else certificate["refutation"]
        flat = {side: [entry for row in refutation[side] for entry in row] for side in ("left", "right")}
        changed |= {"certificate": flat if verdict == "false" else {**certificate, "refutation": flat}}
        point = _point(record["counterexample"], coordinates, entries)
        changed |= {"counterexample": {name: value for name, value in point.items() if name in words}}
    return {**record, **changed, **forms}


def _stated(record: Mapping[str, Any], form: str) -> Statement:
    """Return the statement that a form is the derived one."""
    setting = record["setting"]
    conditional = {name: setting.get(name, []) for name in ("constraints", "nonzero")}
    question = {"letters": setting["letters"], "lhs": record[form], "rhs": record["derived"], **conditional}
    statement = without_definitions(without_derivatives(without_lengths(stated(question))))
    if statement.sizes or has_functions(statement):
        raise Silent("no theorem is written yet for letters of any size, or with functions of angles")
    return statement


def _coordinates(*statements: Statement) -> dict[str, Coordinates]:
    """Return the coordinates of all letters, which must be free."""
    found = {name: Coordinates(name, letter) for each in statements for name, letter in each.letters.items()}
    if any(each.constraints for each in statements) or not all(map(_are_free, found.values())):
        raise Silent("no theorem is written yet for letters under constraints")
    nodes = [node for each in statements for node in each.nodes]
    symbols = {part.value for node in nodes for part in parts_of(node) if part.kind == "symbol"}
    names = [*symbols, *(name for each in found.values() for name in each.names)]
    if len({*names}) < len(names):
        raise Silent("no theorem is written for a number with the name of an entry of a letter")
    return found


def _pivot(statement: Statement, point: Mapping[str, Any]) -> int:
    """Return the place of an entry that is not zero at a point."""
    letters = {name: [[Fraction(entry) for entry in row] for row in point[name]] for name in statement.letters}
    entries = Entries(Algebra(lambda name: Fraction(point[name]), Fraction), letters, {})
    sides = ([entry for row in entries.of(side) for entry in row] for side in (statement.left, statement.right))
    return next(place for place, pair in enumerate(zip(*sides, strict=True)) if all(pair))


def _point(point: Mapping[str, Any], coordinates: Mapping[str, Coordinates], entries: Entries) -> dict[str, str]:
    """Return the numbers at a point, and the entries of its letters."""
    if any(map(_divides, coordinates.values())):
        raise Silent("no theorem is written yet for a point that is about a rotation or a unit vector")
    found = {name: value for name, value in point.items() if isinstance(value, str)}
    for name, letter in coordinates.items():
        for texts, values in zip(entries.letters[name], point[name], strict=True):
            found |= {text.text: value for text, value in zip(texts, values, strict=True) if text.text in letter.names}
    return found


def _are_free(letter: Coordinates) -> bool:
    """Whether any numbers, but for zeros of a divisor, are coordinates of a matrix that has the properties."""
    if letter.signs or ("orthogonal" in letter.properties and not letter.turns):
        return False
    return letter.properties <= {"symmetric", "skew", "diagonal", "orthogonal", "rotation", "unit"}


def _divides(letter: Coordinates) -> bool:
    """Whether the matrix is divided by the square of its coordinates: a quaternion, or the normal of a mirror."""
    return bool(letter.names and (letter.turns or "unit" in letter.properties))


def _square(names: Sequence[str]) -> str:
    return " + ".join(f"{name}**2" for name in names)


def _written(rows: Matrix) -> str:
    lines: Sequence[str] = [f"[{', '.join(entry.text for entry in row)}]" for row in rows]
    return rows[0][0].text if len(rows) == len(rows[0]) == 1 else f"Matrix([{', '.join(lines)}])"
