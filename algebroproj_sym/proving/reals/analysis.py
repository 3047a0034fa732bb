"""Signs of functions of one variable on a range: by where they rise and fall, or by values on small pieces.

Values at points only guide the search; what counts are the steps that the theory of the replay takes.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import ceil, floor, log, pi
from typing import Any

import flint

from algebroproj_sym.expressions.exact import fmpq, fraction
from algebroproj_sym.proving.reals.balls import Balls
from algebroproj_sym.proving.reals.forms import carried, leading, multiplied, simplest, without_numbers
from algebroproj_sym.proving.reals.knowledge import Knowledge
from algebroproj_sym.proving.reals.samples import Sample, samples_at
from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.reals.definitions import Condition, conditions, derivative, kinds, replaced
from algebroproj_sym.replaying.reals.proofs import MOST_PIECES, between, is_positive
from algebroproj_sym.replaying.reals.terms import Term, negative, over, read, written
from algebroproj_sym.replaying.reals.theory import Theory
from algebroproj_sym.replaying.reals.values import UndecidedError, UndefinedError, value_of
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected

DEEPEST = 5
MOST_TERMS = 40
EFFORT = 10
BITS = 64
PRECISION = 160
NEARLY_ZERO = 1e-25
MOST_HALVINGS = 9
GRAIN = 2**20
SIMPLE = 24
HALVINGS = 60
PARTS = (1, 4, 10, 20, 32, 45, 55, 68, 80, 90, 96, 99)
AWAY = [Fraction(p, 100) for p in (1, 10, 25, 50, 75, 100, 130, 160, 200, 250, 300, 400, 500, 700, 1000, 1500, 3000)]

Nested = Callable[[Theory, Sequence[Condition], Sequence[Sample], list[int]], "dict[str, Any] | None"]

Equal = Callable[[Knowledge, Element, Element], bool]


@dataclass(frozen=True)
class Bound:
    """An end of a range: its text, about where it is, and the condition that holds there."""

    text: str
    value: Fraction
    condition: str


@dataclass(frozen=True)
class Range:
    """The numbers that a variable may be, without others."""

    name: str
    low: Bound | None
    high: Bound | None

    def given(self) -> list[str]:
        """Return the range as conditions."""
        return [bound.condition for bound in (self.low, self.high) if bound]

    def points(self) -> list[Fraction]:
        """Return points inside, in order."""
        if self.low and self.high:
            size = self.high.value - self.low.value
            found = [self.low.value + size * Fraction(part, 100) for part in PARTS]
            grain = ceil(200 / size)
            return [Fraction(round(point * grain), grain) for point in found]
        if self.low:
            return [self.low.value + step for step in AWAY]
        if self.high:
            return [self.high.value - step for step in AWAY[::-1]]
        return [-step for step in AWAY[::-1]] + AWAY


@dataclass(frozen=True)
class Rise:
    """A function of a variable, from where it is said to rise, or fall on the other side, and what is given there."""

    name: str
    whole: Term
    start: str
    given: list[str]


class Analysis:
    """A search for the signs of functions of one variable, after some derivatives were taken.

    `nested` proves relations of terms in a theory of their own, and `equal` shows that two elements are equal.
    """

    def __init__(self, nested: Nested, equal: Equal, knowledge: Knowledge, level: int) -> None:
        self.nested, self.equal, self.knowledge, self.level = nested, equal, knowledge, level

    def related(self, relation: str, goal: Element) -> bool:
        """Show a relation of an element to zero by the signs of its factors."""
        if self.level >= DEEPEST:
            return False
        if relation == "!=":
            return any(self.related(">", side) for side in (goal, -goal) if -1 not in self.knowledge.seen(side))
        polynomial = self.knowledge.signed(goal)
        if polynomial == 0 or len(polynomial) > MOST_TERMS:
            return False
        form, cofactors = simplest(self.knowledge, polynomial)
        for factor, power in form.factor()[1]:
            element = self.knowledge.back(factor)
            if power % 2 == 0 and relation == ">=":
                continue
            sign = self.knowledge.sign(element)
            if sign == "=" or (sign is not None and (relation == ">=" or sign in "<>")):
                continue
            if not self._signed(element, relation == ">"):
                return False
        strict = relation == ">"
        return carried(self.knowledge, polynomial, form, cofactors, strict) and self.knowledge.positive(goal, strict)

    def _signed(self, element: Element, strict: bool) -> bool:
        """Show that a function of one variable has one sign, which may be zero if that is not asked for."""
        whole = read(spelled(self.knowledge.theory, self.knowledge.theory.text(element)))
        if not whole.symbols() or kinds(whole) & {"sign", "atan2"}:
            return False
        if len(whole.symbols()) > 1:
            self.knowledge.spend(EFFORT)
            if -1 in self.knowledge.seen(element):
                element, whole = -element, negative(whole)
            return self._risen_from_others(element, whole, strict)
        (name,) = whole.symbols()
        scope = self._range(name)
        if scope is None:
            return False
        function = Function(self, whole, element, scope, strict)
        points = scope.points()
        if function.sign_at(points[len(points) // 2]) == -1:
            function = Function(self, negative(whole), -element, scope, strict)
        return function.is_shown()

    def risen(self, element: Element, rise: Rise, samples: Sequence[Sample], strict: bool) -> bool:
        """Show the sign of a function by that at a start, and that of the derivative from there."""
        knowledge = self.knowledge
        text = written(replaced(rise.whole, rise.name, read(rise.start)))
        if not knowledge.step("defined", term=text):
            return False
        beginning = knowledge.theory.read(text)
        if not self._is_shown_there(beginning):
            return False
        step = {
            "variable": rise.name,
            "function": written(rise.whole),
            "from": rise.start,
            "given": rise.given,
            "relation": ">" if strict and not knowledge.theory.holds(">", beginning) else ">=",
        }
        try:
            inner, (*needed, last) = between(knowledge.theory, step)
        except (Rejected, NotReplayable):
            return False
        proof = self.nested(inner, [*needed, *conditions(last[1]), last], samples, knowledge.effort)
        return (
            proof is not None
            and knowledge.step("mean value", **step, proof=proof)
            and (not element.exponents or without_numbers(knowledge, element - beginning))
            and self._added(element, strict, element - beginning, beginning)
        )

    def _risen_from_others(self, element: Element, whole: Term, strict: bool) -> bool:
        """Show the sign of a function of several variables that is zero where two sides of an assumption are equal."""
        knowledge, theory = self.knowledge, self.knowledge.theory
        places = {theory.field.places[name]: name for name in theory.symbols()}
        facts = [fact for _, fact in knowledge.facts(">", ">=") if knowledge.names(fact) <= places.keys()]
        for fact in facts:
            for place in sorted(knowledge.names(fact)) if len(knowledge.names(fact)) > 1 else ():
                slope = fact.derivative(place)
                if not slope.is_constant() or int(fact.degrees()[place]) != 1:
                    continue
                end = (slope * fact.context().gens()[place] - fact) / slope.leading_coefficient()
                others = [fact, *(other for other in facts if place not in knowledge.names(other))]
                given = [self._said(other) for other in others]
                rise = Rise(places[place], whole, theory.text(knowledge.back(end)), given)
                if self.risen(element, rise, (), strict):
                    return True
        return False

    def _said(self, fact: Any) -> str:
        element = self.knowledge.back(fact)
        relation = ">" if self.knowledge.theory.holds(">", element) else ">="
        return f"{self.knowledge.theory.text(element)} {relation} 0"

    def _is_shown_there(self, value: Element) -> bool:
        """Show that a number is positive or zero."""
        theory = self.knowledge.theory
        if value.is_zero or theory.holds(">", value) or self.knowledge.value(value):
            return True
        return self.equal(self.knowledge, value, theory.number(0))

    def _added(self, whole: Element, strict_asked: bool, *parts: Element) -> bool:
        """Show the sign as that of a sum of parts whose signs are known."""
        knowledge, theory = self.knowledge, self.knowledge.theory
        total, cofactors, one = list[Any](), dict[int, Any](), knowledge.context.constant(1)
        for part in parts:
            weight = Fraction(part.numerator.content() or 0, part.denominator)
            if part.is_zero:
                continue
            if part.exponents:
                return knowledge.positive(whole, strict_asked)
            if part.numerator.is_constant():
                total.append((weight, one, {}))
                continue
            relation = next(relation for relation in ("=", ">", ">=") if theory.holds(relation, part))
            fact = theory.fact(relation, part)
            if fact not in theory.known:
                return knowledge.positive(whole, strict_asked)
            place = theory.facts.index(fact)
            if relation == "=":
                cofactors[place] = one * fmpq(weight)
            else:
                total.append((abs(weight), one, {place: 1}))
        return knowledge.has_sign(theory.text(whole), total, cofactors) and knowledge.positive(whole, strict_asked)

    def _range(self, name: str) -> Range | None:
        """Return the range of a variable that facts give; None if it is empty."""
        knowledge, theory = self.knowledge, self.knowledge.theory
        place = theory.field.places[name]
        for root in [*self._roots(place)]:
            side = theory.variable(name) - theory.number(root)
            for each in (side, -side):
                if -1 not in knowledge.seen(each):
                    knowledge.positive(each, True)
        low: Bound | None = None
        high: Bound | None = None
        for _, fact in knowledge.facts(">", ">="):
            if place not in knowledge.names(fact) or int(fact.degrees()[place]) != 1:
                continue
            slope = fact.derivative(place)
            rest = fact - slope * knowledge.context.gens()[place]
            if not slope.is_constant() or not knowledge.is_number(rest):
                continue
            end = knowledge.back(rest / slope.leading_coefficient() * -1)
            value = rational(theory.value(end, BITS))
            relation = ">" if theory.holds(">", knowledge.back(fact)) else ">="
            text = spelled(theory, theory.text(end))
            below = slope.leading_coefficient() > 0
            found = Bound(text, value, f"{name} {relation if below else relation.replace('>', '<')} {text}")
            if below and (low is None or (value, relation == ">") > (low.value, "=" not in low.condition)):
                low = found
            elif not below and (high is None or (-value, relation == ">") > (-high.value, "=" not in high.condition)):
                high = found
        return None if low and high and low.value >= high.value else Range(name, low, high)

    def _roots(self, place: int) -> Iterator[Fraction]:
        """Yield the rational ends of ranges that facts of higher degree may give."""
        for _, fact in self.knowledge.facts(">", ">="):
            if self.knowledge.names(fact) == {place} and 1 < int(fact.degrees()[place]) <= 4:
                for factor, _ in fact.factor()[1]:
                    if int(factor.degrees()[place]) == 1:
                        slope = factor.derivative(place)
                        root = (factor - slope * self.knowledge.context.gens()[place]) / slope.leading_coefficient()
                        yield -fraction(root.leading_coefficient()) if root != 0 else Fraction(0)


class Function:
    """A function of one variable on a range, where it is said to be positive, or not negative."""

    def __init__(self, analysis: Analysis, whole: Term, element: Element, scope: Range, strict: bool) -> None:
        self.analysis, self.knowledge = analysis, analysis.knowledge
        self.whole, self.element, self.scope, self.strict = whole, element, scope, strict
        self.slope = derivative(whole, scope.name)

    def is_shown(self) -> bool:
        """Look for the proof; note where to cut the range if that would help."""
        self.knowledge.spend(EFFORT)
        points = self.scope.points()
        if -1 in [self._sign(self.whole, point) for point in points]:
            return False
        slopes = [(point, self._sign(self.slope, point)) for point in points]
        signs = {sign for _, sign in slopes}
        if None in signs:
            return False
        if self._divided():
            return True
        if -1 not in signs and self._from(self.scope.low):
            return True
        if 1 not in signs and self._from(self.scope.high):
            return True
        if self._on_a_range():
            return True
        changes = [(one, other) for one, other in pairwise([pair for pair in slopes if pair[1]]) if one[1] != other[1]]
        if changes:
            self._cut(changes)
        elif self.strict:
            self._note(str(points[len(points) // 2]))
        return False

    def sign_at(self, point: Fraction) -> int | None:
        """Return about the sign at a point."""
        return self._sign(self.whole, point)

    def _sign(self, term: Term, point: Fraction | Term) -> int | None:
        """Return the sign of a value; 0 also for what is close to zero, None where it is not defined."""
        if isinstance(point, Term):
            term, point = replaced(term, self.scope.name, point), Fraction(0)
        kept, flint.ctx.prec = flint.ctx.prec, PRECISION
        try:
            value = value_of(term, {self.scope.name: point}, Balls())
            size = float(value if isinstance(value, Fraction) else value.mid())
        except (UndecidedError, UndefinedError, OverflowError):
            return None
        finally:
            flint.ctx.prec = kept
        return 0 if abs(size) < NEARLY_ZERO else 1 if size > 0 else -1

    def _from(self, start: Bound | None) -> bool:
        """Show the sign by that at an end, and that of the derivative from there."""
        if start is None or self._sign(self.whole, read(start.text)) not in (0, 1):
            return False
        knowledge = self.knowledge
        if self.scope.low and self.scope.high:
            knowledge.value(knowledge.theory.read(self.scope.high.text) - knowledge.theory.read(self.scope.low.text))
        samples = samples_at({self.scope.name: point} for point in self.scope.points())
        rise = Rise(self.scope.name, self.whole, start.text, self.scope.given())
        return self.analysis.risen(self.element, rise, samples, self.strict)

    def _divided(self) -> bool:
        """Show the sign by that of a quotient by something positive, whose derivative is simpler."""
        knowledge = self.knowledge
        for divisor in leading(knowledge, self.element, self.scope.name):
            sign = knowledge.sign(divisor)
            if sign not in ("<", ">"):
                continue
            knowledge.spend(EFFORT)
            positive = divisor if sign == ">" else -divisor
            term = read(spelled(knowledge.theory, knowledge.theory.text(positive)))
            quotient = Function(self.analysis, over(self.whole, term), self.element / positive, self.scope, self.strict)
            slopes = {quotient._sign(quotient.slope, point) for point in self.scope.points()}
            for start, other in ((self.scope.low, -1), (self.scope.high, 1)):
                if start is None or slopes & {other, None}:
                    continue
                at_start = written(replaced(term, self.scope.name, read(start.text)))
                if (
                    knowledge.step("defined", term=at_start)
                    and knowledge.value(knowledge.theory.read(at_start))
                    and quotient._from(start)
                    and multiplied(knowledge, self.element, positive, self.strict)
                ):
                    return True
        return False

    def _on_a_range(self) -> bool:
        """Show that the function is positive by its values on pieces of the range."""
        if self.scope.low is None or self.scope.high is None:
            return False
        low, high = self.scope.low.value, self.scope.high.value
        low = low if low.denominator < GRAIN else Fraction(floor(low * GRAIN), GRAIN)
        high = high if high.denominator < GRAIN else Fraction(ceil(high * GRAIN), GRAIN)
        pieces = [low]
        waiting = [high]
        if self._sign(self.whole, low) != 1 or self._sign(self.whole, high) != 1:
            return False
        while waiting:
            if len(waiting) > MOST_HALVINGS or len(pieces) >= MOST_PIECES:
                return False
            if is_positive(self.whole, self.scope.name, pieces[-1], waiting[-1], BITS):
                pieces.append(waiting.pop())
            else:
                waiting.append((pieces[-1] + waiting[-1]) / 2)
        knowledge = self.knowledge
        variable = knowledge.theory.variable(self.scope.name)
        return (
            knowledge.positive(variable - knowledge.theory.number(low))
            and knowledge.positive(knowledge.theory.number(high) - variable)
            and knowledge.step(
                "on a range",
                variable=self.scope.name,
                function=written(self.whole),
                ends=[str(end) for end in pieces],
                bits=BITS,
            )
        )

    def _cut(self, changes: Sequence[tuple[Any, Any]]) -> None:
        """Note where to cut the range: at a zero, or beside an end from which the function rises."""
        low, inner = self.scope.low, list[str]()
        for (left, before), (right, _) in changes:
            zero = self._zero(left, right) if before < 0 else None
            if zero is not None:
                inner.append(zero)
        if inner:
            self._note(inner[0])
        elif low is None or self._sign(self.whole, read(low.text)) != 1:
            self._note(str(changes[0][0][0]))
        else:
            self._note(str(changes[-1][1][0]))

    def _note(self, text: str) -> None:
        theory = self.knowledge.theory
        self.knowledge.step("defined", term=text)
        side = theory.variable(self.scope.name) - theory.read(text)
        if self.knowledge.sign(side) is None:
            self.knowledge.cuts.append(side.numerator)

    def _zero(self, left: Fraction, right: Fraction) -> str | None:
        """Return a simple number between two others at which the function seems to be zero."""
        for _ in range(HALVINGS):
            middle = (left + right) / 2
            left, right = (middle, right) if self._sign(self.slope, middle) in (-1, 0) else (left, middle)
        number = float(left)
        kinds = [("{}", number), ("{}*pi", number / pi), ("sqrt({})", number * abs(number))]
        kinds += [("exp({})", log(number))] if number > 0 else []
        for form, value in kinds:
            text = form.format(Fraction(value).limit_denominator(SIMPLE))
            if self._sign(self.whole, read(text)) == 0:
                return text
        return None


def spelled(theory: Theory, text: str) -> str:
    """Return a text with what names of applications stand for."""
    return re.sub(r"(?<![\w'])_[0-9]+", lambda found: _spelled(theory, found[0]), text)


def _spelled(theory: Theory, name: str) -> str:
    function, degree, args = theory.applications[name]
    listed = [spelled(theory, theory.text(arg)) for arg in args]
    return f"(({listed[0]})**(1/{degree}))" if function == "root" else f"{function}({', '.join(listed)})"


def rational(value: Any) -> Fraction:
    """Return about the value of a number, given by itself or by an interval."""
    return value if isinstance(value, Fraction) else Fraction(value[0] + value[1], 2 << BITS).limit_denominator(10**9)
