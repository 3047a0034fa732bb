"""The errors of a function as pictures: a row for each stratum, and error against distance near a singularity."""

from collections.abc import Sequence
from math import isfinite, log10

from markupsafe import Markup

from algebroproj_sym.verifying.accuracy import Accuracy, Stratum

WIDTH, LEFT, RIGHT, ROW, TOP = 440, 40, 24, 36, 14
LOWEST = -2.0
SIDE, BELOW, SMALLEST, TALLEST = 300, 170, -16.0, 2.0
"""Width and height of a picture for one singularity; exponents of the least distance and of the largest error."""


def accuracy_plot(accuracy: Accuracy) -> Markup:
    """Return median and largest error of each stratum, in ULP, as SVG."""
    largest = [s.max_ulp for s in accuracy.strata if isfinite(s.max_ulp) and s.max_ulp > 0]
    top = float(max(2, *(int(log10(value)) + 1 for value in largest))) if largest else 2.0
    bottom = TOP + ROW * len(accuracy.strata)
    parts = [
        _grid(top, bottom),
        *(_row(k, s, top) for k, s in enumerate(accuracy.strata)),
    ]
    description = "; ".join(f"{s.name}: median {s.median_ulp:.3g}, largest {s.max_ulp:.3g}" for s in accuracy.strata)
    return Markup(
        '<svg viewBox="0 0 {} {}" role="img" aria-labelledby="plot-title plot-text">'
        '<title id="plot-title">Errors in ULP by stratum, logarithmic scale</title>'
        '<desc id="plot-text">{}</desc>{}</svg>'
    ).format(WIDTH, bottom + 42, description, Markup("").join(parts))


def distance_plot(stratum: Stratum) -> Markup:
    """Return the error of each sample, in ULP, against what the factor is there that vanishes at a singularity, as SVG.

    Both scales are logarithmic.  A line shows half an ULP: no function can promise less.
    """

    def x(exponent: float) -> float:
        return LEFT + (min(max(exponent, SMALLEST), 0) - SMALLEST) / -SMALLEST * (SIDE - LEFT - 10)

    def y(exponent: float) -> float:
        return BELOW - 36 - (min(max(exponent, LOWEST), TALLEST) - LOWEST) / (TALLEST - LOWEST) * (BELOW - 46)

    across = [
        Markup(
            '<path class="grid" d="M{0:.0f} 10V{1}"/><text x="{0:.0f}" y="{2}" text-anchor="middle">1e{3}</text>'
        ).format(x(k), BELOW - 36, BELOW - 20, k)
        for k in (-16, -12, -8, -4, 0)
    ]
    up = [
        Markup('<path class="grid" d="M{} {:.0f}H{}"/><text x="{}" y="{:.0f}" text-anchor="end">{}</text>').format(
            LEFT, y(k), SIDE - 10, LEFT - 4, y(k) + 4, _tick(k)
        )
        for k in range(int(LOWEST), int(TALLEST) + 1)
    ]
    half = Markup('<path class="half" d="M{} {:.0f}H{}"/>').format(LEFT, y(log10(0.5)), SIDE - 10)
    dots = "".join(f"M{x(_log(at)):.0f} {y(_log(error)):.0f}h0" for at, error in sorted(stratum.near))
    largest = max(error for _, error in stratum.near)
    return Markup(
        '<svg viewBox="0 0 {} {}" role="img" aria-label="{}: {} samples, largest error {:.3g} ULP">{}{}{}'
        '<path class="dots" d="{}"/><text x="{}" y="{}" text-anchor="middle">size of the factor</text></svg>'
    ).format(
        *(SIDE, BELOW, stratum.name, len(stratum.near), largest),
        *(Markup("").join(across), Markup("").join(up), half, dots),
        *((LEFT + SIDE) // 2, BELOW - 4),
    )


def _log(value: float) -> float:
    return log10(value) if value > 0 else float("-inf")


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


def _row(place: int, stratum: Stratum, top: float) -> Markup:
    y = TOP + ROW * place + 26
    return Markup(
        '<text x="{0}" y="{1}">{2}</text><path class="range" d="M{3} {4}H{5}"/>'
        '<path class="largest" d="M{5} {6}l6 6l-6 6l-6 -6z"/><circle class="median" cx="{3}" cy="{4}" r="4.5"/>'
    ).format(4, y - 12, stratum.name, _x(stratum.median_ulp, top), y, _x(stratum.max_ulp, top), y - 6)
