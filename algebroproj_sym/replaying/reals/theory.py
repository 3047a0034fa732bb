"""What is known of real numbers: polynomials that are zero, positive, not negative or not zero, and how more follows.

Each application of a function that is not defined by others is a symbol of its own, ``_1``, ``_2``, ..., with the
facts that hold for it wherever it is defined.  A statement may use that it is defined; whatever a proof adds must be
shown to be defined first.
"""

import re
from collections.abc import Iterable
from fractions import Fraction
from functools import reduce
from operator import add
from typing import Any, NamedTuple, Self

from algebroproj_sym.replaying.evaluation import Algebra, evaluate
from algebroproj_sym.replaying.field import Element, Field
from algebroproj_sym.replaying.polynomial import Polynomial, constant, powers_of
from algebroproj_sym.replaying.reals.definitions import expanded
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.terms import Term, read
from algebroproj_sym.replaying.reals.values import Numbers, UndecidedError, UndefinedError
from algebroproj_sym.replaying.rejection import Rejected, require
from algebroproj_sym.replaying.text import parse_polynomial

RESERVED = re.compile(r"_[0-9]+|pi")
"""Names that symbols of a statement cannot have."""


class Fact(NamedTuple):
    """A polynomial that is ``=``, ``!=``, ``>`` or ``>=`` zero."""

    relation: str
    polynomial: Polynomial


class Application(NamedTuple):
    """A function and its arguments; roots have their degree."""

    function: str
    degree: int
    args: tuple[Element, ...]


class Theory:
    """Facts about real numbers, which some symbols stand for.

    `depth` says within how many cases, or proofs of something else, it is.

    Examples
    --------
    >>> theory = Theory(["x"])
    >>> root = theory.term(read("sqrt(x**2 + 1)"), granted=True)
    >>> theory.holds(">=", root)
    True
    """

    def __init__(self, symbols: Iterable[str], depth: int = 0) -> None:
        names = sorted(symbols)
        require(not any(map(RESERVED.fullmatch, names)), "expected symbols other than pi and _1, _2, ...")
        self.depth = depth
        self.field = Field(names)
        self.alive = set(names)
        self.facts: list[Fact] = []
        self.known: set[Fact] = set()
        self.applications: dict[str, Application] = {}
        self.contradictory = False
        self._terms: dict[Term, Element] = {}

    def branch(self) -> Self:
        """Return a copy, for a case."""
        other = object.__new__(type(self))
        other.field, other.contradictory, other.depth = self.field, self.contradictory, self.depth
        other.alive, other.known = set(self.alive), set(self.known)
        other.facts, other.applications = list(self.facts), dict(self.applications)
        other._terms = dict(self._terms)
        return other

    # -- numbers and polynomials

    def number(self, value: Fraction | int) -> Element:
        """Return a rational number."""
        return self.field.number(Fraction(value))

    @property
    def pi(self) -> Element:
        """The number pi, between 3 and 22/7."""
        if "pi" not in self.alive:
            self.alive.add("pi")
            pi = self.field.symbol("pi") if "pi" in self.field.places else self.field.adjoin("pi")
            self.add(">", pi - self.number(3))
            self.add(">", self.number(22) - self.number(7) * pi)
        return self.field.symbol("pi")

    def polynomial(self, text: Any) -> Element:
        """Read a polynomial in what is known to be defined."""
        form = parse_polynomial(text)
        require(not form.shape, "expected a scalar")
        found: Element = evaluate(form, Algebra(self.variable, self.number))[0]
        return found

    def text(self, element: Element) -> str:
        """Return a rational function as text."""
        above = {place: power for place, power in element.exponents.items() if power > 0}
        below = {place: -power for place, power in element.exponents.items() if power < 0}
        text = self.written(element.numerator * self.field.powers(above))
        divisor = self.field.powers(below).scaled(element.denominator)
        return text if divisor == constant(1) else f"({text})/({self.written(divisor)})"

    def written(self, polynomial: Polynomial) -> str:
        """Return a polynomial as text."""
        names = {place: name for name, place in self.field.places.items()}
        terms = []
        for monomial, coefficient in sorted(polynomial.terms.items(), reverse=True):
            factors = [] if abs(coefficient) == 1 and monomial else [str(abs(coefficient))]
            factors += [names[place] if n == 1 else f"{names[place]}**{n}" for place, n in powers_of(monomial)]
            terms.append(("-" if coefficient < 0 else "+", "*".join(factors)))
        text = "".join(f" {sign} {term}" for sign, term in terms)
        return "0" if not terms else text[3:] if terms[0][0] == "+" else f"-{text[3:]}"

    def variable(self, name: str) -> Element:
        """Return a symbol, or an application by its name."""
        if name == "pi":
            return self.pi
        if name not in self.alive:
            raise Rejected(f"{name} is not known here")
        return self.field.symbol(name)

    def symbols(self) -> set[str]:
        """Return the symbols, without those that stand for applications."""
        return {name for name in self.field.places if not RESERVED.fullmatch(name)}

    # -- facts

    def signed(self, element: Element, *, parity: bool = True) -> Polynomial:
        """Return a polynomial with the sign of an element, or only zero where that is, without a positive content."""
        if not element.numerator:
            return element.numerator
        numerator, powers = element.cancelled()
        kept = {place: power if power > 0 else -power % 2 * parity for place, power in powers.items() if power}
        whole = numerator * self.field.powers({place: power for place, power in kept.items() if power})
        return whole.divided(abs(whole.content()))

    def fact(self, relation: str, element: Element) -> Fact:
        """Return a fact in its one form."""
        polynomial = self.signed(element, parity=relation in (">", ">="))
        if relation in ("=", "!=") and polynomial and polynomial.content() < 0:
            polynomial = -polynomial
        return Fact(relation, polynomial)

    def add(self, relation: str, element: Element) -> None:
        """Enter what is known to hold."""
        fact = self.fact(relation, element)
        if fact.polynomial.is_constant():
            self.contradictory = self.contradictory or not _constant_holds(fact)
        elif fact not in self.known:
            self.known.add(fact)
            self.facts.append(fact)

    def holds(self, relation: str, element: Element) -> bool:
        """Whether something is known to hold, as it stands."""
        fact = self.fact(relation, element)
        if fact.polynomial.is_constant():
            return _constant_holds(fact)
        polynomial = fact.polynomial
        if relation == "!=":
            return any(one in self.known for one in (fact, Fact(">", polynomial), Fact(">", -polynomial)))
        if fact in self.known:
            return True
        weak = Fact(">=", polynomial) in self.known
        if relation == ">":
            return weak and self.holds("!=", element)
        return relation == ">=" and (Fact(">", polynomial) in self.known or self.holds("=", element))

    def require(self, relation: str, element: Element, about: str) -> None:
        """Reject what is not known to hold."""
        if not self.holds(relation, element):
            raise Rejected(f"{about}: it is not known that it is {relation} 0")

    # -- terms

    def read(self, text: Any) -> Element:
        """Read a term, which must be known to be defined."""
        return self.term(read(text))

    def term(self, term: Term, granted: bool = False) -> Element:
        """Return a term as a rational function of symbols and applications.

        What must hold for it to be defined is entered if it is granted, and else required.
        """
        found = self._terms.get(term)
        if found is None:
            found = self._terms[term] = self._made(term, granted)
        return found

    def _ask(self, relation: str, element: Element, about: str, granted: bool) -> None:
        if granted:
            self.add(relation, element)
        else:
            self.require(relation, element, about)

    def _made(self, term: Term, granted: bool) -> Element:
        kind = term.kind
        if kind == "number":
            return self.number(term.value)
        if kind in ("symbol", "pi"):
            return self.variable(term.value or "pi")
        definition, asked = expanded(term)
        for relation, part in asked:
            self._ask(relation, self.term(part, granted), f"the argument of {kind}", granted)
        if definition is not term:
            return self.term(definition, granted)
        args = [self.term(part, granted) for part in term.args]
        if kind == "+":
            return reduce(add, args)
        if kind == "-":
            return -args[0]
        if kind == "*":
            return args[0] * args[1]
        if kind == "/":
            self._divisor(args[1], granted)
            return self._divided(args[0], term.args[1])
        if kind == "^":
            return self._power(args[0], term.value, granted)
        return self.applied(kind, *args, granted=granted)

    def _divisor(self, element: Element, granted: bool) -> Element:
        require(not element.is_zero, "a divisor is zero")
        self._ask("!=", element, "a divisor", granted)
        return element

    def _divided(self, value: Element, divisor: Term) -> Element:
        """Return a quotient by a divisor, factor by factor as it is written: so the sign of x/a**2 is that of x."""
        if divisor.kind == "*":
            return self._divided(self._divided(value, divisor.args[0]), divisor.args[1])
        if divisor.kind == "^" and divisor.value > 0 and divisor.value.denominator == 1:
            return value * self.term(divisor.args[0]) ** -int(divisor.value)
        return value / self.term(divisor)

    def _power(self, base: Element, exponent: Fraction, granted: bool) -> Element:
        if exponent.denominator > 1:
            base = self.applied("root", base, degree=exponent.denominator, granted=granted)
        if exponent <= 0:
            base = self._divisor(base, granted)
        return base**exponent.numerator

    def named(self, function: str, *args: Element, degree: int = 0) -> Element | None:
        """Return an application that is known to be defined, None if it is not."""
        for name, known in self.applications.items():
            if (known.function, known.degree) == (function, degree) and all(
                (a - b).is_zero for a, b in zip(known.args, args, strict=True)
            ):
                return self.field.symbol(name)
        return None

    def applied(self, function: str, *args: Element, degree: int = 0, granted: bool = False) -> Element:
        """Return an application of a function, with the facts that belong to it."""
        return self.named(function, *args, degree=degree) or self._new(Application(function, degree, args), granted)

    def _new(self, application: Application, granted: bool) -> Element:
        function, degree, args = application
        u, one = args[0], self.number(1)
        if function == "root":
            self._ask(">=", u, "a radicand", granted)
        elif function == "log":
            self._ask(">", u, "the argument of a logarithm", granted)
        elif function == "asin":
            self._ask(">=", one - u * u, "1 minus the square of a sine", granted)
        elif function == "atan2":
            self._ask("!=", u * u + args[1] * args[1], "the square of a radius", granted)
        elif function not in ("sin", "cos", "exp", "atan", "sign"):
            raise Rejected(f"there is no function {function!r}")
        if function == "cos":
            self.applied("sin", u)
            found = self.named("cos", u)
            assert found is not None
            return found
        symbol = self._symbol(application)
        getattr(self, f"_facts_of_{function}")(symbol, *args, *([degree] if degree else []))
        return symbol

    def _symbol(self, application: Application) -> Element:
        name = f"_{len(self.applications) + 1}"
        self.applications[name] = application
        self.alive.add(name)
        return self.field.symbol(name) if name in self.field.places else self.field.adjoin(name)

    # -- what holds for each function wherever it is defined

    def _facts_of_root(self, root: Element, u: Element, degree: int) -> None:
        self.add(">" if self.holds(">", u) else ">=", root)
        self.add("=", root**degree - u)

    def _facts_of_sin(self, sin: Element, u: Element) -> None:
        cos = self._symbol(Application("cos", 0, (u,)))
        self.add("=", sin * sin + cos * cos - self.number(1))

    def _facts_of_exp(self, exp: Element, u: Element) -> None:
        one = self.number(1)
        self.add(">", exp)
        self.add(">=", exp - one - u)
        self.add(">=", one - exp * (one - u))

    def _facts_of_log(self, log: Element, u: Element) -> None:
        one = self.number(1)
        self.add(">=", u - one - log)
        self.add(">=", u * log - u + one)

    def _facts_of_sign(self, sign: Element, u: Element) -> None:
        self.add("=", sign**3 - sign)
        self.add("=", u * (sign * sign - self.number(1)))
        self.add(">=", u * sign)

    def _arc(self, arc: Element) -> tuple[Element, Element]:
        return self.applied("sin", arc), self.applied("cos", arc)

    def _facts_of_asin(self, arc: Element, u: Element) -> None:
        sin, cos = self._arc(arc)
        two = self.number(2)
        self.add("=", sin - u)
        self.add(">=", cos)
        self.add(">=", self.pi - two * arc)
        self.add(">=", self.pi + two * arc)

    def _facts_of_atan(self, arc: Element, u: Element) -> None:
        sin, cos = self._arc(arc)
        two = self.number(2)
        self.add("=", sin - u * cos)
        self.add(">", cos)
        self.add(">", self.pi - two * arc)
        self.add(">", self.pi + two * arc)

    def _facts_of_atan2(self, arc: Element, y: Element, x: Element) -> None:
        sin, cos = self._arc(arc)
        self.add("=", y * cos - x * sin)
        self.add(">", x * cos + y * sin)
        self.add("=", (x * cos + y * sin) ** 2 - x * x - y * y)
        self.add(">=", self.pi - arc)
        self.add(">", self.pi + arc)

    # -- values

    def value(self, element: Element, bits: int) -> Any:
        """Return an enclosure of a number."""
        numbers, found = Intervals(bits), dict[str, Any]()
        return self._enclosed(element, numbers, found)

    def _enclosed(self, element: Element, numbers: Numbers, found: dict[str, Any]) -> Any:
        total = self._at(element.numerator, numbers, found)
        for place, power in element.exponents.items():
            factor = numbers.raised(self._at(self.field.factors[place], numbers, found), abs(power))
            total = numbers.operation("times" if power > 0 else "over", total, factor)
        return numbers.operation("times", total, Fraction(1, element.denominator))

    def _at(self, polynomial: Polynomial, numbers: Numbers, found: dict[str, Any]) -> Any:
        names = {place: name for name, place in self.field.places.items()}
        total: Any = Fraction(0)
        for monomial, coefficient in polynomial.terms.items():
            term: Any = Fraction(coefficient)
            for place, power in powers_of(monomial):
                value = self._number_of(names[place], numbers, found)
                term = numbers.operation("times", term, numbers.raised(value, power))
            total = numbers.operation("plus", total, term)
        return total

    def _number_of(self, name: str, numbers: Numbers, found: dict[str, Any]) -> Any:
        if name not in found:
            found[name] = self._computed(name, numbers, found)
        return found[name]

    def _computed(self, name: str, numbers: Numbers, found: dict[str, Any]) -> Any:
        if name == "pi":
            return numbers.pi()
        require(name in self.applications, f"{name} is not a number")
        function, degree, args = self.applications[name]
        values = [self._enclosed(arg, numbers, found) for arg in args]
        try:
            if function == "root":
                return numbers.root(values[0], degree)
            return numbers.atan2(*values) if function == "atan2" else numbers.applied(function, values[0])
        except (UndecidedError, UndefinedError):
            raise Rejected("a number cannot be enclosed") from None


def _constant_holds(fact: Fact) -> bool:
    value = fact.polynomial.terms.get(0, 0)
    return {"=": value == 0, "!=": value != 0, ">": value > 0, ">=": value >= 0}[fact.relation]
