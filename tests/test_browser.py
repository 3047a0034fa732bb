"""The site in a browser: headless Chromium opens it from disk, and axe-core looks for barriers.

``pytest tests/test_browser.py --site DIR`` checks every page of a site that was written before.
"""

import re
import shutil
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
OPTIONS = (
    *("--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
)
SELECTORS = ("fundamentals1996:2.2", "fundamentals1996:1.2", "rhodos1990:1.1", "bridges:5")
REPRESENTATIVE = (
    "index.html",
    "search.html",
    "functions/index.html",
    "functions/correlation.correlation_matrix.html",
    "fundamentals1996/index.html",
    "fundamentals1996/errata.html",
    "fundamentals1996/symbols.html",
    "fundamentals1996/graph.html",
    "fundamentals1996/graph-2.2.html",
    "bridges/5_epipole.html",
    "fundamentals1996/2.2.4.html",
    "fundamentals1996/2.2.6.html",
    "fundamentals1996/2.2_eight-points.html",
    "rhodos1990/errata.html",
    "notebooks/algebroproj_derivations.fundamentals1996.s1_2_determination_of_projection.html",
)
DESKTOP, PHONE = {"width": 1280, "height": 900}, {"width": 390, "height": 844}
READ_PAGE = """() => {
  const shown = (element) => !element.closest("details:not([open]), [popover]:not(:popover-open)");
  const boxes = [...document.querySelectorAll("math")].filter(shown).map((m) => m.getBoundingClientRect());
  return {
    math: boxes.length,
    empty: boxes.filter((box) => box.width === 0 || box.height === 0).length,
    links: [...document.querySelectorAll("[href], [src]")]
      .map((element) => new URL(element.getAttribute("href") ?? element.getAttribute("src"), document.baseURI).href),
    anchors: [...document.querySelectorAll("[id]")].map((element) => element.id),
    cut: [...document.querySelectorAll(".formula, .line-formula, .wide")].filter(shown)
      .filter((element) => element.scrollHeight > element.clientHeight + 1).map((element) => element.outerHTML),
    overflow: document.documentElement.scrollWidth - document.documentElement.clientWidth,
  };
}"""

pytestmark = [
    pytest.mark.whole,
    pytest.mark.skipif(
        CHROMIUM is None, reason="NOT TESTED IN A BROWSER: there is no Chromium; install Debian's package chromium"
    ),
]


@dataclass
class Visit:
    """What the browser found on the pages of a site."""

    pages: int = 0
    math: int = 0
    links: set = field(default_factory=set)
    anchors: dict = field(default_factory=dict)
    problems: list = field(default_factory=list)


@pytest.fixture(scope="module")
def site(request, tmp_path_factory):
    given = request.config.getoption("--site")
    if given:
        return given.resolve()
    folder = tmp_path_factory.mktemp("browser") / "site"
    command = [sys.executable, "-m", "algebroproj_sym", "report", *SELECTORS, "--notebooks", "--samples", "2"]
    subprocess.run([*command, "--out", str(folder)], check=True, capture_output=True)
    return folder


@pytest.fixture(scope="module")
def browser():
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=CHROMIUM, args=OPTIONS)
        yield chromium
        chromium.close()


def opened(browser, problems, **options):
    """Return a page of the browser that reports errors, and whatever it loads from elsewhere than from disk."""
    page = browser.new_page(**options)
    page.on("console", lambda message: problems.append((page.url, message.text)) if message.type == "error" else None)
    page.on("pageerror", lambda error: problems.append((page.url, str(error))))
    page.on("requestfailed", lambda request: problems.extend(failures(page, request)))
    page.on("request", lambda request: None if is_local(request.url) else problems.append((page.url, request.url)))
    return page


def failures(page, request):
    """Return what could not be loaded; a request that ends since the next page is opened is no failure."""
    if request.failure == "net::ERR_ABORTED":
        return []
    return [(page.url, f"cannot be loaded: {request.url}, {request.failure}")]


def is_local(address):
    return urlsplit(address).scheme in ("file", "data")


def addresses(site, request):
    """Return the pages whose barriers are looked for."""
    every = sorted(path.relative_to(site).as_posix() for path in site.rglob("*.html"))
    return every if request.config.getoption("--site") else [name for name in REPRESENTATIVE if name in every]


@pytest.fixture(scope="module")
def visit(site, browser):
    """Open every page once."""
    found = Visit()
    page = opened(browser, found.problems, viewport=DESKTOP)
    for path in sorted(site.rglob("*.html")):
        page.goto(path.as_uri())
        read = page.evaluate(READ_PAGE)
        found.pages += 1
        found.math += read["math"]
        found.links.update(read["links"])
        found.anchors[path] = set(read["anchors"])
        if read["empty"]:
            found.problems.append((path, f"{read['empty']} formulas without size"))
    page.close()
    return found


def test_every_page_loads_without_errors_and_every_formula_has_a_size(visit, capsys):
    with capsys.disabled():
        print(f" [{visit.pages} pages, {visit.math} formulas, {len(visit.links)} different links]", end=" ")
    assert visit.problems == []
    assert visit.math > visit.pages > 50


def resolves(link, anchors):
    parts = urlsplit(link)
    if parts.scheme == "data":
        return True
    target = Path(unquote(parts.path))
    if parts.scheme != "file" or not target.is_file():
        return False
    return not parts.fragment or unquote(parts.fragment) in anchors[target]


def test_every_link_resolves(visit):
    assert len(visit.links) > visit.pages
    assert [link for link in visit.links if not resolves(link, visit.anchors)] == []


@pytest.mark.parametrize("viewport", [DESKTOP, PHONE], ids=["desktop", "phone"])
def test_axe_finds_no_barrier(site, browser, request, viewport):
    """Also in what a reader unfolds, in the card of a symbol, and in the dark, which changes colors alone."""
    problems = []
    page = opened(browser, problems, viewport=viewport)
    checked = addresses(site, request)
    for name in checked:
        page.emulate_media(color_scheme="light")
        page.goto((site / name).as_uri())
        unfold(page)
        problems += [(name, *found) for found in barriers(page)]
        page.emulate_media(color_scheme="dark")
        problems += [(name, "dark", *found) for found in barriers(page, runOnly=["cat.color"])]
    page.close()
    assert problems == []
    assert len(checked) >= len(REPRESENTATIVE)


def test_the_dark_changes_colors_alone(repository):
    style = (repository / "algebroproj_sym/reporting/site/templates/style.css").read_text(encoding="utf-8")
    (dark,) = re.findall(r"@media \(prefers-color-scheme: dark\) \{\s*:root \{(.*?)\}\s*\}", style, flags=re.DOTALL)
    assert style.count("prefers-color-scheme") == 1
    assert re.fullmatch(r"(\s*--[\w-]+: #[0-9a-f]+;)+\s*", dark)


def unfold(page):
    """Open what is folded, and the card of the first symbol."""
    page.evaluate("for (const part of document.querySelectorAll('details')) part.open = true")
    if page.locator(".symbols a").count():
        page.locator(".symbols a").first.click()
        page.locator("[popover]:popover-open").wait_for()


def test_axe_finds_no_barrier_among_the_results_of_a_search(site, browser):
    page = opened(browser, [], viewport=PHONE)
    page.goto((site / "search.html").as_uri() + "?q=epipole")
    assert page.locator("#results a").count() > 3
    assert barriers(page) == []
    page.close()


def barriers(page, **options):
    """Return what axe-core finds on a page: the rule, and the first elements that break it."""
    from axe_playwright_python.sync_playwright import Axe

    found = Axe().run(page, options={"preload": False, "resultTypes": ["violations"], **options}).response["violations"]
    return [(each["id"], [node["html"][:200] for node in each["nodes"][:3]]) for each in found]


def test_a_symbol_in_a_formula_opens_its_card(site, browser):
    problems = []
    page = opened(browser, problems, viewport=PHONE)
    page.goto((site / "fundamentals1996" / "2.2.6.html").as_uri())
    page.locator("figure .known").first.click()
    card = page.locator("[popover]:popover-open")
    card.wait_for()
    assert "First in" in card.inner_text()
    box = card.bounding_box()
    assert box["x"] >= 0
    assert box["x"] + box["width"] <= PHONE["width"]
    page.keyboard.press("Escape")
    assert card.count() == 0
    page.close()
    assert problems == []


def test_a_symbol_leads_to_the_page_of_symbols_without_a_script(site, browser):
    page = browser.new_page(java_script_enabled=False)
    page.goto((site / "fundamentals1996" / "2.2.6.html").as_uri())
    page.get_by_role("link", name="z22").click()
    assert page.url == (site / "fundamentals1996" / "symbols.html").as_uri() + "#z22"
    assert "printed as" in page.locator("li:target").inner_text()
    page.close()


def test_the_edges_of_a_formula_stand_out_in_the_graph_while_it_has_the_focus(site, browser):
    page = opened(browser, [], viewport=DESKTOP)
    page.goto((site / "fundamentals1996" / "graph-2.2.html").as_uri())
    page.locator('[data-vertex="2.2.4"]').focus()
    near = page.locator(".graph path.near")
    ends = {near.nth(k).get_attribute(end) for k in range(near.count()) for end in ("data-from", "data-to")}
    assert {"2.2.4", "correlation.system"} <= ends
    assert page.locator(".graph path").count() > near.count()
    page.close()


def test_a_phone_shows_every_page_without_scrolling_sideways_and_cuts_no_formula(site, browser, request):
    problems, wide, cut = [], [], []
    page = opened(browser, problems, viewport=PHONE)
    for name in addresses(site, request):
        page.goto((site / name).as_uri())
        read = page.evaluate(READ_PAGE)
        wide += [name] if read["overflow"] > 0 else []
        cut += [(name, element) for element in read["cut"]]
    page.close()
    assert wide == cut == problems == []


@pytest.mark.parametrize("query", ["2.2.6", "(2.2.6)"])
def test_the_search_finds_a_number(site, browser, query):
    problems = []
    page = opened(browser, problems, viewport=DESKTOP)
    page.goto((site / "index.html").as_uri())
    page.get_by_role("searchbox").fill(query)
    page.get_by_role("searchbox").press("Enter")
    page.locator("#results a").first.click()
    assert page.url == (site / "fundamentals1996" / "2.2.6.html").as_uri()
    assert page.get_by_role("heading", level=1).inner_text().startswith("(2.2.6)")
    page.close()
    assert problems == []


def test_the_search_finds_a_symbol_as_it_is_typed(site, browser):
    page = opened(browser, [], viewport=DESKTOP)
    page.goto((site / "search.html").as_uri())
    page.get_by_role("searchbox").press_sequentially("upp1")
    results = page.locator("#results a")
    assert results.count() > 3
    assert "found" in page.get_by_role("status").inner_text()
    page.close()


@pytest.mark.parametrize(("query", "title"), [("epiople", "epipole"), ("epipolr line", "epipolar line")])
def test_the_search_forgives_a_typo(site, browser, query, title):
    page = opened(browser, [], viewport=DESKTOP)
    page.goto((site / "search.html").as_uri())
    page.get_by_role("searchbox").fill(query)
    assert title in page.locator("#results li").first.inner_text()
    page.close()


@pytest.mark.parametrize(
    ("what", "copied"), [("TeX", r"\frac"), ("Python", "z11"), ("BibTeX", "@misc{"), ("link", "2.2.6.html")]
)
def test_a_button_copies(site, browser, what, copied):
    context = browser.new_context(permissions=["clipboard-read", "clipboard-write"])
    page = context.new_page()
    page.goto((site / "fundamentals1996" / "2.2.6.html").as_uri())
    page.get_by_role("button", name=what, exact=True).click()
    page.locator(".copies [role=status]").get_by_text("Copied.").wait_for()
    assert copied in page.evaluate("navigator.clipboard.readText()")
    context.close()


def test_a_phone_has_the_search_in_one_line(site, browser):
    page = opened(browser, [], viewport=PHONE)
    page.goto((site / "index.html").as_uri())
    field, button = (page.locator(f"header {part}").bounding_box() for part in ("input", "button"))
    assert field["y"] < button["y"] + button["height"]
    assert button["y"] < field["y"] + field["height"]
    page.close()


def test_the_keyboard_reaches_the_content_first(site, browser):
    page = opened(browser, [], viewport=DESKTOP)
    page.goto((site / "fundamentals1996" / "2.2.6.html").as_uri())
    page.keyboard.press("Tab")
    focused = page.locator(":focus")
    assert focused.inner_text() == "Skip to the content"
    assert focused.bounding_box()["x"] >= 0
    page.keyboard.press("Enter")
    assert page.url.endswith("#content")
    page.close()


def test_every_page_reads_without_a_script(site, browser):
    page = browser.new_page(java_script_enabled=False)
    page.goto((site / "fundamentals1996" / "2.2.6.html").as_uri())
    assert page.locator("math").count() > 3
    assert page.locator("math").first.bounding_box()["width"] > 0
    page.goto((site / "search.html").as_uri())
    assert "The search needs JavaScript." in page.locator("main").inner_text()
    page.close()
