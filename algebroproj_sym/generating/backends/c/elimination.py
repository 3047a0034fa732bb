"""Printing the elimination of linear equations of fixed size as C, unrolled and without branches.

A compiler can then solve several systems at once.  The operations and their order are those of ``solve`` and
``null_vector`` in the NumPy source: partial pivoting, and one step of refinement with the residual in twice the
precision; or those of ``solve_once`` and ``null_vector_once``, without refinement.
"""

from __future__ import annotations

from collections.abc import Sequence


def solve_body(size: int) -> list[str]:
    r"""Return the statements that solve ``system`` into ``solution``.

    A row has the coefficients and the right side, and then what rounding took from each of them.

    Examples
    --------
    >>> print(*solve_body(1)[:4], sep="\n")
    real a0_0 = system[0][0];
    real b0 = system[0][1];
    real kept;
    const real x0 = b0 / a0_0;
    """
    return [
        *_solution(size),
        *_residual([(f"system[{i}][{size}]", f"system[{i}][{2 * size + 1}]") for i in range(size)], size, size),
        *_forward(size, "r"),
        *_upper_solved("d", "r", size),
        *_refined(size),
        *(f"solution[{k}] = y{k};" for k in range(size)),
        *_guards(size, size),
    ]


def null_vector_body(height: int) -> list[str]:
    r"""Return the statements that span the null space of ``system``, which has one column more than rows.

    A row has the entries, and then what rounding took from each of them.

    Examples
    --------
    >>> print(*null_vector_body(1)[:5], sep="\n")
    real a0_0 = system[0][0];
    real a0_1 = system[0][1];
    const real zero = system[0][0] * 0;
    real kept;
    const int swap0_1 = isgreater(absolute(a0_1), absolute(a0_0));
    """
    width = height + 1
    return [
        *_spanning(height),
        *_residual([("zero", "zero")] * height, height, width),
        *_forward(height, "r", exchanged=False),
        *_substituted_in_order("d", [f"r{i}" for i in range(height)], "zero"),
        *_refined(width),
        *_scaled("y", width),
        *_guards(height, width),
    ]


def solve_once_body(size: int) -> list[str]:
    r"""Return the statements that solve ``system`` into ``solution`` without refinement.

    Examples
    --------
    >>> print(*solve_once_body(1), sep="\n")
    real a0_0 = system[0][0];
    real b0 = system[0][1];
    real kept;
    const real x0 = b0 / a0_0;
    solution[0] = x0;
    """
    return [*_solution(size), *(f"solution[{k}] = x{k};" for k in range(size))]


def null_vector_once_body(height: int) -> list[str]:
    """Return the statements that span the null space of ``system`` without refinement."""
    return [*_spanning(height), *_scaled("x", height + 1)]


def _solution(size: int) -> list[str]:
    """Eliminate and substitute."""
    return [
        *(f"real a{i}_{j} = system[{i}][{j}];" for i in range(size) for j in range(size)),
        *(f"real b{i} = system[{i}][{size}];" for i in range(size)),
        "real kept;",
        *_eliminated(size, "b"),
        *_upper_solved("x", "b", size),
    ]


def _spanning(height: int) -> list[str]:
    """Eliminate and substitute, beginning with one for the last unknown."""
    return [
        *(f"real a{i}_{j} = system[{i}][{j}];" for i in range(height) for j in range(height + 1)),
        "const real zero = system[0][0] * 0;",
        "real kept;",
        *_columns_pivoted(height),
        *_substituted_in_order("x", ["zero"] * height, "zero + 1"),
    ]


def _scaled(component: str, width: int) -> list[str]:
    """Divide a vector by its largest component."""
    return [
        f"real largest = {component}0;",
        *(
            f"largest = isgreater(absolute({component}{k}), absolute(largest)) ? {component}{k} : largest;"
            for k in range(1, width)
        ),
        *(f"solution[{k}] = {component}{k} / largest;" for k in range(width)),
    ]


def _eliminated(size: int, right_side: str) -> list[str]:
    """Eliminate below the diagonal, with the largest entry of a column on it; keep the exchanges and the factors."""
    lines = []
    for k in range(size):
        below = range(k + 1, size)
        for i in below:
            lines.append(f"const int swap{k}_{i} = isgreater(absolute(a{i}_{k}), absolute(a{k}_{k}));")
            for j in range(k, size):
                lines += _exchanged(f"swap{k}_{i}", f"a{k}_{j}", f"a{i}_{j}")
            lines += _exchanged(f"swap{k}_{i}", f"{right_side}{k}", f"{right_side}{i}")
        lines += _taken_off(k, size, size)
        lines += [f"{right_side}{i} = {right_side}{i} - f{k}_{i} * {right_side}{k};" for i in below]
    return lines


def _columns_pivoted(height: int) -> list[str]:
    """Eliminate below the diagonal, with the largest entry of a row on it; keep the exchanges and the factors."""
    lines = []
    for k in range(height):
        for j in range(k + 1, height + 1):
            lines.append(f"const int swap{k}_{j} = isgreater(absolute(a{k}_{j}), absolute(a{k}_{k}));")
            for i in range(k, height):
                lines += _exchanged(f"swap{k}_{j}", f"a{i}_{k}", f"a{i}_{j}")
        lines += _taken_off(k, height, height + 1)
    return lines


def _taken_off(k: int, height: int, width: int) -> list[str]:
    """Take multiples of a row off the rows below it."""
    below = range(k + 1, height)
    lines = [f"const real f{k}_{i} = a{i}_{k} / a{k}_{k};" for i in below]
    return lines + [f"a{i}_{j} = a{i}_{j} - f{k}_{i} * a{k}_{j};" for i in below for j in range(k + 1, width)]


def _exchanged(condition: str, first: str, second: str) -> list[str]:
    return [
        f"kept = {first};",
        f"{first} = {condition} ? {second} : {first};",
        f"{second} = {condition} ? kept : {second};",
    ]


def _upper_solved(unknown: str, right_side: str, size: int) -> list[str]:
    """Substitute backwards."""
    lines = []
    for k in reversed(range(size)):
        lines += [f"{right_side}{k} = {right_side}{k} - a{k}_{j} * {unknown}{j};" for j in range(k + 1, size)]
        lines.append(f"const real {unknown}{k} = {right_side}{k} / a{k}_{k};")
    return lines


def _forward(size: int, right_side: str, exchanged: bool = True) -> list[str]:
    """Do to a right side what elimination did to the rows."""
    lines = []
    for k in range(size):
        for i in range(k + 1, size if exchanged else 0):
            lines += _exchanged(f"swap{k}_{i}", f"{right_side}{k}", f"{right_side}{i}")
        lines += [f"{right_side}{i} = {right_side}{i} - f{k}_{i} * {right_side}{k};" for i in range(k + 1, size)]
    return lines


def _substituted_in_order(unknown: str, right_sides: Sequence[str], last: str) -> list[str]:
    """Substitute backwards, the last unknown being given, and put the unknowns where their columns were."""
    height = len(right_sides)
    lines = [f"real {unknown}{height} = {last};"]
    for k in reversed(range(height)):
        right_of = range(k + 1, height + 1)
        lines.append(f"real {unknown}{k} = {right_sides[k]};")
        lines += [f"{unknown}{k} = {unknown}{k} - a{k}_{j} * {unknown}{j};" for j in right_of]
        lines.append(f"{unknown}{k} = {unknown}{k} / a{k}_{k};")
        for j in reversed(right_of):
            lines += _exchanged(f"swap{k}_{j}", f"{unknown}{k}", f"{unknown}{j}")
    return lines


def _residual(right_sides: Sequence[tuple[str, str]], height: int, unknowns: int) -> list[str]:
    """Compute right side minus matrix times unknowns, the sum of each row and its rounding errors apart."""
    lines = []
    for i, (high, low) in enumerate(right_sides):
        lines += [f"real h{i} = {high};", f"real l{i} = {low};"]
        for j in range(unknowns):
            at, entry, rest = f"{i}_{j}", f"system[{i}][{j}]", f"system[{i}][{height + 1 + j}]"
            lines += [
                f"const real p{at} = {entry} * x{j};",
                f"const real e{at} = product_error({entry}, x{j}, p{at}) + {rest} * x{j};",
                f"const real s{at} = h{i} + -p{at};",
                f"l{i} = l{i} + (NAME(sum_error)(h{i}, -p{at}, s{at}) - e{at});",
                f"h{i} = s{at};",
            ]
        lines.append(f"real r{i} = h{i} + l{i};")
    return lines


def _guards(height: int, unknowns: int) -> list[str]:
    """Keep the range of the operands of products whose errors are taken."""
    operands = [f"system[{i}][{j}]" for i in range(height) for j in range(unknowns)]
    operands += [f"x{j}" for j in range(unknowns)]
    return [*(f"range = within(range, {operand});" for operand in operands), "return range;"]


def _refined(size: int) -> list[str]:
    """Add the correction wherever that is finite."""
    lines = []
    for k in range(size):
        lines.append(f"const real z{k} = x{k} + d{k};")
        lines.append(f"const real y{k} = z{k} - z{k} == 0 ? z{k} : x{k};")
    return lines
