"""What the generated functions do where a factor that must not vanish is exactly zero."""

from types import ModuleType

import numpy as np

from algebroproj_sym.expressions import Scalar
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.samples import on_factor
from algebroproj_sym.verifying.shipped import call, function_of

POINTS = 8


def silent_factors(lowered: Lowered, package: ModuleType) -> tuple[Scalar, ...]:
    """Return the factors on whose zeros a function stays finite, or for which no exact zero was found."""
    return tuple(factor for factor in lowered.rational_hypotheses if not _speaks_up(factor, lowered, package))


def _speaks_up(factor: Scalar, lowered: Lowered, package: ModuleType) -> bool:
    function = function_of(lowered.kernel, package)
    points = on_factor(factor, lowered, POINTS)
    with np.errstate(all="ignore"):
        results = [call(function, lowered.kernel, point) for point in points]
    return bool(results) and all(not np.isfinite(result).all() for result in results)
