"""Claims in letters as claims about entries: letters are written out, and what constraints define is put in."""

from __future__ import annotations

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
from algebroproj_sym.replaying.letters.statement import conditions, stated, without_definitions, without_lengths


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
    """Return the record of an identity in letters as one about entries: an identity of rational functions.

    Raises
    ------
    Silent
        If the claim is of another kind or is refuted, a size is a letter, there are functions of angles, or a
        constraint defines nothing.
    """
    setting = record["setting"]
    if record["verdict"] != "proved" or record["kind"] not in ("identity", "identity under constraints"):
        raise Silent("no theorem is written yet for a claim in letters of this kind or verdict")
    question = {"letters": setting["letters"], "lhs": record["printed"], "rhs": record["derived"]}
    conditional = {name: setting.get(name, []) for name in ("constraints", "nonzero")}
    statement = without_derivatives(without_definitions(without_lengths(stated(question | conditional))))
    if statement.sizes or has_functions(statement):
        raise Silent("no theorem is written yet for letters of any size, or with functions of angles")
    coordinates = {name: Coordinates(name, letter) for name, letter in statement.letters.items()}
    if statement.constraints or any(each.properties - {"symmetric", "skew"} for each in coordinates.values()):
        raise Silent("no theorem is written yet for letters under constraints")
    symbols = {part.value for node in statement.nodes for part in parts_of(node) if part.kind == "symbol"}
    names = [*symbols, *(name for each in coordinates.values() for name in each.names)]
    if len({*names}) < len(names):
        raise Silent("no theorem is written for a number with the name of an entry of a letter")
    algebra = Algebra(_Text, lambda value: _Text(str(Fraction(value))))
    entries = Entries(algebra, {name: each.matrix(algebra) for name, each in coordinates.items()}, {})
    hypotheses = sorted(entries.scalar(condition).text for condition in conditions(statement))
    printed, derived = (_written(entries.of(side)) for side in (statement.left, statement.right))
    about = {"kind": "identity", "setting": {}, "printed": printed, "derived": derived, "hypotheses": hypotheses}
    return {**record, **about}


def _written(rows: Matrix) -> str:
    lines: Sequence[str] = [f"[{', '.join(entry.text for entry in row)}]" for row in rows]
    return rows[0][0].text if len(rows) == len(rows[0]) == 1 else f"Matrix([{', '.join(lines)}])"
