"""Points whose angles are multiples of one transcendental angle that has a rational sine and cosine.

acos(c) with a rational c between -1 and 1, and a rational sine, is not an algebraic number (Lindemann), nor is pi/2.  A
rational function of it that is not zero at some rational number is not zero there either; a homogeneous one that is
zero at such a number, not zero itself, is zero there too.
"""

import re
from collections.abc import Mapping
from fractions import Fraction
from math import factorial, isqrt
from typing import Any

from algebroproj_sym.replaying.letters.reading import Node
from algebroproj_sym.replaying.letters.series import turning
from algebroproj_sym.replaying.rejection import Rejected, require
from algebroproj_sym.replaying.text import number

_MULTIPLE = re.compile(r"(-?)(?:([1-9][0-9]*)\*)?(?:acos\((-?[0-9]+/[0-9]+)\)|pi)(?:/([1-9][0-9]*))?")


class Turn:
    """An angle, with a rational number in its place; `names` are the letters and numbers that are multiples of it."""

    def __init__(self, value: Fraction) -> None:
        require(value > 0, "what stands for an angle is not positive")
        self.value = value
        self.names: set[str] = set()
        self.others: set[str] = set()
        self.cosine: Fraction | None = None
        self.sine = Fraction(0)

    def read(self, name: str, text: Any) -> Fraction:
        """Return the value of a number, or of an entry of a letter."""
        match = _MULTIPLE.fullmatch(text) if isinstance(text, str) else None
        if match is None:
            value = number(text)
            if value:
                self.others.add(name)
            return value
        sign, times, cosine, over = match.groups()
        self._require_angle(number(cosine) if cosine else Fraction(0))
        self.names.add(name)
        return Fraction(int(times or 1) * (1 if cosine else 2), int(over or 1)) * (-1 if sign else 1) * self.value

    def _require_angle(self, cosine: Fraction) -> None:
        sine = _root(1 - cosine**2) if abs(cosine) < 1 else None
        require(sine is not None, "an angle of which the sine is not rational")
        require(self.cosine in (None, cosine), "two angles must be multiples of one")
        self.cosine, self.sine = cosine, sine or self.sine

    def require_pure(self) -> None:
        """Reject a letter that is neither constant nor a multiple of the angle."""
        require(not self.names & self.others, "a letter that is a multiple of an angle only in part")

    def degree(self, node: Node) -> int | None:
        """Return the power of the angle that a node is homogeneous of; None if it is not known to be."""
        kind = node.kind
        if kind in ("letter", "symbol"):
            return 1 if node.value in self.names else 0
        if kind in ("number", "eye", "zeros", "sin", "cos") or (kind == "exp" and node.shape == (3, 3)):
            return 0
        if kind in ("exp", "jl", "jr", "hat", "ad", "Ad"):
            return None
        zero = (Node("number", (1, 1), (), Fraction(0)),)
        found = [self.degree(part) for part in node.parts if part.kind != "zeros" and part not in zero]
        degrees = [degree for degree in found if degree is not None]
        if len(degrees) < len(found):
            return None
        if kind in ("product", "dot", "outer", "cross", "kron", "qmul"):
            return sum(degrees)
        if len({*degrees}) > 1:
            return None
        degree = degrees[0] if degrees else 0
        if kind in ("det", "adj") and degree:
            size = node.parts[0].shape[0]
            return degree * (size - (kind == "adj")) if isinstance(size, int) else None
        return degree * node.value if kind == "power" else 0 if kind == "rotation" else degree

    def of_argument(self, node: Node) -> int | None:
        """Return the degree of the angle in the argument of an exponential or a Jacobian."""
        if node.kind == "product":
            found = [self.of_argument(part) for part in node.parts]
            return sum(each for each in found if each is not None) if None not in found else None
        if node.kind in ("hat", "ad"):
            return self.degree(turning(node.parts[0]))
        return self.degree(turning(node) if node.shape == (6, 1) else node)

    def length(self, square: Fraction, degree: int | None) -> Fraction:
        """Return the root of a square that has one."""
        root = _root(square)
        if degree is None or root is None:
            raise Rejected("a length that is not known exactly")
        return root

    def functions(self, square: Fraction, degree: int | None) -> Mapping[str, Fraction]:
        """Return Stumpff's functions of the square of an angle."""
        if not square and degree in (0, 1):
            return {f"c{k}": Fraction(1, factorial(k)) for k in range(6)}
        turns = _root(square / self.value**2)
        known = degree == 1 and self.cosine is not None and turns is not None and turns.denominator == 1
        if not known or turns is None or self.cosine is None or turns > 100:
            raise Rejected("an angle of which the sine is not known exactly")
        cosine, sine = Fraction(1), Fraction(0)
        for _ in range(int(turns)):
            cosine, sine = cosine * self.cosine - sine * self.sine, sine * self.cosine + cosine * self.sine
        found = [cosine, sine / (turns * self.value)]
        for place in range(4):
            found.append((Fraction(1, factorial(place)) - found[place]) / square)
        return {f"c{k}": value for k, value in enumerate(found)}


def _root(square: Fraction) -> Fraction | None:
    if square < 0:
        return None
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return root if root * root == square else None
