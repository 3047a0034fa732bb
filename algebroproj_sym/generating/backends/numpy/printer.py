"""Printing a program as the body of a function of numbers or arrays.

A step that is used once is written into the expression that uses it, with the parentheses that keep the order of
the operations, as long as the line stays readable.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from algebroproj_sym.declaring import LINEAR
from algebroproj_sym.generating.program import Call, Operand, Program, Step
from algebroproj_sym.generating.runtime.pairs import DIGITS

LINE = 100

_TEMPORARY = re.compile(r"t\d+")

_PRECEDENCE = {"+": 1, "-": 1, "*": 2, "/": 2, "neg": 3} | dict.fromkeys(DIGITS, 4)
_ATOM = 4


@dataclass(frozen=True)
class _Text:
    text: str
    precedence: int


def statements(program: Program) -> list[str]:
    r"""Return the statements of the body of a function that returns the outputs of a program.

    Examples
    --------
    >>> program = Program(("x", "y"), (Step("t0", "-", ("x", "y")), Step("t1", "/", (1, "t0"))), ("t1", 0))
    >>> print("\n".join(statements(program)))
    return 1 / (x - y), 0
    """
    uses = program.uses()
    written: dict[Operand, _Text] = {}
    lines: list[str] = []
    doubled = _doubled(program)
    for step in program.steps:
        if isinstance(step, Call):
            lines += _call(step, written)
            continue
        text = _operation(step, written, doubled)
        inlined = uses[step.name] == 1 and bool(_TEMPORARY.fullmatch(step.name)) and len(text.text) <= LINE
        if inlined:
            written[step.name] = text
        else:
            lines.append(f"{step.name} = {text.text}")
    return lines + _returned([_operand(output, written).text for output in program.outputs])


def _returned(outputs: Sequence[str]) -> list[str]:
    """Return the statement that returns a tuple."""
    first, *rest = packed(outputs)
    if rest:
        return ["return (", *(f"    {line}" for line in (first, *rest)), ")"]
    return [f"return ({first})"] if len(outputs) == 1 else [f"return {first.removesuffix(',')}"]


def packed(items: Sequence[str]) -> list[str]:
    """Return lines with as many of the items as fit, each with its comma.

    Examples
    --------
    >>> packed(["a", "b"])
    ['a, b,']
    """
    lines: list[str] = []
    for item in items:
        if lines and len(lines[-1]) + len(item) < LINE:
            lines[-1] += f" {item},"
        else:
            lines.append(f"{item},")
    return lines


def _call(call: Call, written: dict[Operand, _Text]) -> list[str]:
    """Return the statements of a call: a single row of operands in its line, several ones in a line each."""
    if call.primitive == "let":
        return [f"{n} = {_operand(operand, written).text}" for n, operand in zip(call.names, call.rows[0], strict=True)]
    rows = [", ".join(_operand(operand, written).text for operand in row) for row in call.rows]
    single = "," if call.primitive in LINEAR and len(call.names) == 1 else ""
    head = f"{', '.join(call.names)}{single} = {call.primitive}("
    if call.primitive not in LINEAR:
        return [f"{head}{rows[0]})"]
    return [head, *(f"    [{row}]," for row in rows), ")"]


def _operand(operand: Operand, written: dict[Operand, _Text]) -> _Text:
    if operand in written:
        return written[operand]
    negative = isinstance(operand, int) and operand < 0
    return _Text(str(operand), _PRECEDENCE["neg"] if negative else _ATOM)


def _doubled(program: Program) -> set[Operand]:
    """Return the names of the numbers of twice the digits."""
    doubled: set[Operand] = set()
    for step in program.steps:
        if isinstance(step, Step):
            widens = step.operator == "wide" or (step.operator not in DIGITS and not doubled.isdisjoint(step.operands))
            doubled |= {step.name} if widens else set()
        elif step.primitive not in LINEAR and not doubled.isdisjoint(step.operands):
            doubled |= {*step.names}
    return doubled


def _operation(step: Step, written: dict[Operand, _Text], doubled: set[Operand]) -> _Text:
    """Return an operation; a number of twice the digits is its left operand, as an array need not know of those."""
    precedence = _PRECEDENCE[step.operator]
    operands = [_operand(operand, written) for operand in step.operands]
    if isinstance(step.operands[0], str) and step.operands[0] not in doubled and not doubled.isdisjoint(step.operands):
        operands[0] = _Text(f"wide({operands[0].text})", _ATOM)
    if step.operator in DIGITS:
        return _Text(f"{step.operator}({operands[0].text})", _ATOM)
    if step.operator == "neg":
        return _Text(f"-{_parenthesised(operands[0], precedence + 1)}", precedence)
    left, right = _parenthesised(operands[0], precedence), _parenthesised(operands[1], precedence + 1)
    return _Text(f"{left} {step.operator} {right}", precedence)


def _parenthesised(text: _Text, least: int) -> str:
    return text.text if text.precedence >= least else f"({text.text})"
