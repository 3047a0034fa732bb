"""Ideal membership with the cofactors kept: f * s^k = sum c_i g_i, found by exact linear algebra.

Variables that occur in no constraint are parameters: f lies in the ideal exactly if each of its coefficients,
as a polynomial in the parameters, does.  For each coefficient the cofactors are sought among the polynomials of
bounded degree (a Macaulay matrix); what is found is multiplied out again before it is believed.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations_with_replacement
from typing import Any, TypeAlias

from sympy import QQ
from sympy.polys.matrices import DomainMatrix

from algebroproj_sym.proving.engines import Ring

Powers: TypeAlias = tuple[int, ...]
Terms: TypeAlias = Mapping[Powers, Fraction]

EXTRA_DEGREE = 2


def cofactors(ring: Ring, polynomial: Any, generators: Sequence[Any]) -> list[Any] | None:
    """Return polynomials c_i with ``polynomial == sum(c_i * generators[i])``, or None if none were found.

    Parameters
    ----------
    ring : Ring
        The ring of all the polynomials.
    polynomial : polynomial
        What may lie in the ideal.
    generators : sequence of polynomial
        The generators of the ideal.

    Returns
    -------
    list of polynomial or None
        None proves nothing: cofactors of higher degree may exist.
    """
    generator_terms = [ring.terms(generator) for generator in generators]
    used = _used_variables(generator_terms)
    found: list[dict[Powers, Fraction]] = [{} for _ in generators]
    for parameters, coefficient in _coefficients(ring.terms(polynomial), used).items():
        parts = _bounded_cofactors(coefficient, generator_terms, used)
        if parts is None:
            return None
        for target, part in zip(found, parts, strict=True):
            target |= {_plus(powers, parameters): value for powers, value in part.items()}
    result = [ring.polynomial(terms) for terms in found]
    rest = polynomial
    for cofactor, generator in zip(result, generators, strict=True):
        rest = rest - cofactor * generator
    return None if ring.terms(rest) else result


def _used_variables(polynomials: Sequence[Terms]) -> tuple[int, ...]:
    return tuple(sorted({i for terms in polynomials for powers in terms for i, n in enumerate(powers) if n}))


def _coefficients(terms: Terms, used: Sequence[int]) -> dict[Powers, dict[Powers, Fraction]]:
    parts: dict[Powers, dict[Powers, Fraction]] = defaultdict(dict)
    for powers, value in terms.items():
        inner = tuple(n if i in used else 0 for i, n in enumerate(powers))
        outer = tuple(0 if i in used else n for i, n in enumerate(powers))
        parts[outer][inner] = value
    return parts


def _bounded_cofactors(
    target: Terms, generators: Sequence[Terms], used: Sequence[int]
) -> list[dict[Powers, Fraction]] | None:
    degree = max(map(sum, target))
    for bound in range(degree, degree + EXTRA_DEGREE + 1):
        parts = _cofactors_of_degree(target, generators, used, bound)
        if parts is not None:
            return parts
    return None


def _cofactors_of_degree(
    target: Terms, generators: Sequence[Terms], used: Sequence[int], bound: int
) -> list[dict[Powers, Fraction]] | None:
    width = len(next(iter(target)))
    unknowns = [
        (index, monomial)
        for index, terms in enumerate(generators)
        for monomial in _monomials(bound - max(map(sum, terms), default=0), used, width)
    ]
    equations: dict[Powers, int] = {}
    entries: dict[int, dict[int, Any]] = defaultdict(dict)
    for column, (index, monomial) in enumerate(unknowns):
        for powers, value in generators[index].items():
            row = equations.setdefault(_plus(powers, monomial), len(equations))
            entries[row][column] = QQ(value.numerator, value.denominator)
    for powers, value in target.items():
        if powers not in equations:
            return None
        entries[equations[powers]][len(unknowns)] = QQ(value.numerator, value.denominator)
    matrix = DomainMatrix(dict(entries), (len(equations), len(unknowns) + 1), QQ)
    reduced, pivots = matrix.rref()
    if len(unknowns) in pivots:
        return None
    parts: list[dict[Powers, Fraction]] = [{} for _ in generators]
    solution = reduced.to_sdm()
    for row, column in enumerate(pivots):
        value = solution.get(row, {}).get(len(unknowns))
        if value:
            index, monomial = unknowns[column]
            parts[index][monomial] = Fraction(int(value.numerator), int(value.denominator))
    return parts


def _monomials(degree: int, used: Sequence[int], width: int) -> Iterator[Powers]:
    for total in range(degree + 1):
        for choice in combinations_with_replacement(used, total):
            yield tuple(choice.count(i) for i in range(width))


def _plus(left: Powers, right: Powers) -> Powers:
    return tuple(a + b for a, b in zip(left, right, strict=True))
