"""Time and error of whole jobs beside other packages: correlation matrices and rectification of uncalibrated pairs.

Run with ``python benchmarks/jobs.py``; what is not installed is left out, and said on standard error.  Errors are those
of the largest entry of a matrix, relative to it, against the exact matrix: of eight pairs as rounded the solution of
their equations in rational arithmetic, of a hundred pairs, which no matrix satisfies, that of the cameras.  A
rectification is judged by what parallax it leaves, relative to the extent of the image.  A scene is well conditioned if
it is as deep as wide; otherwise its points lie within a ten-thousandth of a plane.
"""

from __future__ import annotations

import importlib
import sys
import time
from collections.abc import Callable, Iterator
from itertools import product
from statistics import median

import flint
import numpy as np

from algebroproj import affine, correlation, normal_case

TASKS = 200
RUNS = 7
DEPTHS = {"well": 1.0, "near a plane": 1e-4}
ANGLES = ((0.1, 0.05, 0.2), (-0.05, 0.1, -0.1))
CENTERS = ((0.0, 0.0, 0.0), (1.0, 0.1, 0.05))
LAST = [1, 2, 0]
"""The places of (x, y, 1) in (1, x, y)."""

Array = np.ndarray
Job = Callable[[Array, Array], Array]


def main() -> None:
    """Print a line for each job, scene and package."""
    print("| job | scene | package | microseconds a pair of images | median error | largest error |")
    print("| --- | --- | --- | ---: | ---: | ---: |")
    for pairs, (scene, depth) in product((8, 100), DEPTHS.items()):
        left, right = images(pairs, depth)
        truth = exact(left, right) if pairs == 8 else np.broadcast_to(of_cameras(), (TASKS, 3, 3))
        for name, job in installed(matrices(pairs)):
            matrix, seconds = timed(job, left, right)
            errors = [apart(one, other) for one, other in zip(matrix, truth, strict=True)]
            show(f"matrix of {pairs} pairs", scene, name, seconds, errors)
        for name, job in installed(rectifications()):
            parallaxes, seconds = timed(job, left, right)
            show(f"rectification of {pairs} pairs", scene, name, seconds, parallaxes.tolist())


def show(job: str, scene: str, name: str, seconds: float, errors: list[float]) -> None:
    """Print a row of the table."""
    figures = f"{1e6 * seconds / TASKS:.1f} | {median(errors):.1e} | {max(errors):.1e}"
    print(f"| {job} | {scene} | {name} | {figures} |", flush=True)


def timed(job: Job, left: Array, right: Array) -> tuple[Array, float]:
    """Return the results of a job, and the processor time that it takes, in the median of some runs after the first."""
    results = job(left, right)
    seconds = []
    for _ in range(RUNS):
        start = time.process_time()
        job(left, right)
        seconds.append(time.process_time() - start)
    return results, median(seconds)


def rotation(angles: tuple[float, float, float]) -> Array:
    """Return a matrix of rotation about the three axes."""
    (ca, cb, cc), (sa, sb, sc) = np.cos(angles), np.sin(angles)
    about_x = np.array([[1, 0, 0], [0, ca, -sa], [0, sa, ca]])
    about_y = np.array([[cb, 0, sb], [0, 1, 0], [-sb, 0, cb]])
    return about_x @ about_y @ np.array([[cc, -sc, 0], [sc, cc, 0], [0, 0, 1]])


def images(pairs: int, depth: float) -> tuple[Array, Array]:
    """Return homologous points of random scenes, of shape (TASKS, pairs, 2) in each image."""
    generator = np.random.default_rng(0)
    x, y, z = generator.uniform(-1, 1, (3, TASKS, pairs))
    points = np.stack([x, y, 5 + 0.2 * x + depth * z], axis=-1)
    rays = [(points - center) @ rotation(angles).T for center, angles in zip(CENTERS, ANGLES, strict=True)]
    left, right = (ray[..., :2] / ray[..., 2:] for ray in rays)
    return left, right


def of_cameras() -> Array:
    """Return the matrix F of ``right^T F left = 0`` for rays (x, y, 1)."""
    first, second = map(rotation, ANGLES)
    a, b, c = np.subtract(*CENTERS)
    return second @ np.array([[0, -c, b], [c, 0, -a], [-b, a, 0]]) @ first.T


def exact(left: Array, right: Array) -> Array:
    """Solve the eight equations in rational arithmetic, and round the solution."""
    return np.array([_exact(*task) for task in zip(left.tolist(), right.tolist(), strict=True)])


def _exact(left: list[list[float]], right: list[list[float]]) -> Array:
    rows = []
    for of_left, of_right in zip(left, right, strict=True):
        both = [[flint.fmpq(*number.as_integer_ratio()) for number in (*point, 1.0)] for point in (of_left, of_right)]
        rows.append([b * a for b in both[1] for a in both[0]])
    head = flint.fmpq_mat([row[:8] for row in rows])
    solution = head.solve(flint.fmpq_mat([[-row[8]] for row in rows]))
    return np.array([*(int(x.p) / int(x.q) for x in solution.entries()), 1.0]).reshape(3, 3)


def apart(matrix: Array, truth: Array) -> float:
    """Return the largest difference of two matrices that are scaled to the largest entry of the second."""
    place = np.unravel_index(np.argmax(abs(truth)), truth.shape)
    return float(np.max(abs(matrix / matrix[place] - truth / truth[place])))


def installed(jobs: Iterator[tuple[str, Callable[[], Job]]]) -> Iterator[tuple[str, Job]]:
    """Yield the jobs whose packages are there."""
    for name, make in jobs:
        try:
            yield name, make()
        except ImportError as error:
            print(f"{name}: left out, {error}", file=sys.stderr)


def matrices(pairs: int) -> Iterator[tuple[str, Callable[[], Job]]]:
    """Yield what finds the matrix F of all tasks; the closed form takes eight of the pairs."""
    yield "algebroproj" if pairs == 8 else "algebroproj, eight of them", lambda: own_matrix
    if pairs > 8:
        yield "algebroproj, least squares", lambda: least_squares_matrix
    yield "opencv", opencv_matrix
    yield "poselib", poselib_matrix
    yield "kornia", kornia_matrix


def least_squares_matrix(left: Array, right: Array) -> Array:
    """Fit a matrix to all pairs: of their rows, scaled by columns, the singular vector of the least singular value.

    Each image is shifted to its mean and scaled to its extent; a triangular factor of the rows has their singular
    vectors, and is small.
    """
    (first, to_first), (second, to_second) = map(normalised, (left, right))
    rays = [np.concatenate([np.ones((*points.shape[:2], 1)), points], axis=-1) for points in (first, second)]
    rows = (rays[0][..., :, None] * rays[1][..., None, :]).reshape(*left.shape[:2], 9)
    vectors = np.linalg.svd(np.linalg.qr(rows, mode="r"))[2]
    matrix = np.swapaxes(to_first, -1, -2) @ vectors[:, -1].reshape(-1, 3, 3) @ to_second
    return np.swapaxes(matrix, -1, -2)[:, LAST][..., LAST]


def normalised(points: Array) -> tuple[Array, Array]:
    """Return points with mean zero and extent one, and the matrices that map rays (1, x, y) to theirs."""
    mean = points.mean(axis=1, keepdims=True)
    extent = abs(points - mean).max(axis=(1, 2), keepdims=True)
    matrices = np.zeros((len(points), 3, 3))
    matrices[:, 0, 0] = 1
    matrices[:, 1:, 0] = -(mean / extent)[:, 0]
    matrices[:, [1, 2], [1, 2]] = 1 / extent[:, 0]
    return (points - mean) / extent, matrices


def own_matrix(left: Array, right: Array) -> Array:
    """Solve for the matrix of correlation, and bring its rows and columns into the order of the others."""
    matrix = correlation.general_correlation_matrix(left[:, :8], right[:, :8])
    return np.swapaxes(matrix, -1, -2)[:, LAST][..., LAST]


def opencv_matrix() -> Job:
    """Return the normalised linear solution of OpenCV."""
    cv2 = importlib.import_module("cv2")
    return lambda left, right: np.array(
        [cv2.findFundamentalMat(a, b, cv2.FM_8POINT)[0] for a, b in zip(left, right, strict=True)]
    )


def poselib_matrix() -> Job:
    """Return the linear solution of PoseLib, which takes rays."""
    poselib = importlib.import_module("poselib")

    def job(left: Array, right: Array) -> Array:
        rays = (np.concatenate([each, np.ones((*each.shape[:2], 1))], axis=-1) for each in (left, right))
        unit = (each / np.linalg.norm(each, axis=-1, keepdims=True) for each in rays)
        return np.array([poselib.essential_matrix_8pt(list(a), list(b)) for a, b in zip(*unit, strict=True)])

    return job


def kornia_matrix() -> Job:
    """Return the normalised linear solution of kornia, with equal weights, for all tasks at once."""
    torch = importlib.import_module("torch")
    find = importlib.import_module("kornia.geometry.epipolar").find_fundamental

    def job(left: Array, right: Array) -> Array:
        weights = torch.ones(left.shape[:2], dtype=torch.float64)
        return find(torch.as_tensor(left), torch.as_tensor(right), weights).numpy()

    return job


def rectifications() -> Iterator[tuple[str, Callable[[], Job]]]:
    """Yield what rectifies all tasks, and returns the largest parallax that is left in each."""
    yield "algebroproj", lambda: own_rectification
    yield "opencv", opencv_rectification


def own_rectification(left: Array, right: Array) -> Array:
    """Transform to the normal case: three pairs for the affine systems, five for the matrix of correlation."""
    u_left, u_right = (affine.plane_coordinates(v[:, 3:], v[:, None, :3]) for v in (left, right))
    factor, *taus = normal_case.from_correlation(correlation.correlation_matrix(u_left[:, :5], u_right[:, :5]))
    normal = [normal_case.map_points(tau[:, None], u) for tau, u in zip(taus, (u_left, u_right), strict=True)]
    return parallax(*(points[..., 0] + factor[:, None] * points[..., 1] for points in normal))


def opencv_rectification() -> Job:
    """Return what OpenCV makes of its own matrix."""
    cv2 = importlib.import_module("cv2")

    def rectified(left: Array, right: Array) -> tuple[Array, Array]:
        matrix, _ = cv2.findFundamentalMat(left, right, cv2.FM_8POINT)
        _, *homographies = cv2.stereoRectifyUncalibrated(left, right, matrix, (1, 1))
        mapped = (
            np.column_stack([points, np.ones(len(points))]) @ matrix.T
            for points, matrix in zip((left, right), homographies, strict=True)
        )
        first, second = (rays[:, 1] / rays[:, 2] for rays in mapped)
        return first, second

    def job(left: Array, right: Array) -> Array:
        both = [rectified(*task) for task in zip(left, right, strict=True)]
        return parallax(*(np.array(rows) for rows in zip(*both, strict=True)))

    return job


def parallax(first: Array, second: Array) -> Array:
    """Return the largest difference in each task, relative to the extent of the first image."""
    return np.max(abs(first - second), axis=-1) / np.ptp(first, axis=-1)


if __name__ == "__main__":
    main()
