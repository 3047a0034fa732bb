"""Work in several processes: the results of one, no process too many, none left behind, and errors that are told."""

import gc
import json
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time

import pytest

from algebroproj_sym import pipeline
from algebroproj_sym.cli.terminal import progressing
from algebroproj_sym.declaring import modules_of_papers, needed_by
from algebroproj_sym.processes import can_fork, dealt, forked, in_processes, mapped
from algebroproj_sym.remembering import Memory

forking = pytest.mark.skipif(sys.platform != "linux", reason="processes are forked on Linux only")
made = []


def made_sum(task):
    return task + sum(made)


def dying(task):
    if task == 3:
        os.kill(os.getpid(), signal.SIGKILL)
    return task


def sleeping(task):
    time.sleep(600)


def exists(process):
    """Ask the system: ``is_alive`` may say so of a process that another thread has just waited for."""
    try:
        os.kill(process.pid, 0)
    except ProcessLookupError:
        return False
    return True


def echoing(there):
    there.send(there.recv())


def first(worker, pending):
    return pending[0]


WAYS = {
    "mapped": lambda function, tasks: mapped(function, tasks, 1),
    "in_processes": lambda function, tasks: in_processes(function, tasks, 2),
    "dealt": lambda function, tasks: dealt(function, tasks, 2, first),
    "forked": lambda function, tasks: forked(function, tasks, 2),
}
WAY = [pytest.param(way, marks=[forking] if way == "forked" else []) for way in WAYS]


@pytest.mark.parametrize("way", WAY)
def test_every_way_gives_each_result_once(way):
    assert sorted(WAYS[way](abs, [*range(-5, 1)])) == [*range(6)]


@pytest.mark.parametrize("way", WAY)
def test_an_error_of_the_work_is_raised_and_leaves_no_process(way):
    with pytest.raises(ValueError, match="invalid literal for int"):
        list(WAYS[way](int, ["1", "2", "three", "4"]))
    assert not [child for child in multiprocessing.active_children() if exists(child)]


@forking
@pytest.mark.parametrize("way", WAYS)
def test_processes_of_others_are_left_alone(way):
    here, there = multiprocessing.Pipe()
    other = multiprocessing.get_context("fork").Process(target=echoing, args=[there])
    other.start()
    there.close()
    with pytest.raises(ValueError, match="invalid literal for int"):
        list(WAYS[way](int, ["1", "2", "three", "4"]))
    here.send("still there")
    assert here.recv() == "still there"
    other.join()


@pytest.mark.parametrize("way", ["in_processes", "dealt"])
def test_a_worker_of_a_pool_that_dies_is_an_error(way):
    with pytest.raises(RuntimeError, match="terminated abruptly"):
        list(WAYS[way](os._exit, [1, 1]))


@forking
@pytest.mark.parametrize("jobs", [1, 2, 3])
def test_a_fork_that_dies_is_an_error_and_leaves_no_process(jobs):
    with pytest.raises(ChildProcessError, match=f"exit status -{signal.SIGKILL.value}"):
        list(forked(dying, [1, 2, 3, 4], jobs))
    assert multiprocessing.active_children() == []


@forking
@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_a_fork_has_what_was_made_before_its_task_was_there(jobs):
    def tasks():
        made.clear()
        for task in range(8):
            made.append(task)
            yield 100 * task

    results = dict(enumerate(sorted(forked(made_sum, tasks(), jobs))))
    for task, result in results.items():
        assert sum(range(task + 1)) <= result - 100 * task <= sum(range(8))


@forking
@pytest.mark.parametrize("jobs", [1, 2, 3])
def test_no_more_processes_work_at_a_time_than_jobs(jobs):
    working, most = (multiprocessing.get_context("fork").Value("i", 0) for _ in range(2))

    def work(task):
        with working.get_lock():
            working.value += 1
            most.value = max(most.value, working.value)
        time.sleep(0.02)
        with working.get_lock():
            working.value -= 1
        return task

    assert sorted(forked(work, map(work, range(10)), jobs)) == [*range(10)]
    assert 1 <= most.value <= jobs


@forking
def test_as_many_processes_work_at_a_time_as_jobs():
    """Three that wait for each other come to an end."""
    meeting = multiprocessing.get_context("fork").Barrier(3)
    assert sorted(forked(lambda task: meeting.wait(60) * 0 + task, range(6), 3)) == [*range(6)]


@forking
def test_an_error_where_tasks_are_made_is_raised_and_leaves_no_process():
    def tasks():
        yield 1
        yield 2
        raise ValueError("no third task")

    with pytest.raises(ValueError, match="no third task"):
        list(forked(sleeping, tasks(), 3))
    assert multiprocessing.active_children() == []


@forking
def test_who_wants_no_more_results_leaves_no_process():
    results = forked(abs, [-1, -2, -3, -4], 2)
    next(results)
    results.close()
    assert multiprocessing.active_children() == []
    assert gc.isenabled()


@forking
def test_a_process_with_threads_is_not_forked():
    assert can_fork() is (threading.active_count() == 1)
    over = threading.Event()
    thread = threading.Thread(target=over.wait)
    thread.start()
    assert not can_fork()
    over.set()
    thread.join()


@forking
def test_a_progress_bar_that_does_not_tick_leaves_the_process_without_threads(monkeypatch):
    """Else nothing would be forked at a terminal."""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    monkeypatch.setattr(sys.stderr, "write", lambda text: len(text), raising=False)
    before = threading.active_count()
    threads = [threading.active_count() for _ in progressing(range(3), 3, "counting", ticking=False)]
    assert threads == [before] * 3
    assert max(threading.active_count() for _ in progressing(range(3), 3, "counting")) > before


def checked(memory, jobs):
    modules = pipeline.check_modules(modules_of_papers(["rhodos1990"]), "flint", jobs, memory, recorded=True)
    records = [record | {"seconds": 0} for m in sorted(modules, key=lambda m: m.name) for record in m.records]
    return json.dumps(records)


@pytest.mark.parametrize("fork", [pytest.param(True, marks=forking), False])
def test_modules_are_judged_alike_wherever_they_are(fork, tmp_path, monkeypatch):
    memory = Memory(tmp_path, fresh=True)
    alone = [pipeline._check_module(name, "flint", memory, True) for name in modules_of_papers(["rhodos1990"])]
    monkeypatch.setattr(pipeline, "can_fork", lambda: fork)
    assert checked(memory, 2) == json.dumps([record | {"seconds": 0} for module in alone for record in module.records])


def test_what_several_modules_need_is_imported_once_before_them():
    """In a process of its own, where nothing is imported yet."""
    papers = ["okamoto1981", "rhodos1990"]
    script = (
        "import json, sys; from algebroproj_sym import declaring, pipeline\n"
        f"names = declaring.modules_of_papers({papers})\n"
        "steps = ([name, [m for m in sys.modules if m.startswith('algebroproj_derivations.')]] for name in\n"
        "    pipeline._ready(names))\n"
        "print(json.dumps([*steps]))"
    )
    found = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout
    steps = json.loads(found)
    names = modules_of_papers(papers)
    assert sorted(name for name, _ in steps) == sorted(names)
    for name, imported in steps:
        for other in {*names} - {name}:
            assert needed_by(name).keys() & needed_by(other).keys() <= {*imported}
    unshared = {name for name in names if not any(name in needed_by(other) for other in names if other != name)}
    assert unshared
    assert not unshared & {*steps[-1][1]}


@pytest.fixture
def _interruptible():
    """Be interrupted as at a terminal, also where the tests run in the background, which ignores Ctrl-C."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@forking
@pytest.mark.usefixtures("_interruptible")
def test_ctrl_c_ends_a_check_with_130_and_every_process_of_it(tmp_path):
    command = [sys.executable, "-m", "algebroproj_sym", "check", "--fresh", "--jobs", "2"]
    environment = os.environ | {"ALGEBROPROJ_CACHE": str(tmp_path)}
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    running = subprocess.Popen(command, env=environment, start_new_session=True, **pipes)
    while not [*tmp_path.rglob("*.json")] and running.poll() is None:
        time.sleep(0.02)
    os.killpg(running.pid, signal.SIGINT)
    _, errors = running.communicate(timeout=60)
    assert running.returncode == 130
    assert "Interrupted" in errors
    assert "Traceback" not in errors
    with pytest.raises(ProcessLookupError):
        os.killpg(running.pid, 0)
    assert not [*tmp_path.rglob("*.partial")]
