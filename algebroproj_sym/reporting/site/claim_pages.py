"""The page of a claim, and the pages that list claims: papers and errata."""

import re
from collections.abc import Iterator, Mapping
from typing import Any

from markupsafe import Markup, escape

from algebroproj_sym.declaring import KINDS, Grade, Judgement, bibtex
from algebroproj_sym.reporting.findings import HEADINGS, Finding, by_grade, gathered
from algebroproj_sym.reporting.ledger import summary
from algebroproj_sym.reporting.live.questions import question
from algebroproj_sym.reporting.site.addresses import START, errata_page, paper_page, relative
from algebroproj_sym.reporting.site.catalogue import Catalogue, Entry, Paper
from algebroproj_sym.reporting.site.comparison import (
    comparison,
    forms_of,
    marks_of,
    relation,
    where,
)
from algebroproj_sym.reporting.site.evidence import evidence
from algebroproj_sym.reporting.site.formulas import block, described, listed
from algebroproj_sym.reporting.site.symbols import MOST, Symbols, names_of
from algebroproj_sym.reporting.site.templating import page
from algebroproj_sym.showing.arranging import Part, as_declared
from algebroproj_sym.showing.display import formula
from algebroproj_sym.showing.marks import MARK, Marks

MOST_LISTED = 12
"""Claims that rest on one, or on which one rests, before the others are folded."""


def claim_html(
    catalogue: Catalogue, symbols: Symbols, paper: Paper, place: int, record: Mapping[str, Any], with_graph: bool
) -> str:
    """Return the page of a claim, with its entry of the ledger at hand, whose section may have a graph."""
    entry = paper.entries[place]
    claim = entry.claim
    sides, differences = comparison(entry.judgement)
    sentences, tables = evidence(entry.judgement)
    return page(
        "claim",
        entry.page,
        catalogue=catalogue,
        entry=entry,
        claim=claim,
        paper=paper,
        relation=relation(claim),
        sides=sides,
        differences=differences,
        where=where(claim),
        sentences=sentences,
        tables=tables,
        note=_linked(claim.note, entry.claim.paper, entry.page, catalogue),
        instead=catalogue.by_number.get((entry.claim.paper, claim.instead)),
        functions=catalogue.functions_on(entry.claim),
        most_listed=MOST_LISTED,
        symbols=[symbols[paper.about.key, name] for name in names_of(claim)[:MOST]],
        with_graph=with_graph,
        cell=catalogue.cell_of(entry),
        record=record,
        copies=_copies(entry, paper, record),
        question=question(record) if catalogue.live else None,
        previous=paper.entries[place - 1] if place else None,
        following=paper.entries[place + 1] if place + 1 < len(paper.entries) else None,
    )


def _copies(entry: Entry, paper: Paper, record: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Return what a reader can copy, and its name; the address of the page has no text."""
    python = record["printed"] or record["corrected"]
    found = {
        "TeX": formula(entry.judgement),
        "Python": python if isinstance(python, str) else "",
        "BibTeX": bibtex(paper.about),
    }
    return [*((what, text) for what, text in found.items() if text), ("link", "")]


def paper_files(catalogue: Catalogue, paper: Paper, with_graph: frozenset[str]) -> dict[str, str]:
    """Return the pages that list the claims of a paper, of which some sections have a graph: all, and the errata."""
    address = paper_page(paper.about.key)
    shown = {"line": _line, "stated": _stated, "with_graph": with_graph, "most_listed": MOST_LISTED}
    files = {address: page("paper", address, catalogue=catalogue, paper=paper, **shown)}
    address = errata_page(paper.about.key)

    def with_links(text: str) -> Markup:
        return _linked(text, paper.about.key, address, catalogue)

    def instead(entry: Entry) -> Entry | None:
        return catalogue.by_number.get((paper.about.key, entry.claim.instead))

    files[address] = page(
        "errata",
        address,
        catalogue=catalogue,
        paper=paper,
        bibtex=bibtex(paper.about),
        grades=[*_grades(catalogue, paper)],
        forms=_erratum,
        stated=_stated,
        with_links=with_links,
        instead=instead,
    )
    return files


def start_html(catalogue: Catalogue) -> str:
    """Return the first page."""
    counts = summary([entry.judgement for entry in catalogue.entries])
    shown = {"figures": _figures(catalogue, counts), "verdicts": counts, "headlines": _headlines(catalogue)}
    return page("start", START, catalogue=catalogue, **shown)


def _figures(catalogue: Catalogue, counts: Mapping[str, int]) -> list[tuple[str, str, int]]:
    """Return what is counted, its verdict, and how often it occurs."""
    return [
        ("claims", "", len(catalogue.entries)),
        ("hold as printed", "proved", counts.get("proved", 0)),
        ("misprints and errors", "misprint", counts.get("misprint", 0) + counts.get("error", 0)),
        ("false statements", "false", counts.get("false", 0)),
        ("functions", "definition", len(catalogue.functions)),
    ]


def _headlines(catalogue: Catalogue) -> list[tuple[Entry, Markup, Markup, Markup]]:
    """Return the first three findings that change results and are marked in a line: claim, both forms, what follows."""
    every = dict(by_grade(gathered([entry.judgement for entry in catalogue.entries])))
    found = []
    for finding in every["results"]:
        entry = catalogue.by_number[finding.claim.paper, finding.claim.number]
        if MARK in _line(entry):
            found.append((entry, *_erratum(entry), _linked(finding.follows, entry.claim.paper, START, catalogue)))
    return found[:3]


def _grades(
    catalogue: Catalogue, paper: Paper
) -> Iterator[tuple[Grade, str, list[tuple[Finding, Entry, list[Entry]]]]]:
    """Yield the grades of findings with their headings; each finding with its claim and the others that have it."""

    def entry(judgement: Judgement) -> Entry:
        return catalogue.by_number[judgement.claim.paper, judgement.claim.number]

    for grade, found in by_grade(gathered([entry.judgement for entry in paper.entries])):
        yield grade, HEADINGS[grade], [(f, entry(f.first), [*map(entry, f.others)]) for f in found]


def _line(entry: Entry) -> Markup:
    """Return what is printed, and what is right instead, as far as it fits into a line."""
    claim = entry.claim
    if as_text := KINDS[claim.kind].text:
        printed, corrected = (Markup("({})").format(as_text(form)) for form in (claim.printed, claim.derived))
        return printed if claim.printed == claim.derived else _arrow(printed, corrected)
    forms = forms_of(claim)
    marks = marks_of(entry.judgement, forms)
    shown = listed(forms["printed"], marks["printed"])
    if claim.corrected is None:
        return shown or _summary(claim.printed)
    right = listed(forms["corrected"], marks["corrected"])
    if claim.printed is None:
        return Markup("reconstructed: {}").format(right or described(claim.corrected))
    if shown is None or right is None:
        return _summary(claim.printed)
    return _arrow(shown, right)


def _arrow(printed: Markup, corrected: Markup) -> Markup:
    return Markup('{} <span class="correct">correct: {}</span>').format(printed, corrected)


def _summary(statement: object) -> Markup:
    return Markup('<span class="summary">{}</span>').format(described(statement))


def _erratum(entry: Entry) -> tuple[Markup, Markup]:
    """Return the printed and the corrected form of a misprint, the difference marked."""
    claim = entry.claim
    if as_text := KINDS[claim.kind].text:
        as_number = Markup('<p class="number">({})</p>')
        return as_number.format(as_text(claim.printed)), as_number.format(as_text(claim.derived))
    forms = forms_of(claim)
    marks = marks_of(entry.judgement, forms)
    return _side("printed", forms, marks), _side("corrected", forms, marks)


def _side(part: Part, forms: Mapping[Part, Any], marks: Mapping[Part, Marks]) -> Markup:
    return block(forms[part], marks[part], f"{part} form", ordered=False)


def _stated(entry: Entry) -> Markup:
    part: Part = "corrected" if entry.claim.printed is None else "printed"
    return block(as_declared(entry.claim, part), label="form", ordered=False)


_NUMBER = re.compile(
    r"(?<![\w./#-])(?:table:)?\d+[a-z]?(?:\.\d+|/[^\s/#,;()]*[^\s/#,;().:])+(?:#[^\s,;()]*[^\s,;().:])?"
)


_ELSEWHERE = re.compile(r" See docs/[\w/.-]*\w\.")
"""A reference to the documentation, which the site does not have."""


def _linked(text: str, paper: str, page: str, catalogue: Catalogue) -> Markup:
    """Return a text, escaped, with links to the claims of a paper that it names."""
    text, result, end = _ELSEWHERE.sub("", text), Markup(), 0
    for match in _NUMBER.finditer(text):
        entry = catalogue.by_number.get((paper, match.group()))
        if entry is None or entry.page == page:
            continue
        link = Markup('<a href="{}">{}</a>').format(relative(entry.page, page), entry.claim.number)
        result, end = result + escape(text[end : match.start()]) + link, match.end()
    return result + escape(text[end:])
