"""Angles: the ranges that signs of sines and cosines give, and angles that are zero, or equal, by their sines."""

from collections.abc import Callable, Mapping
from fractions import Fraction
from itertools import combinations
from math import gcd

from algebroproj_sym.proving.reals.constants import constant_zero
from algebroproj_sym.proving.reals.knowledge import Knowledge
from algebroproj_sym.proving.reals.normal import normalised
from algebroproj_sym.replaying.field import Element

ARCS = ("asin", "atan", "atan2")
MOST_ANGLES = 8

Relate = Callable[[Knowledge], None]


def turn_decided(knowledge: Knowledge, sin: Element, angle: Element) -> None:
    """Give sine and cosine their signs where the range of the angle gives them."""
    theory = knowledge.theory
    knowledge.step("defined", term="pi")
    cos, pi, two = theory.named("cos", angle), theory.pi, theory.number(2)
    if cos is None or not knowledge.samples or not knowledge.bounded(angle):
        return
    if not theory.holds(">=", cos) and knowledge.positive(pi - two * angle) and knowledge.positive(pi + two * angle):
        knowledge.step("cosine in range", angle=knowledge.said(angle))
    elif knowledge.positive(two * angle - pi) and knowledge.positive(pi + two * (pi - angle)):
        _opposite(knowledge, angle)
    if theory.holds(">=", sin):
        return
    if knowledge.positive(angle) and knowledge.positive(pi - angle):
        knowledge.step("sine in range", angle=knowledge.said(angle))
    elif knowledge.positive(-angle) and knowledge.positive(pi + angle) and _opposite_sine(knowledge, angle) is not None:
        knowledge.step("sine in range", angle=f"-({knowledge.said(angle)})")
        knowledge.positive(-sin)


def _opposite_sine(knowledge: Knowledge, angle: Element) -> Element | None:
    """Return the sine of the opposite angle, after relating both."""
    text = knowledge.said(angle)
    if not knowledge.step("defined", term=f"sin(-({text}))"):
        return None
    name = knowledge.called("sin", -angle)
    knowledge.step("addition", target=name, parts=[[-1, text]])
    return knowledge.theory.field.symbol(name)


def _opposite(knowledge: Knowledge, angle: Element) -> None:
    """Find the sign of a cosine from that of half a turn less."""
    theory = knowledge.theory
    text = f"{knowledge.said(angle)} - pi"
    if knowledge.step("defined", term=f"sin({text})"):
        turned = angle - theory.pi
        parts = [[1, knowledge.said(angle)], [-2, "pi/2"]]
        knowledge.step("addition", target=knowledge.called("sin", turned), parts=parts)
        if knowledge.positive(theory.pi - turned - turned) and knowledge.positive(theory.pi + turned + turned):
            knowledge.step("cosine in range", angle=text)


def arc_decided(knowledge: Knowledge, name: str, arc: Element) -> None:
    """Give an arc the range that the signs of its sine and cosine give."""
    theory = knowledge.theory
    function, _, args = theory.applications[name]
    sin, cos = theory.named("sin", arc), theory.named("cos", arc)
    if sin is None or cos is None:
        return
    pi = theory.pi
    sign = knowledge.sign(sin)
    if sign == "=" or (sign is None and knowledge.zero(sin)):
        if knowledge.positive(pi - arc, True) and knowledge.positive(pi + arc, True):
            knowledge.step("zero of sine", angle=theory.text(arc))
    elif sign is None:
        knowledge.want(knowledge.signed(sin), *(factor for factor, _ in knowledge.signed(args[0]).factor()[1]))
    else:
        _ranged(knowledge, "sine", arc if sign.startswith(">") else -arc)
    if function == "atan2":
        side = knowledge.sign(cos)
        if side is not None and side.startswith(">"):
            _ranged(knowledge, "cosine", arc)
        elif side is not None and sign is not None and sign != "=":
            _ranged(knowledge, "cosine", arc - pi if sign.startswith(">") else arc + pi)


def _ranged(knowledge: Knowledge, function: str, angle: Element) -> bool:
    """Give an angle its range if its sine, or its cosine, is not negative."""
    theory = knowledge.theory
    value = _value(knowledge, function, angle)
    if value is None or not (knowledge.positive(value) or is_positive_by_square(knowledge, value)):
        return False
    turn = theory.pi if function == "sine" else theory.pi * theory.number(Fraction(3, 2))
    strict = not theory.holds(">", value)
    low, high = turn + angle, (turn + turn if function == "sine" else turn) - angle
    return (
        knowledge.positive(low, strict)
        and knowledge.positive(high, strict)
        and knowledge.step(f"range of {function}", angle=knowledge.said(angle))
    )


def is_positive_by_square(knowledge: Knowledge, element: Element) -> bool:
    """Show that what is equal to t - u is not negative, as one of its terms t is not, and t**2 >= u**2."""
    polynomial = knowledge.into(element.numerator)
    reduced = knowledge.reduced(polynomial)
    if len(polynomial) == 2 and (reduced is None or len(reduced[0]) != 2):
        reduced = polynomial, {}
    if reduced is None or len(reduced[0]) != 2 or -1 in knowledge.seen(element):
        return False
    for powers, value in reduced[0].to_dict().items():
        term = knowledge.context.from_dict({powers: value})
        rest = term - reduced[0]
        texts = [knowledge.said(knowledge.back(side)) for side in (term, rest)]
        if (
            knowledge.positive(knowledge.back(term))
            and knowledge.positive(knowledge.back(term**2 - rest**2))
            and knowledge.step("order of powers", larger=texts[0], smaller=texts[1], degree=2)
        ):
            return knowledge.positive(element)
    return False


def _value(knowledge: Knowledge, function: str, angle: Element) -> Element | None:
    """Return the sine, or the cosine, of an angle, after relating it to others."""
    if not _related_sine(knowledge, angle):
        return None
    return knowledge.theory.named("sin" if function == "sine" else "cos", angle)


def _related_sine(knowledge: Knowledge, angle: Element) -> bool:
    if knowledge.theory.named("sin", angle) is not None:
        return True
    if not knowledge.step("defined", term=f"sin({knowledge.said(angle)})"):
        return False
    normalised(knowledge)
    return True


def turned_by_an_eighth(knowledge: Knowledge, element: Element, relate: Relate) -> bool:
    """Show that cos F + sin F, or cos F - sin F, is not negative by the range of F + pi/4."""
    theory = knowledge.theory
    terms = {theory.written(type(element.numerator)({monomial: 1})) for monomial in element.numerator.terms}
    found = [theory.applications.get(name) for name in sorted(terms)]
    if len(found) != 2 or {known and known.function for known in found} != {"sin", "cos"} or found[0] is None:
        return False
    angle = found[0].args[0]
    if found[1] is None or not (found[1].args[0] - angle).is_zero:
        return False
    if not _related_sine(knowledge, angle + theory.pi * theory.number(Fraction(1, 4))):
        return False
    relate(knowledge)
    return knowledge.positive(element)


def by_angle(knowledge: Knowledge, goal: Element, relate: Relate) -> bool:
    """Show that an angle is zero, or that an arc is what it is said to be, by sines, cosines and ranges."""
    theory = knowledge.theory
    if not {*ARCS} & {known.function for known in theory.applications.values()} or knowledge.seen(goal) - {0}:
        return False
    if _by_sines(knowledge, goal):
        return True
    _with_roots(knowledge)
    relate(knowledge)
    if knowledge.zero(goal) or _by_sines(knowledge, goal):
        return True
    numerator, arcs = _angle_of(knowledge, goal)
    if not arcs:
        return False
    base = numerator * theory.number(Fraction(1, gcd(*(count for _, _, count in arcs))))
    for scale in (Fraction(1), Fraction(1, 2)):
        angle, pi = base * theory.number(scale), theory.pi
        half = knowledge.positive(pi - angle, True) and knowledge.positive(pi + angle, True)
        if half or (knowledge.positive(pi + pi - angle, True) and knowledge.positive(pi + pi + angle, True)):
            return _is_zero_angle(knowledge, angle, half, relate) and knowledge.zero(goal)
    return False


def _angle_of(knowledge: Knowledge, goal: Element) -> tuple[Element, list[tuple[Element, str, int]]]:
    """Return a goal as an angle, after rewriting, and its arcs; none if it has too many terms."""
    theory = knowledge.theory
    whole = knowledge.settled(theory.field.element(theory.signed(goal, parity=False)))
    terms = dict(theory.signed(whole, parity=False).terms)
    return knowledge.rational(terms), _arcs_in(knowledge, terms) if len(terms) <= MOST_ANGLES else []


def _by_sines(knowledge: Knowledge, goal: Element) -> bool:
    """Show that an arc of a sine is the rest of an angle, of which it is said to be the opposite."""
    numerator, arcs = _angle_of(knowledge, goal)
    common = gcd(*(count for _, _, count in arcs))
    for arc, _, count in arcs:
        _bounded_by_special(knowledge, arc, abs(count) // common)
    for (one, first, _), (two, second, _) in combinations(arcs, 2):
        if first == second == "asin":
            for larger, smaller in ((one, two), (two, one), (one, -two), (-two, one)):
                if -1 not in knowledge.seen(larger - smaller) and not knowledge.positive(larger - smaller):
                    _ordered(knowledge, larger, smaller)
    for arc, function, count in arcs:
        rest = arc - numerator * knowledge.theory.number(Fraction(1, count))
        if (
            function == "asin"
            and abs(count) == common
            and not rest.is_zero
            and _by_sine(knowledge, arc, rest)
            and knowledge.zero(goal)
        ):
            return True
    return False


def by_order(knowledge: Knowledge, relation: str, goal: Element) -> bool:
    """Show that an arc is more, or less, than an angle by its sine, or by the range that its sine and cosine give."""
    if relation not in (">", ">=") or goal.exponents:
        return False
    numerator = knowledge.theory.signed(goal)
    for arc, function, count in _arcs_in(knowledge, numerator.terms):
        if function == "asin":
            rest = arc - knowledge.rational(numerator.terms) * knowledge.theory.number(Fraction(1, count))
            larger, smaller = (arc, rest) if count > 0 else (rest, arc)
            if _ordered(knowledge, larger, smaller, relation == ">") and knowledge.positive(goal, relation == ">"):
                return True
    if not _arcs_in(knowledge, numerator.terms):
        return False
    _with_roots(knowledge)
    for name, known in [*knowledge.theory.applications.items()]:
        if known.function in ARCS:
            arc_decided(knowledge, name, knowledge.theory.field.symbol(name))
    return knowledge.positive(goal, relation == ">")


def _arcs_in(knowledge: Knowledge, terms: Mapping[int, int]) -> list[tuple[Element, str, int]]:
    """Return the arcs among the terms of an angle, what they are, and how often they are taken."""
    theory, found = knowledge.theory, list[tuple[Element, str, int]]()
    for name, known in theory.applications.items():
        if known.function in ARCS:
            arc = theory.field.symbol(name)
            count = terms.get(next(iter(arc.numerator.terms)), 0)
            if count:
                found.append((arc, known.function, count))
    return found


def _with_roots(knowledge: Knowledge) -> None:
    """Express sines and cosines of arcs by roots: of the square of a radius, of 1 + u**2, or of 1 - u**2."""
    for name, (function, _, args) in [*knowledge.theory.applications.items()]:
        if function not in ARCS:
            continue
        theory, arc, u = knowledge.theory, knowledge.theory.field.symbol(name), args[0]
        sin, cos, one = theory.named("sin", arc), theory.named("cos", arc), theory.number(1)
        assert sin is not None
        assert cos is not None
        if function == "asin":
            square, product, value = one - u * u, cos, None
        elif function == "atan":
            square, product, value = one + u * u, cos, cos
        else:
            square, product, value = u * u + args[1] * args[1], u * sin + args[1] * cos, None
        if not knowledge.positive(square) or not knowledge.step("defined", term=f"({knowledge.said(square)})**(1/2)"):
            continue
        root = theory.named("root", square, degree=2)
        assert root is not None
        left, right = (product, root) if value is None else (root * value, one)
        if _are_equal_squares(knowledge, left, right) and function == "atan2":
            knowledge.zero(root * cos - args[1])
            knowledge.zero(root * sin - u)


def _are_equal_squares(knowledge: Knowledge, left: Element, right: Element) -> bool:
    """Show that two numbers are equal, if they are not negative, by their squares."""
    return knowledge.zero(left - right, quick=True) or (
        knowledge.zero(left * left - right * right)
        and knowledge.positive(left)
        and knowledge.positive(right)
        and knowledge.step("equal powers", left=knowledge.said(left), right=knowledge.said(right), degree=2)
    )


def _bounded_by_special(knowledge: Knowledge, arc: Element, count: int) -> None:
    """Bound an arc of which a multiple is taken by the angles at which this is a quarter turn, or half of one."""
    theory = knowledge.theory
    if count < 2:
        return
    quarter = theory.pi * theory.number(Fraction(1, 2 * count))
    turn = theory.pi * theory.number(Fraction(1, 2))
    for bound in (quarter, turn - quarter - quarter)[: 1 if count == 3 else 2]:
        for side in (bound, -bound):
            for larger, smaller in ((side, arc), (arc, side)):
                rise = larger - smaller
                if knowledge.seen(rise) <= {0, 1} and not knowledge.positive(rise):
                    _ordered(knowledge, larger, smaller)


def _ordered(knowledge: Knowledge, larger: Element, smaller: Element, strict: bool = False) -> bool:
    """Show that one angle is at least another, both between quarter turns, if its sine is."""
    theory = knowledge.theory
    if not all(_related_sine(knowledge, angle) and _is_between(knowledge, angle) for angle in (larger, smaller)):
        return False
    first, second = theory.named("sin", larger), theory.named("sin", smaller)
    assert first is not None
    assert second is not None
    rise = first - second
    if not ((not strict and _zero_number(knowledge, rise)) or knowledge.positive(rise, strict)):
        return False
    return knowledge.step("order of sines", larger=knowledge.said(larger), smaller=knowledge.said(smaller))


def _is_between(knowledge: Knowledge, angle: Element) -> bool:
    """Show that an angle is from minus to plus a quarter turn."""
    pi, double = knowledge.theory.pi, angle + angle
    return all(knowledge.positive(side) for side in (pi - double, pi + double)) or _ranged(knowledge, "cosine", angle)


def _by_sine(knowledge: Knowledge, arc: Element, angle: Element) -> bool:
    """Show that an arc of a sine is an angle which has this sine, and lies in its range."""
    return _related_sine(knowledge, angle) and _is_between(knowledge, angle) and _ordered(knowledge, arc, angle)


def _is_zero_angle(knowledge: Knowledge, angle: Element, half: bool, relate: Relate) -> bool:
    text = knowledge.said(angle)
    if not knowledge.step("defined", term=f"sin({text})"):
        return False
    for monomial, value in knowledge.theory.signed(angle).terms.items():
        if abs(value) > 1:
            knowledge.step("defined", term=f"sin({knowledge.said(knowledge.rational({monomial: abs(value)}))})")
    relate(knowledge)
    theory = knowledge.theory
    sin, cos = theory.named("sin", angle), theory.named("cos", angle)
    assert sin is not None
    assert cos is not None
    one = theory.number(1)
    if half and _zero_number(knowledge, sin):
        return knowledge.step("zero of sine", angle=text)
    if not _zero_number(knowledge, cos - one):
        if not _zero_number(knowledge, sin):
            return False
        knowledge.zero(cos * cos - one)
        if not knowledge.positive(cos, True) or not knowledge.step(
            "equal powers", left=knowledge.theory.text(cos), right="1", degree=2
        ):
            return False
    return knowledge.step("full turn", angle=text)


def _zero_number(knowledge: Knowledge, element: Element) -> bool:
    return knowledge.zero(element) or constant_zero(knowledge, element)
