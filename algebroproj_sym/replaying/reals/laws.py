"""The laws by which more becomes known, each stated once with its side conditions.

A law takes a theory and the entries of a step, rejects the step if a side condition is not known to hold, and else
adds what follows.  Products of facts are given as powers by the places of the facts.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.reals.theory import Theory
from algebroproj_sym.replaying.reals.values import UndecidedError
from algebroproj_sym.replaying.rejection import Rejected, require
from algebroproj_sym.replaying.text import integer, natural, number

MOST_PARTS = 200
LARGEST = 64
MOST_BITS = 4096

Step = Mapping[str, Any]


def _product(theory: Theory, powers: Mapping[str, Any], relations: Sequence[str], *, even: bool = False) -> Element:
    """Return a product of facts of some relations; what is only not zero must have an even power, if so asked."""
    found = theory.number(1)
    for place, power in powers.items():
        require(place.isascii() and place.isdecimal() and int(place) < len(theory.facts), "there is no such fact")
        fact = theory.facts[int(place)]
        require(fact.relation in relations, f"fact {place} is of another kind")
        require(1 <= integer(power) <= LARGEST, "expected a power from 1 on")
        require(not even or fact.relation != "!=" or power % 2 == 0, "an odd power of what may be negative")
        found = found * theory.field.element(fact.polynomial) ** power
    return found


UNITS = (">", "!=")


def _combined(theory: Theory, cofactors: Mapping[str, Any]) -> Element:
    """Return a combination of what is zero."""
    products = (theory.polynomial(text) * _product(theory, {place: 1}, ("=",)) for place, text in cofactors.items())
    return sum(products, theory.number(0))


def _same(left: Element, right: Element) -> None:
    require((left - right).is_zero, "the identity does not multiply out")


def _scale(value: Any) -> int:
    require(integer(value) > 0, "expected a positive integer")
    return int(value)


def defined(theory: Theory, step: Step) -> None:
    """Use a term, if what its functions and divisions ask for is known."""
    theory.read(step["term"])


def follows(theory: Theory, step: Step) -> None:
    """Conclude p = 0 if scale*m*p**n is a combination of zeros, m a product of what is not zero.

    With n = 0 it is a contradiction.
    """
    zero = theory.polynomial(step["zero"])
    whole = theory.number(_scale(step["scale"])) * _product(theory, step["multiplier"], UNITS)
    _same(whole * zero ** natural(step["exponent"]), _combined(theory, step["cofactors"]))
    theory.add("=", zero if step["exponent"] else theory.number(1))


def sign(theory: Theory, step: Step) -> None:
    """Conclude p >= 0 if scale*m*p is a sum of squares times what is not negative, modulo zeros, m positive.

    It is > 0 if one of the terms is: a number times facts that are positive, or even powers of what is not zero.
    """
    polynomial = theory.polynomial(step["polynomial"])
    whole = theory.number(_scale(step["scale"])) * _product(theory, step["multiplier"], (">",))
    total, strict = _combined(theory, step["cofactors"]), False
    for weight, root, powers in step["sum"]:
        require(number(weight) > 0, "a weight is not positive")
        square = theory.polynomial(root)
        total = total + theory.number(number(weight)) * square * square * _product(
            theory, powers, (">", ">=", "!="), even=True
        )
        is_number = square.cleared().is_constant() and not square.is_zero
        strict |= is_number and all(theory.facts[int(place)].relation != ">=" for place in powers)
    _same(whole * polynomial, total)
    require(step["relation"] == ">=" or (step["relation"] == ">" and strict), "it is not shown to be positive")
    theory.add(step["relation"], polynomial)


def nonzero(theory: Theory, step: Step) -> None:
    """Conclude p != 0 if a product of what is not zero is a multiple of p, modulo zeros."""
    polynomial = theory.polynomial(step["polynomial"])
    whole = theory.number(_scale(step["scale"])) * _product(theory, step["multiplier"], UNITS)
    _same(whole, theory.polynomial(step["factor"]) * polynomial + _combined(theory, step["cofactors"]))
    theory.add("!=", polynomial)


def both(theory: Theory, step: Step) -> None:
    """Conclude p > 0 if p >= 0 and p != 0; p = 0 if p >= 0 and -p >= 0."""
    polynomial = theory.polynomial(step["polynomial"])
    theory.require(">=", polynomial, "both")
    if theory.holds(">=", -polynomial):
        theory.add("=", polynomial)
    else:
        theory.require("!=", polynomial, "both")
        theory.add(">", polynomial)


def value(theory: Theory, step: Step) -> None:
    """Conclude that a number is positive if an enclosure of it is."""
    polynomial = theory.polynomial(step["polynomial"])
    bits = natural(step["bits"])
    require(0 < bits <= MOST_BITS, "too many bits")
    try:
        enclosure = theory.value(polynomial, bits)
    except UndecidedError:
        raise Rejected("a number cannot be enclosed") from None
    low = enclosure if isinstance(enclosure, Fraction) else enclosure[0]
    require(low > 0, "a number is not positive")
    theory.add(">", polynomial)


def _known(theory: Theory, function: str, *args: Element) -> Element:
    found = theory.named(function, *args)
    if found is None:
        raise Rejected(f"a {function} is not known to be defined")
    return found


def _application(theory: Theory, name: Any, function: str) -> tuple[Element, Element]:
    """Return an application by its name, and its argument."""
    known = theory.applications.get(name)
    if known is None or known.function != function:
        raise Rejected(f"{name!r:.40} is no {function}")
    return theory.variable(name), known.args[0]


def _count(value: Any) -> int:
    require(0 < abs(integer(value)) <= LARGEST, "expected a small integer other than zero")
    return int(value)


def _parts(step: Step) -> list[tuple[int, Any]]:
    parts = step["parts"]
    require(isinstance(parts, list) and len(parts) <= MOST_PARTS, "expected a list of parts")
    return [(_count(count), part) for count, part in parts]


def addition(theory: Theory, step: Step) -> None:
    """Conclude: sin and cos of sum(n*t) are the parts of the product of (cos t + i sin t)**n; i itself for t = pi/2."""
    sin, angle = _application(theory, step["target"], "sin")
    real, imaginary = theory.number(1), theory.number(0)
    for count, text in _parts(step):
        part = theory.read(text)
        if (part + part - theory.pi).is_zero:
            c, s = theory.number(0), theory.number(1)
        else:
            c, s = _known(theory, "cos", part), _known(theory, "sin", part)
        angle = angle - theory.number(count) * part
        for _ in range(abs(count)):
            turned = s if count > 0 else -s
            real, imaginary = real * c - imaginary * turned, real * turned + imaginary * c
    theory.require("=", angle, "addition: the angle minus its parts")
    theory.add("=", sin - imaginary)
    theory.add("=", _known(theory, "cos", _application(theory, step["target"], "sin")[1]) - real)


def exponents(theory: Theory, step: Step) -> None:
    """Conclude: exp of sum(n*u) is the product of exp(u)**n; exp(log p) is p."""
    target, rest = _application(theory, step["target"], "exp")
    above, below = theory.number(1), theory.number(1)
    for count, name in _parts(step):
        known = theory.applications.get(name)
        if known is not None and known.function == "log":
            exponent, power = theory.variable(name), known.args[0]
        else:
            power, exponent = _application(theory, name, "exp")
        rest = rest - theory.number(count) * exponent
        above, below = (above * power**count, below) if count > 0 else (above, below * power**-count)
    theory.require("=", rest, "exponents: the exponent minus its parts")
    theory.add("=", target * below - above)


def logarithms(theory: Theory, step: Step) -> None:
    """Conclude: log of a product of p**n, each p > 0, is sum(n*log p); log(exp u) is u."""
    total, argument = _application(theory, step["target"], "log")
    whole = theory.number(1)
    for count, text in _parts(step):
        part = theory.read(text)
        theory.require(">", part, "logarithms: a factor")
        whole = whole * part**count
        log = _argument_of_exponential(theory, part) or theory.named("log", part)
        if log is None:
            raise Rejected("the logarithm of a factor is not known to be defined")
        total = total - theory.number(count) * log
    theory.require("=", argument - whole, "logarithms: the argument minus the product")
    theory.add("=", total)


def _argument_of_exponential(theory: Theory, part: Element) -> Element | None:
    for name, known in theory.applications.items():
        if known.function == "exp" and (theory.field.symbol(name) - part).is_zero:
            return known.args[0]
    return None


def equal_powers(theory: Theory, step: Step) -> None:
    """Conclude a = b if a**n = b**n and neither a nor b is negative."""
    left, right = theory.read(step["left"]), theory.read(step["right"])
    theory.require(">=", left, "equal powers: the left side")
    theory.require(">=", right, "equal powers: the right side")
    degree = _count(step["degree"])
    require(degree > 0, "expected a positive degree")
    theory.require("=", left**degree - right**degree, "equal powers: the difference of the powers")
    theory.add("=", left - right)


def order_of_powers(theory: Theory, step: Step) -> None:
    """Conclude a >= b if a**n >= b**n and a >= 0, and a > b if a**n > b**n."""
    larger, smaller = theory.read(step["larger"]), theory.read(step["smaller"])
    degree = _count(step["degree"])
    require(degree > 0, "expected a positive degree")
    theory.require(">=", larger, "order of powers: the larger side")
    rise = larger**degree - smaller**degree
    theory.require(">=", rise, "order of powers: the difference of the powers")
    theory.add(">" if theory.holds(">", rise) else ">=", larger - smaller)


def _angle(theory: Theory, step: Step) -> tuple[Element, Element, Element]:
    angle = theory.read(step["angle"])
    return angle, _known(theory, "sin", angle), _known(theory, "cos", angle)


def zero_of_sine(theory: Theory, step: Step) -> None:
    """Conclude F = 0 if sin F = 0 and -pi < F < pi."""
    angle, sin, _ = _angle(theory, step)
    theory.require("=", sin, "the sine")
    theory.require(">", theory.pi - angle, "pi minus the angle")
    theory.require(">", theory.pi + angle, "pi plus the angle")
    theory.add("=", angle)


def full_turn(theory: Theory, step: Step) -> None:
    """Conclude F = 0 if cos F = 1 and -2*pi < F < 2*pi."""
    angle, _, cos = _angle(theory, step)
    turn = theory.number(2) * theory.pi
    theory.require("=", cos - theory.number(1), "the cosine minus 1")
    theory.require(">", turn - angle, "2*pi minus the angle")
    theory.require(">", turn + angle, "2*pi plus the angle")
    theory.add("=", angle)


def sine_in_range(theory: Theory, step: Step) -> None:
    """Conclude sin F > 0 if 0 < F < pi, and sin F >= 0 if 0 <= F <= pi."""
    angle, sin, _ = _angle(theory, step)
    theory.require(">=", angle, "the angle")
    theory.require(">=", theory.pi - angle, "pi minus the angle")
    theory.add(">" if theory.holds(">", angle) and theory.holds(">", theory.pi - angle) else ">=", sin)


def cosine_in_range(theory: Theory, step: Step) -> None:
    """Conclude cos F > 0 if -pi/2 < F < pi/2, and cos F >= 0 if -pi/2 <= F <= pi/2."""
    angle, _, cos = _angle(theory, step)
    sides = [theory.pi - theory.number(2) * angle, theory.pi + theory.number(2) * angle]
    for side in sides:
        theory.require(">=", side, "the distance to a quarter turn")
    theory.add(">" if all(theory.holds(">", side) for side in sides) else ">=", cos)


def range_of_sine(theory: Theory, step: Step) -> None:
    """Conclude 0 < F < pi if sin F > 0 and -pi <= F <= 2*pi, and 0 <= F <= pi if sin F >= 0 and -pi < F < 2*pi."""
    angle, sin, _ = _angle(theory, step)
    sides = [angle + theory.pi, theory.number(2) * theory.pi - angle]
    _in_range(theory, "the sine", sin, sides, [angle, theory.pi - angle])


def range_of_cosine(theory: Theory, step: Step) -> None:
    """Conclude -pi/2 < F < pi/2 if cos F > 0 and -3*pi/2 <= F <= 3*pi/2, and likewise with < and <= exchanged."""
    angle, _, cos = _angle(theory, step)
    double, three = theory.number(2) * angle, theory.number(3) * theory.pi
    _in_range(theory, "the cosine", cos, [three - double, three + double], [theory.pi - double, theory.pi + double])


def _in_range(theory: Theory, about: str, value: Element, asked: Sequence[Element], found: Sequence[Element]) -> None:
    """Add that what is found is positive if a value is, or not negative if a value is and what is asked is positive."""
    strict = theory.holds(">", value)
    theory.require(">=", value, about)
    for side in asked:
        theory.require(">=" if strict else ">", side, "the distance of the angle from the ends of its range")
    for side in found:
        theory.add(">" if strict else ">=", side)


def order_of_sines(theory: Theory, step: Step) -> None:
    """Conclude A > B if sin A > sin B and both A and B are from -pi/2 to pi/2; likewise with >= and =."""
    larger, smaller = (theory.read(step[key]) for key in ("larger", "smaller"))
    for angle in (larger, smaller):
        for side in (theory.pi - theory.number(2) * angle, theory.pi + theory.number(2) * angle):
            theory.require(">=", side, "the distance to a quarter turn")
    rise = _known(theory, "sin", larger) - _known(theory, "sin", smaller)
    theory.require(">=", rise, "the difference of the sines")
    theory.add(next(relation for relation in ("=", ">", ">=") if theory.holds(relation, rise)), larger - smaller)


def sign_function(theory: Theory, step: Step) -> None:
    """Conclude sign u = 1 if u > 0, sign u = -1 if u < 0, and sign u = 0 if u = 0."""
    target, argument = _application(theory, step["target"], "sign")
    for relation, side, found in ((">", argument, 1), (">", -argument, -1), ("=", argument, 0)):
        if theory.holds(relation, side):
            theory.add("=", target - theory.number(found))
            return
    raise Rejected("the sign of the argument is not known")


def strict_bounds(theory: Theory, step: Step) -> None:
    """Conclude sqrt(u) > 0 if u > 0, likewise for other roots.

    Also exp u > 1 + u and 1 > (1 - u)*exp u if u != 0, and log u < u - 1 and u*log u > u - 1 if u != 1.
    """
    known = theory.applications.get(step["target"])
    if known is None or known.function not in ("root", "exp", "log"):
        raise Rejected(f"{step['target']!r:.40} is not a root, exponential or logarithm")
    value, u, one = theory.variable(step["target"]), known.args[0], theory.number(1)
    if known.function == "root":
        theory.require(">", u, "the radicand")
        theory.add(">", value)
    elif known.function == "exp":
        theory.require("!=", u, "the exponent")
        theory.add(">", value - one - u)
        theory.add(">", one - value * (one - u))
    else:
        theory.require("!=", u - one, "the argument minus 1")
        theory.add(">", u - one - value)
        theory.add(">", u * value - u + one)


LAWS: Mapping[str, tuple[Callable[[Theory, Step], None], frozenset[str]]] = {
    "defined": (defined, frozenset({"term"})),
    "follows": (follows, frozenset({"zero", "exponent", "scale", "multiplier", "cofactors"})),
    "sign": (sign, frozenset({"polynomial", "relation", "scale", "multiplier", "sum", "cofactors"})),
    "nonzero": (nonzero, frozenset({"polynomial", "factor", "scale", "multiplier", "cofactors"})),
    "both": (both, frozenset({"polynomial"})),
    "value": (value, frozenset({"polynomial", "bits"})),
    "addition": (addition, frozenset({"target", "parts"})),
    "exponents": (exponents, frozenset({"target", "parts"})),
    "logarithms": (logarithms, frozenset({"target", "parts"})),
    "equal powers": (equal_powers, frozenset({"left", "right", "degree"})),
    "order of powers": (order_of_powers, frozenset({"larger", "smaller", "degree"})),
    "zero of sine": (zero_of_sine, frozenset({"angle"})),
    "full turn": (full_turn, frozenset({"angle"})),
    "sine in range": (sine_in_range, frozenset({"angle"})),
    "cosine in range": (cosine_in_range, frozenset({"angle"})),
    "range of sine": (range_of_sine, frozenset({"angle"})),
    "range of cosine": (range_of_cosine, frozenset({"angle"})),
    "order of sines": (order_of_sines, frozenset({"larger", "smaller"})),
    "strict bounds": (strict_bounds, frozenset({"target"})),
    "sign function": (sign_function, frozenset({"target"})),
}
