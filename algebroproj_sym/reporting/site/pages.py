"""All files of the site."""

from __future__ import annotations

import json

from algebroproj_sym.declaring import VERDICTS, quotes_of
from algebroproj_sym.reporting.ledger import ledger
from algebroproj_sym.reporting.site.addresses import LEDGER, PROVER, SEARCH, START
from algebroproj_sym.reporting.site.catalogue import Catalogue
from algebroproj_sym.reporting.site.claim_pages import claim_html, headlines, paper_files
from algebroproj_sym.reporting.site.folder import MARKER
from algebroproj_sym.reporting.site.function_pages import function_files
from algebroproj_sym.reporting.site.notebook_pages import notebook_files
from algebroproj_sym.reporting.site.search import search_script
from algebroproj_sym.reporting.site.templating import licence, page, static, style


def render_site(catalogue: Catalogue) -> dict[str, str]:
    """Return the text of each file of the site by its address.

    Parameters
    ----------
    catalogue : Catalogue
        What the site is about.
    """
    quotes = quotes_of(entry.derivation for entry in catalogue.entries)
    record = ledger([entry.judgement for entry in catalogue.entries], quotes, timed=False)
    records = {(claim["paper"], claim["number"]): claim for claim in record["claims"]}
    files = {
        START: page("start", START, catalogue=catalogue, verdicts=VERDICTS, headlines=headlines(catalogue)),
        SEARCH: page("search", SEARCH, catalogue=catalogue),
        MARKER: search_script(catalogue),
        LEDGER: json.dumps(record, indent=1, ensure_ascii=False) + "\n",
        "style.css": style(),
        "font-licence.txt": licence(),
        "search.js": static("search.js"),
        "copy.js": static("copy.js"),
    }
    for paper in catalogue.papers:
        files |= paper_files(catalogue, paper)
        for place, entry in enumerate(paper.entries):
            claim = records[entry.claim.paper, entry.claim.number]
            files[entry.page] = claim_html(catalogue, paper, place, claim)
            if catalogue.live:
                files[entry.record] = json.dumps(claim, ensure_ascii=False) + "\n"
    if catalogue.live:
        files[PROVER] = page("prover", PROVER, catalogue=catalogue)
    return files | function_files(catalogue) | notebook_files(catalogue)
