"""Exponential maps and angles in letters, as polynomials in numbers.

A skew matrix K of a vector v has K**3 = -N*K, where N is the square of the length of v.  So its exponential is a
polynomial in K, with numbers that are series in N: Stumpff's functions, c_k = 1/k! - N/(k + 2)! + ...  They are entire,
so nothing is divided by an angle.  Two neighbours among them give all others below by ``c_k = 1/k! - N*c_(k+2)``, and
one equation, the sum of the squares of sine and cosine, is all that holds between these two and N.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import factorial, isqrt, prod

from algebroproj_sym.expressions.letters import (
    ONE,
    LetterError,
    Term,
    factors_of,
    letters_text,
    made,
    minus,
    number,
    parse_letters,
)
from algebroproj_sym.proving.letters.properties import Letter
from algebroproj_sym.proving.letters.statements import Statement, replaced

SERIES: Mapping[str, Sequence[str]] = {
    "exp skew": ("1", "c1", "c2"),
    "exp hat": ("1", "1", "c2", "c3"),
    "exp ad": ("1", "1 + N*(c2 - 3*c3)/2", "2*c2 - c1/2", "(c2 - c3)/2", "(c3 - 2*c4)/2"),
    "jl skew": ("1", "c2", "c3"),
    "jl ad": ("1", "2*c2 - c1/2", "(5*c3 - c2)/2", "(c3 - 2*c4)/2", "(c4 - 3*c5)/2"),
}
"""The coefficients of the powers of a matrix: of its exponential, and of the Jacobian ``1 + M/2! + M**2/3! + ...``.

They follow from ``K**3 = -N*K`` for ``skew``, ``M**4 = -N*M**2`` for ``hat`` and ``M*(M**2 + N)**2 = 0`` for ``ad``.
"""
RELATIONS: Mapping[int, str] = {
    0: "c0**2 + N*c1**2 - 1",
    1: "c1**2 + N*c2**2 - 2*c2",
    2: "c1**2 + N*c2**2 - 2*c2",
    3: "N*c3**2 - 2*c3 + 2*c4 + c2**2",
    4: "N*c3**2 - 2*c3 + 2*c4 + c2**2",
}
"""What is zero, by the lower one of the two neighbours that are kept."""
DOUBLED: Mapping[int, str] = {0: "2*c0**2 - 1", 1: "c0*c1", 2: "c1**2/2", 3: "(c2 + c3 - N*c2*c3)/4"}
"""The functions of 4*N, that is at the double angle."""
FUNCTIONS = ("sin", "cos", "exp", "jl", "jr", "norm")


def speaks_of_angles(statement: Statement) -> bool:
    """Whether a statement has an exponential map, a sine or cosine, or a length."""
    return any(part.kind in FUNCTIONS for term in statement.terms for part in factors_of(term))


def without_series(statement: Statement) -> tuple[list[Term], Statement]:
    """Return the angles of a statement, as vectors or numbers, and the statement in numbers that stand for series.

    It raises `LetterError` if there is an exponential of another matrix, or a name is taken.
    """
    return _Translation(statement).result()


@dataclass(frozen=True)
class _Angle:
    """A multiple of a vector, or of a number: the functions depend on the square of its length."""

    core: Term
    factor: Fraction


class _Translation:
    def __init__(self, statement: Statement) -> None:
        self.statement = statement
        parts = dict.fromkeys(part for term in statement.terms for part in factors_of(term) if part.kind in FUNCTIONS)
        angles = [angle for part in parts for angle in self.angles(part)]
        self.cores = sorted({angle.core for angle in angles}, key=letters_text)
        self.bases = {
            core: min(abs(angle.factor) for angle in angles if angle.core == core and angle.factor)
            for core in self.cores
            if any(angle.core == core and angle.factor for angle in angles)
        }
        self.highest: dict[Term, int] = {}
        self.lengths: set[Term] = set()
        for part in parts:
            self.count(part)
        taken = {
            part.value for term in statement.terms for part in factors_of(term) if part.kind in ("symbol", "letter")
        }
        for name in (
            f"{kind}_{place + 1}"
            for kind in ("c0", "c1", "c2", "c3", "c4", "c5", "length")
            for place in range(len(self.cores))
        ):
            if name in taken:
                raise LetterError(f"expected another name than {name}, which stands for a function of an angle")

    def result(self) -> tuple[list[Term], Statement]:
        known: dict[Term, Term] = {}
        plain = self.statement.every(lambda term: self.plain(term, known))
        return self.cores, replace(plain, constraints=(*plain.constraints, *self.relations(known)))

    # -- angles

    def angles(self, part: Term) -> list[_Angle]:
        """Return the angles of which a part is a function: of a sum of numbers, those of its terms."""
        if part.kind in ("sin", "cos"):
            return [self.angle(term) for term in _terms(part.parts[0])]
        if part.kind == "exp" and (unit := self.about_unit(part.parts[0])) is not None:
            return [self.angle(term) for term in _terms(unit)]
        return [self.angle(turned(part, self.statement.letters))]

    def count(self, part: Term) -> None:
        """Note which functions are needed."""
        for angle in self.angles(part):
            if part.kind == "norm":
                self.lengths.add(angle.core)
                continue
            if part.kind in ("sin", "cos") or (part.kind == "exp" and self.about_unit(part.parts[0]) is not None):
                needed = 1
            else:
                needed = {"exp skew": 2, "exp hat": 3, "exp ad": 4, "jl skew": 3, "jl ad": 5}[name_of(part)]
            base = self.bases.get(angle.core)
            if base is not None and angle.factor and abs(angle.factor) != base:
                if needed > 3:
                    raise LetterError("expected one angle in exponentials of this size, got multiples of it")
                needed = max(needed, 1)
            self.highest[angle.core] = max(self.highest.get(angle.core, 1), needed)

    def angle(self, term: Term) -> _Angle:
        """Return what the length of a term is a multiple of; rotations, signs and unit vectors do not change it."""
        if term.kind == "number":
            return _Angle(number(1), term.value)
        if term.kind == "norm":
            return self.angle(term.parts[0])
        if term.kind == "letter" and "unit" in self.statement.letters[term.value].properties:
            return _Angle(number(1), Fraction(1))
        if term.kind == "power" and term.value == -1 and term.parts[0].kind == "number":
            return _Angle(number(1), 1 / term.parts[0].value)
        if (length := constant_length(term)) is not None:
            return _Angle(number(1), length)
        if term.kind != "product":
            return _Angle(term, Fraction(1))
        parts = _flat(term)
        factor = prod((part.value for part in parts if part.kind == "number"), start=Fraction(1))
        numbers = [part for part in parts if part.shape == ONE and part.kind != "number"]
        chain = [part for part in parts if part.shape != ONE]
        while len(chain) > 1 and is_orthogonal(chain[0], self.statement.letters):
            chain.pop(0)
        length = constant_length(chain[0]) if len(chain) == 1 else None
        factor *= length or 1
        rest = numbers if length is not None or (len(chain) == 1 and self.is_unit(chain[0])) else [*numbers, *chain]
        if not rest or not factor:
            return _Angle(number(1), factor)
        if len(rest) > 1:
            return _Angle(made("product", *rest), factor)
        inner = self.angle(rest[0])
        return _Angle(inner.core, inner.factor * factor)

    def is_unit(self, term: Term) -> bool:
        return term.kind == "letter" and "unit" in self.statement.letters[term.value].properties

    def about_unit(self, matrix: Term) -> Term | None:
        """Return the number x where a matrix is the cross-product matrix of x times a unit vector that is a letter."""
        factors = _flat(matrix)
        if not factors or factors[-1].kind != "skew":
            return None
        factors = [*factors[:-1], *_flat(factors[-1].parts[0])]
        units = [factor for factor in factors if self.is_unit(factor)]
        scalars = [factor for factor in factors if factor.shape == ONE]
        if len(units) != 1 or len(scalars) != len(factors) - 1:
            return None
        return scalars[0] if len(scalars) == 1 else made("product", *scalars) if scalars else number(1)

    # -- numbers

    def square(self, core: Term) -> Term:
        """Return the square of the length of the base of a core."""
        base = self.bases.get(core, Fraction(1))
        square = made("power", core, value=2) if core.shape == ONE else made("dot", core, core)
        return square if base == 1 else made("product", number(base**2), square)

    def stumpff(self, degree: int, angle: _Angle, known: dict[Term, Term]) -> Term:
        """Return the function c_k of an angle."""
        if not angle.factor:
            return number(Fraction(1, factorial(degree)))
        ratio = abs(angle.factor) / self.bases[angle.core]
        place = self.cores.index(angle.core) + 1
        square = self.plain(self.square(angle.core), known)
        pair = self.highest[angle.core] - 1
        doublings = ratio.numerator.bit_length() - 1
        if ratio != 2**doublings:
            raise LetterError(f"expected angles that are doubled, got {ratio} times {letters_text(angle.core)}")
        return _number_of(degree, pair, place, square, doublings)

    def relations(self, known: dict[Term, Term]) -> list[Term]:
        """Return what is zero for the numbers that stand for functions, and lengths."""
        found = []
        for place, core in enumerate(self.cores, 1):
            if core in self.highest and core in self.bases:
                square, pair = self.plain(self.square(core), known), self.highest[core] - 1
                found.append(_filled(RELATIONS[pair], pair, place, square))
            if core in self.lengths:
                square = made("power", core, value=2) if core.shape == ONE else made("dot", core, core)
                length = made("power", Term("symbol", ONE, (), f"length_{place}"), value=2)
                found.append(minus(length, self.plain(square, known)))
        return found

    # -- terms

    def plain(self, term: Term, known: dict[Term, Term]) -> Term:
        """Return a term in which the functions are polynomials."""
        if term not in known:
            known[term] = self._plain(term, known)
        return known[term]

    def _plain(self, term: Term, known: dict[Term, Term]) -> Term:
        if term.kind in ("sin", "cos"):
            return self.of_sum(term.kind, _terms(term.parts[0]), known)
        if term.kind == "norm":
            angle = self.angle(term.parts[0])
            length = Term("symbol", ONE, (), f"length_{self.cores.index(angle.core) + 1}")
            return made("product", number(abs(angle.factor)), length)
        if term.kind not in ("exp", "jl", "jr"):
            parts = [self.plain(part, known) for part in term.parts]
            return made(term.kind, *parts, value=term.value) if parts else term
        if term.kind == "exp" and (unit := self.about_unit(term.parts[0])) is not None:
            (axis,) = (part for part in factors_of(term.parts[0]) if self.is_unit(part))
            matrix = made("skew", axis)
            sine, cosine = (self.of_sum(kind, _terms(unit), known) for kind in ("sin", "cos"))
            return _series((number(1), sine, minus(number(1), cosine)), matrix)
        angle, name = self.angle(turned(term, self.statement.letters)), name_of(term)
        matrix = self.plain(matrix_of(term), known)
        square = self.plain(self.square(angle.core), known)
        values = {
            f"c{k}": self.stumpff(k, angle, known) for k in range(6) if any(f"c{k}" in text for text in SERIES[name])
        }
        scale = number((abs(angle.factor) / self.bases[angle.core]) ** 2) if angle.factor else number(0)
        values["N"] = made("product", scale, square)
        coefficients = (_put(parse_letters(text, {}), values) for text in SERIES[name])
        return _series((*coefficients,), matrix)

    def of_sum(self, kind: str, terms: Sequence[Term], known: dict[Term, Term]) -> Term:
        """Return the sine or cosine of a sum."""
        first, *others = terms
        angle = self.angle(first)
        sine = made("product", self.plain(first, known), self.stumpff(1, angle, known))
        cosine = self.stumpff(0, angle, known)
        if not others:
            return sine if kind == "sin" else cosine
        other_sine, other_cosine = (self.of_sum(each, others, known) for each in ("sin", "cos"))
        if kind == "sin":
            return made("sum", made("product", sine, other_cosine), made("product", cosine, other_sine))
        return minus(made("product", cosine, other_cosine), made("product", sine, other_sine))


def constant_length(term: Term) -> Fraction | None:
    """Return the length of a vector of numbers, if that is one and the length is rational and not zero."""
    if term.kind != "block" or term.shape[1] != 1 or any(part.kind != "number" for part in term.parts):
        return None
    square = sum((part.value**2 for part in term.parts), Fraction(0))
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return root if root and root**2 == square else None


def matrix_of(part: Term) -> Term:
    """Return the matrix of which an exponential or a Jacobian is a series."""
    (argument,) = part.parts
    if part.kind == "exp":
        return argument
    signed = made("product", number(-1), argument) if part.kind == "jr" else argument
    return made("skew" if argument.shape[0] == 3 else "ad", signed)


def turned(part: Term, letters: Mapping[str, Letter]) -> Term:
    """Return the vector, or the number, the length of which is the angle of a function."""
    (argument,) = part.parts
    if part.kind in ("sin", "cos", "norm"):
        return argument
    if part.kind in ("jl", "jr"):
        return argument if argument.shape[0] == 3 else last_three(argument)
    scalars = [part for part in _flat(argument) if part.shape == ONE]
    factors = [part for part in _flat(argument) if part.shape != ONE]
    while (
        argument.shape == (3, 3)
        and len(factors) > 2
        and _is_transposed(factors[0], factors[-1])
        and is_orthogonal(factors[0], letters)
    ):
        factors = factors[1:-1]
    core = factors[0]
    if core.kind == "letter" and core.shape == (3, 3) and "skew" in letters[core.value].properties:
        core = made("skew", made("vee", core))
    if len(factors) > 1 or core.kind not in ("skew", "hat", "ad"):
        known = "skew(v), hat(x) or ad(x), or a multiple, or R*skew(v)*R.T with an orthogonal R"
        raise LetterError(f"exp: expected {known}, got {letters_text(argument)}")
    vector = core.parts[0] if core.kind == "skew" else last_three(core.parts[0])
    return made("product", *scalars, vector) if scalars else vector


def last_three(motion: Term) -> Term:
    """Return the rotation vector of a motion."""
    if motion.kind == "block" and [part.shape for part in motion.parts] == [(3, 1), (3, 1)]:
        return motion.parts[1]
    if motion.kind == "product" and len(motion.parts) == 2 and motion.parts[0].shape == ONE:
        return made("product", motion.parts[0], last_three(motion.parts[1]))
    return made("block", *(made("entry", motion, value=(k, 0)) for k in (3, 4, 5)), value=(1, 1, 1))


def name_of(part: Term) -> str:
    """Return which series a function is."""
    kind = {3: "skew", 4: "hat", 6: "ad"}.get(int(part.shape[0]))
    return f"{'exp' if part.kind == 'exp' else 'jl'} {kind}"


def _is_transposed(first: Term, last: Term) -> bool:
    return (last.kind == "transpose" and last.parts[0] == first) or (
        first.kind == "transpose" and first.parts[0] == last
    )


def is_orthogonal(term: Term, letters: Mapping[str, Letter]) -> bool:
    """Whether a term is an orthogonal letter, or the transpose of one."""
    letter = term.parts[0] if term.kind == "transpose" else term
    return letter.kind == "letter" and "orthogonal" in letters[letter.value].properties


def _flat(term: Term) -> list[Term]:
    return [factor for part in term.parts for factor in _flat(part)] if term.kind == "product" else [term]


def _terms(term: Term) -> list[Term]:
    """Return the terms of a sum, which may have a number as a factor."""
    if term.kind == "sum":
        return [each for part in term.parts for each in _terms(part)]
    if (
        term.kind == "product"
        and len(term.parts) == 2
        and term.parts[0].kind == "number"
        and term.parts[1].kind == "sum"
    ):
        return [made("product", term.parts[0], each) for each in _terms(term.parts[1])]
    return [term]


def _series(coefficients: Sequence[Term], matrix: Term) -> Term:
    terms = [made("product", coefficients[0], made("eye", value=matrix.shape[:1]))]
    terms += [
        made("product", coefficient, matrix if power == 1 else made("power", matrix, value=power))
        for power, coefficient in enumerate(coefficients[1:], 1)
    ]
    return made("sum", *terms)


def _put(term: Term, values: Mapping[str, Term]) -> Term:
    return replaced(term, lambda part: values.get(part.value) if part.kind == "symbol" else None)


def _filled(text: str, pair: int, place: int, square: Term) -> Term:
    """Return a polynomial in the functions of an angle, of which two neighbours are symbols."""
    values = {f"c{k}": _number_of(k, pair, place, square, 0) for k in range(6) if f"c{k}" in text}
    return _put(parse_letters(text, {}), {**values, "N": square})


def _number_of(degree: int, pair: int, place: int, square: Term, doublings: int) -> Term:
    """Return the function c_k of an angle that is doubled some times."""
    if doublings:
        text = DOUBLED[degree]
        values = {f"c{k}": _number_of(k, pair, place, square, doublings - 1) for k in range(4) if f"c{k}" in text}
        return _put(parse_letters(text, {}), {**values, "N": made("product", number(4 ** (doublings - 1)), square)})
    if degree > pair + 1:
        raise LetterError("expected one angle in functions of this kind, got multiples of it")
    if degree >= pair:
        return Term("symbol", ONE, (), f"c{degree}_{place}")
    above = _number_of(degree + 2, pair, place, square, 0)
    return minus(number(Fraction(1, factorial(degree))), made("product", square, above))
