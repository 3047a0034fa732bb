"""Memory and time of a sweep of a light study, for numbers of members and of workers.

    python benchmarks/sweeps.py [--members N ...] [--jobs N ...] [--chunk N]

Each sweep runs in a process of its own: the determinant of the five equations for random aerial stereo pairs, then the
joint distribution of two of its variables.  Peak memory is what the operating system counted for that process and the
largest of its workers.
"""

from __future__ import annotations

import argparse
import resource
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import xarray

import algebroproj
from algebroproj_derivations.studies.stereo.aerial import aerial
from algebroproj_derivations.studies.stereo.distributions import joint
from algebroproj_derivations.studies.stereo.scenes import images
from algebroproj_sym.study import MEMBER, Study
from algebroproj_sym.study.datasets import variable
from algebroproj_sym.study.sweeping import Sweep, assemble, prepare, run


def chunk(indices: Any, seed: int) -> xarray.Dataset:
    """Compute the determinants of some stereo pairs."""
    u = images(aerial(seed, indices))
    data = {
        "determinant": variable([MEMBER], algebroproj.critical.determinant(u[:, 0, 3:], u[:, 1, 3:])),
        "first": variable([MEMBER], u[:, 0, 3, 0]),
    }
    return xarray.Dataset(data, coords={MEMBER: indices})


STUDY = Study("determinants", "Determinants of random stereo pairs", (), 1, chunk, lambda _: "", lambda _: {})


def sweep(members: int, jobs: int, size: int) -> None:
    """Run a sweep, and print its figures in a line."""
    start, clock = time.perf_counter(), time.process_time()
    with TemporaryDirectory() as folder:
        work = Sweep(STUDY, Path(folder), {}, members, size)
        prepare(work)
        if jobs == 1:
            done = len(list(run(work)))
        else:
            with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
                done = len(list(run(work, pool, 2 * jobs)))
        with assemble(work) as dataset:
            counted = joint(dataset, "first", "determinant", np.linspace(-10, 10, 201), np.linspace(-10, 10, 201))
            total = int(counted.counts.sum()) + counted.outside
            assert total == members
        written = work.result.stat().st_size
    own, workers = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    print(
        f"{members:>9} {size:>7} {jobs:>5} {done:>7} {written / 1e6:>9.1f} {own.ru_maxrss / 1024:>10.0f} "
        f"{workers.ru_maxrss / 1024 if jobs > 1 else 0:>12.0f} {time.perf_counter() - start:>8.1f} "
        f"{time.process_time() - clock + (workers.ru_utime + workers.ru_stime if jobs > 1 else 0):>8.1f}",
        flush=True,
    )


def main() -> None:
    """Run each sweep in a process of its own."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--members", type=int, nargs="+", default=[100_000, 1_000_000, 10_000_000])
    parser.add_argument("--jobs", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--chunk", type=int, default=50_000)
    parser.add_argument("--one", action="store_true", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.one:
        sweep(given.members[0], given.jobs[0], given.chunk)
        return
    print("  members   chunk  jobs  chunks  file [MB] peak [MB] largest worker  wall [s]  CPU [s]", flush=True)
    for members in given.members:
        for jobs in given.jobs:
            arguments = ["--members", str(members), "--jobs", str(jobs), "--chunk", str(given.chunk), "--one"]
            subprocess.run([sys.executable, __file__, *arguments], check=True)


if __name__ == "__main__":
    main()
