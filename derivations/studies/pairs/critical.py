"""How far pairs are from the nearest critical configuration: a proved lower bound, and one that attains an upper bound.

The rows x2 (x) x1 of n pairs form a matrix A of n rows and 9 columns.  The pairs are critical if its rank is less than
8: then the linear equations leave a choice.  The distance is the root of the sum of the squares by which all 4n
coordinates move, in pixels.

The lower bound says that nothing nearer is critical, wherever it is.  A kernel of A + E(d) of two columns is B0 + B1 C,
where B0 and B1 are nearly the singular vectors of A, two and seven.  For any matrix Y of n rows and 2 columns,

    <Y, A B0> = -<Y, E(d) B0> - <Y, E(d) B1 C> - <Y, A B1 C>,   C = -(Z A B1 + Z E(d) B1)^-1 (Z A B0 + Z E(d) B0),

with any Z of 7 rows, nearly an inverse of A B1.  All terms on the right have bounds that grow with the length of d, so
the equation has no solution below some length.  Eigenvalues are bounded by Cholesky's factorisation, which proves that
a matrix is positive definite; all sums have the rounding errors of their length and of the size of their terms added.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from algebroproj_derivations.studies.pairs.normalising import Pairs, sample

Numbers = NDArray[np.float64]

ROUNDOFF = 2.0**-53
DENSE = 40
"""Up to how many pairs the terms of second order are bounded together, not one by one."""
RESTRICTED = 200
"""Up to how many pairs the kernels that are left are restricted."""
FARTHER = 1.8
TRIALS = 6
ROUNDS = 8
SHARES = tuple(10.0**k for k in np.linspace(-3, 1, 7))
NEGLIGIBLE = 1e-9
BISECTIONS = 60
STEPS = 40
CONVERGED = 1e-10
IMPROVED = 1e-4


@dataclass(frozen=True)
class Critical:
    """The nearest critical configuration that was found.

    Attributes
    ----------
    lower : float
        No critical configuration is nearer, in pixels.
    upper : float
        Distance of this one.
    pixels : ndarray, shape (2, n, 2)
        Its pairs.
    kernel : ndarray, shape (2, 3, 3)
        Two matrices that it fulfils, for points to scale.
    """

    lower: float
    upper: float
    pixels: Numbers
    kernel: Numbers


def nearest_critical(pairs: Pairs) -> Critical:
    """Return the nearest critical configuration that was found, and how near another one might be.

    Examples
    --------
    >>> from algebroproj_derivations.studies.pairs.normalising import pairs_of
    >>> from algebroproj_derivations.studies.pairs.populating import pair
    >>> known = pair(1, "plane", count=12, sigma=0.5)
    >>> found = nearest_critical(pairs_of(known.x1, known.x2))
    >>> bool(0 < found.lower <= found.upper)
    True
    """
    some, starts = sample(pairs), _starts(pairs)
    if some is not pairs:
        kernel = min((_approached(some, start) for start in starts), key=_distance)[2]
        starts = [kernel.reshape(2, 9).T] if kernel.any() else starts
    found = [flattened(pairs), *(_approached(pairs, start) for start in starts)]
    distance, moved, kernel = min(found, key=_distance)
    return Critical(min(lower_bound(pairs), distance), distance, moved, kernel)


def _distance(found: tuple[float, Numbers, Numbers]) -> float:
    return found[0]


def rows(points: Numbers) -> Numbers:
    """Return the rows x2 (x) x1, shape (n, 9)."""
    return np.einsum("ni,nj->nij", points[1], points[0]).reshape(-1, 9)


def slopes(points: Numbers, scales: Numbers) -> Numbers:
    """Return the derivatives of the rows by the pixels x1, y1, x2, y2, shape (n, 9, 4)."""
    first, second = points
    result = np.zeros((len(first), 3, 3, 4))
    for k in range(2):
        result[:, :, k, k] = scales[0] * second
        result[:, k, :, 2 + k] = scales[1] * first
    return result.reshape(-1, 9, 4)


def lower_bound(pairs: Pairs) -> float:
    """Return a distance, in pixels, below which no pairs are critical.

    Examples
    --------
    >>> from algebroproj_derivations.studies.pairs.normalising import pairs_of
    >>> corners = [[0, 0], [0, 900], [900, 0], [900, 900], [300, 400], [400, 200], [700, 500], [500, 800]]
    >>> lower_bound(pairs_of(corners, corners))
    0.0
    """
    a, linear = rows(pairs.points), slopes(pairs.points, pairs.scales)
    rounding = 16 * (4 * len(a) + 200) * ROUNDOFF
    moved = np.sqrt(4 * len(a)) * 16 * ROUNDOFF * np.abs(pairs.pixels).max()
    norms, half = _norms(pairs) * (1 + rounding), float(pairs.scales.prod()) / 2 * (1 + rounding)
    found = max(_by_eigenvalues(a, linear, norms, half, rounding), _by_elimination(a, linear, norms, half, rounding))
    return max(0.0, found * (1 - rounding) - moved)


def _norms(pairs: Pairs) -> Numbers:
    """Return by how much, at most, a row changes with its pixels: the norms of the matrices of `slopes`."""
    squares = (pairs.points**2).sum(axis=2) * pairs.scales[::-1, None] ** 2
    mixed = pairs.scales.prod() * np.linalg.norm(pairs.points[..., :2], axis=2).prod(axis=0)
    return np.asarray(np.sqrt(squares.mean(axis=0) + np.hypot((squares[0] - squares[1]) / 2, mixed)))


def _by_eigenvalues(a: Numbers, linear: Numbers, norms: Numbers, half: float, rounding: float) -> float:
    """Return the greatest distance that `_is_excluded`, beginning with what is excluded without a restriction."""
    squares = _sum_of_least(a / norms[:, None], rounding)
    target = np.sqrt(max(0.0, squares)) * (1 - rounding)
    low = 2 * target / (1 + np.sqrt(1 + 4 * half / float(norms.min()) * target))
    high = FARTHER * low
    for _ in range(TRIALS if len(a) <= RESTRICTED and low > 0 else 0):
        middle = (low + high) / 2
        low, high = (middle, high) if _is_excluded(middle, a, linear, norms, half, rounding) else (low, middle)
    return low


def _is_excluded(r: float, a: Numbers, linear: Numbers, norms: Numbers, half: float, rounding: float) -> bool:
    """Return whether it is proved that nothing critical is as near as r.

    Let B be a kernel of two orthonormal columns, at a distance of at most r.  A row has ``a B = -(E d + q(d, d)) B``,
    which is not longer than ``(sqrt(m) + half r) |d|`` if ``b^T E E^T b <= m`` for all b of length 1 in the kernel.  So
    the squares of all ``a B``, divided by those factors, have a sum of at most r**2, and at least that of the two least
    eigenvalues of W, which has the divided rows.  If this is more, there is no such kernel.

    If not, ``b^T W b`` is at most r**2 less the least eigenvalue, and this restricts b: for any l of at least 0, m may
    be the largest eigenvalue of ``E E^T - l W``, and l times that bound (the S-lemma).  With these m one tries again.
    """
    forms = np.einsum("nik,njk->nij", linear, linear)
    m = norms**2
    for _ in range(ROUNDS):
        divided = a / (np.sqrt(m) + half * r)[:, None] * (1 - rounding)
        w = divided.T @ divided
        size = float(np.trace(w))
        if _sum_of_least(divided, rounding) > r**2 * (1 + rounding):
            return True
        bound = max(0.0, r**2 - _least(w, rounding)) + 2 * rounding * size
        scale = float(m.mean() / np.linalg.eigvalsh(w)[2])
        tried = [_largest(forms - share * scale * w) + share * scale * (bound + rounding * size) for share in SHARES]
        least = np.minimum(np.min(tried, axis=0) + rounding * norms**2, m)
        if (least > (1 - IMPROVED) * m).all():
            return False
        m = np.maximum(least, NEGLIGIBLE * m)
    return False


def _sum_of_least(b: Numbers, rounding: float) -> float:
    """Return a bound below the sum of the squares of the last two singular values."""
    normal = b.T @ b
    last = np.linalg.eigh(normal)[1][:, 0]
    return _least(normal, rounding) + _least(normal + np.trace(normal) * np.outer(last, last), rounding)


def _by_elimination(a: Numbers, linear: Numbers, norms: Numbers, half: float, rounding: float) -> float:
    """Return the bound of the equation above."""
    weights = 1 / norms
    for _ in range(2):
        vectors = np.linalg.svd(weights[:, None] * a, full_matrices=len(a) < 9)[2]
        apart = vectors[7:].T
        turned = np.einsum("nik,ij->njk", linear, apart)
        weights = 1 / np.maximum(np.linalg.norm(turned, axis=(1, 2)), 1e-3 * norms)
    b, e = weights[:, None] * a, weights[:, None, None] * linear
    regular = vectors[:7].T
    if not np.linalg.norm(vectors @ vectors.T - np.eye(9)) < rounding / 4:
        return 0.0
    inverse = np.linalg.pinv(b @ regular)
    e0, e1 = np.einsum("nik,ij->njk", e, apart), np.einsum("nik,ij->njk", e, regular)
    dual = _dual(b @ apart, b @ regular, e0)
    along = np.einsum("nj,njk->nk", dual, e0)
    length = float(np.linalg.norm(along))
    if not length > 0:
        return 0.0
    dual, along = dual / length, along / length

    sizes, second = np.linalg.norm(b, axis=1), np.linalg.norm(dual, axis=1)
    third, whole = np.linalg.norm(inverse, axis=0), weights * norms
    target = float((dual * (b @ apart)).sum()) - rounding * float(second @ sizes)
    slack = rounding * float(third @ sizes)
    rest0 = float(np.linalg.norm(inverse @ (b @ apart))) + slack
    rest1 = float(np.linalg.norm(inverse @ (b @ regular) - np.eye(7))) + slack
    rest_dual = float(np.linalg.norm(dual.T @ (b @ regular))) + rounding * float(second @ sizes)
    products = weights * half * (1 + rounding)
    q, qd = float((third * products).max()), float((second * products).max())
    z, y = (2 * float(np.linalg.norm(each * whole)) for each in (third, second))
    left = np.einsum("an,njk->ajnk", inverse, e0).reshape(14, -1)
    right = np.einsum("nik,nj->ijnk", e1, dual).reshape(14, -1)
    c, d, first = _norm(left, rounding) + rounding * z, _norm(right, rounding) + rounding * y, 1 + rounding * (1 + y)
    bent = c * d + qd
    if len(a) <= DENSE:
        bent = min(bent, _bent(left, right, dual, weights, apart, half) + rounding * (z * y + 2 * qd * len(a)))

    def excess(r: float) -> float:
        """Return what the right side can be at most, less the left side."""
        change = rest1 + (z / 2 + rounding * z) * r + q * r**2
        if not change < 1:
            return np.inf
        size = (rest0 + c * r + q * r**2) / (1 - change)
        further = rest0 + q * r**2 + change * size
        right_side = first * r + bent * r**2 + d * r * further + qd * r**2 * size + rest_dual * size
        return right_side * (1 + rounding) - target

    low, high = 0.0, max(target, 0.0)
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        low, high = (middle, high) if excess(middle) < 0 else (low, middle)
    return low


def _dual(target: Numbers, regular: Numbers, e0: Numbers) -> Numbers:
    """Return the matrix Y, shape (n, 2), orthogonal to the regular columns, of the greatest bound to first order."""
    metric = np.einsum("njk,nlk->njl", e0, e0)
    metric = metric + 1e-9 * np.trace(metric.mean(axis=0)) * np.eye(2)
    inverse = np.linalg.inv(metric)
    solved = np.einsum("njl,nl->nj", inverse, target)
    columns = np.einsum("njl,nc->njlc", inverse, regular)
    system = np.einsum("na,njlc->ajcl", regular, columns).reshape(14, 14)
    multipliers = np.linalg.lstsq(system, np.einsum("na,nj->aj", regular, solved).reshape(14), rcond=None)[0]
    dual = solved - np.einsum("njlc,cl->nj", columns, multipliers.reshape(7, 2))
    return dual - regular @ np.linalg.lstsq(regular, dual, rcond=None)[0]


def _bent(left: Numbers, right: Numbers, dual: Numbers, weights: Numbers, apart: Numbers, half: float) -> float:
    """Return a bound of the quadratic form of all that is of second order in d, from the side that matters."""
    n = len(dual)
    mixed = right.T @ left
    form = (mixed + mixed.T) / 2
    blocks = np.einsum("n,nj,abj->nab", weights, dual, apart.reshape(3, 3, 2)[:2, :2])
    for i in range(n):
        form[4 * i + 2 : 4 * i + 4, 4 * i : 4 * i + 2] -= half * blocks[i]
        form[4 * i : 4 * i + 2, 4 * i + 2 : 4 * i + 4] -= half * blocks[i].T
    return max(0.0, float(_largest(form)))


def _norm(matrix: Numbers, rounding: float) -> float:
    square = matrix @ matrix.T
    return float(np.sqrt(max(0.0, float(_largest(square)) + rounding * np.trace(square)))) * (1 + rounding)


def _largest(form: Numbers) -> Any:
    """Return bounds that the largest eigenvalues do not exceed: Cholesky's factorisation proves them."""
    size, unit = np.linalg.norm(form, axis=(-2, -1)), np.eye(form.shape[-1])
    bound = np.linalg.eigvalsh(form)[..., -1]
    margin = 64 * len(unit) * ROUNDOFF * size
    while True:
        bound = bound + margin
        definite = bound[..., None, None] * unit - form
        try:
            np.linalg.cholesky(definite)
        except np.linalg.LinAlgError:
            margin = np.maximum(2 * margin, np.finfo(np.float64).tiny)
            continue
        diagonal = np.abs(np.diagonal(definite, axis1=-2, axis2=-1)).sum(axis=-1)
        return bound + 4 * (len(unit) + 2) * ROUNDOFF * diagonal


def _least(form: Numbers, rounding: float) -> float:
    """Return a bound below the smallest eigenvalue of a Gram matrix whose entries have rounding errors."""
    return float(-_largest(-form) - rounding * np.trace(form))


def flattened(pairs: Pairs, kept: slice | NDArray[np.int64] = slice(None)) -> tuple[float, Numbers, Numbers]:
    """Return distance, pixels and kernel of points in a plane: those of the right picture move alone.

    Parameters
    ----------
    pairs : Pairs
        To scale.
    kept : slice or ndarray of int, optional
        The points that come into the plane; all by default.
    """
    first, second = pairs.points[:, kept]
    plane = homography(first, second)
    seen = first @ plane.T
    pixels = pairs.pixels[:, kept].copy()
    with np.errstate(divide="ignore", invalid="ignore"):
        moved = (seen[:, :2] / seen[:, 2:] - second[:, :2]) / pairs.scales[1]
    pixels[1] += moved
    kernel = np.stack([np.cross(np.eye(3)[k], plane, axisb=0, axisc=0) for k in range(2)])
    distance = float(np.linalg.norm(moved))
    return distance if np.isfinite(distance) else np.inf, pixels, kernel


def homography(first: Numbers, second: Numbers) -> Numbers:
    """Return a matrix H, shape (3, 3), for which the points x2 are near to H x1, for points to scale."""
    zero = np.zeros_like(first)
    along, across = second[:, :1] * first, second[:, 1:2] * first
    system = np.concatenate([np.hstack([first, zero, -along]), np.hstack([zero, first, -across])])
    found: Numbers = np.linalg.eigh(system.T @ system)[1][:, 0].reshape(3, 3)
    return found


def _starts(pairs: Pairs) -> list[Numbers]:
    """Return pairs of matrices, shape (9, 2), that the pairs nearly fulfil."""
    a, linear = rows(pairs.points), slopes(pairs.points, pairs.scales)
    norms = np.linalg.norm(linear, axis=(1, 2))
    vectors = np.linalg.eigh((a / norms[:, None]).T @ (a / norms[:, None]))[1]
    found = [vectors[:, list(chosen)] for chosen in combinations(range(4), 2)][:4]
    turned = np.einsum("nik,ij->njk", linear, found[0])
    again = a / np.linalg.norm(turned, axis=(1, 2))[:, None]
    return [np.linalg.eigh(again.T @ again)[1][:, :2], *found]


def _approached(pairs: Pairs, start: Numbers) -> tuple[float, Numbers, Numbers]:
    """Return distance, pixels and kernel of a critical configuration, by Newton's steps of least distance."""
    base, kernel = pairs.pixels, start
    moved = np.zeros((len(base[0]), 4))
    best = np.inf, base, np.zeros((2, 3, 3))
    for _ in range(STEPS):
        pixels = base + moved.reshape(-1, 2, 2).transpose(1, 0, 2)
        points = pairs.to_scale(*pixels)
        a, linear = rows(points), slopes(points, pairs.scales)
        missing = a @ kernel
        distance = float(np.linalg.norm(moved))
        if not np.isfinite(distance):
            break
        if np.linalg.norm(missing) <= CONVERGED * np.linalg.norm(a):
            improved = distance < best[0] * (1 - IMPROVED)
            if distance < best[0]:
                best = distance, pixels, kernel.T.reshape(2, 3, 3)
            if not improved:
                break
        turned = np.matmul(kernel.T, linear)
        across = np.linalg.qr(kernel, mode="complete")[0][:, 2:]
        inverse = _inverses(np.matmul(turned, turned.transpose(0, 2, 1)))
        lacking = missing - np.einsum("njk,nk->nj", turned, moved)
        free = a @ across
        products = (free[:, :, None] * free[:, None, :]).reshape(len(a), 49)
        system = (products.T @ inverse.reshape(-1, 4)).reshape(7, 7, 2, 2).transpose(0, 2, 1, 3).reshape(14, 14)
        known = -(free.T @ np.einsum("njl,nl->nj", inverse, lacking)).reshape(14)
        change = np.linalg.lstsq(system, known, rcond=1e-13)[0].reshape(7, 2)
        moved = -np.einsum("njk,njl,nl->nk", turned, inverse, lacking + free @ change)
        kernel = np.linalg.qr(kernel + across @ change)[0]
    return best


def _inverses(metric: Numbers) -> Numbers:
    """Return the inverses of symmetric matrices, shape (n, 2, 2), which may be nearly singular."""
    trace = metric[:, 0, 0] + metric[:, 1, 1]
    metric = metric + (1e-15 * trace + np.finfo(np.float64).tiny)[:, None, None] * np.eye(2)
    adjugate = trace[:, None, None] * (1 + 2e-15) * np.eye(2) - metric
    return adjugate / np.linalg.det(metric)[:, None, None]
