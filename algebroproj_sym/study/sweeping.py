"""Sweeps: the members of a study in chunks, which can be stopped at any moment and go on later.

A folder holds a sweep: ``manifest.json`` (what is computed, and by what), a file for each chunk that is done, and in
the end one dataset in their place.  A chunk is written under another name and then renamed, so that it is there whole
or not at all; as it is a function of its members, the seed and the options alone, the result does not depend on who
computed it, in which order, or how often the work was stopped.

Each file has a seal beside it: the digests of the manifest and of the file, and which members it has.  A chunk that
does not match its seal is computed again; a result that does not is refused.  While a run writes to the folder, another
one is refused.
"""

import fcntl
import hashlib
import json
import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import islice
from pathlib import Path
from typing import Any, Literal

import numpy as np
import xarray

from algebroproj_sym.files import write_texts
from algebroproj_sym.study.datasets import attributes, join, provenance, read, variable, write
from algebroproj_sym.study.declaration import MEMBER, Indices, Study

MANIFEST = "manifest.json"
CHUNKS = "chunks"
ASSEMBLING = ".assembling"
LOCK = ".lock"
SEAL = ".seal"
SUFFIXES = {"netcdf": ".nc", "zarr": ".zarr"}
Format = Literal["netcdf", "zarr"]


class OtherSweepError(ValueError):
    """A folder holds another sweep than the one that is to be run in it, or a result that is not its own."""


class BusyFolderError(ValueError):
    """Another run writes to a folder."""


@dataclass(frozen=True)
class Sweep:
    """A study with its arguments, in a folder.

    The options are those that are not to have their default values. A chunk has `size` members, by which memory is
    bounded.

    It raises `ValueError` if an argument is out of its range or the study does not accept its options.
    """

    study: Study
    folder: Path
    options: Mapping[str, Any]
    members: int
    size: int = 10_000
    seed: int = 0
    output: Format = "netcdf"

    def __post_init__(self) -> None:
        for name, number, least in (("members", self.members, 1), ("chunk", self.size, 1), ("seed", self.seed, 0)):
            if number < least:
                raise ValueError(f"{name}: expected at least {least}, got {number}")
        if self.output not in SUFFIXES:
            raise ValueError(f"format: expected one of {', '.join(SUFFIXES)}, got {self.output!r}")
        object.__setattr__(self, "options", self.study.arguments(self.options))

    @cached_property
    def manifest(self) -> dict[str, Any]:
        """What the result depends on."""
        return {"arguments": arguments(self), "provenance": provenance(self.study.source)}

    @property
    def count(self) -> int:
        """How many chunks there are."""
        return -(-self.members // self.size)

    @property
    def result(self) -> Path:
        """Where the dataset is in the end."""
        return self.folder / f"{self.study.name}{SUFFIXES[self.output]}"

    def indices(self, chunk: int) -> Indices:
        """Return the members of a chunk."""
        return np.arange(chunk * self.size, min((chunk + 1) * self.size, self.members), dtype=np.int64)

    def path(self, chunk: int) -> Path:
        """Return where a chunk is kept until all are there."""
        return self.folder / CHUNKS / f"{chunk:08d}.nc"


def arguments(sweep: Sweep) -> dict[str, Any]:
    """Return what the result depends on, beside the program: of a file its name and a digest."""
    return {
        "study": sweep.study.name,
        "members": sweep.members,
        "chunk": sweep.size,
        "seed": sweep.seed,
        "format": sweep.output,
        "options": {name: _recorded(value) for name, value in sweep.options.items()},
    }


@contextmanager
def held(folder: Path) -> Iterator[None]:
    """Make a folder, and keep other runs from it until the block or this process ends.

    It raises `BusyFolderError` if another run has it.  It raises `OSError` if the folder cannot be written to.
    """
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / LOCK).open("a") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            message = f"{folder}: another run writes to this folder. Wait until it has ended, or choose another folder"
            raise BusyFolderError(message) from error
        yield


def prepare(sweep: Sweep) -> None:
    """Make the folder of a sweep, or find that it holds the same one.

    It raises `OtherSweepError` if the folder holds a sweep with other arguments, one of another version of the program,
    another result, or a folder in the place of a file.  It raises `OSError` if the folder cannot be written to.
    """
    (sweep.folder / CHUNKS).mkdir(parents=True, exist_ok=True)
    path = sweep.folder / MANIFEST
    for file in (path, *sorted((sweep.folder / CHUNKS).iterdir())):
        if file.is_dir():
            raise OtherSweepError(f"{file}: expected a file, found a folder. Choose another folder, or remove it")
    if path.exists():
        _require_equal(path, sweep.manifest)
    if sweep.result.exists() and not _is_sealed(sweep.manifest, sweep.result, range(sweep.members)):
        raise OtherSweepError(
            f"{sweep.result}: this is not what the study has written here, or it is damaged. "
            "Choose another folder, or remove it"
        )
    write_texts({MANIFEST: json.dumps(sweep.manifest, indent=1, sort_keys=True) + "\n"}, sweep.folder)


def missing(sweep: Sweep) -> list[int]:
    """Return the chunks that are not there yet, or not as they were written, in order."""
    if sweep.result.exists():
        return []
    return [
        chunk for chunk in range(sweep.count) if not _is_sealed(sweep.manifest, sweep.path(chunk), sweep.indices(chunk))
    ]


def run(sweep: Sweep, executor: Executor | None = None, window: int = 1) -> Iterator[int]:
    """Compute the chunks that are missing, and yield the number of each when it is kept.

    An executor computes, with `window` chunks under way at once; without one, this process does.  It raises
    `OtherSweepError` if a file that the study reads has changed since the sweep was made.
    """
    if executor is None:
        for chunk in missing(sweep):
            _keep(sweep, chunk, _task(sweep, chunk)())
            yield chunk
        return
    waiting = iter(missing(sweep))
    running: dict[Future[xarray.Dataset], int] = {}
    try:
        while True:
            for chunk in islice(waiting, window - len(running)):
                running[executor.submit(_task(sweep, chunk))] = chunk
            if not running:
                return
            done, _ = wait(running, return_when=FIRST_COMPLETED)
            for task in sorted(done, key=running.__getitem__):
                chunk = running.pop(task)
                _keep(sweep, chunk, task.result())
                yield chunk
    finally:
        for task in running:
            task.cancel()


def computed(
    chunk: Callable[..., xarray.Dataset], indices: Indices, seed: int, options: Mapping[str, Any]
) -> xarray.Dataset:
    """Compute some members of a study by its function, wherever this is called.

    It raises `RuntimeError` if the function gives other members than it was asked for.
    """
    dataset = chunk(indices, seed, **options)
    if MEMBER not in dataset.coords or not np.array_equal(dataset[MEMBER].values, indices):
        raise RuntimeError(f"study: expected the members {indices[0]} to {indices[-1]} in order, got others")
    return dataset.assign_coords({MEMBER: variable([MEMBER], indices, about="number of the member")})


def assemble(sweep: Sweep) -> xarray.Dataset:
    """Make one dataset of all chunks, which are then removed, and open it; its values are read when they are needed.

    It raises `FileNotFoundError` if a chunk is missing, or is not as it was written.  It raises `ValueError` if chunks
    have different variables or units.
    """
    if absent := missing(sweep):
        raise FileNotFoundError(f"{sweep.path(absent[0])}: expected a chunk with its seal, found none")
    if not sweep.result.exists():
        paths = [sweep.path(chunk) for chunk in range(sweep.count)]
        with _emptied(sweep.folder / ASSEMBLING) as folder:
            whole = folder / sweep.result.name
            join(paths, MEMBER, attributes(sweep.study.summary, **sweep.manifest), whole)
            _put(sweep, whole, sweep.result, range(sweep.members))
    for name in (ASSEMBLING, CHUNKS):
        shutil.rmtree(sweep.folder / name, ignore_errors=True)
    return read(sweep.result)


@contextmanager
def _emptied(folder: Path) -> Iterator[Path]:
    """Give an empty folder, whatever a killed run has left there, and remove it in the end."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def finished(folder: Path) -> tuple[str, xarray.Dataset]:
    """Return the name of the study that is done in a folder, by whatever version of the program, and its dataset.

    It raises `OtherSweepError` if none is, or it is damaged.
    """
    try:
        manifest = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
        arguments = manifest["arguments"]
        name, members = str(arguments["study"]), range(arguments["members"])
        result = folder / f"{name}{SUFFIXES[arguments['format']]}"
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise OtherSweepError(f"{folder}: expected a folder of a study with {MANIFEST}, got {error}") from error
    if not members or not _is_sealed(manifest, result, members):
        raise OtherSweepError(f"{result}: expected the dataset as the study wrote it, got none or a damaged one")
    return name, read(result)


def _recorded(value: Any) -> Any:
    if not isinstance(value, Path):
        return value
    return f"{value.name}, sha256 {hashlib.sha256(value.read_bytes()).hexdigest()}"


def _keep(sweep: Sweep, chunk: int, dataset: xarray.Dataset) -> None:
    if arguments(sweep) != sweep.manifest["arguments"]:
        raise OtherSweepError(f"{sweep.folder}: a file that the study reads has changed since the study began")
    path = sweep.path(chunk)
    write(dataset, _unsealed(path))
    _put(sweep, _unsealed(path), path, sweep.indices(chunk))


def _put(sweep: Sweep, written: Path, path: Path, members: Sequence[int] | Indices) -> None:
    """Put what is written in its place; its seal comes first, so that it is never there without one."""
    write_texts({path.name + SEAL: _seal(sweep.manifest, written, members)}, path.parent)
    written.replace(path)


def _is_sealed(manifest: Mapping[str, Any], path: Path, members: Sequence[int] | Indices) -> bool:
    seal = path.with_name(path.name + SEAL)
    return seal.is_file() and seal.read_bytes() == _seal(manifest, path, members).encode()


def _seal(manifest: Mapping[str, Any], path: Path, members: Sequence[int] | Indices) -> str:
    digest = hashlib.sha256()
    for file in sorted(path.rglob("*")) if path.is_dir() else [path]:
        if file.is_file():
            with file.open("rb") as opened:
                digest.update(
                    f"{file.relative_to(path)} {hashlib.file_digest(opened, 'sha256').hexdigest()}\n".encode()
                )
    return json.dumps(
        {
            "sweep": hashlib.sha256(json.dumps(manifest, sort_keys=True).encode()).hexdigest(),
            "members": [int(members[0]), int(members[-1])],
            "content": digest.hexdigest(),
        }
    )


def _unsealed(path: Path) -> Path:
    return path.with_name(f"unsealed-{path.name}")


def _task(sweep: Sweep, chunk: int) -> Callable[[], xarray.Dataset]:
    return partial(computed, sweep.study.chunk, sweep.indices(chunk), sweep.seed, dict(sweep.options))


def _require_equal(path: Path, wanted: Mapping[str, Any]) -> None:
    try:
        before = _flat(json.loads(path.read_text(encoding="utf-8")))
    except (ValueError, AttributeError) as error:
        raise OtherSweepError(f"{path}: this is not the manifest of a study. Choose another folder") from error
    now = _flat(json.loads(json.dumps(wanted)))
    for name in sorted(before.keys() | now.keys()):
        if before.get(name) != now.get(name):
            raise OtherSweepError(
                f"{path.parent}: the study in this folder has {name} = {before.get(name)}, not "
                f"{now.get(name)}. Choose another folder, or remove this one"
            )


def _flat(tree: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    leaves: dict[str, Any] = {}
    for name, value in tree.items():
        leaves |= _flat(value, f"{prefix}{name}.") if isinstance(value, dict) else {f"{prefix}{name}": value}
    return leaves
