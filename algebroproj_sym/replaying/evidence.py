"""Checking the evidence, kind by kind: nothing is searched for, everything is multiplied out.

``PROOFS`` shows that a form holds, ``REFUTATIONS`` that the printed one does not.  Each is a function of the statement,
the name of the form, the certificate and the other parts of the evidence; it returns nothing, or raises `Rejected`.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from itertools import combinations
from math import prod
from typing import Any, TypeAlias

from algebroproj_sym.replaying.consequences import Question, Sides, require_consequence, require_divisors
from algebroproj_sym.replaying.evaluation import Algebra, at_point, derivatives, evaluate
from algebroproj_sym.replaying.field import Element, Field
from algebroproj_sym.replaying.polynomial import Polynomial
from algebroproj_sym.replaying.rejection import require, require_keys
from algebroproj_sym.replaying.statement import Point, Statement
from algebroproj_sym.replaying.text import decimal, integer, natural, number, numbers, parse_polynomial, texts

Certificate: TypeAlias = Mapping[str, Any]
Check: TypeAlias = Callable[[Statement, str, Certificate], None]


def _method(certificate: Certificate, expected: str) -> None:
    found = certificate.get("method")
    require(found == expected, f"expected the method {expected!r}, got {found!r}")


def _sides(statement: Statement, form: str) -> Sides:
    """Return what gives both sides in an algebra."""

    def sides(algebra: Algebra) -> tuple[list[Any], list[Any]]:
        left, right = statement.side(form, algebra), statement.side("derived", algebra)
        require(statement.form(form).shape == statement.form("derived").shape, "the two sides differ in shape")
        return left, right

    return sides


def _difference(sides: Sides, field: Field) -> list[Element]:
    return [a - b for a, b in zip(*sides(field.algebra), strict=True)]


def identity(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that two sides are equal as rational functions."""
    _method(certificate, "normal form")
    require_keys(certificate, {"method", "denominators"})
    field = Field(statement.symbols, certificate["denominators"])
    field.units(statement.listed("nonzero"))
    require(all(entry.is_zero for entry in _difference(_sides(statement, form), field)), "the two sides differ")
    require_divisors(statement.record["hypotheses"], field, certificate["denominators"])


def constrained(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that the difference of two sides times what does not vanish is a combination of the constraints."""
    _constrained(statement, certificate, _sides(statement, form))


def _constrained(statement: Statement, certificate: Certificate, sides: Sides) -> None:
    hypotheses = statement.record["hypotheses"]
    constraints, nonzero = statement.listed("constraints"), statement.listed("nonzero")
    require_consequence(Question(sides, constraints, nonzero, statement.symbols, hypotheses), certificate)


def _numerator(element: Element) -> Polynomial:
    """Return what is left when divisors and numbers are dropped."""
    raised = {place: power for place, power in element.exponents.items() if power > 0}
    return _primitive(element.numerator * element.field.powers(raised))


def _primitive(polynomial: Polynomial) -> Polynomial:
    require(bool(polynomial), "a constraint or a divisor is identically zero")
    return polynomial.divided(polynomial.content())


def _pivot(certificate: Certificate, places: int) -> int:
    pivot = integer(certificate.get("pivot"))
    require(places > 1, "two single numbers always have a common factor")
    require(0 <= pivot < places, "the pivot is not the place of an entry")
    return pivot


def projective(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that one side is the other times a factor, wherever neither is zero, and that neither is zero everywhere.

    Without constraints one entry is compared with all others, since it is not zero as a rational function; where there
    are constraints, all entries are compared with one another.
    """
    both = _sides(statement, form)
    if "constraints" in statement.setting:
        point = statement.point(certificate.get("nonzero at"))
        statement.require_allowed(point)
        pivot = _pivot(certificate, len(statement.form("derived").entries))
        require(all(side[pivot] != 0 for side in both(at_point(point))), "a side is zero at the point")
        own = {key: value for key, value in certificate.items() if key not in ("pivot", "nonzero at")}
        _constrained(statement, own, lambda algebra: _crossed(*both(algebra)))
        return
    _method(certificate, "normal form")
    require_keys(certificate, {"method", "denominators", "pivot"})
    field = Field(statement.symbols, certificate["denominators"])
    printed, derived = both(field.algebra)
    pivot = _pivot(certificate, len(derived))
    p, d = printed[pivot], derived[pivot]
    require(not p.is_zero and not d.is_zero, "the entry at the pivot is zero")
    require(all(entry.is_zero for entry in derived[:pivot]), "an entry before the pivot is not zero")
    field.units(statement.listed("nonzero"))
    equal = all((a * d - b * p).is_zero for a, b in zip(printed, derived, strict=True))
    require(equal, "the two sides are not proportional")
    require_divisors(statement.record["hypotheses"], field, certificate["denominators"])


def _crossed(left: Sequence[Any], right: Sequence[Any]) -> tuple[list[Any], list[Any]]:
    """Return the products of entries that are equal where two lists are proportional."""
    pairs = [*combinations(range(len(left)), 2)]
    return [left[i] * right[j] for i, j in pairs], [left[j] * right[i] for i, j in pairs]


def structure(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that the derived matrix has the zeros, equal and opposite entries of the pattern."""
    _method(certificate, "normal form")
    require_keys(certificate, {"method", "denominators", "pattern"})
    marks = _marks(statement, form)
    pattern: dict[str, list[int]] = {}
    for place, (sign, mark) in enumerate(marks, start=1):
        pattern.setdefault(mark, []).append(sign * place)
    given = {mark: [*map(integer, places)] for mark, places in certificate["pattern"].items()}
    require(pattern == given, "the pattern of the certificate differs from the printed one")
    field = Field(statement.symbols, certificate["denominators"])
    entries = statement.side("derived", field.algebra)
    same = statement.form(form).shape == statement.form("derived").shape
    require(same, "the pattern and the matrix differ in shape")
    first: dict[str, Element] = {}
    for (sign, mark), entry in zip(marks, entries, strict=True):
        signed = entry if sign > 0 else -entry
        if mark.lstrip("-").isdecimal():
            require((signed - field.number(Fraction(mark))).is_zero, f"an entry marked {mark} is not {mark}")
            continue
        require(not signed.is_zero, f"an entry marked {mark} is zero")
        require((first.setdefault(mark, signed) - signed).is_zero, f"the entries marked {mark} differ")
    require_divisors(statement.record["hypotheses"], field, certificate["denominators"])


def _marks(statement: Statement, form: str) -> list[tuple[int, str]]:
    """Return the sign and the mark of each entry of a pattern."""
    require(not statement.where, "a mark of a pattern must not stand for an expression")
    pattern, marks = statement.form(form), []
    for place in range(len(pattern.entries)):
        mark, sign = pattern.entry(place), 1
        if mark.kind == "-":
            mark, sign = pattern.operations[mark.operands[0]], -1
        require(mark.kind in ("symbol", "number"), "expected symbols with signs and integers")
        marks.append((sign, mark.value) if mark.kind == "symbol" else (1, str(sign * mark.value)))
    return marks


def vanishing(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that an expression and a product of factors vanish at the same places, from their factors.

    That the factors are irreducible is not needed for this direction, and not checked.
    """
    _method(certificate, "factorisation")
    require_keys(certificate, {"method", "content", "factors", "denominator", "printed", "excluded"})
    divisors = statement.record["hypotheses"]
    field = Field(statement.symbols, divisors)
    algebra = field.algebra
    require(not statement.form("derived").shape, "expected a scalar that vanishes")
    named: dict[str, Element] = {}

    def product(powers: Any) -> Element:
        total = field.number(Fraction(1))
        require(len({name for name, _ in powers}) == len(powers), "a factor is listed twice")
        for name, count in powers:
            require(natural(count) > 0, "expected a positive multiplicity")
            if name not in named:
                named[name] = field.polynomial(name)
                primitive = not named[name].cleared().is_constant() and abs(named[name].cleared().content()) == 1
                require(primitive, "a listed factor is a constant, or has a numeric factor")
            total = total * named[name] ** count
        return total

    content = field.number(number(certificate["content"]))
    derived = statement.side("derived", algebra)[0]
    multiplied = content * product(certificate["factors"])
    below = product(certificate["denominator"])
    require({name for name, _ in certificate["denominator"]} <= {*divisors}, "a divisor is not among the hypotheses")
    require(not derived.is_zero, "the derived expression is identically zero")
    require((derived * below - multiplied).is_zero, "the factors do not multiply out to the expression")
    printed = statement.side(form, algebra)
    require(
        len(printed) == len(certificate["printed"]),
        "the certificate and the statement differ in the number of printed factors",
    )
    for value, powers in zip(printed, certificate["printed"], strict=True):
        require(_numerator(value) == _numerator(product(powers)), "the factors of a printed factor do not multiply out")
    factors = {name for name, _ in certificate["factors"]}
    claimed = {name for powers in certificate["printed"] for name, _ in powers}
    units = field.units(statement.listed("nonzero"))
    excluded = []
    for name in sorted(factors):
        factor = named[name].cleared()
        listed = factor in field.factors[: field.listed] or -factor in field.factors[: field.listed]
        if listed or any(_numerator(value).quotient(_primitive(factor)) is not None for value in units):
            excluded.append(name)
    require(
        certificate["excluded"] == excluded, "the excluded factors differ from those of the divisors and hypotheses"
    )
    require(factors - {*certificate["excluded"]} == claimed, "the factors of the two sides differ")
    field.require_listed()


def rank(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that a matrix has a rank: a minor that is not zero below, vectors that it takes to zero above."""
    _method(certificate, "rank at a point and kernel vectors")
    claimed = _integer(statement, form)
    require(_minor(statement, certificate, certificate.get("point")) == claimed, "the minor is not of the claimed size")
    require(_bound(statement, certificate, {"point", "rows", "columns", "minor"}) == claimed, "the rank may be larger")


def _integer(statement: Statement, form: str) -> int:
    require(not statement.form(form).shape, "expected a number")
    value = statement.side(form, at_point({}))[0]
    require(value.denominator == 1, "expected a whole number")
    return int(value)


def _minor(statement: Statement, certificate: Certificate, point: Any) -> int:
    """Return the size of the minor of the certificate, which is not zero at a point."""
    exact = statement.point(point)
    require(exact.keys() == statement.symbols, "the point must give a value to every symbol, and to no other")
    return _size(_matrix_at(statement, exact), certificate, "rows", "columns", "minor")


def _matrix_at(statement: Statement, point: Point) -> list[list[Fraction]]:
    """Return the matrix, or the Jacobian matrix of the functions, at a point."""
    form = statement.form("derived")
    if statement.kind == "rank":
        return _rows(evaluate(form, at_point(point)), form.shape)
    variables = statement.setting["variables"]
    units = {name: [Fraction(i == j) for j in range(len(variables))] for i, name in enumerate(variables)}
    return derivatives(form, at_point(point), units, len(variables))


def _rows(entries: list[Any], shape: tuple[int, ...]) -> list[list[Any]]:
    require(len(shape) == 2, "expected a matrix")
    return [entries[i * shape[1] : (i + 1) * shape[1]] for i in range(shape[0])]


def _size(matrix: list[list[Fraction]], certificate: Certificate, rows: str, columns: str, value: str) -> int:
    width = len(matrix[0]) if matrix else 0
    chosen_rows = _chosen(certificate.get(rows), len(matrix))
    chosen_columns = _chosen(certificate.get(columns), width)
    require(len(chosen_rows) == len(chosen_columns), "a minor needs as many rows as columns")
    determinant = _determinant([[matrix[i][j] for j in chosen_columns] for i in chosen_rows])
    require(determinant != 0, "the minor is zero")
    require(determinant == number(certificate.get(value)), "the recorded value of the minor is wrong")
    return len(chosen_rows)


def _chosen(places: Any, limit: int) -> list[int]:
    require(isinstance(places, list), "a minor needs a list of rows and a list of columns")
    found = [place for place in map(integer, places) if 0 <= place < limit]
    require(
        found == places == sorted({*found}), "the rows or columns of the minor are out of order, or outside the matrix"
    )
    return found


def _determinant(matrix: list[list[Fraction]]) -> Fraction:
    rows, result = [list(row) for row in matrix], Fraction(1)
    for place in range(len(rows)):
        pivot = next((i for i in range(place, len(rows)) if rows[i][place]), None)
        if pivot is None:
            return Fraction(0)
        if pivot != place:
            rows[place], rows[pivot] = rows[pivot], rows[place]
            result = -result
        result *= rows[place][place]
        for row in rows[place + 1 :]:
            if row[place]:
                factor = row[place] / rows[place][place]
                row[place:] = [a - factor * b for a, b in zip(row[place:], rows[place][place:], strict=True)]
    return result


def _bound(statement: Statement, certificate: Certificate, others: set[str]) -> int:
    """Return the upper bound that size and kernel vectors give."""
    derived = statement.form("derived")
    counted = statement.kind == "count"
    width = len(statement.setting["variables"]) if counted else derived.shape[1]
    smaller = min(len(derived.entries) if counted else derived.shape[0], width)
    require(statement.record["hypotheses"] == [], "a rank over the rational functions must not have hypotheses")
    field = Field(statement.symbols)
    if not certificate.get("kernel"):
        require_keys(certificate, {"method", "kernel", *others})
        return smaller
    require_keys(certificate, {"method", "kernel", "kernel at", "kernel rows", "kernel minor", *others})
    vectors = [[*map(field.element, field.polynomials(text))] for text in texts(certificate["kernel"])]
    require(
        all(len(vector) == width for vector in vectors),
        "a kernel vector and the matrix differ in the number of columns",
    )
    require(all(entry.is_zero for entry in _along(statement, field, vectors)), "a vector is not in the kernel")
    point = statement.point(certificate["kernel at"])
    columns = [evaluate(parse_polynomial(text), at_point(point)) for text in texts(certificate["kernel"])]
    at = {**certificate, "kernel columns": [*range(len(columns))]}
    independent = _size(
        [list(row) for row in zip(*columns, strict=True)], at, "kernel rows", "kernel columns", "kernel minor"
    )
    return width - independent


def _along(statement: Statement, field: Field, vectors: Sequence[Sequence[Element]]) -> list[Element]:
    """Return the matrix, or the Jacobian matrix of the functions, times the vectors."""
    form, algebra = statement.form("derived"), field.algebra
    if statement.kind == "count":
        variables = statement.setting["variables"]
        directions = {name: [vector[i] for vector in vectors] for i, name in enumerate(variables)}
        return [value for row in derivatives(form, algebra, directions, len(vectors)) for value in row]
    rows = _rows(evaluate(form, algebra), form.shape)
    products = []
    for row in rows:
        for vector in vectors:
            products.append(sum((a * b for a, b in zip(row, vector, strict=True)), field.number(Fraction(0))))
    return products


def limit(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that the leading coefficients have the claimed quotient.

    A limit is one where the lowest coefficients of all divisors do not vanish; these are hypotheses.
    """
    _method(certificate, "leading coefficients")
    require_keys(certificate, {"method", "divisors", "orders"})
    field, limits, lowest = _limits(statement, form, certificate)
    for value, found in zip(statement.side(form, field.algebra), limits, strict=True):
        require(found is not None, "an entry has no limit")
        assert found is not None
        numerator, denominator = found
        require((value * denominator - numerator).is_zero, "the limit differs from the printed one")
    hypotheses = Field(statement.symbols, statement.record["hypotheses"])
    statement.side(form, hypotheses.algebra)
    for coefficient in lowest:
        hypotheses.factored(coefficient)
    hypotheses.require_listed()


Limit: TypeAlias = "tuple[Element, Element] | None"


def _limits(statement: Statement, form: str, certificate: Certificate) -> tuple[Field, list[Limit], list[Polynomial]]:
    """Return numerator and denominator of the limit of each entry, None for a pole, and what must not vanish."""
    require(statement.form(form).shape == statement.form("derived").shape, "the two sides differ in shape")
    field = Field(statement.symbols, certificate["divisors"])
    values = statement.side("derived", field.algebra)
    field.require_listed()
    place = field.places[statement.setting["variable"]]
    found = [_leading(value, place) for value in values]
    require([*map(integer, certificate["orders"])] == [order for order, _, _ in found], "the recorded orders are wrong")
    zero = field.number(Fraction(0))
    limits: list[Limit] = [
        None if order < 0 else (above, below) if order == 0 else (zero, below) for order, above, below in found
    ]
    return field, limits, [_lowest(factor, place)[1] for factor in field.factors[: field.listed]]


def _leading(value: Element, place: int) -> tuple[int, Element, Element]:
    """Return the lowest power of a variable, and the numerator and denominator of its coefficient."""
    field = value.field
    if value.is_zero:
        return 0, value, field.number(Fraction(1))
    above = {i: power for i, power in value.exponents.items() if power > 0}
    below = {i: -power for i, power in value.exponents.items() if power < 0}
    numerator, denominator = _lowest(value.numerator * field.powers(above), place), _lowest(field.powers(below), place)
    scale = field.number(Fraction(1, value.denominator))
    return numerator[0] - denominator[0], field.element(numerator[1]) * scale, field.element(denominator[1])


def _lowest(polynomial: Polynomial, place: int) -> tuple[int, Polynomial]:
    parts = polynomial.parts(place)
    return min(parts), parts[min(parts)]


def numeric(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that a printed number is the exact one, rounded as declared."""
    require(_rounded(statement, form, certificate), "the exact number, rounded, differs from the printed one")


def numeric_refuted(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that a printed number is not the exact one, rounded as declared."""
    _require_no_point(statement)
    require(not _rounded(statement, form, certificate), "the printed number is the exact one, rounded")


def _rounded(statement: Statement, form: str, certificate: Certificate) -> bool:
    """Whether the printed number is the one that the certificate gives, after a check that this is the rounded one."""
    _method(certificate, "exact rounding")
    require_keys(certificate, {"method", "rounded"})
    exact = statement.form("derived")
    require(not exact.shape, "the exact number is a matrix")
    require(statement.record["hypotheses"] == [], "a printed number must not have hypotheses")
    printed, digit = decimal(statement.record[form])
    given, last = decimal(certificate["rounded"])
    require(last == digit, "the rounded number and the printed one differ in the number of decimals")
    value = evaluate(exact, at_point({}))[0]
    require(_rounds_to(value, given, digit, statement.setting.get("rounding")), "the recorded rounded number is wrong")
    return given == printed


def _rounds_to(exact: Fraction, given: Fraction, digit: Fraction, rounding: Any) -> bool:
    """Whether a number lies in the interval of those that are rounded to the given one, or cut off."""
    require(rounding in ("nearest", "cut"), f"expected the rounding nearest or cut, got {rounding!r}")
    lower = abs(given) - digit / 2 if rounding == "nearest" else abs(given)
    return exact * given >= 0 and lower <= abs(exact) < lower + digit


def reference(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that a reference is the meant one."""
    require(_referred(statement, form, certificate), "the printed reference differs from the meant one")


def reference_refuted(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that a reference is not the meant one."""
    _require_no_point(statement)
    require(not _referred(statement, form, certificate), "the printed reference is the meant one")


def _referred(statement: Statement, form: str, certificate: Certificate) -> bool:
    _method(certificate, "comparison of references")
    require_keys(certificate, {"method"})
    require(statement.record["hypotheses"] == [], "a reference must not have hypotheses")
    printed, meant = statement.form(form), statement.form("derived")
    return printed.shape == meant.shape and evaluate(printed, at_point({})) == evaluate(meant, at_point({}))


def definition(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that what is defined has the recorded values at a point."""
    _method(certificate, "instance")
    require_keys(certificate, {"method", "instance", "values"})
    values = statement.side(form, at_point(statement.point(certificate["instance"])))
    require(values == numbers(certificate["values"]), "the recorded values of the instance are wrong")
    field = Field(statement.symbols, statement.record["hypotheses"])
    statement.side(form, field.algebra)
    field.require_listed()


def differing(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that two sides differ at the point."""
    _method(certificate, "counterexample")
    require_keys(certificate, {"method", "left", "right"})
    left, right = _sides(statement, form)(at_point(_counterexample(statement)))
    _require_different(certificate, left, right)


def _counterexample(statement: Statement) -> Point:
    point = statement.point(statement.record["counterexample"])
    statement.require_allowed(point)
    return point


def projective_refuted(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that two sides are not proportional at the point."""
    _method(certificate, "counterexample")
    require_keys(certificate, {"method", "left", "right", "pivot"})
    printed, derived = _sides(statement, form)(at_point(_counterexample(statement)))
    pivot = _pivot(certificate, len(derived))
    left = [entry * derived[pivot] for entry in printed]
    right = [entry * printed[pivot] for entry in derived]
    require(derived[pivot] != 0, "the entry at the pivot is zero")
    _require_different(certificate, left, right)


def structure_refuted(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that a matrix does not follow the pattern at the point."""
    _method(certificate, "counterexample")
    require_keys(certificate, {"method", "left", "right"})
    values = statement.side("derived", at_point(_counterexample(statement)))
    first: dict[str, Fraction] = {}
    expected = []
    marks = _marks(statement, form)
    same = statement.form(form).shape == statement.form("derived").shape
    require(same, "the pattern and the matrix differ in shape")
    for (sign, mark), value in zip(marks, values, strict=True):
        constant = mark.lstrip("-").isdecimal()
        expected.append(Fraction(mark) if constant else sign * first.setdefault(mark, sign * value))
    require(expected == numbers(certificate["left"]), "the recorded value of the pattern at the point is wrong")
    require(values == numbers(certificate["right"]), "the recorded value of the matrix at the point is wrong")
    require(expected != values, "the matrix follows the pattern at the point")


def vanishing_refuted(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that at the point only one side vanishes."""
    _method(certificate, "counterexample")
    require_keys(certificate, {"method", "derived", "product of the factors"})
    require(not statement.form("derived").shape, "expected a scalar that vanishes")
    algebra = at_point(_counterexample(statement))
    derived, product = statement.side("derived", algebra)[0], prod(statement.side(form, algebra), start=Fraction(1))
    require(
        derived == number(certificate["derived"]), "the recorded value of the derived expression at the point is wrong"
    )
    require(
        product == number(certificate["product of the factors"]),
        "the recorded value of the product at the point is wrong",
    )
    require((derived == 0) != (product == 0), "at the point both sides are zero, or neither is")


def rank_refuted(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that a rank is larger, by a minor, or smaller, by kernel vectors."""
    claimed = _integer(statement, form)
    if certificate.get("method") == "counterexample":
        require_keys(certificate, {"method", "rank", "rows", "columns", "minor"})
        size = _minor(statement, certificate, statement.record["counterexample"])
        require(size == integer(certificate["rank"]), "the minor is not of the recorded size")
        require(size > claimed, "the rank is not larger")
        return
    _method(certificate, "kernel vectors")
    bound = _bound(statement, certificate, {"rank at most"})
    _require_no_point(statement)
    require(bound == integer(certificate["rank at most"]), "the recorded bound of the rank is wrong")
    require(bound < claimed, "the rank is not smaller")


def limit_refuted(statement: Statement, form: str, certificate: Certificate) -> None:
    """Show that an entry has a pole, or that the limit differs at the point."""
    if certificate.get("method") == "divergence":
        require_keys(certificate, {"method", "divisors", "orders"})
        _, limits, _ = _limits(statement, form, certificate)
        _require_no_point(statement)
        require(None in limits, "every entry has a limit")
        return
    _method(certificate, "counterexample")
    require_keys(certificate, {"method", "divisors", "orders", "left", "right"})
    field, limits, lowest = _limits(statement, form, certificate)
    point = _counterexample(statement)
    require(all(field.value(part, point) for part in lowest), "the limit is not defined at the point")
    right = []
    for found in limits:
        require(found is not None, "an entry has no limit")
        assert found is not None
        above, below = (field.value(part.cleared(), point) / part.denominator for part in found)
        right.append(above / below)
    _require_different(certificate, statement.side(form, at_point(point)), right)


def _require_different(certificate: Certificate, left: list[Fraction], right: list[Fraction]) -> None:
    require(left == numbers(certificate["left"]), "the recorded value of the left side at the point is wrong")
    require(right == numbers(certificate["right"]), "the recorded value of the right side at the point is wrong")
    require(left != right, "the two sides do not differ at the point")


def _require_no_point(statement: Statement) -> None:
    require(statement.record["counterexample"] == {}, "a refutation without a point needs an empty counterexample")


PROOFS: Mapping[str, Check] = {
    "identity": identity,
    "identity under constraints": constrained,
    "identity up to scale": projective,
    "structure": structure,
    "vanishing": vanishing,
    "rank": rank,
    "count": rank,
    "limit": limit,
    "numeric": numeric,
    "reference": reference,
    "definition": definition,
}
REFUTATIONS: Mapping[str, Check] = {
    "identity": differing,
    "identity under constraints": differing,
    "identity up to scale": projective_refuted,
    "structure": structure_refuted,
    "vanishing": vanishing_refuted,
    "rank": rank_refuted,
    "count": rank_refuted,
    "limit": limit_refuted,
    "numeric": numeric_refuted,
    "reference": reference_refuted,
}
