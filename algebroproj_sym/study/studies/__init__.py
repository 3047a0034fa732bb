"""The ready studies, in the order in which a reader may want them."""

from __future__ import annotations

from algebroproj_sym.study.declaration import Study
from algebroproj_sym.study.studies import example, layouts, near_critical

STUDIES: tuple[Study, ...] = tuple(module.STUDY for module in (near_critical, layouts, example))

__all__ = ["STUDIES"]
