"""Comparisons of terms, as relations to zero."""

import re

from algebroproj_sym.replaying.reals.definitions import Condition
from algebroproj_sym.replaying.reals.terms import Term, UnreadableError, negative, plus, read

REVERSED = {"<": ">", "<=": ">="}

_COMPARISON = re.compile(r"(<=|>=|!=|==|<|>|=)")


def comparisons(text: str) -> tuple[Condition, ...]:
    """Read comparisons of terms, as relations to zero.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import written
    >>> [(relation, written(term)) for relation, term in comparisons("0 < x <= pi")]
    [('>', 'x - 0'), ('>=', 'pi - x')]
    """
    parts = _COMPARISON.split(text)
    if len(parts) < 3:
        raise UnreadableError(len(text.rstrip()), "a comparison", "the end")
    sides, position = list[Term](), 0
    for place, part in enumerate(parts):
        if place % 2 == 0:
            try:
                sides.append(read(part))
            except UnreadableError as error:
                raise UnreadableError(position + error.position, error.expected, error.got) from None
        position += len(part)
    return tuple(compared(*each) for each in zip(sides, parts[1::2], sides[1:], strict=False))


def equations(text: str) -> tuple[Condition, ...]:
    """Read equations, or a term that is zero, as relations to zero.

    Examples
    --------
    >>> from algebroproj_sym.replaying.reals.terms import written
    >>> [written(term) for _, term in (*equations("x = y"), *equations("x - y"))]
    ['x - y', '(x - y) - 0']
    >>> equations("x < y")
    Traceback (most recent call last):
    ...
    algebroproj_sym.replaying.reals.terms.UnreadableError: position 2: expected '=', got '<'
    """
    signs = [*_COMPARISON.finditer(text)]
    for sign in signs:
        if sign[0] not in ("=", "=="):
            raise UnreadableError(sign.start(), "'='", repr(sign[0]))
    return comparisons(text if signs else f"{text} = 0")


def compared(left: Term, sign: str, right: Term) -> Condition:
    """Return a comparison of two terms, as a relation to zero."""
    if sign in REVERSED:
        return REVERSED[sign], plus(right, negative(left))
    return "=" if sign == "==" else sign, plus(left, negative(right))
