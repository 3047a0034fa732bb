"""Measured errors, which the documentation of the functions tells: ``accuracy.json`` in the package has them."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from textwrap import wrap
from types import ModuleType
from typing import Any

from .evaluation import parts_of

__all__ = ["tell_errors"]

ELSEWHERE = "Other input may lose all digits without a warning: `algebroproj.bounds` tells the error at a point."
"""What samples do not show."""

_EXAMPLES = re.compile(r"\n\n( *)Examples\n")


def tell_errors(record: Path, modules: Iterable[ModuleType]) -> None:
    """Write the errors that a file records into the docstrings of generated functions, if there is such a file."""
    if not record.is_file():
        return
    functions = json.loads(record.read_text(encoding="utf-8"))["functions"]
    figures = {entry["function"]: entry for entry in functions}
    for module in modules:
        for name in module.__all__:
            function = getattr(module, name)
            entry = figures.get(f"{module.__name__.rpartition('.')[2]}.{name}")
            if entry is not None and function.__doc__:
                _, body = parts_of(function, "tell_errors")
                backward = not {"solve", "null_vector"}.isdisjoint(body.__code__.co_names)
                function.__doc__ = _with(function.__doc__, sentences(entry, backward))


def sentences(entry: Mapping[str, Any], backward: bool) -> list[str]:
    """Return what a docstring says of an entry of the record; of a function that solves a linear system, the ratio.

    Examples
    --------
    >>> figures = {"samples": 100, "median_ulp": 0.25, "max_ulp": 0.75, "max_ratio": 1.5}
    >>> sentences({"all": figures}, False)[0]
    'Measured error in float64: 0.25 ULP in the median, at most 0.75 ULP (100 samples, some near singularities).'
    """
    figures = entry["all"]
    ratio = f"{figures['max_ratio']} times what rounding the arguments changes"
    largest = ratio if backward else f"{figures['max_ulp']} ULP"
    errors = f"{figures['median_ulp']} ULP in the median, at most {largest}"
    text = [f"Measured error in float64: {errors} ({figures['samples']} samples, some near singularities)."]
    if "plain" in entry:
        everywhere = entry["plain"]["all"]
        ordinary = next(stratum for stratum in entry["plain"]["strata"] if stratum["name"] == "ordinary")
        largest = (
            f"at most {ordinary['max_ulp']:.3g} ULP on ordinary input, {everywhere['max_ulp']:.3g} ULP on all samples"
        )
        text.append(f"Without compensation (`plain`): {everywhere['median_ulp']} ULP in the median; {largest}.")
    return [*text, ELSEWHERE]


def _with(docstring: str, text: Iterable[str]) -> str:
    """Return a docstring with a paragraph before its examples."""
    place = _EXAMPLES.search(docstring)
    assert place is not None
    lines = [line for sentence in text for line in wrap(sentence, 112)]
    paragraph = "\n".join(place[1] + line for line in lines)
    return f"{docstring[: place.start()]}\n\n{paragraph}{docstring[place.start() :]}"
