"""Files: a set of files is written as a whole or not at all, and JSON with a repeated key is refused."""

import json
import signal
import threading
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import Any


class AmbiguousError(ValueError):
    """JSON text says a thing twice, or has what is no number of JSON."""


def strict_json(text: str) -> Any:
    """Return what JSON text stands for.

    It raises `AmbiguousError` if an object has a key twice, or a number is none of JSON, such as NaN.  It raises
    `ValueError` if it is no JSON.

    Examples
    --------
    >>> strict_json('{"a": 1, "a": 2}')
    Traceback (most recent call last):
    ...
    algebroproj_sym.files.AmbiguousError: expected each key of an object once, got 'a' twice
    """
    return json.loads(text, object_pairs_hook=_object, parse_constant=_no_number)


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    keys = Counter(key for key, _ in pairs)
    twice = [key for key, count in keys.items() if count > 1]
    if twice:
        raise AmbiguousError(f"expected each key of an object once, got {twice[0]!r:.80} twice")
    return dict(pairs)


def _no_number(text: str) -> Any:
    raise AmbiguousError(f"expected JSON, got {text}")


def write_texts(files: Mapping[str, str], folder: Path) -> None:
    """Write text files, given by their paths in a folder; it, and folders in it, are made if they do not exist.

    Whatever goes wrong, an interruption too, the folder has either all files as they were or all new ones.

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
