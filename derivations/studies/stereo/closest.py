"""The closest critical configuration: the least movement of points and centers that puts all ten on a quadric."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from algebroproj_derivations.studies.stereo.quadric import MONOMIALS, monomials
from algebroproj_derivations.studies.stereo.scenes import LEAST_POINTS, Scene, require_eight

Numbers = NDArray[np.float64]

STEPS = 100
CONVERGED = 1e-13
CERTIFIED = 1e-8
"""Largest remainder and angle of what counts as stationary."""

CRITICAL = 1e-14
"""Smallest singular value of a configuration that is critical already, but for rounding."""


@dataclass(frozen=True)
class ClosestCritical:
    """A critical configuration near a given one, and what shows that no smaller movement near it does as well.

    Attributes
    ----------
    scene : Scene
        The critical one: its points and centers lie on a quadric but for rounding.
    quadric : ndarray, shape (4, 4)
        Symmetric matrix of that quadric, a form of (1, x1, x2, x3), of Frobenius norm 1.
    distance : float
        Root of the sum of the squares of all movements, in the unit of length of the scene.
    movements : ndarray, shape (10, 3)
        Of the eight points and of both centers.
    remainder : float
        How far, to first order and relative to the distance, the points are from a common quadric.
    angle : float
        Angle in radians between the movement and the gradient of the condition.  Both vanish at a stationary point:
        this is the first-order certificate.  That it is the closest of all is not proved; several starts were tried.
    """

    scene: Scene
    quadric: Numbers
    distance: float
    movements: Numbers
    remainder: float
    angle: float


def closest_critical(scene: Scene) -> ClosestCritical:
    """Find the critical configuration that is closest to a given one.

    Parameters
    ----------
    scene : Scene
        A single one of eight points.

    Returns
    -------
    ClosestCritical

    Raises
    ------
    ValueError
        If there are not eight points.
    ArithmeticError
        If no start leads to a stationary point.

    Examples
    --------
    >>> from algebroproj_derivations.studies.stereo.layouts import LAYOUTS
    >>> exact = {layout.name: layout for layout in LAYOUTS}["two columns"].scene()
    >>> scene = exact.each(lambda part: part.astype(float))
    >>> scene.points[7] += [0.001, 0.0, 0.0]
    >>> found = closest_critical(scene)
    >>> bool(found.distance < 0.001), bool(found.angle < 1e-6)
    (True, True)
    """
    require_eight(scene)
    places = np.concatenate([scene.points, scene.centers]).astype(np.float64)
    middle, size = places.mean(axis=0), float(np.sqrt(np.mean(np.var(places, axis=0))))
    normalised = (places - middle) / size
    value, _, form = condition(normalised)
    if abs(value) <= CRITICAL:
        return ClosestCritical(scene, _at_places(form, middle, size), 0.0, 0 * places, 0.0, 0.0)
    candidates = [_descended(normalised, start) for start in _starts(normalised)]
    stationary = [move for move in candidates if _is_stationary(normalised, move)]
    if not stationary:
        raise ArithmeticError("closest_critical: expected a stationary point from one of the starts, found none")
    best = min(stationary, key=lambda move: float(np.linalg.norm(move)))
    remainder, angle = _certificate(normalised, best)
    moved = places + size * best
    critical = Scene(moved[:LEAST_POINTS], moved[LEAST_POINTS:], scene.planes)
    form = _at_places(condition(normalised + best)[2], middle, size)
    return ClosestCritical(critical, form, size * float(np.linalg.norm(best)), size * best, remainder, angle)


def condition(places: Numbers) -> tuple[float, Numbers, Numbers]:
    """Return a function of ten places that vanishes where a quadric contains them, with its gradient and the quadric.

    Parameters
    ----------
    places : ndarray, shape (10, 3)
        Points and centers.

    Returns
    -------
    value : float
        The smallest singular value of their monomials, with the sign of the determinant: smooth where it is simple.
    gradient : ndarray, shape (10, 3)
        Its derivatives.
    quadric : ndarray, shape (4, 4)
        The form of norm 1 whose values at the places are least.
    """
    y = np.concatenate([np.ones((len(places), 1)), places], axis=-1)
    products = monomials(places).astype(np.float64)
    left, values, right = np.linalg.svd(products)
    sign = float(np.linalg.slogdet(products)[0]) or 1.0
    form = np.zeros((4, 4))
    for (i, j), coefficient in zip(MONOMIALS, right[-1], strict=True):
        form[i, j] += coefficient / 2
        form[j, i] += coefficient / 2
    gradient = sign * left[:, -1:] * (2 * y @ form)[:, 1:]
    return sign * float(values[-1]), gradient, form


def _starts(places: Numbers) -> list[Numbers]:
    """Return movements to first order: of all places, and of each one alone."""
    value, gradient, _ = condition(places)
    alone = [np.where(np.arange(len(places))[:, None] == k, gradient, 0.0) for k in range(len(places))]
    starts = [-value * part / np.sum(part**2) for part in (gradient, *alone) if np.any(part)]
    return [start * min(1.0, 1.0 / float(np.linalg.norm(start))) for start in starts]


def _descended(places: Numbers, start: Numbers) -> Numbers:
    """Return a movement to a critical configuration that is stationary in size, if the descent finds one."""
    projected = _projected(places, start)
    if _is_stationary(places, projected):
        return projected
    unit = float(np.linalg.norm(start)) or 1.0

    def place(parameters: Numbers) -> Numbers:
        return unit * parameters.reshape(-1, 3)

    def scaled(parameters: Numbers) -> float:
        return condition(places + place(parameters))[0] / unit

    def derivative(parameters: Numbers) -> Numbers:
        return condition(places + place(parameters))[1].reshape(-1)

    found = minimize(
        lambda parameters: 0.5 * float(parameters @ parameters),
        (start / unit).reshape(-1),
        jac=lambda parameters: parameters,
        constraints={"type": "eq", "fun": scaled, "jac": derivative},
        method="SLSQP",
        options={"ftol": 1e-15, "maxiter": 100},
    )
    return _projected(places, place(found.x))


def _projected(places: Numbers, movement: Numbers) -> Numbers:
    """Repeat the projection on the linearised condition, which is exact where the quadric is flat."""
    for _ in range(STEPS):
        value, normal, _ = condition(places + movement)
        following = normal * (np.sum(normal * movement) - value) / np.sum(normal**2)
        step = float(np.linalg.norm(following - movement))
        if not np.isfinite(step) or step > float(np.linalg.norm(movement)):
            return movement
        movement = following
        if step <= CONVERGED * float(np.linalg.norm(movement)):
            break
    return movement


def _certificate(places: Numbers, movement: Numbers) -> tuple[float, float]:
    """Return what is left of the condition, and the angle between the movement and its gradient."""
    value, normal, _ = condition(places + movement)
    steepness, length = float(np.linalg.norm(normal)), float(np.linalg.norm(movement))
    if length == 0.0:
        return 0.0, 0.0
    along = np.sum(normal * movement) / steepness
    across = float(np.linalg.norm(movement - along * normal / steepness))
    remainder = abs(value) / (steepness * length)
    return remainder, float(np.arctan2(across, abs(along)))


def _is_stationary(places: Numbers, movement: Numbers) -> bool:
    return max(_certificate(places, movement)) < CERTIFIED


def _at_places(form: Numbers, middle: Numbers, size: float) -> Numbers:
    """Return the form of (1, x) that belongs to one of (1, (x - middle) / size)."""
    change: Any = np.eye(4)
    change[1:, 0] = -middle / size
    change[1:, 1:] /= size
    moved = change.T @ form @ change
    return np.asarray(moved / np.linalg.norm(moved))
