"""Writing a folder whole or not at all."""

import os
import shutil
from collections.abc import Mapping
from pathlib import Path
from tempfile import mkdtemp

MARKER = "search-index.js"


class OccupiedError(ValueError):
    """A folder holds something else than an earlier site."""


def require_free(folder: Path) -> None:
    """Make sure that a folder may be replaced.

    It raises `OccupiedError` if it exists, is not empty and is not an earlier site.
    """
    if folder.is_dir() and any(folder.iterdir()) and not (folder / MARKER).is_file():
        raise OccupiedError(f"{folder}: expected a new or empty folder, or an earlier site, got one with other files")


def replace(files: Mapping[str, str | bytes], folder: Path) -> None:
    """Write files to a new folder beside the wanted one, and put it in its place as a whole."""
    require_free(folder)
    target = folder.resolve()
    target.parent.mkdir(parents=True, exist_ok=True)
    working = Path(mkdtemp(prefix=f".{target.name}.", suffix=".partial", dir=target.parent))
    try:
        fresh = working / "new"
        for name, content in files.items():
            path = fresh / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content.encode() if isinstance(content, str) else content)
        if target.exists():
            os.replace(target, working / "old")
        os.replace(fresh, target)
    finally:
        if (working / "old").exists() and not target.exists():
            os.replace(working / "old", target)
        shutil.rmtree(working, ignore_errors=True)
