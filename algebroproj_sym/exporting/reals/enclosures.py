"""Enclosures of numbers: rational bounds of pi, and of roots, sines, cosines and arcs of enclosed numbers.

A sine is between two parts of its series at the ends of its angle; an arc is between two angles whose sines, or
quotients of sine and cosine, are on both sides of what it is the arc of.
"""

from collections.abc import Callable
from fractions import Fraction
from functools import reduce
from itertools import product
from math import ceil, floor
from typing import TypeAlias

from algebroproj_sym.exporting.gallina import digits
from algebroproj_sym.exporting.reals.formulas import called
from algebroproj_sym.exporting.reals.writing import Enclosed, Written
from algebroproj_sym.exporting.refusal import Silent
from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.polynomial import BITS, powers_of

DECIMALS = 10**5
PI = Fraction(3141592, 10**6), Fraction(3141593, 10**6)
FARTHEST = Fraction(3, 2)
"""The largest angle whose sine and cosine are enclosed."""


_Apart: TypeAlias = "Callable[[Fraction, Enclosed], tuple[Fraction, Fraction]]"


def positive(theory: Written, element: Element) -> str:
    """Return a proof that a number is positive.

    It raises `Silent` if there are no bounds of it, or these do not tell.
    """
    low, _, text, proof = _element(theory, element)
    if low <= 0:
        raise Silent("no theorem is written yet for the sign of a number so near to zero")
    return f"ltac:(clear - {proof}; lra) : 0 < {text}"


def _element(theory: Written, element: Element) -> Enclosed:
    """Enclose a polynomial of numbers."""
    if element.exponents:
        raise Silent("no theorem is written yet for the sign of a quotient of numbers")
    names = {place: name for name, place in theory.field.places.items()}
    low = high = Fraction(0)
    proofs = []
    for monomial, coefficient in element.numerator.terms.items():
        factors = [names[place] for place, power in powers_of(monomial) for _ in range(power)]
        if factors:
            found = reduce(lambda left, right: _product(theory, left, right), [_name(theory, name) for name in factors])
            ends = sorted((coefficient * found.low, coefficient * found.high))
            proofs.append(found.proof)
        else:
            ends = [Fraction(coefficient)] * 2
        low, high = low + ends[0] / element.denominator, high + ends[1] / element.denominator
    return _enclosed(
        theory, low, high, theory.shown(element), f"clear - {' '.join(proofs)}; lra" if proofs else "clear; lra"
    )


def _enclosed(theory: Written, low: Fraction, high: Fraction, text: str, tactics: str) -> Enclosed:
    """Write down bounds, rounded outwards."""
    low, high = Fraction(floor(low * DECIMALS), DECIMALS), Fraction(ceil(high * DECIMALS), DECIMALS)
    return Enclosed(low, high, text, theory.asserted(f"{_text(low)} <= {text} <= {_text(high)}", f"{tactics}."))


def _product(theory: Written, left: Enclosed, right: Enclosed) -> Enclosed:
    ends = [a * b for a, b in product((left.low, left.high), (right.low, right.high))]
    proof = f"apply (product_between _ _ _ _ _ _ _ _ {left.proof} {right.proof}); clear; lra"
    return _enclosed(theory, min(ends), max(ends), f"({left.text} * {right.text})", proof)


def _name(theory: Written, name: str) -> Enclosed:
    """Enclose pi, or the value of a function."""
    function = name if name == "pi" else theory.applications[name].function if name in theory.applications else "symbol"
    if function not in _FUNCTIONS:
        raise Silent(f"no theorem is written yet for the sign of a number with a {function}")
    if name not in theory.enclosed:
        theory.enclosed[name] = _FUNCTIONS[function](theory, name)
    return theory.enclosed[name]


def _pi(theory: Written, name: str) -> Enclosed:
    stated = f"{_text(PI[0])} <= PI <= {_text(PI[1])}"
    return Enclosed(*PI, "PI", theory.asserted(stated, "clear; pose proof close_to_pi; lra."))


def _root(theory: Written, name: str) -> Enclosed:
    _, degree, (radicand,) = theory.applications[name]
    value, of = theory.field.symbol(name), _element(theory, radicand)
    low, high = _root_of(of.low, degree), _root_of(of.high, degree) + Fraction(1, DECIMALS)
    power = theory.proof("=", value**degree - radicand, f"({called(name)} ^ {degree} - {of.text})")
    known = f"{theory.proof('>=', value)} {power}"
    proof = f"apply (root_between _ {of.text} {degree - 1} _ _ {known}); clear - {of.proof}; lra"
    return _enclosed(theory, low, high, called(name), proof)


def _root_of(number: Fraction, degree: int) -> Fraction:
    """Return a root rounded downwards."""
    wanted, low, high = floor(number * DECIMALS**degree), 0, (floor(number) + 1) * DECIMALS
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle**degree <= wanted else (low, middle)
    return Fraction(low, DECIMALS)


def _sine(theory: Written, name: str) -> Enclosed:
    angle = _angle(theory, name)
    return _of_series(theory, name, angle, "sine", sine(angle.low)[0], sine(angle.high)[1])


def _cosine(theory: Written, name: str) -> Enclosed:
    angle = _angle(theory, name)
    return _of_series(theory, name, angle, "cosine", cosine(angle.high)[0], cosine(angle.low)[1])


def _angle(theory: Written, name: str) -> Enclosed:
    angle = _element(theory, theory.applications[name].args[0])
    if angle.low < 0 or angle.high > FARTHEST:
        raise Silent("no theorem is written yet for the sign of a number with such an angle")
    return angle


def _of_series(theory: Written, name: str, angle: Enclosed, kind: str, low: Fraction, high: Fraction) -> Enclosed:
    value = called(name)
    ends = f"{_text(angle.low)} {_text(angle.high)}"
    stated = f"{kind}_between {value} {angle.text} {ends} d{value} ltac:(clear; lra) {angle.proof} ltac:(clear; lra)"
    proof = f"pose proof ({stated}) as e; {_UNFOLDED} in e; clear - e; lra"
    return _enclosed(theory, low, high, value, proof)


def _arc_sine(theory: Written, name: str) -> Enclosed:
    return _arc(theory, name, "sine", lambda angle, of: (sine(angle)[1] - of.low, of.high - sine(angle)[0]))


def _arc_tangent(theory: Written, name: str) -> Enclosed:
    def apart(angle: Fraction, of: Enclosed) -> tuple[Fraction, Fraction]:
        (low, high), (below, above) = sine(angle), cosine(angle)
        return high - of.low * below, of.high * above - low

    return _arc(theory, name, "tangent", apart)


def _arc(theory: Written, name: str, kind: str, apart: _Apart) -> Enclosed:
    """Enclose an arc between angles at which what must not be positive is not."""
    of = _element(theory, theory.applications[name].args[0])
    value, about = called(name), _middle(theory, name)
    for margin in (Fraction(1, 1000), Fraction(1, 100), Fraction(1, 20)):
        low, high = max(about - margin, Fraction(0)), about + margin
        if of.low >= 0 and high <= FARTHEST and apart(low, of)[0] <= 0 and apart(high, of)[1] <= 0:
            stated = f"arc_{kind}_between {value} {of.text} {_text(low)} {_text(high)} d{value}"
            proof = f"apply ({stated}); {_UNFOLDED}; clear - {of.proof}; lra"
            return _enclosed(theory, low, high, value, proof)
    raise Silent("no theorem is written yet for the sign of a number with such an arc")


def _middle(theory: Written, name: str) -> Fraction:
    found = theory.value(theory.field.symbol(name), BITS)
    about = found if isinstance(found, Fraction) else Fraction(found[0], 1 << BITS)
    return Fraction(floor(about * DECIMALS), DECIMALS)


def sine(angle: Fraction) -> tuple[Fraction, Fraction]:
    """Return what a sine is not below, and not above."""
    low = angle - angle**3 / 6 + angle**5 / 120 - angle**7 / 5040
    return low, low + angle**9 / 362880


def cosine(angle: Fraction) -> tuple[Fraction, Fraction]:
    """Return what a cosine is not below, and not above."""
    low = 1 - angle**2 / 2 + angle**4 / 24 - angle**6 / 720
    return low, low + angle**8 / 40320


def _text(value: Fraction) -> str:
    sign = "- " if value < 0 else ""
    return f"({sign}({digits(abs(value.numerator))} / {digits(value.denominator)}))"


_UNFOLDED = "unfold sine_above, sine_below, cosine_above, cosine_below"

_FUNCTIONS = {"pi": _pi, "root": _root, "sin": _sine, "cos": _cosine, "asin": _arc_sine, "atan": _arc_tangent}
