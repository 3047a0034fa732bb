"""The evidence for a verdict as readable data: points, values, cofactors."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy
from markupsafe import Markup

from algebroproj_sym.declaring import KINDS, Claim, Judgement
from algebroproj_sym.declaring.claim import in_derived_terms
from algebroproj_sym.expressions import evaluate, shape, text
from algebroproj_sym.reporting.site.formulas import bullet, symbol
from algebroproj_sym.reporting.site.tables import Table

LONGEST_VALUE = 1200

METHODS = {
    "normal form": "Both sides have the same normal form in the field of rational functions over Q.",
    "ideal membership": "The numerator of the difference, times the multiplier, is a combination of the constraints: "
    "the cofactors are below, and multiplied out they give it.",
    "radical membership": "A power of the numerator of the difference is a combination of the constraints.",
    "sums of squares": "Squares that add up to zero are zero over the reals; then the numerator of the difference is.",
    "case distinction": "The numerator of the difference is zero in each of some cases, one of which always holds.",
    "exact rounding": "The exact number, rounded as declared, was compared with the printed one.",
    "rank at a point and kernel vectors": "From below by the exact rank at a rational point, from above by vectors "
    "that are taken to zero.",
    "factorisation": "The irreducible factors of the numerator were compared with the printed ones.",
    "instance": "The notation is well-formed; one exact instance is below.",
    "comparison of references": "The reference was compared with what it must point to.",
    "counterexample": "At an exact rational point it does not hold.",
    "leading coefficients": "The limit is the quotient of the coefficients of the lowest powers.",
    "kernel vectors": "Vectors that are taken to zero bound the rank from above.",
    "divergence": "The expression has a pole there.",
}
_SHOWN_ELSEWHERE = ("method", "reason", "refutation", "entries", "left", "right", "witness", "point", "instance")


@dataclass(frozen=True)
class Evidence:
    """The evidence for a verdict.

    Attributes
    ----------
    sentences : tuple of str
        How the verdict was found.
    hypotheses : tuple of Markup
        What must not vanish.
    tables : tuple of Table
        Points, values and certificates.
    complete : bool
        Whether nothing was too long to be shown.
    """

    sentences: tuple[str, ...]
    hypotheses: tuple[Markup, ...]
    tables: tuple[Table, ...]
    complete: bool


def evidence(judgement: Judgement) -> Evidence:
    """Return the evidence for a verdict."""
    certificate: Mapping[str, Any] = judgement.certificate or {}
    refutation: Mapping[str, Any] = certificate.get("refutation") or {}
    tables = [
        *_counterexample(judgement),
        *_data("Refutation of the printed form", _rest(refutation, judgement)),
        *(_points(certificate)),
        *_cofactors(judgement.claim, certificate),
        *_data("Certificate", _rest(certificate, judgement)),
    ]
    hypotheses = tuple(map(bullet, judgement.hypotheses))
    cut = [cell for table in tables for row in table.rows for cell in row if "…" in cell]
    return Evidence(_sentences(judgement, certificate, refutation), hypotheses, tuple(tables), not cut)


def _sentences(judgement: Judgement, certificate: Mapping[str, Any], refutation: Mapping[str, Any]) -> tuple[str, ...]:
    method = certificate.get("method", "")
    if method == "none":
        return (f"Undecided: {certificate['reason']}.",)
    found = METHODS.get(method, method)
    if judgement.verdict in ("misprint", "error"):
        return f"The printed form: {_lowered(METHODS.get(refutation.get('method', ''), ''))}", (
            f"The corrected form: {_lowered(found)}"
        )
    if judgement.verdict == "illegible":
        return (f"The reconstruction: {_lowered(found)}",)
    return (found,) if found else ()


def _lowered(sentence: str) -> str:
    return sentence[:1].lower() + sentence[1:]


def _counterexample(judgement: Judgement) -> list[Table]:
    point = judgement.counterexample
    if not point:
        return []
    rows = [(symbol(key.name), _fraction(value)) for key, value in point.items()]
    tables = [Table("Counterexample: a point at which it fails", ("symbol", "value"), rows)]
    values = _values(judgement.claim, point)
    if values:
        note = ", which are not proportional" if judgement.claim.kind == "identity up to scale" else ""
        tables.append(Table(f"Both sides at this point{note}", ("entry", "printed", "derived"), values))
    return tables


def _values(claim: Claim, point: Mapping[sympy.Symbol, Fraction]) -> list[tuple[Markup | str, ...]]:
    if not KINDS[claim.kind].is_equality or claim.printed is None or claim.derived is None:
        return []
    printed: Any = in_derived_terms(claim.printed, claim.where)
    try:
        pairs = list(zip(evaluate(printed, point), evaluate(claim.derived, point), strict=True))
    except (KeyError, ZeroDivisionError):
        return []
    marked = claim.kind != "identity up to scale"
    return [
        (_place(claim, k), _fraction(p, marked and p != d), _fraction(d, marked and p != d))
        for k, (p, d) in enumerate(pairs)
    ]


def _place(claim: Claim, place: int) -> str:
    if not shape(claim.derived):
        return "value"
    width = claim.derived.cols  # type: ignore[union-attr]
    return f"row {place // width + 1}, column {place % width + 1}"


def _fraction(value: Fraction, marked: bool = False) -> Markup | str:
    return Markup('<mark class="differs">{}</mark>').format(value) if marked else str(value)


def _points(certificate: Mapping[str, Any]) -> list[Table]:
    captions = {
        "witness": "Witness: a point that satisfies constraints and hypotheses",
        "point": "The point from below",
        "instance": "Instance",
    }
    return [
        Table(caption, ("symbol", "value"), [(symbol(name), value) for name, value in certificate[key].items()])
        for key, caption in captions.items()
        if certificate.get(key)
    ]


def _cofactors(claim: Claim, certificate: Mapping[str, Any]) -> list[Table]:
    rows = []
    for k, entry in enumerate(certificate.get("entries", ()), 1):
        if "steps" in entry or "cases" in entry:
            rows.append((f"entry {k}", "in steps", _code(str(entry))))
        elif "cofactors" in entry:
            for place, cofactor in entry["cofactors"].items():
                rows.append((f"entry {k}, constraint {int(place) + 1}", _code(entry["multiplier"]), _code(cofactor)))
    if not rows:
        return []
    return [Table("Cofactors of the constraints", ("of", "multiplier", "cofactor"), rows)]


def _rest(certificate: Mapping[str, Any], judgement: Judgement) -> Mapping[str, Any]:
    known = {text(factor) for factor in judgement.hypotheses}
    return {
        key: value
        for key, value in certificate.items()
        if key not in _SHOWN_ELSEWHERE
        and value not in ((), [], {})
        and not (key == "denominators" and {*value} <= known)
    }


def _data(caption: str, record: Mapping[str, Any]) -> list[Table]:
    if not record:
        return []
    return [Table(caption, ("what", "value"), [(key, _readable(value)) for key, value in record.items()])]


def _readable(value: Any) -> Markup | str:
    if isinstance(value, Sequence) and not isinstance(value, str):
        return Markup("<ul>{}</ul>").format(_items(value))
    return _code(value) if isinstance(value, str) else str(value)


def _items(values: Iterable[Any]) -> Markup:
    texts = [" ^ ".join(map(str, value)) if isinstance(value, list | tuple) else str(value) for value in values]
    return Markup("").join(Markup("<li>{}</li>").format(_code(text)) for text in texts)


def _code(text: str) -> Markup:
    return Markup("<code>{}</code>").format(_cut(text))


def _cut(text: str) -> str:
    return text if len(text) <= LONGEST_VALUE else f"{text[:LONGEST_VALUE]} … ({len(text)} characters)"
