"""Writing files: all of them whole, or none of them at all."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import FrameType


def write_texts(files: Mapping[str, str], folder: Path) -> None:
    """Write text files.

    Whatever goes wrong, an interruption too, the folder has either all files as they were or all new ones.

    Parameters
    ----------
    files : mapping of str to str
        The text of each file by its path in the folder.
    folder : Path
        Where to write them; it, and folders in it, are made if they do not exist.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     write_texts({"a.txt": "one", "b.txt": "two"}, Path(folder))
    ...     sorted(path.name for path in Path(folder).iterdir())
    ['a.txt', 'b.txt']
    """
    targets = {name: folder / name for name in files}
    for parent in {folder, *(target.parent for target in targets.values())}:
        parent.mkdir(parents=True, exist_ok=True)
    temporaries = {name: target.with_name(f".{target.name}.partial") for name, target in targets.items()}
    try:
        for name, temporary in temporaries.items():
            temporary.write_text(files[name], encoding="utf-8")
        with _interrupts_later():
            for name, temporary in temporaries.items():
                temporary.replace(targets[name])
    finally:
        for temporary in temporaries.values():
            temporary.unlink(missing_ok=True)


@contextmanager
def _interrupts_later() -> Iterator[None]:
    """Answer Ctrl-C at the end of the block; only the main thread can."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    caught: list[int] = []

    def remember(number: int, frame: FrameType | None) -> None:
        caught.append(number)

    before = signal.signal(signal.SIGINT, remember)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
        if caught:
            signal.raise_signal(signal.SIGINT)
