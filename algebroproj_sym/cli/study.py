"""algebroproj study: the ready studies, a command each."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from concurrent.futures import BrokenExecutor, CancelledError, Executor, ProcessPoolExecutor
from contextlib import ExitStack, contextmanager
from errno import EACCES, EDQUOT, EFBIG, ENOSPC, EROFS
from multiprocessing import get_context
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from algebroproj_sym.cli import options
from algebroproj_sym.cli.steps import missing_modules, require_modules
from algebroproj_sym.cli.terminal import console, progressing
from algebroproj_sym.files import write_texts

if TYPE_CHECKING:
    import xarray

    from algebroproj_sym.study import Option, Study
    from algebroproj_sym.study.sweeping import Sweep

MODULES = ("xarray", "h5netcdf", "h5py", "dask", "matplotlib", "scipy")
REQUIREMENT = "algebroproj-sym[study]"
CONNECTING = "10s"
REDRAW = "redraw"
CHUNKS_PER_WORKER = 2
NOT_WRITABLE = (EACCES, EDQUOT, EFBIG, ENOSPC, EROFS)
"""How many chunks are under way for each worker: one is computed while another one is kept."""


class Studies(click.Group):
    """The installed studies, or those of a folder or a file, which are imported when one of them is asked for."""

    path: Path | None = None

    def list_commands(self, context: click.Context) -> list[str]:
        """Return the names of the studies; none if they cannot be imported."""
        return [study.name for study in _studies(self.path)] if not missing_modules(MODULES) else []

    def get_command(self, context: click.Context, name: str) -> click.Command | None:
        """Return the command of a study, or the studies at a path."""
        if context.resilient_parsing and missing_modules(MODULES):
            return None
        require_modules(MODULES, "study", REQUIREMENT)
        named = {study.name: study for study in _studies(self.path)}
        if name == REDRAW:
            return _redrawing(named)
        if name in named:
            return _command(named[name])
        if self.path is None and Path(name).exists():
            return _at(Path(name))
        return None

    def format_commands(self, context: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list of the studies, or how to install what they need."""
        if missing_modules(MODULES):
            formatter.write(f"\nTo see the studies, install what they need:\n  pip install '{REQUIREMENT}'\n")
        else:
            with formatter.section("Commands"):
                formatter.write_dl([(study.name, study.summary) for study in _studies(self.path)])


@click.group(name="study", cls=Studies)
def study_group() -> None:
    """Run a numerical study, and write a dataset, figures and a short report.

    Finished parts are kept.  If a study is stopped, the same command goes on where it was.  The results depend only on
    the options and the seed, not on the number of workers.

    `study redraw FOLDER` writes report and figures of a finished study again.

    In place of a name, give the path of a file or a folder with studies of your own.
    """


def _studies(path: Path | None) -> tuple[Study, ...]:
    from algebroproj_sym.study.discovery import studies

    return studies(path)


def _at(path: Path) -> click.Command:
    """Return the command of the study in a file, or the group of the studies in a folder."""
    found = _studies(path)
    if not found:
        raise click.UsageError(f"study: expected a module that makes a Study named STUDY, got {path}")
    if path.is_file():
        return _command(found[0])
    group = Studies(str(path), help=f"The studies in {path}.")
    group.path = path
    return group


def _command(study: Study) -> click.Command:
    def callback(**given: Any) -> None:
        _run(study, **given)

    own = [_parameter(option) for option in study.options]
    return click.Command(study.name, callback=callback, params=[*own, *_shared(study)], help=f"{study.summary}.")


def _redrawing(named: Mapping[str, Study]) -> click.Command:
    @click.command(REDRAW)
    @click.argument("folder", type=click.Path(exists=True, file_okay=False, path_type=Path))
    def redraw(folder: Path) -> None:
        """Write report and figures of the finished study in FOLDER again, as this version of the program does.

        The dataset stays as it is.
        """
        from algebroproj_sym.study import sweeping

        try:
            with sweeping.held(folder):
                name, dataset = sweeping.finished(folder)
                if name not in named:
                    raise ValueError(f"{folder}: expected one of the studies {', '.join(named)}, got {name}")
                _show(named[name], dataset, folder)
        except ValueError as error:
            raise click.UsageError(str(error)) from error

    return redraw


def _parameter(option: Option) -> click.Option:
    kind: Any = click.Choice(option.type) if isinstance(option.type, tuple) else option.type
    if option.type is Path:
        kind = click.Path(exists=True, dir_okay=False, path_type=Path)
    flags = f"--{option.name.replace('_', '-')}"
    return click.Option([flags, option.name], type=kind, default=option.default, show_default=True, help=option.help)


def _shared(study: Study) -> list[click.Parameter]:
    @click.option("--members", type=int, default=study.members, show_default=True, help="Number of random cases.")
    @click.option("--seed", type=int, default=0, show_default=True, help="Seed of the random numbers.")
    @click.option(
        "--chunk",
        type=int,
        default=study.size,
        show_default=True,
        help="Members that are computed at a time. Fewer take less memory.",
    )
    @options.jobs
    @click.option("--scheduler", metavar="URL", help="Compute on the dask cluster at URL, such as tcp://HOST:PORT.")
    @options.output_as("netcdf", "zarr", help="Format of the dataset.")
    @options.folder(f"study/{study.name}", "dataset, figures and report")
    def shared() -> None:
        """Carry the options that all studies have."""

    return list(reversed(shared.__click_params__))


def _run(
    study: Study,
    *,
    members: int,
    seed: int,
    chunk: int,
    jobs: int,
    scheduler: str | None,
    output: str,
    out: Path,
    **given: Any,
) -> None:
    from algebroproj_sym.study import sweeping

    if scheduler is not None and jobs != 1:
        raise click.UsageError("expected either --jobs or --scheduler, got both")
    if output == "zarr":
        require_modules(("zarr",), "--format zarr", "zarr")
    with ExitStack() as stack:
        try:
            sweep = sweeping.Sweep(study, out, given, members, chunk, seed, output)  # type: ignore[arg-type]
            stack.enter_context(sweeping.held(out))
            sweeping.prepare(sweep)
        except ValueError as error:
            raise click.UsageError(str(error)) from error
        except OSError as error:
            raise click.UsageError(f"--out: {out} cannot be written ({error.strerror})") from error
        _finish(sweep, jobs, scheduler)


def _finish(sweep: Sweep, jobs: int, scheduler: str | None) -> None:
    """Compute what is missing, and write dataset, report and figures."""
    from algebroproj_sym.study import sweeping

    try:
        with _executor(jobs, scheduler) as (executor, workers):
            left = len(sweeping.missing(sweep))
            done = sweeping.run(sweep, executor, CHUNKS_PER_WORKER * workers)
            for _ in progressing(done, left, sweep.study.name):
                pass
        dataset = sweeping.assemble(sweep)
    except (BrokenExecutor, CancelledError) as error:
        raise click.ClickException(
            f"study: the workers were lost. Finished parts are kept in {sweep.folder}: "
            "the same command goes on from there"
        ) from error
    except sweeping.OtherSweepError as error:
        raise click.ClickException(str(error)) from error
    except OSError as error:
        if error.errno not in NOT_WRITABLE:
            raise
        raise click.ClickException(
            f"study: {sweep.folder} cannot be written ({error.strerror}). Finished parts are kept: "
            "the same command goes on from there"
        ) from error
    _show(sweep.study, dataset, sweep.folder, sweep.result.name)


def _show(study: Study, dataset: xarray.Dataset, out: Path, *written: str) -> None:
    """Write report and figures of a dataset, and print the report and what is written."""
    from algebroproj_sym.study import figures
    from algebroproj_sym.study.datasets import thinned

    dataset, step = thinned(dataset, study.shown)
    text = study.report(dataset) + (f"\n{study.legend()}" if study.terms else "")
    text += f"\nReport and figures show one member in {step}.\n" if step > 1 else ""
    drawings = figures.save(study.figures(dataset), out / "figures")
    write_texts({"report.txt": text}, out)
    console().print(text.rstrip("\n"))
    names = sorted({path.stem for path in drawings})
    files = ", ".join([*written, "report.txt", f"figures ({', '.join(names)})"])
    console().print(f"written to {out}: {files}")


@contextmanager
def _executor(jobs: int, scheduler: str | None) -> Iterator[tuple[Executor | None, int]]:
    """Give who computes, and how many workers that are."""
    if scheduler is not None:
        with _cluster(scheduler) as cluster:
            yield cluster
    elif jobs == 1:
        yield None, 1
    else:
        with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
            yield pool, jobs


@contextmanager
def _cluster(scheduler: str) -> Iterator[tuple[Executor, int]]:
    from distributed import Client, KilledWorker

    try:
        client = Client(scheduler, timeout=CONNECTING, set_as_default=False)
    except (OSError, ValueError) as error:
        raise click.UsageError(f"--scheduler: no cluster answers at {scheduler} ({error})") from error
    with client:
        workers = sum(client.nthreads().values())
        if not workers:
            raise click.UsageError(f"--scheduler: the cluster at {scheduler} has no workers")
        try:
            yield client.get_executor(pure=False), workers
        except KilledWorker as error:
            raise BrokenExecutor(str(error)) from error
