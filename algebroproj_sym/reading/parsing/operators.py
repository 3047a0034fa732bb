r"""Operators with what they are applied to, as letters: ``\nabla \cdot u``, ``\nabla^2 f`` and ``\frac{D p}{D t}``.

Each is linear, and all that is computed of it.  So the same operator of the same formula is the same letter.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.lexing.commands import VECTOR_STYLE
from algebroproj_sym.reading.parsing.grammar import (
    IN_BRACKETS,
    Formula,
    Parsed,
    Sides,
    symbols_in,
    trees_in,
    without_brackets,
)

Name = Callable[[Formula], str]
_MATERIAL = re.compile(r"D|\\mathrm\{D\}|\\mathcal\{D\}")
_NABLA = re.compile(r"(?:\\(?:mathbf|boldsymbol|bm|vec)\{)?\\nabla\}?")
_PARTIAL = re.compile(r"\\partial_.+")
_BOLD = re.compile(VECTOR_STYLE)
_TWO: Formula = Tree("number", [Token("NUMBER", "2")])
_APPLIED = ("symbol", "opaque", "call", "bracket", "marked", "fraction", "function", "power", "root")
"""To what an operator may be applied: a product behind it may begin with a factor of its own."""


@dataclass(frozen=True)
class Applied:
    """An operator with what it is applied to."""

    kind: str
    """How it is called: "div", "curl", "grad", "lap", "along", the same without brackets, or "partial x"."""
    body: Formula
    by: Formula | None = None
    r"""The u of ``(u \cdot \nabla) v``."""


@dataclass(frozen=True)
class Operators:
    """Which operators a document has.

    Attributes
    ----------
    material : bool
        Whether a D is a derivative wherever it stands.
    fields : bool
        Whether gradients are those of fields, and by no vector of the document.
    applied : dict
        What each letter of an operator is, as far as formulas were changed.
    """

    material: bool
    fields: bool
    applied: dict[str, Applied] = field(default_factory=dict, compare=False)


def operators_in(equations: Sequence[Sides]) -> Operators | None:
    """Return which operators some equations have; None for none."""
    material = _is_material(equations)
    acts = material or any(_acts(side) for sides in equations for side in sides)
    return Operators(material, any(map(_has_fields, equations))) if acts else None


def with_operators(formula: Parsed, operators: Operators) -> Parsed:
    r"""Return a formula in which operators with what they are applied to are letters.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> formula = parsed(r"\frac{D (a - b)}{D t} + \nabla \cdot c")
    >>> found = with_operators(formula, operators_in([formula.sides]))
    >>> symbols_in(found.sides[0])
    ['D a/D t', 'D b/D t', 'div c']
    """
    return replace(formula, sides=tuple(_changed(side, operators) for side in formula.sides))


def _is_material(equations: Iterable[Sides]) -> bool:
    """Whether a D stands only above and below lines, as a derivative does."""
    inside, every = 0, 0
    for sides in equations:
        for side in sides:
            every += sum(1 for each in side.scan_values(lambda token: _MATERIAL.fullmatch(str(token)) is not None))
            inside += sum(2 for each in side.iter_subtrees() if _of_material(each) is not None)
    return 0 < every == inside


def _has_fields(sides: Sides) -> bool:
    r"""Whether a nabla has a point, a cross or a square, or is bold, so that it is no gradient by a vector.

    In ``\nabla^2 f(x)`` the square may be that of all second derivatives.
    """
    trees = [each for side in sides for each in side.iter_subtrees()]
    products = any(each.data == "product" and _of_product(each, {}) is not each for each in trees)
    pairs = [pair for each in trees if each.data == "run" for pair in pairwise(trees_in(each))]
    of_values = [sign for sign, body in pairs if body.data == "call" and len(trees_in(trees_in(body)[0])) == 1]
    powers = (each for each in trees if each.data == "power" and each not in of_values)
    squares = any(_is_nabla(trees_in(each)[0]) for each in powers)
    return products or squares or any(_is_nabla(each) and each.children[0] != r"\nabla" for each in trees)


def _changed(tree: Any, operators: Operators) -> Any:
    if not isinstance(tree, Tree):
        return tree
    if operators.material and (found := _of_material(tree)) is not None:
        body, variable = found
        body = _changed(body, operators)
        return _linear(lambda each: f"D {_written(each)}/D {variable}", body)
    changed = Tree(tree.data, [_changed(each, operators) for each in tree.children])
    if changed.data == "run":
        changed = Tree("run", [one for each in changed.children for one in _factors_of(each)])
        return _of_run(changed, operators)
    return _of_product(changed, operators.applied) if changed.data == "product" else changed


def _factors_of(part: Any) -> list[Any]:
    r"""Return a letter and a bracket for what looks like a value of a function, as ``\rho (u \cdot \nabla)``."""
    if not isinstance(part, Tree) or part.data != "call" or not any(map(_is_along, map(_bracket, trees_in(part)))):
        return [part]
    return [Tree("symbol", [Token("SYMBOL", str(part.children[0]))]), *map(_bracket, trees_in(part))]


def _bracket(items: Formula) -> Formula:
    return Tree("bracket", [items])


def _of_material(fraction: Formula) -> tuple[Formula, str] | None:
    """Return of what a fraction is the derivative along a path, and by which letter; None if it is none."""
    if fraction.data not in ("fraction", "quotient") or len(fraction.children) != 2:
        return None
    above, below = trees_in(fraction)
    if above.data != "run" or below.data != "run" or len(above.children) != 2 or len(below.children) != 2:
        return None
    (one, body), (other, variable) = trees_in(above), trees_in(below)
    is_sign = one == other and one.data == "symbol" and _MATERIAL.fullmatch(str(one.children[0])) is not None
    return (body, str(variable.children[0])) if is_sign and variable.data == "symbol" else None


def _of_run(run: Formula, operators: Operators) -> Formula:
    """Return a product in which an operator before its last factor is one letter with it."""
    *before, sign, body = trees_in(run) if len(run.children) > 1 else (run, run)
    body = _without_braces(body)
    if body.data not in _APPLIED or any(map(_acts, before)):
        return run
    applied = operators.applied
    if sign.data == "power" and _is_nabla(trees_in(sign)[0]) and trees_in(sign)[1] == _TWO:
        name = _named(applied, "lap", "lap", body, r"\mathbf{lap}")
    elif _is_nabla(sign) and operators.fields:
        name = _named(applied, "grad", r"\mathbf{grad}", body, r"\mathbf{Grad}")
    elif _is_partial(sign):
        letter = str(sign.children[0]).partition("_")[2]
        name = _named(applied, f"partial {letter}", f"part {letter}", body, rf"\mathbf{{part}} {letter}")
    elif _is_along(sign) and _has_vector(body):
        by = trees_in(without_brackets(sign))[0]
        name = _named(applied, "along", "", body, rf"\mathbf{{along}} {_plain(by)} of", by)
    else:
        return run
    return _joined("run", [*before, _linear(name, body)])


def _of_product(product: Formula, applied: dict[str, Applied]) -> Formula:
    """Return a product in which a nabla with a point or a cross behind it is one letter with what follows."""
    first, *rest = product.children
    if len(rest) == 4 and isinstance(rest[1], Tree) and _is_nabla(rest[1]):
        inner = _of_product(Tree("product", rest[1:]), applied)
        rest = [rest[0], inner] if inner.data == "symbol" else rest
    if len(rest) != 2 or not isinstance(first, Tree) or not isinstance(rest[1], Tree):
        return product
    *before, sign = trees_in(first) if first.data == "run" else [first]
    body = _without_braces(rest[1])
    kind = getattr(rest[0], "type", "")
    gradient = applied.get(str(body.children[0])) if body.data == "symbol" and kind == "DOT" else None
    if gradient is not None and gradient.kind == "grad" and _has_vector(gradient.body) and _has_vector(sign):
        name = _named(
            applied, "along, without brackets", "", gradient.body, rf"\mathbf{{along}} {_plain(sign)} of", sign
        )
        return _joined("run", [*before, _linear(name, gradient.body)])
    if not _is_nabla(sign) or body.data not in _APPLIED or any(map(_acts, before)) or kind not in ("DOT", "CROSS"):
        return product
    of_vector = r"\mathbf{curl}" if kind == "CROSS" else "div"
    of_table = r"\mathbf{div}" if kind == "DOT" and _has_table(body) else of_vector
    name = _named(applied, "curl" if kind == "CROSS" else "div", of_vector, body, of_table)
    return _joined("run", [*before, _linear(name, body)])


def _without_braces(tree: Formula) -> Formula:
    return _without_braces(trees_in(tree)[0]) if tree.data == "group" else tree


def _named(
    applied: dict[str, Applied], kind: str, of_number: str, body: Formula, of_vector: str, by: Formula | None = None
) -> Name:
    """Return how an operator with each term of a formula is written; what is written so is noted."""
    sign = of_vector if _has_vector(body) else of_number

    def name(each: Formula) -> str:
        symbol = f"{sign} {_plain(each)}"
        applied[symbol] = Applied(kind, each, by)
        return symbol

    return name


def _linear(name: Name, body: Formula) -> Formula:
    """Return the letter of an operator with a formula; that of a sum is a sum."""
    inside = without_brackets(body)
    if inside.data != "sum":
        return Tree("symbol", [Token("SYMBOL", name(inside))])
    parts: list[Any] = [_linear(name, each) if isinstance(each, Tree) else each for each in inside.children]
    return Tree("bracket", [Tree("items", [Tree("sum", parts)])])


def _joined(kind: str, parts: list[Any]) -> Formula:
    return parts[0] if len(parts) == 1 else Tree(kind, parts)


def _plain(tree: Formula) -> str:
    """Return a formula as text that no other one has, with no command of a vector: that of the operator counts."""
    return re.sub(VECTOR_STYLE, lambda style: re.sub(r"\W", "", style[0]), _written(tree))


def _written(tree: Formula) -> str:
    """Return a formula as text that no other one has."""
    inside = " ".join(_written(each) if isinstance(each, Tree) else str(each) for each in tree.children)
    if tree.data in ("symbol", "opaque", "number"):
        return inside
    return f"[{inside}]" if tree.data in IN_BRACKETS else f"{tree.data}[{inside}]"


def _acts(tree: Formula) -> bool:
    """Whether an operator stands alone in a factor: it acts on all that is behind it."""
    return any(_is_nabla(each) or _is_partial(each) for each in tree.iter_subtrees())


def _is_partial(tree: Formula) -> bool:
    return tree.data == "symbol" and _PARTIAL.fullmatch(str(tree.children[0])) is not None


def _is_nabla(tree: Formula) -> bool:
    return tree.data == "symbol" and _NABLA.fullmatch(str(tree.children[0])) is not None


def _is_along(tree: Formula) -> bool:
    r"""Whether a factor is ``(u \cdot \nabla)``."""
    inside = without_brackets(tree)
    return inside.data == "product" and len(inside.children) == 3 and _is_nabla(trees_in(inside)[-1])


def _has_vector(tree: Formula) -> bool:
    return any(_BOLD.match(each) for each in symbols_in(tree))


def _has_table(tree: Formula) -> bool:
    return any(re.match(rf"{VECTOR_STYLE}\{{?\W*[A-Z]|\\boldsymbol", each) for each in symbols_in(tree))
