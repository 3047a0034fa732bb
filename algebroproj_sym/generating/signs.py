"""Signs: a reciprocal of which nothing but negatives of products are wanted is taken with its sign changed."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection
from dataclasses import replace

from algebroproj_sym.generating.program import Call, Operand, Program, Step


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
    uses = program.uses()
    users: dict[Operand, list[Step | Call]] = defaultdict(list)
    for step in program.steps:
        for operand in step.operands:
            users[operand].append(step)

    def negative(product: Step | Call) -> str | None:
        """Return the name of the negative of a product that has no other use, and one factor that is a reciprocal."""
        if not isinstance(product, Step) or product.operator != "*" or uses[product.name] != 1:
            return None
        reciprocals = [operand for operand in product.operands if operand in candidates]
        user = users[product.name]
        is_negated = len(user) == 1 and isinstance(user[0], Step) and user[0].operator == "neg"
        return user[0].names[0] if is_negated and len(reciprocals) == 1 and product.name not in kept else None

    candidates: set[Operand] = {
        step.name
        for step in program.steps
        if isinstance(step, Step) and (step.operator, step.operands[0]) == ("/", 1) and step.name not in kept
    }
    turned = {
        name
        for name in candidates
        if 0 < uses[name] == len(users[name]) and all(negative(product) is not None for product in users[name])
    }
    steps: list[Step | Call] = []
    spared: set[Operand] = set()
    for step in program.steps:
        if isinstance(step, Call) or not turned & {step.name, *step.operands}:
            steps += [] if spared.issuperset(step.operands) else [step]
        elif step.name in turned:
            steps.append(replace(step, operands=(-1, step.operands[1])))
        else:
            spared.add(step.name)
            steps.append(replace(step, name=str(negative(step))))
    return Program(program.inputs, tuple(steps), program.outputs)
