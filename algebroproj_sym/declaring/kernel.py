"""Kernels: numeric functions to be generated from derived expressions."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from keyword import iskeyword
from typing import Any, NotRequired, TypedDict, Unpack, cast

import sympy

from algebroproj_sym.declaring.claim import DeclarationError
from algebroproj_sym.declaring.elementary import PRIMITIVES
from algebroproj_sym.declaring.kernels_in_letters import entry_by_entry
from algebroproj_sym.declaring.stage import LINEAR, Stage
from algebroproj_sym.expressions import Expression, entries, rational, shape, symbols_of, vector
from algebroproj_sym.proving.statements import speaks_of_letters

STRUCTURES: Mapping[str, tuple[str, Callable[[int, int], bool]]] = {
    "diagonal": ("the entries beside the diagonal are not read", lambda i, j: i == j),
    "symmetric": ("the entries above the diagonal stand for those below it, which are not read", lambda i, j: i <= j),
    "skew": ("the entries above the diagonal stand for the others, which are not read", lambda i, j: i < j),
}
"""Matrices some of whose entries give the others: what that means for a function, and which places it reads."""


@dataclass(frozen=True)
class Argument:
    """An argument of a kernel: its name, and its entries as a symbol or a matrix of symbols.

    A symmetric, skew or diagonal matrix repeats symbols, or has zeros.  The function takes it whole all the same.

    Examples
    --------
    >>> a, b, c = sympy.symbols("a b c")
    >>> dispersion = Argument("S", sympy.ImmutableMatrix([[a, b], [b, c]]))
    >>> dispersion.structure, dispersion.read, dispersion.symbols
    ('symmetric', (a, b, c), (a, b, S_21, c))
    """

    name: str
    entries: Expression

    @property
    def shape(self) -> tuple[int, ...]:
        """The core shape."""
        return shape(self.entries)

    @property
    def structure(self) -> str | None:
        """One of `STRUCTURES`, None of a matrix that has none, and of what is not a square matrix."""
        size = self.shape
        if len(size) < 2 or size[0] != size[1] or size[0] == 1:
            return None
        if self.entries.is_diagonal():
            return "diagonal"
        kinds = {"symmetric": self.entries.T, "skew": -self.entries.T}
        return next((kind for kind, turned in kinds.items() if turned == self.entries), None)

    @property
    def read(self) -> tuple[sympy.Expr, ...]:
        """The entries that the function reads, row by row."""
        return tuple(entry for _, entry, is_read in self._places() if is_read)

    @property
    def symbols(self) -> tuple[sympy.Symbol, ...]:
        """All entries row by row, those that are not read with names of their own."""
        return tuple(
            sympy.Symbol(str(entry) if is_read else f"{self.name}_{''.join(str(k + 1) for k in place)}")
            for place, entry, is_read in self._places()
        )

    @property
    def description(self) -> str:
        """What is said of its structure, nothing where it has none."""
        kind = self.structure
        return f"Taken as {kind}: {STRUCTURES[kind][0]}." if kind else ""

    def _places(self) -> Iterator[tuple[tuple[int, ...], sympy.Expr, bool]]:
        kind = self.structure
        for place, entry in zip(product(*map(range, self.shape)), entries(self.entries), strict=True):
            yield place, entry, kind is None or STRUCTURES[kind][1](*place)


@dataclass(frozen=True)
class Result:
    """A result of a kernel."""

    name: str
    """What it is called."""
    derived: Expression
    """What the derivation computes: the truth that the function is held against."""
    form: Expression
    """An equal expression that is to be lowered; it may use the abbreviations of the kernel."""

    @property
    def shape(self) -> tuple[int, ...]:
        """The core shape."""
        return shape(self.derived)


@dataclass(frozen=True)
class Kernel:
    """A named numeric function lowered from a derived expression.

    Attributes
    ----------
    paper, section : str
        Where it is derived.
    module, name : str
        The place of the generated function: ``algebroproj.<module>.<name>``.
    summary : str
        The first line of its docstring.
    arguments : tuple of Argument
        Names and core shapes.
    results : tuple of Result
        What it returns: several results as a tuple, in this order.
    stages : tuple of Stage
        Intermediate values that are not rational functions of the arguments, such as angles.
    where : tuple of (Symbol, Expr)
        Abbreviations, such as ``y00 = 1 - y01 - y02 - y03``.
    claims : tuple of str
        The numbers of the claims that prove it.
    example : mapping of str to nested tuple of str
        Decimal values of the arguments for the example of its docstring.
    describe : mapping of str to str
        What each argument is, with its unit.
    alternatives : tuple of Kernel
        The same kernel with other forms.  The generator may choose one of them.
    normwise : bool
        Whether errors are relative to the largest entry of an argument or result.  Otherwise they are relative to each
        entry.
    """

    paper: str
    section: str
    module: str
    name: str
    summary: str
    arguments: tuple[Argument, ...]
    results: tuple[Result, ...]
    where: tuple[tuple[sympy.Symbol, sympy.Expr], ...]
    claims: tuple[str, ...]
    example: Mapping[str, Any]
    describe: Mapping[str, str]
    stages: tuple[Stage, ...] = ()
    normwise: bool = False
    alternatives: tuple[Kernel, ...] = ()

    @property
    def qualified_name(self) -> str:
        """The module and the name."""
        return f"{self.module}.{self.name}"

    @property
    def symbols(self) -> tuple[sympy.Symbol, ...]:
        """The entries of all arguments, in order."""
        return tuple(symbol for argument in self.arguments for symbol in argument.symbols)

    @property
    def read(self) -> tuple[sympy.Expr, ...]:
        """Those of them that are read: one triangle of a symmetric matrix."""
        return tuple(entry for argument in self.arguments for entry in argument.read)

    @property
    def intermediate(self) -> tuple[sympy.Symbol, ...]:
        """The symbols that the stages give, in order."""
        return tuple(symbol for stage in self.stages for symbol in stage.results)

    @property
    def described(self) -> Mapping[str, str]:
        """What each argument is, with what is said of its structure."""
        return {a.name: "  ".join(filter(None, [self.describe[a.name], a.description])) for a in self.arguments}

    @property
    def solves_systems(self) -> bool:
        """Whether a stage solves a linear system."""
        return any(stage.primitive in LINEAR for stage in self.stages)

    @property
    def is_rational(self) -> bool:
        """Whether no stage solves a linear system or calls an elementary function."""
        return all(stage.primitive == "let" for stage in self.stages)

    @property
    def derived(self) -> Expression:
        """The derived form of the result, or of all results in one column."""
        return _joined([result.derived for result in self.results])

    @property
    def form(self) -> Expression:
        """The form to be lowered of the result, or of all results in one column."""
        return _joined([result.form for result in self.results])


def _joined(forms: Sequence[Expression]) -> Expression:
    return forms[0] if len(forms) == 1 else vector(*(entry for form in forms for entry in entries(form)))


class Alternative(TypedDict):
    """Another form of a kernel, with its own abbreviations."""

    form: Any
    where: NotRequired[Mapping[sympy.Symbol, Any]]


class KernelParts(TypedDict):
    """What a kernel declares beside its name and summary."""

    arguments: Mapping[str, Any]
    derived: Any
    claims: Sequence[str]
    example: Mapping[str, Any]
    describe: Mapping[str, str]
    properties: NotRequired[Mapping[Any, Any]]
    form: NotRequired[Any]
    where: NotRequired[Mapping[sympy.Symbol, Any]]
    through: NotRequired[Sequence[Stage]]
    normwise: NotRequired[bool]
    alternatives: NotRequired[Sequence[Alternative]]


def declared_kernel(
    paper: str, section: str, qualified_name: str, summary: str, **parts: Unpack[KernelParts]
) -> Kernel:
    """Return a kernel, after checking that its declaration is complete.

    Arguments can be letters, as ``MatrixSymbol("S", 3, 3)``, and forms can speak of these.  They are then written out
    here, once.  By ``properties={S: "symmetric"}`` a letter is symmetric, skew, diagonal, positive definite,
    orthogonal, a rotation, or a unit vector.

    It raises `DeclarationError` if a symbol of the expression is neither an entry of an argument nor an abbreviation,
    an entry occurs twice, no claim is named, or the example does not give every argument.
    """
    label = f"kernel {qualified_name}"
    if speaks_of_letters(parts["arguments"].values()) or parts.get("properties"):
        parts = cast("KernelParts", entry_by_entry(parts, label))
    module, _, name = qualified_name.partition(".")
    kernel = Kernel(
        paper=paper,
        section=section,
        module=module,
        name=name,
        summary=summary,
        arguments=tuple(Argument(key, rational(value, f"{label}, {key}")) for key, value in parts["arguments"].items()),
        results=_results(parts["derived"], parts.get("form", parts["derived"]), label),
        where=_where(parts.get("where", {}), label),
        claims=tuple(parts["claims"]),
        example=parts["example"],
        describe=parts["describe"],
        stages=tuple(parts.get("through", ())),
        normwise=parts.get("normwise", False),
    )
    alternatives = tuple(
        _alternative(kernel, parts["derived"], other, label) for other in parts.get("alternatives", ())
    )
    for each in (kernel, *alternatives):
        _require_complete(each, label)
    return replace(kernel, alternatives=alternatives)


def _alternative(kernel: Kernel, derived: Any, other: Alternative, label: str) -> Kernel:
    return replace(
        kernel,
        results=_results(derived, other["form"], label),
        where=_where(other.get("where", {}), label),
    )


def _where(given: Mapping[sympy.Symbol, Any], label: str) -> tuple[tuple[sympy.Symbol, sympy.Expr], ...]:
    return tuple((symbol, rational(value, f"{label}, where")) for symbol, value in given.items())


def _results(derived: Any, form: Any, label: str) -> tuple[Result, ...]:
    """Return the results: several ones are given by name, a single one has none of its own."""
    if not isinstance(derived, Mapping):
        return (Result("result", rational(derived, f"{label}, derived"), rational(form, f"{label}, form")),)
    if not isinstance(form, Mapping) or list(form) != list(derived) or not derived:
        raise DeclarationError(f"{label}: expected a form for each of the results {list(derived)}, got {form}")
    return tuple(
        Result(name, rational(value, f"{label}, {name}"), rational(form[name], f"{label}, form of {name}"))
        for name, value in derived.items()
    )


def _require_complete(kernel: Kernel, label: str) -> None:
    if not (kernel.module and kernel.name):
        raise DeclarationError(f"{label}: expected a name of the form module.function")
    inputs = kernel.symbols
    if len(set(inputs)) != len(inputs) or not {*kernel.read} <= {*inputs}:
        raise DeclarationError(
            f"{label}: expected different plain symbols as entries of the arguments, or symmetric, skew or diagonal "
            f"matrices with such above or on the diagonal, got {[*kernel.read]}"
        )
    for argument in kernel.arguments:
        if not argument.shape and argument.symbols[0].name != argument.name:
            raise DeclarationError(
                f"{label}: expected the scalar {argument.name} as its symbol, got {argument.symbols[0]}"
            )
    _require_free_names(kernel, label)
    unknown = _unknown_symbols(kernel)
    if unknown:
        raise DeclarationError(f"{label}: expected the symbols of the arguments, got also {sorted(map(str, unknown))}")
    for result in kernel.results:
        if shape(result.form) != result.shape:
            raise DeclarationError(f"{label}: expected a form of shape {result.shape}, got {shape(result.form)}")
    if not kernel.claims:
        raise DeclarationError(f"{label}: expected the numbers of the claims that prove it, got none")
    names = {argument.name for argument in kernel.arguments}
    for what, given in (("example", kernel.example), ("description", kernel.describe)):
        if set(given) != names:
            raise DeclarationError(f"{label}: expected an {what} of each of {sorted(names)}, got {sorted(given)}")


def _require_free_names(kernel: Kernel, label: str) -> None:
    """Refuse names that the generated code cannot give, or gives to something else, and names given twice."""
    several = [result.name for result in kernel.results] if len(kernel.results) > 1 else []
    own = [*(symbol.name for symbol in kernel.intermediate), *several]
    given = [kernel.name, *kernel.example, *(symbol.name for symbol in kernel.symbols), *own]
    reserved = ("arguments", "out", *PRIMITIVES)
    refused = [name for name in given if iskeyword(name) or not name.isidentifier() or name in reserved]
    refused += [name for name in own if re.fullmatch(r"t\d+", name)]
    if refused:
        raise DeclarationError(f"{label}: expected names that are free in the generated code, got {refused}")
    names = Counter([*own, *{*(symbol.name for symbol in kernel.symbols), *kernel.example}])
    names.update({symbol.name for symbol, _ in kernel.where})
    twice = sorted(name for name, count in names.items() if count > 1)
    if twice:
        raise DeclarationError(f"{label}: expected different names of arguments, stages and results, got {twice} twice")


def _unknown_symbols(kernel: Kernel) -> set[sympy.Symbol]:
    """Return the symbols that are used before anything gives them a value."""
    known = {*kernel.symbols}
    unknown: set[sympy.Symbol] = set()
    for stage in kernel.stages:
        unknown |= {*symbols_of([stage.derived, stage.form])} - known
        known |= {*stage.results}
    unknown |= {*symbols_of([kernel.derived])} - known
    for abbreviation, expression in kernel.where:
        unknown |= {*symbols_of([expression])} - known
        known.add(abbreviation)
    return unknown | ({*symbols_of([kernel.form])} - known)
