"""Two pictures: whether the correlation (fundamental) matrix of measured pairs of points can be trusted."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import xarray
from matplotlib.figure import Figure
from numpy.typing import NDArray

from algebroproj_derivations.studies.pairs import estimating, explaining, predicting, space
from algebroproj_derivations.studies.pairs.drawings import residuals_in_pictures, uncertain_lines
from algebroproj_derivations.studies.pairs.judging import PairJudgement, held, judge, require_sigma, selected, simulated
from algebroproj_derivations.studies.pairs.measuring import measured
from algebroproj_derivations.studies.pairs.normalising import Pairs, pairs_of
from algebroproj_derivations.studies.pairs.pair_files import COLUMNS
from algebroproj_derivations.studies.pairs.robust import require_ransac
from algebroproj_derivations.studies.pairs.wording import in_words
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.declaration import MEMBER, Indices, Option, Study
from algebroproj_sym.study.sampling import normal

UNIT_OF_FILE = "unit of the file"


def check(**options: Any) -> None:
    """Refuse a file without pairs, and options without sense."""
    if options["file"] is None:
        raise ValueError("file: expected a CSV file with the columns x1, y1, x2, y2, got none")
    sigma = options.pop("sigma")
    require_sigma(sigma)
    require_ransac(options["ransac"])
    try:
        given = measured(**options)
    except OSError as error:
        raise ValueError(f"file: {error.filename} cannot be read ({error.strerror})") from error
    try:
        pairs = pairs_of(*given.pixels)
    except ValueError as error:
        raise ValueError(f"file: {options['file']}: {error}") from error
    if given.objects is not None:
        _in_space(estimating.minima(pairs)[0].matrix, pairs, given.objects)


def chunk(indices: Indices, seed: int, *, sigma: float, **source: Any) -> xarray.Dataset:
    """Measure the adjusted pairs again, with random errors, and see by how much the check points are wrong."""
    given = measured(**source)
    pairs = pairs_of(*given.pixels)
    fit = estimating.minima(pairs)[0]
    places, adjusted = predicting.checks(fit.matrix, pairs, given.frames), estimating.adjusted(fit.matrix, pairs)
    additions = explaining.additions(pairs, fit, sigma, places)
    whole = np.concatenate([adjusted, places[:, [addition.place for addition in additions]]], axis=1)
    count = adjusted.shape[1]
    again = [
        [_again(measurements[:, : count + more]) for more in range(len(additions) + 1)]
        for measurements in whole + sigma * normal(seed, indices, whole.shape)
    ]
    errors = [[_error(*one, places) for one in member] for member in again]
    frames = np.full((2, 2, 2), np.nan) if given.frames is None else given.frames
    data = {
        "error": variable(
            [MEMBER, "added"], errors, "pixel", "root mean square error at the check points, with some pairs added"
        ),
        "measured": variable(["side", "pair", "axis"], given.pixels, "pixel", "the pairs that are judged"),
        "frame": variable(["side", "corner", "axis"], frames, "pixel", "corners of the pictures, if they are known"),
        "read": variable([], given.read, about="number of pairs of the file"),
        "chance": variable([], given.chance, about="log10 of how many sets of wrong pairs were kept, too"),
        "doubtful": variable([], given.doubtful, about="number of wrong pairs that may have been kept"),
        "sigma": variable([], sigma, "pixel", "standard deviation of a coordinate"),
    }
    if given.objects is not None:
        true = _in_space(fit.matrix, pairs, given.objects)
        known = np.where(np.isfinite(given.objects), true, np.nan)
        found = [_in_space(*member[0], known) for member in again]
        data |= {
            "object": variable(["pair", "xyz"], given.objects, UNIT_OF_FILE, "object points"),
            "place": variable(["pair", "xyz"], true, UNIT_OF_FILE, "where the pairs put them"),
            "place_again": variable(
                [MEMBER, "pair", "xyz"], found, UNIT_OF_FILE, "where repeated measurements put them"
            ),
        }
    return xarray.Dataset(data, coords={MEMBER: indices})


def _again(pixels: NDArray[np.float64]) -> tuple[NDArray[np.float64], Pairs]:
    """Return the matrix of some pairs, and the pairs to scale."""
    pairs = pairs_of(*pixels)
    return estimating.minima(pairs)[0].matrix, pairs


def _error(matrix: NDArray[np.float64], pairs: Pairs, places: NDArray[np.float64]) -> float:
    """Return the root mean square error at check points of a matrix."""
    return float(np.sqrt((predicting.errors(matrix, pairs, places) ** 2).mean()))


def _in_space(matrix: NDArray[np.float64], pairs: Pairs, objects: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return where the pairs are in space, by those whose object points are known."""
    points = space.reconstructed(matrix, pairs)
    return space.placed(points, space.into_space(points, objects))


def _judged(dataset: xarray.Dataset) -> PairJudgement:
    frames = dataset.frame.values if np.isfinite(dataset.frame.values).all() else None
    judgement = judge(*dataset.measured.values, float(dataset.sigma), frames)
    if "object" in dataset:
        pairs = pairs_of(*dataset.measured.values)
        surface = explaining.in_space(pairs, judgement.critical, dataset.object.values)
        judgement = replace(judgement, why=(*judgement.why, surface))
    judgement = selected(judgement, int(dataset.read), float(dataset.chance))
    judgement = held(judgement, dataset.measured.values, int(dataset.doubtful), frames)
    return simulated(judgement, dataset.error.values[:, 0])


def _of_objects(dataset: xarray.Dataset) -> list[str]:
    """Return how object points fit, and how certain the points in space are, in sentences."""
    if "object" not in dataset:
        return []
    true, again = dataset.place.values, dataset.place_again.values
    off, apart = (np.linalg.norm(each - true, axis=-1) for each in (dataset.object.values, again))
    known = np.isfinite(off)
    expected = np.quantile(np.sqrt((apart[:, known] ** 2).mean(axis=1)), 0.95)
    deviations = np.sqrt(np.median(apart**2, axis=0))
    return [
        f"{known.sum()} object points: off by {np.sqrt((off[known] ** 2).mean()):.2g} (root mean square), "
        f"pair {int(np.nanargmax(off)) + 1} by {np.nanmax(off):.2g}; pixels explain {expected:.2g}.",
        f"Simulated errors in space: median {np.median(deviations):.2g}, largest {deviations.max():.2g} "
        f"(pair {int(deviations.argmax()) + 1}), in the unit of the file.",
    ]


def report(dataset: xarray.Dataset) -> str:
    """Return the judgement, first in words and then in numbers."""
    errors, added = np.quantile(dataset.error.values, [0.5, 0.95], axis=0)
    repeated = (
        f"{dataset.sizes[MEMBER]} simulated measurements: median {errors[0]:.2g} px, 95 % below {added[0]:.2g} px."
    )
    judgement, read = _judged(dataset), int(dataset.read)
    kept = len(judgement.residuals)
    left_out = f"RANSAC kept {kept} of {read} pairs. " if np.isfinite(dataset.chance.values) else ""
    return in_words(judgement, "\n".join([left_out + repeated, *_of_objects(dataset)]), added[1:])


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
        Option("file", Path, None, "File of the pairs: CSV, .npz of OpenCV, or COLMAP's database or images.txt."),
        Option("sigma", float, 0.5, "Standard deviation of the coordinates, in pixels."),
        Option("columns", str, COLUMNS, "Names of the columns of a CSV file, or their numbers."),
        Option("images", str, None, "Names of the left and of the right picture in COLMAP's files."),
        Option("size", str, None, "Width and height of the pictures in pixels, such as 4000,3000."),
        Option("camera", Path, None, "Calibration: TOML, .npz, COLMAP's database or cameras.txt."),
        Option("points", str, None, "Names of the columns with object coordinates, such as X,Y,Z."),
        Option(
            "ransac", float, None, "Leave out pairs that miss the matrix by more pixels than this (PoseLib's RANSAC)."
        ),
    ),
    members=100,
    size=10,
    chunk=chunk,
    report=report,
    figures=figures,
    check=check,
    terms={
        "distance, error": "Sampson's: by how much both points of a pair must move to fit the matrix [px: pixels]",
        "sigma": "standard deviation of a coordinate, as given [px]; as a unit: how far all coordinates move together",
        "leverage": "share of its own error that the fit hides [0 to 1]",
    },
)
