"""Exponential maps, sines and lengths: the laws by which a proof replaces them, read and applied by code of its own.

N is the square of an angle, c0, c1, ... are Stumpff's functions of N: ``c_k = 1/k! - N/(k + 2)! + N**2/(k + 4)! - ...``
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from math import factorial, isqrt
from typing import Any, NamedTuple

from algebroproj_sym.replaying.letters.reading import NUMBER, Node, changed, constant, made, parts_of, read
from algebroproj_sym.replaying.letters.statement import Statement
from algebroproj_sym.replaying.rejection import Rejected, require
from algebroproj_sym.replaying.text import texts

EXPONENTIAL: Mapping[int, Sequence[str]] = {
    3: ("1", "c1", "c2"),
    4: ("1", "1", "c2", "c3"),
    6: ("1", "1 + N*(c2 - 3*c3)/2", "2*c2 - c1/2", "(c2 - c3)/2", "(c3 - 2*c4)/2"),
}
"""``M**j/j!`` summed, by the size of M: K**3 = -N*K, M**4 = -N*M**2, M*(M**2 + N)**2 = 0."""
JACOBIAN: Mapping[int, Sequence[str]] = {
    3: ("1", "c2", "c3"),
    6: ("1", "2*c2 - c1/2", "(5*c3 - c2)/2", "(c3 - 2*c4)/2", "(c4 - 3*c5)/2"),
}
"""``M**j/(j + 1)!`` summed."""
BETWEEN: Mapping[int, str] = {
    0: "c0**2 + N*c1**2 - 1",
    1: "c1**2 + N*c2**2 - 2*c2",
    2: "c1**2 + N*c2**2 - 2*c2",
    3: "N*c3**2 - 2*c3 + 2*c4 + c2**2",
    4: "N*c3**2 - 2*c3 + 2*c4 + c2**2",
}
"""The sum of the squares of cosine and sine is 1; divided by N where that is possible."""
TWICE: Mapping[int, str] = {0: "2*c0**2 - 1", 1: "c0*c1", 2: "c1**2/2", 3: "(c2 + c3 - N*c2*c3)/4"}
"""The functions of 4*N."""
KINDS = ("sin", "cos", "exp", "jl", "jr", "norm")


class Angle(NamedTuple):
    """A multiple of a vector or number, the length of which is an angle."""

    factor: Fraction
    of: Node


def has_functions(statement: Statement) -> bool:
    """Whether a statement has functions of angles, or lengths."""
    return any(part.kind in KINDS for node in statement.nodes for part in parts_of(node))


def without_functions(statement: Statement, angles: Any) -> Statement:
    """Put polynomials in numbers for functions of the listed angles; the numbers are related by constraints."""
    shapes = {name: letter.shape for name, letter in statement.letters.items()}
    listed = [read(text, shapes) for text in texts(angles)]
    series = _Series(statement, listed)
    plain = statement.every(series.plain)
    return replace(plain, constraints=(*plain.constraints, *series.relations()))


def matrix_of(node: Node) -> Node:
    """Return the matrix M of a series."""
    inner: Node = node.parts[0]
    if node.kind == "exp":
        return inner
    vector = made("product", constant(-1), inner) if node.kind == "jr" else inner
    return made("skew" if inner.shape == (3, 1) else "ad", vector)


def turning(motion: Node) -> Node:
    """Return the rotation vector of a motion: its last three components."""
    if motion.kind == "block" and [part.shape for part in motion.parts] == [(3, 1), (3, 1)]:
        vector: Node = motion.parts[1]
        return vector
    if motion.kind == "product" and len(motion.parts) == 2 and motion.parts[0].shape == NUMBER:
        return made("product", motion.parts[0], turning(motion.parts[1]))
    return made("block", *(made("entry", motion, value=(place, 0)) for place in (3, 4, 5)), value=(1, 1, 1))


class _Series:
    def __init__(self, statement: Statement, listed: Sequence[Node]) -> None:
        self.letters = statement.letters
        self.listed = listed
        self.highest: dict[Node, int] = {}
        self.smallest: dict[Node, Fraction] = {}
        self.lengths: set[Node] = set()
        seen: set[Node] = set()
        functions = [part for node in statement.nodes for part in parts_of(node) if part.kind in KINDS]
        for part in functions:
            for angle in self._angles(part):
                seen.add(angle.of)
                if angle.factor:
                    size = abs(angle.factor)
                    self.smallest[angle.of] = min(size, self.smallest.get(angle.of, size))
                if part.kind == "norm":
                    self.lengths.add(angle.of)
                else:
                    self.highest[angle.of] = max(self._needed(part), self.highest.get(angle.of, 1))
        require(seen == {*listed} and len(seen) == len(listed), "the angles are not those of the statement")
        own = {
            f"{kind}_{k}" for kind in ("c0", "c1", "c2", "c3", "c4", "c5", "length") for k in range(1, len(listed) + 1)
        }
        names = {part.value for node in statement.nodes for part in parts_of(node) if part.kind in ("symbol", "letter")}
        require(not own & (names | self.letters.keys()), "a name stands for a function of an angle, too")

    def _needed(self, part: Node) -> int:
        if part.kind in ("sin", "cos") or (part.kind == "exp" and self._about_unit(part.parts[0])):
            return 1
        table = EXPONENTIAL if part.kind == "exp" else JACOBIAN
        return max(
            int(text[place + 1]) for text in table[int(part.shape[0])] for place, c in enumerate(text) if c == "c"
        )

    # -- angles

    def _angles(self, part: Node) -> list[Angle]:
        (inner,) = part.parts
        if part.kind in ("sin", "cos"):
            return [self._angle(term) for term in _terms(inner)]
        if part.kind == "norm":
            return [self._angle(inner)]
        if part.kind != "exp":
            return [self._angle(inner if inner.shape == (3, 1) else turning(inner))]
        unit = self._about_unit(inner)
        return [self._angle(term) for term in _terms(unit[0])] if unit else [self._angle(self._turned(inner))]

    def _turned(self, matrix: Node) -> Node:
        """Return the rotation vector of a multiple of a cross-product matrix, or of the matrix of a motion."""
        factors = [*_factors(matrix)]
        numbers = [factor for factor in factors if factor.shape == NUMBER]
        core = [factor for factor in factors if factor.shape != NUMBER]
        while (
            matrix.shape == (3, 3)
            and len(core) > 2
            and self._is_orthogonal(core[0])
            and core[-1] == _transposed(core[0])
        ):
            core = core[1:-1]
        (inner,) = core if len(core) == 1 else (None,)
        if inner is None:
            raise Rejected("the exponential of another matrix")
        if inner.kind == "letter" and inner.shape == (3, 3) and "skew" in self.letters[inner.value].properties:
            vector = made("vee", inner)
        else:
            require(inner.kind in ("skew", "hat", "ad"), "the exponential of another matrix")
            vector = inner.parts[0] if inner.kind == "skew" else turning(inner.parts[0])
        return made("product", *numbers, vector) if numbers else vector

    def _about_unit(self, matrix: Node) -> tuple[Node, Node] | None:
        """Return x and n where a matrix is the cross-product matrix of x*n, and n a letter that is a unit vector."""
        factors = [*_factors(matrix)]
        if factors[-1].kind != "skew":
            return None
        factors[-1:] = _factors(factors[-1].parts[0])
        axes = [factor for factor in factors if self._is_unit(factor)]
        numbers = [factor for factor in factors if factor.shape == NUMBER]
        if len(axes) != 1 or len(numbers) + 1 != len(factors):
            return None
        return (made("product", *numbers) if len(numbers) > 1 else [*numbers, constant(1)][0]), axes[0]

    def _angle(self, node: Node) -> Angle:
        """Return a multiple with the same length, or its opposite: orthogonal letters and unit vectors are left out."""
        if node.kind == "norm":
            return self._angle(node.parts[0])
        if node.kind == "power" and node.value == -1 and node.parts[0].kind == "number":
            return Angle(1 / node.parts[0].value, constant(1))
        factors = [*_factors(node)]
        value, numbers, others = Fraction(1), list[Node](), list[Node]()
        for factor in factors:
            if factor.kind == "number":
                value *= factor.value
            else:
                (numbers if factor.shape == NUMBER else others).append(factor)
        while len(others) > 1 and self._is_orthogonal(others[0]):
            others = others[1:]
        length = _length_of_numbers(others[0]) if len(others) == 1 else None
        if length is not None or (len(others) == 1 and self._is_unit(others[0])):
            others, value = [], value * (length or 1)
        rest = numbers + others
        if not value or not rest:
            return Angle(value, constant(1))
        if len(rest) > 1:
            return Angle(value, made("product", *rest))
        if rest[0] == node or (len(factors) == 1 and rest[0] == factors[0]):
            return Angle(value, constant(1) if self._is_unit(rest[0]) else rest[0])
        inner = self._angle(rest[0])
        return Angle(value * inner.factor, inner.of)

    def _is_orthogonal(self, node: Node) -> bool:
        letter = node.parts[0] if node.kind == "transpose" else node
        return letter.kind == "letter" and "orthogonal" in self.letters[letter.value].properties

    def _is_unit(self, node: Node) -> bool:
        return node.kind == "letter" and "unit" in self.letters[node.value].properties

    # -- numbers

    def _square(self, core: Node) -> Node:
        return made("power", core, value=2) if core.shape == NUMBER else made("dot", core, core)

    def _base(self, core: Node) -> Node:
        """Return the square of the smallest multiple."""
        factor = self.smallest.get(core, Fraction(1))
        square = self.plain(self._square(core))
        return square if factor == 1 else made("product", constant(factor**2), square)

    def relations(self) -> Iterator[Node]:
        """Yield what is zero between the numbers, angle by angle."""
        for place, core in enumerate(self.listed, 1):
            if core in self.highest and core in self.smallest:
                yield self._filled(BETWEEN[self.highest[core] - 1], core, 0)
            if core in self.lengths:
                length = made("power", Node("symbol", NUMBER, (), f"length_{place}"), value=2)
                yield made("sum", length, made("product", constant(-1), self.plain(self._square(core))))

    def _filled(self, text: str, core: Node, doublings: int) -> Node:
        square = made("product", constant(4**doublings), self._base(core))
        return changed(
            read(text, {}),
            lambda node: (
                (square if node.value == "N" else self._stumpff(int(node.value[1]), core, doublings))
                if node.kind == "symbol"
                else None
            ),
        )

    def _stumpff(self, degree: int, core: Node, doublings: int) -> Node:
        """Return c_k of the smallest multiple of an angle, doubled some times."""
        if doublings:
            require(degree in TWICE, "a function of a double angle that is not known")
            return self._filled(TWICE[degree], core, doublings - 1)
        highest = self.highest[core]
        require(degree <= highest, "a function that is not known")
        if degree >= highest - 1:
            return Node("symbol", NUMBER, (), f"c{degree}_{self.listed.index(core) + 1}")
        above = made("product", constant(-1), self._base(core), self._stumpff(degree + 2, core, 0))
        return made("sum", constant(Fraction(1, factorial(degree))), above)

    def _at(self, text: str, angle: Angle) -> Node:
        """Return a polynomial in the functions of an angle."""
        if not angle.factor:
            return changed(read(text, {}), lambda node: _at_zero(node.value) if node.kind == "symbol" else None)
        ratio = abs(angle.factor) / self.smallest[angle.of]
        doublings = ratio.numerator.bit_length() - 1
        require(ratio == 2**doublings, "an angle must be a multiple by a power of 2")
        return self._filled(text, angle.of, doublings)

    # -- nodes

    def plain(self, node: Node) -> Node:
        """Return a node without functions."""
        return changed(node, lambda part: self._plain(part) if part.kind in KINDS else None)

    def _plain(self, part: Node) -> Node:
        (inner,) = part.parts
        if part.kind == "norm":
            angle = self._angle(inner)
            symbol = Node("symbol", NUMBER, (), f"length_{self.listed.index(angle.of) + 1}")
            return made("product", constant(abs(angle.factor)), symbol)
        if part.kind in ("sin", "cos"):
            return self._of_sum(_terms(inner))[part.kind == "sin"]
        matrix = self.plain(matrix_of(part))
        unit = self._about_unit(inner) if part.kind == "exp" else None
        if unit:
            cosine, sine = self._of_sum(_terms(unit[0]))
            axis = made("skew", unit[1])
            factors: list[Node] = [constant(1), sine, made("sum", constant(1), made("product", constant(-1), cosine))]
            return _polynomial(factors, axis)
        (angle,) = self._angles(part)
        table = EXPONENTIAL if part.kind == "exp" else JACOBIAN
        return _polynomial([self._at(text, angle) for text in table[int(part.shape[0])]], matrix)

    def _of_sum(self, terms: Sequence[Node]) -> tuple[Node, Node]:
        """Return cosine and sine of a sum, by the theorem of addition."""
        first = self._angle(terms[0])
        cosine, sine = self._at("c0", first), made("product", self.plain(terms[0]), self._at("c1", first))
        if len(terms) == 1:
            return cosine, sine
        other, another = self._of_sum(terms[1:])
        minus = made("product", constant(-1), sine, another)
        return (
            made("sum", made("product", cosine, other), minus),
            made("sum", made("product", sine, other), made("product", cosine, another)),
        )


def _length_of_numbers(vector: Node) -> Fraction | None:
    """Return the length of a column of numbers, where it is rational and positive."""
    if vector.kind != "block" or vector.shape[1] != 1 or {part.kind for part in vector.parts} != {"number"}:
        return None
    total = sum((part.value * part.value for part in vector.parts), Fraction(0))
    root = Fraction(isqrt(total.numerator), isqrt(total.denominator))
    return root if root > 0 and root * root == total else None


def _at_zero(name: str) -> Node:
    return constant(0) if name == "N" else constant(Fraction(1, factorial(int(name[1]))))


def _factors(node: Node) -> Iterator[Node]:
    if node.kind == "product":
        for part in node.parts:
            yield from _factors(part)
    else:
        yield node


def _terms(node: Node) -> list[Node]:
    """Return the terms of a sum, which may be multiplied by a number."""
    if node.kind == "sum":
        return [term for part in node.parts for term in _terms(part)]
    if (
        node.kind == "product"
        and len(node.parts) == 2
        and node.parts[0].kind == "number"
        and node.parts[1].kind == "sum"
    ):
        return [made("product", node.parts[0], term) for term in _terms(node.parts[1])]
    return [node]


def _transposed(node: Node) -> Node:
    return node.parts[0] if node.kind == "transpose" else made("transpose", node)


def _polynomial(factors: Sequence[Node], matrix: Node) -> Node:
    powers = (made("power", matrix, value=power) for power in range(len(factors)))
    return made("sum", *(made("product", factor, power) for factor, power in zip(factors, powers, strict=True)))
