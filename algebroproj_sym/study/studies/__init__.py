"""The ready studies, in the order in which a reader may want them."""

from __future__ import annotations

from algebroproj_sym.study.declaration import Study
from algebroproj_sym.study.studies import (
    example,
    indicators,
    layouts,
    near_critical,
    normal_case,
    precision,
    propagation,
    scene,
)

STUDIES: tuple[Study, ...] = tuple(
    module.STUDY for module in (near_critical, indicators, layouts, propagation, precision, normal_case, example, scene)
)

__all__ = ["STUDIES"]
