"""What follows from constraints, step by step: the evidence of a proof, whether it multiplies out, and its record.

Every step is an identity of its own, over what the steps before it have shown, so that nothing need be multiplied out
over the constraints themselves.  Where that stays short it is done nevertheless: then no step is left.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from typing import Any, Literal, TypeAlias

from algebroproj_sym.proving.polynomials import denominator_of, divided, is_product, least_common_multiple

Cofactors: TypeAlias = Mapping[int, Any]
Squares: TypeAlias = list[tuple[Any, Any]]
Written: TypeAlias = Callable[[Any], str]

LONGEST = 1_000
"""How many terms what is multiplied out over the constraints may have."""


@dataclass(frozen=True)
class Step:
    """What follows from what is known.

    With ``sum`` for the sum of the cofactors times what is known to be zero, by its place, the identities are

    * ``multiplier * polynomial == sum`` for ``"zero"``,
    * ``multiplier == sum + factor * polynomial`` for ``"not zero"``,
    * ``multiplier * goal == sum + factor * polynomial`` for ``"goal"``, which takes the place of the goal,

    where the multiplier is a product of what does not vanish.
    """

    shows: Literal["zero", "not zero", "goal"]
    polynomial: Any
    multiplier: Any
    cofactors: Cofactors
    factor: Any = None


@dataclass(frozen=True)
class Zeros:
    """``multiplier * sum(a_j * s_j**2) == sum`` with positive numbers a_j: over the reals, every s_j is zero."""

    squares: Squares
    multiplier: Any
    cofactors: Cofactors


@dataclass(frozen=True)
class Positive:
    """``polynomial == sum(a_j * s_j**2)``, one square of which is a number: it does not vanish at any real point."""

    polynomial: Any
    squares: Squares


@dataclass(frozen=True)
class End:
    """``goal**exponent * multiplier == sum``; with exponent 0 the case is empty."""

    exponent: int
    multiplier: Any
    cofactors: Cofactors


@dataclass(frozen=True)
class Case:
    """What is assumed, what follows, and how the goal is reached: at an end, or in further cases.

    The cases of one goal are two.  A proof is a case that assumes nothing, with one further case for each of its goals.
    """

    assumed: tuple[Literal["zero", "not zero"], Any] | None
    steps: Sequence[Step | Zeros | Positive]
    rest: End | tuple[Case, ...]


def follows(case: Case, goal: Any, zeros: Sequence[Any], units: Sequence[Any], into: Callable[[Any], Any]) -> bool:
    """Whether every identity of a case multiplies out in a ring in which ``into`` takes polynomials."""
    known, nonzero = [*zeros], [*units]
    if case.assumed is not None:
        (known if case.assumed[0] == "zero" else nonzero).append(case.assumed[1])

    def combined(cofactors: Cofactors) -> Any:
        return sum((into(part) * into(known[place]) for place, part in cofactors.items()), into(goal * 0))

    def total(squares: Squares) -> Any:
        return sum((into(root) ** 2 * into(root**0 * weight) for weight, root in squares), into(goal * 0))

    for step in case.steps:
        if not isinstance(step, Step) and min(weight for weight, _ in step.squares) <= 0:
            return False
        if isinstance(step, Positive):
            is_positive = any(root.is_constant() and root != 0 for _, root in step.squares)
            if not is_positive or total(step.squares) - into(step.polynomial) != 0:
                return False
            nonzero.append(step.polynomial)
            continue
        if not is_product(step.multiplier, nonzero):
            return False
        if isinstance(step, Zeros):
            if into(step.multiplier) * total(step.squares) - combined(step.cofactors) != 0:
                return False
            known += [root for _, root in step.squares]
            continue
        left = {"zero": step.polynomial, "not zero": goal**0, "goal": goal}[step.shows]
        rest = into(step.multiplier) * into(left) - combined(step.cofactors)
        if step.shows != "zero":
            rest = rest - into(step.factor) * into(step.polynomial)
        if rest != 0:
            return False
        if step.shows == "goal":
            goal = step.polynomial
        else:
            (known if step.shows == "zero" else nonzero).append(step.polynomial)
    if isinstance(case.rest, End):
        end = case.rest
        identity = into(goal) ** end.exponent * into(end.multiplier) - combined(end.cofactors)
        return is_product(end.multiplier, nonzero) and bool(identity == 0)
    first, second = (part.assumed or ("", None) for part in case.rest)
    are_complementary = (*first, *second) == ("not zero", first[1], "zero", first[1])
    return are_complementary and all(follows(part, goal, known, nonzero, into) for part in case.rest)


# -- multiplied out over what is given


def flattened(case: Case, goal: Any, given: int) -> Case | None:
    """Return a case without steps, so many zeros being given; None if it has cases or squares, or becomes long."""
    if not isinstance(case.rest, End) or not all(isinstance(step, Step) for step in case.steps):
        return None
    one, end = goal**0, case.rest
    known: list[tuple[Any, dict[int, Any]]] = [(one, {place: one}) for place in range(given)]
    units: list[tuple[Any, Any, dict[int, Any], Any]] = []
    above, below, rest = one, one, dict[int, Any]()  # above * goal == below * current + rest
    current = goal

    def combined(cofactors: Cofactors) -> tuple[Any, dict[int, Any]]:
        common = reduce(least_common_multiple, (known[place][0] for place in cofactors), one)
        total = dict[int, Any]()
        for place, cofactor in cofactors.items():
            multiplier, parts = known[place]
            total = _plus(total, _times(cofactor * divmod(common, multiplier)[0], parts))
        return common, total

    for step in case.steps:
        assert isinstance(step, Step)
        common, total = combined(step.cofactors)
        scale = common * step.multiplier
        if step.shows == "zero":
            known.append((scale, total))
        elif step.shows == "not zero":
            units.append((step.polynomial, scale, total, common * step.factor))
        else:
            rest = _plus(_times(below, total), _times(scale, rest))
            above, below, current = above * scale, below * common * step.factor, step.polynomial
        if _length(total, scale, rest) > LONGEST:
            return None
    common, total = combined(end.cofactors)
    scale = common * end.multiplier
    between = _between(above * goal, below * current, end.exponent, one)
    multiplier = scale * above**end.exponent
    total = _plus(_times(below**end.exponent, total), _times(scale * between, rest))
    claim = goal**end.exponent
    for unit, whole, parts, cofactor in reversed(units):  # whole == sum + cofactor * unit
        count, (left, removed) = 0, divided(multiplier, [unit])
        while removed != 1:
            removed, count = divmod(removed, unit)[0], count + 1
        if count:
            between = _between(whole, cofactor * unit, count, one)
            total = _plus(_times(cofactor**count, total), _times(between * left * claim, parts))
            multiplier = whole**count * left
        if _length(total, multiplier) > LONGEST:
            return None
    return Case(None, (), End(end.exponent, multiplier, {place: part for place, part in total.items() if part != 0}))


def _plus(left: Cofactors, right: Cofactors) -> dict[int, Any]:
    return {**left, **{place: left[place] + part if place in left else part for place, part in right.items()}}


def _times(factor: Any, cofactors: Cofactors) -> dict[int, Any]:
    return {place: factor * part for place, part in cofactors.items()}


def _between(left: Any, right: Any, exponent: int, one: Any) -> Any:
    """Return ``(left**n - right**n) / (left - right)``."""
    return sum((left**k * right ** (exponent - 1 - k) for k in range(exponent)), one - one)


def _length(cofactors: Cofactors, *others: Any) -> int:
    lengths = [*map(len, cofactors.values())]
    return sum(lengths) + sum(len(other) if not isinstance(other, dict) else _length(other) for other in others)


# -- without what nothing rests on


def pruned(case: Case, given: int) -> Case:
    """Return a case without the steps that nothing rests on, so many zeros being given."""
    return _renumbered(case, _needed(case, given)[0], {place: place for place in range(given)}, given)


def _needed(case: Case, count: int) -> tuple[set[int], set[int], list[Any]]:
    """Return the steps that are needed, by identity, the places of zeros that are used, and all multipliers."""
    places = [*_places(case, count)]
    steps, used, multipliers = set[int](), set[int](), list[Any]()
    if isinstance(case.rest, End):
        used, multipliers = {*case.rest.cofactors}, [case.rest.multiplier]
    else:
        for part in case.rest:
            found = _needed(part, places[-1].stop)
            steps, used, multipliers = steps | found[0], used | found[1], multipliers + found[2]
    for step, own in zip(reversed(case.steps), reversed(places[1:]), strict=True):
        if isinstance(step, Positive) or (isinstance(step, Step) and step.shows == "not zero"):
            is_needed = any(divmod(whole, step.polynomial)[1] == 0 for whole in multipliers)
        else:
            is_needed = not own or bool(used & {*own})
        if is_needed:
            steps.add(id(step))
            if not isinstance(step, Positive):
                used |= {*step.cofactors}
                multipliers.append(step.multiplier)
    return steps, used, multipliers


def _places(case: Case, count: int) -> Iterator[range]:
    """Yield the places of the zero that is assumed, if any, and of the zeros that each step shows."""
    sizes = [int(case.assumed is not None and case.assumed[0] == "zero")]
    for step in case.steps:
        is_zero = isinstance(step, Step) and step.shows == "zero"
        sizes.append(len(step.squares) if isinstance(step, Zeros) else int(is_zero))
    for size in sizes:
        yield range(count, count + size)
        count += size


def _renumbered(case: Case, needed: set[int], new: Mapping[int, int], count: int) -> Case:
    names, kept = dict(new), list[Step | Zeros | Positive]()
    own, *places = _places(case, count)
    names |= {place: len(names) for place in own}
    for step, shown in zip(case.steps, places, strict=True):
        if id(step) in needed:
            kept.append(step if isinstance(step, Positive) else _renamed(step, names))
            names |= {place: len(names) + k for k, place in enumerate(shown)}
    if isinstance(case.rest, End):
        return Case(case.assumed, kept, _renamed(case.rest, names))
    last = places[-1].stop if places else own.stop
    return Case(case.assumed, kept, tuple(_renumbered(part, needed, names, last) for part in case.rest))


def _renamed(part: Any, names: Mapping[int, int]) -> Any:
    return replace(part, cofactors={names[place]: cofactor for place, cofactor in part.cofactors.items()})


# -- as a record


def method_of(proof: Case) -> str:
    """Return what a proof is called."""
    assert isinstance(proof.rest, tuple)
    if any(isinstance(entry.rest, tuple) for entry in proof.rest):
        return "case distinction"
    if not all(isinstance(step, Step) for part in (proof, *proof.rest) for step in part.steps):
        return "sums of squares"
    exponents = [entry.rest.exponent for entry in proof.rest if isinstance(entry.rest, End)]
    return "radical membership" if max(exponents) > 1 else "ideal membership"


def recorded(case: Case, written: Written) -> dict[str, Any]:
    """Return a case as text in dictionaries and lists, with integer coefficients."""
    found: dict[str, Any] = {} if case.assumed is None else {"assumed": {case.assumed[0]: written(case.assumed[1])}}
    if case.steps:
        found["steps"] = [_step(step, written) for step in case.steps]
    if isinstance(case.rest, End):
        return {**found, "exponent": case.rest.exponent, **_sum(case.rest, written)}
    return {**found, "cases": [recorded(part, written) for part in case.rest]}


def _step(step: Step | Zeros | Positive, written: Written) -> dict[str, Any]:
    if isinstance(step, Step):
        return {step.shows: written(step.polynomial), **_sum(step, written, step.factor)}
    squares = [[str(weight), written(root)] for weight, root in step.squares]
    if isinstance(step, Positive):
        return {"not zero": written(step.polynomial), "squares": squares}
    return {"squares": squares, **_sum(step, written)}


def _sum(part: Step | Zeros | End, written: Written, factor: Any = None) -> dict[str, Any]:
    others = {} if factor is None else {"factor": factor}
    number = denominator_of(part.multiplier, *part.cofactors.values(), *others.values())
    cofactors = {str(place): written(cofactor * number) for place, cofactor in part.cofactors.items()}
    others = {key: written(other * number) for key, other in others.items()}
    return {"multiplier": written(part.multiplier * number), "cofactors": cofactors, **others}
