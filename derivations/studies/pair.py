"""Two pictures: whether the correlation (fundamental) matrix of measured pairs of points can be trusted."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import xarray
from matplotlib.figure import Figure

from algebroproj_derivations.studies.pairs import estimating, predicting
from algebroproj_derivations.studies.pairs.drawings import residuals_in_pictures, uncertain_lines
from algebroproj_derivations.studies.pairs.judging import PairJudgement, judge, require_sigma, simulated
from algebroproj_derivations.studies.pairs.normalising import pairs_of
from algebroproj_derivations.studies.pairs.pair_files import read_pairs
from algebroproj_derivations.studies.pairs.wording import in_words
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.declaration import MEMBER, Indices, Option, Study
from algebroproj_sym.study.sampling import normal


def check(**options: Any) -> None:
    """Refuse a file without pairs, and errors without sense."""
    if options["file"] is None:
        raise ValueError("file: expected a CSV file with the columns x1, y1, x2, y2, got none")
    require_sigma(options["sigma"])
    try:
        pixels = read_pairs(options["file"])
    except OSError as error:
        raise ValueError(f"file: {options['file']} cannot be read ({error.strerror})") from error
    try:
        pairs_of(*pixels)
    except ValueError as error:
        raise ValueError(f"file: {options['file']}: {error}") from error


def chunk(indices: Indices, seed: int, *, file: Path, sigma: float) -> xarray.Dataset:
    """Measure the adjusted pairs again, with random errors, and see by how much the check points are wrong."""
    pixels = read_pairs(file)
    pairs = pairs_of(*pixels)
    fit = estimating.minima(pairs)[0]
    places, adjusted = predicting.checks(fit.matrix, pairs), estimating.adjusted(fit.matrix, pairs)
    errors = []
    for changes in sigma * normal(seed, indices, pixels.shape):
        again = pairs_of(*(adjusted + changes))
        found = estimating.minima(again)[0]
        errors.append(np.sqrt((predicting.errors(found.matrix, again, places) ** 2).mean()))
    data = {
        "error": variable([MEMBER], errors, "pixel", "root mean square error at the check points"),
        "measured": variable(["side", "pair", "axis"], pixels, "pixel", "the pairs of the file"),
        "sigma": variable([], sigma, "pixel", "standard deviation of a coordinate"),
    }
    return xarray.Dataset(data, coords={MEMBER: indices})


def _judged(dataset: xarray.Dataset) -> PairJudgement:
    return simulated(judge(*dataset.measured.values, float(dataset.sigma)), dataset.error.values)


def report(dataset: xarray.Dataset) -> str:
    """Return the judgement, first in words and then in numbers."""
    errors = np.quantile(dataset.error.values, [0.5, 0.95])
    repeated = (
        f"{dataset.sizes[MEMBER]} simulated measurements: median {errors[0]:.2g} px, 95 % below {errors[1]:.2g} px."
    )
    return in_words(_judged(dataset), repeated)


def figures(dataset: xarray.Dataset) -> Mapping[str, Figure]:
    """Draw the pairs with their distances, and how uncertain the epipolar lines are."""
    judgement, pixels = _judged(dataset), dataset.measured.values
    return {
        "distances": residuals_in_pictures(judgement, pixels),
        "epipolar-lines": uncertain_lines(judgement, pixels),
    }


STUDY = Study(
    name="pair",
    summary="Whether two pictures determine their relative position well enough to be trusted",
    options=(
        Option("file", Path, None, "CSV file of pairs, with the columns x1, y1, x2, y2 in pixels."),
        Option("sigma", float, 0.5, "Standard deviation of the coordinates, in pixels."),
    ),
    members=100,
    size=10,
    chunk=chunk,
    report=report,
    figures=figures,
    check=check,
)
