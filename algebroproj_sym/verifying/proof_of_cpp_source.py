"""Proving C++ source: executed on rational functions, it must give the derivation, as the C source must.

The body of a function is C but for its head, the list that it returns and the array it lets a solution be written to.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import sympy

from algebroproj_sym.declaring import LINEAR, Kernel
from algebroproj_sym.generating.backends.cpp import declaration, in_double, is_written
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.verifying.c_execution import Meaning, NotUnderstoodError, Source, body_values
from algebroproj_sym.verifying.proof_of_c_source import is_proved, product_errors_are_proved, solver_is_proved

_COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
_FUNCTION = re.compile(
    r"((?:^template <typename real>\nstruct \w+ \{\n[^}]*\};\n\s*)?"
    r"^template <typename real>\n(?:constexpr|inline) [^\n]*? (\w+)\([^\n]*\))\n(\{\n.*?^\})",
    re.DOTALL | re.MULTILINE,
)
_FRAME = re.compile(
    r'#pragma once|#include "(arithmetic|elementary|systems)\.hpp"|namespace [\w:]+ \{|using namespace arithmetic;|\}'
)
_RETURN = re.compile(r"return \{((?:-?\w+(?:, )?)+)\};\s*\}$")
_SYSTEM = re.compile(r"const real \(&system\)\[(\d+)\]\[(\d+)\], real \(&solution\)\[(\d+)\]\)$")
_ERROR = (
    "constexpr real product_error(const std::common_type_t<real> a, const std::common_type_t<real> b, const real p)"
)


@dataclass(frozen=True)
class Header:
    """The functions of a header: what stands before each, and its body."""

    heads: Mapping[str, str]
    bodies: Mapping[str, str]


def header_of(text: str) -> Header:
    """Take a header apart into its functions.

    It raises `NotUnderstoodError` if there is anything else in it, or a function twice.
    """
    bare = _COMMENT.sub("", text)
    found = _FUNCTION.findall(bare)
    rest = [
        line for line in _FUNCTION.sub("", bare).splitlines() if line.strip() and not _FRAME.fullmatch(line.strip())
    ]
    names = [name for _, name, _ in found]
    if rest or len(names) != len({*names}):
        raise NotUnderstoodError(f"C++ source: expected nothing but functions, each once, got {rest[:1] or names}")
    return Header({name: head for head, name, _ in found}, {name: body for _, name, body in found})


def cpp_source_is_proved(lowered: Lowered, files: Mapping[str, str]) -> bool:
    """Whether the C++ source of a kernel, executed on rational functions, is identical to the derivation.

    A kernel that is left out counts as proved.
    """
    if not is_written(lowered):
        return True
    kernel = lowered.kernel
    try:
        header, systems = header_of(files[f"{kernel.module}.hpp"]), _solvers(header_of(files["systems.hpp"]))
        errors = Source({}, {}, {"split_product_error": _product_error(files["arithmetic.hpp"])})
        called = [(stage.primitive, stage.derived.rows) for stage in kernel.stages if stage.primitive in LINEAR]
        solved = all(solver_is_proved(systems, primitive, height) for primitive, height in called)
        return solved and product_errors_are_proved(errors) and function_is_proved(kernel, header)
    except (NotUnderstoodError, KeyError):
        return False


def function_is_proved(kernel: Kernel, header: Header) -> bool:
    """Whether a function gives the derivation, if what it calls solves linear systems and takes errors of products."""
    names, head = declaration(kernel)
    if header.heads[kernel.name].split() != head.split():
        raise NotUnderstoodError(f"{kernel.name}: expected {head}, got {header.heads[kernel.name]}")
    body = re.sub(r"(real solution\d+\[\d+\]) = \{\};", r"\1;", header.bodies[kernel.name])
    returned = _RETURN.search(body)
    if returned is None:
        raise NotUnderstoodError(f"{kernel.name}: expected a list of results at the end")

    def outputs(values: Mapping[sympy.Symbol, Any], meaning: Meaning) -> list[Any]:
        given: dict[str, Any] = {}
        for argument in kernel.arguments:
            entries = iter([values[symbol] for symbol in argument.symbols])
            given[names[argument.name]] = _shaped(entries, argument.shape)
        return body_values(f"{body[: returned.start()]}}}", given, returned[1].split(", "), meaning)

    return is_proved(kernel, outputs, once=False)


def _shaped(entries: Any, shape: tuple[int, ...]) -> Any:
    return [_shaped(entries, shape[1:]) for _ in range(shape[0])] if shape else next(entries)


def _solvers(header: Header) -> Source:
    """Return the functions that solve linear systems, each of which takes the arrays that belong to its name."""
    bodies = {}
    for name, head in header.heads.items():
        height = int(name.rpartition("_")[2])
        width = height + name.startswith("null_vector")
        system = _SYSTEM.search(head)
        if system is None or tuple(map(int, system.groups())) != (height, 2 * height + 2, width):
            raise NotUnderstoodError(f"{name}: expected a system and its solution, got {head}")
        first, narrow, rest = header.bodies[name].partition(
            "".join(f"    {line}\n" for line in in_double(name, height, width))
        )
        if first != "{\n" or not narrow:
            raise NotUnderstoodError(f"{name}: expected systems of narrower numbers to be left to double precision")
        bodies[name] = first + rest
    return Source({}, bodies, {})


def _product_error(text: str) -> str:
    """Return the function for errors of products as C has it, whose splitter is any number."""
    _, found, rest = text.partition(f"template <typename real>\n{_ERROR}\n")
    if not found:
        raise NotUnderstoodError("C++ source: expected a function for errors of products")
    body = rest[: rest.index("\n}") + 2].replace("splitter<real>", "splitter")
    return f"(const real a, const real b, const real p)\n{body}"
