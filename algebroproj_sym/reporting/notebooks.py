"""Derivation modules as notebooks that have been run from top to bottom, each in a kernel of its own."""

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from algebroproj_sym.declaring import Derivation, import_root
from algebroproj_sym.showing.notebook import METADATA

CELL_SECONDS = 600
"""Time limit of a cell."""


class NotebookError(ValueError):
    """A derivation does not run as a notebook, or its cells do not show all its claims."""


@dataclass(frozen=True)
class Notebook:
    """A derivation and its cells.

    They are cells of the notebook format, version 4, with outputs.
    """

    module: str
    cells: tuple[Any, ...]


def run_notebook(derivation: Derivation) -> Notebook:
    """Run a derivation as Jupyter does, and keep what its cells show.

    It raises `NotebookError` if a cell fails, or a claim is not shown.
    """
    import jupytext
    from jupyter_client.kernelspec import KernelSpecManager
    from jupyter_client.manager import AsyncKernelManager
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError

    notebook = jupytext.read(derivation.path)
    specifications = KernelSpecManager(kernel_dirs=[])
    kernel = AsyncKernelManager(kernel_name="python3", kernel_spec_manager=specifications)
    client = NotebookClient(
        notebook,
        km=kernel,
        timeout=CELL_SECONDS,
        iopub_timeout=CELL_SECONDS,
        extra_arguments=["--log-level=ERROR"],
        resources={"metadata": {"path": str(derivation.path.parent)}},
    )
    try:
        client.execute(env=_environment(derivation.path), cleanup_kc=True)
    except CellExecutionError as error:
        place, cell = _failing(notebook.cells)
        first = cell.source.strip().partition("\n")[0]
        raise NotebookError(
            f"{derivation.path}: cell {place}, which begins with {first!r}, fails: {error.ename}: {error.evalue}"
        ) from error
    except (CellTimeoutError, DeadKernelError) as error:
        raise NotebookError(f"{derivation.path}: {error}") from error
    cells = tuple(cell for cell in notebook.cells if cell.source.strip())
    _require_claims(derivation, cells)
    return Notebook(derivation.module, cells)


def claim_of(output: Any) -> str | None:
    """Return the number of the claim that an output of a cell shows, if it shows one."""
    shown = output.get("metadata", {}).get(METADATA)
    return None if shown is None else str(shown["claim"])


def _failing(cells: Sequence[Any]) -> tuple[int, Any]:
    """Return the first cell whose output is an error, and its place."""
    return next(
        (place, cell)
        for place, cell in enumerate((cell for cell in cells if cell.source.strip()), 1)
        if any(output.output_type == "error" for output in cell.get("outputs", ()))
    )


def _environment(path: Path) -> dict[str, str]:
    """Return an environment in which a module finds its package."""
    paths = [str(import_root(path)), *filter(None, [os.environ.get("PYTHONPATH")])]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(paths), "PYTHONDONTWRITEBYTECODE": "1"}


def _require_claims(derivation: Derivation, cells: tuple[Any, ...]) -> None:
    shown = [claim_of(output) for cell in cells for output in cell.get("outputs", ())]
    missing = [claim.number for claim in derivation.section.claims if claim.number not in shown]
    if missing:
        raise NotebookError(f"{derivation.path}: expected cells that show all claims, none shows {', '.join(missing)}")
