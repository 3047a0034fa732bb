"""What follows only from an equation that is not proved does not follow."""

import re
from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import replace

from algebroproj_sym.reading.judging.verdicts import Reading
from algebroproj_sym.reading.remembering.memory import where_of

_PARTS = re.compile(r"the derivative of | with |, where ")
"""What stands between the places on which a derivative rests."""


def without_refuted_premises(readings: Sequence[Reading], closed: Collection[str]) -> list[Reading]:
    """Return readings in which nothing follows from an equation that contradicts.

    Nor does it from the end of a chain that gives a letter, if the end is not proved to be equal to its beginning.

    Nor does it from an equation that one change would mend, within its display, or together with what that one rests
    on: both would give what neither says.
    """
    found = list[Reading]()
    refuted = set[str]()
    mended: dict[str, set[str]] = {}
    places = Counter(where_of(each.statement) for each in readings)
    doubted = {id(each.statement.display) for each in readings if any(link.suggestion for link in each.links)}
    for each in readings:
        own = {where_of(each.statement)} if id(each.statement.display) in doubted else set()
        links = tuple(
            replace(link, verdict="independent", reason=f"it follows only from {wrong[0]}, which is not proved")
            if link.verdict == "follows"
            and (
                wrong := [
                    where
                    for where in link.rests_on
                    if {*_PARTS.split(where)} & (refuted | own)
                    or not mended.get(where, set()).isdisjoint(link.rests_on)
                ]
            )
            else link
            for link in each.links
        )
        found.append(replace(each, links=links))
        where = where_of(each.statement)
        if places[where] == 1 and (rests := {one for link in links if link.suggestion for one in link.rests_on}):
            mended[where] = rests
        open_chain = where in closed and any(link.verdict != "follows" for link in links[1:])
        if found[-1].verdict == "contradicts" or open_chain:
            refuted.add(where)
    return found
