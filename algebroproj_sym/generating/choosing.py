"""Choosing among equal forms of a kernel: by measured errors, and then by the number of operations.

A derivation may offer several forms of a kernel, and there is the factored form of what it derives.  Each can be
lowered with quotients as written, or with the reciprocals of shared divisors; with twice the digits where sums may
cancel, or throughout, for long products, where roundings add up; and with the last sums rounded once or twice.  All are
proved equal to the derivation.  On stratified samples they differ: their errors are those of the program on machine
numbers against its value on fractions.  Where a factor of a result is zero, a product is zero, and a sum may not be.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations
from typing import Any, TypeAlias

import numpy as np
import sympy
from numpy.typing import NDArray

from algebroproj_sym.declaring import Kernel, Result
from algebroproj_sym.expressions import Matrix, entries, evaluate, over
from algebroproj_sym.expressions.exact import fmpq, fraction
from algebroproj_sym.generating.compensation import compensated, with_sums_rounded_twice
from algebroproj_sym.generating.expansion import expanded
from algebroproj_sym.generating.factored import factored
from algebroproj_sym.generating.lowering import Lowered, lowered_form, program_of
from algebroproj_sym.generating.program import Program, run
from algebroproj_sym.generating.samples import Sample, on_sum, stratified
from algebroproj_sym.proving import RationalFunctionField

Numbers: TypeAlias = "NDArray[np.float64]"

MEDIAN_ULP = 0.55
MAX_ULP = 3.5
"""What is asked for: a little less than what is promised, since samples seldom show the largest errors."""

NOT_WORSE = 1.25
"""How many times the least error may be taken, where even that is large: so near a singularity that it may be."""

SAMPLES = 50
COSTLY = {"/": 8}
"""What an operation costs, in additions of a processor that does several at once."""


@dataclass(frozen=True)
class _Candidate:
    lowered: Lowered
    cost: int
    ulps: Numbers
    loses_zeros: bool

    @property
    def median_ulp(self) -> float:
        return float(np.median(self.ulps))


def lower(kernel: Kernel) -> Lowered:
    """Lower a kernel, prove the program, and choose it among those of equal forms.

    The cheapest one is taken each of whose errors is small, or not much larger than the least one of any program there,
    and of these one that keeps the zeros of the results, if any does.  If there is none, the one that exceeds that
    least is taken.  Programs with primitive functions, which are not exact on fractions, cannot be compared: there the
    first form is taken.

    It raises `LoweringError` if a program, run on rational functions, does not give the derived expression, or an entry
    is a constant fraction, which integers cannot give.
    """
    if not kernel.is_rational:
        return lowered_form(mirrored(kernel)[0])
    simple = factored(kernel)
    lowered = list(_distinct(kernel, simple))
    if len(lowered) == 1:
        return lowered[0]
    places = [place for place, output in enumerate(lowered[0].plain.outputs) if not isinstance(output, int)]
    inputs, truths = _truths(lowered[0].plain, stratified(lowered[0], SAMPLES), places)
    zeros = _truths(lowered[0].plain, _on_sums(simple) if simple else [], places)
    candidates = [_measured(each, inputs, truths, zeros, places) for each in lowered]
    median = max(MEDIAN_ULP, min(candidate.median_ulp for candidate in candidates))
    most = np.fmax(MAX_ULP, NOT_WORSE * np.min([candidate.ulps for candidate in candidates], axis=0))

    def excess(candidate: _Candidate) -> float:
        with np.errstate(invalid="ignore"):
            return float(np.fmax.reduce(candidate.ulps / most, initial=max(1, candidate.median_ulp / median)))

    best = min(
        candidates,
        key=lambda candidate: (excess(candidate), candidate.loses_zeros, candidate.cost, np.max(candidate.ulps)),
    )
    return replace(best.lowered, forms=len(lowered))


def _distinct(kernel: Kernel, simple: Kernel | None) -> Iterator[Lowered]:
    """Yield the lowered forms of a kernel whose programs differ; the factored one is the last."""
    forms = [kernel, *kernel.alternatives, *([simple] if simple else [])]
    forms = [each for form in forms for each in mirrored(form)]
    programs: set[Program] = set()
    for form in forms:
        for reciprocals in (False, True):
            if reciprocals and program_of(form, (), reciprocals) == program_of(form, ()):
                continue
            lowered = lowered_form(form, reciprocals)
            wide = lowered.program, compensated(lowered.plain, throughout=True)
            for program in (*wide, *map(with_sums_rounded_twice, wide)):
                if program not in programs:
                    programs.add(program)
                    yield replace(lowered, program=program)


def _on_sums(simple: Kernel) -> list[Sample]:
    """Return samples at which a factor of a result in factored form is exactly zero that is a sum of inputs."""
    names = dict(simple.where)
    numerators = [entry.args[0] for entry in entries(simple.form) if isinstance(entry, over)]
    bases = {power.as_base_exp()[0] for numerator in numerators for power in sympy.Mul.make_args(numerator)}
    factors = {names.get(base, base) for base in bases}
    sums = [factor for factor in factors if _is_sum(factor) and not factor.free_symbols & {*names}]
    return [sample for factor in sorted(sums, key=str) for sample in on_sum(factor, simple.symbols, SAMPLES)]


def _is_sum(factor: sympy.Expr) -> bool:
    """Whether an expression is a sum of symbols and numbers, with signs."""
    return factor.is_Add and all((-term).is_Symbol or term.is_Symbol or term.is_Integer for term in factor.args)


def _truths(
    program: Program, samples: Sequence[Sample], places: Sequence[int]
) -> tuple[Mapping[str, Numbers], Numbers]:
    """Return the inputs for which a program has results, and exact entries of these, each as the sum of two numbers."""
    found = [(sample.values, _results(program, sample)) for sample in samples]
    known = [(values, results) for values, results in found if results is not None]
    inputs = {name: np.array([values[name] for values, _ in known]) for name in program.inputs}
    exact = [[_two_numbers(results[place]) for place in places] for _, results in known]
    return inputs, np.reshape(exact, (len(known), len(places), 2))


def _results(program: Program, sample: Sample) -> tuple[Any, ...] | None:
    """Return the exact results, None where there are none."""
    try:
        return run(program, {name: fmpq(Fraction(value)) for name, value in sample.values.items()})
    except ZeroDivisionError:
        return None


def _two_numbers(exact: Any) -> tuple[float, float]:
    nearest = float(fraction(exact))
    return nearest, float(fraction(exact - fmpq(Fraction(nearest))))


def _measured(
    lowered: Lowered,
    inputs: Mapping[str, Numbers],
    truths: Numbers,
    zeros: tuple[Mapping[str, Numbers], Numbers],
    places: Sequence[int],
) -> _Candidate:
    """Measure the errors of some entries, in units in the last place of the exact ones, and whether it loses zeros."""
    nearest, rest = truths[..., 0], truths[..., 1]
    values = _computed(lowered, inputs, places, len(truths))
    with np.errstate(all="ignore"):
        ulps = abs(values - nearest - rest) / np.spacing(abs(nearest))
    ulps[~np.isfinite(values)] = np.inf
    at, exact = zeros
    lost = (_computed(lowered, at, places, len(exact)) != 0) & (exact[..., 0] == 0)
    operations = expanded(lowered.program).operations()
    cost = sum(COSTLY.get(operator, 1) * count for operator, count in operations.items())
    return _Candidate(lowered, cost, ulps.ravel(), bool(lost.any()))


def _computed(lowered: Lowered, inputs: Mapping[str, Numbers], places: Sequence[int], size: int) -> Numbers:
    """Return some entries of the results of a program, a row for each input."""
    with np.errstate(all="ignore"):
        results = run(lowered.program, inputs)
    return np.stack([np.broadcast_to(results[place], size) for place in places], axis=1)


def mirrored(kernel: Kernel) -> list[Kernel]:
    """Return a kernel in whose symmetric and skew results the upper triangle stands for the lower one, and conversely.

    What is derived decides whether a result is symmetric.  A kernel without such results is returned alone.

    Examples
    --------
    >>> import sympy
    >>> from algebroproj_sym.declaring.kernel import declared_kernel
    >>> a, b = sympy.symbols("a b")
    >>> told = {"arguments": {"a": a, "b": b}, "describe": {"a": "", "b": ""}, "example": {"a": "1", "b": "2"}}
    >>> square = sympy.ImmutableMatrix([[a, a * (a + b)], [a**2 + b * a, b]])
    >>> kernel = declared_kernel("p", "1", "m.f", "F.", derived=square, claims=["1"], **told)
    >>> [each.form[0, 1] for each in mirrored(kernel)]
    [a*(a + b), a**2 + a*b]
    """
    field = RationalFunctionField((*kernel.symbols, *kernel.intermediate), "flint")
    signs = [_sign(result, field) for result in kernel.results]
    if not any(signs):
        return [kernel]
    both = ([_turned(*each, upper) for each in zip(kernel.results, signs, strict=True)] for upper in (True, False))
    return [replace(kernel, results=tuple(results)) for results in both]


def _sign(result: Result, field: RationalFunctionField) -> int:
    """Return 1 for a symmetric result, -1 for a skew one, and 0 if there is nothing to gain."""
    size = result.shape
    if len(size) < 2 or size[0] != size[1] or result.form in (result.form.T, -result.form.T):
        return 0
    values = evaluate(result.derived, field.variables, field.lift)
    places = range(size[0])
    both = [(values[i * size[0] + j], values[j * size[0] + i]) for i, j in combinations(places, 2)]
    if all((above - below).is_zero for above, below in both):
        return 1
    diagonal = [values[i * size[0] + i] for i in places]
    return -all(value.is_zero for value in [*diagonal, *(above + below for above, below in both)])


def _turned(result: Result, sign: int, upper: bool) -> Result:
    form = result.form
    if not sign:
        return result
    return replace(
        result, form=Matrix(*result.shape, lambda i, j: form[i, j] if i == j or (i < j) == upper else sign * form[j, i])
    )
