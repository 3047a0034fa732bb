"""What follows from constraints: whether the evidence shows that two sides are equal wherever the constraints hold.

A proof lists claims (the numerators of the difference), generators (those of the constraints) and
units (factors of what does not vanish).  Where no translation along some directions changes any of them, they are taken
at the origin of these directions.  There, steps add to what is zero and what is not, each by an identity of its own:
those before all entries, and those of an entry.  At the end a power of the claim, times units, is a combination of what
is zero, directly or in each of two cases, in one of which something is zero that is not zero in the other.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, Self, TypeAlias

from algebroproj_sym.replaying.evaluation import Algebra, at_point, derivatives, evaluate
from algebroproj_sym.replaying.field import Element, Field
from algebroproj_sym.replaying.polynomial import Polynomial, constant
from algebroproj_sym.replaying.rejection import require, require_keys
from algebroproj_sym.replaying.residues import Residue, extension
from algebroproj_sym.replaying.text import Form, natural, number, parse, parse_polynomial, texts

Sides: TypeAlias = Callable[[Algebra], tuple[list[Any], list[Any]]]

NEEDED = frozenset({"method", "denominators", "claims", "generators", "units", "entries", "witness"})
OPTIONAL = frozenset({"steps", "translations", "extension"})


@dataclass(frozen=True)
class Question:
    """Whether two sides are equal."""

    sides: Sides
    """Gives the entries of both sides in an algebra."""
    constraints: list[Form]
    nonzero: list[Form]
    """What is zero, and what is not."""
    symbols: set[str]
    """All symbols."""
    hypotheses: Any
    """What does not vanish either, as the record has it."""

    def difference(self, field: Field) -> list[Element]:
        """Return the difference of the sides, entry by entry."""
        return [a - b for a, b in zip(*self.sides(field.algebra), strict=True)]

    def sides_at(
        self, given: Mapping[str, Any], numbers: Algebra, divisors: Sequence[Form] = ()
    ) -> tuple[list[Any], list[Any]]:
        """Return both sides at a point, at which the hypotheses must hold."""
        require(
            given.keys() == self.symbols,
            "the point must give a value to every symbol of the statement, and to no other",
        )
        point = {name: number_of(text, numbers) for name, text in given.items()}
        algebra = Algebra(point.__getitem__, numbers.number)
        constraints = (evaluate(form, algebra)[0] for form in self.constraints)
        require(all(map(is_zero, constraints)), "the point violates a constraint")
        units = (evaluate(form, algebra)[0] for form in (*self.nonzero, *divisors))
        require(not any(map(is_zero, units)), "a form that must not be zero is zero at the point")
        return self.sides(algebra)


def is_zero(value: Any) -> bool:
    """Whether a number, which may lie in an extension, or a rational function is zero."""
    return value.is_zero if isinstance(value, Residue | Element) else bool(value == 0)


def numbers_of(certificate: Mapping[str, Any]) -> Algebra:
    """Return the numbers of the points of a certificate: rational, or in an extension with a real root r."""
    return extension(certificate["extension"]) if "extension" in certificate else at_point({})


def number_of(text: Any, numbers: Algebra) -> Any:
    """Return a coordinate of a point."""
    form = parse(text)
    require(not form.shape, "expected a number")
    return evaluate(form, numbers)[0]


def require_divisors(hypotheses: Any, field: Field, divisors: Any) -> None:
    """Require that the hypotheses are the listed divisors, and that these are those of the text of the statement."""
    require(hypotheses == divisors, "the hypotheses differ from the divisors of the certificate")
    field.require_listed()


@dataclass(frozen=True)
class _Known:
    """What is zero, what is not, and the claim that is left, all at the origin."""

    field: Field
    moved: frozenset[int]
    zeros: tuple[Element, ...]
    units: tuple[Element, ...]
    claim: Element

    def read(self, text: Any) -> Element:
        """Return the text of a polynomial, at the origin."""
        return _restricted(self.field.polynomial(text), self.moved)

    def combined(self, cofactors: Any) -> Element:
        """Return the sum of cofactors, by place, times what is zero."""
        total = self.field.number(Fraction(0))
        for place, text in cofactors.items():
            require(
                place.isascii() and place.isdecimal() and int(place) < len(self.zeros),
                "a cofactor belongs to nothing that is zero",
            )
            total = total + self.read(text) * self.zeros[int(place)]
        return total

    def multiplier(self, text: Any) -> Element:
        """Return a polynomial that is a product of what does not vanish."""
        value = self.read(text)
        require(_is_product(value, self.units), "a multiplier is not a product of forms that are known not to be zero")
        return value

    def with_zero(self, zero: Element) -> Self:
        return replace(self, zeros=(*self.zeros, zero))

    def with_unit(self, unit: Element) -> Self:
        return replace(self, units=(*self.units, unit))


def require_consequence(question: Question, certificate: Mapping[str, Any]) -> None:
    """Reject a certificate that does not show that the sides are equal where the constraints hold."""
    method = certificate["method"]
    require(
        method == _method_of(certificate),
        f"the certificate says {method!r}, but its steps are those of another method",
    )
    require_keys(certificate, NEEDED, OPTIONAL)
    require(bool(question.constraints), "there are no constraints")
    field = Field(question.symbols, certificate["denominators"])
    algebra = field.algebra
    claims = _numerators(field, certificate["claims"], question.difference(field))
    constraints = [evaluate(form, algebra)[0] for form in question.constraints]
    generators = _numerators(field, certificate["generators"], constraints)
    sources = [*field.factors[: field.listed], *(unit.numerator for unit in field.units(question.nonzero))]
    require_divisors(question.hypotheses, field, certificate["denominators"])
    moved = _moved(question, field, certificate)
    units = [_restricted(Element(field, source, {}, 1), moved) for source in sources]
    zero = field.number(Fraction(0))
    known = _Known(field, moved, tuple(_restricted(part, moved) for part in generators), tuple(units), zero)
    for text in texts(certificate["units"]):
        unit = known.read(text)
        require(
            any(_divides(unit, source) for source in units),
            "a listed unit divides none of the forms that must not be zero",
        )
        known = known.with_unit(unit)
    steps = certificate.get("steps", [])
    require(not any("goal" in step for step in steps), "a step before the entries changes the goal of an entry")
    known = _after_steps(known, steps)
    require(
        len(certificate["entries"]) == len(claims), "the certificate and the statement differ in the number of entries"
    )
    for claim, entry in zip(claims, certificate["entries"], strict=True):
        require_keys(entry, _keys_of_case(entry), {"steps"})
        _require_case(replace(known, claim=_restricted(claim, moved)), entry)
    divisors = [*map(parse_polynomial, certificate["denominators"])]
    left, right = question.sides_at(certificate["witness"], numbers_of(certificate), divisors)
    require(all(is_zero(a - b) for a, b in zip(left, right, strict=True)), "the two sides differ at the witness")


def _method_of(certificate: Mapping[str, Any]) -> str:
    """Return what a certificate is called."""
    entries = certificate["entries"]
    if any("cases" in entry for entry in entries):
        return "case distinction"
    if any("squares" in step for part in (certificate, *entries) for step in part.get("steps", ())):
        return "sums of squares"
    return "radical membership" if any(entry["exponent"] > 1 for entry in entries) else "ideal membership"


def _numerators(field: Field, given: Any, elements: Sequence[Element]) -> list[Element]:
    """Return polynomials that are zero exactly where the elements are, the listed divisors not being zero."""
    listed = texts(given)
    require(len(listed) == len(elements), "the certificate and the statement differ in the number of numerators")
    found = [field.polynomial(text) for text in listed]
    for numerator, element in zip(found, elements, strict=True):
        first, second = (_essence(field, part.numerator) for part in (numerator, element))
        require(first in (second, -second), "the numerators differ from those of the statement")
    return found


def _essence(field: Field, polynomial: Polynomial) -> Polynomial:
    """Return a primitive polynomial without listed divisors."""
    return _without(polynomial, field.factors[: field.listed]) if polynomial else polynomial


def _without(polynomial: Polynomial, factors: Iterable[Polynomial]) -> Polynomial:
    rest = polynomial.divided(polynomial.content())
    for factor in factors:
        while not rest.is_constant() and (quotient := rest.quotient(factor)) is not None:
            rest = quotient
    return rest


def _is_product(value: Element, units: Sequence[Element]) -> bool:
    """Whether a polynomial is a number other than zero times powers of units."""
    if value.is_zero:
        return False
    parts = [unit.cleared() for unit in units if not unit.is_zero]
    primitive = [part.divided(part.content()) for part in parts if not part.is_constant()]
    return _without(value.cleared(), primitive).is_constant()


def _restricted(element: Element, moved: Iterable[int]) -> Element:
    """Return a polynomial with zero for some variables."""
    numerator = element.cleared()
    for place in moved:
        numerator = numerator.parts(place).get(0, constant(0))
    return Element(element.field, numerator, {}, element.denominator)


def _moved(question: Question, field: Field, certificate: Mapping[str, Any]) -> frozenset[int]:
    """Return the variables that translations take to zero, after seeing that nothing changes along them."""
    translations = certificate.get("translations", ())
    names = [along["zero"] for along in translations]
    for along in translations:
        require_keys(along, {"zero", "along"})
        require(
            along["along"].keys() <= field.places.keys(),
            "a translation moves a symbol that does not occur in the statement",
        )
        own = {name: along["along"].get(name, "0") for name in names}
        require(
            own == {name: str(int(name == along["zero"])) for name in names},
            "a translation moves a symbol that another translation takes to zero",
        )
    texts = (*certificate["claims"], *certificate["generators"], *certificate["denominators"])
    directions: dict[str, list[Element]] = {name: [] for name in field.places}
    for name, components in directions.items():
        components += [field.number(number(along["along"].get(name, "0"))) for along in translations]
    algebra = field.algebra
    for form in (*map(parse_polynomial, texts), *question.nonzero):
        slopes = derivatives(form, algebra, directions, len(names))[0] if names else []
        require(all(slope.is_zero for slope in slopes), "a form changes along a translation")
    return frozenset(field.places[name] for name in names)


def _divides(unit: Element, source: Element) -> bool:
    if unit.is_zero or source.is_zero:
        return False
    factor, whole = unit.cleared(), source.cleared()
    return whole.divided(whole.content()).quotient(factor.divided(factor.content())) is not None


def _squares(known: _Known, step: Mapping[str, Any]) -> tuple[list[Element], Element]:
    """Return the roots of a sum of squares with positive weights, and the sum."""
    roots, total = list[Element](), known.field.number(Fraction(0))
    for weight, text in step["squares"]:
        require(number(weight) > 0, "the weight of a square is not positive")
        roots.append(known.read(text))
        total = total + known.field.number(number(weight)) * roots[-1] * roots[-1]
    return roots, total


def _after_squares(known: _Known, step: Mapping[str, Any]) -> _Known:
    """Return what is known after a sum of squares was shown to be zero, or to be positive."""
    roots, total = _squares(known, step)
    if "not zero" in step:
        require_keys(step, {"squares", "not zero"})
        constants = [root for root in roots if root.cleared().is_constant() and not root.is_zero]
        require(
            (total - known.read(step["not zero"])).is_zero,
            "the squares do not add up to the form that is said not to be zero",
        )
        require(bool(constants), "none of the squares is that of a number, so that their sum may be zero")
        return known.with_unit(total)
    require_keys(step, {"squares", "multiplier", "cofactors"})
    rest = known.multiplier(step["multiplier"]) * total - known.combined(step["cofactors"])
    require(rest.is_zero, "the cofactors do not multiply out to the sum of squares")
    return replace(known, zeros=(*known.zeros, *roots))


def _keys_of_case(case: Mapping[str, Any]) -> Set[str]:
    return {"cases"} if "cases" in case else {"exponent", "multiplier", "cofactors"}


def _require_case(known: _Known, case: Mapping[str, Any]) -> None:
    """Check that the claim vanishes in a case."""
    known = _after_steps(known, case.get("steps", ()))
    if "cases" not in case:
        left = known.claim ** natural(case["exponent"]) * known.multiplier(case["multiplier"])
        require((left - known.combined(case["cofactors"])).is_zero, "the cofactors do not multiply out to the claim")
        return
    first, second = case["cases"]
    for part in (first, second):
        require_keys(part, {"assumed", *_keys_of_case(part)}, {"steps"})
    require(
        first["assumed"].keys() == {"not zero"} and second["assumed"].keys() == {"zero"},
        "a case distinction needs a case 'not zero' and then a case 'zero'",
    )
    require(first["assumed"]["not zero"] == second["assumed"]["zero"], "the two cases are not about the same form")
    distinguished = known.read(second["assumed"]["zero"])
    _require_case(known.with_unit(distinguished), first)
    _require_case(known.with_zero(distinguished), second)


def _after_steps(known: _Known, steps: Iterable[Mapping[str, Any]]) -> _Known:
    for step in steps:
        known = _after_squares(known, step) if "squares" in step else _after_step(known, step)
    return known


def _after_step(known: _Known, step: Mapping[str, Any]) -> _Known:
    """Return what is known after a step."""
    ((shows, text),) = [(key, value) for key, value in step.items() if key in ("zero", "not zero", "goal")]
    require_keys(step, {shows, "multiplier", "cofactors", *(() if shows == "zero" else ("factor",))})
    shown, multiplier, total = known.read(text), known.multiplier(step["multiplier"]), known.combined(step["cofactors"])
    if shows == "zero":
        require(
            (multiplier * shown - total).is_zero,
            "the cofactors do not multiply out to the form that is said to be zero",
        )
        return known.with_zero(shown)
    left = multiplier if shows == "not zero" else multiplier * known.claim
    rest = left - total - known.read(step["factor"]) * shown
    require(rest.is_zero, f"the cofactors do not multiply out to the {shows}")
    return known.with_unit(shown) if shows == "not zero" else replace(known, claim=shown)
