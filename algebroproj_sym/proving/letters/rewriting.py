"""Proofs in words: a polynomial is zero because it is a sum of rules, each between words.

A polynomial is rewritten by the rules, the longest word first, each time into shorter ones: that ends.  Where something
is left, it is multiplied by what has an inverse in it, and rewritten again.  Whether all of it is found does not
matter: a proof is a list of sums, and each can be multiplied out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from typing import Any

from algebroproj_sym.expressions.letters import ONE, Shape, letters_text
from algebroproj_sym.proving.letters.rules import CONSTRAINT, Rule, rule_in
from algebroproj_sym.proving.letters.spanning import combined
from algebroproj_sym.proving.letters.words import (
    Algebra,
    Atom,
    Monomial,
    NotWordsError,
    Poly,
    Scalar,
    Word,
    constant,
    cuts_of,
    of_key,
    of_scalar,
    order,
    weight,
)

MOST_STEPS = 400
MOST_STATES = 60
MOST_MULTIPLICATIONS = 4


@dataclass(frozen=True)
class Part:
    """A multiple of something that is zero: ``factor * left * zero * right``, or a number made of that."""

    place: int
    """The place of what is zero: of a rule, or of an earlier sum."""
    factor: Poly
    """A number."""
    left: Poly
    right: Poly
    """What it is multiplied by."""
    inside: str = ""
    """Whether its trace is taken."""
    outer: Poly | None = None
    """What a number that is made of it is multiplied by."""

    def value(self, algebra: Algebra, zero: Poly) -> Poly:
        """Return the multiple."""
        inner = algebra.product(algebra.product(self.left, zero), self.right)
        inner = algebra.trace(inner) if self.inside else inner
        inner = algebra.product(self.factor, inner)
        return inner if self.outer is None else algebra.product(inner, self.outer)

    def within(self, algebra: Algebra) -> Part:
        """Return the multiple with its factors computed in another algebra."""
        factor, left, right = (algebra.poly(algebra.term(poly)) for poly in (self.factor, self.left, self.right))
        outer = None if self.outer is None else algebra.poly(algebra.term(self.outer))
        return replace(self, factor=factor, left=left, right=right, outer=outer)

    def record(self, algebra: Algebra) -> dict[str, Any]:
        """Return the multiple as text, without what is 1."""
        found: dict[str, Any] = {"of": self.place}
        named = {"times": self.factor, "left": self.left, "right": self.right, "then": self.outer}
        for key, poly in named.items():
            if poly is not None and poly != constant(1):
                found[key] = letters_text(algebra.term(poly))
        return {**found, "trace": True} if self.inside else found


@dataclass(frozen=True)
class Proof:
    """Why a polynomial is zero."""

    rules: list[Rule]
    """What is zero, and used."""
    sums: list[list[Part]]
    """Sums of multiples of rules, which have places from 0 on, and of earlier sums, which follow.  The last one is
    the polynomial."""

    def record(self, algebra: Algebra) -> dict[str, Any]:
        """Return the proof as text."""
        return {
            "rules": [_rule_record(algebra, rule) for rule in self.rules],
            "sums": [[part.record(algebra) for part in parts] for parts in self.sums],
        }

    def multiply_out(self, algebra: Algebra, constraints: Sequence[Poly]) -> None:
        """Compute the rules and the sums once more, in another algebra."""
        zeros = [rule_in(algebra, rule, constraints) for rule in self.rules]
        for parts in self.sums:
            values = [part.within(algebra).value(algebra, zeros[part.place]) for part in parts]
            zeros.append(reduce(Poly.__add__, values) if values else Poly(ONE, {}))


def proof_in_words(algebra: Algebra, claim: Poly, rules: Sequence[Rule]) -> Proof | None:
    """Return why a polynomial is zero; None if that was not found."""
    return _Search(algebra, rules).result(claim)


@dataclass(frozen=True)
class _State:
    """What is left of a claim that was multiplied and rewritten.

    ``whole == rest + sum(parts)``; the claim of `before` follows, since what it was multiplied by has an inverse.
    """

    whole: Poly
    rest: Poly
    parts: list[Part]
    before: _State | None = None
    undo: Part | None = None
    rule: Part | None = None
    depth: int = 0


class _Search:
    def __init__(self, algebra: Algebra, rules: Sequence[Rule]) -> None:
        self.algebra = algebra
        self.rules = rules
        self.leads = [max(rule.poly.terms, key=order) for rule in rules]
        self.longest_first = sorted(
            range(len(rules)), key=lambda place: (-len(self.leads[place][1]), -len(self.leads[place][0]))
        )
        self.places = {
            (rule.name, rule.of[0].key): place
            for place, rule in enumerate(rules)
            if isinstance(rule.of[0], Poly) and not rule.transposed
        }
        self.left = MOST_STEPS

    def result(self, claim: Poly) -> Proof | None:
        sums = self.proof(claim) or self._proof_of_forms(claim) or self._sum_of_multiples(claim)
        return None if sums is None else self._used(sums)

    def proof(self, claim: Poly) -> list[list[Part]] | None:
        """Return sums of multiples of the rules and of earlier sums, which have places from -1 on downwards."""
        waiting, seen = [self._state(claim)], set[object]()
        for _ in range(MOST_STATES):
            if not waiting:
                return None
            waiting.sort(key=lambda state: (len(state.rest.terms) + 2 * state.depth, str(state.rest.key)))
            state = waiting.pop(0)
            if not state.rest:
                return self._sums(state)
            if state.depth < MOST_MULTIPLICATIONS:
                for following in self._multiplied(state):
                    if following.rest.key not in seen:
                        seen.add(following.rest.key)
                        waiting.append(following)
        return None

    # -- rewriting

    def _state(self, whole: Poly, **more: Any) -> _State:
        rest, done, parts = whole, Poly(whole.shape, {}), list[Part]()
        self.left = MOST_STEPS
        while rest and self.left:
            self.algebra.work.spend(len(rest.terms))
            monomial = max(rest.terms, key=order)
            part = self._step(monomial, rest)
            if part is None:
                moved = Poly(whole.shape, {monomial: rest.terms[monomial]})
                rest, done = rest - moved, done + moved
            else:
                parts.append(part)
                rest = rest - part.value(self.algebra, self.rules[part.place].poly)
                self.left -= 1
        return _State(whole, rest + done, parts, **more)

    def _step(self, monomial: Monomial, rest: Poly) -> Part | None:
        """Return the multiple of a rule that takes a monomial out, and leaves shorter ones."""
        for place in self.longest_first:
            for part in self._fits(place, self.leads[place], monomial, rest.shape):
                found = part.value(self.algebra, self.rules[place].poly)
                value = found.terms.get(monomial)
                if value and all(order(other) <= order(monomial) for other in found.terms):
                    return replace(part, factor=part.factor.times(rest.terms[monomial] / value))
        return None

    def _fits(self, place: int, lead: Monomial, monomial: Monomial, shape: Any) -> Iterator[Part]:
        scalars, word = [*monomial[0]], monomial[1]
        for scalar in lead[0]:
            if scalar not in scalars:
                return
            scalars.remove(scalar)
        rule = self.rules[place].poly
        if not lead[1]:
            if rule.shape == ONE:
                yield Part(place, self._number(scalars), constant(1), Poly(shape, {((), word): Fraction(1)}))
            return
        for start in _places(lead[1], word):
            left, right = word[:start], word[start + len(lead[1]) :]
            yield self._part(place, scalars, left, right, rule)
        for scalar in dict.fromkeys(scalars):
            if scalar.kind in ("form", "trace"):
                others = [*scalars]
                others.remove(scalar)
                if scalar.kind == "form":
                    yield from self._across(place, lead[1], scalar, others, word)
                yield from self._inside(place, lead[1], scalar, others, Poly(shape, {((), word): Fraction(1)}))

    def _across(self, place: int, lead: Word, scalar: Scalar, others: list[Scalar], word: Word) -> Iterator[Part]:
        """Yield where a rule fits when a number is put back into the word."""
        first: Word = scalar.key  # type: ignore[assignment]
        for cut in cuts_of(word):
            for form in (first, self.algebra.transposed_word(first)[1]):
                whole = word[:cut] + form + word[cut:]
                for start in _places(lead, whole):
                    left, right = whole[:start], whole[start + len(lead) :]
                    yield self._part(place, others, left, right, self.rules[place].poly)

    def _inside(self, place: int, lead: Word, scalar: Scalar, others: list[Scalar], outer: Poly) -> Iterator[Part]:
        first: Word = scalar.key  # type: ignore[assignment]
        turns = range(len(first)) if scalar.kind == "trace" else (0,)
        outside = None if outer == constant(1) else outer
        for word in (first, self.algebra.transposed_word(first)[1]):
            for turn in turns:
                turned = word[turn:] + word[:turn]
                for start in _places(lead, turned):
                    left, right = turned[:start], turned[start + len(lead) :]
                    part = self._part(place, others, left, right, self.rules[place].poly)
                    yield replace(part, inside="trace" if scalar.kind == "trace" else "", outer=outside)

    def _part(self, place: int, scalars: Sequence[Scalar], left: Word, right: Word, rule: Poly) -> Part:
        before = Poly((left[0].rows, left[-1].columns), {((), left): Fraction(1)}) if left else constant(1)
        after = Poly((right[0].rows, right[-1].columns), {((), right): Fraction(1)}) if right else constant(1)
        return Part(place, self._number(scalars), before, after)

    def _number(self, scalars: Sequence[Scalar]) -> Poly:
        result = constant(1)
        for scalar in scalars:
            result = self.algebra.product(result, of_scalar(scalar))
        return result

    # -- multiplying

    def _multiplied(self, state: _State) -> Iterator[_State]:
        """Yield what is left times what has an inverse: what is inverted at its ends, and orthogonal letters there."""
        algebra, rest = self.algebra, state.rest
        ends = {(True, word[0]) for _, word in rest.terms if word} | {
            (False, word[-1]) for _, word in rest.terms if word
        }
        for scalar in sorted({scalar for scalars, _ in rest.terms for scalar in scalars}, key=str):
            if scalar.kind == "reciprocal":
                base = of_key(scalar.key)
                yield from self._following(state, base, of_scalar(scalar), "left inverse", base, on_left=True)
        for on_left, atom in sorted(ends, key=str):
            value = algebra.of_word((atom.rows, atom.columns), (atom,))
            if atom.kind == "inverse":
                base = algebra.transposed(of_key(atom.key)) if atom.transposed else of_key(atom.key)
                name = "left inverse" if on_left else "right inverse"
                yield from self._following(state, base, value, name, base, on_left=on_left)
            elif atom.kind == "letter" and "orthogonal" in algebra.letters[str(atom.key)].properties:
                other = algebra.transposed(value)
                name = "orthogonal rows" if on_left != atom.transposed else "orthogonal columns"
                letter = other if atom.transposed else value
                yield from self._following(state, other, value, name, letter, on_left=on_left)

    def _following(
        self, state: _State, base: Poly, inverse: Poly, name: str, of: Poly, *, on_left: bool
    ) -> Iterator[_State]:
        place = self.places.get((name, of.key))
        if place is None:
            return
        one, rest = constant(1), state.rest
        try:
            whole = self.algebra.product(base, rest) if on_left else self.algebra.product(rest, base)
            undo = Part(0, one, *((inverse, one) if on_left else (one, inverse)))
            rule = Part(place, constant(-1), *((one, rest) if on_left else (rest, one)))
            yield self._state(whole, before=state, undo=undo, rule=rule, depth=state.depth + 1)
        except NotWordsError:
            return

    # -- forms

    def _proof_of_forms(self, claim: Poly) -> list[list[Part]] | None:
        """Return why forms ``u.T*A*v`` add up to zero: for each u and v, what is between them does."""
        groups: dict[tuple[Atom, Atom], Poly] = {}
        for (scalars, _), value in claim.terms.items():
            forms = [scalar for scalar in scalars if scalar.kind == "form"]
            if claim.shape != ONE or not forms:
                return None
            longest = max(forms, key=weight)
            others = [*scalars]
            others.remove(longest)
            sign, first, inner, last = self._cut(longest)
            middle = Poly((first.columns, last.rows), {((*others,), inner): value * sign})
            groups[first, last] = groups.get((first, last), Poly(middle.shape, {})) + middle
        sums, whole, rest = list[list[Part]](), list[Part](), claim
        for (first, last), middle in groups.items():
            if self.algebra.transposed_word((first,)) == (1, (last,)):
                middle = (middle + self.algebra.transposed(middle)).times(Fraction(1, 2))
            found = self.proof(middle)
            if found is None:
                return None
            moved = len(sums)
            for parts in found:
                sums.append([replace(part, place=part.place - moved * (part.place < 0)) for part in parts])
            whole.append(self._part(-len(sums), (), (first,), (last,), middle))
            rest = rest - whole[-1].value(self.algebra, middle)
        return None if rest else [*sums, whole]

    def _cut(self, form: Scalar) -> tuple[int, Atom, Word, Atom]:
        """Return a form, or its transpose with a sign, as its first factor, those between, and its last one."""
        key: Word = form.key  # type: ignore[assignment]
        forms = [(1, key), self.algebra.transposed_word(key)]
        sign, word = min(forms, key=lambda each: (str(each[1][0]), str(each[1][-1])))
        return sign, word[0], word[1:-1], word[-1]

    # -- multiples

    def _sum_of_multiples(self, claim: Poly) -> list[list[Part]] | None:
        """Return the claim as a sum of multiples of the rules, if something is given."""
        if not any(rule.name == CONSTRAINT for rule in self.rules):
            return None
        found = combined(claim, lambda monomial: self._with_word(monomial, claim.shape))
        if found is None:
            return None
        return [[replace(part, factor=part.factor.times(factor)) for part, factor in found]]

    def _with_word(self, monomial: Monomial, shape: Shape) -> Iterator[tuple[Part, Poly]]:
        """Yield the multiples of the rules that have a monomial."""
        for place, rule in enumerate(self.rules):
            for lead in (each for each in rule.poly.terms if each != ((), ())):
                for part in self._fits(place, lead, monomial, shape):
                    value = part.value(self.algebra, rule.poly)
                    self.algebra.work.spend(len(value.terms))
                    if monomial in value.terms:
                        yield part, value

    # -- the proof

    def _sums(self, state: _State) -> list[list[Part]]:
        sums = [state.parts]
        while state.before is not None and state.undo is not None and state.rule is not None:
            last = replace(state.undo, place=-len(sums))
            sums.append([*state.before.parts, last, state.rule])
            state = state.before
        return sums

    def _used(self, sums: list[list[Part]]) -> Proof:
        """Return the proof with the rules that it uses."""
        used = sorted({part.place for parts in sums for part in parts if part.place >= 0})
        places = {place: k for k, place in enumerate(used)} | {-k: len(used) + k - 1 for k in range(1, len(sums))}
        return Proof(
            [self.rules[place] for place in used],
            [[replace(part, place=places[part.place]) for part in parts] for parts in sums],
        )


def _rule_record(algebra: Algebra, rule: Rule) -> dict[str, Any]:
    named = [part if isinstance(part, int) else letters_text(algebra.term(part)) for part in rule.of]
    return {"rule": rule.name, "of": named} | ({"transposed": True} if rule.transposed else {})


def _places(part: Word, word: Word) -> Iterator[int]:
    for start in range(len(word) - len(part) + 1):
        if word[start : start + len(part)] == part:
            yield start
