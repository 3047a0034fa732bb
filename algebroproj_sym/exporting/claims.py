"""From the evidence of a claim to theorems, kind by kind.

``PROOFS`` holds what shows that a form holds, ``REFUTATIONS`` what shows that the printed one does not; each is a
function of the statement, the name of the form, and the certificate, and returns theorems by what they show.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from typing import Any, TypeAlias

from algebroproj_sym.exporting import points
from algebroproj_sym.exporting.counts import Functions, independent_at, unchanged_along
from algebroproj_sym.exporting.gallina import formula, listed
from algebroproj_sym.exporting.limits import denominators, limits
from algebroproj_sym.exporting.objects import Object, dot
from algebroproj_sym.exporting.points import Literal, Regular, divisors_nonzero
from algebroproj_sym.exporting.rational_functions import exact_quotient, hypotheses, ratio, vector
from algebroproj_sym.exporting.reading import decimal, formula_of, natural, symbol
from algebroproj_sym.exporting.reading import form as read
from algebroproj_sym.exporting.refusal import AnotherForm, NotExportable, Silent
from algebroproj_sym.exporting.statement import Point, Statement
from algebroproj_sym.exporting.terms import (
    Term,
    Written,
    difference,
    free,
    in_rows,
    inlined,
    integer,
    name,
    negative,
    number,
    power,
    product,
    quotient,
)
from algebroproj_sym.exporting.theorems import (
    Goal,
    Hypotheses,
    equations,
    matrix_of,
    splitting,
    universal,
    universal_of_matrix,
    with_divisors,
)
from algebroproj_sym.exporting.vanishing import both_ways

Certificate: TypeAlias = Mapping[str, Any]
Proved: TypeAlias = dict[str, tuple[str, str]]
"""Statement and proof, by what the theorem shows."""


def _hypotheses(statement: Statement, *forms: Written) -> Hypotheses:
    """Return the hypotheses, after comparing them with what the forms divide by."""
    definitions = {called: value for form in forms for called, value in form.definitions.items()}
    variables = tuple(sorted(statement.symbols))
    entries = inlined([entry for form in forms for entry in form.entries], definitions)
    conditions = [*statement.listed("nonzero"), *statement.listed("constraints")]
    divisors = hypotheses(variables, statement.hypotheses, [*entries, *conditions])
    return Hypotheses(variables, divisors, definitions)


def _constrained(statement: Statement, given: Hypotheses, more: Sequence[Term] = ()) -> Hypotheses:
    units = (*statement.listed("nonzero"), *more)
    return replace(given, units=units, constraints=statement.listed("constraints"))


def identity(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show equations between rational functions."""
    left, right = statement.written(form), statement.written("derived")
    given = _hypotheses(statement, left, right)
    return {"holds": universal(given, [Goal(a, b) for a, b in zip(left.entries, right.entries, strict=True)])}


def about(statement: Statement, form: str, certificate: Certificate, made: Object) -> Proved:
    """Show that an object which the derivation makes step by step is what is printed."""
    printed, derived = statement.written(form), statement.written("derived")
    given = _hypotheses(statement, printed, derived)
    piece = made.piece
    entries = [entry for row in piece.rows for entry in row]
    given = replace(given, variables=tuple(sorted({*given.variables, *piece.variables})))
    expected = inlined(derived.entries, derived.definitions)
    if not _same(given, entries, expected):
        raise AnotherForm("the steps of the derivation make another form than the ledger has")
    right = printed.entries if given.variables else inlined(printed.entries, printed.definitions)
    goals = [Goal(a, b) for a, b in zip(entries, right, strict=True)]
    if "constraints" in statement.setting:
        given = _constrained(statement, given)
        goals = _members(given, [(goal.left, goal.right) for goal in goals], certificate)
    rows = in_rows(goals, len(piece.rows[0]))
    holds = universal_of_matrix(
        given, rows, piece.text, scalar=piece.scalar, first=made.rewriting, required=piece.needs
    )
    return (
        {"holds": holds, **_witness_of(statement, given, certificate)}
        if "constraints" in statement.setting
        else {"holds": holds}
    )


def _same(given: Hypotheses, left: Sequence[Term], right: Sequence[Term]) -> bool:
    if len(left) != len(right):
        return False
    if not given.variables:
        return points.values({}, {}, left) == points.values({}, {}, right) is not None
    field = splitting(given).field
    return not any(field.value(difference(a, b)).numerator for a, b in zip(left, right, strict=True))


def constrained(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show equations that follow from constraints, by their cofactors; and a point that satisfies all hypotheses."""
    left, right = statement.written(form), statement.written("derived")
    given = _constrained(statement, _hypotheses(statement, left, right))
    goals = _members(given, [*zip(left.entries, right.entries, strict=True)], certificate)
    return {"holds": universal(given, goals), **_witness_of(statement, given, certificate)}


def _witness_of(statement: Statement, given: Hypotheses, certificate: Certificate) -> Proved:
    """Show that the point of a certificate satisfies all hypotheses; nothing if its numbers are roots."""
    if "extension" in certificate:
        return {}
    return {"witness": _witness(given, statement.point(certificate["witness"]))}


def _members(given: Hypotheses, pairs: Sequence[tuple[Term, Term]], certificate: Certificate) -> list[Goal]:
    """Return the goals that entries follow from the constraints.

    The certificate's polynomials are compared with what the exporter finds but for a rational factor.
    """
    if any("steps" in part or "cases" in part for part in (certificate, *certificate["entries"])):
        raise NotExportable("a proof in steps has no theorem yet")
    field = splitting(given).field
    count = len(given.divisors)
    bases = [*field.divisors[:count], *(field.value(unit).numerator for unit in given.units)]
    texts = zip(certificate["generators"], given.constraints, strict=True)
    ratios = [ratio(field.polynomial(formula_of(text)), field.numerator(constraint)) for text, constraint in texts]
    goals = []
    for (left, right), text, part in zip(pairs, certificate["claims"], certificate["entries"], strict=True):
        exponent = natural(part["exponent"])
        multiplier, raised = _split_by(bases, field.polynomial(formula_of(part["multiplier"])))
        if not multiplier.is_constant() or not multiplier:
            raise NotExportable("the multiplier is not a product of hypotheses")
        claim, value = field.polynomial(formula_of(text)), field.value(difference(left, right))
        scale = Fraction(int(multiplier.leading_coefficient()))
        common = dict[int, int]()
        if value.numerator:
            claimed, powers = _split_by(bases[:count], claim)
            found, own = _split_by(bases[:count], value.numerator)
            scale *= ratio(claimed, (found, value.denominator)) ** exponent
            for place in range(count):
                more = powers.get(place, 0) - own.get(place, 0) - value.exponents.get(place, 0)
                raised[place] = raised.get(place, 0) + more * exponent
                common[place] = max(0, -raised[place])
                raised[place] += common[place]
        for place, unit in enumerate(given.units):
            scale /= int(field.value(unit).numerator.content()) ** raised.get(count + place, 0)
        shared = [power(given.divisors[place], n) for place, n in common.items() if n]
        cofactors = [
            product([number(r / scale), *shared, formula_of(part["cofactors"].get(str(place), "0"))])
            for place, r in enumerate(ratios)
        ]
        goals.append(Goal(left, right, exponent, vector(raised), tuple(cofactors)))
    return goals


def _split_by(bases: Sequence[Any], polynomial: Any) -> tuple[Any, dict[int, int]]:
    """Return what is left of a polynomial without the primitive parts of others, and how often it has each."""
    exponents = dict[int, int]()
    for place, base in enumerate(bases):
        primitive = base / base.content()
        while (
            not primitive.is_constant() and polynomial and (rest := exact_quotient(polynomial, primitive)) is not None
        ):
            polynomial, exponents[place] = rest, exponents.get(place, 0) + 1
    return polynomial, exponents


def _common_point(given: Hypotheses, listed_points: Sequence[Point]) -> Point:
    """Return the point of two, or of both together, where all hypotheses hold."""
    witness, other = listed_points
    for point in (witness, witness | other, other):
        nonzero = points.values(point, given.definitions, [*given.divisors, *given.units])
        if nonzero and all(nonzero):
            return point
    raise NotExportable("neither point of the certificate satisfies all hypotheses")


def _witness(given: Hypotheses, point: Point) -> tuple[str, str]:
    literals = [Literal("Nonzero", (divisor,)) for divisor in (*given.divisors, *given.units)]
    literals += [Literal("Zero", (constraint,)) for constraint in given.constraints]
    return points.at_point(point, given.definitions, literals)


def projective(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show that entries are proportional where the entry at the pivot is not zero."""
    left, right = statement.written(form), statement.written("derived")
    given = _hypotheses(statement, left, right)
    if "constraints" in statement.setting:
        return _proportional_under_constraints(statement, given, left.entries, right.entries, certificate)
    pivot = natural(certificate["pivot"])
    taken = {*given.variables, *given.definitions}
    p, d = (name(free(text, taken)) for text in ("pivot", "pivot'"))
    definitions = {**given.definitions, str(p.value): left.entries[pivot], str(d.value): right.entries[pivot]}
    given = replace(given, definitions=definitions)
    pairs = [*zip(left.entries, right.entries, strict=True)]
    crossed = [(product([a, d]), product([b, p])) for a, b in pairs]
    given = replace(given, units=(d, p))
    goals = [Goal(a, b) for a, b in crossed]
    k = name(free("k", {*given.variables, *given.definitions}))
    scaled = equations([Goal(a, product([k, b])) for a, b in pairs])
    listed_pairs = listed([f"({formula(a)}, {formula(b)})" for a, b in pairs])
    lemma = f"proportional {formula(p)} {formula(d)} {listed_pairs}"
    return {
        "holds": universal(
            given,
            goals,
            f"exists {k.value} : R, {k.value} <> 0 /\\\n{scaled}",
            lambda introduced, crossed: f"{lemma} {' '.join(introduced.units[:-3:-1])} ({crossed})",
        )
    }


def _proportional_under_constraints(
    statement: Statement, given: Hypotheses, left: Sequence[Term], right: Sequence[Term], certificate: Certificate
) -> Proved:
    """Show that all products of entries are equal crosswise; a point has all that is assumed, and entries not zero."""
    given = _constrained(statement, given)
    pairs = [*combinations(range(len(left)), 2)]
    crossed = [(product([left[i], right[j]]), product([left[j], right[i]])) for i, j in pairs]
    goals = _members(given, crossed, certificate)
    pivot = natural(certificate["pivot"])
    listed_points = [statement.point(certificate[key]) for key in ("witness", "nonzero at")]
    nonzero = replace(given, units=(*given.units, left[pivot], right[pivot]))
    return {"holds": universal(given, goals), "witness": _witness(nonzero, _common_point(nonzero, listed_points))}


def structure(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show zeros, equal and opposite entries of a matrix: it has the pattern, for some values of the marks."""
    derived = statement.written("derived")
    given = _hypotheses(statement, derived)
    marks = _marks(statement, form)
    pairs, first = _signed(marks, derived.entries)
    expected = [meant if sign > 0 else negative(meant) for (sign, _), (_, meant) in zip(marks, pairs, strict=True)]
    width = statement.form("derived").shape[1]
    goals = [Goal(a, b) for a, b in zip(derived.entries, expected, strict=True)]
    rows = in_rows(goals, width)
    variables = tuple(v for v in given.variables if v not in first)
    given = replace(given, variables=variables)
    bound = {mark: name(mark) for mark in first}
    pattern = [
        (lambda value: value if sign > 0 else negative(value))(bound[mark] if mark in bound else integer(int(mark)))
        for sign, mark in marks
    ]
    holds = universal_of_matrix(given, rows, pattern=in_rows(pattern, width), marks=first)
    point = _point_where(statement, given, [*first.values()])
    literals = [
        *divisors_nonzero([*first.values()], given.definitions),
        *(Literal("Nonzero", (t,)) for t in first.values()),
    ]
    marked = {"marked": points.at_point(point, given.definitions, literals)} if first else {}
    return {"holds": holds} | marked


def _marks(statement: Statement, form: str) -> list[tuple[int, str]]:
    """Return the sign and the mark of each entry of a pattern."""
    signed = [(node.kind == "-", node.parts[0] if node.kind == "-" else node) for node in statement.form(form).entries]
    if any(node.parts for _, node in signed):
        raise NotExportable("a pattern is of names and integers")
    return [(-1 if minus else 1, str(node.value)) for minus, node in signed]


def _signed(
    marks: Sequence[tuple[int, str]], entries: Sequence[Term]
) -> tuple[list[tuple[Term, Term]], dict[str, Term]]:
    """Return each entry, with the sign of its mark, and what it should be; and what each mark stands for."""
    first: dict[str, Term] = {}
    pairs = []
    for (sign, mark), entry in zip(marks, entries, strict=True):
        signed = entry if sign > 0 else negative(entry)
        pairs.append((signed, integer(int(mark)) if mark.lstrip("-").isdecimal() else first.setdefault(mark, signed)))
    return pairs, first


def _point_where(statement: Statement, given: Hypotheses, terms: Sequence[Term]) -> Point:
    """Return a point with small coordinates where terms are defined and not zero."""
    variables = given.variables
    for shift in range(200):
        point = {v: Fraction((place + 2) * (place + shift + 1) % (97 + shift) + 2) for place, v in enumerate(variables)}
        values = points.values(point, given.definitions, terms)
        if values is not None and all(values):
            return point
    raise NotExportable("no point was found where the marked entries are not zero")


def vanishing(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show that an expression is zero exactly where a product is."""
    derived, printed = statement.written("derived"), statement.written(form)
    given = _hypotheses(statement, derived, printed)
    given = replace(given, units=statement.listed("nonzero"))
    return {"holds": both_ways(given, derived.entries[0], printed.entries)}


def rank(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show a regular minor at a point, and independent vectors that the matrix takes to zero.

    The matrix is the given one or, to count independent functions, that of their derivatives.
    """
    return {"minor": _minor(statement, certificate, certificate["point"])} | _kernel(statement, certificate)


def _minor(statement: Statement, certificate: Certificate, exact: Any) -> tuple[str, str]:
    if statement.kind == "count":
        return _derivatives(statement, certificate, exact)
    derived, point = statement.written("derived"), statement.point(exact)
    rows, columns = certificate["rows"], certificate["columns"]
    matrix = in_rows(derived.entries, statement.form("derived").shape[1])
    minor = tuple(tuple(matrix[natural(i)][natural(j)] for j in columns) for i in rows)
    literal = _regular(point, derived.definitions, minor)
    chosen = [entry for row in minor for entry in row]
    return points.at_point(point, derived.definitions, [*divisors_nonzero(chosen, derived.definitions), literal])


def _regular(point: Point, definitions: Mapping[str, Term], rows: Sequence[Sequence[Term]]) -> Regular:
    """Return that a matrix of formulas is regular at a point."""
    if points.values(point, definitions, [entry for row in rows for entry in row]) is None:
        raise NotExportable("a divisor is zero at the point")
    if any(len(row) != len(rows) for row in rows):
        raise NotExportable("the minor is not square")
    return Regular(tuple(map(tuple, rows)))


def _kernel(statement: Statement, certificate: Certificate) -> Proved:
    if not certificate.get("kernel"):
        return {}
    derived = statement.written("derived")
    vectors = [read(text).entries for text in certificate["kernel"]]
    independent = {"independent": _independent(statement, certificate, vectors)}
    if statement.kind == "count":
        return {"kernel": _unchanged(statement, vectors)} | independent
    given = Hypotheses(tuple(sorted(statement.symbols)), (), derived.definitions)
    matrix = in_rows(derived.entries, statement.form("derived").shape[1])
    rows = [[Goal(dot(row, vector), integer(0)) for vector in vectors] for row in matrix]
    given = with_divisors(given, [goal.left for row in rows for goal in row])
    shown = f"times\n {matrix_of(matrix)}\n {matrix_of(vectors)}"
    return {"kernel": universal_of_matrix(given, rows, shown)} | independent


def _independent(statement: Statement, certificate: Certificate, vectors: Sequence[Sequence[Term]]) -> tuple[str, str]:
    point = statement.point(certificate["kernel at"])
    minor = tuple(tuple(vector[natural(i)] for vector in vectors) for i in certificate["kernel rows"])
    literal = _regular(point, {}, minor)
    return points.at_point(point, {}, [*divisors_nonzero([t for row in minor for t in row], {}), literal])


def _functions(statement: Statement) -> Functions:
    derived = statement.written("derived")
    return Functions(tuple(sorted(statement.symbols)), derived.definitions, derived.entries)


def _derivatives(statement: Statement, certificate: Certificate, exact: Any) -> tuple[str, str]:
    point, functions = statement.point(exact), _functions(statement)
    variables = [symbol(statement.setting["variables"][natural(column)]) for column in certificate["columns"]]
    places = [functions.variables.index(variable) for variable in variables]
    chosen = functions.chosen([natural(row) for row in certificate["rows"]])
    return independent_at(chosen, point, places)


def _unchanged(statement: Statement, vectors: Sequence[Sequence[Term]]) -> tuple[str, str]:
    functions, variables = _functions(statement), [*map(symbol, statement.setting["variables"])]
    components = [dict(zip(variables, vector, strict=True)) for vector in vectors]
    directions = [[part.get(symbol, integer(0)) for symbol in functions.variables] for part in components]
    return unchanged_along(functions, directions)


def limit(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show that expressions have limits."""
    printed, derived = statement.written(form), statement.written("derived")
    variable = symbol(statement.setting["variable"])
    entries = inlined(derived.entries, derived.definitions)
    at_zero = Written(
        tuple(
            quotient(integer(1), below) for below in denominators(tuple(sorted(statement.symbols)), entries, variable)
        ),
        {},
    )
    given = _hypotheses(statement, printed, at_zero)
    given = replace(given, variables=tuple(v for v in given.variables if v != variable))
    divisors = [*map(formula_of, certificate["divisors"])]
    return {"holds": limits(given, variable, divisors, entries, printed.entries)}


def numeric(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show that the exact number lies in the interval of those that are rounded to the printed one, or cut off."""
    exact = statement.written("derived")
    return {"holds": _compared(exact, _limits(statement, form, exact.entries[0]))}


def not_numeric(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show that the exact number lies beyond one of the limits of this interval."""
    exact = statement.written("derived")
    lower, upper = _limits(statement, form, exact.entries[0])
    found = points.values({}, exact.definitions, exact.entries)
    if found is None:
        raise NotExportable("the exact number is not defined")
    missed = lower if found[0] < decimal(statement.record[form])[0] else upper
    beyond = Literal("AtMost" if missed.kind == "Less" else "Less", missed.terms[::-1])
    return {"refuted": _compared(exact, [beyond])}


def _limits(statement: Statement, form: str, exact: Term) -> tuple[Literal, Literal]:
    """Return what holds of the exact number if it is rounded, or cut off, to the printed one: a limit on each side."""
    printed, digit = decimal(statement.record[form])
    rounding = statement.setting.get("rounding")
    if rounding not in ("nearest", "cut"):
        raise NotExportable(f"the rounding {rounding!r}")
    nearer = abs(printed) - (digit / 2 if rounding == "nearest" else 0)
    farther = nearer + digit
    above = Literal("AtMost", (number(nearer), exact)) if printed > 0 else Literal("Less", (number(-farther), exact))
    below = Literal("AtMost", (exact, number(-nearer))) if printed < 0 else Literal("Less", (exact, number(farther)))
    return above, below


def _compared(exact: Written, literals: Sequence[Literal]) -> tuple[str, str]:
    divisors = divisors_nonzero(exact.entries, exact.definitions)
    return points.at_point({}, exact.definitions, [*divisors, *literals])


def differing(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show a point where two sides are defined, the hypotheses hold, and the sides differ."""
    left, right = statement.written(form), statement.written("derived")
    place = next(i for i, (a, b) in enumerate(zip(certificate["left"], certificate["right"], strict=True)) if a != b)
    return _refuted(statement, [left, right], [Literal("Unequal", (left.entries[place], right.entries[place]))])


def _refuted(statement: Statement, forms: Sequence[Written], literals: Sequence[Literal]) -> Proved:
    point = statement.point(statement.record["counterexample"])
    definitions = {called: value for form in forms for called, value in form.definitions.items()}
    entries = [entry for form in forms for entry in form.entries]
    given = [Literal("Zero", (constraint,)) for constraint in statement.listed("constraints")]
    given += [Literal("Nonzero", (unit,)) for unit in statement.listed("nonzero")]
    return {
        "refuted": points.at_point(point, definitions, [*divisors_nonzero(entries, definitions), *given, *literals])
    }


def not_projective(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show a point where two sides are not proportional."""
    left, right = statement.written(form), statement.written("derived")
    pivot = natural(certificate["pivot"])
    p, d = left.entries[pivot], right.entries[pivot]
    place = next(i for i, (a, b) in enumerate(zip(certificate["left"], certificate["right"], strict=True)) if a != b)
    crossed = (product([left.entries[place], d]), product([right.entries[place], p]))
    return _refuted(statement, [left, right], [Literal("Nonzero", (d,)), Literal("Unequal", crossed)])


def not_structure(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show a point where a matrix does not follow the pattern."""
    derived = statement.written("derived")
    expected, _ = _signed(_marks(statement, form), derived.entries)
    place = next(i for i, (a, b) in enumerate(zip(certificate["left"], certificate["right"], strict=True)) if a != b)
    return _refuted(statement, [derived], [Literal("Unequal", expected[place])])


def not_vanishing(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show a point where one side is zero and the other is not."""
    printed, derived = statement.written(form), statement.written("derived")
    sides = (derived.entries[0], product(printed.entries))
    zero = certificate["derived"] == "0"
    literals = [Literal("Zero" if zero else "Nonzero", sides[:1]), Literal("Nonzero" if zero else "Zero", sides[1:])]
    return _refuted(statement, [printed, derived], literals)


def not_rank(statement: Statement, form: str, certificate: Certificate) -> Proved:
    """Show a regular minor that is too large, or too many vectors that the matrix takes to zero."""
    if certificate["method"] == "counterexample":
        return {"refuted": _minor(statement, certificate, statement.record["counterexample"])}
    return _kernel(statement, certificate)


Export: TypeAlias = Callable[[Statement, str, Certificate], Proved]
PROOFS: Mapping[str, Export] = {
    "identity": identity,
    "identity under constraints": constrained,
    "identity up to scale": projective,
    "structure": structure,
    "vanishing": vanishing,
    "rank": rank,
    "count": rank,
    "limit": limit,
    "numeric": numeric,
}
REFUTATIONS: Mapping[str, Export] = {
    "identity": differing,
    "identity under constraints": differing,
    "identity up to scale": not_projective,
    "structure": not_structure,
    "vanishing": not_vanishing,
    "rank": not_rank,
    "count": not_rank,
    "numeric": not_numeric,
}
REASONS: Mapping[str, str] = {
    "definition": "a definition introduces notation and states nothing",
    "reference": "a reference is about the text of the paper, not about a formula",
}


def theorems(record: Mapping[str, Any], made: Object | None = None) -> Proved:
    """Return statements and proofs of what a claim of the ledger shows, by what they show.

    `made` is how its derivation makes the derived form of an identity.  It raises `NotExportable` if there is no
    theorem, for a reason.
    """
    kind, verdict, certificate = record["kind"], record["verdict"], record["certificate"]
    if kind in REASONS:
        raise Silent(REASONS[kind])
    if verdict == "open" or certificate is None:
        raise NotExportable("an open claim shows nothing")
    statement = Statement(record)
    found = Proved()
    if verdict != "false" and made is not None:
        found |= about(statement, "printed" if verdict == "proved" else "corrected", certificate, made)
    elif verdict != "false":
        found |= _translated(PROOFS, kind)(statement, "printed" if verdict == "proved" else "corrected", certificate)
    if verdict in ("misprint", "error", "false"):
        refutation = certificate if verdict == "false" else certificate["refutation"]
        found |= _translated(REFUTATIONS, kind)(statement, "printed", refutation)
    if not found:
        raise Silent("the matrix has too few rows or columns, which can be seen without a theorem")
    return found


def _translated(exports: Mapping[str, Export], kind: str) -> Export:
    if kind not in exports:
        raise NotExportable(f"no translation of this verdict for claims of kind {kind}")
    return exports[kind]
