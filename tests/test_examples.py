"""The examples are bodies of claims of other fields, which the machinery judges without knowing them."""

import ast
import json
from collections import Counter

import pytest
from click.testing import CliRunner

from algebroproj_sym.cli import main
from algebroproj_sym.declaring import derivation_at, judge, kernels

BODIES = ("elliptic_curves",)
LIMIT = 2.0


@pytest.fixture(scope="module", params=BODIES)
def body(request, repository):
    return repository / "examples" / request.param


@pytest.fixture(scope="module")
def judgements(body):
    return [judge(claim) for derivation in derivation_at(body) for claim in derivation.section.claims]


def test_every_claim_is_as_declared(judgements):
    assert [judgement.claim.number for judgement in judgements if not judgement.as_declared] == []


def test_there_are_claims_of_several_kinds_and_verdicts(judgements):
    verdicts = Counter(judgement.verdict for judgement in judgements)
    assert verdicts.total() >= 25
    assert set(verdicts) >= {"proved", "misprint", "false", "definition"}
    assert len({judgement.claim.kind for judgement in judgements}) >= 5


def test_every_claim_is_fast(judgements):
    assert [judgement.claim.number for judgement in judgements if judgement.seconds > LIMIT] == []


def test_what_is_refuted_has_a_counterexample(judgements):
    assert all(j.counterexample for j in judgements if j.verdict in ("misprint", "false"))


def test_both_engines_agree_on_what_is_not_simply_proved(judgements):
    for judgement in judgements:
        if judgement.verdict in ("misprint", "false"):
            assert judge(judgement.claim, "sympy").verdict == judgement.verdict, judgement.claim.number


def test_the_functions_are_generated_and_verified(body, tmp_path):
    name = f"{body.name}_functions"
    arguments = ["build", "--derivations", str(body), "--name", name, "--out", str(tmp_path), "--samples", "6"]
    result = CliRunner().invoke(main, arguments)
    assert result.exit_code == 0, result.output
    figures = json.loads((tmp_path / "accuracy.json").read_text(encoding="utf-8"))["functions"]
    assert [figure["function"] for figure in figures] == [k.qualified_name for k in kernels((), (str(body),))]
    assert len(figures) >= 2
    assert all(figure["passed"] and figure["source_proved"] for figure in figures)
    ledger = json.loads((tmp_path / "ledger.json").read_text(encoding="utf-8"))
    assert {claim["paper"] for claim in ledger["claims"]} == {body.name}
    modules = {kernel.module for kernel in kernels((), (str(body),))}
    assert {path.stem for path in (tmp_path / name).glob("[a-z]*.py")} == modules


def test_the_machinery_does_not_know_the_examples(body, repository):
    for file in (repository / "algebroproj_sym").rglob("*.py"):
        assert body.name not in file.read_text(encoding="utf-8"), file


def test_the_examples_import_the_machinery_and_sympy_alone(body):
    for file in body.glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module] if isinstance(node, ast.ImportFrom) else []
            assert {name.partition(".")[0] for name in names} <= {"sympy", "algebroproj_sym", body.name}
