"""The graphs of what rests on what: the sections of a paper, and the equations and functions of a section."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from algebroproj_sym.reporting.site.addresses import graph_page, relative
from algebroproj_sym.reporting.site.catalogue import Catalogue, Chapter, Equation, Paper
from algebroproj_sym.reporting.site.layers import Vertex, graph_svg
from algebroproj_sym.reporting.site.templating import page


@dataclass(frozen=True)
class Graph:
    """What rests on what in a section."""

    chapter: Chapter
    """The section."""
    vertices: tuple[Vertex, ...]
    """Its equations and the functions that rest on them, and equations of other sections that they rest on."""
    bases: Mapping[str, Sequence[str]]
    """What each of them rests on, by name."""

    @property
    def address(self) -> str:
        """Where its page is."""
        return graph_page(self.chapter.paper, self.chapter.number)


def graphs_of(catalogue: Catalogue, paper: Paper) -> tuple[Graph, ...]:
    """Return the graphs of the sections of a paper; a section in which nothing rests on anything has none."""
    equations = {
        entry.key: equation for each in catalogue.papers for equation in _equations(each) for entry in equation.entries
    }
    found = (_graph(catalogue, chapter, equations) for chapter in paper.chapters)
    return tuple(graph for graph in found if graph.bases)


def graph_files(catalogue: Catalogue, paper: Paper, graphs: Sequence[Graph]) -> dict[str, str]:
    """Return the page of each graph, and the page with the graph of the sections."""
    files = {graph.address: _page(catalogue, paper, graph) for graph in graphs}
    if graphs:
        files[graph_page(paper.about.key)] = _overview(catalogue, paper, graphs)
    return files


def _equations(paper: Paper) -> Iterator[Equation]:
    return (equation for chapter in paper.chapters for equation in chapter.equations)


def _graph(catalogue: Catalogue, chapter: Chapter, equations: Mapping[tuple[str, str], Equation]) -> Graph:
    bases: dict[str, list[str]] = {}
    vertices: dict[str, Vertex] = {}

    def vertex(equation: Equation) -> str:
        first = equation.entries[0]
        name = equation.number if first.claim.paper == chapter.paper else f"{first.claim.paper} {equation.number}"
        own = (first.claim.paper, first.claim.section) == (chapter.paper, chapter.number)
        style = equation.verdict if own else f"{equation.verdict} elsewhere"
        vertices[name] = Vertex(name, name, first.page, f"{first.claim.title}: {equation.verdict}", style)
        return name

    for equation in chapter.equations:
        below = [equations[base.key] for entry in equation.entries for base in catalogue.bases(entry)]
        below = [each for each in dict.fromkeys(below) if each is not equation]
        above = {each.name: each for entry in equation.entries for each in catalogue.functions_on(entry.claim)}
        if below:
            bases[vertex(equation)] = [*map(vertex, below)]
        for function in above.values():
            kernel = function.lowered.kernel
            vertices[function.name] = Vertex(function.name, kernel.name, function.page, kernel.summary, "function")
            bases.setdefault(function.name, []).append(vertex(equation))
    order = {name: place for place, name in enumerate(equation.number for equation in chapter.equations)}
    ordered = sorted(
        vertices.values(), key=lambda each: order.get(each.name, -1 if each.style != "function" else len(order))
    )
    return Graph(chapter, tuple(ordered), bases)


def _page(catalogue: Catalogue, paper: Paper, graph: Graph) -> str:
    return page(
        "graph",
        graph.address,
        catalogue=catalogue,
        paper=paper,
        title=f"What rests on what in section {graph.chapter.number}",
        chapter=graph.chapter,
        picture=graph_svg(_linked(graph.vertices, graph.address), graph.bases, "Equations and functions"),
        rows=_rows(graph.vertices, graph.bases),
    )


def _overview(catalogue: Catalogue, paper: Paper, graphs: Sequence[Graph]) -> str:
    address = graph_page(paper.about.key)
    known = {graph.chapter.number: graph for graph in graphs}
    sections = [
        Vertex(number, number, graph.address, f"Section {number}, {graph.chapter.title}", "section")
        for number, graph in known.items()
    ]
    own = {entry.key: chapter.number for chapter in paper.chapters for entry in chapter.entries}
    bases = {
        number: [
            *dict.fromkeys(
                own[base.key] for entry in graph.chapter.entries for base in catalogue.bases(entry) if base.key in own
            )
        ]
        for number, graph in known.items()
    }
    bases = {number: [base for base in found if base != number and base in known] for number, found in bases.items()}
    return page(
        "graph",
        address,
        catalogue=catalogue,
        paper=paper,
        title="What rests on what",
        chapter=None,
        picture=graph_svg(_linked(sections, address), bases, "Sections"),
        rows=_rows(sections, bases),
    )


def _linked(vertices: Sequence[Vertex], address: str) -> list[Vertex]:
    return [replace(vertex, address=relative(vertex.address, address)) for vertex in vertices]


def _rows(vertices: Sequence[Vertex], bases: Mapping[str, Sequence[str]]) -> list[tuple[Vertex, list[Vertex]]]:
    """Return each vertex that rests on others, with these."""
    named = {vertex.name: vertex for vertex in vertices}
    found = [(vertex, [named[base] for base in bases.get(vertex.name, ())]) for vertex in vertices]
    return [(vertex, below) for vertex, below in found if below]
