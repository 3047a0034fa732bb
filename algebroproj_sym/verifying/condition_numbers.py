"""The condition numbers of a-priori error bounds, written as expressions in the arguments."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import ROUND_CEILING, Context
from typing import Any, TypeAlias

from algebroproj_sym.expressions.walking import parts_first
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.verifying.a_priori import ONE, Analysis, analysis
from algebroproj_sym.verifying.straight_line import StraightLine, straight_line

_Node: TypeAlias = "tuple[str, int]"
"""The exact value of an operation, or its magnitude."""

_SUM, _PRODUCT, _ATOM = range(3)

_UPWARDS = Context(prec=3, rounding=ROUND_CEILING)
"""Three digits of a coefficient: what is published is never smaller than what is proved."""


def conditions(found: Analysis) -> tuple[Mapping[int, str], Mapping[str, str]]:
    """Write the condition number of each sum that the bounds of a function mention, and what abbreviations stand for.

    Each abbreviation follows those that it is made of: s7 is a value, m7 is the same with absolute values.

    Examples
    --------
    >>> from algebroproj_sym.verifying.a_priori import analysis
    >>> from algebroproj_sym.generating.program import recorded, run
    >>> from algebroproj_sym.generating.compensation import compensated
    >>> from algebroproj_sym.generating.expansion import expanded
    >>> from algebroproj_sym.verifying.straight_line import numbered
    >>> program = expanded(compensated(recorded("xyz", lambda x, y, z: ((1 - x - y) / z,))))
    >>> conditions(analysis(numbered(program)))[0].values()
    dict_values(['(1 + |x| + |y|)/|1 - x - y|'])
    """
    places = sorted({place for bound in found.bounds if bound is not None for place, _ in bound.terms})
    line = found.line
    roots = [(kind, _first(line, place)) for place in places for kind in ("m", "s")]
    uses: Counter[_Node] = Counter(roots)
    ordered = list(_below(line, roots, uses))
    shared = {node for node in ordered if uses[node] > 1 and _children(line, node)}
    writer = _Writer(line, shared)
    first = {place: _first(line, place) for place in places}
    kappas = {place: f"{writer.text(('m', of), _ATOM)}/|{writer.text(('s', of), _SUM)}|" for place, of in first.items()}
    where = {f"{kind}{place}": writer.written((kind, place))[0] for kind, place in ordered if (kind, place) in shared}
    return kappas, where


def as_record(found: Analysis) -> dict[str, Any]:
    """Return the bounds of a function as plain data: a list of results, and what the abbreviations stand for."""
    kappas, where = conditions(found)
    results = [
        None
        if bound is None
        else {
            "roundings": bound.roundings,
            "terms": [
                {"coefficient": float(_UPWARDS.divide(coefficient, ONE)), "kappa": kappas[place]}
                for place, coefficient in bound.terms
            ],
        }
        for bound in found.bounds
    ]
    return {"results": results, "where": dict(where)}


def a_priori_record(lowered: Lowered) -> dict[str, Any] | None:
    """Return the bounds of a kernel as plain data; None if it is not a rational function."""
    return as_record(analysis(straight_line(lowered))) if lowered.kernel.is_rational else None


def _children(line: StraightLine, node: _Node) -> list[_Node]:
    kind, place = node
    operator, operands = line.operations[place]
    if operator in ("input", "constant"):
        return []
    operands = tuple(_first(line, operand) for operand in operands)
    if operator == "/":
        above = [(kind, operands[0]), ("s", operands[1])]
        return above if kind == "s" or _is_given(line, operands[1]) else [*above, ("m", operands[1])]
    return [(kind, operand) for operand in operands]


def _first(line: StraightLine, place: int) -> int:
    """Return the number to which only what was rounded off was added."""
    operator, operands = line.operations[place]
    return _first(line, operands[0]) if operator == "join" else place


def _is_given(line: StraightLine, place: int) -> bool:
    return line.operations[place][0] in ("input", "constant")


def _below(line: StraightLine, roots: Sequence[_Node], uses: Counter[_Node]) -> Iterator[_Node]:
    """Yield nodes, each after those that it is made of, and count how often each is used."""
    for node in parts_first(roots, lambda node: _children(line, node)):
        uses.update(_children(line, node))
        yield node


@dataclass(frozen=True)
class _Writer:
    line: StraightLine
    shared: set[_Node]

    def text(self, node: _Node, within: int) -> str:
        """Return the text of a node as a part of a sum, of a product, or of something else."""
        text, binding = (f"{node[0]}{node[1]}", _ATOM) if node in self.shared else self.written(node)
        return text if binding >= within else f"({text})"

    def written(self, node: _Node) -> tuple[str, int]:
        """Return the text of a node that is not an abbreviation, and how strongly it binds."""
        kind, place = node
        operator, operands = self.line.operations[place]
        if operator == "input":
            name = self.line.inputs[operands[0]]
            return (f"|{name}|" if kind == "m" else name), _ATOM
        if operator == "constant":
            value = abs(operands[0]) if kind == "m" else operands[0]
            return str(value), _ATOM if value >= 0 else _SUM
        children = _children(self.line, node)
        if operator == "neg":
            return (f"-{self.text(children[0], _PRODUCT)}", _SUM) if kind == "s" else self.written(children[0])
        left, right, *others = children
        if operator in ("+", "-"):
            sign = operator if kind == "s" else "+"
            return f"{self.text(left, _SUM)} {sign} {self.text(right, _SUM if sign == '+' else _PRODUCT)}", _SUM
        divisor = f"|{self.text(right, _SUM)}|" if operator == "/" and kind == "m" else self.text(right, _ATOM)
        if others:
            above = self.text(others[0], _PRODUCT)
            if self.line.operations[left[1]] != ("constant", (1,)):
                above = f"{self.text(left, _PRODUCT)}*{above}"
            return f"{above}/{self.text(right, _ATOM)}**2", _PRODUCT
        if operator == "*":
            return f"{self.text(left, _PRODUCT)}*{self.text(right, _PRODUCT)}", _PRODUCT
        return f"{self.text(left, _PRODUCT)}/{divisor}", _PRODUCT
