"""A kind of claims: how it is declared, compared and shown.  Each is a module of the folder ``kinds``."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal, Protocol, TypedDict, get_args

import sympy

from algebroproj_sym.declaring.claim import Claim, Grade, Verdict
from algebroproj_sym.declaring.transcription import transcribed
from algebroproj_sym.expressions import Rounding
from algebroproj_sym.proving import Proof

Field = Literal[
    "constraints", "nonzero", "assumptions", "relation", "letters", "variable", "variables", "kernel", "rounding",
    "assumed",
]  # fmt: skip
FIELDS: tuple[Field, ...] = get_args(Field)
"""What only some kinds of claims use."""


class _Quoted:
    def __repr__(self) -> str:
        return "what the quote says"


QUOTED: Any = _Quoted()
"""In place of a printed form: it is read from the quote of the claim."""


class Options(TypedDict, total=False):
    """What a claim may declare beside its number, title, printed and derived form."""

    corrected: Any
    expect: Verdict
    where: Mapping[sympy.Symbol, Any]
    constraints: Sequence[sympy.Expr]
    nonzero: Sequence[sympy.Expr]
    assumptions: Sequence[Any]
    relation: str
    properties: Mapping[Any, Any]
    letters: Mapping[str, str]
    witness: Mapping[sympy.Symbol, Fraction | int] | Mapping[str, Fraction | int | str]
    variable: sympy.Symbol
    variables: Sequence[sympy.Symbol]
    kernel: Sequence[Any]
    rounding: Rounding
    instead: str
    note: str
    follows: str
    same_as: str
    grade: Grade


class Declaring(Protocol):
    """A section, as a kind sees it."""

    paper: str

    def declare(self, kind: Kind, number: str, title: str, printed: Any, derived: Any, **options: Any) -> Claim:
        """Declare a claim, for the caller of the caller."""


@dataclass(frozen=True)
class Kind:
    r"""A kind of claims."""

    name: str
    """As the ledger has it."""
    declare: Callable[..., Claim]
    """It declares a claim of the kind in a section, of which it becomes a method."""
    compare: Callable[[Claim, Any, str], Proof]
    """It takes a claim, its printed or corrected form in the terms of the derived one, and an engine, and returns a
    `Proof`.  Every decision in it is made by `prove`."""
    says: str | Callable[[Claim], str]
    """A sentence: how the printed form is compared with the derived one."""
    transcribe: Callable[..., Any] = transcribed
    """It takes the folder of the quotes, section and number of a claim, what is derived, and what makes expressions,
    and returns the printed form that the quote has."""
    takes: tuple[Field, ...] = ()
    """Which fields of a claim it uses, of those that not every kind uses."""
    of_entries: bool = False
    """Whether letters in its forms are written out, because it is about entries."""
    one_shape: bool = False
    """Whether both forms have the same shape."""
    require: Callable[[Claim, str], None] | None = None
    """It takes a claim, and raises an error if its declaration is not complete."""
    is_notation: bool = False
    """Whether it introduces notation, so that nothing is derived."""
    is_equality: bool = False
    """Whether both forms have values at a point, which are equal, perhaps up to scale."""
    is_marked: bool = False
    """Whether the parts in which a wrong printed form differs from the right one are marked."""
    is_reduced: bool = True
    """Whether what is derived is shown in lowest terms.  What no verdict needs expanded may be too large for that."""
    printed: str = "Printed"
    derived: str = "Derived"
    """Captions of the two forms."""
    relation: str = "="
    negated: str = r"\neq"
    """LaTeX between the two forms, if the claim holds and if it does not."""
    applied: str = "%(derived)s"
    """LaTeX of what is compared with the printed form, from ``%(derived)s`` and ``%(variable)s``."""
    derived_first: bool = False
    """Whether the derived form stands before the relation."""
    text: Callable[[Any], str] | None = None
    """How a form is written for readers, if it is not a formula."""

    @property
    def when_it_holds(self) -> Verdict:
        """The verdict on a claim whose printed form holds."""
        return "definition" if self.is_notation else "proved"

    def sentence(self, claim: Claim) -> str:
        """Return how the printed form of a claim is compared with the derived one."""
        return self.says if isinstance(self.says, str) else self.says(claim)
