"""All files of the site."""

import json

from algebroproj_sym.declaring import quotes_of
from algebroproj_sym.reporting.ledger import ledger
from algebroproj_sym.reporting.site.addresses import LEDGER, PROVER, SEARCH, START
from algebroproj_sym.reporting.site.catalogue import Catalogue
from algebroproj_sym.reporting.site.claim_pages import claim_html, paper_files, start_html
from algebroproj_sym.reporting.site.folder import MARKER
from algebroproj_sym.reporting.site.function_pages import function_files
from algebroproj_sym.reporting.site.graph_pages import graph_files, graphs_of
from algebroproj_sym.reporting.site.notebook_pages import notebook_files
from algebroproj_sym.reporting.site.search import search_script
from algebroproj_sym.reporting.site.symbols import symbol_files, symbols_in
from algebroproj_sym.reporting.site.templating import licence, page, static, style


def render_site(catalogue: Catalogue) -> dict[str, str]:
    """Return the text of each file of the site by its address."""
    quotes = quotes_of(entry.derivation for entry in catalogue.entries)
    record = ledger([entry.judgement for entry in catalogue.entries], quotes, timed=False)
    claims = {(claim["paper"], claim["number"]): claim for claim in record["claims"]}
    symbols = symbols_in(catalogue)
    files = {
        START: start_html(catalogue),
        SEARCH: page("search", SEARCH, catalogue=catalogue),
        MARKER: search_script(catalogue, symbols),
        LEDGER: json.dumps(record, ensure_ascii=False) + "\n",
        "style.css": style(),
        "font-licence.txt": licence(),
        **{name: static(name) for name in ("icon.svg", "search.js", "copy.js", "graph.js", "symbols.js")},
    }
    for paper in catalogue.papers:
        graphs = graphs_of(catalogue, paper)
        with_graph = frozenset(graph.chapter.number for graph in graphs)
        files |= paper_files(catalogue, paper, with_graph)
        files |= graph_files(catalogue, paper, graphs)
        for place, entry in enumerate(paper.entries):
            has_graph = entry.claim.section in with_graph
            files[entry.page] = claim_html(catalogue, symbols, paper, place, claims[entry.key], has_graph)
        files |= symbol_files(catalogue, paper, symbols)
    if catalogue.live:
        files[PROVER] = page("prover", PROVER, catalogue=catalogue)
    return files | function_files(catalogue) | notebook_files(catalogue)
