"""The site: every link leads somewhere, every formula is well-formed, what is shown is what was judged."""

import json
import os
import re
import subprocess
import sys
from base64 import b64decode
from decimal import Decimal
from fractions import Fraction
from html import unescape
from html.parser import HTMLParser
from io import BytesIO
from itertools import combinations
from pathlib import Path
from posixpath import dirname, join, normpath
from xml.etree import ElementTree

import pytest
import sympy
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st
from markupsafe import escape

from algebroproj_sym import Section
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import Derivation, Quote, derivations, judge, kernels, publication, quotations, select
from algebroproj_sym.declaring.bibliography import bibtex
from algebroproj_sym.expressions import Matrix, entries, evaluate, over, symbols_of, vector
from algebroproj_sym.expressions.arranging import arranged
from algebroproj_sym.reporting.dependences import noted
from algebroproj_sym.reporting.site.addresses import claim_page, slug
from algebroproj_sym.reporting.site.catalogue import catalogue
from algebroproj_sym.reporting.site.differences import difference
from algebroproj_sym.reporting.site.folder import OccupiedError, replace
from algebroproj_sym.reporting.site.formulas import block, listed
from algebroproj_sym.reporting.site.function_pages import formulas_of
from algebroproj_sym.reporting.site.layers import Vertex, graph_svg
from algebroproj_sym.reporting.site.mathml import math
from algebroproj_sym.reporting.site.pages import render_site
from algebroproj_sym.reporting.site.quotes import quoted
from algebroproj_sym.reporting.site.search import search_index
from algebroproj_sym.reporting.site.symbols import symbols_in
from algebroproj_sym.showing.latex import latex
from algebroproj_sym.showing.names import latex_name, plain_name

SELECTORS = ("fundamentals1996:1.2", "fundamentals1996:2.2", "rhodos1990")
VOID = {"meta", "link", "input", "br", "hr", "img", "wbr"}
x, y, z, u31, up31 = sympy.symbols("x y z u31 up31")
HOSTILE = '<script>alert("1")</script> & <b> "quoted" \'single\' </main>'


class Page(HTMLParser):
    """Elements, links and identifiers of a page; complains about tags that do not match."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.open, self.elements, self.text = [], [], text
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        self.elements.append((tag, dict(attributes)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.elements.append((tag, dict(attributes)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_decl(self, declaration):
        assert declaration == "doctype html"

    def all(self, *tags):
        return [attributes for tag, attributes in self.elements if tag in tags]

    @property
    def identifiers(self):
        return [attributes["id"] for _, attributes in self.elements if "id" in attributes]


def demonstration():
    """A section with every verdict and kind of form."""
    section = Section("demo", "1", f"Demonstration {HOSTILE}")
    big = sympy.expand((x + 2 * y + 3 * z + 1) ** 12)
    section.definition("1.1", "sum", printed=x + y)
    section.identity("1.2", f"square {HOSTILE}", printed=x**2, derived=x * x, note=f"{HOSTILE}, see 1.3 and 1.3/true.")
    section.identity("1.3", "not equal", printed=x * y, derived=x + y, expect="false", instead="1.3/true")
    section.identity("1.3/true", "equal", printed=x + y, derived=y + x)
    section.identity(
        "1.4#A",
        "matrix",
        printed=vector(x, -y, z),
        derived=vector(x, y, z),
        corrected=vector(x, y, z),
        expect="misprint",
    )
    section.identity("1.4#a", "lost", printed=None, derived=x + x, corrected=2 * x, expect="illegible")
    section.identity("1.5", "open by mistake", printed=x + 1, derived=x)
    section.identity("1.6", "long", printed=big, derived=big + over(x, x) - 1)
    section.identity("1.7", "long, and false", printed=big, derived=big + 1, expect="false", instead="1.6")
    section.numeric("1.8", "number", printed="0.333", derived=sympy.Rational(1, 3))
    section.numeric(
        "1.9", "number", printed="0.353", derived=sympy.Rational(1, 3), corrected="0.333", expect="misprint"
    )
    section.reference("1.10", "reference", printed="1.2", meant="1.3")
    section.identity("1.11", "constraint", printed=x**3, derived=x, constraints=[x**2 - 1], witness={x: 1})
    section.vanishing("1.12", "undecided", printed=(), derived=x**2 + 1)
    section.vanishing("1.13", "zeros", printed=(x, y), derived=x * y**2)
    section.rank("1.14", "rank", printed=2, derived=Matrix([[x, 0], [0, y]]))
    section.limit("1.15", "limit", printed=y, derived=over(x * y, x), variable=x)
    section.up_to_scale("1.16", "scale", printed=vector(x, y), derived=vector(2 * x, 2 * y))
    section.structure("1.17", "structure", printed=Matrix([[0, z], [-z, 0]]), derived=Matrix([[0, x], [-x, 0]]))
    return section


@pytest.fixture(scope="module")
def demo():
    return rendered()


@pytest.fixture(scope="module")
def live():
    return rendered(live=True)


def rendered(**options):
    section = demonstration()
    source = Derivation("demo", section, Path("demo.py"))
    judged = [judge(claim) for claim in section.claims]
    return render_site(catalogue(judged, [source] * len(judged), **options))


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """The site of a few sections, as the command writes it."""
    folder = tmp_path_factory.mktemp("written") / "site"
    result = CliRunner().invoke(main, ["report", *SELECTORS, "--out", str(folder), "--samples", "2"])
    assert result.exit_code == 0, result.output
    return folder


@pytest.fixture(scope="module")
def site(written):
    return {path.relative_to(written).as_posix(): path.read_text(encoding="utf-8") for path in written.rglob("*.*")}


@pytest.mark.whole
def test_a_function_of_a_symmetric_matrix_is_found_by_the_entries_that_it_reads(tmp_path):
    result = CliRunner().invoke(main, ["report", "normalcase1992:3.2", "--out", str(tmp_path), "--samples", "1"])
    assert result.exit_code == 0, result.output
    index = (tmp_path / "search-index.js").read_text(encoding="utf-8")
    (entry,) = (line for line in index.splitlines() if '"metric.normal_covariance"' in line)
    assert "S_a_12" in entry
    assert "S_a_21" not in entry


@pytest.fixture(params=["demo", "site"])
def files(request):
    return request.getfixturevalue(request.param)


def pages(files):
    return {name: Page(text) for name, text in files.items() if name.endswith(".html")}


def test_there_is_a_page_for_each_paper_claim_and_function(site):
    for claim in select(SELECTORS):
        assert claim_page(claim.paper, claim.number) in site
    for paper in ("fundamentals1996", "rhodos1990"):
        assert {f"{paper}/index.html", f"{paper}/errata.html"} <= site.keys()
    assert any(name.startswith("functions/correlation.") for name in site)
    assert "index.html" in site


def test_every_link_and_anchor_resolves(files):
    found = pages(files)
    checked = 0
    for name, page in found.items():
        assert len(page.identifiers) == len(set(page.identifiers)), name
        for attributes in page.all("a", "link", "script", "form"):
            target = attributes.get("href") or attributes.get("src") or attributes.get("action")
            if target is None:
                continue
            path, _, anchor = target.partition("#")
            address = normpath(join(dirname(name), path)) if path else name
            assert address in files, (name, target)
            assert not anchor or anchor in found[address].identifiers, (name, target)
            checked += 1
        for attributes in (attributes for _, attributes in page.elements):
            for reference in ("aria-labelledby", "for"):
                assert {*attributes.get(reference, "").split()} <= {*page.identifiers}, (name, attributes)
    assert checked > 100


def test_a_section_of_references_has_an_anchor_for_each():
    section = Section("demo", "0", "References")
    section.reference("0.1", "reference", printed="1.2", meant="1.2")
    files = render_site(
        catalogue([judge(claim) for claim in section.claims], [Derivation("demo", section, Path("demo.py"))])
    )
    assert 'href="index.html#0.1"' in files["demo/0.1.html"]
    assert "0.1" in Page(files["demo/index.html"]).identifiers


def test_nothing_is_loaded_from_elsewhere(files):
    elsewhere = r"(?:src|href|action)=\"(?:[a-z]+:|//)|url\((?!data:)|@import|fetch\(|https?://"
    for name, text in files.items():
        if name.endswith((".html", ".css", ".js")):
            assert not re.search(elsewhere, text), name


def require_no_markup(text, name):
    for formula in re.findall(r"<math.*?</math>", text):
        shown = "".join(ElementTree.fromstring(formula).itertext())
        assert not {*shown} & {*"<>&\\"}, (name, shown)


def test_no_formula_shows_markup_as_text(files):
    for name, text in files.items():
        if name.endswith(".html"):
            require_no_markup(text, name)


def test_evidence_is_not_shown_as_python_writes_it(files):
    assert [name for name, text in files.items() if name.endswith(".html") and ">{&#39;" in text] == []


def test_no_formula_of_any_function_shows_markup_as_text():
    found = kernels()
    assert len(found) > 70
    for kernel in found:
        require_no_markup("".join(formulas_of(kernel)), kernel.qualified_name)


@pytest.mark.extra("dev")
def test_the_font_of_the_formulas_is_in_the_site_with_its_licence_and_has_what_the_pages_show(files):
    from fontTools.ttLib import TTFont

    font = TTFont(BytesIO(b64decode(re.search(r"url\(data:font/woff2;base64,([^)]*)\)", files["style.css"]).group(1))))
    assert "MATH" in font
    assert "SIL OPEN FONT LICENSE" in files["font-licence.txt"]
    for name, text in files.items():
        for formula in re.findall(r"<math.*?</math>", text) if name.endswith(".html") else ():
            for element in ElementTree.fromstring(formula).iter():
                assert {*map(drawn, (element.text or "").strip())} <= font.getBestCmap().keys(), (name, element.text)


def drawn(letter):
    """Return the code of a letter: an identifier of one letter is drawn in italics."""
    if letter.isascii() and letter.isalpha() and letter != "h":
        return 0x1D434 + ord(letter) - (65 if letter < "a" else 71)
    return ord(letter)


def test_pages_can_be_read_by_everyone(files):
    for name, page in pages(files).items():
        assert page.all("html") == [{"lang": "en"}], name
        assert len(page.all("h1")) == len(page.all("main")) == 1, name
        assert ("title", {}) in page.elements, name
        assert page.all("header"), name
        assert page.all("footer"), name
        levels = [int(tag[1]) for tag, _ in page.elements if re.fullmatch("h[1-6]", tag)]
        assert all(after <= before + 1 for before, after in zip([0, *levels], levels, strict=False)), (name, levels)
        assert len(page.all("caption")) == len(page.all("table")), name
        assert all(attributes.get("scope") in ("row", "col") for attributes in page.all("th")), name
        assert len(page.all("label")) == len(page.all("input")) > 0, name
        assert all(attributes.get("aria-label") for attributes in page.all("nav")), name
        assert {attributes.get("role") for attributes in page.all("svg")} <= {"img", "group"}, name
        assert 'class="skip" href="#content"' in page.text, name


def test_formulas_are_well_formed(files):
    count = 0
    for name in [name for name in files if name.endswith(".html")]:
        for formula in re.findall(r"<math.*?</math>", files[name]):
            tree = ElementTree.fromstring(formula)
            assert {element.tag for element in tree.iter()} <= PRINTED_TAGS, name
            count += 1
    assert count > 20


TAGS = {"math", "mtext", "mrow", "mi", "mn", "mo", "mfrac", "msup", "msub", "msubsup", "mtable", "mtr", "mtd"}
PRINTED_TAGS = TAGS | {"mover", "munder", "munderover", "mspace", "msqrt"}


def value(element, point):
    """Evaluate MathML: what a reader sees, read back."""
    children = list(element)
    if element.tag == "mn":
        return Fraction(element.text)
    if element.tag == "mfrac":
        return value(children[0], point) / value(children[1], point)
    if "".join(element.itertext()) in point and element.tag in ("mi", "msub", "msup", "msubsup"):
        return point["".join(element.itertext())]
    if element.tag == "msup":
        return value(children[0], point) ** int(children[1].text)
    total, product, sign = Fraction(0), None, 1
    for child in children:
        if child.tag == "mo" and child.text in "+−":
            total += sign * product if product is not None else 0
            product, sign = None, 1 if child.text == "+" else -1
        elif child.tag == "mrow" and set(child.attrib) == {"class"} and child[0].tag == "mo" and child[0].text in "+−":
            raise AssertionError("marked terms are not read back")
        elif child.tag != "mo":
            product = (1 if product is None else product) * value(child, point)
    return total + sign * product


def assert_reads_back(expression):
    symbols = symbols_of([expression])
    point = {symbol: Fraction(7 * k + 3, 5 * k + 11) for k, symbol in enumerate(symbols)}
    seen = {"".join(ElementTree.fromstring(math(latex(symbol))).itertext()): point[symbol] for symbol in symbols}
    assert len(seen) == len(symbols)
    tree = ElementTree.fromstring(math(latex(expression)))
    cells = list(tree.iter("mtd")) if isinstance(expression, sympy.MatrixBase) else [tree]
    assert [value(one(cell), seen) for cell in cells] == list(evaluate(expression, point))


def one(cell):
    row = ElementTree.Element("mrow")
    row.append(cell) if cell.tag != "mtd" else row.extend(cell)
    return row


@pytest.mark.parametrize(
    "expression",
    [
        -x,
        x - y,
        -(x + y) * z,
        2 * x**2 / (3 * y),
        over(x + 1, x + 1) ** 2,
        over(-x, y - 1) * z,
        (-x) ** 3 + 1,
        sympy.Rational(-2, 3) + x / 2,
        1 / (x * y**2) - over(1, over(x, y)),
        up31**2 * u31,
        sympy.Mul(2, sympy.Add(x, 1), evaluate=False),
        sympy.Mul(x, sympy.Mul(-2, y, evaluate=False), 3, evaluate=False),
        sympy.Mul(2, sympy.Pow(3, 2, evaluate=False), evaluate=False),
        sympy.Pow(sympy.Rational(-1, 2), 2, evaluate=False) + x,
        sympy.Add(x, sympy.Add(y, -1, evaluate=False), evaluate=False),
        Matrix([[-1, x], [0, -over(y, x)]]),
    ],
    ids=str,
)
def test_what_is_shown_is_what_was_meant(expression):
    assert_reads_back(expression)


def test_formulas_of_the_papers_read_back():
    claims = select(["fundamentals1996:1.2", "fundamentals1996:1.5"])
    forms = [form for claim in claims for form in (claim.printed, claim.derived, claim.corrected)]
    shown = [form for form in forms if isinstance(form, sympy.Expr | sympy.MatrixBase)]
    assert len(shown) > 40
    for form in shown:
        assert_reads_back(form)


@pytest.mark.parametrize(
    ("name", "latex", "plain"),
    [
        ("up31", r"u^{\prime}_{31}", "u'31"),
        ("uppN30", r"u^{\prime\prime}_{N30}", "u''N30"),
        ("pp1", r"p^{\prime}_{1}", "p'1"),
        ("p1", "p_{1}", "p1"),
        ("mup1", r"\mu^{\prime}_{1}", "μ'1"),
        ("y0_3", "y_{0,3}", "y0,3"),
        ("c_phi", r"c_{\varphi}", "cφ"),
        ("weighted", r"\mathrm{weighted}", "weighted"),
        ("x8pp", r"x^{\prime\prime}_{8}", "x''8"),
    ],
)
def test_names_of_symbols(name, latex, plain):
    assert (latex_name(name), plain_name(name)) == (latex, plain)


def test_file_names_are_unique_even_where_case_does_not_count(files):
    names = [name.lower() for name in files]
    assert len(names) == len(set(names))
    assert all(re.fullmatch(r"[a-z0-9_./~=,+-]+", name) for name in files)
    everything = [claim_page(claim.paper, claim.number) for claim in select()]
    assert len(everything) == len(set(everything))


def test_addresses_are_permanent():
    numbers = ["2.2.6", "1.3.5#mu3", "2.4/2.3.2", "table:2.2", "2.1/u0'C", "1.3/P*", "1.2/j=2", "1.3/ä"]
    assert [slug(number) for number in numbers] == [
        "2.2.6",
        "1.3.5~mu3",
        "2.4_2.3.2",
        "table,2.2",
        "2.1_u0=+c",
        "1.3_+p+2a",
        "1.2_j+3d2",
        "1.3_+80000e4",
    ]


def test_a_preview_says_what_the_page_says(demo):
    for name, page in pages(demo).items():
        shown = {each["property"]: each for each in page.all("meta") if "property" in each}
        assert f"<title>{escape(shown['og:title']['content'])}</title>" in page.text, name
        assert shown["og:description"]["name"] == "description"
        assert shown["og:description"]["content"], name
    assert "Misprint. The printed form is refuted. The corrected form is proved. demo." in demo["demo/1.4~+a.html"]


def test_a_claim_can_be_copied_as_tex_and_as_python_and_what_there_is_none_of_cannot(demo):
    def copies(name):
        buttons = re.findall(r'data-copy="([^"]*)">([^<]*)<', demo[f"demo/{name}.html"])
        return {what: unescape(text) for text, what in buttons}

    assert copies("1.3") == {"TeX": r"x y \neq x + y", "Python": "x*y", "link": ""}
    assert copies("1.4~a") == {"TeX": "2 x", "Python": "2*x", "link": ""}
    assert copies("1.10").keys() == {"TeX", "Python", "link"}


def test_every_verdict_has_a_page_that_says_so(demo):
    verdicts = {
        name: re.search(r'class="verdict (\w+)"', text).group(1)
        for name, text in demo.items()
        if re.match(r"demo/\d", name) and name.endswith(".html")
    }
    assert {*verdicts.values()} == {"proved", "misprint", "false", "illegible", "definition", "open"}
    assert "Declared: proved." in demo["demo/1.5.html"]
    assert "What is true instead" in demo["demo/1.3.html"]
    assert "The scan does not preserve it" in demo["demo/1.4~a.html"]
    assert "Undecided: " in demo["demo/1.12.html"]
    assert "Cofactors of the constraints" in demo["demo/1.11.html"]


def test_the_entries_that_differ_are_marked_and_named(demo):
    text = demo["demo/1.4~+a.html"]
    printed, corrected, derived = re.findall(r"<figure.*?</figure>", text, re.DOTALL)
    for side, marked in ((printed, '<mrow class="differs"><mo>−</mo></mrow>'), (corrected, "<mi>y</mi>")):
        assert len(re.findall("<mtd", side)) == 3
        assert len(re.findall('class="differs"', side)) == 1
        assert re.search(rf'<mtd[^>]*>(<mrow>)?(<mrow class="differs">)?{marked}', side)
    assert "differs" not in derived
    assert "row 2, column 1" in text
    assert "Counterexample" in text
    digits = demo["demo/1.9.html"]
    assert '0.3<mark class="differs">5</mark>3' in digits


def test_as_little_as_can_be_told_apart_is_marked():
    assert marked(x * y + z, x * u31 + z) == ("x [y] + z", "[u31] x + z")
    assert marked(x, -x) == ("[x]", "[-]x")
    assert marked(over(x, y), over(x, z)) == ("x/[y]", "x/[z]")
    assert marked(x * y - z, x * y + z) == ("x y [-] z", "x y [+] z")
    assert marked(2 * x**2 * y + z, 3 * x**2 * y + z) == ("[2] x^2 y + z", "[3] x^2 y + z")
    assert marked(x**2 * y, x**3 * y) == ("x^[2] y", "x^[3] y")
    assert marked(z * (x - y) ** 2, z * (x + y) ** 2) == ("z (x [-] y)^2", "z (x [+] y)^2")
    assert marked(x + y, x + y + z) == ("x + y", "x + y [+ z]")
    assert marked(x * y, u31 + z) == ("[x y]", "[u31 + z]")
    assert marked(Matrix([[x, -y], [z, 0]]), Matrix([[x, y], [z, 1]])) == ("x, [-]y, z, [0]", "x, [y], z, [1]")


SPELLED = [
    (r"\\class\{differs\}\{((?:[^{}]|\{[^{}]*\})*)\}", r"[\1]"),
    (r"\\left|\\right", ""),
    (r"u_\{31\}", "u31"),
    (r"\\frac\{(.*)\}\{(.*)\}", r"\1/\2"),
    (r"\^\{(.*?)\}", r"^\1"),
    (r"\[\\begin\{matrix\} (.*) \\end\{matrix\}\]", r"\1"),
    (r" (?:&|\\\\) ", ", "),
]


def marked(left, right):
    """Return two forms in few letters, what is marked in brackets."""
    forms = arranged(left), arranged(right)
    shown = [latex(form, marks, ordered=False) for form, marks in zip(forms, difference(*forms), strict=True)]
    for pattern, spelled in SPELLED:
        shown = [re.sub(pattern, spelled, text) for text in shown]
    return tuple(shown)


def test_a_long_form_is_folded_with_its_size_and_its_beginning_and_all_of_it_is_on_the_page(demo):
    text = demo["demo/1.6.html"]
    assert max(map(len, re.findall(r"<math.*?</math>", text))) < 2000
    size, beginning, whole = re.search(
        r", ([\d,]+) characters. It begins:</p><pre[^>]*>(.*?)</pre>"
        r"<details><summary>All of it</summary><pre[^>]*>(.*?)</pre></details>",
        text,
        re.DOTALL,
    ).groups()
    assert int(size.replace(",", "")) == len(whole)
    assert whole.startswith(beginning.partition(" …")[0])
    assert sympy.sympify(whole).equals(sympy.expand((x + 2 * y + 3 * z + 1) ** 12))
    assert all(len(page) < 100_000 for name, page in demo.items() if name.endswith(".html"))


def test_long_entries_that_differ_are_shown_where_they_differ():
    section = Section("demo", "1", "Long entries")
    right = sympy.expand((x + 2 * y + 3 * z + 1) ** 6)
    wrong = right - 540 * x * z**3
    section.identity(
        "1.1", "long", printed=vector(wrong, x), derived=vector(right, x), corrected=vector(right, x), expect="misprint"
    )
    page = render_site(catalogue([judge(section.claims[0])], [Derivation("demo", section, Path("demo.py"))]))
    printed, corrected = re.search(
        r"row 1, column 1</th><td><code>(.*?)</code></td><td><code>(.*?)</code>", page["demo/1.1.html"]
    ).groups()
    assert printed != corrected
    assert printed[:20] == corrected[:20]
    assert printed.startswith("…")


def test_titles_and_notes_are_escaped_and_numbers_in_notes_are_links(demo):
    for name, text in demo.items():
        if name.endswith(".html"):
            assert "<script>" not in text, name
            assert "</main> " not in text, name
    text = demo["demo/1.2.html"]
    assert "&lt;script&gt;" in text
    assert '<a href="1.3_true.html">1.3/true</a>.' in text
    assert "</script" not in demo["search-index.js"]


def test_a_field_is_called_printed_only_if_the_paper_prints_what_is_in_it(live):
    assert '">Printed form</label>' in live["demo/1.2.html"]
    assert '">Printed form</label>' not in live["demo/1.4~a.html"]
    assert '">Reconstruction</label>' in live["demo/1.4~a.html"]


def test_what_a_page_asks_is_escaped_and_complete(live):
    """The prover adds fields and buttons, and nothing that a title could inject."""
    assert not any("<script>" in text or "</main> " in text for name, text in live.items() if name.endswith(".html"))
    assert ">x**2 - 1</textarea>" in live["demo/1.11.html"]


def test_the_errata_say_what_to_read(demo, site):
    text = demo["demo/errata.html"]
    assert text.count("<figcaption>For</figcaption>") == text.count("<figcaption>Read</figcaption>") == 3
    assert "True instead" in text
    assert "@misc" not in text
    assert "@misc{fundamentals1996" in site["fundamentals1996/errata.html"]
    assert "(2.2.6)" in site["fundamentals1996/errata.html"]
    assert "(2.2.6)" in site["index.html"]


def test_the_search_finds_numbers_titles_and_symbols(site):
    lines = site["search-index.js"].split("\n")[1:-2]
    index = [json.loads(line.rstrip(",")) for line in lines]
    (found,) = [entry for entry in index if entry[2] == "2.2.6"]
    assert found[:5] == ["fundamentals1996/2.2.6.html", "fundamentals1996", "2.2.6", "epipole in P'", "error"]
    assert {"z11", "zeta11"} <= {*found[5].split()}
    assert any("u'1" in entry[5].split() and "up1" in entry[5].split() for entry in index)
    assert any(entry[1] == "function" and entry[2].startswith("correlation.") for entry in index)
    assert [entry[0] for entry in index if "Brandst\u00e4tter" in entry[3]] == [
        "fundamentals1996/index.html",
        "rhodos1990/index.html",
    ]
    assert all(entry[0] in site for entry in index)


def test_a_function_page_has_formula_claims_figures_and_plot(site):
    text = site["functions/correlation.design_row.html"]
    for part in (
        "<svg",
        "Claims that prove it",
        "Operations",
        "badly scaled",
        "def design_row",
        "algebroproj.correlation.",
    ):
        assert part in text
    ElementTree.fromstring(re.search(r"<svg.*?</svg>", text, re.DOTALL).group())
    assert 'href="../functions/correlation.design_row.html"' in site["fundamentals1996/2.2.4.html"]


@pytest.mark.whole
def test_a_long_factor_does_not_run_out_of_a_picture(tmp_path):
    """It stands whole among those that must not vanish."""
    result = CliRunner().invoke(main, ["report", "fundamentals1996:1.4", "--out", str(tmp_path), "--samples", "2"])
    assert result.exit_code == 0, result.output
    text = (tmp_path / "functions" / "affine.plane_coordinates.html").read_text(encoding="utf-8")
    named = re.findall(r">(near [^<]* …)<", text)
    assert [*map(named.count, {*named})] == [3], "in both pictures and in the table"
    assert not re.search(r">near [^<]{48}", text)


def edges(picture):
    return {*re.findall(r'data-from="([^"]*)" data-to="([^"]*)"', picture)}


def test_a_graph_shows_what_rests_on_what(site):
    drawing = site["fundamentals1996/graph-2.2.html"]
    assert {("2.2.3", "2.2.5"), ("2.2.5", "2.2.6"), ("2.2.4", "correlation.system")} <= edges(drawing)
    assert edges(site["rhodos1990/graph.html"]) == set()
    assert Page(site["fundamentals1996/2.2.6.html"]).text.count('href="2.2.5~right.html"') == 1


def test_what_rests_on_what_is_what_was_computed_from_what():
    found = noted(["rhodos1990"])
    assert found["rhodos1990", "1.2.2"] == (("rhodos1990", "1.2/mu"),)
    claims = [(claim.paper, claim.number) for claim in select(["rhodos1990"])]
    assert found.keys() <= {*claims}
    assert not any(key in bases for key, bases in found.items())


def test_what_cannot_be_imported_has_no_graph_and_says_why():
    with pytest.raises(RuntimeError, match="nowhere"):
        noted(["nowhere"])


@given(st.dictionaries(st.integers(0, 9), st.lists(st.integers(0, 9), max_size=4), min_size=1))
def test_a_graph_is_drawn_without_overlaps_and_from_left_to_right(bases):
    """What cannot be drawn from left to right closes a circle; what is left out is reached by a path."""
    names = [*map(str, range(10))]
    bases = {str(name): [*map(str, found)] for name, found in bases.items()}
    picture = graph_svg([Vertex(name, name * 9, "page.html", name, "") for name in names], bases, "graph")
    root = ElementTree.fromstring(picture)
    boxes = {each.get("data-vertex"): each[1].attrib for each in root.iter("a")}
    assert [*boxes] == names
    left, top, width = ({name: float(box[key]) for name, box in boxes.items()} for key in ("x", "y", "width"))
    for one, other in combinations(names, 2):
        is_beside = left[one] + width[one] < left[other] or left[other] + width[other] < left[one]
        assert is_beside or abs(top[one] - top[other]) > float(boxes[one]["height"])
    shown = edges(picture)
    assert all(left[base] + width[base] < left[name] for base, name in shown)
    paths = closure(shown)
    for name, found in bases.items():
        for base in found:
            assert (base, name) in paths or (name, base) in paths or name == base
    assert not any((a, b) in paths and (b, c) in paths for a, c in shown for b in names)


def closure(pairs):
    found = {*pairs}
    while more := {(a, d) for a, b in found for c, d in found if b == c} - found:
        found |= more
    return found


@pytest.mark.parametrize(
    ("quote", "shown"),
    [
        (r"\mu_3 = -\frac{y_{00}}{y_{03}} \tag{1.3.5}", "<mfrac>"),
        (r"the rank of $C$ is 2", "<p>the rank of <math"),
        (r"the rank of $C is 2", "<p>the rank of $C is 2</p>"),
        (r"= \mathbf{z}$ as in", "</math> as in</p>"),
        (r"a &= b \\ c &= d", "<mtable"),
        ("1\t0.5\t$x$", "<span>1</span> <span>0.5</span> <span><math"),
        (r"\left( x + \frac{1}{", r"<code>\left( x + \frac{1}{</code>"),
        (r"<script> = \frac", r"<code>&lt;script&gt; = \frac</code>"),
        (r"<script>", "<p>&lt;script&gt;</p>"),
    ],
)
def test_a_quote_is_shown_as_the_paper_prints_it_or_as_the_scan_has_it(quote, shown):
    found = quoted(Quote(("1",), 1, (quote,)))
    assert shown in found
    assert "tag" not in found


def test_a_determinant_has_lines_and_a_matrix_has_brackets():
    determinant, matrix = (
        math(rf"\left{left}\begin{{matrix}}a & b\end{{matrix}}\right{right}") for left, right in ("||", "[]")
    )
    assert '<mrow class="determinant"><mo>|</mo><mtable>' in determinant
    assert '<mrow class="matrix"><mo>[</mo><mtable>' in matrix


def test_a_matrix_of_long_numbers_scrolls_and_one_of_short_ones_does_not():
    """Both have as many entries; the long one is wider than a phone."""
    assert "tabindex" in listed(sympy.Matrix([[sympy.Rational(10**30 + 1, 7), 1], [0, 1]]))
    assert "tabindex" not in listed(sympy.eye(2))


def test_the_findings_of_the_start_page_show_what_is_wrong(site):
    printed = re.findall(r"<figcaption>Printed</figcaption>(.*?)</figure>", site["index.html"], re.DOTALL)
    assert printed
    assert all('class="differs"' in form for form in printed)


def test_quotes_of_the_papers_are_shown_as_formulas():
    """What the reader can read, the browser can show."""
    quotes = {
        quote
        for derivation in derivations("fundamentals1996")
        for quote in [*quotations(derivation.path.parent).quotes.values()]
    }
    readable = [quote for quote in quotes if not quote.unparsed]
    assert len(readable) > 300
    assert [quote.text for quote in readable if "<code>" in quoted(quote)] == []


def test_a_paper_page_has_the_equations_in_the_order_of_the_paper(site):
    text = site["fundamentals1996/index.html"]
    numbers = re.findall(r'<a class="number" href="#(2\.2\.\d+)">\(\1\)</a>', text)
    assert numbers == [f"2.2.{k}" for k in range(1, 10)]


def test_where_the_scan_is_damaged_a_paper_page_shows_the_formula_and_folds_the_scan(site):
    text = site["rhodos1990/index.html"]
    equation = text[text.index('id="1.1.1"') :].partition("</article>")[0]
    scan, formula = equation.split("</details>")
    assert "poo Poi PO 2 P0 3" in scan.partition("<details>")[2]
    assert "<mtable>" in formula


def test_a_paper_page_does_not_print_a_part_of_a_quote_twice(site):
    assert site["rhodos1990/index.html"].count("(1.1.1) contains 15 Independent parameters") == 1


def test_a_symbol_explains_itself_where_it_stands(site):
    text = site["fundamentals1996/2.2.6.html"]
    cards = json.loads(site["fundamentals1996/cards.js"].removeprefix("const SYMBOLS = ").removesuffix(";\n"))
    assert {"z11", "z22", "D"} <= {*re.findall(r'href="symbols.html#(\w+)"', text)} <= cards.keys()
    page = site["fundamentals1996/symbols.html"]
    assert all(f'<li id="{name}">{card}</li>' in page for name, card in cards.items())
    card = cards["z22"]
    assert "printed as" in card
    assert math(r"\zeta_{22}", "inline") in card
    assert 'href="../functions/correlation.epipoles.html"' in card
    assert '<a href="2.2.1.html">(2.2.1)</a> division by one element.' in card
    assert '<a href="2.2_+d.html">(2.2/D)</a>' in cards["D"]


def test_papers_are_in_their_own_order_whatever_the_selectors():
    found = derivations("rhodos1990")
    claims = [(judge(claim), source) for source in reversed(found) for claim in source.section.claims[:2]]
    (paper,) = catalogue([judgement for judgement, _ in claims], [source for _, source in claims]).papers
    assert [chapter.number for chapter in paper.chapters] == ["1.1", "1.2"]
    assert [entry.claim.number for entry in paper.entries[:2]] == [
        claim.number for claim in found[0].section.claims[:2]
    ]


def test_every_paper_is_known():
    papers = {claim.paper for claim in select()}
    assert all(publication(paper).title != paper for paper in papers)
    assert all(bibtex(publication(paper)).isascii() for paper in papers)
    assert not bibtex(publication("nosuch"))


@pytest.mark.whole
def test_the_bytes_depend_neither_on_the_hash_seed_nor_on_the_workers(tmp_path, written, site):
    out = tmp_path / "again"
    command = [sys.executable, "-m", "algebroproj_sym", "report", *reversed(SELECTORS), "--out", str(out)]
    environment = {**os.environ, "PYTHONHASHSEED": "77"}
    subprocess.run([*command, "--samples", "2", "--jobs", "2"], check=True, env=environment, capture_output=True)
    again = {path.relative_to(out).as_posix(): path.read_text(encoding="utf-8") for path in out.rglob("*.*")}
    assert again.keys() == site.keys()
    assert [name for name in site if again[name] != site[name]] == []
    assert not list(tmp_path.glob(".*"))


def test_only_entries_that_differ_have_marks():
    a, b = sympy.symbols("a b")
    assert [{*marks.inside} for marks in difference(Matrix([[a, b, 1]]), Matrix([[a, -b, 2]]))] == [{1, 2}] * 2


def test_a_long_matrix_is_text_with_the_place_of_each_entry():
    a, b = sympy.symbols("a b")
    text = block(Matrix([[sympy.expand((a + b + 1) ** 20), 1], [0, a]]))
    assert all(f"[{place}]  {entry}" in text for place, entry in (("1, 2", "1"), ("2, 1", "0"), ("2, 2", "a")))


def test_only_an_earlier_site_is_replaced(tmp_path):
    folder = tmp_path / "site"
    replace({"index.html": "one", "search-index.js": "", "old.html": ""}, folder)
    replace({"index.html": "two", "search-index.js": ""}, folder)
    assert {path.name: path.read_text() for path in folder.iterdir()} == {"index.html": "two", "search-index.js": ""}
    (folder / "search-index.js").unlink()
    with pytest.raises(OccupiedError, match="expected a new or empty folder"):
        replace({"index.html": "three"}, folder)
    result = CliRunner().invoke(main, ["report", "rhodos1990:1.1", "--out", str(folder)])
    assert result.exit_code == 2
    assert (folder / "index.html").read_text() == "two"
    assert [path.name for path in tmp_path.iterdir()] == ["site"]


def test_a_claim_that_is_not_as_declared_exits_with_1(tmp_path):
    module = tmp_path / "squares.py"
    module.write_text(
        "import sympy\nfrom algebroproj_sym import Section\nx = sympy.Symbol('x')\n"
        "section = Section('mine', '1', 'Squares')\n"
        "section.identity('1.1', 'a square', printed=x**2 + 1, derived=(x + 1) ** 2)\n",
        encoding="utf-8",
    )
    result = CliRunner().invoke(main, ["report", str(module), "--out", str(tmp_path / "site")])
    assert result.exit_code == 1
    assert "Declared: proved." in (tmp_path / "site" / "mine" / "1.1.html").read_text(encoding="utf-8")


def test_the_index_has_every_entry_of_the_catalogue():
    section = demonstration()
    source = Derivation("demo", section, Path("demo.py"))
    whole = catalogue([judge(claim) for claim in section.claims], [source] * len(section.claims))
    assert len(search_index(whole, symbols_in(whole))) == len(section.claims) + len(whole.papers)
    assert isinstance(section.claims[9].printed, Decimal)
    assert Path("demo/1.8.html").as_posix() in {entry[0] for entry in search_index(whole, symbols_in(whole))}
    assert entries(section.claims[4].printed)[1] == -y
