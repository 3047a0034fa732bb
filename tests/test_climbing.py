"""No count of solutions is wrong on a climb towards double solutions, and the climb finds solvers that err."""

import sys
from collections import namedtuple
from pathlib import Path

import numpy as np
import pytest

from algebroproj import minimal

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "benchmarks"))
import climbing


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("name", "steps", "least"), [("seven", 12, 2500), ("five", 8, 20)])
def test_no_count_is_wrong(name, steps, least):
    pairs = [pair for _, compared, _ in climbing.climb(name, steps, seed=3) for pair in compared]
    assert len(pairs) >= least
    assert all(true in (None, count) for true, count, _ in pairs)
    assert len({count for _, count, _ in pairs}) > 1


def test_a_solver_without_bounds_is_caught(monkeypatch):
    def rounded(left, right):
        rows = np.einsum("nki,nkj->nkij", *(np.insert(side, 2, 1, axis=2) for side in (left, right))).reshape(-1, 7, 9)
        first, second = np.moveaxis(np.linalg.svd(rows)[2][:, 7:].reshape(-1, 2, 3, 3), 1, 0)
        sign = np.sign(minimal.discriminant(minimal.cubic(first, second)))
        return namedtuple("Found", "count")(np.where(sign > 0, 3, 1))

    pairs, population, gaps, _, exact = climbing.OF["seven"]
    monkeypatch.setitem(climbing.OF, "seven", (pairs, population, gaps, rounded, exact))
    compared = [pair for _, compared, _ in climbing.climb("seven", 12, seed=3) for pair in compared]
    assert any(true > 0 and true != count for true, count, _ in compared)
