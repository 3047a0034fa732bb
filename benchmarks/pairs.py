"""How often the judgement of `study pair` errs, on generated pairs of every kind with known truth; beside others.

    python benchmarks/pairs.py measure FILE FIRST LAST    # appends a line for each pair; goes on where it was stopped
    python benchmarks/pairs.py FILE...                    # prints the tables

A measurement errs if the error at check points, all over the pictures or in the scene, is more than twice what is
predicted for 99.9 % of cases.  Pairs are good if neither they nor four repeated measurements err, and the predicted
error is less than 5 % of the width of the points.  Of trusted pairs, the predicted root mean square error is compared
with that of twenty repeated measurements, whose own uncertainty is 16 % or less.
"""

import json
import sys
import time
from collections import Counter
from pathlib import Path

import cv2
import numpy as np
import poselib
import pycolmap
from skimage.transform import FundamentalMatrixTransform

from algebroproj_derivations.studies.pairs import estimating, predicting
from algebroproj_derivations.studies.pairs.judging import IMPRECISE, TRUST, WIDTH, judge
from algebroproj_derivations.studies.pairs.normalising import pairs_of
from algebroproj_derivations.studies.pairs.populating import HALF, KINDS, pair

COUNTS = [8, 9, 10, 12, 16, 25, 40, 100]
REPEATED, REPEATED_IF_TRUSTED = 4, 20
USELESS = 50.0
THRESHOLD = 3.0
"""By how many sigma a pair may miss the matrix in the RANSAC of the other programs."""


def opencv(x1, x2, sigma):
    """Return the matrix, and whether the program warns."""
    return cv2.findFundamentalMat(x1, x2, cv2.FM_8POINT)[0], False


def scikit_image(x1, x2, sigma):
    """Return the matrix, and whether the program warns."""
    found = FundamentalMatrixTransform.from_estimate(x1, x2)
    return (found.params, False) if found else (None, True)


def poselib_ransac(x1, x2, sigma):
    """Return the matrix, and whether the program warns."""
    return poselib.estimate_fundamental(x1, x2, {"max_epipolar_error": THRESHOLD * sigma, "seed": 1})[0], False


def colmap(x1, x2, sigma):
    """Return the matrix, and whether the program calls the pair planar, panoramic or degenerate."""
    side = int(2 * HALF)
    camera = pycolmap.Camera(model="SIMPLE_PINHOLE", width=side, height=side, params=[1.2 * side, HALF, HALF])
    options = pycolmap.TwoViewGeometryOptions()
    options.min_num_inliers = 7
    options.ransac.max_error, options.ransac.random_seed = THRESHOLD * sigma, 1
    matches = np.repeat(np.arange(len(x1), dtype=np.uint32)[:, None], 2, axis=1)
    found = pycolmap.estimate_two_view_geometry(camera, x1 + HALF, camera, x2 + HALF, matches, options)
    shift = np.array([[1, 0, HALF], [0, 1, HALF], [0, 0, 1]])
    matrix = None if found.F is None else shift.T @ found.F @ shift
    return matrix, bool(found.config != pycolmap.TwoViewGeometryConfiguration.UNCALIBRATED)


OTHERS = {"OpenCV": opencv, "scikit-image": scikit_image, "PoseLib": poselib_ransac, "pycolmap": colmap}


def to_scale(matrix, pairs):
    """Return a matrix of pixels for points to scale."""
    left, right = (np.linalg.inv(each) for each in pairs.transforms)
    scaled = right.T @ matrix @ left
    return scaled / np.linalg.norm(scaled)


def root_mean_square(matrix, pairs, places):
    """Return the error of a matrix at check points in pixels."""
    return float(np.sqrt((predicting.errors(matrix, pairs, places) ** 2).mean()))


def measured(x1, x2, sigma, known):
    """Return by which factor a measurement errs, the bound as a share of the width, and two errors: it and predicted.

    Both are root mean squares at true check points all over the pictures, in pixels.
    """
    pairs = pairs_of(x1, x2)
    fit = estimating.minima(pairs)[0]
    spread, ratios = predicting.covariance(fit, sigma), []
    true_places = predicting.checks(to_scale(known.matrix, pairs), pairs)
    for places in (known.checks, true_places):
        slopes = predicting.derivatives(fit, pairs, places)
        ratios.append(root_mean_square(fit.matrix, pairs, places) / predicting.bound(slopes, spread))
    deviations = predicting.check_deviations(slopes, spread)
    places = predicting.checks(fit.matrix, pairs)
    bound = predicting.bound(predicting.derivatives(fit, pairs, places), spread)
    own = root_mean_square(fit.matrix, pairs, true_places)
    return float(max(ratios)), bound * pairs.scales.mean() / WIDTH, own, float(np.sqrt((deviations**2).mean()))


def beside(known, sigma):
    """Return what each other program errs at the check points of the scene, in pixels, and whether it warns."""
    pairs, found = pairs_of(known.x1, known.x2), {}
    for name, program in OTHERS.items():
        matrix, warns = program(known.x1, known.x2, sigma)
        usable = matrix is not None and matrix.shape == (3, 3) and np.isfinite(matrix).all() and matrix.any()
        found[name] = [root_mean_square(to_scale(matrix, pairs), pairs, known.checks) if usable else None, warns]
    return found


def judged(seed):
    """Return all that the tables need about one pair."""
    rng, kind = np.random.default_rng([99, seed]), KINDS[seed % len(KINDS)]
    count, sigma = int(rng.choice(COUNTS)), float(10 ** rng.uniform(-1, np.log10(2)))
    known, exact = pair(seed, kind, count, sigma), pair(seed, kind, count, 0.0)
    began = time.perf_counter()
    judgement = judge(known.x1, known.x2, sigma)
    seconds = time.perf_counter() - began
    factor, share, own, predicted = measured(known.x1, known.x2, sigma, known)
    repeated = REPEATED_IF_TRUSTED if judgement.verdict == TRUST else REPEATED
    changes = np.random.default_rng([7, seed]).normal(size=(repeated, 2, count, 2)) * sigma
    again = [measured(exact.x1 + one, exact.x2 + two, sigma, known) for one, two in changes]
    return {
        "seed": seed,
        "kind": kind,
        "count": count,
        "verdict": judgement.verdict,
        "factor": factor,
        "good": bool(max(factor, *(each[0] for each in again[:REPEATED])) <= 2 and share < IMPRECISE.undecided),
        "own": own,
        "predicted": predicted,
        "actual": float(np.sqrt(np.mean([each[2] ** 2 for each in again]))),
        "seconds": seconds,
        "others": beside(known, sigma),
    }


def measure(path, first, last):
    """Append the pairs of these seeds that a file does not have."""
    done = {row["seed"] for row in rows_of(path)} if path.exists() else set()
    with path.open("a") as file:
        for seed in range(first, last):
            if seed not in done:
                print(json.dumps(judged(seed)), file=file, flush=True)


def rows_of(path):
    """Return what `measure` has written."""
    return [json.loads(line) for line in path.read_text().splitlines()]


def of_each(rows):
    """Yield the rows of each kind, of each range of numbers of pairs, and all."""
    for kind in KINDS:
        yield kind, [row for row in rows if row["kind"] == kind]
    for low, high in ((8, 10), (12, 25), (40, 100)):
        yield f"{low} to {high} pairs", [row for row in rows if low <= row["count"] <= high]
    yield "all", rows


def tables(rows):
    """Print the verdicts for each kind and each range of numbers of pairs, and what other programs say."""
    states = ("trust", "undecided", "do not trust")
    for name, chosen in of_each(rows):
        trusted = [row for row in chosen if row["verdict"] == TRUST]
        ratios = np.array([row["predicted"] / row["actual"] for row in trusted])
        counted = [
            [Counter(row["verdict"] for row in some)[state] for state in states]
            for some in (chosen, [row for row in chosen if row["factor"] > 2], [row for row in chosen if row["good"]])
        ]
        print(
            f"{name:<16}{len(chosen):>6}  verdicts {counted[0]}  erring {counted[1]}  good {counted[2]}  "
            f"trusted within 1.5: {np.mean(np.abs(np.log(ratios)) < np.log(1.5)):.3f}, "
            f"actual over predicted at most {(1 / ratios).max():.2f}, "
            f"error over bound at most {max(row['factor'] for row in trusted):.2f}"
        )
    seconds = [row["seconds"] for row in rows]
    print(f"seconds: median {np.median(seconds):.3f}, largest {max(seconds):.3f}")
    for name in OTHERS:
        said = [(row["verdict"], *row["others"][name]) for row in rows]
        useless = [(verdict, error, warns) for verdict, error, warns in said if error is None or error > USELESS]
        silent = [each for each in useless if each[1] is not None and not each[2]]
        good = [each for each, row in zip(said, rows, strict=True) if row["good"]]
        errors = [each[1] for each in said if each[0] == TRUST and each[1] is not None]
        print(
            f"{name:<16}more than {USELESS:g} px without a warning: {len(silent)} (of these "
            f"{dict(Counter(each[0] for each in silent))}); warns of {sum(each[2] for each in said)}, of good ones "
            f"{sum(each[2] for each in good)}; of trusted pairs, median error {np.median(errors):.2f} px"
        )


if __name__ == "__main__":
    if sys.argv[1] == "measure":
        measure(Path(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4]))
    else:
        tables([row for path in sys.argv[1:] for row in rows_of(Path(path))])
