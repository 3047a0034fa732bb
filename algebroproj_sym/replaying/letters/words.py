"""Sums of words in one form: two sums that are equal by the laws of rings and transposes give the same dictionary.

An atom is a text, entered with its shape and with what it becomes when it is transposed.  Parts of a word that are
numbers are taken out of it, as texts of their own.
"""

from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import reduce
from itertools import pairwise, repeat
from typing import NamedTuple, TypeAlias

from algebroproj_sym.replaying.letters.reading import NUMBER, Letter, Node, Shape, Size
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected, require

Word: TypeAlias = tuple[str, ...]
Term: TypeAlias = tuple[Word, Word]
"""Numbers that commute, in order, and a word."""

MOST_TERMS = 5_000


class Poly(NamedTuple):
    """A matrix or a number: coefficients by term."""

    shape: Shape
    terms: Mapping[Term, Fraction]

    def text(self) -> str:
        """Return the one text that equal ones have."""
        return f"{self.shape[0]}x{self.shape[1]}:{sorted(self.terms.items())}"


class _Atom(NamedTuple):
    shape: Shape
    factor: Fraction
    transposed: str


class Words:
    """The algebra of the words in some letters.

    `is_sized` says whether something was used that holds for the given sizes alone.

    Examples
    --------
    >>> from algebroproj_sym.replaying.letters.reading import read
    >>> words = Words({"A": Letter(("n", "n"), frozenset()), "v": Letter(("n", 1), frozenset())})
    >>> shapes = {"A": ("n", "n"), "v": ("n", 1)}
    >>> words.poly(read("v.T*A*v", shapes)) == words.poly(read("v.T*A.T*v", shapes))
    True
    """

    def __init__(self, letters: Mapping[str, Letter]) -> None:
        self.letters = letters
        self.is_sized = False
        self.is_closed = False
        self.atoms: dict[str, _Atom] = {}
        self.inside: dict[str, Poly] = {}
        self.known: dict[Node, Poly] = {}

    def close(self) -> None:
        """Allow no inverse any more that was not met."""
        self.is_closed = True

    # -- sums and products

    def constant(self, value: Fraction | int, shape: Shape = NUMBER) -> Poly:
        """Return a multiple of the identity."""
        return Poly(shape, {((), ()): Fraction(value)} if value else {})

    def number(self, name: str) -> Poly:
        """Return a number that is not further known."""
        return Poly(NUMBER, {((name,), ()): Fraction(1)})

    def plus(self, left: Poly, right: Poly, factor: Fraction | int = 1) -> Poly:
        """Return a sum, with a multiple of the second term."""
        terms = dict(left.terms)
        for term, value in right.terms.items():
            terms[term] = terms.get(term, Fraction(0)) + value * factor
        return self._poly(left.shape, terms)

    def _poly(self, shape: Shape, terms: Mapping[Term, Fraction]) -> Poly:
        if len(terms) > MOST_TERMS:
            raise NotReplayable("too many words")
        return Poly(shape, {term: value for term, value in terms.items() if value})

    def times(self, left: Poly, right: Poly) -> Poly:
        """Return a product."""
        if left.shape == NUMBER or right.shape == NUMBER:
            shape = right.shape if left.shape == NUMBER else left.shape
        else:
            require(left.shape[1] == right.shape[0], "words that do not fit together")
            shape = left.shape[0], right.shape[1]
        if len(left.terms) * len(right.terms) > MOST_TERMS:
            raise NotReplayable("too many words")
        terms: dict[Term, Fraction] = {}
        for (s, word), a in left.terms.items():
            for (t, other), b in right.terms.items():
                factor, term = self._term((*s, *t), word + other)
                terms[term] = terms.get(term, Fraction(0)) + factor * a * b
        return self._poly(shape, terms)

    def _term(self, numbers: Word, word: Word) -> tuple[Fraction, Term]:
        """Return a word without the parts of it that are numbers."""
        cuts = self._cuts(word)
        factor, taken = Fraction(1), [*numbers]
        for start, end in pairwise(cuts):
            found, least = self._least([word[start:end]])
            factor *= found
            taken.append(self._enter_number("form", least))
        if len(cuts) > 1:
            word = word[: cuts[0]] + word[cuts[-1] :]
        return factor, ((*sorted(taken),), word)

    def _cuts(self, word: Word) -> list[int]:
        sizes = [self.atoms[atom].shape[0] for atom in word]
        if word:
            sizes.append(self.atoms[word[-1]].shape[1])
        return [place for place, size in enumerate(sizes) if size == 1]

    def _enter_number(self, kind: str, word: Word) -> str:
        return f"{kind}({'*'.join(word)})"

    def _least(self, words: Iterable[Word]) -> tuple[Fraction, Word]:
        """Return the first of equal numbers, with its factor; zero where they are a number and its opposite."""
        candidates = [(Fraction(1), word) for word in words]
        candidates += [self._turned(word) for _, word in candidates]
        least = min(word for _, word in candidates)
        factors = {factor for factor, word in candidates if word == least}
        return (factors.pop() if len(factors) == 1 else Fraction(0)), least

    def _turned(self, word: Word) -> tuple[Fraction, Word]:
        """Return the transpose of a word, with a factor."""
        factor = Fraction(1)
        for atom in word:
            factor *= self.atoms[atom].factor
        return factor, tuple(self.atoms[atom].transposed for atom in reversed(word))

    def transpose(self, poly: Poly) -> Poly:
        """Return the transpose."""
        terms: dict[Term, Fraction] = {}
        for (numbers, word), value in poly.terms.items():
            factor, other = self._turned(word)
            terms[numbers, other] = terms.get((numbers, other), Fraction(0)) + factor * value
        return self._poly((poly.shape[1], poly.shape[0]), terms)

    # -- atoms

    def _atom(self, name: str) -> Poly:
        return Poly(self.atoms[name].shape, {((), (name,)): Fraction(1)})

    def _enter(self, name: str, shape: Shape, factor: Fraction | int, transposed: str) -> None:
        self.atoms.setdefault(name, _Atom(shape, Fraction(factor), transposed))

    def letter(self, name: str) -> Poly:
        """Return a letter."""
        shape, properties = self.letters[name]
        self.is_sized |= shape == NUMBER
        sign = 1 if "symmetric" in properties else -1 if "skew" in properties else 0
        other = name if sign else f"{name}.T"
        self._enter(name, shape, sign or 1, other)
        self._enter(other, (shape[1], shape[0]) if not sign else shape, sign or 1, name)
        return self._atom(name)

    def _inverted(self, poly: Poly) -> Poly:
        """Return the inverse of a matrix as a factor; that of the transposed matrix is its transpose."""
        value, base = self._normal(poly)
        other_value, other = self._normal(self.transpose(base))
        name, turned = f"inverse[{base.text()}]", f"inverse[{other.text()}]"
        require(name in self.atoms or not self.is_closed, "an inverse that the statement does not have")
        self._enter(name, poly.shape, 1 / other_value, turned)
        self._enter(turned, poly.shape, other_value, name)
        self.inside |= {name: base, turned: other}
        return self.times(self.constant(1 / value), self._atom(name))

    def _normal(self, poly: Poly) -> tuple[Fraction, Poly]:
        """Return the coefficient of the first term, and the polynomial divided by it."""
        first = poly.terms[min(poly.terms)]
        return first, self._poly(poly.shape, {term: value / first for term, value in poly.terms.items()})

    # -- functions

    def trace(self, poly: Poly) -> Poly:
        """Return the trace; its words may be rotated and transposed."""
        if poly.shape == NUMBER:
            return poly
        total = self.constant(0)
        for (numbers, word), value in poly.terms.items():
            cuts = self._cuts(word)
            if not word:
                part = self._size(poly.shape[0])
            elif cuts:
                factor, (taken, rest) = self._term((), word[cuts[0] :] + word[: cuts[0]])
                require(not rest, "a trace must be a number")
                part = Poly(NUMBER, {(taken, ()): factor})
            else:
                factor, least = self._least(word[k:] + word[:k] for k in range(len(word)))
                part = self.times(self.constant(factor), self.number(self._enter_number("trace", least)))
            total = self.plus(total, self.times(Poly(NUMBER, {(numbers, ()): value}), part))
        return total

    def _size(self, size: Size) -> Poly:
        if isinstance(size, str):
            return self.number(size)
        self.is_sized = True
        return self.constant(size)

    def determinant(self, poly: Poly) -> Poly:
        """Return the determinant, of a product factor by factor."""
        if poly.shape == NUMBER or not poly.terms:
            return poly if poly.terms else self.constant(0)
        if len(poly.terms) > 1 or not self._has_square_factors(poly):
            return self.number(f"det[{min(poly.text(), self.transpose(poly).text())}]")
        (((numbers, word), value),) = poly.terms.items()
        result = self.constant(1)
        if numbers or value != 1:
            if not isinstance(poly.shape[0], int):
                raise Rejected("the determinant of a multiple of a matrix of any size")
            self.is_sized = True
            result = self.power(Poly(NUMBER, {(numbers, ()): value}), poly.shape[0])
        parts = (self._atom(atom) for atom in word)
        names = (min(part.text(), self.transpose(part).text()) for part in parts)
        return reduce(self.times, (self.number(f"det[{name}]") for name in names), result)

    def _has_square_factors(self, poly: Poly) -> bool:
        shapes = (self.atoms[atom].shape for _, word in poly.terms for atom in word)
        return all(rows == columns for rows, columns in shapes)

    def inverse(self, poly: Poly) -> Poly:
        """Return the inverse, of a product factor by factor."""
        require(bool(poly.terms), "the inverse of zero")
        if poly.shape == NUMBER:
            return self._reciprocal(poly)
        if len(poly.terms) > 1 or not self._has_square_factors(poly):
            value, base = self._normal(poly)
            return self.times(self.constant(1 / value), self._inverted(base))
        (((numbers, word), value),) = poly.terms.items()
        result = self.times(self._reciprocal(Poly(NUMBER, {(numbers, ()): value})), self.constant(1, poly.shape))
        return reduce(self.times, map(self._inverse_of, reversed(word)), result)

    def _inverse_of(self, atom: str) -> Poly:
        one = self._atom(atom)
        letter = self.letters.get(atom.removesuffix(".T"))
        if letter is not None and "orthogonal" in letter.properties:
            return self.transpose(one)
        if atom.startswith("inverse["):
            return self.inside[atom]
        return self._inverted(one)

    def _reciprocal(self, poly: Poly) -> Poly:
        value, base = self._normal(poly)
        if len(base.terms) > 1:
            return self.times(self.constant(1 / value), self._one_over(base))
        (((numbers, _), _),) = base.terms.items()
        parts = (self.inside[name] if name in self.inside else self._one_over(self.number(name)) for name in numbers)
        return reduce(self.times, parts, self.constant(1 / value))

    def _one_over(self, poly: Poly) -> Poly:
        name = f"reciprocal[{poly.text()}]"
        if name not in self.inside:
            require(not self.is_closed, "a divisor that the statement does not have")
            self.inside[name] = poly
        return self.number(name)

    def power(self, poly: Poly, exponent: int) -> Poly:
        """Return a power."""
        base = poly if exponent >= 0 else self.inverse(poly)
        return reduce(self.times, repeat(base, abs(exponent)), self.constant(1, poly.shape))

    def adjugate(self, poly: Poly) -> Poly:
        """Return the adjugate, of a product factor by factor; that of a number is one."""
        if poly.shape == NUMBER:
            return self.constant(1)
        if not poly.terms:
            require(isinstance(poly.shape[0], int), "the adjugate of a zero matrix of any size")
            self.is_sized = True
            return poly
        if len(poly.terms) == 1 and self._has_square_factors(poly):
            (((numbers, word), value),) = poly.terms.items()
            if len(word) != 1 and not numbers and value == 1:
                parts = (self.adjugate(self._atom(atom)) for atom in reversed(word))
                return reduce(self.times, parts, self.constant(1, poly.shape))
        name, turned = f"adj[{poly.text()}]", f"adj[{self.transpose(poly).text()}]"
        opposite = f"adj[{self.plus(self.constant(0, poly.shape), poly, -1).text()}]"
        if turned == opposite:
            if not isinstance(poly.shape[0], int):
                raise Rejected("the adjugate of a skew matrix of any size")
            self.is_sized = True
            self._enter(name, poly.shape, (-1) ** (poly.shape[0] - 1), name)
        self._enter(name, poly.shape, 1, turned)
        self._enter(turned, poly.shape, 1, name)
        return self._atom(name)

    def skew(self, poly: Poly) -> Poly:
        """Return the cross-product matrix, which is linear."""
        self.is_sized = True
        terms: dict[Term, Fraction] = {}
        for (numbers, word), value in poly.terms.items():
            name = f"skew[{'*'.join(word)}]"
            self._enter(name, (3, 3), -1, name)
            self.inside[name] = Poly((3, 1), {((), word): Fraction(1)})
            terms[numbers, (name,)] = value
        return self._poly((3, 3), terms)

    def _vee(self, poly: Poly) -> Poly:
        total = self.constant(0, (3, 1))
        for (numbers, word), value in poly.terms.items():
            require(len(word) == 1 and word[0].startswith("skew["), "vee needs a cross-product matrix")
            part = self.times(Poly(NUMBER, {(numbers, ()): value}), self.inside[word[0]])
            total = self.plus(total, part)
        return total

    # -- from nodes

    def poly(self, node: Node) -> Poly:
        """Return a node as a sum of words."""
        if node not in self.known:
            self.known[node] = self._of(node)
        return self.known[node]

    def _of(self, node: Node) -> Poly:
        kind, value = node.kind, node.value
        if kind == "number":
            return self.constant(value)
        if kind == "symbol":
            return self.number(value)
        if kind == "letter":
            return self.times(self.constant(1), self.letter(value))
        if kind in ("eye", "zeros"):
            return self.constant(int(kind == "eye"), node.shape)
        parts = [self.poly(part) for part in node.parts]
        first = parts[0]
        if kind in ("sum", "product"):
            return reduce(self.plus if kind == "sum" else self.times, parts)
        if kind == "power":
            return self.power(first, value)
        if kind in ("dot", "outer", "cross"):
            left = {"dot": self.transpose, "outer": lambda poly: poly, "cross": self.skew}[kind](first)
            return self.times(left, self.transpose(parts[1]) if kind == "outer" else parts[1])
        functions = {
            "transpose": self.transpose,
            "trace": self.trace,
            "det": self.determinant,
            "adj": self.adjugate,
            "skew": self.skew,
            "vee": self._vee,
        }
        require(kind in functions, f"{kind} is not a function of words")
        return functions[kind](first)
