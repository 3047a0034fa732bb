"""An adversary: it looks for the inputs on which a function errs most, by hill climbing over the bits of the inputs.

It begins at stratified samples, changes some bits of each, and keeps what makes the error larger.  It stays in the
neighbourhood where it began: no factor that must not vanish, and no entry of the result, may become smaller than a half
of what it was.  So what it finds can be compared with the samples of the same stratum, and with a bound.

While it climbs, the function with twice the digits tells the error.  What is reported is measured by the oracle.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from time import perf_counter
from types import ModuleType
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.samples import Sample
from algebroproj_sym.proving import seed_of
from algebroproj_sym.verifying.accuracy import Accuracy, measured, samples_of, strata_record
from algebroproj_sym.verifying.shipped import call, function_of

Numbers: TypeAlias = "NDArray[np.float64]"
Score: TypeAlias = "Callable[[Numbers], tuple[Numbers, Numbers]]"

CLIMBERS = 12
"""How many points climb in each stratum."""

GENERATION = 25
"""After how many steps the lower half of a stratum goes on from where its highest point is."""

REPORTED = 2
"""How many of the highest points of a stratum the oracle measures."""


@dataclass(frozen=True)
class Attack:
    """What an adversary found.

    The errors at the worst inputs of each stratum, the input with the largest error in units in the last place, and how
    many were tried.
    """

    accuracy: Accuracy
    worst: Sample
    evaluations: int


def attack(lowered: Lowered, package: ModuleType, seconds: float) -> Attack:
    """Look for the largest errors of a generated function.

    What is tried, and in which order, depends on the function alone; the seconds say when to stop.
    """
    deadline = perf_counter() + seconds
    generator = np.random.default_rng(seed_of(lowered.kernel.qualified_name, "attack", 0))
    samples = samples_of(lowered, CLIMBERS)
    strata = np.unique([sample.stratum for sample in samples], return_inverse=True)[1]
    names = [symbol.name for symbol in lowered.kernel.symbols]
    points = np.array([[sample.values[name] for name in names] for sample in samples])
    score = _score(lowered, package)
    errors, sizes = score(points)
    least = sizes / 2
    steps = 0
    while perf_counter() < deadline:
        steps += 1
        tried = _changed(points, generator)
        found, sizes = score(tried)
        higher = (found > errors) & (sizes >= least).all(axis=1)
        points[higher], errors[higher] = tried[higher], found[higher]
        if steps % GENERATION == 0:
            _go_on_from_the_highest(strata, points, errors, least)
    worst = [
        Sample(samples[place].stratum, dict(zip(names, points[place].tolist(), strict=True)))
        for place in _highest(strata, errors, REPORTED)
    ]
    function = function_of(lowered.kernel, package)
    each = [measured(lowered, function, [sample]).overall.max_ulp for sample in worst]
    return Attack(measured(lowered, function, worst), worst[int(np.argmax(each))], len(points) * (steps + 1))


def attack_record(found: Attack) -> Mapping[str, object]:
    """Return what was found as plain data; the worst input in hexadecimal digits."""
    at = {name: value.hex() for name, value in found.worst.values.items()}
    return {**strata_record(found.accuracy), "evaluations": found.evaluations, "worst": at}


def _score(lowered: Lowered, package: ModuleType) -> Score:
    """Return a function from points to their errors, and to what must not become small."""
    kernel = lowered.kernel
    function = function_of(kernel, package)
    doubled, factors = package.dd(function), package.hypotheses(function)
    varying = [place for place, output in enumerate(lowered.program.outputs) if isinstance(output, str)]

    def parts(*arrays: Any) -> Any:
        found = doubled(*arrays)
        stacked = [np.stack([number.hi, number.lo]) for number in (found if isinstance(found, tuple) else (found,))]
        return stacked[0] if len(stacked) == 1 else tuple(stacked)

    def sizes_of(*arrays: Any) -> Any:
        return np.stack([np.ones(len(arrays[0])), *factors(*arrays).values()])

    def score(points: Numbers) -> tuple[Numbers, Numbers]:
        values = dict(zip((symbol.name for symbol in kernel.symbols), points.T, strict=True))
        with np.errstate(all="ignore"):
            computed = call(function, kernel, values)[:, varying]
            high, low = call(parts, kernel, values)[..., varying]
            errors = np.max(np.abs(computed - high - low) / np.spacing(np.abs(high)), axis=1, initial=0)
            arrays = [np.stack([values[s.name] for s in a.symbols], -1).reshape(-1, *a.shape) for a in kernel.arguments]
            sizes = np.concatenate([np.abs(sizes_of(*arrays)).T, np.abs(high)], axis=1)
        usable = np.isfinite(errors) & np.isfinite(sizes).all(axis=1)
        return np.where(usable, errors, -1.0), np.where(usable[:, None], sizes, 0.0)

    return score


def _changed(points: Numbers, generator: np.random.Generator) -> Numbers:
    """Return points of which some coordinates have another digit, mostly one of the last."""
    digits = np.minimum(generator.geometric(0.05, points.shape), 52) - 1
    chosen = generator.random(points.shape) < generator.choice([1.0, 2.0, 4.0]) / points.shape[1]
    flips = np.where(chosen, np.int64(1) << digits.astype(np.int64), 0)
    return (points.view(np.int64) ^ flips).view(np.float64)


def _go_on_from_the_highest(strata: NDArray[Any], points: Numbers, errors: Numbers, least: Numbers) -> None:
    for stratum in np.unique(strata):
        places = np.flatnonzero(strata == stratum)
        order = places[np.argsort(errors[places], kind="stable")]
        lower, highest = order[: len(order) // 2], order[-1]
        points[lower], errors[lower], least[lower] = points[highest], errors[highest], least[highest]


def _highest(strata: NDArray[Any], errors: Numbers, count: int) -> Sequence[int]:
    """Return the places of the largest errors of each stratum."""
    found = []
    for stratum in np.unique(strata):
        places = np.flatnonzero(strata == stratum)
        found += places[np.argsort(errors[places], kind="stable")][-count:].tolist()
    return found
