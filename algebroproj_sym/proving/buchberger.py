"""Buchberger's algorithm with a memory: every element of the basis knows how it was made from the generators.

The polynomials are FLINT's, in degree reverse lexicographic order; steps are counted, not timed, so that the result
does not depend on the machine.  What is found here is only a suggestion: whoever uses it multiplies it out again.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from heapq import heapify, heappop, heappush
from operator import le
from typing import Any

from algebroproj_sym.proving.polynomials import EffortExceededError, relation

Powers = tuple[int, ...]

MAX_STEPS = 20_000
MAX_LENGTH = 3_000
MAX_BASIS = 400
MOST_WORK = 12_000_000


class Work:
    """How much all bases of a question may cost together, in terms of the polynomials that are reduced.

    Examples
    --------
    >>> work = Work(5)
    >>> work.spend(5)
    >>> work.spend(1)
    Traceback (most recent call last):
    ...
    algebroproj_sym.proving.polynomials.EffortExceededError
    """

    def __init__(self, terms: int = MOST_WORK) -> None:
        self.left = terms

    def spend(self, terms: int) -> None:
        """Count what was done; raise `EffortExceededError` if it is too much."""
        self.left -= terms
        if self.left < 0:
            raise EffortExceededError


class GroebnerBasis:
    """A Groebner basis of some polynomials, with the combinations of the generators that its elements are.

    The generators are in a context with degree reverse lexicographic order.  All bases of a question share some `work`.
    It raises `EffortExceededError` if there is no end within so many reductions, or that work.

    Examples
    --------
    >>> import flint
    >>> context = flint.fmpq_mpoly_ctx.get(("x", "y"), flint.Ordering.degrevlex)
    >>> x, y = context.gens()
    >>> basis = GroebnerBasis([x**2 - y, x * y - 1])
    >>> basis.cofactors(y**2 - x)
    [-y, x]
    >>> basis.cofactors(x) is None
    True
    """

    def __init__(self, generators: Sequence[Any], steps: int = MAX_STEPS, work: Work | None = None) -> None:
        self._work = work or Work()
        self._generators = list(generators)
        self._context = self._generators[0].context()
        self._steps = steps
        self._elements: list[Any] = []
        self._leading: list[Powers] = []
        self._recipes: list[dict[int, Any]] = []
        self._known: dict[int, list[Any]] = {}
        self._pairs: list[tuple[int, Powers, int, int]] = []
        self._live: dict[tuple[int, int], Powers] = {}
        count = len(self._generators)
        for place in sorted(range(count), key=lambda i: (_degree(self._generators[i]), len(self._generators[i]))):
            rest, recipe = self._reduced(self._generators[place], {-1 - place: self._context.constant(1)})
            self._enter(rest, recipe)
        while self._pairs and not self.is_unit:
            self._next_pair()

    @property
    def context(self) -> Any:
        """The ring of the generators."""
        return self._context

    @property
    def is_unit(self) -> bool:
        """Whether the ideal is the whole ring."""
        return any(not any(powers) for powers in self._leading)

    def remainder(self, polynomial: Any) -> Any:
        """Return what is left of a polynomial after division by the basis: zero if it lies in the ideal."""
        return self._reduced(polynomial, {})[0]

    def normal_form(self, polynomial: Any) -> Any:
        """Return the polynomial without a monomial that is leading in the ideal, equal modulo the ideal."""
        total = self._context.constant(0)
        while (polynomial := self.remainder(polynomial)) != 0:
            leading = self._monomial(tuple(map(int, polynomial.monomial(0)))) * polynomial.leading_coefficient()
            total, polynomial = total + leading, polynomial - leading
        return total

    def powers(self, polynomial: Any, most: int) -> Iterator[Any]:
        """Yield the powers of a polynomial modulo the ideal, the highest last."""
        power = self._context.constant(1)
        for k in range(most + 1):
            yield power
            if k < most:
                power = self.normal_form(power * polynomial)

    def relation(self, polynomials: Iterable[Any]) -> list[Any] | None:
        """Return numbers, not all zero, with which polynomials add up to an element of the ideal: the first that exist.

        Examples
        --------
        >>> import flint
        >>> context = flint.fmpq_mpoly_ctx.get(("x",), flint.Ordering.degrevlex)
        >>> (x,) = context.gens()
        >>> GroebnerBasis([x**2 - 2]).relation([x**0, x, x**2, x**3])
        [-2, 0, 1]
        """
        forms = list[Any]()
        for polynomial in polynomials:
            forms.append(self.normal_form(polynomial))
            if (found := relation(forms)) is not None:
                return found
        return None

    def free(self) -> set[int]:
        """Return a maximal set of variables that occur and of which no power product is a leading monomial."""
        return self.independent() & {*self.occurring()}

    def occurring(self) -> list[int]:
        """Return the places of the variables that occur in the generators."""
        degrees = [polynomial.degrees() for polynomial in self._generators if polynomial != 0]
        return [place for place, column in enumerate(zip(*degrees, strict=True)) if any(column)]

    def cofactors(self, polynomial: Any) -> list[Any] | None:
        """Return the cofactors of a polynomial with respect to the generators, None if it is not in the ideal."""
        if len(self._generators) == 1:
            quotient, rest = divmod(polynomial, self._generators[0])
            return None if rest != 0 else [quotient]
        rest, recipe = self._reduced(polynomial, {})
        if rest != 0:
            return None
        return [-part for part in self._expanded(recipe)]

    def independent(self) -> set[int]:
        """Return a maximal set of variables of which no power product is a leading monomial: the free ones."""
        free: set[int] = set()
        for variable in range(len(self._context.names())):
            candidate = free | {variable}
            if not any(all(i in candidate for i, n in enumerate(powers) if n) for powers in self._leading):
                free = candidate
        return free

    def _next_pair(self) -> None:
        _, _, i, j = heappop(self._pairs)
        common = self._live.pop((i, j), None)
        if common is None:
            return
        left, right = self._monomial(_minus(common, self._leading[i])), self._monomial(_minus(common, self._leading[j]))
        rest, recipe = self._reduced(
            left * self._elements[i] - right * self._elements[j], {i: left, j: -right} if i != j else {}
        )
        self._enter(rest, recipe)

    def _reduced(self, polynomial: Any, recipe: Mapping[int, Any]) -> tuple[Any, dict[int, Any]]:
        parts: dict[int, dict[Powers, Any]] = {}
        while polynomial != 0:
            powers = tuple(map(int, polynomial.monomial(0)))
            place = self._divisor(powers)
            if place is None:
                break
            self._steps -= 1
            if self._steps < 0 or len(polynomial) > MAX_LENGTH:
                raise EffortExceededError
            self._work.spend(len(polynomial) + len(self._elements[place]))
            factor = polynomial.leading_coefficient()
            monomial = _minus(powers, self._leading[place])
            polynomial = polynomial - self._context.from_dict({monomial: factor}) * self._elements[place]
            parts.setdefault(place, {})[monomial] = -factor
        result = dict(recipe)
        for place, terms in parts.items():
            part = self._context.from_dict(terms)
            result[place] = result[place] + part if place in result else part
        return polynomial, result

    def _divisor(self, powers: Powers) -> int | None:
        """Return the first element whose leading monomial divides a monomial."""
        return next((i for i, lead in enumerate(self._leading) if _divides(lead, powers)), None)

    def _enter(self, polynomial: Any, recipe: dict[int, Any]) -> None:
        if polynomial == 0:
            return
        unit = 1 / polynomial.leading_coefficient()
        place = len(self._elements)
        if place >= MAX_BASIS:
            raise EffortExceededError
        self._elements.append(polynomial * unit)
        self._leading.append(tuple(map(int, polynomial.monomial(0))))
        self._recipes.append({index: part * unit for index, part in recipe.items()})
        self._update(place)

    def _update(self, new: int) -> None:
        lead = self._leading
        fresh = lead[new]
        for pair, common in list(self._live.items()):
            if _divides(fresh, common) and _lcm(lead[pair[0]], fresh) != common != _lcm(lead[pair[1]], fresh):
                del self._live[pair]
        candidates = {i: _lcm(lead[i], fresh) for i in range(new)}
        kept: list[int] = []
        for i, common in sorted(candidates.items(), key=lambda item: (sum(item[1]), not self._coprime(item[0], new))):
            if not any(_divides(candidates[other], common) for other in kept):
                kept.append(i)
        for i in kept:
            if not self._coprime(i, new):
                self._live[i, new] = candidates[i]
                heappush(self._pairs, (sum(candidates[i]), candidates[i], i, new))
        self._pairs = [entry for entry in self._pairs if (entry[2], entry[3]) in self._live]
        heapify(self._pairs)

    def _coprime(self, i: int, j: int) -> bool:
        return not any(a and b for a, b in zip(self._leading[i], self._leading[j], strict=True))

    def _monomial(self, powers: Powers) -> Any:
        return self._context.from_dict({powers: 1})

    def _expanded(self, recipe: Mapping[int, Any]) -> list[Any]:
        """Return a combination of basis elements as a combination of the generators."""
        needed = dict(recipe)
        result = [self._context.constant(0) for _ in self._generators]
        while needed:
            place = max(needed)
            part = needed.pop(place)
            if part == 0:
                continue
            if place < 0:
                result[-1 - place] = part
                continue
            for index, factor in self._recipes[place].items():
                needed[index] = needed[index] + part * factor if index in needed else part * factor
        return result


def _degree(polynomial: Any) -> int:
    return int(polynomial.total_degree()) if polynomial != 0 else 0


def _divides(left: Powers, right: Powers) -> bool:
    """Whether one monomial divides another."""
    return all(map(le, left, right))


def _minus(left: Powers, right: Powers) -> Powers:
    return tuple(a - b for a, b in zip(left, right, strict=True))


def _lcm(left: Powers, right: Powers) -> Powers:
    return tuple(map(max, left, right))
