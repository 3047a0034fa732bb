"""Studies: how accurate the formulas are near critical configurations, by digits and by uncertainty of the input.

A study is a declaration (`declaration`) of many independent members, whose random numbers are counted (`sampling`);
a sweep computes them in chunks that survive a kill (`sweeping`) and become one labelled dataset (`datasets`), from
which a report and figures (`figures`) are made.  `precision` evaluates the generated functions in any
arithmetic.  The studies themselves are not here: `discovery` finds them, as files.

Numbers come from `precision` (any generated function in any arithmetic), `ladder` (certified values for a batch),
`taylor` and `conditioning` (exact derivatives, condition numbers), `propagation` (errors of the input).

The core of the package needs none of this: what is here needs the extra `study`.
"""

from algebroproj_sym.study.declaration import MEMBER, Option, Study

__all__ = ["MEMBER", "Option", "Study"]
