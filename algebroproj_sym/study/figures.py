"""The one style of all figures: for print, in colours that the colour-blind can tell apart, with lines that differ."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib
from cycler import cycler
from matplotlib.figure import Figure

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000")
"""The palette of Okabe and Ito, which differs in lightness as well, in the order of use."""

DASHES: tuple[Any, ...] = ("-", (0, (5, 1.5)), (0, (1.5, 1.2)), (0, (6, 1.5, 1.5, 1.5)))
"""Lines that can be told apart without colours, in the order of use."""

MAP = "cividis"
"""Of heat maps: its lightness grows evenly, and the colour-blind see the same."""

INK, GREY = "#1b1d21", "#7a828e"
COLUMN, PAGE = 3.5, 7.2
"""Widths in inches of one column and of a page."""

STYLE: Any = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 8,
    "axes.titlesize": 9,
    "axes.titlelocation": "left",
    "axes.labelsize": 8,
    "axes.labelcolor": INK,
    "axes.edgecolor": GREY,
    "axes.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.prop_cycle": cycler(color=COLOURS),
    "grid.color": "#e3e6ea",
    "grid.linewidth": 0.5,
    "image.cmap": MAP,
    "lines.linewidth": 1.4,
    "legend.frameon": False,
    "legend.fontsize": 7.5,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "figure.dpi": 100,
    "savefig.dpi": 220,
    "pdf.fonttype": 42,
    "svg.fonttype": "none",
    "svg.hashsalt": "algebroproj",
    "mathtext.fontset": "dejavusans",
}
FORMATS: Mapping[str, Mapping[str, str | None]] = {
    "png": {"Software": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}
"""What is written for each figure, without what would differ from run to run."""


@contextmanager
def style() -> Iterator[None]:
    """Draw in the shared style within the block."""
    with matplotlib.rc_context(STYLE):
        yield


def figure(width: float = PAGE, height: float = 3.2) -> Figure:
    """Return an empty figure, in inches; call it within `style`.

    Examples
    --------
    >>> with style():
    ...     figure(COLUMN, 2.0).get_size_inches().tolist()
    [3.5, 2.0]
    """
    return Figure(figsize=(width, height), layout="constrained")


def save(figures: Mapping[str, Figure], folder: Path) -> list[Path]:
    """Write each figure in each of `FORMATS`, and return the files.

    It raises `OSError` if a file cannot be written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    with style():
        for name, drawing in figures.items():
            for suffix, metadata in FORMATS.items():
                path, temporary = folder / f"{name}.{suffix}", folder / f".{name}.{suffix}.partial"
                drawing.savefig(temporary, format=suffix, metadata=dict(metadata))
                temporary.replace(path)
                paths.append(path)
    return paths
