"""A search for problems whose number of solutions is told wrongly: a climb towards double solutions.

    python benchmarks/climbing.py seven STEPS [SEED]    # 256 problems, each changed in every step
    python benchmarks/climbing.py five STEPS [SEED]     # 64 problems

A change is kept if the nearest two solutions, real or not, come nearer.  Seven of eight problems keep only what
floating-point numbers alone decide: they climb along the edge of what these can.  Problems that do not climb any more
are replaced by others.  Of seven pairs all counts are compared with exact arithmetic, of five pairs in each step those
of the smallest gaps among the changes that were kept.
"""

import sys
from collections import Counter
from contextlib import contextmanager
from unittest import mock

import numpy as np
from exact_counts import count_of_five, count_of_seven, scenes

from algebroproj import five_pairs, minimal, solvers

PATIENCE = 60
"""After how many steps without a gain a problem is replaced."""
COMPARED = 4
"""How many of five pairs are compared in each step."""


def started(generator, count, pairs):
    """Return problems: ordinary ones, with a short base, near a plane, in pixels, and with few digits."""
    base, depth = 10.0 ** (generator.uniform(-8, 0, (2, count, 1, 1)) * (generator.random((2, count, 1, 1)) < 0.4))
    points = np.stack(scenes(generator, count, pairs, 0.5 * base, depth), axis=1)
    digits = np.where(generator.random((count, 1, 1, 1)) < 0.2, generator.integers(2, 12, (count, 1, 1, 1)), 60)
    points = np.ldexp(np.rint(np.ldexp(points, digits)), -digits)
    return np.where(generator.random((count, 1, 1, 1)) < 0.2, points * 1000 + 500, points)


def changed(points, generator):
    """Return problems of which some coordinates are moved, have other bits, or are those of another pair."""
    shape = points.shape
    ways = np.stack(
        [
            points * (1 + generator.normal(size=shape) * 2.0 ** -generator.uniform(1, 53, (len(points), 1, 1, 1))),
            (points.view(np.int64) ^ (1 << generator.integers(0, 53, shape))).view(np.float64),
            np.roll(points, 1, axis=2) + generator.normal(size=shape) * 2.0 ** -generator.uniform(1, 60, shape),
            points * 2.0 ** generator.integers(-8, 9, (len(points), 2, 1, 1)),
            np.ldexp(np.rint(np.ldexp(points, digits := generator.integers(2, 40, (len(points), 1, 1, 1)))), -digits),
        ]
    )
    way = generator.choice(5, size=len(points), p=[0.6, 0.2, 0.1, 0.05, 0.05])
    some = generator.random(shape) < 2.0 ** -generator.integers(0, 5, (len(points), 1, 1, 1))
    some |= (way == 3)[:, None, None, None]
    return np.where(some, ways[way, np.arange(len(points))], points)


def gaps_of_seven(points):
    """Return the discriminants of the cubics of the pencils, as shares of their coefficients."""
    u, v = (np.concatenate([part, np.ones_like(part[..., :1])], axis=2) for part in np.moveaxis(points, 1, 0))
    rows = (u[..., None] * v[:, :, None, :]).reshape(-1, 7, 9)
    rows /= np.linalg.norm(rows, axis=2, keepdims=True)
    first, second = np.moveaxis(np.linalg.qr(rows.swapaxes(1, 2), mode="complete")[0][:, :, 7:], 2, 0)
    cubic = minimal.cubic(first.reshape(-1, 3, 3), second.reshape(-1, 3, 3))
    return np.abs(minimal.discriminant(cubic)) / (cubic**2).sum(axis=1) ** 2


def gaps_of_five(points):
    """Return the distances of the nearest two of ten approximate solutions."""
    left, right = (np.concatenate([part, np.ones_like(part[..., :1])], axis=2) for part in np.moveaxis(points, 1, 0))
    solutions = five_pairs._eliminated(left, right, 0)[0].reshape(-1, 10, 9)
    gaps = five_pairs._apart(solutions).min(axis=(1, 2))
    return np.where(np.isfinite(gaps), gaps, np.inf)


OF = {
    "seven": (7, 256, gaps_of_seven, minimal.seven_pairs, count_of_seven),
    "five": (5, 64, gaps_of_five, minimal.five_pairs, count_of_five),
}


@contextmanager
def floats_alone():
    """Let integers decide nothing."""
    with mock.patch.object(solvers, "_solve_exactly"), mock.patch.object(five_pairs, "_solve_by_integers"):
        yield


def climb(name, steps, seed=1):
    """Yield of each step how many problems were told, the true and the told counts of those compared, and the gaps."""
    pairs, population, gaps_of, solve, count_of = OF[name]
    generator = np.random.default_rng([seed, pairs])
    on_edge = population * 7 // 8
    best, gaps, waited = started(generator, population, pairs), np.full(population, np.inf), np.zeros(population, int)
    for step in range(steps):
        fresh = waited > PATIENCE
        points = np.where(fresh[:, None, None, None], started(generator, population, pairs), best)
        points = np.where((fresh | (step == 0))[:, None, None, None], points, changed(points, generator))
        gaps[fresh] = np.inf
        with np.errstate(all="ignore"):
            now = gaps_of(points)
        with floats_alone():
            counts = solve(*points[:on_edge].swapaxes(0, 1)).count
        untold = counts == (0 if name == "seven" else -1)
        counts = np.concatenate([counts, solve(*points[on_edge:].swapaxes(0, 1)).count])
        kept = (now < gaps) & ~np.concatenate([untold, np.zeros(population - on_edge, bool)])
        told = np.flatnonzero(counts != -1 if name == "five" else counts != 0)
        compared = told if name == "seven" else [k for k in told[np.argsort(now[told])] if kept[k]][:COMPARED]
        yield len(told), [(count_of(*points[k]), int(counts[k]), points[k]) for k in compared], gaps
        best[kept], gaps[kept] = points[kept], now[kept]
        waited = np.where(kept, 0, waited + 1)
        waited[fresh] = 0


def main(name, steps, seed=1):
    """Print how many were told and compared, wrong ones with their points, and how small the gaps became."""
    told, pairs, smallest = 0, Counter(), np.inf
    for step, (number, compared, gaps) in enumerate(climb(name, steps, seed), 1):
        told += number
        smallest = min(smallest, gaps.min())
        for true, count, points in compared:
            pairs[true, count] += 1
            if true not in (None, count):
                print(
                    "wrong:", true, count, [[float(x).hex() for x in row] for row in points.reshape(-1, 2)], flush=True
                )
        if step % 100 == 0 or step == steps:
            wrong = sum(number for (true, count), number in pairs.items() if true not in (None, count))
            print(f"{step} steps: {told} told, {pairs.total()} compared, {wrong} wrong, smallest gap {smallest:.1e}, ")
            print(f"median {np.median(gaps):.1e}; true and told: {dict(sorted(pairs.items(), key=str))}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
