"""Printing the elimination of linear equations of fixed size as C, unrolled and without branches.

A compiler can then solve several systems at once.  The operations and their order are those of ``solve`` and
``null_vector`` in the NumPy source: partial pivoting, and one step of refinement with the residual in twice the
precision.  Of a row ``a0_`` of the equations the entries are ``a0_0``, ``a0_1``, ...
"""

from __future__ import annotations

from collections.abc import Sequence


def solve_body(size: int) -> list[str]:
    r"""Return the statements that solve ``system``, rows of coefficients and right side, into ``solution``.

    Examples
    --------
    >>> print(*solve_body(1)[:4], sep="\n")
    real a0_0 = system[0][0];
    real b0 = system[0][1];
    real kept;
    const real x0 = b0 / a0_0;
    """
    return [
        *(f"real a{i}_{j} = system[{i}][{j}];" for i in range(size) for j in range(size)),
        *(f"real b{i} = system[{i}][{size}];" for i in range(size)),
        "real kept;",
        *_eliminated(size, size, "b"),
        *_upper_solved("x", "b", size),
        *_residual([f"system[{i}][{size}]" for i in range(size)], size),
        *_forward(size, "r"),
        *_upper_solved("d", "r", size),
        *_refined(size),
        *(f"solution[{k}] = y{k};" for k in range(size)),
    ]


def null_vector_body(height: int) -> list[str]:
    r"""Return the statements that span the null space of ``system``, rows with one entry more than rows.

    The columns are eliminated; the combination of columns that is left as zero is the vector.

    Examples
    --------
    >>> print(*null_vector_body(1)[:5], sep="\n")
    real a0_0 = system[0][0];
    real a1_0 = system[0][1];
    const real zero = system[0][0] * 0;
    real kept;
    const int swap0_1 = isgreater(absolute(a1_0), absolute(a0_0));
    """
    width = height + 1
    return [
        *(f"real a{j}_{i} = system[{i}][{j}];" for j in range(width) for i in range(height)),
        "const real zero = system[0][0] * 0;",
        "real kept;",
        *_eliminated(width, height),
        *_combined("x", [*["zero"] * height, "zero + 1"], height),
        *_residual(["zero"] * height, width),
        *_lower_solved("u", "r", height),
        *_combined("d", [*(f"u{k}" for k in range(height)), "zero"], height),
        *_refined(width),
        "real largest = y0;",
        *(f"largest = isgreater(absolute(y{k}), absolute(largest)) ? y{k} : largest;" for k in range(1, width)),
        *(f"solution[{k}] = y{k} / largest;" for k in range(width)),
    ]


def _eliminated(height: int, steps: int, right_side: str = "") -> list[str]:
    """Eliminate below the diagonal, and keep the exchanges of rows and the factors."""
    lines = []
    for k in range(steps):
        below = range(k + 1, height)
        for i in below:
            lines.append(f"const int swap{k}_{i} = isgreater(absolute(a{i}_{k}), absolute(a{k}_{k}));")
            for j in range(k, steps):
                lines += _exchanged(f"swap{k}_{i}", f"a{k}_{j}", f"a{i}_{j}")
            if right_side:
                lines += _exchanged(f"swap{k}_{i}", f"{right_side}{k}", f"{right_side}{i}")
        lines += [f"const real f{k}_{i} = a{i}_{k} / a{k}_{k};" for i in below]
        lines += [f"a{i}_{j} = a{i}_{j} - f{k}_{i} * a{k}_{j};" for i in below for j in range(k + 1, steps)]
        if right_side:
            lines += [f"{right_side}{i} = {right_side}{i} - f{k}_{i} * {right_side}{k};" for i in below]
    return lines


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


def _lower_solved(unknown: str, right_side: str, size: int) -> list[str]:
    """Substitute forwards in the transposed system."""
    lines = []
    for k in range(size):
        lines += [f"{right_side}{k} = {right_side}{k} - a{j}_{k} * {unknown}{j};" for j in range(k)]
        lines.append(f"const real {unknown}{k} = {right_side}{k} / a{k}_{k};")
    return lines


def _forward(size: int, right_side: str) -> list[str]:
    """Do to a right side what elimination did to the rows."""
    lines = []
    for k in range(size):
        for i in range(k + 1, size):
            lines += _exchanged(f"swap{k}_{i}", f"{right_side}{k}", f"{right_side}{i}")
        lines += [f"{right_side}{i} = {right_side}{i} - f{k}_{i} * {right_side}{k};" for i in range(k + 1, size)]
    return lines


def _combined(name: str, weights: Sequence[str], steps: int) -> list[str]:
    """Compute the combination of the rows before elimination that is this one of the rows after it."""
    lines = [f"real {name}{k} = {weight};" for k, weight in enumerate(weights)]
    for k in reversed(range(steps)):
        below = range(k + 1, len(weights))
        lines += [f"{name}{k} = {name}{k} - f{k}_{i} * {name}{i};" for i in below]
        for i in reversed(below):
            lines += _exchanged(f"swap{k}_{i}", f"{name}{k}", f"{name}{i}")
    return lines


def _residual(right_sides: Sequence[str], width: int) -> list[str]:
    """Compute right side minus matrix times unknowns, the sum of each row and its rounding errors apart."""
    lines = []
    for i, right_side in enumerate(right_sides):
        lines += [f"real h{i} = {right_side};", f"real l{i} = 0;"]
        for j in range(width):
            at = f"{i}_{j}"
            lines += [
                f"const real p{at} = system[{i}][{j}] * x{j};",
                f"const real e{at} = NAME(product_error)(system[{i}][{j}], x{j}, p{at});",
                f"const real s{at} = h{i} + -p{at};",
                f"l{i} = l{i} + (NAME(sum_error)(h{i}, -p{at}, s{at}) - e{at});",
                f"h{i} = s{at};",
            ]
        lines.append(f"real r{i} = h{i} + l{i};")
    return lines


def _refined(size: int) -> list[str]:
    """Add the correction wherever that is finite."""
    lines = []
    for k in range(size):
        lines.append(f"const real z{k} = x{k} + d{k};")
        lines.append(f"const real y{k} = z{k} - z{k} == 0 ? z{k} : x{k};")
    return lines
