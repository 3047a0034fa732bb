"""The table of accuracy.md, from the figures that ``algebroproj verify --out generated`` has written."""

import json
from pathlib import Path
from typing import Any

_FIGURES = Path(__file__).resolve().parent.parent / "generated" / "accuracy.json"
_MARKER = "[figures]"
_KEYS = ("median_ulp", "thousandth_ulp", "max_ulp")
_HEADS = ("median", "99.9 %", "largest")


def on_page_markdown(text: str, **_: Any) -> str:
    """Put the table where a page wants it."""
    return text.replace(_MARKER, _table()) if _MARKER in text else text


def _table() -> str:
    functions = json.loads(_FIGURES.read_text(encoding="utf-8"))["functions"]
    heads = ["function", "stratum", "samples", *_HEADS, *(f"plain: {head}" for head in _HEADS)]
    lines = [f"| {' | '.join(heads)} |", f"|---|---|{'--:|' * (len(heads) - 2)}"]
    for function in functions:
        name, plain = f"`{function['function']}`", function["plain"]
        lines.append(_row(name, {**function["all"], "name": "all"}, plain["all"]))
        lines += [_row("", *both) for both in zip(function["strata"], plain["strata"], strict=True)]
    return "\n".join(lines)


def _row(function: str, figures: dict[str, Any], plain: dict[str, Any]) -> str:
    name = figures["name"] if len(figures["name"]) <= 60 else f"{figures['name'][:57]}..."
    values = " | ".join(f"{each[key]:.3g}" for each in (figures, plain) for key in _KEYS)
    return f"| {function} | {name.replace('*', '·')} | {figures['samples']} | {values} |"
