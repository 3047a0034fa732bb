"""The evidence for a verdict as readable data: points, values, cofactors."""

import json
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from markupsafe import Markup

from algebroproj_sym.declaring import Judgement, statement_text
from algebroproj_sym.declaring.claim import CORRECTED
from algebroproj_sym.expressions import Matrix, TextForm
from algebroproj_sym.proving import point_record
from algebroproj_sym.reporting.explaining import plain_rows, sides_at_counterexample
from algebroproj_sym.reporting.site.comparison import place_of
from algebroproj_sym.reporting.site.formulas import folded, in_line, symbol
from algebroproj_sym.reporting.site.mathml import math
from algebroproj_sym.reporting.site.tables import Table
from algebroproj_sym.showing.forms import entries_of_letters
from algebroproj_sym.showing.latex import latex
from algebroproj_sym.showing.text_latex import latex_of_text

LONGEST_VALUE = 1200

METHODS = {
    "normal form": "Both sides have the same normal form in the field of rational functions over Q.",
    "ideal membership": "The numerator of the difference, times the multiplier, is a combination of the constraints. "
    "The cofactors are below; multiplying them out shows it.",
    "radical membership": "A power of the numerator of the difference, times the multiplier, is a combination of the "
    "constraints. The cofactors are below; multiplying them out shows it.",
    "sums of squares": "The difference vanishes where a sum of squares does, which the constraints make zero.",
    "case distinction": "The difference vanishes in each of the cases below.",
    "exact rounding": "The exact number, rounded as declared, was compared with the printed one.",
    "rank at a point and kernel vectors": "The exact rank at a rational point bounds the rank from below. Independent "
    "vectors in the kernel bound it from above.",
    "factorisation": "The irreducible factors of the numerator were compared with the printed ones.",
    "instance": "The notation is well-formed. One exact instance is below.",
    "comparison of references": "The printed number was compared with the number of the formula that is meant.",
    "counterexample": "It fails at a rational point, computed exactly.",
    "leading coefficients": "The limit is the quotient of the coefficients of the lowest powers.",
    "kernel vectors": "Independent vectors in the kernel bound the rank from above.",
    "words": "Both sides are equal in the algebra of words: matrices are multiplied as letters, by rules that hold for "
    "matrices of every size that fits. The rules and sums are below.",
    "entries": "Both sides are equal entry by entry, with the entries below for the letters.",
    "real laws": "What is stated follows by the laws of real functions below, wherever the conditions hold.",
    "exact point": "It fails at a point whose coordinates are exact numbers, by the laws of real functions below.",
    "enclosures": "It fails at a rational point. There both sides were enclosed in intervals that show it.",
    "divergence": "The expression has a pole where the variable goes to zero.",
}
_SHOWN_ELSEWHERE = ("method", "reason", "refutation", "entries", "left", "right", "witness", "point", "instance")


def evidence(judgement: Judgement) -> tuple[tuple[str, ...], list[Table]]:
    """Return the evidence for a verdict: sentences on how it was found; points, values and certificates as tables."""
    certificate: Mapping[str, Any] = judgement.certificate or {}
    refutation: Mapping[str, Any] = certificate.get("refutation") or {}
    tables = [
        *_counterexample(judgement),
        *_data("Refutation of the printed form", _rest(refutation, judgement)),
        *_letters(judgement),
        *(_points(certificate)),
        *_cofactors(certificate),
        *_data("Certificate", _rest(certificate, judgement)),
    ]
    return _sentences(judgement, certificate, refutation), tables


def _sentences(judgement: Judgement, certificate: Mapping[str, Any], refutation: Mapping[str, Any]) -> tuple[str, ...]:
    method = certificate.get("method", "")
    if method == "none":
        return (f"Undecided: {certificate['reason']}.",)
    found = METHODS.get(method, method)
    if judgement.verdict in CORRECTED:
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
    tables = [_point("Counterexample: a point at which it fails", point_record(point))]
    values = _values(judgement)
    if values:
        note = ", which are not proportional" if judgement.claim.kind == "identity up to scale" else ""
        tables.append(Table(f"Both sides at this point{note}", ("entry", "printed", "derived"), values))
    return tables


def _values(judgement: Judgement) -> list[tuple[Markup | str, ...]]:
    marked = judgement.claim.kind != "identity up to scale"
    return [
        (place_of(judgement.claim, k), *(_fraction(value, marked and p != d) for value in (p, d)))
        for k, (p, d) in enumerate(sides_at_counterexample(judgement))
    ]


def _point(caption: str, values: Mapping[str, Any]) -> Table:
    rows = [(symbol(name), _value(value)) for name, value in values.items()]
    return Table(caption, ("symbol", "value"), rows, is_point=True)


def _fraction(value: Fraction, marked: bool = False) -> Markup | str:
    return Markup('<mark class="differs">{}</mark>').format(_value(value)) if marked else _value(value)


def _value(value: Any) -> Markup | str:
    """Return a number as text, or a matrix, given by its rows, as a formula."""
    if not isinstance(value, list):
        return str(value).replace("-", "−")
    return in_line(math(latex_of_text(TextForm(str(Matrix(value))))))


def _points(certificate: Mapping[str, Any]) -> list[Table]:
    captions = {
        "witness": "Witness: a point that satisfies constraints and hypotheses",
        "point": "Point with this rank",
        "instance": "Instance",
    }
    return [_point(caption, certificate[key]) for key, caption in captions.items() if certificate.get(key)]


def _letters(judgement: Judgement) -> list[Table]:
    """Return the entries of the letters, and what was decided about them."""
    claim = judgement.claim
    letters = [(symbol(name), in_line(math(latex(form)))) for name, form in entries_of_letters(judgement).items()]
    found = [Table("Entries of the letters", ("letter", "entries"), letters)] if letters else []
    parts = [part for part in ("printed", "derived", "corrected") if part in claim.stated]
    rows = [(part, _code("; ".join(plain_rows(getattr(claim, part))))) for part in parts]
    return [*found, Table("Written out", ("form", "entries"), rows)] if rows else found


def _cofactors(certificate: Mapping[str, Any]) -> list[Table]:
    listed = certificate.get("entries", ())
    if isinstance(listed, Mapping):
        return []
    entries = [(f"entry {k}", entry) for k, entry in enumerate(listed, 1)]
    rows = [
        (f"{name}, constraint {int(i) + 1}", str(entry["exponent"]), _code(entry["multiplier"]), _code(cofactor))
        for name, entry in entries
        for i, cofactor in entry.get("cofactors", {}).items()
        if "steps" not in entry
    ]
    cases = [(name, _code(json.dumps(e))) for name, e in entries if "steps" in e or "cofactors" not in e]
    headings = ("of", "power of the difference", "multiplier", "cofactor")
    tables = (Table("Cofactors of the constraints", headings, rows), Table("Proof by steps", ("of", "steps"), cases))
    return [table for table in tables if table.rows]


def _rest(certificate: Mapping[str, Any], judgement: Judgement) -> Mapping[str, Any]:
    known = {*map(statement_text, judgement.hypotheses)}
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
        if all(isinstance(each, int) for each in value):
            return ", ".join(map(str, value))
        return Markup("<ul>{}</ul>").format(_items(value))
    return _code(value) if isinstance(value, str) else _item(value)


def _items(values: Iterable[Any]) -> Markup:
    return Markup("").join(Markup("<li>{}</li>").format(_code(_item(value))) for value in values)


def _item(value: Any, between: str = " ^ ") -> str:
    if isinstance(value, Mapping):
        return "; ".join(f"{key}: {_item(each, ', ')}" for key, each in value.items())
    return between.join(map(_item, value)) if isinstance(value, list | tuple) else str(value)


def _code(text: str) -> Markup:
    code = Markup("<code>{}</code>").format(text)
    return code if len(text) <= LONGEST_VALUE else folded(f"{len(text):,} characters", code)
