"""Whether the sides of a relation agree where letters are numbers: a sieve before the prover is asked."""

from cmath import isnan
from collections.abc import Iterable, Mapping
from contextlib import suppress
from fractions import Fraction
from itertools import count
from typing import Any

import sympy
from lark import Tree

from algebroproj_sym.expressions import NotRationalError, entries, evaluate, over, shape
from algebroproj_sym.expressions.bounds import MAX_BITS
from algebroproj_sym.proving import Question
from algebroproj_sym.proving.letters import prove_texts
from algebroproj_sym.proving.proof import UndefinedError
from algebroproj_sym.reading.asking.questions import Sides, asked_of
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.defining.vocabulary import MOST_PARTS, Vocabulary
from algebroproj_sym.reading.deriving.rates import TWO
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import evaluated, evaluator
from algebroproj_sym.reading.parsing.grammar import Formula, put_in

POINTS = (Fraction(3, 2), Fraction(-5, 3), Fraction(7, 5), Fraction(11, 4), Fraction(-13, 7))
_UNDEFINED = (UnreadableError, ZeroDivisionError, TypeError, ValueError, AttributeError, OverflowError, RecursionError)
_NEARLY = 1e-9


class Sample:
    """A point at which formulas are evaluated; the seed says where.  What several of them share is evaluated once."""

    def __init__(self, vocabulary: Vocabulary, seed: int) -> None:
        self._vocabulary = vocabulary
        self._numbers: dict[Any, Any] = {}
        self._others = (POINTS[(seed + place) % len(POINTS)] + place for place in count())
        self._known: dict[str, Any] = {}
        self._value = evaluator(self._names)
        self._values: dict[int, tuple[Formula, tuple[Any, ...] | None]] = {}
        self._parts = 0

    def agrees(self, sides: Sides) -> bool | None:
        """Whether two sides have one value; None if one of them has none."""
        if any(self._values.get(id(side), (side, ()))[1] is None for side in sides):
            return None
        left, right = map(self.at, sides)
        if left is None or right is None or len(left) != len(right):
            return None
        with suppress(OverflowError):
            return all(_are_near(a, b) for a, b in zip(left, right, strict=True))
        return None

    def at(self, tree: Formula) -> tuple[Any, ...] | None:
        """Return the entries of a formula; None if it has no value."""
        if id(tree) not in self._values:
            self._parts = 0
            try:
                self._values[id(tree)] = tree, _numbers(self._value(tree))
            except _UNDEFINED:
                self._values[id(tree)] = tree, None
        return self._values[id(tree)][1]

    def _names(self, symbol: str) -> Any:
        if symbol not in self._known:
            definition = self._vocabulary.definitions.get(symbol)
            if definition is None or not definition.usable:
                self._known[symbol] = self._number(self._vocabulary.plain(symbol))
            elif definition.parameters:
                self._known[symbol] = self._function(definition)
            else:
                changing = _has_slope(definition)
                value = self._vocabulary.value if changing else self._value
                self._known[symbol] = _as_number(_bounded(self._number(value(definition.tree))))
        return self._known[symbol]

    def _number(self, letters: Any) -> Any:
        for each in sorted((one for entry in entries(letters) for one in entry.free_symbols), key=str):
            if each not in self._numbers:
                self._numbers[each] = _rational(next(self._others))
        return letters.xreplace(self._numbers if _is_rational(letters) else _nearly(self._numbers))

    def _function(self, definition: Definition) -> Any:
        changing = _has_slope(definition)

        def function(*arguments: Any) -> Any:
            self._parts += sum(1 for _ in definition.tree.iter_subtrees())
            if self._parts > MOST_PARTS:
                raise UnreadableError("the formula is too large with all definitions put in")
            own = dict(zip(definition.parameters, arguments, strict=True))
            letters = {each: sympy.Dummy(each) for each in own} if changing else own
            found = evaluated(
                definition.tree, lambda symbol: letters[symbol] if symbol in letters else self._names(symbol)
            )
            return _as_number(
                _bounded(found.xreplace({letters[each]: own[each] for each in own}) if changing else found)
            )

        return function


def _has_slope(definition: Definition) -> bool:
    return any(True for _ in definition.tree.find_data("slope"))


def _bounded(value: Any) -> Any:
    """Return a value, unless its numbers are larger than those that are computed with."""
    numbers = (number for entry in entries(value) for number in entry.atoms(sympy.Rational))
    if any(max(int(each.p).bit_length(), int(each.q).bit_length()) > MAX_BITS for each in numbers):
        raise UnreadableError(f"expected numbers of at most {MAX_BITS} bits")
    return value


def _is_rational(value: Any) -> bool:
    """Whether an expression is made of rational numbers and letters by rational operations."""
    parts = {each.func for entry in entries(value) for each in sympy.preorder_traversal(entry)}
    powers = (power.exp for entry in entries(value) for power in entry.atoms(sympy.Pow))
    known = all(issubclass(each, _RATIONAL) for each in parts)
    return known and all(isinstance(each, sympy.Integer) for each in powers)


_RATIONAL = (sympy.Symbol, sympy.Rational, sympy.Add, sympy.Mul, sympy.Pow, over)
_DIGITS = 30
"""With how many digits numbers are computed that are not rational."""


def _nearly(numbers: Mapping[Any, Any]) -> dict[Any, Any]:
    return {each: sympy.Float(value, _DIGITS) for each, value in numbers.items()}


def _as_number(value: Any) -> Any:
    """Return a value without letters as a rational number, or as one with some digits: it goes into others."""
    if _is_rational(value):
        return value
    return value.applyfunc(_with_digits) if shape(value) else _with_digits(value)


def _with_digits(number: Any) -> Any:
    return sympy.N(number.doit(), _DIGITS)


def _rational(value: Fraction) -> Any:
    return sympy.Rational(value.numerator, value.denominator)


def _numbers(value: Any) -> tuple[Any, ...]:
    """Return the entries of an expression without letters: exact ones, or else nearly."""
    try:
        return evaluate(value, {})
    except NotRationalError:
        found = tuple(complex(entry) for entry in entries(value.doit()))
    if any(map(isnan, found)):
        raise ZeroDivisionError("a value is not a number")
    return found


def _are_near(left: Any, right: Any) -> bool:
    if isinstance(left, Fraction) and isinstance(right, Fraction):
        return left == right
    return abs(complex(left) - complex(right)) <= _NEARLY * (1 + abs(complex(left)))


def samples_of(vocabulary: Vocabulary, *trees: Formula) -> list[Sample]:
    """Return some points at which formulas have values."""
    samples = (Sample(vocabulary, seed) for seed in range(len(POINTS)))
    return [each for each in samples if all(each.at(tree) is not None for tree in trees)]


def is_somewhere_positive(vocabulary: Vocabulary, number: Formula) -> bool:
    """Whether a number is seen to be real and not negative at some point."""
    values = (complex(value) for each in samples_of(vocabulary, number) for value in each.at(number) or ())
    return any(value.imag == 0 <= value.real for value in values)


def have_one_sign(vocabulary: Vocabulary, sides: Sides) -> bool | None:
    """Whether two sides are seen to be real, and of one sign, at some point; None if none has values.

    A length is the square of a letter: it is never negative.
    """
    lengths = [norm for side in sides for norm in side.find_data("norm")]
    letters = (letter_of(rf"\bullet_{{{place}}}") for place in count())
    squares = {each: Tree("power", [letter, TWO]) for each, letter in zip(lengths, letters, strict=False)}
    left, right = (put_in(side, squares) for side in sides)
    samples = samples_of(vocabulary, left, right)
    values = ([complex(entry) for side in (left, right) for entry in each.at(side) or ()] for each in samples)
    pairs = (each for each in values if len(each) == 2)
    return any(a.imag == 0 == b.imag and a.real * b.real >= 0 for a, b in pairs) if samples else None


def are_one_matrix(vocabulary: Vocabulary, sides: Sides) -> bool:
    """Whether two sides with vectors and matrices as letters are seen to be one."""
    for known in (vocabulary, vocabulary.with_identity(*sides)):
        asked = asked_of(known, *sides) if known is not None else ""
        with suppress(*_UNDEFINED, UndefinedError):
            if isinstance(asked, list) and all(_is_proved(each) for each in asked):
                return True
    return False


def _is_proved(question: Question) -> bool:
    return question.letters is not None and (
        prove_texts(question.lhs, question.rhs, question.letters, constraints=question.constraints).verdict == "proved"
    )


def agree(samples: Iterable[Sample], sides: Sides) -> bool:
    """Whether two sides agree wherever they are defined at some points, and are so somewhere."""
    defined = False
    for each in samples:
        found = each.agrees(sides)
        if found is False:
            return False
        defined = defined or found is True
    return defined
