"""Noncommutative polynomials: sums of numbers times words, which hold for every size.

A word is a product of atoms: letters, their transposes, inverses of sums, cross-product matrices, adjugates.  A part of
a word that is a number, such as ``n.T*A*n``, is taken out of it: numbers commute.  So are traces and determinants.
What is equal by the laws of rings, by transposing, and by what letters are declared to be, has one form.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from itertools import pairwise
from typing import Any, NamedTuple, TypeAlias

from algebroproj_sym.expressions.letters import ONE, Shape, Size, Term, made, number
from algebroproj_sym.proving.buchberger import Work
from algebroproj_sym.proving.letters.properties import Letter

MOST_TERMS = 3_000
MOST_PRODUCTS = 20_000
LONG = 10


class NotWordsError(ValueError):
    """A statement is not one about words: it needs entries."""


class Atom(NamedTuple):
    """A factor of a word.

    The key of a ``letter`` is its name; of an ``inverse`` and of an ``adj`` the polynomial; of a ``skew`` the word.
    """

    kind: str
    key: object
    transposed: bool
    rows: Size
    columns: Size


Word: TypeAlias = tuple[Atom, ...]


class Scalar(NamedTuple):
    """A number that is not further known.

    Its key is a name (``symbol``), a word (``form``, ``trace``) or a polynomial (``det``, ``reciprocal``).
    """

    kind: str
    key: object


Monomial: TypeAlias = tuple[tuple[Scalar, ...], Word]


@dataclass(frozen=True)
class Poly:
    """A matrix, or a number, as a sum of coefficients times numbers times words."""

    shape: Shape
    terms: Mapping[Monomial, Fraction]

    @property
    def key(self) -> tuple[object, ...]:
        """The shape and the terms in order."""
        return (self.shape, tuple(sorted(self.terms.items(), key=lambda item: order(item[0]))))

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __add__(self, other: Poly) -> Poly:
        terms = dict(self.terms)
        for monomial, value in other.terms.items():
            _put(terms, monomial, value)
        if len(terms) > MOST_TERMS:
            raise NotWordsError(f"more than {MOST_TERMS} words")
        return Poly(self.shape, terms)

    def __neg__(self) -> Poly:
        return self.times(Fraction(-1))

    def __sub__(self, other: Poly) -> Poly:
        return self + -other

    def times(self, factor: Fraction) -> Poly:
        """Return a multiple."""
        return Poly(self.shape, {monomial: value * factor for monomial, value in self.terms.items()} if factor else {})


def _put(terms: dict[Monomial, Fraction], monomial: Monomial, value: Fraction) -> None:
    total = terms.get(monomial, Fraction(0)) + value
    if total:
        terms[monomial] = total
    else:
        terms.pop(monomial, None)


def constant(value: Fraction | int, shape: Shape = ONE) -> Poly:
    """Return a number times the identity."""
    return Poly(shape, {((), ()): Fraction(value)} if value else {})


def of_scalar(scalar: Scalar) -> Poly:
    """Return a number that is not further known."""
    return Poly(ONE, {((scalar,), ()): Fraction(1)})


def of_key(key: Any) -> Poly:
    """Return the polynomial of a key."""
    shape, terms = key
    return Poly(shape, dict(terms))


def weight(part: object) -> int:
    """Return the length of a monomial, an atom or a number; a determinant or adjugate of a sum is long."""
    if isinstance(part, Atom | Scalar):
        if part.kind in ("det", "adj"):
            return _long(part.kind, of_key(part.key))
        if part.kind in ("form", "trace"):
            return sum(map(weight, part.key))  # type: ignore[call-overload]
        return 1 + weight(part.key) if part.kind == "skew" else 1
    return sum(map(weight, part))  # type: ignore[call-overload]


def _long(kind: str, base: Poly) -> int:
    length = sum(map(weight, base.terms))
    if len(base.terms) == length == 1:
        (((_, word), _),) = base.terms.items()
        return LONG if kind == "adj" and any(atom.kind == "inverse" for atom in word) else 1
    return LONG * length + sum(atom.kind == "inverse" for _, word in base.terms for atom in word)


def order(monomial: Monomial) -> tuple[object, ...]:
    """Return a key by which the longer of two monomials comes later."""
    scalars, word = monomial
    return weight(scalars) + weight(word), len(word), str(word), str(scalars)


class Algebra:
    """The words in some letters.

    `is_sized` says whether something was computed that holds for the given sizes alone.  `work` is how many words may
    be multiplied, or compared, before all is given up.
    """

    def __init__(self, letters: Mapping[str, Letter]) -> None:
        self.letters = letters
        self.is_sized = False
        self.work = Work(MOST_PRODUCTS)
        self._known: dict[Term, Poly] = {}

    # -- from terms

    def poly(self, term: Term) -> Poly:
        """Return a term as a polynomial.

        It raises `NotWordsError` if a function of it is one of entries.

        Examples
        --------
        >>> from algebroproj_sym.expressions.letters import parse_letters
        >>> letters = {name: Letter(name, ("n", "n"), frozenset()) for name in "AB"}
        >>> shapes = {name: letter.shape for name, letter in letters.items()}
        >>> left, right = (parse_letters(text, shapes) for text in ("((A*B).T)**-1", "(A**-1).T*(B.T)**-1"))
        >>> algebra = Algebra(letters)
        >>> algebra.poly(left) == algebra.poly(right)
        True
        """
        if term not in self._known:
            self._known[term] = self._poly(term)
        return self._known[term]

    def _poly(self, term: Term) -> Poly:
        kind, value = term.kind, term.value
        if kind == "number":
            return constant(value)
        if kind == "symbol":
            return of_scalar(Scalar("symbol", value))
        if kind == "letter":
            self.is_sized |= term.shape == ONE
            return self.of_word(term.shape, (Atom("letter", value, False, *term.shape),))
        if kind == "eye":
            return constant(1, term.shape)
        if kind == "zeros":
            return constant(0, term.shape)
        function = _FUNCTIONS.get(kind)
        if function is None:
            raise NotWordsError(f"{kind} is a function of entries")
        return function(self, [self.poly(part) for part in term.parts], value)

    # -- canonical forms

    def of_word(self, shape: Shape, word: Word, scalars: tuple[Scalar, ...] = ()) -> Poly:
        """Return a word, from which the parts that are numbers are taken out."""
        cuts = cuts_of(word)
        sign, taken = 1, [*scalars]
        for start, end in pairwise(cuts):
            found, part = self._least([word[start:end]])
            sign *= found
            taken.append(Scalar("form", part))
        rest = word if len(cuts) < 2 else word[: cuts[0]] + word[cuts[-1] :]
        return Poly(shape, {(_ordered(taken), rest): Fraction(sign)} if sign else {})

    def _least(self, words: Iterable[Word]) -> tuple[int, Word]:
        """Return the first of some equal numbers, also transposed, with a sign; the sign 0 if they are zero."""
        forms = [(1, word) for word in words]
        forms += [(sign, word) for sign, word in (self.transposed_word(word) for _, word in forms)]
        least = min((word for _, word in forms), key=str)
        signs = {sign for sign, word in forms if word == least}
        return (signs.pop() if len(signs) == 1 else 0), least

    def transposed_word(self, word: Word) -> tuple[int, Word]:
        """Return the transpose of a word, with its sign."""
        signs, atoms = zip(*map(self._transposed, reversed(word)), strict=True) if word else ((), ())
        return (-1 if sum(sign < 0 for sign in signs) % 2 else 1), (*atoms,)

    def _transposed(self, atom: Atom) -> tuple[int, Atom]:
        if atom.kind == "letter":
            properties = self.letters[str(atom.key)].properties
            sign = 1 if "symmetric" in properties else -1 if "skew" in properties else 0
        elif atom.kind == "skew":
            sign = -1
        else:
            base = of_key(atom.key)
            sign = self._parity(base)
            if atom.kind == "adj" and sign == -1:
                sign = (-1) ** (int(atom.rows) - 1)
        other = Atom(atom.kind, atom.key, not atom.transposed, atom.columns, atom.rows)
        return (sign, atom) if sign else (1, other)

    def _parity(self, base: Poly) -> int:
        """Return 1 if a polynomial is symmetric, -1 if it is skew, else 0."""
        other = self.transposed(base)
        return 1 if other == base else -1 if other == -base else 0

    def transposed(self, poly: Poly) -> Poly:
        """Return the transpose."""
        terms: dict[Monomial, Fraction] = {}
        for (scalars, word), value in poly.terms.items():
            sign, other = self.transposed_word(word)
            _put(terms, (scalars, other), value * sign)
        return Poly((poly.shape[1], poly.shape[0]), terms)

    def product(self, left: Poly, right: Poly) -> Poly:
        """Return the product; a number may stand on either side."""
        if len(left.terms) * len(right.terms) > MOST_TERMS:
            raise NotWordsError(f"more than {MOST_TERMS} words")
        self.work.spend(len(left.terms) * len(right.terms))
        shape = (
            right.shape if left.shape == ONE else left.shape if right.shape == ONE else (left.shape[0], right.shape[1])
        )
        terms: dict[Monomial, Fraction] = {}
        for (s, word), a in left.terms.items():
            for (t, other), b in right.terms.items():
                for monomial, value in self.of_word(shape, word + other, s + t).terms.items():
                    _put(terms, monomial, value * a * b)
        return Poly(shape, terms)

    def power(self, base: Poly, exponent: int) -> Poly:
        """Return a power; a negative one is a power of the inverse."""
        if exponent < 0:
            base, exponent = self.inverse(base), -exponent
        result = constant(1, base.shape)
        for _ in range(exponent):
            result = self.product(result, base)
        return result

    def trace(self, poly: Poly) -> Poly:
        """Return the trace, in which a word is taken up to rotation and transposition."""
        total = constant(0)
        for (scalars, word), value in poly.terms.items():
            if poly.shape == ONE:
                return poly
            if not word:
                part = self.size(poly.shape[0])
            elif cuts := cuts_of(word):
                part = self.of_word(ONE, word[cuts[0] :] + word[: cuts[0]])
            else:
                sign, least = self._least(word[k:] + word[:k] for k in range(len(word)))
                part = of_scalar(Scalar("trace", least)).times(Fraction(sign))
            total = total + self.product(Poly(ONE, {(scalars, ()): value}), part)
        return total

    def size(self, size: Size) -> Poly:
        """Return a size as a number."""
        if isinstance(size, str):
            return of_scalar(Scalar("symbol", size))
        self.is_sized = True
        return constant(size)

    def determinant(self, poly: Poly) -> Poly:
        """Return the determinant: the product of those of square factors."""
        if poly.shape == ONE:
            return poly
        if not poly:
            return constant(0)
        if len(poly.terms) == 1:
            (((scalars, word), value),) = poly.terms.items()
            if all(atom.rows == atom.columns for atom in word):
                result = constant(1)
                if scalars or value != 1:
                    if not isinstance(poly.shape[0], int):
                        raise NotWordsError("the determinant of a multiple of a matrix of any size")
                    self.is_sized = True
                    result = self.power(Poly(ONE, {(scalars, ()): value}), poly.shape[0])
                parts = (of_scalar(Scalar("det", self._least_key(self.of_word(poly.shape, (atom,))))) for atom in word)
                return reduce(self.product, parts, result)
        return of_scalar(Scalar("det", self._least_key(poly)))

    def _least_key(self, poly: Poly) -> object:
        """Return the key of a matrix or of its transpose, which have one determinant.

        A skew letter has its own: written as ``det(-K)``, it would be read as a multiple of ``det(K)``.
        """
        other = self.transposed(poly)
        return poly.key if len(poly.terms) == 1 and other == -poly else min(poly.key, other.key, key=str)

    def inverse(self, poly: Poly) -> Poly:
        """Return the inverse: the product of the inverses of square factors, in reverse."""
        if not poly:
            raise ZeroDivisionError("the inverse of zero")
        if poly.shape == ONE:
            return self._reciprocal(poly)
        if len(poly.terms) == 1:
            (((scalars, word), value),) = poly.terms.items()
            if all(atom.rows == atom.columns for atom in word):
                start = self.product(self._reciprocal(Poly(ONE, {(scalars, ()): value})), constant(1, poly.shape))
                return reduce(self.product, map(self._inverse_of, reversed(word)), start)
        first = poly.key[1][0][1]  # type: ignore[index]
        return self._opaque("inverse", poly.times(1 / first)).times(1 / first)

    def _inverse_of(self, atom: Atom) -> Poly:
        shape = (atom.rows, atom.columns)
        if atom.kind == "letter" and "orthogonal" in self.letters[str(atom.key)].properties:
            return self.transposed(self.of_word(shape, (atom,)))
        if atom.kind == "inverse":
            base = of_key(atom.key)
            return self.transposed(base) if atom.transposed else base
        return self._opaque("inverse", self.of_word(shape, (atom,)))

    def _opaque(self, kind: str, poly: Poly) -> Poly:
        other = self.transposed(poly)
        if other == -poly:
            return self.of_word(poly.shape, (Atom(kind, poly.key, False, *poly.shape),))
        transposed = str(other.key) < str(poly.key)
        return self.of_word(poly.shape, (Atom(kind, (other if transposed else poly).key, transposed, *poly.shape),))

    def _reciprocal(self, poly: Poly) -> Poly:
        if len(poly.terms) == 1:
            (((scalars, _), value),) = poly.terms.items()
            parts = (self._reciprocal_of(scalar) for scalar in scalars)
            return reduce(self.product, parts, constant(1 / value))
        first = poly.key[1][0][1]  # type: ignore[index]
        return of_scalar(Scalar("reciprocal", poly.times(1 / first).key)).times(1 / first)

    def _reciprocal_of(self, scalar: Scalar) -> Poly:
        if scalar.kind == "reciprocal":
            return of_key(scalar.key)
        return of_scalar(Scalar("reciprocal", of_scalar(scalar).key))

    def adjugate(self, poly: Poly) -> Poly:
        """Return the adjugate: the product of those of square factors, in reverse; of a number, it is one."""
        if poly.shape == ONE:
            return constant(1)
        if not poly:
            if not isinstance(poly.shape[0], int):
                raise NotWordsError("the adjugate of zero, which is one for a matrix of one row")
            self.is_sized = True
            return poly
        if len(poly.terms) == 1:
            (((scalars, word), value),) = poly.terms.items()
            if len(word) != 1 and not scalars and value == 1 and all(atom.rows == atom.columns for atom in word):
                parts = (self.adjugate(self.of_word(poly.shape, (atom,))) for atom in reversed(word))
                return reduce(self.product, parts, constant(1, poly.shape))
        if self._parity(poly) == -1:
            if not isinstance(poly.shape[0], int):
                raise NotWordsError("the adjugate of a skew matrix of any size")
            self.is_sized = True
        return self._opaque("adj", poly)

    def skew(self, poly: Poly) -> Poly:
        """Return the matrix of the cross product, which is linear in the vector."""
        self.is_sized = True
        terms: dict[Monomial, Fraction] = {}
        for (scalars, word), value in poly.terms.items():
            _put(terms, (scalars, (Atom("skew", word, False, 3, 3),)), value)
        return Poly((3, 3), terms)

    def vee(self, poly: Poly) -> Poly:
        """Return the vector of a sum of cross-product matrices."""
        terms: dict[Monomial, Fraction] = {}
        for (scalars, word), value in poly.terms.items():
            if len(word) != 1 or word[0].kind != "skew":
                raise NotWordsError("vee is a function of entries")
            _put(terms, (scalars, word[0].key), value)  # type: ignore[arg-type]
        return Poly((3, 1), terms)

    # -- to terms

    def term(self, poly: Poly) -> Term:
        """Return a polynomial as a term."""
        ordered = sorted(poly.terms.items(), key=lambda item: order(item[0]))
        parts = [self._monomial(monomial, value, poly.shape) for monomial, value in ordered]
        if not parts:
            return made("zeros", value=poly.shape) if poly.shape != ONE else number(0)
        return parts[0] if len(parts) == 1 else made("sum", *parts)

    def _monomial(self, monomial: Monomial, value: Fraction, shape: Shape) -> Term:
        scalars, word = monomial
        factors = [number(value)] if value != 1 else []
        factors += [self._scalar(scalar) for scalar in scalars]
        factors += [self._atom(atom) for atom in word]
        if not word and shape != ONE:
            factors.append(made("eye", value=shape[:1]))
        return factors[0] if len(factors) == 1 else made("product", *factors) if factors else number(1)

    def _scalar(self, scalar: Scalar) -> Term:
        if scalar.kind == "symbol":
            return Term("symbol", ONE, (), scalar.key)
        if scalar.kind == "form":
            return self.term(self._plain(ONE, scalar.key))
        if scalar.kind == "trace":
            word: Word = scalar.key  # type: ignore[assignment]
            return made("trace", self.term(self._plain((word[0].rows, word[-1].columns), word)))
        base = self.term(of_key(scalar.key))
        return made("det", base) if scalar.kind == "det" else made("power", base, value=-1)

    def _plain(self, shape: Shape, word: object) -> Poly:
        return Poly(shape, {((), word): Fraction(1)})  # type: ignore[dict-item]

    def _atom(self, atom: Atom) -> Term:
        if atom.kind == "letter":
            term = self.letters[str(atom.key)].term
        elif atom.kind == "skew":
            return made("skew", self.term(self._plain((3, 1), atom.key)))
        elif atom.kind == "inverse":
            term = made("power", self.term(of_key(atom.key)), value=-1)
        else:
            term = made("adj", self.term(of_key(atom.key)))
        return made("transpose", term) if atom.transposed else term


def _ordered(scalars: Iterable[Scalar]) -> tuple[Scalar, ...]:
    return tuple(sorted(scalars, key=str))


def cuts_of(word: Word) -> list[int]:
    """Return the places in a word, its ends included, where the size is 1."""
    return [k for k, atom in enumerate(word) if atom.rows == 1] + (
        [len(word)] if word and word[-1].columns == 1 else []
    )


def atoms_of(poly: Poly) -> Iterator[Atom | Scalar]:
    """Yield atoms and numbers of a polynomial, and those within them."""
    for scalars, word in poly.terms:
        parts: list[Atom | Scalar] = [*scalars, *word]
        for part in parts:
            yield part
            yield from _within(part)


def _within(part: Atom | Scalar) -> Iterator[Atom | Scalar]:
    if part.kind in ("inverse", "adj", "det", "reciprocal"):
        yield from atoms_of(of_key(part.key))
    elif part.kind in ("form", "trace", "skew"):
        for atom in part.key:  # type: ignore[attr-defined]
            yield atom
            yield from _within(atom)


def _sum(algebra: Algebra, parts: list[Poly], value: object) -> Poly:
    return reduce(Poly.__add__, parts)


_FUNCTIONS: Mapping[str, Callable[[Algebra, list[Poly], object], Poly]] = {
    "sum": _sum,
    "product": lambda algebra, parts, value: reduce(algebra.product, parts),
    "power": lambda algebra, parts, value: algebra.power(parts[0], value),  # type: ignore[arg-type]
    "transpose": lambda algebra, parts, value: algebra.transposed(parts[0]),
    "trace": lambda algebra, parts, value: algebra.trace(parts[0]),
    "det": lambda algebra, parts, value: algebra.determinant(parts[0]),
    "adj": lambda algebra, parts, value: algebra.adjugate(parts[0]),
    "dot": lambda algebra, parts, value: algebra.product(algebra.transposed(parts[0]), parts[1]),
    "outer": lambda algebra, parts, value: algebra.product(parts[0], algebra.transposed(parts[1])),
    "skew": lambda algebra, parts, value: algebra.skew(parts[0]),
    "cross": lambda algebra, parts, value: algebra.product(algebra.skew(parts[0]), parts[1]),
    "vee": lambda algebra, parts, value: algebra.vee(parts[0]),
}
