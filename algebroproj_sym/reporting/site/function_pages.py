"""The page of a generated function, and the list of all of them."""

import ast
from collections.abc import Mapping, Sequence
from dataclasses import replace
from textwrap import shorten
from typing import Any

from markupsafe import Markup

from algebroproj_sym.declaring import ELEMENTARY, Kernel, Stage
from algebroproj_sym.expressions import entries
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.operation_counts import derived_operations
from algebroproj_sym.generating.writing import PACKAGE
from algebroproj_sym.reporting.site.addresses import FUNCTIONS
from algebroproj_sym.reporting.site.catalogue import Catalogue, Entry, Function
from algebroproj_sym.reporting.site.formulas import block, equation, inline
from algebroproj_sym.reporting.site.plots import accuracy_plot, distance_plot
from algebroproj_sym.reporting.site.tables import Table
from algebroproj_sym.reporting.site.templating import page
from algebroproj_sym.showing.latex import latex
from algebroproj_sym.verifying.accuracy import BOUND, Accuracy, Stratum
from algebroproj_sym.verifying.verification import Verification

_MEANINGS = {
    "solve": "solve the linear system with this matrix. Its last column is the right side:",
    "null_vector": "span the null space of this matrix, scaled so that the largest component is 1:",
    **{name: primitive.meaning for name, primitive in ELEMENTARY.items()},
}


def functions_of(
    lowered: Sequence[Lowered], verified: Sequence[Verification], package: Mapping[str, str]
) -> tuple[Function, ...]:
    """Return the functions with their figures, and their source in the files of the generated package."""
    return tuple(
        Function(low, figures, _source(package[f"{low.kernel.module}.py"], low.kernel.name))
        for low, figures in zip(lowered, verified, strict=True)
    )


def _source(module: str, name: str) -> str:
    found = next(n for n in ast.parse(module).body if isinstance(n, ast.FunctionDef) and n.name == name)
    return ast.get_source_segment(module, found) or ""


LONGEST_NAME = 48
"""Characters of the name of a stratum; a longer factor stands whole among those that must not vanish."""


def function_files(catalogue: Catalogue) -> dict[str, str]:
    """Return a page for each function, and the list."""
    files = {f.page: _page(catalogue, f) for f in catalogue.functions}
    files[FUNCTIONS] = page("functions", FUNCTIONS, catalogue=catalogue, bound=f"{BOUND:g}")
    return files


def _page(catalogue: Catalogue, function: Function) -> str:
    low = function.lowered
    kernel = low.kernel
    figures = function.verification
    strata = [replace(s, name=shorten(s.name, LONGEST_NAME, placeholder=" …")) for s in figures.accuracy.strata]
    accuracy = replace(figures.accuracy, strata=tuple(strata))
    return page(
        "function",
        function.page,
        catalogue=catalogue,
        function=function,
        kernel=kernel,
        signature=f"{PACKAGE}.{kernel.qualified_name}({', '.join(a.name for a in kernel.arguments)})",
        arguments=_arguments(kernel),
        results=[(result.name, _batched(result.shape)) for result in kernel.results],
        formulas=formulas_of(kernel),
        singular=low.hypotheses,
        claims=[(number, _claim(catalogue, kernel, number)) for number in kernel.claims],
        figures=figures,
        accuracy=_accuracy(accuracy),
        plot=accuracy_plot(accuracy),
        near=[(stratum.name, distance_plot(stratum)) for stratum in strata if stratum.near],
        operations=_operations(low),
        bound=f"{BOUND:g}",
    )


def _claim(catalogue: Catalogue, kernel: Kernel, number: str) -> Entry | None:
    return catalogue.by_number.get((kernel.paper, number))


def _batched(shape: tuple[int, ...]) -> str:
    return f"({', '.join(['...', *map(str, shape)])})"


def _arguments(kernel: Kernel) -> Table:
    rows = [
        (Markup("<code>{}</code>").format(a.name), _batched(a.shape), kernel.described[a.name], _entries(a.entries))
        for a in kernel.arguments
    ]
    return Table("Arguments", ("name", "shape", "meaning", "entries"), rows)


def _entries(expression: Any) -> Markup:
    return inline(expression, most=60) or Markup("entries")


def formulas_of(kernel: Kernel) -> list[Markup]:
    """Return how the results are computed: values on the way, abbreviations, results."""
    lines = [line for stage in kernel.stages for line in _stage(stage)]
    lines += [equation(latex(symbol), expression) for symbol, expression in kernel.where]
    return lines + [equation(rf"\text{{{result.name}}}", result.form) for result in kernel.results]


def _stage(stage: Stage) -> list[Markup]:
    if stage.primitive == "let":
        return [equation(latex(s), entry) for s, entry in zip(stage.results, entries(stage.form), strict=True)]
    names = Markup(", ").join(inline(symbol) or Markup() for symbol in stage.results)
    return [Markup("<p>{} {}</p>{}").format(names, _MEANINGS[stage.primitive], block(stage.form))]


def _accuracy(accuracy: Accuracy) -> Table:
    rows = [(s.name, *_figures(s)) for s in accuracy.strata]
    rows.append(("all", *_figures(accuracy.overall)))
    headings = ("stratum", "samples", "median ULP", "largest ULP", "largest error/(cond u)", "undetermined")
    return Table("Errors against 50 digits of the derivation", headings, rows, numeric=True)


def _figures(stratum: Stratum) -> tuple[str, ...]:
    return (
        str(stratum.samples),
        f"{stratum.median_ulp:.2f}",
        f"{stratum.max_ulp:.3g}",
        f"{stratum.max_ratio:.2f}",
        str(stratum.undetermined),
    )


def _operations(low: Lowered) -> Table:
    by_kind = low.plain.operations()
    listed = ", ".join(f"{count} {kind}" for kind, count in sorted(by_kind.items(), key=str) if count)
    rows = [
        ("the derived expression as written", str(derived_operations(low.kernel)), ""),
        ("the generated program", str(by_kind.total()), listed),
    ]
    return Table("Operations", ("of", "count", "which"), rows)
