r"""What stands above or below something else: ``\overset{(3)}{=}`` is ``=``, and ``\underbrace{a}_{b}`` is ``a``."""

import re

from algebroproj_sym.reading.documents.page import Page
from algebroproj_sym.reading.documents.pending import at, braced, formulas_in, group_start, renamed
from algebroproj_sym.reading.lexing.commands import BIG, LETTERS, RELATIONS, UPRIGHT
from algebroproj_sym.reading.lexing.pieces import Piece, has_relation, is_closed

INFIX = {r"\over": r"\frac", r"\choose": r"\binom"}
OVER = frozenset((r"\overset", r"\stackrel", r"\underset"))
BRACES = frozenset((r"\underbrace", r"\overbrace", r"\underbracket", r"\overbracket"))
_JUSTIFIES = re.compile(
    r"|.*(?:def|triangle|Delta|\(|ref\b).*|\d+|(?:\\(?:text|mathrm|rm)\b\W*)?(?!law|iid|lim|dist)[A-Za-z][a-z]{2}[^\\]*",
    re.DOTALL,
)
"""What stands above = where it is an equality: a citation, a word, a sign of definitions; and no letter or limit."""
_LIMITS = re.compile(
    r"\b(?:mod|modulo|wrong|no|not|never|only|false|if|when|approx\w*|almost|roughly|small|large|w\.?p|a\.?s|in)\b",
    re.IGNORECASE,
)
"""Words above or below = by which it is none, or holds in a case."""
_EXTREMUM = re.compile(
    r"\\(?:operatorname\*?|mathrm|text|mathop)\{\\?arg(?:\\[,;! ])?\s*\\?(?:min|max)\}|\\arg\s*\\(?:min|max)"
)
"""The place of a least or a greatest value, as it is written."""
_LONE = re.compile(r"[a-zA-Z]|\\math[a-z]+\s*\{?\s*[a-zA-Z]\s*\}?")
"""A letter, perhaps in a style."""
_ACCENTS_ABOVE = {
    r"\circ": r"\mathring",
    ".": r"\dot",
    r"\cdot": r"\dot",
    r"\sim": r"\tilde",
    r"\frown": r"\overline",
    r"\leftrightarrow": r"\overline",
    r"\rightharpoonup": r"\vec",
}
"""What is an accent where it is written above a letter."""
_WORDS = (r"\text", r"\textrm", r"\mbox")
SIZES = frozenset(
    rf"\{name}"
    for name in (
        "tiny",
        "scriptsize",
        "footnotesize",
        "small",
        "normalsize",
        "large",
        "Large",
        "centering",
        "MoveEqLeft",
        "IEEEnonumber",
        "IEEEyesnumber",
        "IEEEyessubnumber",
        "allowdisplaybreaks",
        "displaylimits",
        "newline",
    )
)
"""Commands that change the looks of all behind them."""


def stacked(page: Page, piece: Piece) -> bool:
    r"""Read what is written above or below something, as by ``\overset``."""
    over, base = page.waiting.group(), page.waiting.group()
    relation = "".join(each.text for each in base).strip()
    above = "".join(each.text for each in over if each.text not in SIZES).strip()
    if _EXTREMUM.fullmatch(relation):
        base = at(piece, r"\argmin" if "min" in relation else r"\argmax")
        relation = base[0].text
    if piece.text == r"\underset" and relation in BIG:
        page.waiting.put([*base, renamed(piece, "_"), *braced(piece, over)])
        return True
    if piece.text == r"\underset" and above.startswith(r"\text") and base[:1] and base[0].text in BRACES:
        page.waiting.put(braced(piece, base))
        return True
    extreme = re.search(r"\{(?:arg)?(?:min|max|lim|inf|sup)", relation)
    if piece.text == r"\underset" and base[:1] and base[0].text in UPRIGHT and not extreme:
        page.waiting.put([*base, renamed(piece, "_"), *braced(piece, over)])
        return True
    if above in _ACCENTS_ABOVE:
        page.waiting.put([renamed(piece, _ACCENTS_ABOVE[above]), *braced(piece, base)])
        return True
    if relation == "=" and (_LIMITS.search(above) or not _JUSTIFIES.fullmatch(above)):
        relation = r"\equiv" if above == "!" else r"\questeq"
    defines = relation == "=" and re.search(r"def|triangle", above)
    if piece.text != r"\underset" and (relation in LETTERS or _LONE.fullmatch(relation)):
        page.waiting.put(
            [*base, renamed(piece, "^"), *braced(piece, [renamed(piece, "("), *over, renamed(piece, ")")])]
        )
        return True
    plain = [piece, *braced(piece, over), *braced(piece, base)]
    page.out.extend(at(piece, ":=" if defines else relation) if relation in RELATIONS else plain)
    return True


def built(page: Page, piece: Piece) -> bool:
    r"""Read ``\buildrel a \over =`` as what stands above a relation."""
    above = page.waiting.before(r"\over")
    page.waiting.put([renamed(piece, r"\overset"), *braced(piece, above)] if above else [])
    return bool(above)


def braced_below(page: Page, piece: Piece) -> bool:
    """Leave a brace above or below a formula out, with what is written at it; words at an equation stand behind it."""
    inside, below = page.waiting.group(), list[Piece]()
    if page.waiting.next in ("_", "^"):
        page.waiting.group()
        below = page.waiting.group()
    bare = has_relation(inside) or not is_closed(inside)
    inside += (
        [renamed(piece, r"\quad"), *below] if has_relation(inside) and below[:1] and below[0].text in _WORDS else []
    )
    page.waiting.put(inside if bare else braced(piece, formulas_in(inside) or inside))
    return True


def infix(page: Page, piece: Piece) -> bool:
    r"""Write ``a \over b`` as a fraction."""
    start = group_start(page.out)
    if start is not None:
        page.out[start:] = [
            renamed(piece, INFIX[piece.text]),
            *braced(piece, page.out[start:]),
            renamed(piece, "{"),
        ]
        page.waiting.close_group(piece)
    return start is not None
