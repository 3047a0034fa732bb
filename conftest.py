"""What a run of the tests includes.

By default it is what is quick.  ``--part rest`` is what that leaves out: builds and other long tests, most of many
similar cases, tests that need an extra, and properties again with all their examples.  CI runs both, with every extra.
``--part coq`` is what `.ci/coq` runs, and ``--part all`` is everything.
"""

import gc
import os
import pickle
import shutil
import subprocess
import sys
from collections import Counter
from contextlib import contextmanager
from functools import cache
from importlib.metadata import PackageNotFoundError, distribution, requires
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings
from packaging.requirements import Requirement

from algebroproj_sym.declaring import kernels
from algebroproj_sym.generating.choosing import lower

gc.set_threshold(200_000, 50, 50)  # as in the command: expressions make few cycles, and looking for them takes time
PROJECT = "algebroproj-sym"
# The extra that the modules of a file or folder import.  A test that needs one is marked with `extra`.
IMPORTS = {
    "algebroproj_sym/reporting/site": "report",
    "algebroproj_sym/study": "study",
    "derivations/studies": "study",
    "tests/test_browser.py": "dev",
    "tests/test_docs.py": "docs",
    "tests/test_notebooks.py": "report",
    "tests/test_site.py": "report",
    "tests/test_study_": "study",
}
REPEATABLE = settings(derandomize=True, deadline=None, print_blob=True, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("quick", REPEATABLE, max_examples=20)
settings.register_profile("whole", REPEATABLE, max_examples=50)


def pytest_addoption(parser):
    parser.addoption("--part", choices=(*PARTS, "all"), default="quick", help="Which tests to run.")
    parser.addoption(
        "--built", type=Path, help="The folder that `algebroproj build` has written; built anew otherwise."
    )
    parser.addoption("--site", type=Path, help="Check every page of this site in the browser, not of a small one.")


def pytest_configure(config):
    config.addinivalue_line("markers", "whole: what takes long, such as a build.")
    config.addinivalue_line("markers", "coq: what Coq takes minutes for.")
    config.addinivalue_line("markers", "extra(name): the test needs this extra.")
    config.addinivalue_line("markers", "sampled(n): a quick run takes every n-th case.")
    settings.load_profile("quick" if config.getoption("part") == "quick" else "whole")


def pytest_collection_modifyitems(config, items):
    leave_out_what_is_not_sampled(items)
    part = config.getoption("part")
    if part != "all":
        config.hook.pytest_deselected(items=[item for item in items if not PARTS[part](item)])
        items[:] = filter(PARTS[part], items)


def leave_out_what_is_not_sampled(items):
    """Mark the cases between those that a quick run takes as parts of the whole."""
    seen = Counter()
    for item in items:
        for mark in item.iter_markers("sampled"):
            place = seen[test := (item.path, item.originalname)]
            seen[test] += 1
            if place % mark.args[0]:
                item.add_marker("whole")


def is_quick(item):
    return item.get_closest_marker("whole") is None and not is_for_coq(item)


def is_rest(item):
    """Whether a quick run leaves a test out, skips it without an extra, or gives it fewer examples."""
    if is_for_coq(item):
        return False
    needs_extra = extra_of(item) is not None or item.get_closest_marker("extra") is not None
    return not is_quick(item) or needs_extra or hasattr(getattr(item, "obj", None), "hypothesis")


def is_for_coq(item):
    return item.get_closest_marker("coq") is not None


PARTS = {"quick": is_quick, "rest": is_rest, "coq": is_for_coq}


@pytest.hookimpl(tryfirst=True)
def pytest_make_collect_report(collector):
    """Skip a file, before it is imported, that needs an extra which is absent."""
    extra = extra_of(collector) if isinstance(collector, pytest.File) else None
    reason = extra and collector.config.getoption("part") == "quick" and absent(extra)
    return pytest.CollectReport(collector.nodeid, "skipped", (collector.nodeid, 0, reason), []) if reason else None


def pytest_runtest_setup(item):
    for mark in item.iter_markers("extra"):
        reason = item.config.getoption("part") == "quick" and absent(*mark.args)
        if reason:
            pytest.skip(reason)


def extra_of(node):
    return next((extra for place, extra in IMPORTS.items() if node.nodeid.startswith(place)), None)


@cache
def absent(extra):
    """Return a sentence on what is not installed of what an extra requires, or None."""
    names = sorted(name for name in required(extra) if not is_installed(name))
    return f"needs the extra {extra}, of which {names[0]} is not installed" if names else None


def required(extra):
    """Return the names of the distributions that an extra requires and the core does not."""
    every = [Requirement(text) for text in requires(PROJECT)]
    for requirement in every:
        if requirement.marker and requirement.marker.evaluate({"extra": extra}):
            if requirement.name == PROJECT:
                yield from (name for inner in requirement.extras for name in required(inner))
            else:
                yield requirement.name


def is_installed(name):
    try:
        return distribution(name) is not None
    except PackageNotFoundError:
        return False


@pytest.fixture
def decided_here(monkeypatch):
    """Questions are decided in the process of the test: no worker is started, and no time is limited."""
    from algebroproj_sym.proving import worker

    @contextmanager
    def asking(*, seconds, engine="flint", jobs=1):
        def here(question):
            try:
                return worker._decided(question, engine)
            except Exception as error:
                return worker.Outcome("error", "none", 0.0, f"{type(error).__name__}: {error}")

        yield lambda questions: map(here, questions)

    monkeypatch.setattr(worker, "asking", asking)
    monkeypatch.setattr("algebroproj_sym.reading.asking.answering.asking", asking)


@pytest.fixture
def verdicts_alone(decided_here, monkeypatch):
    """As `decided_here`; no change is looked for by which what does not follow would."""
    monkeypatch.setattr("algebroproj_sym.reading.judging.deciding.MOST_ASKED", 0)


@pytest.fixture(scope="session")
def repository() -> Path:
    return Path(__file__).resolve().parent


@pytest.fixture(scope="session")
def made_once(tmp_path_factory):
    """Return a function from a name to a folder, which the first worker of a run that asks for it fills."""
    import fcntl

    base = tmp_path_factory.getbasetemp()
    base = base.parent if "PYTEST_XDIST_WORKER" in os.environ else base

    def folder(name, fill):
        with (base / f"{name}.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not (base / name).exists():
                unfinished = tmp_path_factory.mktemp(name)
                fill(unfinished)
                unfinished.rename(base / name)
        return base / name

    return folder


@pytest.fixture(scope="session")
def built(request, made_once):
    """Return the folder of a build of everything."""

    def build(folder):
        command = [sys.executable, "-m", "algebroproj_sym", "build", "--out", str(folder), "--jobs", "2"]
        subprocess.run(command, env=os.environ | {"PYTHONHASHSEED": "1"}, capture_output=True, check=True)

    return request.config.getoption("built") or made_once("built", build)


@pytest.fixture(scope="session")
def lemmas(made_once, tmp_path_factory):
    """Return a folder, for one worker, with the lemmas of all theorems, compiled by Coq."""
    from algebroproj_sym.exporting import compiling, files
    from algebroproj_sym.files import write_texts

    def compiled(folder):
        write_texts(files.render([]), folder)
        assert not any(lemma.error for lemma in compiling.compiled(folder, files.lemmas()))

    return shutil.copytree(made_once("lemmas", compiled), tmp_path_factory.mktemp("own") / "lemmas")


@pytest.fixture(scope="session")
def lowered(made_once):
    """Return a function from the name of a kernel of the papers to its program; each is lowered once for all workers.

    What is read is what worker processes hand over in a build.
    """
    declared = {kernel.qualified_name: kernel for kernel in kernels()}

    def program(name):
        def written(folder):
            (folder / "program").write_bytes(pickle.dumps(lower(declared[name])))

        return pickle.loads((made_once(f"lowered {name}", written) / "program").read_bytes())

    return cache(program)


@pytest.fixture(scope="module")
def sources_read_once():
    """Find out once on which sources a study depends: no test of the module changes them."""
    from algebroproj_sym.study import datasets

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(datasets, "digest", cache(datasets.digest))
        yield
