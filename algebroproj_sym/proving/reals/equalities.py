"""Equalities with functions: relate the functions, then compare polynomials, powers, angles and logarithms."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations

from algebroproj_sym.proving.reals.arcs import (
    ARCS,
    arc_decided,
    by_angle,
    is_positive_by_square,
    turn_decided,
    turned_by_an_eighth,
)
from algebroproj_sym.proving.reals.constants import constant_zero
from algebroproj_sym.proving.reals.knowledge import Knowledge
from algebroproj_sym.proving.reals.normal import normalised
from algebroproj_sym.replaying.field import Element

MOST_NUMBERS = 12


def are_equal(knowledge: Knowledge, left: Element, right: Element) -> bool:
    """Show that two elements are equal."""
    goal = left - right
    if knowledge.zero(goal, quick=True):
        return True
    normalised(knowledge)
    if knowledge.theory.contradictory or knowledge.zero(goal):
        return True
    _related(knowledge)
    if knowledge.zero(goal):
        return True
    return (
        constant_zero(knowledge, goal)
        or _by_powers(knowledge, left, right)
        or by_angle(knowledge, goal, _related)
        or _by_logarithms(knowledge, goal)
    )


def _related(knowledge: Knowledge) -> None:
    """Relate all functions, and decide their signs."""
    normalised(knowledge)
    signs_decided(knowledge)
    unified(knowledge)


def signs_decided(knowledge: Knowledge) -> None:
    """Give every sign function its value, every arc its range, and zero to arcs of zero."""
    for name, known in [*knowledge.theory.applications.items()]:
        theory = knowledge.theory
        symbol = theory.field.symbol(name)
        if known.function == "sign":
            sign = knowledge.sign(known.args[0])
            if sign in (">", "<", "=") or knowledge.zero(known.args[0]):
                knowledge.step("sign function", target=name)
            else:
                knowledge.want(*(factor for factor, _ in knowledge.signed(known.args[0]).factor()[1]))
        elif known.function in ("atan", "asin", "atan2"):
            arc_decided(knowledge, name, symbol)
        elif known.function == "sin":
            turn_decided(knowledge, symbol, known.args[0])


def unified(knowledge: Knowledge) -> None:
    """Find roots, sines and cosines that are equal: those that look so, have equal squares, and are not negative."""
    theory = knowledge.theory
    _proportional(knowledge)
    if len(knowledge.samples) < 2:
        return
    found = [
        (theory.field.symbol(name), known.degree or 2)
        for name, known in theory.applications.items()
        if known.function in ("sin", "cos", "root")
    ]
    for name, known in theory.applications.items():
        if known.function == "atan2":
            arc = theory.field.symbol(name)
            sin, cos = theory.named("sin", arc), theory.named("cos", arc)
            assert sin is not None
            assert cos is not None
            found.append((known.args[1] * cos + known.args[0] * sin, 2))
    for count, (first, degree) in enumerate(found):
        for second, other in found[:count]:
            for left, right in ((first, second), (-first, -second), (first, -second), (-first, second)):
                if knowledge.seen(left - right) - {0} or (max(degree, other) > 2 and degree != other):
                    continue
                if knowledge.zero(left - right, quick=True):
                    break
                if knowledge.positive(left) and knowledge.positive(right):
                    power = max(degree, other)
                    if knowledge.zero(left**power - right**power):
                        texts = knowledge.said(left), knowledge.said(right)
                        knowledge.step("equal powers", left=texts[0], right=texts[1], degree=power)
                    break


def _proportional(knowledge: Knowledge) -> None:
    """Find numbers that are rational multiples of each other."""
    theory = knowledge.theory
    numbers = [
        theory.field.symbol(name)
        for name, known in theory.applications.items()
        if known.function in ("sin", "cos", "root", *ARCS)
        and knowledge.is_number(knowledge.into(theory.variable(name).numerator))
    ]
    numbers += [theory.pi] if "pi" in theory.alive else []
    for count, first in enumerate(numbers[:MOST_NUMBERS]):
        for second in numbers[:count]:
            values = [knowledge.value_of(number) for number in (first, second)]
            if not all(values):
                continue
            ratio = Fraction(values[0] / values[1]).limit_denominator(MOST_NUMBERS)
            if not ratio or abs(values[0] / values[1] - float(ratio)) > 1e-9 or abs(ratio.numerator) > MOST_NUMBERS:
                continue
            left = first * theory.number(ratio.denominator)
            right = second * theory.number(ratio.numerator)
            if (
                not knowledge.zero(left - right, quick=True)
                and constant_zero(knowledge, left * left - right * right)
                and knowledge.positive(left)
                and knowledge.positive(right)
            ):
                knowledge.step("equal powers", left=knowledge.said(left), right=knowledge.said(right), degree=2)


def _by_powers(knowledge: Knowledge, left: Element, right: Element) -> bool:
    """Compare powers of two sides that are not negative."""
    applications = knowledge.theory.applications.values()
    degrees = {known.degree or 2 for known in applications if known.function in ("root", "sin")}
    if not degrees:
        return False
    theory = knowledge.theory
    for sign in (1, -1):
        a, b = left * theory.number(sign), right * theory.number(sign)
        if all(knowledge.positive(side) or turned_by_an_eighth(knowledge, side, _related) for side in (a, b)):
            for degree in sorted(degrees):
                if knowledge.zero(a**degree - b**degree):
                    texts = [knowledge.said(side) for side in (a, b)]
                    if knowledge.step("equal powers", left=texts[0], right=texts[1], degree=degree):
                        return knowledge.zero(left - right)
    return False


def _by_logarithms(knowledge: Knowledge, goal: Element) -> bool:
    """Show that a sum of logarithms and of a rest is zero by the product of their arguments."""
    theory = knowledge.theory
    logs = {name: known.args[0] for name, known in theory.applications.items() if known.function == "log"}
    terms = dict(theory.signed(goal).terms)
    counts = {}
    for name in logs:
        monomial = next(iter(theory.field.symbol(name).numerator.terms))
        if monomial in terms:
            counts[name] = terms.pop(monomial)
    if not counts:
        return False
    rest = knowledge.rational(terms)
    if rest.is_zero:
        _isolated_root(knowledge, [(logs[name], n) for name, n in counts.items()])
    positive = [(n, knowledge.said(logs[name])) for name, n in counts.items() if n > 0]
    negative = [(-n, knowledge.said(logs[name])) for name, n in counts.items() if n < 0]
    if not rest.is_zero:
        knowledge.step("defined", term=f"exp({knowledge.said(rest)})")
        normalised(knowledge)
        power = knowledge.theory.named("exp", rest)
        assert power is not None
        positive.append((1, knowledge.theory.text(power)))
    product = "*".join(f"({text})**{n}" for n, text in positive) or "1"
    other = "*".join(f"({text})**{n}" for n, text in negative) or "1"
    value = knowledge.theory.read(product)
    if not knowledge.zero(value - knowledge.theory.read(other)) or not knowledge.positive(value, True):
        return False
    if not knowledge.step("defined", term=f"log({product})"):
        return False
    target = knowledge.called("log", value)
    for parts in (positive, negative):
        knowledge.step("logarithms", target=target, parts=[[n, text] for n, text in parts])
    return knowledge.zero(goal)


def _isolated_root(knowledge: Knowledge, powers: Sequence[tuple[Element, int]]) -> None:
    """Find the root r of one factor t + r if a product of powers is 1: it is the product of the others, less t."""
    for factor, power in powers:
        for root in _roots_in(knowledge, factor) if abs(power) == 1 else ():
            others = _product(knowledge, [(other, -n * power) for other, n in powers if other is not factor])
            value = _without_opposites(knowledge, root - factor + others)
            if (
                not knowledge.seen(root - value) - {0}
                and knowledge.zero(root * root - value * value)
                and knowledge.positive(root)
                and (knowledge.positive(value) or is_positive_by_square(knowledge, value))
                and knowledge.step("equal powers", left=knowledge.said(root), right=knowledge.said(value), degree=2)
            ):
                return


def _without_opposites(knowledge: Knowledge, element: Element) -> Element:
    """Return a polynomial without pairs of terms that are opposite, such as a root of a product and that of roots."""
    terms = [knowledge.rational({monomial: n}) for monomial, n in element.numerator.terms.items()]
    for one, other in combinations(terms, 2) if not element.exponents and len(terms) <= MOST_NUMBERS else ():
        if knowledge.seen(one + other) == {0} and knowledge.zero(one + other):
            rest = sum((term for term in terms if term not in (one, other)), one - one)
            return _without_opposites(knowledge, rest * knowledge.theory.number(Fraction(1, element.denominator)))
    return element


def _product(knowledge: Knowledge, powers: Sequence[tuple[Element, int]]) -> Element:
    """Return a product of powers, with conjugates for reciprocals where t + r times t - r is a number."""
    found = knowledge.theory.number(1)
    for factor, power in powers:
        for root in _roots_in(knowledge, factor)[:1] if power < 0 else ():
            conjugate = factor - root - root
            norm = knowledge.into((factor * conjugate).numerator)
            reduced = knowledge.reduced(norm)
            if reduced is not None and reduced[0].is_constant() and reduced[0] != 0:
                factor, power = conjugate / knowledge.back(reduced[0]), -power
        found = found * factor**power
    return found


def _roots_in(knowledge: Knowledge, element: Element) -> list[Element]:
    """Return the terms of a polynomial that are multiples of square roots, those made last first."""
    theory, found = knowledge.theory, list[Element]()
    for name, known in theory.applications.items() if not element.exponents else ():
        if (known.function, known.degree) == ("root", 2):
            root = theory.field.symbol(name)
            slope = element.numerator.terms.get(next(iter(root.numerator.terms)), 0)
            found += [root * theory.number(Fraction(slope, element.denominator))] if slope else []
    return found[::-1]
