"""What an engineer computes with OpenCV or COLMAP, beside the functions of this package: the largest differences.

    python benchmarks/conversions.py [SEED]

The scene has two cameras with different calibrations and forty points.  A difference is relative to the largest number
of what is compared.  Where neither program has a function, the comparison is with textbook formulas of NumPy.
"""

import sys

import cv2
import numpy as np
import pycolmap

from algebroproj import correlation, metric, minimal, orientation, projection, stereo
from algebroproj_sym.study.conditioning import jacobian

COUNT = 40
SIGMA = 0.5
"""Standard deviation of the measured pixels."""


def homogeneous(points):
    """Return points with a last coordinate 1."""
    return np.concatenate([points, np.ones((*points.shape[:-1], 1))], axis=-1)


def apart(found, expected):
    """Return the largest difference of two arrays up to a factor, relative to the largest element."""
    found, expected = (np.asarray(each, float) / np.linalg.norm(each) for each in (found, expected))
    return min(np.abs(found - sign * expected).max() for sign in (1, -1)) / np.abs(expected).max()


def off(found, expected):
    """Return the largest difference of two arrays, relative to the largest element."""
    return np.abs(np.asarray(found) - expected).max() / np.abs(expected).max()


def derivatives(function, *arguments):
    """Return central differences by all numbers of the arguments, a column for each."""
    columns = []
    for place, argument in enumerate(arguments):
        for element in np.ndindex(argument.shape):
            ends = []
            for sign in (1, -1):
                moved = [each.copy() for each in arguments]
                moved[place][element] += sign * 1e-6
                found = function(*moved)
                ends.append(np.concatenate([np.ravel(each) for each in (found if type(found) is tuple else (found,))]))
            columns.append((ends[0] - ends[1]) / 2e-6)
    return np.stack(columns, axis=-1)


def main(seed=1):
    """Print a line for each comparison."""
    generator = np.random.default_rng(seed)
    k_left = np.array([[1000.0, 0, 510], [0, 1010, 490], [0, 0, 1]])
    k_right = np.array([[1200.0, 0, 620], [0, 1190, 480], [0, 0, 1]])
    turn_known = cv2.Rodrigues(np.array([0.05, 0.3, -0.04]))[0]
    t = np.array([-1.0, 0.1, 0.2])
    points = generator.uniform((-1, -1, 4), (1, 1, 6), (COUNT, 3))
    pixels = [
        cv2.projectPoints(points, each, shift, k, None)[0][:, 0] + SIGMA * generator.normal(size=(COUNT, 2))
        for each, shift, k in ((np.eye(3), np.zeros(3), k_left), (turn_known, t, k_right))
    ]
    x1, x2 = (cv2.undistortPoints(each, k, None)[:, 0] for each, k in zip(pixels, (k_left, k_right), strict=True))

    def line(what, here, there, difference):
        print(f"| {what} | `{here}` | `{there}` | {difference:.0e} |")

    print("| what | here | there | largest difference |\n|---|---|---|---|")
    turn_relative, b = stereo.relative(np.eye(3), np.zeros(3), turn_known, t)
    essential = np.array([[0, -t[2], t[1]], [t[2], 0, -t[0]], [-t[1], t[0], 0]]) @ turn_known
    transposed = essential.T
    r, translation, *_ = cv2.composeRT(np.zeros((3, 1)), np.zeros((3, 1)), cv2.Rodrigues(turn_known)[0], t[:, None])
    line("two poses to one: R", "stereo.relative", "composeRT", off(turn_relative.T, cv2.Rodrigues(r)[0]))
    line("two poses to one: t", "stereo.relative", "composeRT", off(-turn_relative.T @ b, translation[:, 0]))
    fundamental = stereo.fundamental_matrix(transposed, k_left, k_right)
    line(
        "F of E",
        "stereo.fundamental_matrix",
        "NumPy",
        apart(fundamental, np.linalg.inv(k_right).T @ essential @ np.linalg.inv(k_left)),
    )
    pose = pycolmap.Rigid3d(pycolmap.Rotation3d(turn_known), t)
    line(
        "E of R and t",
        "metric.correlation_matrix",
        "pycolmap.essential_matrix_from_pose",
        apart(
            metric.correlation_matrix(np.eye(3), turn_known.T, -turn_known.T @ t).T,
            pycolmap.essential_matrix_from_pose(pose),
        ),
    )

    solutions = minimal.five_pairs(x1[:5], x2[:5])
    found = cv2.findEssentialMat(x1[:5], x2[:5], np.eye(3))[0].reshape(-1, 3, 3)
    each = [min(apart(other.T, essential) for other in found) for essential in solutions.E[: solutions.count]]
    line("all E of five pairs", "minimal.five_pairs", "findEssentialMat", max(each))
    sevens = minimal.seven_pairs(pixels[0][:7], pixels[1][:7])
    found = cv2.findFundamentalMat(pixels[0][:7], pixels[1][:7], cv2.FM_7POINT)[0].reshape(-1, 3, 3)
    each = [min(apart(other.T, fundamental) for other in found) for fundamental in sevens.F[: sevens.count]]
    line("all F of seven pairs", "minimal.seven_pairs", "findFundamentalMat, FM_7POINT", max(each))

    poses = stereo.poses(transposed, x1, x2)
    _, r_opencv, t_opencv, mask = cv2.recoverPose(essential, x1, x2, np.eye(3))
    turn_1, b1 = poses.R[0], poses.b[0]
    line("orientation: R", "stereo.poses", "recoverPose", off(turn_1.T, r_opencv))
    line("orientation: t", "stereo.poses", "recoverPose", off(-turn_1.T @ b1, t_opencv[:, 0]))
    line(
        "number of points in front", "stereo.poses", "recoverPose", abs(int(poses.in_front[0]) - int((mask > 0).sum()))
    )
    four = cv2.decomposeEssentialMat(essential)
    each = [min(np.abs(turn.T - other).max() for other in four[:2]) for turn in poses.R]
    line("all four orientations", "stereo.poses", "decomposeEssentialMat", max(each))

    near = stereo.corrected(transposed, x1, x2)
    corrected = cv2.correctMatches(essential, x1[None], x2[None])
    line("nearest pairs that fit", "stereo.corrected", "correctMatches", off(near.x_left, corrected[0][0]))
    here = np.hstack([np.eye(3), np.zeros((3, 1))]), np.hstack([r_opencv, t_opencv])
    found_points = stereo.triangulate(turn_1, b1, near.x_left, near.x_right)
    linear = cv2.triangulatePoints(*here, near.x_left.T, near.x_right.T)
    line(
        "points",
        "stereo.triangulate, of corrected",
        "triangulatePoints, of corrected",
        off(found_points, (linear[:3] / linear[3]).T),
    )
    line(
        "one point",
        "stereo.triangulate",
        "pycolmap.triangulate_point",
        off(found_points[0], pycolmap.triangulate_point(*here, near.x_left[0], near.x_right[0])),
    )
    distances = stereo.sampson(transposed, x1, x2)[0]
    sampson = [cv2.sampsonDistance(a, c, essential) for a, c in zip(homogeneous(x1), homogeneous(x2), strict=True)]
    line("square of Sampson's distance", "stereo.sampson", "sampsonDistance", off(distances, sampson))
    _, right = stereo.residuals(found_points, turn_1, b1, x1, x2)
    projected = cv2.projectPoints(found_points, r_opencv, t_opencv, np.eye(3), None)[0][:, 0]
    line("residuals of the right image", "stereo.residuals", "projectPoints", off(right, x2 - projected))

    turns = stereo.rectify(turn_1, b1)
    rectified = cv2.stereoRectify(np.eye(3), None, np.eye(3), None, (2, 2), r_opencv, t_opencv, flags=0, alpha=-1)
    line("rectified first axis", "stereo.rectify", "stereoRectify", off(turns.R_1[0], rectified[0][0]))
    rows = [
        [(turn @ ray)[1] / (turn @ ray)[2] for ray in homogeneous(x)]
        for turn, x in ((turns.R_1, near.x_left), (turns.R_2, near.x_right), (rectified[0], near.x_left))
    ]
    line("y of homologous points, rectified", "stereo.rectify", "the same", off(rows[0], rows[1]))

    camera = k_right @ np.hstack([turn_known, t[:, None]])
    basic = np.array([[0, 0, 5], [1, 0, 5.5], [0, 1, 5.25], [0.5, 0.5, 6.0]])
    again = projection.to_camera(*projection.from_camera(camera, basic), basic)
    k, turn, center, *_ = cv2.decomposeProjectionMatrix(np.asarray(again) * np.sign(np.linalg.det(again[:, :3])))
    line("K of the parameters of 1996", "projection.to_camera", "decomposeProjectionMatrix", off(k / k[2, 2], k_right))
    line("R of the parameters of 1996", "projection.to_camera", "decomposeProjectionMatrix", off(turn, turn_known))
    line(
        "center",
        "projection.to_camera",
        "decomposeProjectionMatrix",
        off(center[:3, 0] / center[3, 0], -turn_known.T @ t),
    )

    first, last = np.ix_([2, 0, 1], [2, 0, 1]), np.ix_([1, 2, 0], [1, 2, 0])
    for side, matrix, epipole in zip(
        ("left", "right"), (fundamental, fundamental.T), correlation.epipoles(fundamental.T[first]), strict=True
    ):
        null = np.linalg.svd(matrix)[2][-1]
        line(f"epipole, {side}", "correlation.epipoles", "NumPy: kernel of F", off(epipole, null[:2] / null[2]))
    eight = [each[:8] for each in pixels]
    found = correlation.general_correlation_matrix(*eight)[last].T
    rows = np.einsum("ni,nj->nij", homogeneous(eight[1]), homogeneous(eight[0])).reshape(8, 9)
    line(
        "matrix of eight pairs",
        "correlation.general_correlation_matrix",
        "NumPy: kernel",
        apart(
            found,
            np.linalg.svd(rows / np.abs(rows).max(axis=0))[2][-1].reshape(3, 3)
            / np.abs(rows).max(axis=0).reshape(3, 3),
        ),
    )

    u = generator.normal(size=(2, 5, 2)) * 0.1 + generator.uniform(0.2, 1, (5, 2))
    z = correlation.correlation_matrix(*u)
    mu, u3 = generator.uniform(0.5, 2, (2, 3)), generator.uniform(0, 1, (2, 2))
    seen = u[0][0], u[1][0], mu[0], u3[0], mu[1], u3[1]
    for function, arguments in (
        (correlation.correlation_matrix, tuple(u)),
        (correlation.epipoles, (np.asarray(z),)),
        (orientation.intersect, seen),
        (stereo.triangulate, (turn_1, b1, x1[0], x2[0])),
    ):
        _, exact = jacobian(function, *arguments)
        name = f"{function.__module__.rpartition('.')[2]}.{function.__name__}"
        line(
            f"derivatives of `{function.__name__}`",
            f"jacobian({name}, ...)",
            "central differences",
            off(exact, derivatives(function, *arguments)),
        )


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
