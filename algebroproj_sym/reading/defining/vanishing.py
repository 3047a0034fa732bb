r"""Products that are zero: which factor is zero, an equation such as ``x (x - a) = 0`` does not say."""

from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in, trees_in


def factors_of_zero(left: Formula, right: Formula) -> list[Formula]:
    """Return the factors with letters, if an equation says that a product is zero.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> [len(factors_of_zero(*parsed(each).sides)) for each in ("2 x (x - a) = 0", "x a = b", "x - a = 0")]
    [2, 0, 0]
    """
    for side, other in ((left, right), (right, left)):
        if other.data == "number" and other.children[0] == "0" and side.data == "run":
            return [each for each in trees_in(side) if symbols_in(each)]
    return []


def share_a_sum(left: Formula, right: Formula) -> bool:
    """Whether both sides have the same sum as a factor: it may be zero, and then they say nothing of the other ones.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> [share_a_sum(*parsed(each).sides) for each in ("(a - b) c = (a - b) d", "a c = a d")]
    [True, False]
    """
    ours, theirs = (trees_in(each) if each.data == "run" else [each] for each in (left, right))
    return any(each in theirs and any(True for _ in each.find_data("sum")) for each in ours)


def are_lone(factors: list[Formula]) -> bool:
    """Whether there are factors, and all are letters."""
    return bool(factors) and all(each.data == "symbol" for each in factors)


def leave_a_choice(factors: list[Formula], letter: str) -> bool:
    """Whether another factor than that of a letter may be zero: a sum, or one with a letter of the same factor."""
    inside = [each for each in factors if letter in symbols_in(each)]
    others = [each for each in factors if each not in inside]
    within = {symbol for each in inside for symbol in symbols_in(each)}
    return len(inside) > 1 or (
        bool(inside) and any(each.data != "symbol" or within & {*symbols_in(each)} for each in others)
    )
