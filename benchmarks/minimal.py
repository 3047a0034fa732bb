"""How often minimal solvers return a wrong number of solutions, beside OpenCV and PoseLib.

    python benchmarks/minimal.py seven COUNT [SEED]    # COUNT problems of each kind, a tenth with a double root
    python benchmarks/minimal.py five COUNT [SEED]     # COUNT problems of each kind

Of seven pairs the truth is the exact sign of the discriminant, by python-flint.  PoseLib has no function for them in
Python.  Of five pairs the truth is the proved count, which the tests compare with exact arithmetic.
"""

import sys
import time

import cv2
import numpy as np
import poselib
from exact_counts import count_of_seven, scenes

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


OF_FIVE = {
    "ordinary": (0.5, 1.0),
    "near a plane": (0.5, 4e-3),
    "in a plane": (0.5, 0.0),
    "short base": (4e-3, 1.0),
}

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


def main_of_five(count, seed=1):
    """Print the table of five pairs."""
    print("| problems | number | not told here | wrong: OpenCV, PoseLib | µs here, OpenCV, PoseLib | largest error |")
    print("|---|---|---|---|---|---|")
    for place, (kind, scene) in enumerate(OF_FIVE.items()):
        generator = np.random.default_rng([seed, place])
        untold, wrong, seconds, worst = 0, np.zeros(2, int), np.zeros(3), 0.0
        for start in range(0, count, BLOCK):
            left, right = scenes(generator, min(BLOCK, count - start), 5, *scene)
            found, own = timed(minimal.five_pairs, left, right)
            others, their = zip(*(timed(each, left, right) for each in (opencv_of_five, poselib_of_five)), strict=True)
            told = found.count >= 0
            untold += (~told).sum()
            wrong += [(counts != found.count)[told].sum() for counts in others]
            seconds += own, *their
            worst = max(worst, float(np.nanmax(found.error)))
        times = ", ".join(f"{1e6 * each / count:.0f}" for each in seconds)
        print(f"| {kind} | {count} | {untold} | {wrong[0]}, {wrong[1]} | {times} | {worst:.0e} |", flush=True)


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
    {"five": main_of_five, "seven": main_of_seven}[sys.argv[1]](*map(int, sys.argv[2:]))
