"""Integrals between bounds of powers, exponentials, waves and ``1/(a x + b)``, and of products with powers."""

from typing import Any

import sympy

from algebroproj_sym.expressions import diff, most_terms, over, text
from algebroproj_sym.reading.lexing.pieces import UnreadableError

INFINITE: dict[str, Any] = {r"\infty": sympy.oo, r"+\infty": sympy.oo, r"-\infty": -sympy.oo}
MOST_TERMS = 50
"""Of how many terms an integral is computed."""
MOST_PARTS = 8
"""The highest power beside an exponential or a wave."""
_WAVES: dict[Any, Any] = {
    sympy.exp: sympy.exp,
    sympy.sin: lambda inside: -sympy.cos(inside),
    sympy.cos: sympy.sin,
    over: sympy.log,
}
_REFUSED = "an integral in it is read, but not computed"


def integral_of(value: Any, variable: Any, step: Any, low: Any, high: Any) -> tuple[Any, tuple[str, ...]]:
    """Return the integral of what stands beside a differential, and what is taken to hold for it.

    `step` is the letter of the differential, by which `value` has it; bounds may be infinite.  It raises
    `UnreadableError` if one of its terms has no rule here.

    Examples
    --------
    >>> x, dx, k = sympy.symbols("x dx k")
    >>> integral_of(k * x * dx, x, dx, sympy.S.Zero, k)
    (k**3/2, ())
    >>> integral_of(sympy.exp(-k * x) * dx, x, dx, sympy.S.Zero, sympy.oo)
    (-over(1, -k), ('-k negative',))
    """
    plain = value.replace(over, lambda above, below: above * over(1, below))
    if most_terms(plain) > MOST_TERMS:
        raise UnreadableError(_REFUSED)
    density = sympy.expand(diff(plain, step), power_base=False, power_exp=False, log=False)
    if density.has(step) or sympy.expand(plain.xreplace({step: sympy.S.Zero})) != 0:
        raise UnreadableError(_REFUSED)
    found, notes = sympy.S.Zero, dict[str, None]()
    for term in sympy.Add.make_args(density):
        factor, power, wave = _parts(term, variable)
        notes |= dict.fromkeys(_required(variable, power, wave, low, high))
        for end, sign in ((high, 1), (low, -1)):
            at_end, needed = _at(factor, power, wave, variable, end)
            found += sign * at_end
            notes |= dict.fromkeys(needed)
    return found, tuple(notes)


def _parts(term: Any, variable: Any) -> tuple[Any, int, Any]:
    """Return the factor of a term that does not change, the power of the letter, and an exponential or a wave."""
    factor, varying = term.as_independent(variable, as_Add=False)
    power, wave = 0, None
    for each in sympy.Mul.make_args(varying):
        base, exponent = each.as_base_exp()
        if base == variable and exponent.is_Integer:
            power += int(exponent)
        elif wave is None and base == sympy.log(variable) and exponent.is_Integer and exponent > 0:
            wave = each
        elif isinstance(each, over):
            fixed, below = each.args[1].as_independent(variable, as_Add=False)
            base, exponent = below.as_base_exp()
            if base == variable and exponent.is_Integer:
                factor, power = factor * over(1, fixed), power - int(exponent)
            elif wave is None and not diff(each.args[1], variable).has(variable):
                wave = over(1, each.args[1])
            else:
                raise UnreadableError(_REFUSED)
        elif wave is None and type(each) in _WAVES and not _rate(each, variable).has(variable):
            wave = each
        elif each != 1:
            raise UnreadableError(_REFUSED)
    is_logarithm = wave is not None and wave.as_base_exp()[0] == sympy.log(variable)
    fits = power == -1 if is_logarithm else wave is None or (power >= 0 and not (power and isinstance(wave, over)))
    if power > MOST_PARTS or not fits:
        raise UnreadableError(_REFUSED)
    return factor, power, wave


def _rate(wave: Any, variable: Any) -> Any:
    return diff(wave.args[-1], variable)


def _required(variable: Any, power: int, wave: Any, low: Any, high: Any) -> list[str]:
    """Return what is positive, if something below a line must be; refuse bounds between which it may be zero."""
    below = wave.args[1] if isinstance(wave, over) else variable
    if power >= 0 and below is variable:
        return []
    ends = [each for each in (below.xreplace({variable: end}) for end in (low, high)) if each.is_number]
    if any(each.is_extended_positive is not True for each in ends):
        raise UnreadableError(_REFUSED)
    return [] if len(ends) == 2 else [f"{text(below)} positive"]


def _at(factor: Any, power: int, wave: Any, variable: Any, end: Any) -> tuple[Any, list[str]]:
    """Return a primitive at a bound, and what is taken to hold there."""
    if end.is_infinite:
        return _at_infinity(factor, power, wave, variable, end)
    if wave is not None and power == -1:
        primitive = wave * sympy.log(variable) * sympy.Rational(1, int(wave.as_base_exp()[1]) + 1)
    else:
        primitive = _of_power(power, variable) if wave is None else _of_wave(power, wave, variable)
    return factor * primitive.xreplace({variable: end}), []


def _of_power(power: int, variable: Any) -> Any:
    if power == -1:
        return sympy.log(variable)
    raised = variable ** (power + 1) if power >= 0 else over(1, variable ** -(power + 1))
    return raised * sympy.Rational(1, power + 1)


def _of_wave(power: int, wave: Any, variable: Any) -> Any:
    """Return a primitive of a power times a wave, by parts."""
    inner = over(1, _rate(wave, variable)) * _WAVES[type(wave)](wave.args[-1])
    if power == 0:
        return inner
    factor, other = inner.as_independent(variable, as_Add=False)
    return variable**power * inner - power * factor * _of_wave_or_sign(power - 1, other, variable)


def _of_wave_or_sign(power: int, wave: Any, variable: Any) -> Any:
    sign, bare = wave.as_coeff_Mul()
    return sign * _of_wave(power, bare, variable)


def _at_infinity(factor: Any, power: int, wave: Any, variable: Any, end: Any) -> tuple[Any, list[str]]:
    """Return zero where a primitive vanishes far away, and the sign of a rate that is taken for that."""
    if wave is None or power < 0:
        if wave is not None or power >= -1:
            raise UnreadableError(_REFUSED)
        return sympy.S.Zero, []
    rate = _rate(wave, variable)
    falls = not isinstance(wave, sympy.exp) or rate.as_coeff_Mul()[0].is_positive == (end is sympy.oo)
    if falls or not all(map(_has_one_sign, sympy.Mul.make_args(rate))):
        raise UnreadableError(_REFUSED)
    return sympy.S.Zero, [] if rate.is_number else [f"{text(rate)} {'negative' if end is sympy.oo else 'positive'}"]


def _has_one_sign(factor: Any) -> bool:
    return factor.is_Symbol or factor.is_number or (isinstance(factor, over) and factor.args[1].is_Symbol)
