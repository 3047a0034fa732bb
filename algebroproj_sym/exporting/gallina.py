"""Printing terms in Coq's language: as formulas for the reader, and as trees for the lemmas."""

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cache
from importlib.resources import files as resources
from typing import NamedTuple, TypeAlias

from algebroproj_sym.exporting.terms import Term


class Split(NamedTuple):
    """The numerator of a divisor: a rational number times natural powers of the listed divisors."""

    content: Fraction
    exponents: tuple[int, ...]


Splits: TypeAlias = Mapping[Term, Split]

LEMMAS = ("Elimination.v", "Formulas.v", "Linear.v", "Functions.v")
"""The files that every exported file requires; each may require those before it."""

_KEYWORDS = """
Axiom CoFixpoint Definition Fixpoint Hypothesis IF Inductive Lemma Parameter Prop Record SProp Section Set Theorem Type
Variable _ as at by cofix constr do else end exists exists2 fix for forall fun if in lazymatch let ltac match
multimatch return then using where with
"""
_LIBRARY = """
I IZR N0 None Npos O PX Pc Pinj Q Q2R Qmake R Rabs Rinv Rplus S Some Z Z0 Zneg Zpos and app bool concat conj cons
eq_refl eq_sym eq_trans ex_intro false inl inr left length limit1_in list map mod nat nil not or pair proj1 proj2 right
seq true tt xH xI xO
PI Rabs acos asin atan cos cosh exp ln sin sinh sqrt tan tanh
"""

_BOUND = ("at_zero", "held", "rows", "same", "shared", "zero")
"""What proofs call what they have shown."""

_ACCURACY = """
B2R accurate applies argument binary64 bounds certificate determined divisors exact formula lines nonzero numbers splits
"""
"""What theorems about error bounds mention."""

_DEFINED = re.compile(r"^\s*(?:Definition|Fixpoint|Inductive|Lemma|Theorem)\s+(\w+)", re.MULTILINE)
_CONSTRUCTOR = re.compile(r"(?:\||:=)\s+([A-Z]\w*) [(:]")


@cache
def reserved() -> frozenset[str]:
    """Return the names that mean something in an exported file: no variable may be called so."""
    lemmas = [resources("algebroproj_sym.exporting").joinpath(name).read_text("utf-8") for name in LEMMAS]
    defined = {found for text in lemmas for found in (*_DEFINED.findall(text), *_CONSTRUCTOR.findall(text))}
    return frozenset([*_KEYWORDS.split(), *_LIBRARY.split(), *_BOUND, *_ACCURACY.split(), *defined])


FUNCTIONS = {"Rabs": "Abs", "floor": "Floor", "at_most": "Compare"}
"""Functions of numbers, and their trees."""

LONG = 10**15
_SUM, _PRODUCT, _SIGN, _POWER, _ATOM = range(5)


def formula(term: Term, within: int = _SUM) -> str:
    """Return a term as a formula over the real numbers; `within` says how tightly what is around it binds.

    Examples
    --------
    >>> from algebroproj_sym.exporting.terms import difference, name, power, product
    >>> x, y = name("x"), name("y")
    >>> formula(product([difference(x, y), power(x, 2)]))
    '(x - y) * x ^ 2'
    """
    text, binds = _formula(term)
    return text if binds >= within else f"({text})"


def _formula(term: Term) -> tuple[str, int]:
    if term.kind == "int":
        return digits(int(term.value)), _ATOM
    if term.kind == "name":
        return identifier(str(term.value)), _ATOM
    first, *others = term.parts
    if term.kind == "-":
        return f"- ({digits(int(first.value))})" if first.kind == "int" else f"- {formula(first, _SIGN)}", _SIGN
    if term.kind == "^":
        return f"{formula(first, _ATOM)} ^ {term.value}", _POWER
    if term.kind == "/":
        return f"{formula(first, _PRODUCT)} / {formula(others[0], _POWER)}", _PRODUCT
    if term.kind == "*":
        return " * ".join([formula(first, _PRODUCT), *(formula(other, _POWER) for other in others)]), _PRODUCT
    if term.kind in FUNCTIONS:
        return " ".join([term.kind, *(formula(part, _ATOM) for part in term.parts)]), _POWER
    return "".join([formula(first, _SUM), *map(_signed, others)]), _SUM


def _signed(term: Term) -> str:
    if term.kind == "-":
        return f" - {formula(term.parts[0], _PRODUCT)}"
    return f" + {formula(term, _PRODUCT)}"


def identifier(name: str) -> str:
    """Return a name that Coq reads as a variable, and that means nothing else; different names stay different.

    Examples
    --------
    >>> identifier("x"), identifier("R"), identifier("α"), identifier("x_x27_")
    ('x', "R''", '_x3b1_', 'x_x5f_x27_')
    """
    spelled = re.sub(
        r"_(?=x[0-9a-f]+(?:_|[^\x00-\x7f]))|[^A-Za-z0-9_']", lambda found: f"_x{ord(found.group()):x}_", name
    )
    return f"{spelled}''" if spelled in reserved() else spelled


def tree(term: Term, places: Mapping[str, int], splits: Splits) -> str:
    """Return a term as a tree, whose names are places of an environment.

    Examples
    --------
    >>> from algebroproj_sym.exporting.terms import difference, name
    >>> tree(difference(name("x"), name("y")), {"x": 0, "y": 1}, {})
    'Sub (Var 0) (Var 1)'
    """
    if term.kind == "int":
        return f"Int {digits(int(term.value))}"
    if term.kind == "name":
        return f"Var {places[str(term.value)]}"
    if term.kind == "^":
        return f"Pow {_inner(term.parts[0], places, splits)} {term.value}"
    if term.kind == "-":
        return f"Opp {_inner(term.parts[0], places, splits)}"
    if term.kind == "/":
        above, below = (_inner(part, places, splits) for part in term.parts)
        if term not in splits:
            return f"Div {above} {below} 1 []"
        content, exponents = splits[term]
        return f"Div {above} {below} {rational(content)} {exponent_list(exponents)}"
    if term.kind in FUNCTIONS:
        return " ".join([FUNCTIONS[term.kind], *(_inner(part, places, splits) for part in term.parts)])
    text = tree(term.parts[0], places, splits)
    for part in term.parts[1:]:
        operation = "Mul" if term.kind == "*" else "Sub" if part.kind == "-" else "Add"
        operand = part.parts[0] if operation == "Sub" else part
        text = f"{operation} ({text}) {_inner(operand, places, splits)}"
    return text


def _inner(term: Term, places: Mapping[str, int], splits: Splits) -> str:
    return f"({tree(term, places, splits)})"


def rational(value: Fraction) -> str:
    """Return a rational number.

    Examples
    --------
    >>> rational(Fraction(-1, 2))
    '((-1) # 2)'
    """
    above = digits(value.numerator) if value >= 0 else f"(-{digits(-value.numerator)})"
    return f"({above} # {digits(value.denominator)})"


def digits(value: int) -> str:
    """Return a natural number; a long one in hexadecimal digits, which Coq reads in linear time."""
    return str(value) if value < LONG else hex(value)


def listed(items: Sequence[str], separator: str = "; ") -> str:
    """Return a list."""
    return f"[{separator.join(items)}]"


def exponent_list(exponents: Sequence[int]) -> str:
    """Return exponents."""
    return listed([*map(str, exponents)]) + ("%Z" if exponents else "")


def conjoined(proofs: Sequence[str]) -> str:
    """Return the proof of a conjunction that ends with its last part, or of True."""
    if not proofs:
        return "I"
    *others, last = proofs
    return "".join(f"(conj {proof} " for proof in others) + last + ")" * len(others)
