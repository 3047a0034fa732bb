"""Derivatives in letters, worked out by code of its own: a form and its change go together, as with dual numbers."""

from dataclasses import replace
from typing import NamedTuple

from algebroproj_sym.replaying.letters.reading import NUMBER, Node, changed, constant, made, parts_of
from algebroproj_sym.replaying.letters.statement import Statement, without_definitions
from algebroproj_sym.replaying.rejection import Rejected, require

_LINEAR = {"transpose", "trace", "skew", "vee", "vec", "diag", "conj", "pure", "imag", "hat", "ad", "entry", "sum"}


class Dual(NamedTuple):
    """A form, and its change; None if it does not change."""

    form: Node
    change: Node | None


def without_derivatives(statement: Statement) -> Statement:
    """Put for each derivative what it is, by the rules of sums, products and chains."""
    if not any(part.kind.endswith("diff") for node in statement.nodes for part in parts_of(node)):
        return statement

    def worked_out(node: Node) -> Node | None:
        if not node.kind.endswith("diff"):
            return None
        inside = without_definitions(replace(statement, left=node))
        return _without(inside.left, inside)

    return statement.every(lambda node: changed(node, worked_out))


def _without(node: Node, statement: Statement) -> Node:
    parts = [_without(part, statement) for part in node.parts]
    if not node.kind.endswith("diff"):
        return made(node.kind, *parts, value=node.value) if parts else node
    form, letter, direction = parts
    _require_free(node.kind, letter, statement)
    turn = made("skew", direction) if node.kind != "diff" else direction
    change = {
        "diff": lambda: direction,
        "ldiff": lambda: made("product", turn, letter),
        "rdiff": lambda: made("product", letter, turn),
    }[node.kind]()
    found = _dual(form, letter, change).change
    return _nothing(form) if found is None else found


def _require_free(kind: str, letter: Node, statement: Statement) -> None:
    bound = any(part == letter for node in statement.constraints for part in parts_of(node))
    require(not bound, "a derivative by a letter that a constraint binds")
    if kind == "diff" and letter.kind == "symbol":
        require(letter.value not in statement.sizes, "a derivative by a size")
        return
    require(letter.kind == "letter", "expected a derivative by a letter")
    properties = statement.letters[letter.value].properties
    kept = "orthogonal" in properties if kind != "diff" else not properties
    require(kept, "a derivative by a letter that does not stay what it is")


def _nothing(form: Node) -> Node:
    return constant(0) if form.shape == NUMBER else made("zeros", value=form.shape)


def _dual(form: Node, letter: Node, change: Node) -> Dual:
    if form == letter:
        return Dual(form, change)
    duals = [_dual(part, letter, change) for part in form.parts]
    changes = [dual.change for dual in duals if dual.change is not None]
    if not changes:
        return Dual(form, None)
    if form.kind in _LINEAR:
        return Dual(form, made(form.kind, *changes, value=form.value))
    if form.kind == "block":
        return Dual(form, made("block", *(dual.change or _nothing(dual.form) for dual in duals), value=form.value))
    if form.kind in ("product", "dot", "outer", "cross", "qmul", "kron"):
        return Dual(form, _leibniz(form.kind, duals))
    return Dual(form, _chain(form, duals[0].form, changes[0]))


def _leibniz(kind: str, duals: list[Dual]) -> Node:
    terms = []
    for place, dual in enumerate(duals):
        if dual.change is not None:
            before, after = (other.form for other in duals[:place]), (other.form for other in duals[place + 1 :])
            terms.append(made(kind, *before, dual.change, *after))
    return made("sum", *terms)


def _chain(form: Node, part: Node, change: Node) -> Node | None:
    if form.kind == "power" and form.value == 0:
        return None
    if form.kind == "power":
        base = Dual(part, change)
        if form.value < 0:
            inverse = made("power", part, value=-1)
            base = Dual(inverse, made("product", constant(-1), inverse, change, inverse))
        return _leibniz("product", [base] * abs(form.value))
    if form.kind == "det":
        return made("trace", made("product", made("adj", part), change))
    if form.kind == "norm":
        return made("product", made("dot", part, change), made("power", form, value=-1))
    if form.kind in ("sin", "cos"):
        other = made("cos" if form.kind == "sin" else "sin", part)
        return made("product", constant(1 if form.kind == "sin" else -1), other, change)
    if form.kind == "exp" and part.kind == change.kind == "skew":
        left = made("skew", made("product", made("jl", *part.parts), *change.parts))
        return made("product", left, form)
    raise Rejected(f"the derivative of {form.kind} is not known")
