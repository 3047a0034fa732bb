"""Functions of many arguments in terms of few: addition theorems, products of powers, factors of radicands.

Arguments are taken apart into monomials over a denominator.  What has the same monomial gets one common argument, of
which the others are multiples.
"""

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from algebroproj_sym.proving.consequences import End
from algebroproj_sym.proving.polynomials import by_degree, content_of
from algebroproj_sym.proving.reals.knowledge import Knowledge, rational_gcd
from algebroproj_sym.proving.reals.rewriting import reduced_by
from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.polynomial import Polynomial

Key = tuple[int, tuple[tuple[int, int], ...]]
"""A monomial, and the exponents of what it is divided by."""

MOST_MULTIPLES = 40
MOST_REWRITINGS = 600
PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47)


def normalised(knowledge: Knowledge) -> None:
    """Relate all applications that there are."""
    logarithms(knowledge)
    exponentials(knowledge)
    angles(knowledge)
    roots(knowledge)


def _monomials(knowledge: Knowledge, element: Element) -> dict[Key, Fraction]:
    """Return the coefficients of an argument, by monomial."""
    numerator, powers = element.cancelled()
    numerator = numerator * knowledge.theory.field.powers({place: n for place, n in powers.items() if n > 0})
    below = tuple(sorted((place, n) for place, n in powers.items() if n < 0))
    return {(monomial, below): Fraction(value, element.denominator) for monomial, value in numerator.terms.items()}


def _element(knowledge: Knowledge, key: Key, value: Fraction) -> Element:
    monomial, below = key
    return Element(knowledge.theory.field, Polynomial({monomial: value.numerator}), dict(below), value.denominator)


def _of(knowledge: Knowledge, function: str) -> list[tuple[str, Element]]:
    found = knowledge.theory.applications.items()
    return [(name, known.args[0]) for name, known in found if known.function == function]


def _bases(knowledge: Knowledge, arguments: Iterable[Element]) -> dict[Key, Fraction]:
    """Return the largest number of which all coefficients of a monomial are multiples."""
    found: dict[Key, list[Fraction]] = {}
    for argument in arguments:
        for key, value in _monomials(knowledge, argument).items():
            found.setdefault(key, []).append(value)
    return {key: rational_gcd(values) for key, values in found.items()}


def angles(knowledge: Knowledge) -> None:
    """Express sine and cosine of all angles by those of common parts."""
    originals = dict(_of(knowledge, "sin"))
    targets = [(name, knowledge.settled(angle)) for name, angle in originals.items()]
    if not targets:
        return
    theory = knowledge.theory
    bases = _bases(knowledge, (angle for _, angle in targets))
    turn = None if "pi" not in theory.alive else (theory.pi.numerator.terms.copy().popitem()[0], ())
    if turn in bases:
        half = (2 * bases[turn]).denominator == 1
        bases[turn] = Fraction(1, 2) if half else Fraction(1, bases[turn].denominator)
    parts = {key: _element(knowledge, key, base) for key, base in bases.items()}
    for key, part in parts.items():
        if key != turn or bases[key] != Fraction(1, 2):
            knowledge.step("defined", term=f"sin({knowledge.said(part)})")
    if turn in bases and bases[turn] != Fraction(1, 2):
        _special(knowledge, int(1 / bases[turn]))
    for name, angle in targets:
        counts = {key: value / bases[key] for key, value in _monomials(knowledge, angle).items()}
        if max(map(abs, counts.values()), default=0) > MOST_MULTIPLES or (
            _is_base(counts, bases, turn) and (angle - originals[name]).is_zero
        ):
            continue
        ordered = [[int(count), knowledge.said(parts[key])] for key, count in counts.items()]
        knowledge.step("addition", target=name, parts=ordered)


def _is_base(counts: Mapping[Key, Fraction], bases: Mapping[Key, Fraction], turn: Key | None) -> bool:
    if len(counts) != 1 or {*counts.values()} != {Fraction(1)}:
        return False
    key = next(iter(counts))
    return key != turn or bases[key] != Fraction(1, 2)


def _special(knowledge: Knowledge, count: int) -> None:
    """Find the polynomials of cosine and sine of pi over a number."""
    theory = knowledge.theory
    base = f"pi/{count}"
    knowledge.step("defined", term="sin(pi)")
    sin, cos = (theory.named(name, theory.pi * theory.number(Fraction(1, count))) for name in ("sin", "cos"))
    name = knowledge.called("sin", theory.pi)
    if sin is None or cos is None or not name:
        return
    knowledge.step("addition", target=name, parts=[[2, "pi/2"]])
    knowledge.step("addition", target=name, parts=[[count, base]])
    knowledge.value(sin)
    _minimal(knowledge, cos, 2 * count)


def _minimal(knowledge: Knowledge, number: Element, order: int) -> None:
    """Show the least equation of the cosine of pi/n: a factor of T_2n(c) = 1.

    T_m is the Chebyshev polynomial, with T_m(cos t) = cos(m*t).  The other factors are not zero.
    """
    x = knowledge.into(number.numerator)
    before, chebyshev = x**0, x
    for _ in range(order - 1):
        before, chebyshev = chebyshev, 2 * x * chebyshev - before
    whole = knowledge.back(chebyshev - 1)
    reduced = reduced_by(chebyshev - 1, knowledge.rules(chebyshev), MOST_REWRITINGS)
    if reduced is None or reduced[0] != 0 or not knowledge.follows(chebyshev - 1, End(1, x**0, reduced[1])):
        return
    place = knowledge.theory.facts.index(knowledge.theory.fact("=", whole))
    others = x**0
    for factor, multiplicity in knowledge.into(knowledge.theory.facts[place].polynomial).factor()[1]:
        element = knowledge.back(factor)
        if not knowledge.is_apart(element):
            least, power = factor, multiplicity
        elif knowledge.value(element) or knowledge.value(-element):
            others = others * factor**multiplicity
    scale = knowledge.into(knowledge.theory.facts[place].polynomial).leading_coefficient() / (
        (others * least**power).leading_coefficient()
    )
    knowledge.follows(least, End(power, others * scale, {place: x**0}))


def exponentials(knowledge: Knowledge) -> None:
    """Express exponentials by those of common parts; those of logarithms are their arguments."""
    targets = _of(knowledge, "exp")
    if not targets:
        return
    theory = knowledge.theory
    for name, exponent in targets:
        same = knowledge.settled(exponent)
        if not (same - exponent).is_zero and knowledge.step("defined", term=f"exp({knowledge.said(same)})"):
            knowledge.step("exponents", target=name, parts=[[1, knowledge.called("exp", same)]])
    targets = [(n, e) for n, e in _of(knowledge, "exp") if (knowledge.settled(e) - e).is_zero]
    logs = {next(iter(theory.field.symbol(name).numerator.terms)): name for name, _ in _of(knowledge, "log")}
    bases = _bases(knowledge, (exponent for _, exponent in targets))
    names: dict[Key, str] = {}
    for key, base in bases.items():
        if key[0] in logs and not key[1] and base.denominator == 1:
            bases[key], names[key] = Fraction(1), logs[key[0]]
        else:
            part = _element(knowledge, key, base)
            knowledge.step("defined", term=f"exp({knowledge.said(part)})")
            names[key] = knowledge.called("exp", part)
            if key[0] in logs and not key[1]:
                whole = _element(knowledge, key, Fraction(1))
                knowledge.step("defined", term=f"exp({knowledge.said(whole)})")
                if log := knowledge.called("exp", whole):
                    knowledge.step("exponents", target=log, parts=[[1, logs[key[0]]]])
                    knowledge.step("exponents", target=log, parts=[[int(1 / base), names[key]]])
                    _exponential_is_root(knowledge, names[key], logs[key[0]], int(1 / base))
    for name, exponent in targets:
        counts = {key: value / bases[key] for key, value in _monomials(knowledge, exponent).items()}
        if (max(map(abs, counts.values()), default=0) <= MOST_MULTIPLES and [*counts.values()] != [1]) or any(
            theory.applications[names[key]].function == "log" for key in counts
        ):
            knowledge.step("exponents", target=name, parts=[[int(n), names[key]] for key, n in counts.items()])


def _exponential_is_root(knowledge: Knowledge, exponential: str, log: str, degree: int) -> None:
    """Find that exp of a part of log p is a root of p."""
    theory = knowledge.theory
    argument, value = theory.applications[log].args[0], theory.field.symbol(exponential)
    if degree > 1 and knowledge.zero(value**degree - argument) and (root := _root_of(knowledge, argument, degree)):
        knowledge.step("equal powers", left=exponential, right=knowledge.said(root), degree=degree)


def factors(knowledge: Knowledge, element: Element) -> tuple[Fraction, list[tuple[Any, int]]]:
    """Return the number, and the irreducible polynomials with their powers, of which an element is the product."""
    theory = knowledge.theory
    above = knowledge.into(element.numerator)
    number, found = Fraction(1, element.denominator), dict[str, tuple[Any, int]]()
    pieces = [(above, 1), *((knowledge.into(theory.field.factors[p]), n) for p, n in element.exponents.items())]
    for polynomial, power in pieces:
        content, parts = polynomial.factor()
        number *= Fraction(int(content.p), int(content.q)) ** power
        for part, multiplicity in parts:
            scale = content_of(part)
            number *= Fraction(int(scale.p), int(scale.q)) ** (multiplicity * power)
            own = part / scale
            known = found.get(str(own), (own, 0))[1]
            found[str(own)] = own, known + multiplicity * power
    return number, [(own, power) for own, power in found.values() if power]


def primes(number: Fraction) -> list[tuple[int, int]]:
    """Return a positive number as powers of small primes, and of what is left."""
    found = []
    for value, sign in ((number.numerator, 1), (number.denominator, -1)):
        for prime in PRIMES:
            power = 0
            while value % prime == 0:
                value, power = value // prime, power + 1
            if power:
                found.append((prime, sign * power))
        if value != 1:
            found.append((value, sign))
    return found


def logarithms(knowledge: Knowledge) -> None:
    """Express logarithms by those of irreducible factors."""
    done = set[str]()
    while pending := [(name, argument) for name, argument in _of(knowledge, "log") if name not in done]:
        for name, argument in pending:
            done.add(name)
            if len(done) < 40:
                _logarithm(knowledge, name, argument)


def _logarithm(knowledge: Knowledge, name: str, argument: Element) -> None:
    theory = knowledge.theory
    number, parts = factors(knowledge, argument)
    listed, negative = list[list[Any]](), number < 0
    left: Element | None = None
    for polynomial, power in parts:
        element = knowledge.back(polynomial)
        sign = knowledge.sign(element)
        if sign == "<":
            element, negative = -element, negative ^ (power % 2 == 1)
        elif sign != ">":
            knowledge.want(polynomial)
            left = element**power if left is None else left * element**power
            continue
        listed.append([power, element])
    if negative and left is not None:
        left, negative = -left, False
    if negative or (left is not None and ((not listed and abs(number) == 1) or not knowledge.positive(left, True))):
        return
    if left is not None:
        listed.append([1, left])
    listed += [[power, theory.number(prime)] for prime, power in primes(abs(number))]
    if len(listed) == 1 and listed[0][0] == 1 and (listed[0][1] - argument).is_zero:
        if _is_exponential(knowledge, argument):
            knowledge.step("logarithms", target=name, parts=[[1, knowledge.said(argument)]])
        _logarithm_of_root(knowledge, argument)
        return
    for _, part in listed:
        if not _is_exponential(knowledge, part):
            knowledge.step("defined", term=f"log({knowledge.said(part)})")
    knowledge.step("logarithms", target=name, parts=[[n, knowledge.said(part)] for n, part in listed])


def _is_exponential(knowledge: Knowledge, part: Element) -> bool:
    return any((knowledge.theory.field.symbol(name) - part).is_zero for name, _ in _of(knowledge, "exp"))


def _logarithm_of_root(knowledge: Knowledge, part: Element) -> None:
    theory = knowledge.theory
    for name, known in [*theory.applications.items()]:
        if known.function == "root" and (theory.field.symbol(name) - part).is_zero:
            radicand = known.args[0]
            if knowledge.positive(radicand, True) and knowledge.step(
                "defined", term=f"log({knowledge.said(radicand)})"
            ):
                target = knowledge.called("log", radicand)
                knowledge.step("logarithms", target=target, parts=[[known.degree, knowledge.said(part)]])


def roots(knowledge: Knowledge) -> None:
    """Express roots by those of irreducible factors whose sign is known."""
    done = set[str]()
    while True:
        theory = knowledge.theory
        pending = [name for name, known in theory.applications.items() if known.function == "root" and name not in done]
        if not pending or len(done) > 30:
            return
        for name in pending:
            done.add(name)
            known = knowledge.theory.applications[name]
            _root(knowledge, name, known.args[0], known.degree)


def _root(knowledge: Knowledge, name: str, radicand: Element, degree: int) -> None:
    theory = knowledge.theory
    root = theory.field.symbol(name)
    if knowledge.zero(radicand):
        knowledge.zero(root)
        return
    if not radicand.numerator.is_constant() and knowledge.is_number(knowledge.into(radicand.numerator)):
        return
    for form in _forms(knowledge, radicand):
        value = _rooted(knowledge, form, degree)
        if value is None or (value - root).is_zero:
            continue
        if knowledge.zero(value**degree - root**degree) and knowledge.positive(value):
            knowledge.step("equal powers", left=name, right=knowledge.said(value), degree=degree)
            return


def _forms(knowledge: Knowledge, radicand: Element) -> list[Element]:
    """Return a radicand with the squares of all sines replaced, or of all cosines, or of none; likewise roots."""
    theory = knowledge.theory
    below = theory.field.powers({p: -n for p, n in radicand.exponents.items() if n < 0})
    numerator = knowledge.into(
        radicand.numerator * theory.field.powers({p: n for p, n in radicand.exponents.items() if n > 0})
    )
    divisor = theory.field.element(below.scaled(radicand.denominator))
    found = [radicand]
    rules = [_squares(knowledge, main) for main in ("none", "sin", "cos")] + [_radicands(knowledge)]
    for rule in rules:
        form = numerator
        for _ in range(6):
            before = form
            for square, value in rule:
                form = _replaced(form, square, value)
            if form == before or len(form) > 200:
                break
        if form != 0:
            candidate = knowledge.back(form) / divisor
            if not any((candidate - other).is_zero for other in found):
                found.append(candidate)
    return sorted(found, key=lambda form: len(form.numerator.terms))


def _squares(knowledge: Knowledge, main: str) -> list[tuple[tuple[int, int], Any]]:
    """Return what takes the place of a power of a variable: that of a root, and the square of a sine or a cosine."""
    theory, found = knowledge.theory, list[tuple[tuple[int, int], Any]]()
    for name, known in theory.applications.items():
        place = theory.field.places[name]
        one = knowledge.context.constant(1)
        if known.function == "root" and not known.args[0].exponents and known.args[0].denominator == 1:
            found.append(((place, known.degree), knowledge.into(known.args[0].numerator)))
        if known.function == main and main in ("sin", "cos"):
            other = theory.named("cos" if main == "sin" else "sin", known.args[0])
            assert other is not None
            found.append(((place, 2), one - knowledge.into(other.numerator) ** 2))
    for _, zero in knowledge.facts("=") if main != "none" else ():
        found += _linear(knowledge, zero)
    return found


def _radicands(knowledge: Knowledge) -> list[tuple[tuple[int, int], Any]]:
    """Return what symbols are in terms of roots whose radicands are of first degree in them."""
    theory, found = knowledge.theory, dict[int, Any]()
    for name, known in theory.applications.items():
        if known.function == "root" and not known.args[0].exponents:
            radicand, power = known.args[0], theory.field.symbol(name) ** known.degree
            for symbol in sorted(theory.symbols()):
                place = theory.field.places[symbol]
                polynomial = knowledge.into(radicand.numerator)
                slope = polynomial.derivative(place)
                if slope != 0 and slope.is_constant():
                    zero = knowledge.into((power - radicand).numerator)
                    found.setdefault(
                        place, knowledge.context.gens()[place] - zero / zero.derivative(place).leading_coefficient()
                    )
                    break
    return [((place, 1), value) for place, value in found.items()]


def _linear(knowledge: Knowledge, polynomial: Any) -> list[tuple[tuple[int, int], Any]]:
    """Return the value of an application that a zero gives, if it is one times it plus others."""
    theory = knowledge.theory
    places = [theory.field.places[name] for name, known in theory.applications.items() if known.function != "root"]
    for place in places:
        if int(polynomial.degrees()[place]) == 1:
            slope = polynomial.derivative(place)
            if slope.is_constant():
                return [((place, 1), knowledge.context.gens()[place] - polynomial / slope.leading_coefficient())]
    return []


def _replaced(polynomial: Any, power: tuple[int, int], value: Any) -> Any:
    """Return a polynomial with a value for a power of a variable."""
    place, degree = power
    if int(polynomial.degrees()[place]) < degree:
        return polynomial
    gen = polynomial.context().gens()[place]
    parts = by_degree(polynomial, place).items()
    return sum((part * value ** (n // degree) * gen ** (n % degree) for n, part in parts), polynomial * 0)


def _rooted(knowledge: Knowledge, radicand: Element, degree: int) -> Element | None:
    """Return the product of the roots of the factors of a radicand; None if their signs are not known."""
    theory = knowledge.theory
    number, parts = factors(knowledge, radicand)
    value, negative = theory.number(1), number < 0
    left: Element | None = None
    split = len(parts) != 1 or any(abs(power) >= degree for _, power in parts) or abs(number) != 1
    if not split:
        return None
    for polynomial, power in parts:
        element = knowledge.back(polynomial)
        inside, outside = power % degree, power // degree
        sign = knowledge.sign(element)
        if sign is None:
            if inside == 0 and outside % 2 == 0:
                sign = ">"
            else:
                knowledge.want(polynomial)
                if outside:
                    return None
                left = element if left is None else left * element
                continue
        if sign.startswith("<"):
            element = -element
            negative ^= power % 2 == 1
        if sign == "=" or (power < 0 and not knowledge.nonzero(knowledge.into(element.numerator))):
            return None
        if outside:
            value = value * element**outside
        if inside:
            part = _root_of(knowledge, element, degree)
            if part is None:
                return None
            value = value * part**inside
    if left is not None and negative:
        left, negative = -left, False
    if negative:
        return None
    if left is not None:
        part = _root_of(knowledge, left, degree) if knowledge.positive(left) else None
        if part is None:
            return None
        value = value * part
    for prime, power in primes(abs(number)):
        if power // degree:
            value = value * theory.number(Fraction(prime) ** (power // degree))
        if power % degree:
            part = _root_of(knowledge, theory.number(prime), degree)
            assert part is not None
            value = value * part ** (power % degree)
    return value


def _root_of(knowledge: Knowledge, radicand: Element, degree: int) -> Element | None:
    """Return the root of something that is shown to have one."""
    if not knowledge.step("defined", term=f"({knowledge.said(radicand)})**(1/{degree})"):
        return None
    return knowledge.theory.named("root", radicand, degree=degree)
