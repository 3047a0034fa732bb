"""Whether the prover in the page decides as the one installed here, and how long each takes.

    algebroproj report lens --live --out site && python benchmarks/live.py site [STEP]

Every STEP-th statement of `tests/corpus` that takes less than a second here is asked in headless Chromium.
It ends with 1 if a verdict differs.
"""

import json
import sys
import threading
import time
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from shutil import which
from statistics import median

from playwright.sync_api import sync_playwright

from algebroproj_sym import prove

CORPUS = Path(__file__).parents[1] / "tests" / "corpus"
KEYS = ("constraints", "nonzero", "assumptions")
LONGEST = 1.0
ASK = "document.querySelector('[data-live]').prover.ask"


class Quiet(SimpleHTTPRequestHandler):
    """A server that does not write a line for each request."""

    def log_message(self, *_):
        """Write nothing."""


def quick(step):
    """Yield what takes less than a second here, with its verdict."""
    items = [item for path in sorted(CORPUS.glob("*.json")) for item in json.loads(path.read_text(encoding="utf-8"))]
    for item in items[::step]:
        asked = {key: item[key] for key in ("relation", "letters", *KEYS) if key in item}
        start = time.perf_counter()
        try:
            verdict = prove(item["lhs"], item["rhs"], **asked).verdict
        except ValueError:
            verdict = None
        if time.perf_counter() - start < LONGEST:
            letters = [f"{name}: {meaning}" for name, meaning in asked.get("letters", {}).items()]
            yield {"do": "prove", "lhs": item["lhs"], "rhs": item["rhs"], **asked, "letters": letters}, verdict


def main(site, step="1"):
    """Print the cold start, the times, and what differs."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=site))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    known = [*quick(int(step))]
    executable = next(filter(None, map(which, ("chromium", "chromium-browser", "google-chrome"))))
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=("--no-sandbox", "--disable-gpu"))
        page = browser.new_page()
        page.set_default_timeout(600_000)
        start = time.perf_counter()
        page.goto(f"http://127.0.0.1:{server.server_port}/prover.html")
        page.evaluate(f"{ASK}({{do: 'prepare'}})")
        print(f"cold start {time.perf_counter() - start:.1f} s")
        seconds, differ = [], []
        for question, here in known:
            start = time.perf_counter()
            there = page.evaluate(f"(question) => {ASK}(question)", question)
            seconds.append(time.perf_counter() - start)
            if there.get("verdict") != here:
                differ.append((question["lhs"], question["rhs"], here, there))
        browser.close()
    print(f"{len(known)} statements: median {median(seconds):.3f} s, longest {max(seconds):.2f} s")
    print(f"{sum(each > 2 for each in seconds)} take more than 2 s; {len(differ)} verdicts differ")
    for each in differ:
        print(*(str(part)[-300:] for part in each), sep="\n  ")
    return bool(differ)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
