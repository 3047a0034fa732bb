"""Translations: variables that may be set to zero without loss of generality, and the way back.

If ``sum(d_i * dP/dx_i)`` is the zero polynomial for every polynomial P of a question, none of them changes along d, and
a variable with ``d_i != 0`` may be put to zero.  What is then found holds everywhere, after ``x - (x_i/d_i) d`` for x.
"""

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import flint

from algebroproj_sym.expressions.exact import fraction
from algebroproj_sym.proving.polynomials import null_space

MOST_TERMS = 20_000


@dataclass(frozen=True)
class Frame:
    """Directions along which no polynomial changes, each with a variable of its own in which it is one."""

    context: Any
    """Of the polynomials."""
    directions: Mapping[int, Sequence[Any]]
    """The components, by the place of the variable that is put to zero."""

    def restricted(self, polynomial: Any) -> Any:
        """Return a polynomial with zero for the variables of the directions."""
        return self._composed(polynomial, [0 if i in self.directions else x for i, x in self._numbered()])

    def lifted(self, polynomial: Any) -> Any:
        """Return the polynomial that does not change along the directions, from its restriction."""
        return self._composed(polynomial, [self._moved(i, x) for i, x in self._numbered()])

    def point(self, values: Sequence[Any]) -> list[Any]:
        """Return a zero of polynomials that do not change, from one of their restrictions."""
        moved = list(values)
        for own, direction in self.directions.items():
            for i, component in enumerate(direction):
                if component and i != own:
                    moved[i] = moved[i] + values[own] * fraction(component)
        return moved

    def _numbered(self) -> list[tuple[int, Any]]:
        return list(enumerate(self.context.gens()))

    def _moved(self, place: int, variable: Any) -> Any:
        gens = self.context.gens()
        return variable - sum((direction[place] * gens[own] for own, direction in self.directions.items()), gens[0] * 0)

    def _composed(self, polynomial: Any, values: Sequence[Any]) -> Any:
        if not self.directions or polynomial == 0:
            return polynomial
        zero = self.context.constant(0)
        return polynomial.compose(*(zero + value for value in values))


def frame_of(polynomials: Sequence[Any], context: Any) -> Frame:
    """Return the directions along which no polynomial changes; the variables of their own occur in the most terms.

    Examples
    --------
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y", "z"), flint.Ordering.degrevlex)
    >>> x, y, z = context.gens()
    >>> frame = frame_of([(x - y) ** 2 + z, x - y + 2], context)
    >>> frame.restricted((x - y) ** 2), frame.lifted(x**2)
    (x^2, x^2 - 2*x*y + y^2)
    """
    if sum(map(len, polynomials)) > MOST_TERMS:
        return Frame(context, {})
    uses = Counter(i for p in polynomials for powers in p.to_dict() for i, n in enumerate(powers) if n)
    occurring = sorted(uses, key=lambda place: (uses[place], place))
    rows = _conditions(polynomials, occurring)
    directions = {}
    for own, components in null_space(rows, len(occurring)):
        whole = [flint.fmpq(0)] * len(context.gens())
        for place, component in zip(occurring, components, strict=True):
            whole[place] = component
        directions[occurring[own]] = whole
    return Frame(context, directions)


def does_not_change(terms: Mapping[tuple[int, ...], Fraction], direction: Sequence[Fraction]) -> bool:
    """Whether a polynomial, given by its terms, is the same along a direction.

    Examples
    --------
    >>> does_not_change({(1, 0): Fraction(2), (0, 1): Fraction(-2)}, [Fraction(1), Fraction(1)])
    True
    """
    change: dict[tuple[int, ...], Fraction] = defaultdict(Fraction)
    for powers, value in terms.items():
        for place, component in enumerate(direction):
            if component and powers[place]:
                change[(*powers[:place], powers[place] - 1, *powers[place + 1 :])] += value * component * powers[place]
    return not any(change.values())


def _conditions(polynomials: Sequence[Any], places: Sequence[int]) -> list[list[Any]]:
    """Return the rows of the linear system that directions solve: one for each monomial of each derivative."""
    rows: dict[tuple[int, Any], list[Any]] = {}
    for number, polynomial in enumerate(polynomials):
        for column, place in enumerate(places):
            for powers, value in polynomial.derivative(place).to_dict().items():
                rows.setdefault((number, powers), [flint.fmpq(0)] * len(places))[column] = value
    return list({tuple(map(str, row)): row for row in rows.values()}.values())
