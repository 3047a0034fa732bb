"""Compensation: sums that may cancel are computed from operands of twice the digits, and rounded once.

A rounded operand of a sum is an error that cancellation enlarges.  Going from the results back to the inputs, each sum
asks its operands for twice the digits (compensated numbers, which begin with ``wide``); so do the operations that
such an operand is made of, down to the inputs, which are exact, and linear systems, whose residuals cancel.  Products
and quotients enlarge no relative error, and take ``rounded`` operands.  In real arithmetic nothing changes: there
``wide`` and ``rounded`` are the identity, and so is ``rounded_twice``, which leaves out what rounding took from a sum
last.
"""

from dataclasses import replace

from algebroproj_sym.declaring import LINEAR
from algebroproj_sym.generating.program import Call, Operand, Program, Step, fresh_names, with_names


def compensated(program: Program, throughout: bool = False) -> Program:
    """Return a program of the same value in which the operands of sums that may cancel have twice the digits.

    If it is so throughout, products and quotients are computed with twice the digits too, and only the results are
    rounded. There are no calls of ``let`` in it.

    Examples
    --------
    >>> steps = (Step("t0", "-", (1, "x")), Step("y0", "-", ("t0", "y")), Step("t1", "/", ("y0", "x")))
    >>> for step in compensated(Program(("x", "y"), steps, ("t1",))).steps:
    ...     print(step.name, "=", step.operator, *step.operands)
    t2 = wide x
    t0 = - 1 t2
    t3 = - t0 y
    y0 = rounded t3
    t1 = / y0 x
    """
    flat = _without_lets(program)
    return _written(flat, _doubled(flat, throughout))


def with_sums_rounded_twice(program: Program) -> Program:
    """Return a program that rounds sums of products without what rounding took from their first part.

    That spares six operations where nothing else is done with such a sum.  It is done where both operands are products,
    or one is a sum of inputs: a first part that cancels so far that the second one matters is exact there, but near
    several zeros at once.

    Examples
    --------
    >>> steps = Step("t0", "wide", ("x",)), Step("t1", "*", ("t0", "y")), Step("t2", "-", ("t1", "y"))
    >>> program = Program(("x", "y"), (*steps, Step("t3", "rounded", ("t2",))), ("t3",))
    >>> with_sums_rounded_twice(program).steps[-1].operator
    'rounded_twice'
    """
    uses, sums = program.uses(), _sums_of_products(program)

    def is_last(step: Step | Call) -> bool:
        rounds = isinstance(step, Step) and step.operator == "rounded"
        return rounds and sums.issuperset(step.operands) and uses[step.operands[0]] == 1

    steps = tuple(Step(s.names[0], "rounded_twice", s.operands) if is_last(s) else s for s in program.steps)
    return Program(program.inputs, steps, program.outputs)


def _sums_of_products(program: Program) -> set[Operand]:
    """Return the sums of two products, or of a product and a sum of inputs, where factors are such sums or products."""
    linear: set[Operand] = {*program.inputs}
    products: set[Operand] = set()
    sums: set[Operand] = set()
    for step in program.steps:
        operands = {operand for operand in step.operands if not isinstance(operand, int)}
        if isinstance(step, Call) or not operands <= linear | products:
            continue
        multiplies, adds = step.operator in ("*", "/"), step.operator in ("+", "-")
        kind = linear if operands <= linear and not multiplies else sums if adds else products
        kind.add(step.name)
    return sums


def _without_lets(program: Program) -> Program:
    """Give the steps the names that ``let`` gives them."""
    lets = [step for step in program.steps if isinstance(step, Call) and step.primitive == "let"]
    bindings = [binding for call in lets for binding in zip(call.names, call.rows[0], strict=True)]
    return with_names(replace(program, steps=tuple(step for step in program.steps if step not in lets)), bindings)


def _doubled(program: Program, throughout: bool) -> set[Operand]:
    """Return the names that stand for numbers of twice the digits."""
    computed = {name for step in program.steps for name in step.names} - _exact(program) - _zeros(program)
    harmless = _without_cancellation(program)
    doubled: set[Operand] = set(computed) if throughout else set()
    for step in reversed(program.steps):
        if isinstance(step, Step) and step.operator in ("+", "-") and step.name not in harmless:
            doubled.add(step.name)
        if _refines(step) or not doubled.isdisjoint(step.names):
            doubled |= computed.intersection(step.operands)
    return doubled


def _refines(step: Step | Call) -> bool:
    """Whether a step takes numbers of twice the digits, and gives rounded ones: linear systems are solved so."""
    return isinstance(step, Call) and step.primitive in LINEAR


def _exact(program: Program) -> set[Operand]:
    """Return the operands that have no more digits: inputs, integers, solutions of systems, and their negatives."""
    exact: set[Operand] = {*program.inputs}
    for step in program.steps:
        exact |= {operand for operand in step.operands if isinstance(operand, int)}
        if _refines(step):
            exact |= {*step.names}
        elif isinstance(step, Step) and step.operator == "neg" and step.operands[0] in exact:
            exact.add(step.name)
    return exact


def _zeros(program: Program) -> set[Operand]:
    """Return the guards, 0 / factor, 0 * sum and sums of them, which are zero or no numbers at all."""
    zeros: set[Operand] = set()
    for step in program.steps:
        if isinstance(step, Step):
            guard = step.operator in ("/", "*") and step.operands[0] == 0
            if guard or zeros.issuperset(step.operands):
                zeros.add(step.name)
    return zeros


def _without_cancellation(program: Program) -> set[Operand]:
    """Return the sums that lose no digits: of two exact numbers, with a guard, or of terms that are not negative."""
    exact, zeros = _exact(program), _zeros(program)
    positive: set[Operand] = {operand for operand in exact if isinstance(operand, int) and operand >= 0}
    harmless: set[Operand] = set()
    for step in program.steps:
        if isinstance(step, Call) or step.operator == "neg":
            continue
        left, right = step.operands
        one_sign = {left, right} <= positive
        if (step.operator == "*" and left == right) or (step.operator != "-" and one_sign):
            positive.add(step.name)
        if {left, right} <= exact or not zeros.isdisjoint((left, right)) or (step.operator == "+" and one_sign):
            harmless.add(step.name)
    return harmless


def _written(program: Program, doubled: set[Operand]) -> Program:
    """Write the program; a value of twice the digits has a name of its own where it is also taken rounded."""
    rounding = [step for step in program.steps if not _refines(step) and doubled.isdisjoint(step.names)]
    also_rounded = {operand for step in rounding for operand in step.operands} | {*program.outputs}
    fresh = fresh_names(program.names)
    wide: dict[Operand, Operand] = {}
    steps: list[Step | Call] = []

    def widened(operand: Operand) -> Operand:
        if operand in wide:
            return wide[operand]
        name = next(fresh)
        steps.append(Step(name, "wide", (operand,)))
        return name

    def operands_of(step: Step) -> tuple[Operand, ...]:
        first: Operand = next((operand for operand in step.operands if isinstance(operand, str)), step.operands[0])
        replaced = {first: widened(first)} if doubled.isdisjoint(step.operands) else wide
        return tuple(replaced.get(operand, operand) for operand in step.operands)

    for step in program.steps:
        names = step.names
        if doubled.isdisjoint(names) and not _refines(step):
            steps.append(step)
            continue
        if isinstance(step, Call) and _refines(step):
            rows = tuple(tuple(wide.get(operand, operand) for operand in row) for row in step.rows)
            steps.append(Call(names, step.primitive, rows))
            continue
        pairs = tuple(next(fresh) if name in also_rounded else name for name in names)
        wide |= dict(zip(names, pairs, strict=True))
        if isinstance(step, Call):
            steps.append(Call(pairs, step.primitive, tuple(tuple(map(widened, row)) for row in step.rows)))
        else:
            steps.append(Step(pairs[0], step.operator, operands_of(step)))
        steps += [Step(n, "rounded", (pair,)) for n, pair in zip(names, pairs, strict=True) if n != pair]
    return Program(program.inputs, tuple(steps), program.outputs)
