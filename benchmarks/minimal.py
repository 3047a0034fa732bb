"""How often minimal solvers return a wrong number of solutions, beside OpenCV and PoseLib.

    python benchmarks/minimal.py seven COUNT [SEED]    # COUNT problems of each kind, a tenth with a double root
    python benchmarks/minimal.py five COUNT [SEED]     # COUNT problems, and a hundredth with a double solution
    python benchmarks/minimal.py batches ROUNDS        # five pairs: time by the number of problems in a call

Of seven pairs the truth is the exact sign of the discriminant, by python-flint.  PoseLib has no function for them in
Python.  Of five pairs the truth is the proved count.  Exact arithmetic checks it for all problems with a planted double
solution, and for some others, first of all those of which PoseLib has another count.
"""

import sys
import time
from collections import Counter
from functools import partial

import cv2
import numpy as np
import poselib
from exact_counts import count_of_seven, counts_of_five, scenes

from algebroproj import minimal

BLOCK = 10_000


def seen(points, generator, base):
    """Return pixels of points in front of two cameras, of which the second is turned and moved."""
    axes = generator.normal(size=(len(points), 1, 3)) * 0.2
    moved = points + np.cross(axes, points) - base * generator.normal(size=(len(points), 1, 3))
    return tuple(p[..., :2] / p[..., 2:] * 1000 + 500 for p in (points, moved))


def ordinary(generator, count, base=0.5):
    """Return problems with points in a cube."""
    return seen(generator.uniform((-1, -1, 3), (1, 1, 5), (count, 7, 3)), generator, base)


def short_base(generator, count):
    """Return problems whose base is a thousandth of the distance."""
    return ordinary(generator, count, base=4e-3)


def near_plane(generator, count):
    """Return problems whose points are off a plane by a thousandth of the distance."""
    points = generator.uniform((-1, -1, -4e-3), (1, 1, 4e-3), (count, 7, 3))
    points[..., 2] += 4 + 0.3 * points[..., 0]
    return seen(points, generator, 0.5)


def double_root(generator, count):
    """Return problems with a double root, but for the rounding of their coordinates.

    A root F of the pencil F + t G is double if b^T G a = 0 for the null vectors of F on both sides.
    """
    first, second, third, fourth = generator.normal(size=(4, count, 3))
    form = np.einsum("ni,nj->nij", first, second) + np.einsum("ni,nj->nij", third, fourth)
    null_left, null_right = np.cross(first, third), np.cross(second, fourth)
    null = np.einsum("ni,nj->nij", null_left, null_right)
    other = generator.normal(size=(count, 3, 3))
    other -= null * ((other * null).sum((1, 2)) / (null**2).sum((1, 2)))[:, None, None]
    left = np.concatenate([generator.uniform(-1, 1, (count, 7, 2)), np.ones((count, 7, 1))], axis=2)
    right = np.cross(left @ form, left @ other)
    return tuple(points[..., :2] / points[..., 2:] * 1000 + 500 for points in (left, right))


def few_digits(generator, count):
    """Return problems whose coordinates have 3 to 12 binary places."""
    places = generator.integers(3, 13, (count, 1, 1))
    return tuple(np.ldexp(np.rint(np.ldexp(points, places)), -places) for points in scenes(generator, count))


def double_solution(generator, count):
    """Return problems with a double solution, but for the rounding of their coordinates.

    A solution E is double if a tangent of the essential matrices at E satisfies the five equations, too.
    """

    def crossed(vectors):
        return np.cross(vectors[:, None], np.eye(3)).swapaxes(1, 2)

    base, change, turn, axis = generator.normal(size=(4, count, 3))
    rotation = np.linalg.inv(np.eye(3) - crossed(axis)) @ (np.eye(3) + crossed(axis))
    form = crossed(base) @ rotation
    tangent = crossed(change) @ rotation + crossed(base) @ crossed(turn) @ rotation
    left = np.concatenate([generator.uniform(-1, 1, (count, 5, 2)), np.ones((count, 5, 1))], axis=2)
    right = np.cross(left @ form, left @ tangent)
    return left[..., :2], right[..., :2] / right[..., 2:]


OF_FIVE = {
    "planted double solution": (double_solution, 0.01),
    "ordinary": (scenes, 0.5),
    "near a plane": (partial(scenes, depth=4e-3), 0.2),
    "in a plane": (partial(scenes, depth=0.0), 0.2),
    "few digits": (few_digits, 0.05),
    "short base": (partial(scenes, base=4e-3), 0.05),
}
"""How problems of each kind are made, and which share of the problems they are."""

COMPARED = 100
"""How many of each block are compared with exact arithmetic, first those of which PoseLib has another count."""

OF_OPENCV = 1000
"""How many of each block OpenCV solves."""

OF_SEVEN = {
    "ordinary": ordinary,
    "near a plane": near_plane,
    "short base": short_base,
    "planted double root": double_root,
}


def opencv_of_seven(left, right):
    """Return the numbers of matrices that OpenCV returns."""
    found = (cv2.findFundamentalMat(a, b, cv2.FM_7POINT)[0] for a, b in zip(left, right, strict=True))
    return np.array([0 if each is None else len(each) // 3 for each in found])


def opencv_of_five(left, right):
    """Return the numbers of essential matrices that OpenCV returns."""
    found = (cv2.findEssentialMat(a, b, np.eye(3))[0] for a, b in zip(left, right, strict=True))
    return np.array([0 if each is None else len(each) // 3 for each in found])


def poselib_of_five(left, right):
    """Return the numbers of essential matrices that PoseLib returns."""
    rays = [np.concatenate([points, np.ones((*points.shape[:2], 1))], axis=2) for points in (left, right)]
    units = [each / np.linalg.norm(each, axis=2, keepdims=True) for each in rays]
    return np.array([len(poselib.essential_matrix_5pt(a, b)) for a, b in zip(*units, strict=True)])


def timed(function, *arguments):
    """Return what a function returns, and the seconds of processor time."""
    start = time.process_time()
    return function(*arguments), time.process_time() - start


def measured(make, generator, count):
    """Return wrong counts and seconds of both programs, and the largest error of a solution."""
    wrong, seconds, worst = np.zeros(2, int), np.zeros(2), 0.0
    for start in range(0, count, BLOCK):
        left, right = make(generator, min(BLOCK, count - start))
        known = np.array([count_of_seven(*pair) for pair in zip(left, right, strict=True)])
        found, own = timed(minimal.seven_pairs, left, right)
        others, their = timed(opencv_of_seven, left, right)
        wrong += [(counts != known).sum() for counts in (found.count, others)]
        seconds += own, their
        worst = max(worst, float(np.nanmax(found.error)))
    return wrong, seconds, worst


def checked(found, left, right, places):
    """Return how many problems were compared with exact arithmetic, and how many of them are told wrongly.

    A count must be exact.  Of a cluster the multiplicities must be those of all real solutions, but for pairs of
    complex ones.
    """
    compared = wrong = 0
    for place in places:
        exact = counts_of_five(left[place], right[place])
        told, within = int(found.count[place]), int(found.multiplicity[place].sum())
        if exact is None or found.case[place] in ("singular", "undecided"):
            continue
        different, real = exact
        fits = told == different if told >= 0 else within >= real and (within - real) % 2 == 0
        compared += 1
        wrong += not fits
        if not fits:
            print("wrong:", exact, told, within, left[place].tolist(), right[place].tolist(), flush=True)
    return compared, wrong


def main_of_five(count, seed=1):
    """Print the table of five pairs."""
    print("| problems | number | not told here | compared, wrong | wrong: PoseLib | wrong: OpenCV, of ", end="")
    print("| µs here, PoseLib, OpenCV | largest error |\n|---|---|---|---|---|---|---|---|", flush=True)
    for place, (kind, (make, share)) in enumerate(OF_FIVE.items()):
        generator, number = np.random.default_rng([seed, place]), int(share * count)
        cases, compared, solved = Counter(), np.zeros(2, int), np.zeros(3, int)
        wrong, seconds, worst = np.zeros(2, int), np.zeros(3), 0.0
        for start in range(0, number, BLOCK):
            left, right = make(generator, min(BLOCK, number - start))
            found, own = timed(minimal.five_pairs, left, right)
            of_poselib, its = timed(poselib_of_five, left, right)
            of_opencv, their = timed(opencv_of_five, left[:OF_OPENCV], right[:OF_OPENCV])
            told = found.count >= 0
            cases.update(found.case[~told].tolist())
            different = told & (of_poselib != found.count)
            wrong += different.sum(), (of_opencv != found.count[:OF_OPENCV])[told[:OF_OPENCV]].sum()
            seconds += own, its, their
            solved += len(left), len(left), len(of_opencv)
            worst = max(worst, float(np.nanmax(found.error)))
            most = len(left) if make is double_solution else COMPARED
            compared += checked(found, left, right, np.argsort(~different, kind="stable")[:most])
        times = ", ".join(f"{each:.0f}" for each in 1e6 * seconds / solved)
        untold = ", ".join(f"{amount} {case}" for case, amount in sorted(cases.items())) or "0"
        print(f"| {kind} | {number} | {untold} | {compared[0]}, {compared[1]} | {wrong[0]} ", end="")
        print(f"| {wrong[1]}, {solved[2]} | {times} | {worst:.0e} |", flush=True)


def main_of_batches(rounds):
    """Print the processor time of five pairs by the number of problems in a call, in turns with PoseLib."""
    left, right = scenes(np.random.default_rng(1), 8192)
    print("| problems in a call | µs a problem | µs, PoseLib | ratio |\n|---|---|---|---|")
    for size in (1, 4, 16, 64, 256, 1024, 8192):
        calls = max(1, 1024 // size)
        seconds = np.zeros((rounds, 2))
        for turn in range(rounds):
            for column, solve in enumerate((minimal.five_pairs, poselib_of_five)):
                parts = [slice(k * size, (k + 1) * size) for k in range(calls)]
                seconds[turn, column] = sum(timed(solve, left[part], right[part])[1] for part in parts)
        own, their = 1e6 * np.median(seconds, axis=0) / (size * calls)
        print(f"| {size} | {own:.0f} | {their:.1f} | {own / their:.0f} |", flush=True)


def main_of_seven(count, seed=1):
    """Print the table of seven pairs."""
    print("| problems | number | wrong counts here, OpenCV | µs here, OpenCV | largest error of an element |")
    print("|---|---|---|---|---|")
    for place, (kind, make) in enumerate(OF_SEVEN.items()):
        number = count // 10 if make is double_root else count
        wrong, seconds, worst = measured(make, np.random.default_rng([seed, place]), number)
        times = ", ".join(f"{1e6 * each / number:.0f}" for each in seconds)
        print(f"| {kind} | {number} | {wrong[0]}, {wrong[1]} | {times} | {worst:.0e} |", flush=True)


if __name__ == "__main__":
    {"five": main_of_five, "seven": main_of_seven, "batches": main_of_batches}[sys.argv[1]](*map(int, sys.argv[2:]))
