"""How often the judgement of `study pair` errs, on generated pairs of every kind with known truth.

    python benchmarks/pairs.py [FIRST [LAST]]

A measurement errs if the error at check points, all over the pictures or in the scene, is more than twice what is
predicted for 99.9 % of cases.  Pairs are good if neither they nor four repeated measurements err, and the predicted
error is less than 5 % of the width of the points.
"""

import sys
from collections import Counter

import numpy as np

from algebroproj_derivations.studies.pairs import estimating, predicting
from algebroproj_derivations.studies.pairs.judging import IMPRECISE, WIDTH, judge
from algebroproj_derivations.studies.pairs.normalising import pairs_of
from algebroproj_derivations.studies.pairs.populating import KINDS, pair

COUNTS = [8, 9, 10, 12, 16, 25, 40, 100]
REPEATED = 4


def errs(x1, x2, sigma, known):
    """Return by which factor a measurement errs, and what was predicted, as a share of the width."""
    pairs = pairs_of(x1, x2)
    fit = estimating.minima(pairs)[0]
    left, right = (np.linalg.inv(each) for each in pairs.transforms)
    truth = right.T @ known.matrix @ left
    spread, ratios = predicting.covariance(fit, sigma), []
    for places in (predicting.checks(truth / np.linalg.norm(truth), pairs), known.checks):
        bound = predicting.bound(predicting.derivatives(fit, pairs, places), spread)
        ratios.append(np.sqrt((predicting.errors(fit.matrix, pairs, places) ** 2).mean()) / bound)
    places = predicting.checks(fit.matrix, pairs)
    bound = predicting.bound(predicting.derivatives(fit, pairs, places), spread)
    return max(ratios), bound * pairs.scales.mean() / WIDTH


def judged(seed):
    """Return kind, number of pairs, verdict, whether they err, whether they are good, and the two bounds."""
    rng, kind = np.random.default_rng([99, seed]), KINDS[seed % len(KINDS)]
    count, sigma = int(rng.choice(COUNTS)), float(10 ** rng.uniform(-1, np.log10(2)))
    known, exact = pair(seed, kind, count, sigma), pair(seed, kind, count, 0.0)
    found, (factor, share) = judge(known.x1, known.x2, sigma), errs(known.x1, known.x2, sigma, known)
    changes = np.random.default_rng([7, seed]).normal(size=(REPEATED, 2, count, 2)) * sigma
    repeated = [errs(exact.x1 + one, exact.x2 + two, sigma, known)[0] for one, two in changes]
    good = max(factor, *repeated) <= 2 and share < IMPRECISE.undecided
    return kind, count, found.verdict, factor > 2, good, found.critical.lower / found.critical.upper


def main(first=20_000, last=21_000):
    """Print the verdicts for each kind and each range of numbers of pairs."""
    rows = [judged(seed) for seed in range(first, last)]
    for name, chosen in (
        *((kind, [row for row in rows if row[0] == kind]) for kind in KINDS),
        *(
            (f"{low} to {high} pairs", [row for row in rows if low <= row[1] <= high])
            for low, high in ((8, 10), (12, 25), (40, 100))
        ),
        ("all", rows),
    ):
        verdicts, good = Counter(row[2] for row in chosen), Counter(row[2] for row in chosen if row[4])
        erring = Counter(row[2] for row in chosen if row[3])
        print(
            f"{name:<16}{len(chosen):>5}  verdicts {dict(verdicts)}  erring {dict(erring)}  good {dict(good)}  "
            f"bounds within 2: {np.mean([row[5] >= 0.5 for row in chosen]):.2f}"
        )


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
