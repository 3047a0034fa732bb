r"""Displays that authors call otherwise, as displays: ``\be``, ``\eq{a = b}``, ``\begin{eqn}``."""

import re
from collections.abc import Iterator, Mapping

from algebroproj_sym.reading.documents.macros import MAX_EXPANSIONS, Macro, filled_in, macros_in
from algebroproj_sym.reading.lexing.commands import MAX_NESTING, MAX_PIECES

MOST_ADDED = 1_000_000
"""How many characters macros may add to a text."""
OPTIONED = "alignat", "xalignat", "xxalignat", "IEEEeqnarray", "empheq"
"""Displays behind whose beginning more is said of them."""
ENVIRONMENTS = (
    *("equation", "align", "gather", "multline", "flalign", "eqnarray", "displaymath", "dmath", "math"),
    *OPTIONED,
)
_MARK = re.compile(rf"\\(?:begin|end)\{{(?:{'|'.join(ENVIRONMENTS)})\*?\}}|\$\$|(?<!\\)\\[\[\]]")
_BEGIN = re.compile(r"\\begin\{([a-zA-Z]+)\*?\}(?:\[[^\[\]\n]*\]|\{[\w:, -]*\})*")
_OF_WORDS = re.compile(
    r"(?<!\\)(?:\$|\\\()|\\(?:item|caption|includegraphics|node|draw|arrow|path|[Ss]tate|put|addplot)(?![a-zA-Z])"
)
"""What stands in words and drawings alone."""
_OF_FORMULAS = re.compile(
    r"\\(?:[dt]?frac|sqrt|sum|int|partial|nabla|cdot|times|left|math(?:rm|bf|cal|bb)|boldsymbol|bm|quad|"
    r"alpha|beta|gamma|delta|epsilon|theta|kappa|lambda|mu|nu|xi|pi|rho|sigma|tau|phi|varphi|chi|psi|omega|sin|cos)"
    r"(?![a-zA-Z])"
)
"""A command that LaTeX takes in formulas alone."""


def with_displays(text: str) -> str:
    r"""Return a text in which displays have the names of LaTeX; each line remains where it is.

    Macros and environments of the author that make displays are expanded.

    Examples
    --------
    >>> with_displays(r"\newcommand{\eq}[1]{\begin{equation}#1\end{equation}}\eq{a = b}").partition("}}")[2]
    '\\begin{equation}a = b\\end{equation}'
    """
    macros, spans = macros_in(text)
    own = {name: each for name, each in macros.items() if _MARK.search(each.body)}
    searched = text
    for begin, end in spans if own else ():
        searched = searched[:begin] + " " * (end - begin) + searched[end:]
    return _expanded(text, searched, own, iter(range(MAX_EXPANSIONS)), 0) if own else text


def _expanded(text: str, searched: str, own: Mapping[str, Macro], budget: Iterator[int], depth: int) -> str:
    """Return a text in which some macros are expanded where another text of its length has them, within bounds."""
    names = re.compile("|".join(rf"{re.escape(each)}{'' if each[-1] == '}' else '(?![a-zA-Z])'}" for each in own))
    kept, place, added = list[str](), 0, 0
    for call in names.finditer(searched):
        if call.start() < place or added > MOST_ADDED:
            continue
        filled = filled_in(own[call[0]], text, call.end())
        if filled is None or next(budget, None) is None:
            continue
        body, end = filled
        body = _expanded(body, body, own, budget, depth + 1) if depth < MAX_NESTING else body
        added += len(body)
        lines = text.count("\n", call.start(), end) - body.count("\n")
        kept += [text[place : call.start()], body.replace("\n", " ", max(-lines, 0)), "\n" * lines]
        place = end
    return "".join([*kept, text[place:]])


def unknown_displays(text: str) -> dict[str, str]:
    r"""Return how environments begin and end that nothing defines, and that hold formulas and no words.

    Examples
    --------
    >>> unknown_displays(r"\begin{law} p = \frac{n R T}{V} \end{law} \begin{note} $a = b$ \end{note}")
    {'\\begin{law}': '\\end{law}'}
    """
    found = dict[str, str]()
    for begin in _BEGIN.finditer(text):
        ending = rf"\end{{{begin[1]}}}"
        end = text.find(ending, begin.end(), begin.end() + MAX_PIECES)
        inside = text[begin.end() : end] if end > 0 and begin[1] not in ENVIRONMENTS else ""
        if "=" in inside and _OF_FORMULAS.search(inside) and not (_OF_WORDS.search(inside) or _MARK.search(inside)):
            found[begin[0]] = ending
    return found
