"""What is remembered is what would be proved again, byte by byte, or it is proved again."""

import json
import os
import subprocess
import sys
from dataclasses import fields, replace
from pathlib import Path

import pytest
import sympy
from click.testing import CliRunner

from algebroproj_sym import Section, pipeline
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import judge, select
from algebroproj_sym.expressions import over, vector
from algebroproj_sym.remembering import Memory, cache_folder, key, key_of
from algebroproj_sym.reporting import ledger

x, y, z = sympy.symbols("x y z")
SELECTORS = ("fundamentals1996:1.3", "fundamentals1996:2.2", "fundamentals1996:4/b", "okamoto1981:54", "rhodos1990")


CANCELLED = over(x**3, x)


def square(printed=x**2, derived=CANCELLED, **options):
    return Section("demo", "1", "Squares").identity("1.1", "square", printed=printed, derived=derived, **options)


def judged(claims, memory):
    return list(pipeline.check(claims, memory=memory))


def entries_in(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.json"))


@pytest.fixture
def counted(monkeypatch):
    """The numbers of the claims that are really proved."""
    proved = []

    def judge_and_count(claim, engine):
        proved.append(claim.number)
        return judge(claim, engine)

    monkeypatch.setattr(pipeline, "judge", judge_and_count)
    return proved


def test_real_claims_are_remembered_as_they_were_proved(tmp_path, counted):
    claims = select(SELECTORS)
    fresh = judged(claims, Memory(tmp_path))
    assert len(counted) == len(claims)
    again = judged(claims, Memory(tmp_path))
    assert len(counted) == len(claims)
    assert again == fresh
    assert json.dumps(ledger(again)) == json.dumps(ledger(fresh))


def test_only_what_has_changed_is_proved(tmp_path, counted):
    section = Section("demo", "1", "Squares")
    for number in ("1.1", "1.2", "1.3"):
        section.identity(number, "square", printed=x**2, derived=x * x)
    judged(section.claims, Memory(tmp_path))
    counted.clear()
    changed = [section.claims[0], replace(section.claims[1], printed=x**3), section.claims[2]]
    assert [judgement.verdict for judgement in judged(changed, Memory(tmp_path))] == ["proved", "false", "proved"]
    assert counted == ["1.2"]


def test_a_fresh_run_recalls_nothing_and_mends_what_is_there(tmp_path, counted):
    claim = square()
    judged([claim], Memory(tmp_path))
    entries_in(tmp_path)[0].write_text("{}", encoding="utf-8")
    judged([claim], Memory(tmp_path, fresh=True))
    assert counted == ["1.1", "1.1"]
    judged([claim], Memory(tmp_path))
    assert counted == ["1.1", "1.1"]


OTHERS = {
    **dict.fromkeys(("paper", "section", "number", "title", "instead", "note"), "other"),
    **{"kind": "limit", "expected": "false", "printed": over(x**2, 1), "derived": x**2, "corrected": x},
    **{"where": {x: y}, "constraints": (x,), "nonzero": (x,), "witness": {x: 1}, "variable": x, "variables": (x,)},
    **{"kernel": (vector(x, y),), "rounding": "cut"},
    **{"assumed": (sympy.Symbol("x", positive=True),)},
}


def test_every_part_of_a_declaration_counts():
    claim = square()
    assert {field.name for field in fields(claim) if field.compare} == OTHERS.keys()
    keys = [key_of(replace(claim, **{name: value}), "flint") for name, value in OTHERS.items()]
    assert len({key_of(claim, "flint"), key_of(claim, "sympy"), *keys}) == len(keys) + 2


def test_a_division_that_cancels_counts():
    assert key_of(square(), "flint") != key_of(square(derived=x**2), "flint")


def test_another_prover_believes_nothing(tmp_path, counted, monkeypatch):
    judged([square()], Memory(tmp_path))
    monkeypatch.setattr(key, "prover", lambda: "another")
    judged([square()], Memory(tmp_path))
    assert counted == ["1.1", "1.1"]


def test_the_source_of_the_prover_counts(tmp_path, monkeypatch):
    before = key.prover()
    key.prover.cache_clear()
    (tmp_path / "proving").mkdir()
    (tmp_path / "proving" / "prove.py").write_text("", encoding="utf-8")
    monkeypatch.setattr(key, "ROOT", tmp_path)
    try:
        assert key.prover() != before
    finally:
        key.prover.cache_clear()


@pytest.mark.parametrize(
    "damage",
    [
        lambda content: "",
        lambda content: content[: len(content) // 2],
        lambda content: "[]",
        lambda content: "null",
        lambda content: content.replace('"false"', '"proved"'),
        lambda content: content.replace('"counterexample": {', '"counterexample": {"y": "1", '),
        lambda content: content.replace('"left": ["', '"left": ["1'),
        lambda content: json.dumps({**json.loads(content), "evidence": {}}),
    ],
)
def test_a_damaged_entry_is_proved_again(tmp_path, counted, damage):
    claim = square(printed=x**2 + 1, expect="false", instead="1.1")
    fresh = judged([claim], Memory(tmp_path))
    (file,) = entries_in(tmp_path)
    content = file.read_text(encoding="utf-8")
    assert damage(content) != content
    file.write_text(damage(content), encoding="utf-8")
    (again,) = judged([claim], Memory(tmp_path))
    assert (again.verdict, again.certificate) == (fresh[0].verdict, fresh[0].certificate)
    assert counted == ["1.1", "1.1"]


def test_the_entry_of_another_claim_is_not_believed(tmp_path, counted):
    right, wrong = square(), square(printed=x**3, expect="false", instead="1.1")
    judged([right], Memory(tmp_path))
    (proved,) = entries_in(tmp_path)
    judged([wrong], Memory(tmp_path))
    (refuted,) = {*entries_in(tmp_path)} - {proved}
    refuted.write_bytes(proved.read_bytes())
    assert judged([wrong], Memory(tmp_path))[0].verdict == "false"
    assert counted == ["1.1"] * 3


def test_without_a_folder_to_write_to_everything_is_proved(tmp_path, counted):
    file = tmp_path / "file"
    file.write_text("", encoding="utf-8")
    for _ in range(2):
        assert judged([square()], Memory(file))[0].verdict == "proved"
    assert counted == ["1.1", "1.1"]


def test_runs_at_the_same_time_do_not_disturb_each_other(tmp_path):
    command = [sys.executable, "-m", "algebroproj_sym", "check", "rhodos1990", "--fresh", "--format", "json"]
    environment = os.environ | {"ALGEBROPROJ_CACHE": str(tmp_path)}
    runs = [subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    verdicts = [[claim["verdict"] for claim in json.loads(run.communicate()[0])["claims"]] for run in runs]
    assert verdicts[0] == verdicts[1]
    assert len(entries_in(tmp_path)) == len(verdicts[0]) > 0
    assert [path for path in tmp_path.rglob("*") if path.is_file() and path.suffix != ".json"] == []


def test_the_command_gives_the_same_bytes(tmp_path, monkeypatch):
    monkeypatch.setenv("ALGEBROPROJ_CACHE", str(tmp_path))
    assert cache_folder() == tmp_path

    def output(*options):
        result = CliRunner().invoke(main, ["check", "critical1996", "--format", "json", *options])
        assert result.exit_code == 0
        return [{k: v for k, v in claim.items() if k != "seconds"} for claim in json.loads(result.stdout)["claims"]]

    first, second, fresh = output(), output(), output("--fresh")
    assert first == second == fresh
    assert len(entries_in(tmp_path)) == len(first)
