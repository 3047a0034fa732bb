"""Sweeps: stopped, killed, resumed, by any number of workers, and always the same bytes."""

import json
import os
import re
import resource
import shutil
import signal
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from errno import ECONNRESET, EDQUOT, ENOENT, ENOSPC
from pathlib import Path

import distributed
import numpy as np
import pytest
import xarray
from click.testing import CliRunner
from matplotlib.figure import Figure
from pages import started

from algebroproj_derivations.studies import example, normal_case
from algebroproj_sym.cli import main
from algebroproj_sym.study import MEMBER, Option, Study
from algebroproj_sym.study.datasets import read, variable
from algebroproj_sym.study.sampling import uniform
from algebroproj_sym.study.sweeping import (
    BusyFolderError,
    OtherSweepError,
    Sweep,
    assemble,
    computed,
    held,
    missing,
    prepare,
    run,
)

pytestmark = pytest.mark.usefixtures("sources_read_once")


def chunk(indices, seed, *, scale, unit="m"):
    units = unit if indices[0] == 0 else "m"
    return xarray.Dataset(
        {
            "length": variable([MEMBER], scale * uniform(seed, indices), units, "length"),
            "text": variable([MEMBER], np.array([f"{index}/7" for index in indices], dtype=object)),
            "axis": variable(["place", MEMBER], np.stack([indices, -indices]), "1"),
            "even": variable([MEMBER], indices % 2 == 0),
            "step": variable(["place"], [1.5, 2.5], "m"),
            "none": variable(["nothing"], np.empty(0)),
        },
        coords={MEMBER: indices},
    )


def others(indices, seed, **options):
    return chunk(indices[::-1], seed, **options)


def positive(*, scale, unit="m"):
    if scale <= 0:
        raise ValueError(f"scale: expected a positive number, got {scale}")


def study(function=chunk):
    options = (Option("scale", float, 2.0, "Factor."), Option("unit", str, "m", "Unit of the first chunk."))
    return Study("lengths", "Some lengths", options, 45, function, lambda _: "", lambda _: {"f": Figure()}, positive)


def swept(folder, **arguments):
    sweep = Sweep(study(), folder, {}, 45, 10, 4, **arguments)
    prepare(sweep)
    return sweep


def finished(sweep, *workers):
    done = list(run(sweep, *workers))
    with assemble(sweep) as dataset:
        return done, dataset.load()


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    sweep = swept(tmp_path_factory.mktemp("reference"))
    done, dataset = finished(sweep)
    assert done == list(range(5))
    return dataset, sweep.result.read_bytes()


def test_the_whole_is_what_one_chunk_would_be(reference):
    dataset, _ = reference
    at_once = computed(chunk, np.arange(45), 4, {"scale": 2.0, "unit": "m"})
    xarray.testing.assert_equal(dataset, at_once.drop_indexes(MEMBER))
    assert dataset[MEMBER].values.tolist() == list(range(45))
    assert {name: dataset[name].attrs["units"] for name in ("length", "step", "even")} == {
        "length": "m",
        "step": "m",
        "even": "1",
    }
    assert dataset.even.dtype == bool


def test_the_whole_tells_where_it_comes_from_and_nothing_of_the_machine(reference):
    attributes = reference[0].attrs
    assert json.loads(attributes["arguments"]) == {
        "study": "lengths",
        "members": 45,
        "chunk": 10,
        "seed": 4,
        "format": "netcdf",
        "options": {"scale": 2.0, "unit": "m"},
    }
    provenance = json.loads(attributes["provenance"])
    assert {"algebroproj-sym", "numpy", "source", "backend"} <= set(provenance)
    assert os.uname().nodename not in json.dumps(attributes) or len(os.uname().nodename) < 4
    assert not re.search(r"\d\d:\d\d", json.dumps(attributes))


@pytest.mark.parametrize("workers", [1, 3])
def test_the_bytes_do_not_depend_on_the_number_of_workers(reference, tmp_path, workers):
    sweep = swept(tmp_path)
    with ThreadPoolExecutor(workers) as executor:
        done, _ = finished(sweep, executor, 2 * workers)
    assert sorted(done) == list(range(5))
    assert sweep.result.read_bytes() == reference[1]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["lengths.nc", "lengths.nc.seal", "manifest.json"]


def test_no_more_chunks_are_under_way_than_the_window_allows(tmp_path):
    class Counting(ThreadPoolExecutor):
        running = most = 0

        def submit(self, *arguments):
            Counting.running += 1
            Counting.most = max(Counting.most, Counting.running)
            return super().submit(*arguments)

    with Counting(2) as executor:
        for _ in run(swept(tmp_path), executor, 3):
            Counting.running -= 1
    assert Counting.most == 3


def test_a_stopped_sweep_goes_on_with_what_is_missing(reference, tmp_path):
    sweep = swept(tmp_path)
    for _, number in zip(range(3), run(sweep), strict=False):
        assert number in (0, 1, 2)
    sweep.path(1).unlink()
    assert missing(swept(tmp_path)) == [1, 3, 4]
    finished(sweep)
    assert sweep.result.read_bytes() == reference[1]
    assert missing(swept(tmp_path)) == []


def halved(path):
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def flipped(path):
    content = bytearray(path.read_bytes())
    content[-9] ^= 4
    path.write_bytes(content)


def with_a_seal(source, path):
    """Copy a file and its seal."""
    shutil.copy(source, path)
    shutil.copy(f"{source}.seal", f"{path}.seal")


CHANGES = {
    "truncated": lambda path, other: halved(path),
    "empty": lambda path, other: path.write_bytes(b""),
    "flipped": lambda path, other: flipped(path),
    "no seal": lambda path, other: path.with_name(f"{path.name}.seal").unlink(),
    "a damaged seal": lambda path, other: halved(path.with_name(f"{path.name}.seal")),
    "a seal of bytes": lambda path, other: path.with_name(f"{path.name}.seal").write_bytes(b"\xff\x00"),
    "another run's": lambda path, other: shutil.copy(other, path),
    "another run's with its seal": lambda path, other: with_a_seal(other, path),
    "the seal alone": lambda path, other: path.unlink(),
}


@pytest.fixture(scope="module")
def foreign(tmp_path_factory):
    """Another run of the same study: some of its chunks, and a whole."""
    sweeps = [Sweep(study(), tmp_path_factory.mktemp("foreign"), {}, 45, 10, 5) for _ in range(2)]
    for sweep in sweeps:
        prepare(sweep)
    for _ in zip(range(4), run(sweeps[0]), strict=False):
        pass
    finished(sweeps[1])
    return sweeps


@pytest.mark.parametrize("change", CHANGES)
def test_a_chunk_that_is_not_as_it_was_written_is_computed_again(reference, foreign, tmp_path, change):
    sweep = swept(tmp_path)
    for _ in zip(range(4), run(sweep), strict=False):
        pass
    CHANGES[change](sweep.path(1), foreign[0].path(1))
    assert missing(swept(tmp_path)) == [1, 4]
    finished(sweep)
    assert sweep.result.read_bytes() == reference[1]


def test_a_chunk_in_the_place_of_another_one_is_computed_again(reference, tmp_path):
    sweep = swept(tmp_path)
    for _ in zip(range(4), run(sweep), strict=False):
        pass
    with_a_seal(sweep.path(0), sweep.path(1))
    shutil.copy(sweep.path(0), sweep.path(2))
    assert missing(sweep) == [1, 2, 4]
    with pytest.raises(FileNotFoundError, match=r"00000001\.nc: expected a chunk with its seal"):
        assemble(sweep)
    finished(sweep)
    assert sweep.result.read_bytes() == reference[1]


@pytest.mark.parametrize("change", sorted(CHANGES.keys() - {"the seal alone"}))
def test_a_result_that_is_not_what_was_written_is_refused(foreign, tmp_path, change):
    sweep = swept(tmp_path)
    finished(sweep)
    CHANGES[change](sweep.result, foreign[1].result)
    kept = sweep.result.read_bytes()
    with pytest.raises(OtherSweepError, match=r"lengths\.nc: this is not what the study has written here"):
        swept(tmp_path)
    assert sweep.result.read_bytes() == kept


def test_a_damaged_zarr_result_is_refused(tmp_path):
    sweep = swept(tmp_path, output="zarr")
    finished(sweep)
    swept(tmp_path, output="zarr")
    halved(max((path for path in sweep.result.rglob("*") if path.is_file()), key=lambda path: path.stat().st_size))
    with pytest.raises(OtherSweepError, match=r"lengths\.zarr: this is not what"):
        swept(tmp_path, output="zarr")


@pytest.mark.parametrize("text", ["", "{", "[1]", "null", '{"arguments": 1}'])
def test_a_damaged_manifest_is_refused_by_name(tmp_path, text):
    swept(tmp_path)
    (tmp_path / "manifest.json").write_text(text)
    with pytest.raises(OtherSweepError, match=r"is not the manifest of a study|in this folder has"):
        swept(tmp_path)


@pytest.mark.parametrize(
    "place", ["chunks/00000001.nc", "chunks/00000001.nc.seal", "chunks/unsealed-00000001.nc", "manifest.json"]
)
def test_a_folder_in_the_place_of_a_file_is_refused_by_name(tmp_path, place):
    for _ in zip(range(4), run(swept(tmp_path)), strict=False):
        pass
    (tmp_path / place).unlink(missing_ok=True)
    (tmp_path / place / "inner").mkdir(parents=True)
    with pytest.raises(OtherSweepError, match=f"{re.escape(place)}: expected a file, found a folder"):
        swept(tmp_path)
    assert (tmp_path / place / "inner").exists()


@pytest.mark.parametrize("place", ["lengths.nc", "lengths.nc.seal"])
def test_a_folder_in_the_place_of_the_result_is_refused_by_name(tmp_path, place):
    finished(swept(tmp_path))
    (tmp_path / place).unlink()
    (tmp_path / place).mkdir()
    with pytest.raises(OtherSweepError, match=r"lengths\.nc: this is not what the study has written here"):
        swept(tmp_path)


def test_a_folder_has_one_run_at_a_time(tmp_path):
    with held(tmp_path), pytest.raises(BusyFolderError, match="another run writes to this folder"), held(tmp_path):
        pass
    with held(tmp_path):
        result = invoke("normal-case", "--members", "10", "--out", str(tmp_path))
    assert result.exit_code == 2
    assert "another run writes to this folder. Wait until it has ended" in result.stderr
    with held(tmp_path):
        assert [path.name for path in tmp_path.iterdir()] == [".lock"]


def test_a_full_disk_is_an_error_and_the_sweep_goes_on_later(tmp_path, monkeypatch):
    sweep = swept(tmp_path)
    prepare(sweep)
    write_bytes = Path.write_bytes

    def full(path, content):
        write_bytes(path, content[:100])
        raise OSError(ENOSPC, "No space left on device")

    with monkeypatch.context() as patched:
        patched.setattr(Path, "write_bytes", full)
        with pytest.raises(OSError, match="No space left"):
            list(run(sweep))
    assert not list(sweep.folder.rglob("*.partial"))
    assert len(list(run(sweep))) == sweep.count


def test_a_file_that_may_not_be_so_large_is_an_error_and_the_sweep_goes_on_later(reference, tmp_path):
    """HDF5 would end the process when it meets the end of the disk, or a limit."""
    sweep = swept(tmp_path)
    list(run(sweep))
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (sum(sweep.path(each).stat().st_size for each in range(5)) // 2, hard))
    try:
        with pytest.raises(OSError, match="File too large"):
            assemble(sweep)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert not sweep.result.exists()
    assert finished(sweep)[0] == []
    assert sweep.result.read_bytes() == reference[1]


def test_what_a_run_that_was_killed_while_it_assembled_has_left_is_removed(reference, tmp_path):
    sweep = swept(tmp_path)
    (tmp_path / ".assembling" / "lengths.nc").mkdir(parents=True)
    finished(sweep)
    assert sorted(each.name for each in tmp_path.iterdir()) == ["lengths.nc", "lengths.nc.seal", "manifest.json"]
    assert sweep.result.read_bytes() == reference[1]


@pytest.mark.parametrize(("number", "told"), [(ENOSPC, True), (EDQUOT, True), (ENOENT, False), (ECONNRESET, False)])
def test_only_an_error_of_writing_is_told_as_one(tmp_path, monkeypatch, number, told):
    def broken(*_):
        raise OSError(number, "broken")

    monkeypatch.setattr("algebroproj_sym.study.sweeping.write", broken)
    result = invoke("example", "--members", "4", "--out", str(tmp_path))
    assert result.exit_code == 1
    assert ("cannot be written (broken)" in result.stderr) is told
    assert isinstance(result.exception, OSError) is not told


def test_a_zarr_folder_has_the_same_values(reference, tmp_path):
    sweep = swept(tmp_path, output="zarr")
    _, dataset = finished(sweep)
    xarray.testing.assert_equal(dataset, reference[0])
    assert json.loads(dataset.attrs["arguments"])["format"] == "zarr"
    assert dataset.length.attrs == reference[0].length.attrs


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"seed": 5}, "seed"),
        ({"members": 46}, "members"),
        ({"size": 11}, "chunk"),
        ({"options": {"scale": 3.0}}, "scale"),
    ],
)
def test_a_folder_with_another_sweep_is_refused_by_the_name_of_the_argument(tmp_path, change, name):
    swept(tmp_path)
    arguments = {"options": {}, "members": 45, "size": 10, "seed": 4} | change
    with pytest.raises(OtherSweepError, match=name):
        prepare(Sweep(study(), tmp_path, **arguments))


def test_a_folder_of_another_version_is_refused(tmp_path):
    swept(tmp_path)
    manifest = json.loads((tmp_path / "manifest.json").read_text())
    manifest["provenance"]["numpy"] = "1.0"
    (tmp_path / "manifest.json").write_text(json.dumps(manifest))
    with pytest.raises(OtherSweepError, match=r"numpy = 1\.0"):
        swept(tmp_path)


def test_another_commit_of_the_same_sources_goes_on(tmp_path, monkeypatch):
    monkeypatch.setattr("algebroproj_sym.study.datasets._commit", lambda: "one")
    for _ in zip(range(3), run(swept(tmp_path)), strict=False):
        pass
    monkeypatch.setattr("algebroproj_sym.study.datasets._commit", lambda: "two")
    sweep = swept(tmp_path)
    assert missing(sweep) == [3, 4]
    assert json.loads(finished(sweep)[1].attrs["provenance"])["commit"] == "two"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"members": 0}, "members: expected at least 1, got 0"),
        ({"size": 0}, "chunk: expected at least 1, got 0"),
        ({"seed": -1}, "seed: expected at least 0, got -1"),
        ({"output": "csv"}, "format: expected one of netcdf, zarr, got 'csv'"),
        ({"options": {"skale": 1.0}}, "expected options among scale, unit, got skale"),
        ({"options": {"scale": 0.0}}, "scale: expected a positive number, got 0.0"),
    ],
)
def test_bad_arguments_are_refused_before_work_begins(tmp_path, arguments, message):
    with pytest.raises(ValueError, match=message):
        Sweep(study(), tmp_path / "new", **({"options": {}, "members": 5} | arguments))
    assert not (tmp_path / "new").exists()


def of_a_file(indices, seed, *, file):
    return chunk(indices, seed, scale=float(file.read_text()))


def test_a_file_that_changes_while_a_study_reads_it_is_refused(tmp_path):
    options = (Option("file", Path, None, "A file."),)
    made = Study(
        "lengths", "Some lengths", options, 45, of_a_file, lambda _: "", lambda _: {"f": Figure()}, lambda file: None
    )
    (tmp_path / "given").write_text("2")
    sweep = Sweep(made, tmp_path, {"file": tmp_path / "given"}, 45, 10, 4)
    prepare(sweep)
    done = run(sweep)
    assert next(done) == 0
    (tmp_path / "given").write_text("3")
    with pytest.raises(OtherSweepError, match="a file that the study reads has changed"):
        next(done)
    assert missing(sweep) == [1, 2, 3, 4]


def test_chunks_with_different_units_do_not_become_one_dataset(tmp_path):
    sweep = Sweep(study(), tmp_path, {"unit": "ft"}, 20, 10)
    prepare(sweep)
    with pytest.raises(ValueError, match="length: expected the unit ft as before, got m"):
        finished(sweep)
    assert not sweep.result.exists()


def test_a_study_that_gives_other_members_is_an_error():
    with pytest.raises(RuntimeError, match="expected the members 0 to 4 in order"):
        computed(others, np.arange(5), 0, {"scale": 1.0})


SWEEP = ("study", "example", "--members", "120", "--chunk", "10")


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("undisturbed")
    assert CliRunner().invoke(main, [*SWEEP, "--out", str(folder)]).exit_code == 0
    return (folder / "example.nc").read_bytes()


def sweeping(folder, *arguments):
    """Return the process of a sweep into a folder, and the file of its errors; it has imported what it needs."""
    folder.mkdir(exist_ok=True)
    process, (_, errors) = started("algebroproj_sym", [*SWEEP, "--out", str(folder), *arguments], folder, folder)
    return process, errors


def written(folder):
    """Return the finished parts of a sweep, and when each was written."""
    return {path: path.stat().st_mtime_ns for path in (folder / "chunks").glob("0*.nc")}


@pytest.mark.whole
def test_a_killed_sweep_loses_nothing_and_doubles_nothing(undisturbed, tmp_path):
    killed, _ = sweeping(tmp_path)
    wait_for(lambda: len(written(tmp_path)) >= 3 or not killed.is_alive())
    killed.kill()
    killed.join()
    assert killed.exitcode == -signal.SIGKILL
    kept = written(tmp_path)
    assert 3 <= len(kept) < 12
    for path in kept:
        assert read(path).sizes[MEMBER] == 10
    resumed, errors = sweeping(tmp_path)
    wait_for(lambda: len(written(tmp_path)) > len(kept) or not resumed.is_alive())
    unchanged = {path: path.stat().st_mtime_ns for path in kept if path.exists()}
    resumed.join()
    assert resumed.exitcode == 0, errors.read_text(encoding="utf-8")
    assert unchanged.items() <= kept.items()
    assert (tmp_path / "example.nc").read_bytes() == undisturbed
    with read(tmp_path / "example.nc") as dataset:
        assert np.array_equal(dataset[MEMBER], np.arange(120))
    assert not (tmp_path / "chunks").exists()


def wait_for(condition, seconds=300):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


@contextmanager
def cluster(folder):
    """A scheduler with two workers, separately started programs on loopback."""
    address = folder / "scheduler.json"

    def program(name, *arguments):
        kept = folder / f"printed by {len(programs)}"
        kept.mkdir()
        programs.append(started(f"distributed.cli.dask_{name}", [*arguments, "--no-dashboard"], folder, kept)[0])

    programs = []
    try:
        program("scheduler", "--host", "127.0.0.1", "--port", "0", "--scheduler-file", str(address))
        wait_for(lambda: address.exists() and address.read_text().endswith("}"))
        url = json.loads(address.read_text())["address"]
        for _ in range(2):
            program("worker", url, "--nthreads", "1", "--no-nanny", "--local-directory", str(folder))
        with distributed.Client(url, set_as_default=False) as client:
            client.wait_for_workers(2, timeout=300)
        yield url
    finally:
        for each in reversed(programs):
            each.terminate()
            each.join()


@pytest.mark.whole
def test_a_cluster_gives_the_same_bytes(undisturbed, tmp_path):
    with cluster(tmp_path) as url:
        process, errors = sweeping(tmp_path / "out", "--scheduler", url)
        process.join()
    assert process.exitcode == 0, errors.read_text(encoding="utf-8")
    assert (tmp_path / "out" / "example.nc").read_bytes() == undisturbed


def test_local_processes_give_the_same_bytes(undisturbed, tmp_path):
    sweep = Sweep(example.STUDY, tmp_path, {}, 120, 10)
    prepare(sweep)
    with ProcessPoolExecutor(2) as executor:
        finished(sweep, executor, 4)
    assert sweep.result.read_bytes() == undisturbed


def invoke(*arguments):
    return CliRunner().invoke(main, ["study", *arguments])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["near-critical", "--members", "0"], "members: expected at least 1, got 0"),
        (["near-critical", "--relief", "-1"], "relief: expected a positive length, got -1.0"),
        (["near-critical", "--digits", "17"], "digits: expected more than 0 and at most 16, got 17.0"),
        (["near-critical", "--base", "nan"], "base: expected a positive length, got nan"),
        (["near-critical", "--jobs", "2", "--scheduler", "tcp://127.0.0.1:1"], "expected either --jobs or --scheduler"),
        (["near-critical", "--members", "many"], "'many' is not a valid integer"),
        (["nothing"], "No such command 'nothing'"),
    ],
)
def test_wrong_usage_is_exit_status_2_before_work_begins(tmp_path, arguments, message):
    result = invoke(*arguments, *(["--out", str(tmp_path / "new")] if len(arguments) > 1 else []))
    assert result.exit_code == 2
    assert message in result.stderr
    assert not (tmp_path / "new").exists()


def test_a_scheduler_that_does_not_answer_is_exit_status_2(tmp_path, monkeypatch):
    monkeypatch.setattr("algebroproj_sym.cli.study.CONNECTING", "1s")
    result = invoke("near-critical", "--scheduler", "tcp://127.0.0.1:9", "--out", str(tmp_path))
    assert result.exit_code == 2
    assert "no cluster answers at tcp://127.0.0.1:9" in result.stderr


def test_a_folder_that_cannot_be_written_is_exit_status_2(tmp_path):
    (tmp_path / "file").touch()
    result = invoke("near-critical", "--out", str(tmp_path / "file" / "folder"))
    assert result.exit_code == 2
    assert "cannot be written" in result.stderr


def test_a_report_that_needs_its_members_in_memory_is_given_some_of_them(tmp_path, monkeypatch):
    monkeypatch.setattr(normal_case, "STUDY", replace(normal_case.STUDY, shown=40))
    result = invoke("normal-case", "--members", "100", "--out", str(tmp_path))
    assert result.exit_code == 0, result.output
    assert "Report and figures show one member in 3." in result.stdout


def test_without_the_extra_the_command_says_how_to_install_it(monkeypatch):
    monkeypatch.setattr("algebroproj_sym.cli.steps.find_spec", lambda name: None)
    result = invoke("near-critical")
    assert result.exit_code == 1
    assert "pip install 'algebroproj-sym[study]'" in result.stderr


def test_a_finished_study_is_drawn_again_by_another_version(tmp_path, monkeypatch):
    assert invoke("normal-case", "--members", "10", "--out", str(tmp_path)).exit_code == 0
    report, kept = (tmp_path / "report.txt").read_bytes(), (tmp_path / "normal-case.nc").read_bytes()
    drawings = sorted(path.name for path in (tmp_path / "figures").iterdir())
    shutil.rmtree(tmp_path / "figures")
    (tmp_path / "report.txt").unlink()
    monkeypatch.setattr("algebroproj_sym.study.sweeping.provenance", lambda source: {"source": "another"})
    assert invoke("normal-case", "--members", "10", "--out", str(tmp_path)).exit_code == 2
    result = invoke("redraw", str(tmp_path))
    assert result.exit_code == 0, result.output
    assert result.stdout.splitlines()[:-1] == report.decode().splitlines()
    assert (tmp_path / "report.txt").read_bytes() == report
    assert sorted(path.name for path in (tmp_path / "figures").iterdir()) == drawings
    assert (tmp_path / "normal-case.nc").read_bytes() == kept
    flipped(tmp_path / "normal-case.nc")
    result = invoke("redraw", str(tmp_path))
    assert result.exit_code == 2
    assert "expected the dataset as the study wrote it, got none or a damaged one" in " ".join(result.stderr.split())


@pytest.mark.parametrize(
    "text", [None, "", "[]", "null", '{"arguments": 1}', '{"arguments": {"study": "a", "members": -1}}']
)
def test_what_is_no_finished_study_is_not_drawn(tmp_path, text):
    if text is not None:
        (tmp_path / "manifest.json").write_text(text)
    result = invoke("redraw", str(tmp_path))
    assert result.exit_code == 2
    assert "expected a folder of a study with manifest.json" in " ".join(result.stderr.split())
