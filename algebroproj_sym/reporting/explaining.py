"""Everything about a claim as lines of text; what is long is folded, with its size and its beginning."""

import ast
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import Any

import sympy
from rich.text import Text

from algebroproj_sym.declaring import KINDS, Claim, Judgement, Quote, in_derived_terms, statement_text
from algebroproj_sym.expressions import TextForm, evaluate, size
from algebroproj_sym.expressions.arranging import LONG, arranged
from algebroproj_sym.proving import reduced
from algebroproj_sym.reporting.tables import verdict_text
from algebroproj_sym.showing.arranging import Part, as_declared, shown
from algebroproj_sym.showing.difference import differing_entries
from algebroproj_sym.showing.display import evidence_lines, folded
from algebroproj_sym.showing.forms import derived_form
from algebroproj_sym.showing.naming import Named, in_names

LABEL = 12
"""Width of the column of labels."""
ROW = 68
"""Width of what stands beside them, on a terminal of 80 columns."""
LONGEST_FORM = LONGEST_LIST = 6 * ROW
LONGEST_MEANING = 2 * ROW
LONGEST_QUOTE = 5 * ROW
LONGEST_ENTRY = ROW - 20
"""Characters of what is not shortened: forms and lists, values of names, quotes, entries that differ."""
MOST_ROWS = 16
MOST_DIFFERING = 4
FULL = "To see everything in full, add --full."
ENTRIES = "To see the entries, add --full."

Line = tuple[str, str]


def explanation(
    judgement: Judgement,
    module: str,
    functions: Sequence[str],
    quote: Quote | None = None,
    *,
    follows: str = "",
    full: bool = False,
) -> Text:
    """Return everything about one claim: at most 60 lines on a terminal of 80 columns, unless it is to be in `full`."""
    claim = judgement.claim
    text = Text(f"{claim.paper} ({claim.number})  {claim.title}\n", style="bold")
    text.append(f"{'verdict':<{LABEL}}", style="not bold").append_text(verdict_text(judgement.verdict))
    declared = "" if judgement.as_declared else f", declared {claim.expected}"
    text.append(f"{declared}, a claim of kind {claim.kind}\n", style="not bold")
    about = list(_about(judgement, full=full))
    lines = [
        *([("quoted", f"line {quote.line}: {_cut(quote.text, full, LONGEST_QUOTE)}")] if quote else []),
        *([("read as", edit.text) for edit in quote.edits] if quote else []),
        *([("not read", quote.why)] if quote and quote.why else []),
        *about,
        *([("note", claim.note)] if claim.note else []),
        *([("follows", follows)] if follows else []),
        *([("same as", f"({claim.same_as})")] if claim.same_as else []),
        ("derived in", module),
        *([("functions", ", ".join(functions))] if functions else []),
        *([("", ENTRIES)] if claim.stated and not full else []),
        *([("", FULL)] if any("…" in line for _, line in about) else []),
    ]
    return text.append(_laid_out(lines), style="not bold")


def failure_text(judgement: Judgement) -> str:
    """Return why a claim is not as declared: both verdicts, both forms, their difference, and where they differ."""
    claim = judgement.claim
    verdict = ("verdict", f"{judgement.verdict}, declared {claim.expected}")
    heading = f"{claim.paper} ({claim.number})  {claim.title}\n"
    return heading + _laid_out([verdict, *_about(judgement, full=False)]).rstrip("\n")


def form_lines(claim: Claim, part: Part, most: int, *, full: bool = False) -> list[str]:
    """Return a form of a claim, a row of a matrix in each line; a long one by the names of what it is made of.

    One of more than `most` characters is long, unless all is to be shown in `full`.
    """
    form = arranged(derived_form(claim)) if part == "derived" else as_declared(claim, part)
    rows = plain_rows(form)
    if part in claim.stated:
        return [*rows, *(f"= {row}" for row in plain_rows(getattr(claim, part)))] if full else rows
    if full or (sum(map(len, rows)) <= most and len(rows) <= MOST_ROWS):
        return rows
    named = in_names(claim, part)
    if named is None:
        return shared_out(rows, most)
    return [named.text, f"… {_size(form, rows)}", *(f"where {meaning}" for meaning in _meanings(named))]


def finding_line(judgement: Judgement) -> str:
    """Return in a line what is printed and what is right: the first entries that differ, where it is a matrix."""
    claim = judgement.claim
    if claim.printed is None:
        return f"reconstructed as {folded(_text_of(claim, 'corrected'), LONGEST_ENTRY)}"
    if entries := _differing(claim, full=False):
        return "; ".join(
            entries[:2] if len(entries) < 3 else [entries[0], f"… and {len(differing_entries(claim)) - 1} more entries"]
        )
    if claim.corrected is not None:
        printed, corrected = apart(_text_of(claim, "printed"), _text_of(claim, "corrected"), LONGEST_ENTRY)
        return f"printed {printed}, corrected {corrected}"
    instead = f"; true instead: ({claim.instead})" if claim.instead else ""
    return f"printed {folded(_text_of(claim, 'printed'), LONGEST_ENTRY)}{instead}"


def _text_of(claim: Claim, part: Part) -> str:
    if as_text := KINDS[claim.kind].text:
        return as_text(getattr(claim, part))
    return ", ".join(plain_rows(as_declared(claim, part)))


def apart(left: str, right: str, most: int) -> tuple[str, str]:
    """Return two texts; if one is long, of both only where they begin to differ.

    Examples
    --------
    >>> apart("a + b", "a - b", 10)
    ('a + b', 'a - b')
    >>> apart("alpha*beta*gamma + delta*epsilon", "alpha*beta*gamma - delta*epsilon", 20)
    ('…gamma + delta*epsil… (32 characters)', '…gamma - delta*epsil… (32 characters)')
    """
    if max(len(left), len(right)) <= most:
        return left, right
    if min(len(left), len(right)) <= most // 3:
        return folded(left, most), folded(right, most)
    common = next((place for place, pair in enumerate(zip(left, right, strict=False)) if pair[0] != pair[1]), 0)
    start = max(0, common - most // 3)
    cut = [f"{'…' if start else ''}{text[start:][: most - 1]}" for text in (left, right)]
    ends = ["" if start + most > len(text) else "…" for text in (left, right)]
    sizes = [f"{end} ({len(text):,} characters)" for end, text in zip(ends, (left, right), strict=True)]
    return cut[0] + sizes[0], cut[1] + sizes[1]


def _about(judgement: Judgement, *, full: bool) -> Iterator[Line]:
    """Yield what is the same for a claim that is explained and for one that has failed."""
    claim = judgement.claim
    seen: set[str] = set()
    for part in ("printed", "derived", "corrected"):
        if part == "derived" and claim.relation != "=":
            yield "relation", f"printed {claim.relation} derived"
        if getattr(claim, part) is not None:
            lines = [line for line in form_lines(claim, part, LONGEST_FORM, full=full) if line not in seen]
            yield from _labelled(part, lines)
            seen |= {line for line in lines if line.startswith("where ")}
    yield from _labelled("differs", _differing(claim, full))
    where = [f"{symbol} = {shown(arranged(reduced(value)))}" for symbol, value in claim.where.items()]
    yield from _labelled("where", where if full else shared_out(where, LONGEST_LIST))
    yield from _labelled("difference", _difference(judgement, full))
    yield from _labelled("evidence", evidence_lines(judgement, full=full))
    yield from _labelled("", _values(judgement, full))


def _labelled(label: str, lines: Iterable[str]) -> Iterator[Line]:
    for place, line in enumerate(lines):
        yield ("" if place else label), line


def _laid_out(lines: Iterable[Line]) -> str:
    return "".join(f"{label:<{LABEL}}{line}\n" for label, line in lines)


def _cut(text: str, full: bool, most: int = LONGEST_MEANING) -> str:
    return text if full else folded(text, most)


def shared_out(lines: Sequence[str], most: int) -> list[str]:
    """Return some lines in so many characters: the first ones, each at least as long as a row."""
    count = min(len(lines), most // ROW)
    more = [f"… and {len(lines) - count} more"] if count < len(lines) else []
    return [*(folded(line, max(most // count, ROW)) for line in lines[:count]), *more]


def plain_rows(form: Any) -> list[str]:
    """Return a form as text, a row of a matrix in each line."""
    if not isinstance(form, sympy.MatrixBase):
        return [_text(form)]
    return [f"[{', '.join(map(_text, form.row(i)))}]" for i in range(form.rows)]


def _text(form: Any) -> str:
    is_long = isinstance(form, sympy.Expr) and size(form, LONG) > LONG
    return statement_text(form) or "" if is_long else shown(form)


def _size(form: Any, rows: Sequence[str]) -> str:
    what = f"{form.rows} × {form.cols} matrix" if isinstance(form, sympy.MatrixBase) else "expression"
    return f"{what} of {sum(map(len, rows)):,} characters"


def _meanings(named: Named) -> Iterator[str]:
    for meaning in named.meanings:
        written = meaning.written
        value = ast.unparse(written) if written is not None else ", ".join(plain_rows(arranged(meaning.value)))
        yield f"{meaning.name} = {folded(value, LONGEST_MEANING)}"


def _differing(claim: Claim, full: bool) -> list[str]:
    """Return the entries of a matrix that are refuted: as printed, and as corrected if a correction is declared."""
    places = [place for place, _, _ in differing_entries(claim)]
    if not places:
        return []
    right: Part = "derived" if claim.corrected is None else "corrected"
    printed, correct = (as_declared(claim, part) for part in ("printed", right))
    count = len(places) if full else min(len(places), MOST_DIFFERING)
    lines = []
    for place in places[:count]:
        row, column = divmod(place, claim.derived.cols)  # type: ignore[union-attr]
        whole = [shown(form[place]) for form in (printed, correct)]  # type: ignore[index]
        pair = whole if full else apart(whole[0], whole[1], LONGEST_ENTRY)
        lines.append(f"row {row + 1}, column {column + 1}: printed {pair[0]}, {right} {pair[1]}")
    return lines if count == len(places) else [*lines, f"… and {len(places) - count} more entries"]


def _difference(judgement: Judgement, full: bool) -> Iterator[str]:
    claim = judgement.claim
    scalar = isinstance(claim.printed, sympy.Expr) and not isinstance(claim.printed, sympy.MatrixBase)
    if not judgement.counterexample or not KINDS[claim.kind].is_equality or not scalar:
        return
    printed: Any = in_derived_terms(claim.printed, claim.where)
    yield f"printed - derived = {_cut(shown(arranged(reduced(printed - claim.derived))), full)}"


def sides_at_counterexample(judgement: Judgement) -> list[tuple[Fraction, Fraction]]:
    """Return what is printed and what is derived at the counterexample of an equality, entry by entry."""
    claim, point = judgement.claim, judgement.counterexample
    if not point or not KINDS[claim.kind].is_equality or claim.printed is None or claim.derived is None:
        return []
    if isinstance(claim.derived, TextForm):
        return [] if claim.kind == "identity up to scale" else [*_recorded_sides(judgement)]
    sides = evaluate(in_derived_terms(claim.printed, claim.where), point), evaluate(claim.derived, point)
    return list(zip(*sides, strict=True))


def _recorded_sides(judgement: Judgement) -> Iterator[tuple[Fraction, Fraction]]:
    """Yield the values of both sides in letters, which the evidence has; values of real functions are not exact."""
    certificate = judgement.certificate or {}
    refutation = certificate.get("refutation", certificate)
    if "left" in refutation:
        sides = ([Fraction(entry) for row in refutation[side] for entry in row] for side in ("left", "right"))
        yield from zip(*sides, strict=True)


def _values(judgement: Judgement, full: bool) -> Iterator[str]:
    """Yield what both sides are at the counterexample, where they differ."""
    proportional = judgement.claim.kind == "identity up to scale"
    different = [pair for pair in sides_at_counterexample(judgement) if pair[0] != pair[1] or proportional]
    for label, values in zip(("printed", "derived"), zip(*different, strict=True), strict=False):
        yield f"at this point {label} = {_cut(', '.join(map(str, values)), full)}"
