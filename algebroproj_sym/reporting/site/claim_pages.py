"""The page of a claim, and the pages that list claims: papers and errata."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from markupsafe import Markup

from algebroproj_sym.declaring import KINDS, bibtex, quotations
from algebroproj_sym.reporting.site.addresses import claim_record_file, errata_page, paper_page
from algebroproj_sym.reporting.site.catalogue import Catalogue, Entry, Paper
from algebroproj_sym.reporting.site.comparison import (
    comparison,
    conditions,
    forms_of,
    marks_of,
    relation,
    where,
)
from algebroproj_sym.reporting.site.evidence import evidence
from algebroproj_sym.reporting.site.formulas import Form, block, described, listed
from algebroproj_sym.reporting.site.prose import linked
from algebroproj_sym.reporting.site.templating import page
from algebroproj_sym.showing import Part, as_declared


def claim_files(catalogue: Catalogue, paper: Paper, place: int, ledger_record: Mapping[str, Any]) -> dict[str, str]:
    """Return the page of a claim, and its record in the ledger if something was too long for the page."""
    entry = paper.entries[place]
    claim = entry.judgement.claim
    forms, found = comparison(entry.judgement), evidence(entry.judgement)
    meanings = where(claim)
    instead = catalogue.by_number.get((entry.paper, claim.instead))
    complete = forms.complete and found.complete and all(form.complete for _, form in meanings)
    record = None if complete else claim_record_file(entry.paper, entry.number)
    html = page(
        "claim",
        entry.page,
        entry=entry,
        claim=claim,
        paper=paper,
        relation=relation(claim),
        comparison=forms,
        conditions=conditions(entry.judgement),
        where=meanings,
        constraints=[block(expression) for expression in claim.constraints],
        nonzero=[block(expression) for expression in claim.nonzero],
        evidence=found,
        note=linked(claim.note, entry.paper, entry.page, catalogue),
        instead=instead,
        instead_conditions=conditions(instead.judgement) if instead else "",
        functions=catalogue.functions_on(entry),
        quote=quotations(entry.derivation.path.parent).quotes.get(entry.number),
        cell=catalogue.cell_of(entry),
        checked=catalogue.is_checked(entry),
        previous=paper.entries[place - 1] if place else None,
        following=paper.entries[place + 1] if place + 1 < len(paper.entries) else None,
        record=record,
    )
    if record is None:
        return {entry.page: html}
    return {entry.page: html, record: json.dumps(ledger_record, indent=1, ensure_ascii=False) + "\n"}


def paper_files(catalogue: Catalogue, paper: Paper) -> dict[str, str]:
    """Return the pages that list the claims of a paper: all of them, and the errata."""
    address = paper_page(paper.key)
    files = {address: page("paper", address, paper=paper, line=_line, conditions=conditions)}
    address = errata_page(paper.key)

    def note(entry: Entry) -> Markup:
        return linked(entry.judgement.claim.note, paper.key, address, catalogue)

    def instead(entry: Entry) -> Entry | None:
        return catalogue.by_number.get((paper.key, entry.judgement.claim.instead))

    files[address] = page(
        "errata",
        address,
        paper=paper,
        bibtex=bibtex(paper.about),
        forms=_erratum,
        conditions=conditions,
        stated=_stated,
        note=note,
        instead=instead,
    )
    return files


def _line(entry: Entry) -> Markup:
    """Return what is printed, and what is right instead, as far as it fits into a line."""
    claim = entry.judgement.claim
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
    return Markup("{} <span>correct: {}</span>").format(printed, corrected)


def _summary(statement: object) -> Markup:
    return Markup('<span class="summary">{}</span>').format(described(statement))


def _erratum(entry: Entry) -> tuple[Form, Form]:
    """Return the printed and the corrected form of a misprint, the difference marked."""
    claim = entry.judgement.claim
    if as_text := KINDS[claim.kind].text:
        as_number = Markup('<p class="number">({})</p>')
        return Form(as_number.format(as_text(claim.printed))), Form(as_number.format(as_text(claim.derived)))
    forms = forms_of(claim)
    marks = marks_of(entry.judgement, forms)
    printed, corrected = (
        block(forms[part], marks[part], f"{part} form", ordered=False) for part in ("printed", "corrected")
    )
    return printed, corrected


def _stated(entry: Entry) -> Form:
    part: Part = "corrected" if entry.judgement.claim.printed is None else "printed"
    return block(as_declared(entry.judgement.claim, part), label="form", ordered=False)
