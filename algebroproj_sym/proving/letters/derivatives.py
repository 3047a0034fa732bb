"""Derivatives in letters: along a vector, or at a rotation that is perturbed on the left or on the right.

``diff(f, v, d)`` is the derivative of f by e at ``v + e*d``, ``ldiff(f, R, d)`` that at ``exp(skew(e*d))*R``, and
``rdiff(f, R, d)`` that at ``R*exp(skew(e*d))``, each where e is zero.  Other letters are held fixed.
"""

from collections.abc import Sequence

from algebroproj_sym.expressions.letters import ONE, LetterError, Term, factors_of, letters_text, made, number
from algebroproj_sym.proving.letters.statements import Statement, replaced, without_definitions

KINDS = ("diff", "ldiff", "rdiff")
_LINEAR = ("transpose", "trace", "skew", "vee", "vec", "diag", "conj", "pure", "imag", "hat", "ad", "entry")
_BILINEAR = ("product", "dot", "outer", "cross", "qmul", "kron")


def without_derivatives(statement: Statement) -> Statement:
    """Return a statement in which derivatives are worked out; what a constraint defines changes with its letters.

    It raises `LetterError` if something is not differentiated by a free letter, or a function has no rule.

    Examples
    --------
    >>> from algebroproj_sym.expressions.letters import parse_letters
    >>> from algebroproj_sym.proving.letters.properties import declared_letters
    >>> shapes = {"R": (3, 3), "v": (3, 1), "d": (3, 1)}
    >>> left, right = (parse_letters(text, shapes) for text in ("ldiff(R*v, R, d)", "-skew(R*v)*d"))
    >>> statement = Statement(left, right, declared_letters(shapes, {"R": "rotation"}))
    >>> letters_text(without_derivatives(statement).left)
    '(skew(d)*R)*v'
    """
    if not any(map(_has_derivative, statement.terms)):
        return statement
    definitions, rest = without_definitions(statement)

    def worked_out(term: Term) -> Term | None:
        return _worked_out(replaced(term, defined), rest) if term.kind in KINDS else None

    def defined(part: Term) -> Term | None:
        return definitions.get(part.value) if part.kind in ("letter", "symbol") else None

    return statement.every(lambda term: replaced(term, worked_out))


def _has_derivative(term: Term) -> bool:
    return any(part.kind in KINDS for part in factors_of(term))


def _worked_out(term: Term, statement: Statement) -> Term:
    parts = [_worked_out(part, statement) for part in term.parts]
    if term.kind not in KINDS:
        return made(term.kind, *parts, value=term.value) if parts else term
    form, letter, direction = parts
    _require_free(term.kind, letter, statement)
    if term.kind != "diff":
        turn = made("skew", direction)
        direction = made("product", turn, letter) if term.kind == "ldiff" else made("product", letter, turn)
    found = _derivative(form, letter, direction)
    return _zero(form) if found is None else found


def _require_free(kind: str, letter: Term, statement: Statement) -> None:
    """Reject what is not a letter, is bound by a constraint, or does not stay what it is where it is changed."""
    needed = "a letter without properties" if kind == "diff" else "a letter that is a rotation"
    good = letter.kind == "letter" or (kind == "diff" and letter.kind == "symbol")
    if good and letter.kind == "letter":
        properties = statement.letters[letter.value].properties
        good = not properties if kind == "diff" else "orthogonal" in properties
    if not good:
        raise LetterError(f"{kind}: expected {needed}, got {letters_text(letter)}")
    if letter.kind == "symbol" and letter.value in statement.size_names:
        raise LetterError(f"{kind}: expected a letter that is not a size, got {letters_text(letter)}")
    if any(letter in factors_of(constraint) for constraint in statement.constraints):
        raise LetterError(f"{kind}: expected a letter that no constraint binds, got {letters_text(letter)}")


def _zero(form: Term) -> Term:
    return number(0) if form.shape == ONE else made("zeros", value=form.shape)


def _derivative(form: Term, letter: Term, change: Term) -> Term | None:
    """Return the derivative of a form where a letter changes; None if it is zero."""
    if form == letter:
        return change
    inner = [_derivative(part, letter, change) for part in form.parts]
    if not any(part is not None for part in inner):
        return None
    if form.kind == "sum":
        return _sum([part for part in inner if part is not None])
    if form.kind in _LINEAR:
        return made(form.kind, *(part for part in inner if part is not None), value=form.value)
    if form.kind == "block":
        parts = (_zero(part) if d is None else d for part, d in zip(form.parts, inner, strict=True))
        return made("block", *parts, value=form.value)
    if form.kind in _BILINEAR:
        return _by_parts(form.kind, form.parts, inner)
    return _of_one(form, inner[0])


def _by_parts(kind: str, parts: Sequence[Term], inner: Sequence[Term | None]) -> Term:
    terms = [
        made(kind, *(change if place == other else part for other, part in enumerate(parts)))
        for place, change in enumerate(inner)
        if change is not None
    ]
    return _sum(terms)


def _of_one(form: Term, change: Term | None) -> Term | None:
    """Return the derivative of a function of one part by the chain rule."""
    (part,) = form.parts
    assert change is not None
    if form.kind == "power":
        if not form.value:
            return None
        factor, changed = part, change
        if form.value < 0:
            factor = made("power", part, value=-1)
            changed = made("product", number(-1), factor, change, factor)
        count = abs(form.value)
        return _by_parts("product", [factor] * count, [changed] * count)
    if form.kind == "det":
        return made("trace", made("product", made("adj", part), change))
    if form.kind == "norm":
        return made("product", made("dot", part, change), made("power", form, value=-1))
    if form.kind == "sin":
        return made("product", made("cos", part), change)
    if form.kind == "cos":
        return made("product", number(-1), made("sin", part), change)
    if form.kind == "exp" and part.kind == "skew" and change.kind == "skew":
        turned = made("product", made("jl", part.parts[0]), change.parts[0])
        return made("product", made("skew", turned), form)
    raise LetterError(f"derivative: expected a function that has a rule, got {letters_text(form)}")


def _sum(terms: list[Term]) -> Term:
    return terms[0] if len(terms) == 1 else made("sum", *terms)
