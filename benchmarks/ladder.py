"""Certified values of the stereo chain: how long they take, against mpmath and Arb, and whether any is wrong.

Run with ``python benchmarks/ladder.py [MEMBERS] [CHECKED]``: so many configurations for the throughput, and so many
whose enclosures are held against balls of 300 bits.  Times are CPU times, those of mpmath and Arb of a sample.
"""

from __future__ import annotations

import sys
import time

import flint
import mpmath
import numpy as np

from algebroproj import correlation
from algebroproj_derivations.studies.stereo.chain import images, simulated
from algebroproj_derivations.studies.stereo.configurations import near_critical, ordinary
from algebroproj_derivations.studies.stereo.scenes import Scene
from algebroproj_sym.study.arithmetics import arb, double_double_balls, float64_balls, mpmath_digits
from algebroproj_sym.study.ladder import climb
from algebroproj_sym.study.precision import apply, nearest, radius

SAMPLE, ARB_BITS = 40, 128
CHECKED_BITS = 300
CHUNK = 5000


def correlation_and_epipoles(batch: Scene):
    """Return the first part of the chain as a pipeline."""

    def pipeline(arithmetic, members):
        both = images(arithmetic, batch[members])
        z = apply(arithmetic, correlation.correlation_matrix, both.left, both.right)
        left, right = apply(arithmetic, correlation.epipoles, z)
        return {"Z": z, "epipole_left": left, "epipole_right": right}

    return pipeline


def whole_chain(batch: Scene):
    """Return the chain as a pipeline."""
    return lambda arithmetic, members: simulated(arithmetic, batch[members])._asdict()


def throughput(members: int) -> None:
    """Print a line for each pipeline, batch and accuracy."""
    print(f"mpmath {mpmath.__version__} ({mpmath.libmp.BACKEND}), python-flint {flint.__version__}, CPU time")
    titles = f"{'mpmath us':>11}{'times':>7}{'Arb us':>11}{'times':>7}"
    print(f"{'pipeline':14}{'batch':15}{'accuracy':>9}{'us':>8}{titles}  rungs")
    for name, made in (("Z, epipoles", correlation_and_epipoles), ("whole chain", whole_chain)):
        for kind, batch in (("ordinary", ordinary(members, 1)), ("near-critical", near_critical(members, 1))):
            pipeline = made(batch)
            others = [alone(pipeline, each) for each in (mpmath_digits(50), arb(ARB_BITS))]
            for accuracy in (1e-6, 1e-10, 1e-15):
                before = time.process_time()
                found = climb(pipeline, members, accuracy)
                quick = (time.process_time() - before) / members
                counts = {rung: count for rung, count in found.counts().items() if count}
                figures = f"{1e6 * quick:8.1f}" + "".join(f"{1e6 * x:11.0f}{x / quick:7.1f}" for x in others)
                print(f"{name:14}{kind:15}{accuracy:9.0e}{figures}  {counts}", flush=True)


def alone(pipeline, arithmetic):
    """Return the seconds that one arithmetic takes for a member."""
    pipeline(arithmetic, np.arange(1))
    before = time.process_time()
    pipeline(arithmetic, np.arange(SAMPLE))
    return (time.process_time() - before) / SAMPLE


def containment(members: int) -> None:
    """Hold the enclosures of both machine arithmetics against Arb, chunk by chunk."""
    truth = arb(CHECKED_BITS)
    for name, batch in (("ordinary", ordinary(members, 2)), ("near-critical", near_critical(members, 2))):
        for balls in (float64_balls(), double_double_balls()):
            values, outside, infinite = 0, 0, 0
            for start in range(0, members, CHUNK):
                chunk = batch[slice(start, start + CHUNK)]
                exact, found = simulated(truth, chunk), simulated(balls, chunk)
                for exact_numbers, numbers in zip(exact, found, strict=True):
                    bad, unbounded = outside_of(balls, numbers, exact_numbers[0])
                    values, outside, infinite = values + bad.size, outside + bad.sum(), infinite + unbounded.sum()
            print(
                f"{name:15}{balls.name:26}{values:9} values, {outside} outside, {infinite} without a bound", flush=True
            )


def outside_of(balls, numbers, exact):
    """Tell which values are certainly not in their enclosures, and which have none."""
    middle, off = nearest(balls, numbers), radius(balls, numbers)
    bad = np.zeros(off.shape, dtype=bool)
    with flint.ctx.workprec(CHECKED_BITS):
        for place in np.ndindex(off.shape):
            if np.isfinite(off[place]):
                distance = exact[place] - float(middle.hi[place]) - float(middle.lo[place])
                bad[place] = not abs(distance) <= flint.arb(float(off[place]))
    return bad, ~np.isfinite(off)


if __name__ == "__main__":
    throughput(int(sys.argv[1]) if len(sys.argv) > 1 else 20_000)
    containment(int(sys.argv[2]) if len(sys.argv) > 2 else 10_000)
