"""Work in several processes: the results of one, in order, none left behind, and errors that are told."""

import json
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from algebroproj_sym.processes import in_processes, mapped

# What takes seconds to import is imported by the test that needs it: a process that is spawned imports this module.
linux = pytest.mark.skipif(sys.platform != "linux", reason="processes are forked on Linux only")


def slow_first(task):
    time.sleep(0.2 if task == 0 else 0)
    return task


def sleeping(task):
    if task:
        time.sleep(600)
    return task


def working(folder):
    """Return how many work at the same time."""
    own = folder / str(os.getpid())
    own.touch()
    time.sleep(0.02)
    found = len([*folder.iterdir()])
    own.unlink()
    return found


def exists(process):
    """Ask the system: ``is_alive`` may say so of a process that another thread has just waited for."""
    try:
        os.kill(process.pid, 0)
    except ProcessLookupError:
        return False
    return True


def left():
    return [child for child in multiprocessing.active_children() if child not in others and exists(child)]


def echoing(there):
    there.send(there.recv())


others = []


@pytest.fixture(autouse=True)
def importable(monkeypatch):
    """A process that is spawned imports the functions of this module by its name; what other tests began is let be."""
    others[:] = multiprocessing.active_children()
    monkeypatch.syspath_prepend(Path(__file__).parent.parent)


FORK = pytest.param("fork", marks=linux)


@pytest.fixture(params=[FORK, "spawn"])
def way(request, monkeypatch):
    """Let processes be forked, or spawned, as is done where another thread might hold a lock."""
    monkeypatch.setattr(threading, "active_count", lambda: 1 if request.param == "fork" else 2)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("count", "jobs"), [(0, 3), (7, 1), (7, 3), (200, 2)])
def test_results_are_in_the_order_of_the_tasks(count, jobs):
    assert list(mapped(slow_first, range(count), jobs)) == [*range(count)]
    assert not left()


def test_every_way_gives_each_result_once(way):
    assert list(in_processes(abs, [*range(-5, 1)], 2)) == [5, 4, 3, 2, 1, 0]


def test_an_error_of_the_work_is_raised_and_leaves_no_process(way):
    with pytest.raises(ValueError, match="invalid literal for int"):
        list(in_processes(int, ["1", "2", "three", "4"], 2))
    assert not left()


def test_a_worker_that_dies_is_an_error_and_leaves_no_process(way):
    with pytest.raises(RuntimeError, match="terminated abruptly"):
        list(in_processes(os._exit, [1, 1], 2))
    assert not left()


def test_who_wants_no_more_results_leaves_no_process(way):
    results = in_processes(sleeping, [0, 1, 2, 3], 2)
    assert next(results) == 0
    results.close()
    assert not left()


@linux
def leaving_slowly(path):
    """Work without end; what it has begun to write when it is told to end takes a moment."""
    path.write_text("begun", encoding="utf-8")
    try:
        time.sleep(600)
    finally:
        time.sleep(0.1)
        path.write_text("finished", encoding="utf-8")


def test_a_worker_has_time_to_finish_what_it_writes(way, tmp_path):
    paths = [tmp_path / "soon", tmp_path / "slowly"]
    results = in_processes(soon_or_slowly, paths, 1)
    assert next(results) == "soon"
    while not paths[1].exists() or not paths[1].read_text(encoding="utf-8"):
        time.sleep(0.01)
    results.close()
    assert paths[1].read_text(encoding="utf-8") == "finished"


def soon_or_slowly(path):
    return path.name if path.name == "soon" else leaving_slowly(path)


def test_processes_of_others_are_left_alone():
    here, there = multiprocessing.Pipe()
    other = multiprocessing.get_context("fork").Process(target=echoing, args=[there])
    other.start()
    there.close()
    with pytest.raises(ValueError, match="invalid literal for int"):
        list(in_processes(int, ["1", "2", "three", "4"], 2))
    here.send("still there")
    assert here.recv() == "still there"
    other.join()


@pytest.mark.parametrize("jobs", [2, pytest.param(3, marks=pytest.mark.whole)])
def test_no_more_processes_work_at_a_time_than_jobs(jobs, tmp_path):
    assert 1 <= max(in_processes(working, [tmp_path] * 10, jobs)) <= jobs


def test_a_progress_bar_leaves_the_process_without_threads(monkeypatch):
    """Else nothing would be forked at a terminal."""
    from algebroproj_sym.cli.terminal import progressing

    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    monkeypatch.setattr(sys.stderr, "write", lambda text: len(text), raising=False)
    before = threading.active_count()
    assert [threading.active_count() for _ in progressing(range(3), 3, "counting")] == [before] * 3


@pytest.mark.parametrize("way", [FORK, pytest.param("spawn", marks=pytest.mark.whole)], indirect=True)
def test_claims_are_judged_alike_by_any_number_of_processes(way):
    from algebroproj_sym.declaring import judge_all, located, quotes_of
    from algebroproj_sym.reporting.ledger import ledger
    from algebroproj_sym.showing.arranging import as_declared, shown

    found = located(["critical1996"])
    claims, quotes = [claim for _, claim in found], quotes_of(derivation for derivation, _ in found)

    def records(jobs):
        judgements = [*judge_all(claims, jobs=jobs)]
        forms = [shown(as_declared(j.claim, "derived")) for j in judgements if j.claim.derived is not None]
        return json.dumps(ledger(judgements, quotes, timed=False, jobs=jobs)), forms

    alone = records(1)
    assert records(2) == alone
    assert alone[1] != [shown(claim.derived) for claim in claims if claim.derived is not None]


@pytest.fixture
def _interruptible():
    """Be interrupted as at a terminal, also where the tests run in the background, which ignores Ctrl-C."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


WORKING = """
import os, time
from algebroproj_sym.processes import in_processes

def work(task):
    os.write(1, b"working\\n")
    time.sleep(600)

def main():
    list(in_processes(work, [1, 2], 2))

if __name__ == "__main__":
    from algebroproj_sym.cli.group import Group
    Group(summaries={}, callback=main, invoke_without_command=True)([], standalone_mode=True)
"""


@pytest.fixture
def at_work(tmp_path):
    """A command two workers of which are at work, in a session of its own."""
    script = tmp_path / "script.py"
    script.write_text(WORKING, encoding="utf-8")
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    running = subprocess.Popen([sys.executable, script], start_new_session=True, **pipes)
    assert [running.stdout.readline() for _ in range(2)] == ["working\n"] * 2
    yield running
    if running.poll() is None:
        running.kill()


def has_ended(session):
    """Whether no process of a session is left, within a time that is much longer than it takes."""
    for _ in range(600):
        try:
            os.killpg(session, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.1)
    return False


@linux
@pytest.mark.usefixtures("_interruptible")
def test_ctrl_c_ends_a_command_with_130_and_every_process_of_it(at_work):
    os.killpg(at_work.pid, signal.SIGINT)
    _, errors = at_work.communicate(timeout=60)
    assert at_work.returncode in (130, -signal.SIGINT)  # both are 130 in a shell
    assert "Interrupted" in errors
    assert "Traceback" not in errors
    assert has_ended(at_work.pid)


@linux
def test_workers_do_not_outlive_a_command_that_is_killed(at_work):
    at_work.kill()
    at_work.wait()
    assert has_ended(at_work.pid)
