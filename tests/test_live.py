"""The prover in the pages: what it is told, what is fetched, and what a browser shows."""

import json
import shutil
import subprocess
import sys
import threading
import zlib
from functools import partial
from hashlib import sha256
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from importlib.resources import files as resources
from io import BytesIO
from pathlib import Path
from zipfile import ZipFile

import pytest
from cases import for_each
from click.testing import CliRunner

from algebroproj_sym import prove
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import KINDS as CLAIM_KINDS
from algebroproj_sym.declaring import judge, select
from algebroproj_sym.reporting.ledger import ledger
from algebroproj_sym.reporting.live.answering import CONDITIONS, MOST_CHARACTERS, answer
from algebroproj_sym.reporting.live.bundling import own_sources
from algebroproj_sym.reporting.live.compiling import compiled
from algebroproj_sym.reporting.live.fetching import FetchError, Package, fetched, genuine, pinned
from algebroproj_sym.reporting.live.questions import KINDS, question

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
WAIT = 300_000
ASK = "(question) => document.querySelector('[data-live]').prover.ask(question)"


def told(**asked):
    return json.loads(answer(json.dumps(asked)))


def test_a_formula_is_decided_as_the_prover_decides_it():
    assert told(do="prove", lhs="(1 - c)/s", rhs="s/(1 + c)", constraints=["c^2 + s^2 = 1"])["verdict"] == "proved"
    refuted = told(do="prove", lhs="(a + b)^2", rhs="a^2 + b^2")
    point = refuted["counterexample"]
    assert refuted["verdict"] == "refuted"
    assert refuted["left"] == [str((int(point["a"]) + int(point["b"])) ** 2)]
    assert told(do="prove", lhs="sqrt(x^2)", rhs="x", assumptions=["x >= 0"])["verdict"] == "proved"


def test_names_stand_for_their_forms_which_may_use_other_names():
    where = {"a": "b + 1", "b": "2*c"}
    assert told(do="prove", lhs="a", rhs="2*c + 1", where=where)["verdict"] == "proved"
    assert told(do="prove", lhs="a", rhs="2*c", where=where)["verdict"] == "refuted"


LONG = "x" * (MOST_CHARACTERS + 1)


@pytest.mark.parametrize("lhs", ["1/(1 + x", LONG, "x^10000000000", "f(x)", "", "1/0", "\x1b[31m"])
def test_input_that_cannot_be_read_is_an_error_and_no_traceback(lhs):
    assert told(do="prove", lhs=lhs, rhs="x").keys() == {"error"}


ENTRIES = {
    **{"do": "prove", "lhs": "x", "rhs": "x", "relation": "=", "where": {}, "claim": {}},
    **{"constraints": [], "letters": []},
}


@for_each("entry", ENTRIES)
@for_each("value", [None, 5, "?", [5], {"x": 5}])
def test_a_question_of_another_form_is_an_error_and_no_traceback(entry, value):
    """Whatever is asked, it is told as JSON."""
    asked = {**ENTRIES, entry: value}
    for do in (asked["do"], "replay"):
        assert told(**{**asked, "do": do}).keys() & {"error", "verdict", "status"}
    del asked[entry]
    assert told(**asked).keys() & {"error", "verdict"}


@for_each("question", ["", "null", "[]", "{}", "5", '{"do": "eval"}', '{"do": []}', "{" * 99999, "[" * 99999])
def test_what_is_no_question_is_an_error_and_no_traceback(question):
    assert json.loads(answer(question)).keys() == {"error"}


def test_a_divisor_that_is_zero_by_what_names_stand_for_is_an_error():
    told_so = told(do="prove", lhs="1/(a - b)", rhs="x", where={"a": "c", "b": "c"})
    assert "denominator" in told_so["error"]


@pytest.fixture(scope="module")
def entries():
    selectors = ("fundamentals1996:1.3", "fundamentals1996:3.3", "okamoto1981:1.1")
    return ledger([judge(claim) for claim in select(selectors)], timed=False)["claims"]


@pytest.mark.parametrize("verdict", ["proved", "misprint", "error", "illegible"])
def test_a_claim_of_the_ledger_is_checked_again_and_a_changed_one_is_rejected(entries, verdict):
    entry = next(entry for entry in entries if entry["verdict"] == verdict and entry["kind"] == "identity")
    assert told(do="replay", claim=entry) == {"status": "replayed", "reason": ""}
    assert told(do="replay", claim={**entry, "derived": "17"})["status"] == "rejected"


def test_what_a_page_asks_of_a_claim_has_the_verdict_of_the_claim(entries):
    expected = {"proved": "proved", "misprint": "refuted", "error": "refuted", "illegible": "proved"}
    asked = [(entry, question(entry)) for entry in entries]
    known = [(entry, each) for entry, each in asked if each and entry["verdict"] in expected]
    assert len(known) > 20
    assert {entry["verdict"] for entry, _ in known} >= {"proved", "misprint", "error"}
    assert any(entry["where"] for entry, _ in known)
    for entry, each in known:
        given = {key: getattr(each, key).splitlines() for key in CONDITIONS}
        found = told(do="prove", lhs=each.lhs, rhs=each.rhs, where=entry["where"], **given)
        assert found["verdict"] == expected[entry["verdict"]], entry["number"]


def test_a_page_asks_with_all_conditions_or_does_not_ask():
    """Without them the verdict would be that of another statement."""
    record = {"kind": "identity", "printed": "sqrt(x**2)", "derived": "x", "setting": {"assumptions": ["x >= 0"]}}
    asked = question(record)
    assert told(do="prove", lhs=asked.lhs, rhs=asked.rhs, assumptions=[asked.assumptions])["verdict"] == "proved"
    assert question({**record, "setting": {"variable": "x"}}) is None


def test_a_page_asks_about_letters_and_a_changed_sign_is_refuted():
    (claim,) = select(["bridges:5/epipole"])
    asked = question(ledger([judge(claim)], timed=False)["claims"][0])
    conditions = {key: getattr(asked, key).splitlines() for key in (*CONDITIONS, "letters")}
    assert told(do="prove", lhs=asked.lhs, rhs=asked.rhs, **conditions)["verdict"] == "proved"
    assert told(do="prove", lhs="E*t", rhs=asked.rhs, **conditions)["verdict"] == "refuted"
    assert "such as R: 3x3 rotation" in told(do="prove", lhs="E", rhs="E", letters=["E"])["error"]


def test_an_inequality_is_decided():
    assert told(do="prove", lhs="x + 1/x", rhs="2", relation=">=", assumptions=["x > 0"])["verdict"] == "proved"
    assert told(do="prove", lhs="x", rhs="2", relation="~")["error"].startswith("relation: expected one of")


def test_the_kinds_that_a_page_can_ask_about_exist():
    assert {*KINDS} <= CLAIM_KINDS.keys()


def test_the_modules_in_the_page_are_enough_to_answer(tmp_path):
    content = own_sources()
    assert content == own_sources()
    ZipFile(BytesIO(content)).extractall(tmp_path)
    script = (
        "import sys; sys.path.insert(0, '.'); from algebroproj_sym.reporting.live.answering import answer\n"
        "import algebroproj_sym; assert algebroproj_sym.__file__.startswith(sys.argv[1])\n"
        "loaded = {name.partition('.')[0] for name in sys.modules}\n"
        "assert not loaded & {'sympy', 'flint', 'numpy', 'click', 'jinja2'}\n"
        'asked = \'"lhs": "cos(acos(x) + acos(y))", "rhs": "x*y - sqrt(1 - x^2)*sqrt(1 - y^2)"\'\n'
        'print(answer(\'{"do": "prove", \' + asked + "}"))\n'
        "assert not {name.partition('.')[0] for name in sys.modules} & {'numpy', 'click', 'jinja2', 'rich'}\n"
    )
    command = [sys.executable, "-c", script, str(tmp_path)]
    ran = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert json.loads(ran.stdout)["verdict"] == "proved"


def test_the_modules_are_the_same_bytes_on_every_machine(monkeypatch):
    """Neither the system nor the version of zlib has a say."""
    content = own_sources()
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(zlib, "compressobj", None)
    assert own_sources() == content


INNER = '''"""Forty-two lines about it."""
from __future__ import annotations
class Documented:
    """Forty-two more."""
def answer(found={'a', 'b', 'c'}):
    """And forty-two."""
    assert found, "assertions stay"
    return sorted(found) if answer.__doc__ is Documented.__doc__ is None else []
'''


def test_the_modules_of_a_wheel_are_compiled_without_its_tests_and_docstrings_and_with_its_licence(tmp_path):
    """They are imported without their source, and the same wheel gives the same bytes."""
    wheel = BytesIO()
    with ZipFile(wheel, "w") as archive:
        archive.writestr("demo/__init__.py", "from demo.inner import answer")
        archive.writestr("demo/inner.py", INNER)
        archive.writestr("demo/tests/test_inner.py", "raise SystemExit")
        archive.writestr("demo-1.dist-info/LICENSE", "MIT")
        archive.writestr("demo-1.dist-info/RECORD", "demo/__init__.py,,")
    content = compiled(wheel.getvalue())
    assert content == compiled(wheel.getvalue())
    (tmp_path / "demo.zip").write_bytes(content)
    with ZipFile(BytesIO(content)) as archive:
        assert archive.namelist() == ["demo-1.dist-info/LICENSE", "demo/__init__.pyc", "demo/inner.pyc"]
        assert b"Forty-two" not in archive.read("demo/inner.pyc")
        assert b"assertions stay" in archive.read("demo/inner.pyc")
    command = [sys.executable, "-c", "import sys; sys.path.insert(0, 'demo.zip'); import demo; print(demo.answer())"]
    ran = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert ran.stdout == "['a', 'b', 'c']\n"


def test_a_package_with_another_digest_is_refused():
    package = Package("npm", "demo", "1", "demo.tgz", sha256(b"expected").hexdigest())
    assert genuine(package, b"expected") == b"expected"
    with pytest.raises(FetchError, match=r"demo\.tgz: expected the SHA-256 digest"):
        genuine(package, b"expecteD")


def test_what_cannot_be_fetched_is_named(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(FetchError, match="npm is not installed; it fetches pyodide"):
        fetched(pinned()[0], tmp_path)


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A site with the prover."""
    folder = tmp_path_factory.mktemp("live") / "site"
    selectors = ("fundamentals1996:3.3", "bridges:5")
    result = CliRunner().invoke(main, ["report", *selectors, "--samples", "2", "--live", "--out", str(folder)])
    assert result.exit_code == 0, result.output
    return folder


@pytest.fixture(scope="module")
def served(folder):
    """The address where it is."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()


@pytest.fixture(scope="module")
def browser():
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=CHROMIUM, args=("--no-sandbox", "--disable-gpu"))
        yield opened
        opened.close()


@pytest.fixture(scope="module")
def page(served, browser):
    opened = browser.new_page()
    opened.set_default_timeout(WAIT)
    foreign = []
    opened.on("request", lambda request: None if request.url.startswith(served) else foreign.append(request.url))
    yield opened
    assert foreign == []


@pytest.mark.whole
@pytest.mark.extra("dev")
@pytest.mark.skipif(CHROMIUM is None, reason="NOT TESTED IN A BROWSER: there is no Chromium")
@pytest.mark.skipif(shutil.which("npm") is None, reason="NOT TESTED IN A BROWSER: there is no npm")
class TestBrowser:
    def verdict(self, page):
        return page.locator("output .verdict").inner_text()

    def test_the_evidence_stands_once_on_a_site_and_the_modules_are_compiled(self, folder):
        with ZipFile(folder / "live" / "algebroproj_sym.zip") as archive:
            assert {Path(name).suffix for name in archive.namelist()} == {".pyc"}
        evidence = [path.name for path in folder.glob("**/*.json") if b'"certificate"' in path.read_bytes()]
        assert evidence == ["ledger.json"]

    def test_a_claim_is_checked_again_and_a_changed_sign_is_refuted(self, served, page):
        page.goto(f"{served}/fundamentals1996/3.3.7~right.html")
        page.get_by_role("button", name="Check the evidence again").click()
        assert self.verdict(page) == "replayed"
        page.get_by_label("Printed form").fill("1 + z12")
        page.get_by_role("button", name="Prove").click()
        page.locator("output .verdict[data-verdict=proved]").wait_for()
        page.get_by_label("Printed form").fill("1 - z12")
        page.get_by_role("button", name="Prove").click()
        page.locator("output .verdict[data-verdict=refuted]").wait_for()
        assert "z12 =" in page.locator("output").inner_text()

    def test_letters_and_relations_are_decided(self, served, page):
        page.goto(f"{served}/bridges/5_epipole.html")
        page.get_by_label("Printed form").fill("E*t")
        page.get_by_role("button", name="Prove").click()
        page.locator("output .verdict[data-verdict=refuted]").wait_for()
        page.goto(f"{served}/prover.html")
        for name, text in (("Left", "x + 1/x"), ("Right", "2"), ("Equations", ""), ("Other", "x > 0")):
            page.get_by_label(name).fill(text)
        page.get_by_label("Relation").select_option(">=")
        page.get_by_role("button", name="Prove").click()
        page.locator("output .verdict[data-verdict=proved]").wait_for()

    @pytest.mark.parametrize("name", ["prover.html", "bridges/5_epipole.html", "fundamentals1996/3.3.7~right.html"])
    def test_axe_finds_no_barrier_in_the_prover(self, served, page, name):
        from axe_playwright_python.sync_playwright import Axe

        page.goto(f"{served}/{name}")
        page.get_by_role("button", name="Prove").click()
        page.locator("output .verdict").wait_for()
        for width in (1280, 390):
            page.set_viewport_size({"width": width, "height": 844})
            found = Axe().run(page, options={"preload": False}).response["violations"]
            assert [(each["id"], [node["html"][:200] for node in each["nodes"]]) for each in found] == []
            assert page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth") == 0

    def test_a_question_can_be_stopped_and_another_one_asked(self, served, page):
        page.goto(f"{served}/prover.html")
        page.get_by_role("button", name="Prove").click()
        page.get_by_role("button", name="Stop").click()
        page.locator("output").get_by_text("Stopped.").wait_for()
        page.get_by_role("button", name="Prove").click()
        page.locator("output .verdict[data-verdict=proved]").wait_for()

    def test_the_corpus_has_the_same_verdicts_as_here(self, served, page, repository):
        items = [item for name in ("ring", "field", "hypotheses", "functions") for item in corpus(repository, name)][
            ::25
        ]
        assert len(items) > 20
        page.goto(f"{served}/prover.html")
        differ = []
        for item in items:
            given = {key: item.get(key, []) for key in ("constraints", "nonzero", "assumptions")}
            asked = {"do": "prove", "lhs": item["lhs"], "rhs": item["rhs"], **given}
            here = prove(item["lhs"], item["rhs"], **given).verdict
            there = page.evaluate(ASK, asked)
            if there.get("verdict") != here:
                differ.append((item["name"], here, there))
        assert differ == []


FORM = """<section data-live hidden><form><textarea name=lhs>x</textarea><textarea name=rhs>x</textarea>
<button>Prove</button></form><button data-do=stop hidden>Stop</button><progress hidden></progress>
<span role=status></span><output></output></section><script src="live.js"></script>"""
WORKER = """window.Worker = class {
  constructor() { window.worker = this; this.asked = []; }
  postMessage(data) { if (data.question.do === "prove") this.asked.push(data); }
  terminate() { this.asked = []; }
  tell(verdict) {
    const answer = { verdict, hypotheses: [], counterexample: {}, left: [], right: [], reason: "" };
    this.onmessage({ data: { id: this.asked.shift().id, answer } });
  }
};"""


@pytest.mark.extra("dev")
@pytest.mark.skipif(CHROMIUM is None, reason="NOT TESTED IN A BROWSER: there is no Chromium")
def test_a_verdict_is_shown_only_beside_the_question_that_it_answers(tmp_path, browser):
    """When a form is changed, a verdict of the earlier form vanishes, and one that comes later is not shown."""
    script = resources("algebroproj_sym.reporting.live") / "templates" / "live.js"
    (tmp_path / "live.js").write_bytes(script.read_bytes())
    (tmp_path / "index.html").write_text(FORM)
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=tmp_path))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    page = browser.new_page()
    page.add_init_script(WORKER)
    page.goto(f"http://127.0.0.1:{server.server_port}/index.html")
    verdict, prove_it, stop = page.locator(".verdict"), page.get_by_text("Prove"), page.get_by_text("Stop")
    prove_it.click()
    page.wait_for_function("worker.asked.length === 1")
    page.evaluate("worker.tell('proved')")
    verdict.wait_for()
    page.locator("[name=rhs]").fill("y")
    assert verdict.count() == 0
    prove_it.click()
    page.wait_for_function("worker.asked.length === 1")
    page.locator("[name=rhs]").fill("z")
    prove_it.click()
    page.wait_for_function("worker.asked.length === 2")
    page.evaluate("worker.tell('refuted')")
    assert (verdict.count(), stop.is_visible()) == (0, True)
    page.evaluate("worker.tell('open')")
    verdict.wait_for()
    assert (verdict.inner_text(), stop.is_visible()) == ("open", False)
    page.close()
    server.shutdown()


def corpus(repository: Path, name: str) -> list[dict]:
    return json.loads((repository / "tests" / "corpus" / f"{name}.json").read_text(encoding="utf-8"))
