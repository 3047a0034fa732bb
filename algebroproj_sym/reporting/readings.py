"""The equations of a document, with their verdicts: folded for a screen, one after the other, or for programs."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from typing import TYPE_CHECKING, Any

from algebroproj_sym.reading.judging.verdicts import TRUE_HERE
from algebroproj_sym.showing.conditions import simple_conditions
from algebroproj_sym.showing.display import folded

if TYPE_CHECKING:
    from algebroproj_sym.reading import Link, Reading
    from algebroproj_sym.reading.documents.files import Line

MOST_REASONS = 8
MOST_LINES = 12


def reading_record(readings: Sequence[Reading], missing: Sequence[str] = (), whole: str = "") -> dict[str, Any]:
    """Return the equations for JSON, the included files that are missing, and the document of which they are a part."""
    found = {"schema": 1, "equations": [_equation(each) for each in readings], "summary": dict(summary_of(readings))}
    return {**found, "missing": list(missing), "whole": whole or None}


def summary_of(readings: Iterable[Reading]) -> Counter[str]:
    """Return how many equations have which verdict, in alphabetical order."""
    counts: Counter[str] = Counter(each.verdict for each in readings)
    return Counter(dict(sorted(counts.items())))


def decisive(reading: Reading) -> Link | None:
    """Return the link that has the verdict of its equation; None for one that is not read."""
    return next((link for link in reading.links if link.verdict == reading.verdict), None)


def _equation(reading: Reading) -> dict[str, Any]:
    link = decisive(reading)
    rests_on = dict.fromkeys(name for each in reading.links for name in each.rests_on)
    hypotheses = dict.fromkeys(name for each in reading.links for name in each.hypotheses)
    return {
        "file": reading.where.file or None,
        "line": reading.line,
        "number": reading.number,
        "latex": reading.latex,
        "read": reading.read,
        "reason": reason_of(reading),
        "verdict": reading.verdict,
        "rests_on": list(rests_on),
        "hypotheses": list(hypotheses),
        "counterexample": dict(link.counterexample) if link and link.counterexample is not None else None,
        "suggestion": (link.suggestion or None) if link else None,
        "certificate": dict(link.certificate) if link and link.certificate is not None else None,
        "links": [{"verdict": each.verdict, "reason": each.reason} for each in reading.links],
    }


def reason_of(reading: Reading) -> str:
    """Return why an equation has its verdict, where there is more to say than the verdict."""
    link = decisive(reading)
    return reading.reason or (link.reason if link else "")


def reading_lines(
    name: str, readings: Sequence[Reading], missing: Sequence[str] = (), whole: str = "", *, full: bool
) -> Iterator[str]:
    """Yield what a reader wants to see first: contradictions whole, and the others folded by verdict and reason."""
    if full:
        for each in readings:
            yield from _whole(each)
    else:
        for each in readings:
            if each.verdict == "contradicts":
                yield from _whole(each)
        for each in readings:
            link = decisive(each)
            if each.verdict != "contradicts" and link is not None and link.suggestion:
                yield f"{_heading(each)} would follow with {link.suggestion}: {link.reason}"
        for verdict in ("definition", "follows", "independent"):
            alike = [each for each in readings if each.verdict == verdict]
            claimed = [each for each in alike if verdict == "definition" and reason_of(each)]
            supposed = [each.where for each in alike if each.supposes]
            others = [each for each in alike if not each.supposes]
            if found := [each.where for each in others if verdict != "definition" or not reason_of(each)]:
                yield f"{verdict}: {_some(found)}"
            if supposed:
                yield f"{verdict}, if the equations that it rests on are true here, too: {_some(supposed)}"
            yield from _by_reason(verdict, claimed)
        for verdict in ("not decided", "not read"):
            yield from _by_reason(verdict, [each for each in readings if each.verdict == verdict])
    if whole:
        yield f"its macros are those of {whole}, of which it is a part"
    for file in dict.fromkeys(missing):
        yield f"the included file {file} is not in the folder of the document, or cannot be read; it was left out"
    counts = summary_of(readings)
    if not readings:
        yield f"{name}: no displayed equation was found; LaTeX (.tex), Markdown with $$ and notebooks (.ipynb) are read"
        return
    yield f"{name}: {len(readings)} {'equation' if len(readings) == 1 else 'equations'}: " + ", ".join(
        f"{count} {verdict}" for verdict, count in counts.items()
    )


def _by_reason(verdict: str, readings: Sequence[Reading]) -> Iterator[str]:
    lines: dict[str, list[Line]] = {}
    for each in readings:
        reason = reason_of(each)
        begin, _, rest = reason.partition(": ")
        lines.setdefault(rest if begin.startswith("line ") else reason, []).append(each.where)
    ordered = sorted(lines.items(), key=lambda item: (-len(item[1]), item[0]))
    for reason, found in ordered[:MOST_REASONS]:
        yield f"{verdict}: {reason} ({_some(found)})"
    if len(ordered) > MOST_REASONS:
        others = sum(len(found) for _, found in ordered[MOST_REASONS:])
        yield f"{verdict}: {others} more for {len(ordered) - MOST_REASONS} other reasons; see them with --full"


def _some(lines: Sequence[Line]) -> str:
    different = list(dict.fromkeys(lines))
    of_files = [
        (file, [str(each.number) for each in found])
        for file, found in groupby(different[:MOST_LINES], key=lambda each: each.file)
    ]
    shown = "; ".join(
        f"line{'s' * (len(numbers) > 1)} {', '.join(numbers)}" + (f" of {file}" if file else "")
        for file, numbers in of_files
    )
    return shown if len(different) <= MOST_LINES else f"{shown}, ... ({len(different)})"


def _heading(reading: Reading) -> str:
    number = f" ({reading.number})" if reading.number else ""
    return f"{reading.where}{number}  {reading.verdict}"


_SAYS = re.compile(r"[<>=]|[\w)'] [a-z]")
"""What a condition has, unlike an expression that is not zero: a relation, or words."""


def _whole(reading: Reading) -> Iterator[str]:
    yield f"{_heading(reading)}  {reading.read or ' '.join(reading.latex.split())[:100]}"
    link = decisive(reading)
    if reason := reason_of(reading):
        yield f"    {reason}"
    if link is None:
        return
    if link.rests_on:
        yield f"    rests on {'; '.join(link.rests_on)}"
    supposed = [each for each in link.hypotheses if TRUE_HERE in each]
    conditions = (each if _SAYS.search(each) else f"{each} != 0" for each in link.hypotheses)
    if shown := simple_conditions(each for each in conditions if each not in supposed):
        yield folded(f"    holds where {', '.join(shown)}", 400)
    if supposed:
        yield folded(f"    supposes that {', and that '.join(supposed)}", 400)
    if link.counterexample:
        point = (name + " = " + str(value).replace("'", "") for name, value in link.counterexample.items())
        yield f"    fails at {', '.join(point)}"
    elif link.verdict == "contradicts":
        yield "    the two sides are different numbers"
    if link.suggestion:
        yield f"    would follow with {link.suggestion}"
