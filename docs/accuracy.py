"""The table of accuracy.md, from the figures that ``algebroproj verify --out generated`` has written."""

import json
from pathlib import Path
from typing import Any

_FIGURES = Path(__file__).resolve().parent.parent / "generated" / "accuracy.json"
_MARKER = "[figures]"


def on_page_markdown(text: str, **_: Any) -> str:
    """Put the table where a page wants it."""
    return text.replace(_MARKER, _table()) if _MARKER in text else text


def _table() -> str:
    functions = json.loads(_FIGURES.read_text(encoding="utf-8"))["functions"]
    lines = ["| function | stratum | samples | median | 99.9 % | largest |", "|---|---|--:|--:|--:|--:|"]
    for function in functions:
        lines.append(_row(f"`{function['function']}`", {**function["all"], "name": "all"}))
        lines += [_row("", stratum) for stratum in function["strata"]]
    return "\n".join(lines)


def _row(function: str, figures: dict[str, Any]) -> str:
    name = figures["name"] if len(figures["name"]) <= 60 else f"{figures['name'][:57]}..."
    values = " | ".join(f"{figures[key]:.3g}" for key in ("median_ulp", "thousandth_ulp", "max_ulp"))
    return f"| {function} | {name.replace('*', '·')} | {figures['samples']} | {values} |"
