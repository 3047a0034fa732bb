r"""Numbers that a document names and does not compute: sums, integrals, values of functions.

Each is a letter of its own, the same for the same text.  A sum is taken term by term, and what does not depend on its
index stands before it: ``\sum_{i=1}^{n} (a x_i + b)`` is a times a letter, plus n times b.  With printed limits it is
the same for every index.
"""

import re
from collections.abc import Collection, Sequence
from typing import Any

import sympy

from algebroproj_sym.expressions import entries, most_terms, over, shape, text
from algebroproj_sym.reading.defining.dependence import (
    ANY,
    COUNTED,
    index_of,
    is_number,
    letters_in,
    letters_of_symbol,
    require_no_value,
)
from algebroproj_sym.reading.defining.factorials import binomial, factorial, inverse_factorial, sum_of_binomials
from algebroproj_sym.reading.defining.parts import MOST_TERMS
from algebroproj_sym.reading.defining.sizing import FREE, WHOLE, base_of
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.evaluating import slope_of

MOST_EXPANDED = 500
"""How many terms a sum may have before like ones are put together."""


class Uncomputed:
    """The values that have letters of their own, whose names begin with ``free`` or ``whole``."""

    def __init__(self, vocabulary: Vocabulary, functions: Collection[str] = (), *, apart: bool = False) -> None:
        self._vocabulary = vocabulary
        self._functions = functions
        self._apart = apart
        self._angles = set[Any]()
        self._roots: dict[Any, tuple[Any, Any]] = {}
        self._inverses: dict[Any, Any] = {}
        self._letters: dict[str, frozenset[str]] = {}
        self._keys: dict[str, str] = {}
        self._first: dict[str, str] = {}
        self._sums: dict[str, tuple[str, Any]] = {}
        self._products: dict[str, tuple[str, Any]] = {}

    def slope(self, value: Any, variable: Any) -> Any:
        """Return a derivative: that of a sum is the sum of the derivatives of its terms."""
        slopes: dict[Any, Any] = {}
        for symbol in {symbol for entry in entries(value) for symbol in entry.free_symbols}:
            if symbol.name in self._sums:
                name, body = self._sums[symbol.name]
                self._require_apart(name, body, variable)
                slopes[symbol] = self.big(name, self.slope(body, variable))
            elif symbol.name in self._letters:
                raise UnreadableError("the derivative of an integral or a function in it is not computed")
        found = slope_of(value, variable)
        for symbol, slope in slopes.items():
            found += slope_of(value, symbol) * slope
        return found

    def _require_apart(self, name: str, body: Any, variable: Any) -> None:
        """Refuse the derivative of a sum by a letter that changes with its index, or is one of many of its name."""
        letter, _, below, above = split_symbol(self._vocabulary.symbol_of(variable.name))
        scripts = letters_in(f"{below} {above}")
        others = [self._vocabulary.symbol_of(each) for each in _names(body) - {variable.name}]
        for other in others:
            like, _, *theirs = split_symbol(other)
            alike = letter in letters_of_symbol(other) and not (like == letter and "".join(theirs).isdigit())
            if ANY in letters_of_symbol(other) or alike:
                raise UnreadableError(f"{self._vocabulary.name(other)} in a sum may depend on {variable.name}")
        if scripts or {letter, *_names(variable)} & (
            letters_in(name) | self._vocabulary.dependence.related(index_of(name))
        ):
            raise UnreadableError(f"{variable.name} may depend on the index of a sum")

    def call(self, name: str, arguments: Sequence[Any]) -> Any:
        """Return the value of a function that nothing defines; an expected value is taken term by term."""
        if name in self._vocabulary.kinds.averages.operators and len(arguments) == 1:
            return self._average(name, arguments[0])
        if self._vocabulary.is_matrix(name):
            raise UnreadableError(f"the function {name} is not defined")
        if name == r"\Gamma" and self._vocabulary.gamma and len(arguments) == 1 and not shape(arguments[0]):
            return factorial(arguments[0] - 1, self._inverse)
        key = f"{name}({', '.join(map(text, arguments))})"
        is_free = name not in self._vocabulary.definitions and self._first.setdefault(base_of(name), key) == key
        return self._value(name, arguments, FREE if is_free else WHOLE, self._vocabulary.name(name))

    def known(self, name: str, arguments: Sequence[Any]) -> Any:
        """Return the value of a function that is known, and not computed, or of a wave that is taken apart."""
        if name in ("sin", "cos") and self.takes(name) and not any(map(shape, arguments)):
            (angle,) = arguments
            if angle.is_number and (value := getattr(sympy, name)(angle)).is_rational:
                return value
            if angle.could_extract_minus_sign():
                return self.known(name, [-angle]) * (1 if name == "cos" else -1)
            self._angles.add(angle)
            if self._apart and angle.is_Add:
                first, rest = angle.as_two_terms()
                sines, cosines = ([self.known(wave, [each]) for each in (first, rest)] for wave in ("sin", "cos"))
                if name == "cos":
                    return cosines[0] * cosines[1] - sines[0] * sines[1]
                return sines[0] * cosines[1] + cosines[0] * sines[1]
        if name == "exp" and self.takes(name) and not any(map(shape, arguments)):
            return self._exponential(arguments[0])
        if name == "factorial" and not shape(arguments[0]):
            return factorial(arguments[0], self._inverse)
        if name == "binom" and not any(map(shape, arguments)):
            above, below = arguments
            found = binomial(above, below, self._inverse)
            if found is not None:
                return found
        found = self._value(name, arguments, WHOLE)
        if name == "root":
            self._roots[found] = arguments[0], arguments[1]
        return found

    def _exponential(self, value: Any) -> Any:
        """Return the product of a letter for each term of an exponent: ``e^{2a + b}`` is one squared times another."""
        powers: list[Any] = []
        for term in filter(None, sympy.Add.make_args(sympy.expand(value.replace(over, _divided)))):
            number, rest = term.as_coeff_Mul()
            count = abs(number) if number.is_Integer and rest != 1 else sympy.S.One
            powers.append(self._value("exp", [term / count], WHOLE) ** count)
        return sympy.Mul(*powers)

    def _inverse(self, value: Any) -> Any:
        """Return the letter of an inverse factorial."""
        found = self._letter(f"1/factorial({text(value)})", WHOLE, self._on(value))
        self._inverses[found] = value
        return found

    def operated(self, kind: str, values: Sequence[Any]) -> Any:
        """Refuse what an operator makes."""
        raise UnreadableError(f"{kind} is an operator, so it is not computed")

    @property
    def has_angles_of_sums(self) -> bool:
        """Whether an angle of a wave is a sum with the angle of another one."""
        return any(part in self._angles or -part in self._angles for each in self._angles for part in each.args)

    def takes(self, name: str) -> bool:
        """Whether each value of a function that is computed elsewhere is a letter here."""
        return name in self._functions

    def ties(self) -> list[str]:
        """Return what holds of the sine and the cosine of one angle, and of roots, if they are letters."""
        calls = {key: name for name, key in self._keys.items()}
        pairs = [(name, calls.get(f"cos{key[3:]}")) for key, name in calls.items() if key.startswith("sin(")]
        roots = [f"{root}^{degree} = {text(inside)}" for root, (inside, degree) in self._roots.items()]
        inverses = [(name, calls.get(f"exp(-{key[4:]}")) for key, name in calls.items() if key.startswith("exp(")]
        return [
            *(f"{sine}^2 + {cosine}^2 = 1" for sine, cosine in pairs if cosine),
            *(f"{one}*{other} = 1" for one, other in inverses if other),
            *roots,
        ]

    def _value(self, name: str, arguments: Sequence[Any], kind: str, called: str = "") -> Any:
        listed = ", ".join(map(text, arguments))
        shown = f"sqrt({text(arguments[0])})" if name == "root" and arguments[1] == 2 else f"{called or name}({listed})"
        letters = self._on(*arguments) | letters_in(name) | letters_of_symbol(name)
        return self._letter(f"{name}({listed})", kind, letters, shown)

    def _average(self, name: str, value: Any) -> Any:
        """Return the expected value of a number."""
        terms = _terms(value)
        return sympy.Add(*(self._of_term(name, each) for each in terms)) if terms else self.known(name, [value])

    def _of_term(self, name: str, term: Any) -> Any:
        """Return the expected value of a product: what does not change stands before it; that of a sum is a sum."""
        random = [each for each in term.free_symbols if not self._is_fixed(name, each.name)]
        outside, inside = term.as_independent(*random, as_Add=False) if random else (term, sympy.S.One)
        if inside == 1:
            return outside
        big, body = self._sums.get(str(inside), ("", None))
        if big and self._vocabulary.kinds.averages.counts(big):
            return outside * self.big(big, self._average(name, body))
        return outside * self.known(name, [inside])

    def _is_fixed(self, operator: str, name: str) -> bool:
        """Whether a letter, or a value, is the same whatever is random."""
        if name in self._sums:
            big, body = self._sums[name]
            return self._vocabulary.kinds.averages.counts(big) and all(
                self._is_fixed(operator, each) for each in _names(body)
            )
        if name in self._keys:
            return self._keys[name].startswith(f"{operator}(")
        vocabulary = self._vocabulary
        symbol = vocabulary.symbol_of(name)
        averages, constants = vocabulary.kinds.averages, vocabulary.dependence.constant
        return averages.is_fixed(operator, [symbol], ()) or averages.is_fixed(
            operator, vocabulary.behind(symbol), constants
        )

    def big(self, name: str, body: Any) -> Any:
        """Return a sum, a product, an integral or a limit."""
        if shape(body):
            raise UnreadableError(f"{name} is read, but not computed")
        require_no_value(name, map(self._vocabulary.symbol_of, _names(body)), self._vocabulary.definitions)
        if name.startswith(r"\prod"):
            return sympy.Mul(*(self._multiplied(name, each) for each in _factors(body)))
        index = index_of(name)
        terms = _terms(body) if index or _LINEAR.match(name) else []
        if not terms:
            return self._whole(name, body.replace(over, _divided))
        return sympy.Add(*(self._summed(name, index, term) if index else self._scaled(name, term) for term in terms))

    def _scaled(self, name: str, term: Any) -> Any:
        """Return the integral, or the derivative, of a product: a number stands before it."""
        number, rest = term.as_coeff_Mul()
        return number * self._whole(name, rest) if number else sympy.S.Zero

    def _multiplied(self, name: str, factor: Any) -> Any:
        """Return a product of powers, of quotients or of exponentials as such of products, or of sums."""
        if isinstance(factor, over):
            return over(1, self.big(name, factor.args[1]))
        if factor.is_Pow and factor.exp.is_Rational:
            return self.big(name, factor.base) ** factor.exp
        if isinstance(factor, sympy.exp):
            return sympy.exp(self.big(_as_sum(name), factor.args[0]))
        index, number = index_of(_as_sum(name)), self.big(_as_sum(name), sympy.S.One)
        varying = self._vocabulary.dependence.related(index) | {index, ANY}
        if index and str(number) not in self._sums and not self._dependent(factor, varying):
            return factor**number
        found = self._whole(name, factor)
        self._products[found.name] = name, factor
        return found

    def logarithm(self, value: Any) -> Any:
        """Return the logarithm of a number, factor by factor if one is an exponential or a product over an index."""
        parts = _factors(value)
        bases = [each.args[1] if isinstance(each, over) else each.base if each.is_Pow else each for each in parts]
        has_parts = any(isinstance(each, sympy.exp) or str(each) in self._products for each in bases)
        is_complex = bool(self._vocabulary.complexes or self._vocabulary.imaginary)
        return self._taken_apart(value) if has_parts and not is_complex else sympy.log(value)

    def _taken_apart(self, value: Any) -> Any:
        """Return a logarithm factor by factor: where it is real, it is that of the sizes of all factors."""
        return sympy.Add(*map(self._of_factor, _factors(value)))

    def _of_factor(self, factor: Any) -> Any:
        if isinstance(factor, over):
            return -self._taken_apart(factor.args[1])
        if isinstance(factor, sympy.exp):
            return factor.args[0]
        if factor.is_Pow:
            return factor.exp * self._taken_apart(factor.base)
        name, body = self._products.get(str(factor), ("", None))
        return self.big(_as_sum(name), self._taken_apart(body)) if name else sympy.log(factor)

    def _summed(self, name: str, index: str, term: Any) -> Any:
        """Return the sum of a product: what does not depend on the index stands before it."""
        counted = COUNTED.fullmatch(name)
        varying = self._vocabulary.dependence.related(index, counted[2] if counted else "") | {index, ANY}
        dependent = self._dependent(term, varying)
        outside, inside = term.as_independent(*dependent, as_Add=False) if dependent else (term, sympy.S.One)
        if counted and counted[1] == "0" and not counted[3]:
            first, last = (self._vocabulary.plain(each) for each in (index, counted[2]))
            found = sum_of_binomials(inside, first, last, self._inverses, lambda one: not self._dependent(one, varying))
            if found is not None:
                return outside * found * inverse_factorial(last, self._inverse)
        if inside == 1 and counted and is_number(counted[2], varying, self._vocabulary.definitions):
            more = (counted[1] == "0") - bool(counted[3])
            return outside * (self._vocabulary.plain(counted[2]) + more)
        return outside * (self._exchanged(name, index, inside) or self._whole(name, inside))

    def _exchanged(self, name: str, index: str, inside: Any) -> Any:
        """Return a sum of a sum in the other order, if its name is the first of both in the alphabet; None if not."""
        sums = [each for each in inside.free_symbols if each.name in self._sums]
        inner, body = self._sums[sums[0].name] if len(sums) == 1 else ("", None)
        within = index_of(inner)
        rest, power = inside.as_independent(*sums, as_Add=False) if sums else (inside, None)
        apart = index not in letters_in(inner) and within not in letters_in(name) | self._on(rest)
        if not inner or power != sums[0] or inner >= name or not apart:
            return None
        return self.big(inner, self.big(name, rest * body))

    def _dependent(self, value: Any, varying: frozenset[str]) -> list[Any]:
        return [symbol for symbol in value.free_symbols if not varying.isdisjoint(self._on(symbol))]

    def _whole(self, name: str, body: Any) -> Any:
        letters = (self._on(body) | letters_in(name)) - {index_of(name)}
        shown = f"[{name}]({text(body)})"
        found = self._letter(self._renamed(name, body) or f"{name} {text(body)}", WHOLE, letters, shown)
        if index_of(name):
            self._sums[found.name] = name, body
        return found

    def _renamed(self, name: str, body: Any) -> str:
        """Return the text of a sum with printed limits, the same for every index; empty if all of it is not seen."""
        index = index_of(name)
        names: dict[Any, Any] = {}
        limits = re.fullmatch(r"\\sum_\{[a-z]=(.*)\}\^(.*)", name)
        if limits is None or index in letters_in(limits[1]) | letters_in(limits[2]):
            return ""
        for symbol in body.free_symbols:
            written = self._vocabulary.symbol_of(symbol.name)
            letter, primes, *scripts = split_symbol(written) if " " not in written else ("", 0)
            bound = ["•" if letter == index else letter, *(_without(index, each) for each in scripts)]
            if bound != [letter, *scripts] and symbol.name not in self._letters:
                names[symbol] = sympy.Symbol("_".join(map(str, (*bound, primes))).encode("unicode_escape").hex())
            elif {index, ANY, *self._vocabulary.dependence.related(index)} & self._on(symbol):
                return ""
        return f"\\sum_{{•={limits[1]}}}^{limits[2]} {text(body.xreplace(names))}"

    def _letter(self, key: str, kind: str, letters: frozenset[str], shown: str = "") -> Any:
        name = self._vocabulary.name(f"{kind} {key}")
        self._vocabulary.names.show(name, shown or key)
        self._letters[name], self._keys[name] = letters, key
        return sympy.Symbol(name)

    def _on(self, *values: Any) -> frozenset[str]:
        """Return the symbols of the document on which values depend, and the letters of these."""
        found: set[str] = set()
        for name in _names(*values):
            symbols = self._vocabulary.behind(self._vocabulary.symbol_of(name))
            found |= self._letters.get(name) or symbols.union(*map(letters_of_symbol, symbols))
        return frozenset(found)


def _terms(value: Any) -> list[Any]:
    """Return the terms of a number, each a product; none if they are too many."""
    value = value.replace(over, _divided)
    if most_terms(value) > MOST_EXPANDED:
        return []
    terms = sympy.Add.make_args(sympy.expand(value, power_base=False, power_exp=False, log=False))
    return [] if len(terms) > MOST_TERMS else [*terms]


_LINEAR = re.compile(r"\\sum|\\i*o?int|d/d|\\partial/")
"""What is taken term by term: sums over whatever it may be, integrals and derivatives."""


def _as_sum(name: str) -> str:
    """Return the name of the sum over the index of a product."""
    return name.replace(r"\prod", r"\sum", 1)


def _factors(value: Any) -> list[Any]:
    """Return the factors of a number."""
    return [*sympy.Mul.make_args(value.replace(over, _divided))]


def _divided(above: Any, below: Any) -> Any:
    return above * over(1, below)


def _without(index: str, script: str) -> str:
    """Return a script with a mark for an index."""
    return re.sub(rf"(?<![a-zA-Z\\]){index}(?![a-zA-Z])", "•", script) if "\\" in script else script.replace(index, "•")


def _names(*values: Any) -> set[str]:
    return {symbol.name for value in values for symbol in value.free_symbols}


def with_values(vocabulary: Vocabulary, functions: Collection[str] = (), *, apart: bool = False) -> Vocabulary:
    """Return a vocabulary in which values that are not computed are letters, and those of some functions.

    The sine and the cosine of a sum of angles may be taken apart.
    """
    found = vocabulary.copied()
    found.uncomputed = Uncomputed(found, functions, apart=apart)
    found.forget()
    return found


def values_in(written: str) -> set[str]:
    """Return the kinds of values in the text of an expression: those that may be any number are ``"free"``.

    Examples
    --------
    >>> sorted(values_in("free_f_x + 2*whole_sum_i_x_i"))
    ['free', 'whole']
    """
    return {*re.findall(rf"\b({FREE}|{WHOLE})_", written), *re.findall(r"\b([a-z]+)\d+_(?!\w)", written)}
