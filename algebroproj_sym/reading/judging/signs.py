"""What words say of the signs of letters: nothing follows where a letter is positive that may be negative."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import replace

from algebroproj_sym.reading.defining.phrases import symbols_of
from algebroproj_sym.reading.documents.displays import Document
from algebroproj_sym.reading.judging.verdicts import Reading

MOST_SEARCHED = 2000
"""Beside how many formulas the words are searched."""
_NEGATIVE = re.compile(
    r"\$([^$=<>]*)\$ (?:(?:may|can|could|might) (?:also )?be|is|are) (?:negative|of (?:either|any) sign)"
    r"|\$([^$=<>]*?) ?(?:<|\\lt|\\le|\\leq) ?0 ?\$"
    r"|\$([^$=<>]*)\$(?: and \$([^$=<>]*)\$)? (?:be|is|are)\b[^.$]{0,30}\bnegative (?:numbers?|charges?|values?)\b"
)
_ZERO = re.compile(
    r"\$([^$=<>]*)\$ (?:(?:may|can|could|might) (?:also )?be zero|is zero|vanishes)\b"
    r"|\b(?:at rest|that is|so|hence|thus|therefore),? \$([^$=<>]*?) ?= ?0\$"
)


def may_be_negative(document: Document) -> frozenset[str]:
    """Return the hypotheses that words deny: ``x > 0`` where x may be negative, in names and in LaTeX."""
    words = " ".join(f"{each.before} ${each.latex}$ {each.after}" for each in document.formulas[:MOST_SEARCHED])
    letters = {symbol for match in _NEGATIVE.findall(words) for each in match for symbol in symbols_of(each)}
    zero = {symbol for match in _ZERO.findall(words) for each in match for symbol in symbols_of(each)}
    names = {each.lstrip("\\") for each in letters}, {each.lstrip("\\") for each in zero}
    return frozenset(f"{each} {sign} 0" for each in names[0] for sign in (">", ">=")) | names[1]


def without_signs(reading: Reading, letters: Collection[str]) -> Reading:
    """Return a reading in which nothing follows where a letter is positive that words call negative."""
    links = tuple(
        replace(link, verdict="not decided", reason=f"{wrong[0].partition(' ')[0]} may be negative")
        if link.verdict == "follows" and (wrong := [each for each in link.hypotheses if each in letters])
        else link
        for link in reading.links
    )
    return replace(reading, links=links)
