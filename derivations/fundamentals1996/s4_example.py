# %% [markdown]
# # 4 The numerical example, computed
#
# Items a) to i) with the generated functions, from the coordinates of the object points to the pixels of the normal
# case.  The modules `s4_a_coordinates`, `s4_c_correlation` and `s4_f_normal_case` judge what the paper prints; this one
# shows how an engineer computes the same.  Everything happens in `example`, in floating-point arithmetic.

# %%
from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import algebroproj
from algebroproj_derivations.fundamentals1996.s4_a_coordinates import BASIC, CARTESIAN, R_LEFT, R_RIGHT

CENTERS = ("O1", "O2")
POINTS = tuple(name for name in CARTESIAN if name not in CENTERS)
CORRELATION_POINTS = ("2", "3", "6", "7", "8")
FIFTH_POINT = "13"
PRINCIPAL_DISTANCE = 2.5
AXIS_POINT = np.array([-1.0, 0.5, 3.5])
ORIGIN, SCALE, SHIFT = 100.0, 256.0, 45.7


class Example(NamedTuple):
    """What the items a) to i) compute; points in the order of `POINTS`, left before right."""

    affine: Any
    centers: Any
    images: Any
    u: Any
    Z: Any
    epipoles: Any
    mu: Any
    model_centers: Any
    model: Any
    transformed_model: Any
    first_z_n: Any
    first_normal: Any
    first_model: Any
    second_z_n: Any
    second_tau: Any
    second_normal: Any
    second_mu: Any
    second_centers: Any
    pixels: Any
    parallaxes: Any


# %% [markdown]
# Rows of a table are picked by the names of points.


# %%
def rows(table: Any, *names: str) -> Any:
    return table[..., [POINTS.index(name) for name in names], :]


# %% [markdown]
# b) The pictures, and the affine coordinates of their points: $u$ refers to the images of the points 1, 4, 5.


# %%
def pictures(points: Any, centers: Any) -> Any:
    rotations = np.array([R_LEFT, R_RIGHT], dtype=float)
    rays = np.einsum("sij,snj->sni", rotations, points - centers[:, None])
    return -PRINCIPAL_DISTANCE * rays[..., :2] / rays[..., 2:]


# %% [markdown]
# The items one after the other.


# %%
def example() -> Example:
    affine, correlation, normal_case = algebroproj.affine, algebroproj.correlation, algebroproj.normal_case
    orientation, projection, space = algebroproj.orientation, algebroproj.projection, algebroproj.space
    points, centers = (np.array([CARTESIAN[name] for name in names], dtype=float) for names in (POINTS, CENTERS))

    # a) affine coordinates of the object
    frame = rows(points, *BASIC)
    object_points = affine.space_coordinates(points, frame)

    # b) images
    images = pictures(points, centers)
    u = affine.plane_coordinates(images, rows(images, *BASIC[:3])[:, None])
    u3_left, u3_right = rows(u, BASIC[3])[:, 0]

    # c) correlation and epipoles
    Z = correlation.correlation_matrix(*rows(u, *CORRELATION_POINTS))
    epipole_left, epipole_right = correlation.epipoles(Z)

    # d) relative orientation
    mu_left = orientation.left_bundle(AXIS_POINT, epipole_left, u3_left)
    center_left = projection.center_from_mu(mu_left, u3_left)
    mu_right = orientation.right_bundle(AXIS_POINT, center_left, epipole_right, u3_right)
    center_right = projection.center_from_mu(mu_right, u3_right)

    # e) model, and its transformation to the object
    model = orientation.intersect(*u, mu_left, u3_left, mu_right, u3_right)
    fifth = rows(model, FIFTH_POINT)[0], rows(object_points, FIFTH_POINT)[0]
    transformed_model = space.map_points(space.mu_from_fifth_point(*fifth), model)

    # f) first normal case: the centers stay
    z_n, *normal_u3 = normal_case.from_orientation(AXIS_POINT, center_left, center_right, u3_left)
    first_mu = [
        projection.mu_from_center(y0, u3) for y0, u3 in zip((center_left, center_right), normal_u3, strict=True)
    ]

    # g) its coordinates
    taus = [normal_case.tau(u3, u3_n) for u3, u3_n in zip((u3_left, u3_right), normal_u3, strict=True)]
    first_normal = normal_case.map_points(np.array(taus)[:, None], u)

    # h) the same model
    first_model = orientation.intersect(*first_normal, first_mu[0], normal_u3[0], first_mu[1], normal_u3[1])

    # i) second normal case: from the correlation matrix alone
    second_z_n, *second_tau = normal_case.from_correlation(Z)
    second_normal = normal_case.map_points(np.array(second_tau)[:, None], u)
    second_u3 = rows(second_normal, BASIC[3])[:, 0]
    second_mu_left = normal_case.mu_left(AXIS_POINT, second_u3[0], second_z_n)
    second_center = projection.center_from_mu(second_mu_left, second_u3[0])
    second_mu_right = normal_case.mu_right(AXIS_POINT, second_center, second_u3[1], second_z_n)
    second_mu = np.array([second_mu_left, second_mu_right])
    frames = np.array([normal_case.frame(second_z_n, tau) for tau in second_tau])
    rectangular = np.einsum("sij,snj->sni", frames, np.insert(second_normal, 0, 1.0, axis=-1))[..., 1:]
    pixels = ORIGIN + SCALE * rectangular
    pixels[1, :, 1] += SHIFT

    return Example(
        affine=object_points,
        centers=affine.space_coordinates(centers, frame),
        images=images,
        u=u,
        Z=Z,
        epipoles=np.array([epipole_left, epipole_right]),
        mu=np.array([mu_left, mu_right]),
        model_centers=np.array([center_left, center_right]),
        model=model,
        transformed_model=transformed_model,
        first_z_n=z_n,
        first_normal=first_normal,
        first_model=first_model,
        second_z_n=second_z_n,
        second_tau=np.array(second_tau),
        second_normal=second_normal,
        second_mu=second_mu,
        second_centers=projection.center_from_mu(second_mu, second_u3),
        pixels=pixels,
        parallaxes=pixels[0, :, 1] - pixels[1, :, 1],
    )


# %% [markdown]
# Fig. 3.5: the pictures of item b) above, the normal case below, where homologous points have one ordinate $X_1$.


# %%
def figure(result: Example, path: Path | None = None) -> Any:
    """Draw Fig. 3.5; write it to a file if a path is given."""
    from matplotlib.figure import Figure

    drawing = Figure(figsize=(9, 9.5), layout="constrained")
    axes = drawing.subplots(2, 2, sharey="row")
    for side, (above, below) in enumerate(zip(*axes, strict=True)):
        name = ("left", "right")[side]
        _draw(above, result.images[side], f"{name} picture", ("x [dm]", "y [dm]"))
        _draw(below, result.pixels[side, :, ::-1], f"normal case, {name}", ("$X_2$ [pixel]", "$X_1$ [pixel]"))
        above.set_xlim(np.mean(result.images[side, :, 0]) + np.array([-1.0, 1.0]))
        below.set_xlim(30, 430)
        for ordinate in result.pixels[0, :, 0]:
            below.axhline(ordinate, color="0.8", linewidth=0.6, zorder=0)
    axes[0, 0].set_ylim(-0.85, 1.15)
    axes[1, 0].set_ylim(70, 390)
    if path is not None:
        drawing.savefig(path, dpi=150)
    return drawing


def _draw(axes: Any, points: Any, title: str, labels: tuple[str, str]) -> None:
    axes.set_title(title)
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])
    axes.set_aspect("equal")
    axes.scatter(*points.T, s=14, color="black")
    for name, point in zip(POINTS, points, strict=True):
        offset = (5, -9) if name == BASIC[0] else (5, 3)
        axes.annotate(name, point, xytext=offset, textcoords="offset points", fontsize=8)


# %%
if __name__ == "__main__":
    figure(example(), Path("figure-3.5.png"))
