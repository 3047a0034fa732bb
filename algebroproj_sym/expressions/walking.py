"""Walks over what shares parts: each part once, without recursion."""

from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

Part = TypeVar("Part")
Parts = Callable[[Part], Iterable[Part]]


def each_once(roots: Iterable[Part], parts: Parts[Part]) -> Iterator[Part]:
    """Yield everything and its parts once, a whole before its parts.

    Examples
    --------
    >>> made_of = {"f": "ab", "a": "xy", "b": "y", "x": "", "y": ""}
    >>> "".join(each_once("f", made_of.__getitem__))
    'faxyb'
    """
    waiting, met = [*roots][::-1], set[Part]()
    while waiting:
        each = waiting.pop()
        if each not in met:
            met.add(each)
            yield each
            waiting += tuple(parts(each))[::-1]


def parts_first(roots: Iterable[Part], parts: Parts[Part]) -> Iterator[Part]:
    """Yield everything and its parts once, a whole after its parts.

    Examples
    --------
    >>> made_of = {"f": "ab", "a": "xy", "b": "y", "x": "", "y": ""}
    >>> "".join(parts_first("f", made_of.__getitem__))
    'xyabf'
    """
    waiting, met = [(root, False) for root in roots][::-1], set[Part]()
    while waiting:
        each, is_ready = waiting.pop()
        if is_ready:
            yield each
        elif each not in met:
            met.add(each)
            waiting.append((each, True))
            waiting += [(part, False) for part in parts(each)][::-1]
