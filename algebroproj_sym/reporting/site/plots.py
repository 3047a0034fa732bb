"""The errors of a function as a picture: a row for each stratum, on a logarithmic scale."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, log10

from markupsafe import Markup

from algebroproj_sym.verifying import Accuracy

WIDTH, LEFT, RIGHT, ROW, TOP = 440, 40, 24, 24, 14
LOWEST = -2.0


def accuracy_plot(accuracy: Accuracy) -> Markup:
    """Return median and largest error of each stratum, in ULP, as SVG; rows are numbered as in the table."""
    largest = [s.max_ulp for s in accuracy.strata if isfinite(s.max_ulp) and s.max_ulp > 0]
    top = float(max(2, *(int(log10(value)) + 1 for value in largest))) if largest else 2.0
    bottom = TOP + ROW * len(accuracy.strata)
    parts = [
        _grid(top, bottom),
        *(_row(k, s.median_ulp, s.max_ulp, top) for k, s in enumerate(accuracy.strata)),
    ]
    description = "; ".join(
        f"{k}, {s.name}: median {s.median_ulp:.3g}, largest {s.max_ulp:.3g}" for k, s in enumerate(accuracy.strata, 1)
    )
    return Markup(
        '<svg viewBox="0 0 {} {}" role="img" aria-labelledby="plot-title plot-text">'
        '<title id="plot-title">Errors in ULP by stratum, logarithmic scale</title>'
        '<desc id="plot-text">{}</desc>{}</svg>'
    ).format(WIDTH, bottom + 42, description, Markup("").join(parts))


def _x(value: float, top: float) -> str:
    """Return where a value is drawn: what is too small, or infinite, at the ends of the scale."""
    exponent = LOWEST if value <= 10**LOWEST else top if not isfinite(value) else min(log10(value), top)
    return f"{LEFT + (exponent - LOWEST) / (top - LOWEST) * (WIDTH - LEFT - RIGHT):.1f}"


def _grid(top: float, bottom: int) -> Markup:
    step = max(1, round((top - LOWEST) / 6))
    exponents: Sequence[int] = range(int(LOWEST), int(top) + 1, step)
    ticks = [
        Markup('<path class="grid" d="M{0} {1}V{2}"/><text x="{0}" y="{3}" text-anchor="middle">{4}</text>').format(
            _x(10.0**exponent, top), TOP, bottom, bottom + 16, _tick(exponent)
        )
        for exponent in exponents
    ]
    label = Markup('<text x="{}" y="{}" text-anchor="middle">error in ULP (○ median, ◆ largest)</text>')
    return Markup("").join(ticks) + label.format((LEFT + WIDTH - RIGHT) // 2, bottom + 36)


def _tick(exponent: int) -> str:
    return {-2: "≤0.01", -1: "0.1", 0: "1", 1: "10", 2: "100"}.get(exponent, f"1e{exponent}")


def _row(place: int, median: float, largest: float, top: float) -> Markup:
    y = TOP + ROW * place + ROW // 2
    return Markup(
        '<text x="{0}" y="{1}" text-anchor="end">{2}</text><path class="range" d="M{3} {4}H{5}"/>'
        '<path class="largest" d="M{5} {6}l6 6l-6 6l-6 -6z"/><circle class="median" cx="{3}" cy="{4}" r="4.5"/>'
    ).format(LEFT - 14, y + 4, place + 1, _x(median, top), y, _x(largest, top), y - 6)
