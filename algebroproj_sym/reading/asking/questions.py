"""What is asked of the prover: whether two sides are equal, with all definitions put in."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import sympy
from lark import Token, Tree

from algebroproj_sym.expressions import TooLargeError, entries, over, require_bounded, shape, text
from algebroproj_sym.proving import Question
from algebroproj_sym.proving.reals.matrices import real_text
from algebroproj_sym.proving.reals.reading import term_of
from algebroproj_sym.proving.statements import has_functions
from algebroproj_sym.reading.asking.refusing import hides_an_index, of_other_letters, out_of_range
from algebroproj_sym.reading.defining.dependence import require_no_value
from algebroproj_sym.reading.defining.letters import lettered
from algebroproj_sym.reading.defining.premises import Premise, sides_of
from algebroproj_sym.reading.defining.values import Uncomputed, values_in, with_values
from algebroproj_sym.reading.defining.vocabulary import UnsizedError, Vocabulary
from algebroproj_sym.reading.deriving.components import multiplies_columns
from algebroproj_sym.reading.deriving.parities import parities
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import FUNCTIONS
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in, tokens_in, without_brackets
from algebroproj_sym.replaying.reals.terms import written

Sides = tuple[Formula, Formula]
OTHER_SHAPES = "its sides have different shapes"
A_VALUE = "it rests on a value that may belong to another case"


@dataclass(frozen=True)
class Way:
    """A way to take a link."""

    left: Formula
    right: Formula
    """Its sides."""
    vocabulary: Vocabulary
    """What its letters stand for."""
    reads: str = ""
    """How it is read otherwise than it stands."""
    under: tuple[Premise, ...] = ()
    """The equations under which it is to hold."""
    supposes: tuple[str, ...] = ()
    """What is taken to hold so: it becomes a hypothesis."""
    last: str = ""
    """The letter up to which it holds, if it goes from each whole number to the next one."""
    doubt: str = A_VALUE
    """Why it may not be meant if it fails so; empty if it is a contradiction then."""

    @property
    def sides(self) -> Sides:
        """Both sides."""
        return self.left, self.right

    @property
    def is_as_it_stands(self) -> bool:
        """Whether the link is asked as it stands, and under no equations."""
        return not self.reads and not self.under

    @property
    def given(self) -> list[Formula]:
        """The sides of the equations under which it is to hold."""
        return sides_of(self.under)

    @property
    def rests_on(self) -> tuple[str, ...]:
        """The places and words on which it rests."""
        rests = rests_of(self.vocabulary, *self.sides, *self.given)
        return tuple(dict.fromkeys((*rests, *(each.where for each in self.under))))


def rests_of(vocabulary: Vocabulary, *trees: Formula) -> tuple[str, ...]:
    """Return the places and words on which formulas rest."""
    return tuple(dict.fromkeys(each.where for each in vocabulary.used_in(*trees)))


def questions_of(vocabulary: Vocabulary, left: Formula, right: Formula, *, by_entries: bool = False) -> list[Question]:
    """Return the question whether two sides are equal; of matrices with real functions, one for each entry.

    Where a sign is ± or ∓, both statements are asked.  It raises `UnreadableError` if a side is no expression, or their
    shapes differ.
    """
    if any(_has_two_signs(tree) for tree in (left, right)):
        both = [[_with_signs(tree, upper) for tree in (left, right)] for upper in (True, False)]
        return [one for sides in both for one in questions_of(vocabulary, *sides, by_entries=by_entries)]
    if any(map(multiplies_columns, (left, right))):
        raise UnreadableError("two columns side by side may be a product of quaternions")
    properties = {vocabulary.properties_of(symbol) for symbol in vocabulary.letters_of(left, right)}
    if properties - {(), ("identity",)}:
        raise UnsizedError("a property of a letter, such as being a rotation, does not show in its entries")
    for part in (big for tree in vocabulary.with_used(left, right) for big in tree.find_data("big")):
        require_no_value(str(part.children[0]), symbols_in(part), vocabulary.definitions)
    values = [vocabulary.value(tree) for tree in (left, right)]
    shapes = [shape(value) for value in values]
    turned = any(tree.data == "marked" and tree.children[1] == "T" for tree in map(without_brackets, (left, right)))
    if shapes[0] != shapes[1]:
        for place, other in ((0, 1), (1, 0)):
            if values[place] == 0 and shapes[other]:
                values[place] = values[other].zeros(*values[other].shape)
            elif (
                shapes[place]
                and shapes[other]
                and not turned
                and values[place].shape == values[other].shape[::-1]
                and values[place].rows == 1
            ):
                values[place] = values[place].T
    if shape(values[0]) != shape(values[1]):
        ours, theirs = (each or "a number" for each in shapes)
        raise UnreadableError(f"{OTHER_SHAPES}: {ours} and {theirs}")
    for value in values:
        require_bounded(value, "the equation")
        if value.has(sympy.zoo, sympy.nan, sympy.oo, -sympy.oo):
            raise UnreadableError("a value is not a number")
    pairs = [*zip(*map(entries, values), strict=True)]
    below: tuple[str, ...] = ()
    if vocabulary.parities:
        wholes = [sympy.Symbol(vocabulary.name(each)) for each in vocabulary.parities]
        below = tuple(
            sorted({text(each.args[1]) for value in values for each in value.atoms(over) if each.args[1].free_symbols})
        )
        pairs = [one for pair in pairs for one in parities(pair, wholes)]
    if vocabulary.numbers != "real":
        return [replace(_of_complex(vocabulary, *pair), nonzero=below) for pair in pairs]
    if any(value.has(sympy.I) for value in values):
        raise UnreadableError("a value is not a real number")
    is_elementary = any(map(has_functions, values))
    if is_elementary and (found := complex_letters_in(vocabulary, left, right)):
        raise UnreadableError(
            f"{min(map(vocabulary.name, found))} may be complex, but functions are computed for real numbers only"
        )
    if is_elementary and (name := _assumed_real(vocabulary, values)):
        raise UnreadableError(f"{name} may be complex or a vector, because its absolute value is taken")
    if (shape(values[0]) and (is_elementary or by_entries)) or vocabulary.parities:
        return [Question(_text(one), _text(other), nonzero=below) for one, other in pairs]
    return [Question(_text(values[0]), _text(values[1]))]


def complex_letters_in(vocabulary: Vocabulary, *trees: Formula) -> frozenset[str]:
    """Return the letters of formulas that may be complex, or the imaginary unit."""
    symbols = vocabulary.letters_of(*trees).union(*map(symbols_in, trees))
    return vocabulary.complex_letters(symbols)


def _assumed_real(vocabulary: Vocabulary, values: Sequence[Any]) -> str:
    """Return a letter within an absolute value, and outside of it or in another one, that no words call real.

    Nobody writes ``|x|^2`` of a real number, and ``|x|^2 = x^2`` holds of no other one.  Functions are of real ones.
    """
    moduli = frozenset().union(*(value.atoms(sympy.Abs) for value in values))
    inside = (each.args[0].replace(_has_real_argument, lambda _: sympy.Integer(1)) for each in moduli)
    measured = {each if each.could_extract_minus_sign() else -each for each in inside}
    others = [value.xreplace(dict.fromkeys(moduli, sympy.Integer(1))) for value in values]
    seen = [*(each.free_symbols for each in measured), frozenset().union(*(each.free_symbols for each in others))]
    twice = {symbol for symbol in frozenset().union(*seen[:-1]) if sum(symbol in each for each in seen) > 1}
    sums = any(each.is_Add for each in measured)
    twice &= frozenset().union(*seen) if sums else seen[-1]
    return min((each.name for each in twice if vocabulary.symbol_of(each.name) not in vocabulary.reals), default="")


def _has_real_argument(part: Any) -> bool:
    return bool(part.is_Function or (part.is_Pow and part.exp.free_symbols))


def _of_complex(vocabulary: Vocabulary, left: Any, right: Any) -> Question:
    """Return the question whether two complex numbers are equal."""
    left, right = (each.replace(_is_exponential, lambda power: sympy.exp(power.exp)) for each in (left, right))
    names = {symbol.name for value in (left, right) for symbol in value.free_symbols}
    if "I" in names or any(value.atoms(type(sympy.E)) for value in (left, right)):
        raise UnreadableError("a letter in it looks like the number e or i")
    if vocabulary.numbers == "some complex":
        plain = {name for name in names if not values_in(name)}
        some = vocabulary.complex_letters(map(vocabulary.symbol_of, plain))
        names = names - plain | {*map(vocabulary.name, some)}
    return Question(text(left), text(right), complex=tuple(sorted(names)))


def _is_exponential(value: Any) -> bool:
    return bool(value.is_Pow and value.base == sympy.E)


def _has_two_signs(tree: Formula) -> bool:
    return not {"±", "∓"}.isdisjoint(tokens_in(tree))


def _with_signs(tree: Formula, upper: bool) -> Formula:
    """Return a formula with the upper signs of ± and ∓, or with the lower ones."""
    signs = {"±": "-+"[upper], "∓": "+-"[upper]}
    parts = [
        _with_signs(each, upper) if isinstance(each, Tree) else Token("SIGN", signs[each]) if each in signs else each
        for each in tree.children
    ]
    return Tree(tree.data, parts)


_UNASKED = (UnreadableError, TooLargeError, ZeroDivisionError, TypeError, ValueError, RecursionError)


def asked_of(vocabulary: Vocabulary, left: Formula, right: Formula) -> list[Question] | str:
    """Return the questions, or why there are none."""
    if other := of_other_letters(vocabulary, left, right):
        return f"{vocabulary.name(other)} with other arguments may be another function"
    if refused := hides_an_index(vocabulary, left, right) or out_of_range(vocabulary, left, right):
        return refused
    try:
        return questions_of(vocabulary, left, right)
    except UnreadableError as unread:
        try:
            return _with_values(vocabulary, left, right) or lettered(vocabulary, left, right)
        except (UnreadableError, RecursionError) as error:
            return _reason_of(error if isinstance(unread, UnsizedError) else unread)
    except (TooLargeError, ZeroDivisionError, TypeError, ValueError, RecursionError) as error:
        return _reason_of(error)


def stated_by(vocabulary: Vocabulary, tree: Formula) -> tuple[Question, ...]:
    """Return what a definition says, as the question whether it equals itself; none if it is not computed."""
    questions = asked_of(vocabulary, tree, tree)
    if isinstance(questions, str):
        return ()
    if (
        len(questions) == 1
        or _has_two_signs(tree)
        or questions[0].complex is not None
        or questions[0].letters is not None
    ):
        return tuple(questions)
    try:
        whole = real_text(vocabulary.value(tree), "the definition")
    except _UNASKED:
        return ()
    return (Question(whole, whole),)


def _reason_of(error: Exception) -> str:
    """Return the first line of a message."""
    if isinstance(error, RecursionError):
        return "a letter in it is defined by itself, or its formula is nested too deeply"
    return str(error).partition("\n")[0][:200] or type(error).__name__


def _with_values(vocabulary: Vocabulary, left: Formula, right: Formula) -> list[Question]:
    """Return the questions in which sums, integrals and values of functions are letters; none if there are vectors."""
    try:
        return questions_of(with_values(vocabulary), left, right)
    except _UNASKED:
        return []


def asked_under(way: Way) -> list[Question] | str:
    """Return the questions of a way, with the equations under which it is to hold as constraints."""
    if not way.under:
        return asked_of(way.vocabulary, *way.sides)
    every = (*way.sides, *way.given)
    if refused := out_of_range(way.vocabulary, *every) or hides_an_index(way.vocabulary, *every):
        return refused
    plain = way.vocabulary
    kept = (*FUNCTIONS, "root")
    together, apart = with_values(plain, kept), with_values(plain, kept, apart=True)
    for known in (plain, with_values(plain), together, apart):
        with suppress(*_UNASKED):
            questions = questions_of(known, *way.sides, by_entries=True)
            conditions = [one for each in way.under for one in questions_of(known, *each.sides, by_entries=True)]
            if all(map(_is_rational, [*questions, *conditions])):
                if (
                    known is together
                    and isinstance(known.uncomputed, Uncomputed)
                    and known.uncomputed.has_angles_of_sums
                ):
                    continue
                ties = known.uncomputed.ties() if isinstance(known.uncomputed, Uncomputed) else []
                constraints = (*(f"{one.lhs} = {one.rhs}" for one in conditions), *ties)
                return [replace(question, constraints=constraints) for question in questions]
    with suppress(*_UNASKED):
        if any(map(way.vocabulary.is_matrix, way.vocabulary.letters_of(way.left))):
            return lettered(way.vocabulary, *way.sides, [each.sides for each in way.under])
    return "the equations above it are neither rational nor about vectors"


def _is_rational(question: Question) -> bool:
    is_number = not (question.lhs.startswith("[") or question.rhs.startswith("["))
    return question.letters is None and is_number and not (has_functions(question.lhs) or has_functions(question.rhs))


def is_lettered(way: Way) -> bool:
    """Whether a relation is asked with vectors and matrices as letters."""
    questions = asked_of(way.vocabulary, *way.sides)
    return isinstance(questions, list) and questions[0].letters is not None


def has_letters(way: Way) -> bool:
    """Whether a relation is asked with letters for vectors, matrices, or values that are not computed."""
    questions = asked_of(way.vocabulary, *way.sides)
    return isinstance(questions, list) and (questions[0].letters is not None or bool(values_of(questions)))


def values_of(questions: Sequence[Question]) -> set[str]:
    """Return the kinds of values in questions that are not computed."""
    return {kind for each in questions for _, written in each.named_texts for kind in values_in(written)}


def _text(value: Any) -> str:
    """Return text in which no number looks like a letter: exp(1) is no E."""
    return written(term_of(value, "the equation")) if value.atoms(type(sympy.E)) else text(value)
