r"""Equations that give an angle by an inverse function, as ``\psi = \arctan(a/b)``, and what they say of the angle."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from lark import Token, Tree

from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.parsing.factors import is_inverse
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, parsed, put_in, symbols_in, trees_in


@dataclass(frozen=True)
class OfAngle:
    """What an equation says of a function of an angle."""

    left: Formula
    right: Formula
    """Its sides."""
    angle: Formula
    """The angle."""
    between: Parsed
    """Where the inverse function has its values."""
    positive: Formula | None = None
    """What is positive, where the function has two arguments."""


_BETWEEN = {
    "sin": r"-\pi/2 \le a \le \pi/2",
    "cos": r"0 \le a \le \pi",
    "tan": r"-\pi/2 < a < \pi/2",
    "atan2": r"-\pi < a \le \pi",
}
"""Where the inverse of a function has its values."""


def of_angle(left: Formula, right: Formula) -> OfAngle | None:
    r"""Return what an equation says of a function of the angle on its left; None if it gives no angle.

    ``\operatorname{atan2}(y, x)`` has y as its sine and x as its cosine, but for a positive factor.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import printed
    >>> found = of_angle(*parsed(r"a = -2 \arccos w").sides)
    >>> printed(found.left), printed(found.right), found.between.relations
    ('function [cos fraction [sum [- a] 2]]', 'w', ('<=', '<='))
    >>> printed(of_angle(*parsed(r"a = \operatorname{atan2}(y, x)").sides).positive)
    'sum [run [y function [sin a]] + run [x function [cos a]]]'
    """
    angle, value = left, right
    while value.data == "sum" and len(value.children) == 2 and value.children[0] == "-":
        angle, value = Tree("sum", [Token("SIGN", "-"), angle]), trees_in(value)[0]
    if value.data == "run" and not any(map(symbols_in, value.children[:-1])):  # type: ignore[arg-type]
        *numbers, value = trees_in(value)
        angle = Tree("fraction", [angle, numbers[0] if len(numbers) == 1 else Tree("run", [*numbers])])
    name, inside = _inverted(value)
    if not name or not symbols_in(left):
        return None
    if name == "atan2":
        y, x = inside
        crossed = [_run(y, _of("cos", angle)), _run(x, _of("sin", angle))]
        along: Formula = Tree("sum", [_run(y, _of("sin", angle)), Token("SIGN", "+"), _run(x, _of("cos", angle))])
        return OfAngle(crossed[0], crossed[1], angle, _between(name, angle), along)
    return OfAngle(_of(name, angle), inside[0], angle, _between(name, angle))


def _between(name: str, angle: Formula) -> Parsed:
    found = parsed(_BETWEEN[name])
    return replace(found, sides=tuple(put_in(each, {letter_of("a"): angle}) for each in found.sides))


def _inverted(tree: Formula) -> tuple[str, Sequence[Formula]]:
    """Return the function of which the inverse stands in a formula, with its arguments; an empty name for none."""
    name, inside = str(tree.children[0]) if tree.children else "", trees_in(tree)
    if tree.data == "raised_function" and name in _BETWEEN and is_inverse(Tree("power", tree.children[:2])):
        arguments = trees_in(inside[1])
        return (name, arguments) if len(arguments) == 1 else ("", ())
    arguments = trees_in(inside[0]) if tree.data == "function" else []
    if name in ("atan2", "arctan2"):
        return ("atan2", arguments) if len(arguments) == 2 else ("", ())
    name = name.removeprefix("arc") if name.startswith("arc") else name.removeprefix("a")
    return (
        (name, arguments) if len(arguments) == 1 and str(tree.children[0])[0] == "a" and name in _BETWEEN else ("", ())
    )


def _of(name: str, angle: Formula) -> Formula:
    return Tree("function", [Token("FUNCTION", name), Tree("items", [angle])])


def _run(*factors: Formula) -> Formula:
    return Tree("run", [Tree("group", [each]) if each.data == "sum" else each for each in factors])
