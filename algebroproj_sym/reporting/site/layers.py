"""A directed graph as SVG: each vertex stands to the right of those it rests on, with few crossings of edges.

The layout is the one of Sugiyama: columns by the longest path, order in a column by the mean of the neighbours.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeAlias

from markupsafe import Markup

ROW, HEIGHT, PASSAGE, GAP, MARGIN = 34, 26, 12, 44, 8
"""From row to row, of a box, of an edge that passes a column, between columns, around all."""
CHARACTER, PADDING = 7.3, 7
SWEEPS = 8

Place: TypeAlias = "str | tuple[str, str, int]"
"""A vertex by its name, or where an edge passes a column."""
Bases: TypeAlias = Mapping[str, Sequence[str]]


@dataclass(frozen=True)
class Vertex:
    """A vertex: its name, what is written in it, where it leads, what it is in words, and its class in the style."""

    name: str
    label: str
    address: str
    title: str
    style: str


def graph_svg(vertices: Sequence[Vertex], bases: Bases, label: str) -> Markup:
    """Return a graph as SVG, with a label for screen readers.

    The vertices of a column are in the given order, as far as their edges leave it open.  An edge that a path makes
    superfluous is not drawn, nor one that closes a circle.
    """
    names = [vertex.name for vertex in vertices]
    forwards = without_circles(names, bases)
    column = _columns(names, forwards)
    chains: list[list[Place]] = [
        [base, *((base, name, k) for k in range(column[base] + 1, column[name])), name]
        for name, found in without_shortcuts(forwards).items()
        for base in found
    ]
    columns: list[list[Place]] = [[] for _ in range(1 + max(column.values(), default=0))]
    for place in dict.fromkeys([*names, *(place for chain in chains for place in chain)]):
        columns[_column(place, column)].append(place)
    beside = _neighbours(chains)
    _sort(columns, beside)
    y = _heights(columns, beside)
    label_of = {vertex.name: vertex.label for vertex in vertices}
    width = {place: len(label_of[place]) * CHARACTER + 2 * PADDING if place in label_of else 0.0 for place in y}
    widths = [max((width[place] for place in places), default=0.0) for places in columns]
    x = [MARGIN + sum(widths[:k]) + GAP * k for k in range(len(columns))]
    lines = [
        _line(chain, [(x[k := _column(p, column)], width[p] or widths[k], y[p]) for p in chain]) for chain in chains
    ]
    boxes = [_box(vertex, x[column[vertex.name]], y[vertex.name], width[vertex.name]) for vertex in vertices]
    size = round(x[-1] + widths[-1] + MARGIN), round(max(y.values(), default=0) + HEIGHT / 2 + MARGIN)
    return Markup(
        '<svg class="graph" role="group" aria-label="{0}" width="{1}" height="{2}" viewBox="0 0 {1} {2}">{3}</svg>'
    ).format(label, *size, Markup("").join(lines + boxes))


def without_circles(names: Iterable[str], bases: Bases) -> dict[str, list[str]]:
    """Return the edges but for those that close a circle; vertices that stand for several claims may have some.

    Examples
    --------
    >>> without_circles("ab", {"a": ["b"], "b": ["a", "b"]})
    {'a': ['b'], 'b': []}
    """
    kept: dict[str, list[str]] = {name: [] for name in names}
    below: dict[str, set[str]] = {name: {name} for name in kept}
    for name in kept:
        for base in dict.fromkeys(bases.get(name, ())):
            if base in kept and name not in below[base]:
                kept[name].append(base)
                for above in below.values():
                    if name in above:
                        above |= below[base]
    return kept


def without_shortcuts(bases: Bases) -> dict[str, list[str]]:
    """Return the edges but for those that a path makes superfluous.

    Examples
    --------
    >>> without_shortcuts({"a": [], "b": ["a"], "c": ["a", "b"]})
    {'a': [], 'b': ['a'], 'c': ['b']}
    """

    def reached(name: str) -> set[str]:
        found, waiting = set(), [*bases[name]]
        while waiting:
            base = waiting.pop()
            if base not in found:
                found.add(base)
                waiting += bases[base]
        return found

    below = {name: reached(name) for name in bases}
    return {name: [b for b in found if not any(b in below[other] for other in found)] for name, found in bases.items()}


def _columns(names: Iterable[str], bases: Bases) -> dict[str, int]:
    found: dict[str, int] = {}

    def column(name: str) -> int:
        if name not in found:
            found[name] = 1 + max(map(column, bases[name]), default=-1)
        return found[name]

    return {name: column(name) for name in names}


def _column(place: Place, column: Mapping[str, int]) -> int:
    return column[place] if isinstance(place, str) else place[2]


def _neighbours(chains: Iterable[Sequence[Place]]) -> dict[Place, list[Place]]:
    found: dict[Place, list[Place]] = {}
    for first, second in (pair for chain in chains for pair in pairwise(chain)):
        found.setdefault(first, []).append(second)
        found.setdefault(second, []).append(first)
    return found


def _sort(columns: list[list[Place]], beside: Mapping[Place, Sequence[Place]]) -> None:
    """Sort each column by where the neighbours are in the column before it, then in the one after it, and so on."""
    for sweep in range(SWEEPS):
        for before, places in pairwise(columns if sweep % 2 == 0 else columns[::-1]):
            at = {place: k / len(before) for k, place in enumerate(before)}
            own = {place: k / len(places) for k, place in enumerate(places)}
            places.sort(key=lambda place: _mean([at[b] for b in beside.get(place, ()) if b in at], own[place]))


def _heights(columns: Sequence[Sequence[Place]], beside: Mapping[Place, Sequence[Place]]) -> dict[Place, float]:
    """Return how far down each place is: at the mean of its neighbours to the left, as far as there is room."""
    y: dict[Place, float] = {}
    for places in columns:
        wanted = [_mean([y[b] for b in beside.get(place, ()) if b in y], 0.0) for place in places]
        found: list[float] = []
        for (before, place), wish in zip(pairwise(["", *places]), wanted, strict=True):
            room = (_room(before) + _room(place)) / 2
            found.append(max(wish, found[-1] + room) if found else wish)
        shift = _mean([a - b for a, b in zip(wanted, found, strict=True)], 0.0)
        y |= dict(zip(places, (height + shift for height in found), strict=True))
    top = MARGIN + HEIGHT / 2 - min(y.values(), default=0.0)
    return {place: height + top for place, height in y.items()}


def _mean(values: Sequence[float], otherwise: float) -> float:
    return sum(values) / len(values) if values else otherwise


def _room(place: Place) -> int:
    return ROW if isinstance(place, str) else PASSAGE


def _line(chain: Sequence[Place], stops: Sequence[tuple[float, float, float]]) -> Markup:
    """Return an edge: from the right end of a box, straight through columns, to the left end of another."""
    (left, width, y), *others = stops
    path = f"M{left + width:.0f} {y:.0f}"
    at = left + width
    for place, (left, width, below) in enumerate(others, 1):
        bend = (at + left) / 2
        path += f"C{bend:.0f} {y:.0f} {bend:.0f} {below:.0f} {left:.0f} {below:.0f}"
        path += f"H{left + width:.0f}" if place < len(others) else ""
        at, y = left + width, below
    return Markup('<path data-from="{}" data-to="{}" d="{}"/>').format(chain[0], chain[-1], path)


def _box(vertex: Vertex, x: float, y: float, width: float) -> Markup:
    return Markup(
        '<a href="{}" class="{}" data-vertex="{}"><title>{}</title>'
        '<rect x="{:.0f}" y="{:.0f}" width="{:.0f}" height="{}" rx="4"/>'
        '<text x="{:.0f}" y="{:.0f}" text-anchor="middle">{}</text></a>'
    ).format(
        *(vertex.address, vertex.style, vertex.name, vertex.title),
        *(x, y - HEIGHT / 2, width, HEIGHT),
        *(x + width / 2, y + 4, vertex.label),
    )
