"""Signs: a reciprocal of which nothing but negatives of products are wanted is taken with its sign changed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection
from dataclasses import replace

from algebroproj_sym.generating.program import Call, Program, Step


def with_negative_reciprocals(program: Program, kept: Collection[str] = ()) -> Program:
    """Take reciprocals with the other sign where that spares negations.

    Parameters
    ----------
    program : Program
        A program on single numbers.
    kept : collection of str
        The names whose values are to stay what they are.

    Returns
    -------
    Program
        The same results, to the last bit.

    Examples
    --------
    >>> steps = (
    ...     Step("r", "/", (1, "z")),
    ...     Step("a", "*", ("x", "r")),
    ...     Step("b", "*", ("y", "r")),
    ...     Step("c", "neg", ("a",)),
    ...     Step("d", "neg", ("b",)),
    ... )
    >>> program = with_negative_reciprocals(Program(("x", "y", "z"), steps, ("c", "d")))
    >>> [(step.name, step.operator, step.operands) for step in program.steps]
    [('r', '/', (-1, 'z')), ('c', '*', ('x', 'r')), ('d', '*', ('y', 'r'))]
    """
    steps = [step for step in program.steps if isinstance(step, Step) and step.name not in kept]
    uses = program.uses()
    reciprocals = {step.name for step in steps if (step.operator, step.operands[0]) == ("/", 1)}
    negatives = {step.operands[0]: step.name for step in steps if step.operator == "neg"}
    products = [
        step
        for step in steps
        if step.operator == "*"
        and step.name in negatives
        and uses[step.name] == 1
        and sum(operand in reciprocals for operand in step.operands) == 1
    ]
    negated = Counter(operand for product in products for operand in product.operands)
    turned = {reciprocal for reciprocal in reciprocals if uses[reciprocal] == negated[reciprocal] > 0}
    names = {product.name: negatives[product.name] for product in products if not turned.isdisjoint(product.operands)}

    def changed(step: Step | Call) -> Step | Call:
        if isinstance(step, Step) and step.name in turned:
            return replace(step, operands=(-1, step.operands[1]))
        return replace(step, name=names[step.name]) if isinstance(step, Step) and step.name in names else step

    spared = {*names.values()}
    left = tuple(changed(step) for step in program.steps if spared.isdisjoint(step.names))
    return Program(program.inputs, left, program.outputs)
