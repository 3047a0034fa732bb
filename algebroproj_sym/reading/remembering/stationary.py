r"""What a sentence says of derivatives: "Setting the gradient to zero gives" supposes that it is zero.

The derivative is the one that is given last above it.  Where it is zero, the letter by which it is taken may get an
accent or a star, as in ``\hat\mu``.
"""

import re
from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import product

from lark import Token, Tree

from algebroproj_sym.reading.defining.notation import DOT, PARTIAL, derivative_in, quotient
from algebroproj_sym.reading.defining.premises import MOST_TOGETHER, Premise, letter_of
from algebroproj_sym.reading.deriving.rates import ZERO
from algebroproj_sym.reading.parsing.grammar import Formula, put_in, symbols_in
from algebroproj_sym.reading.prose.contexts import ANYWHERE
from algebroproj_sym.reading.prose.devices import heard, says
from algebroproj_sym.reading.prose.words import Beside

_FORMULA = r"\$[^$]*\$"
_NAMED = rf"(?:the [a-z]+(?: [a-z]+)?|{_FORMULA})"
_WHAT = r"(?:the|its|this|these|both) (?:(?:partial|first|resulting) )?(?:<slopes>|expressions?)|<it>"
_TO_ZERO = heard(
    rf"\b<zeroing>\s+(?P<what>{_WHAT})"
    rf"(?P<of>\s+of\s+{_NAMED})?(?P<by>\s+with\s+respect\s+to\s+{_NAMED}(?:(?:,|\s+and)\s+{_NAMED})*)?"
    r"\s+(?:equal\s+)?to\s+(?:zero|\$(?:0|\\mathbf\{0\})\$)"
    rf"|\b(?P<zero>{_WHAT})\s+<vanishing>\b"
)
_SEVERAL = re.compile(r"them|both|these|\w+s$", re.IGNORECASE)
_PRONOUN = heard(r"<it>$|.*expressions?$")
_LEADS = heard(r"\W*(?:<proceeds>\b\W*)*")
_ELSEWHERE = heard(r"\b<places>\b")
_ITSELF = heard(r"\b(?:<slopes>|slopes?)\b[^.]*[.]\s")
"""A sentence that says more of a derivative."""
_NABLA = re.compile(r"\\nabla(?:_(.*))?")
_AT_BEST = re.compile(r"\\(?:wide)?hat|\^(?:\*|\\star|\\ast)$|_(?:MLE?|LS|OLS|opt)$")


def set_to_zero(beside: Beside, premises: Sequence[Premise], letters: Collection[str], above: int) -> list[Premise]:
    """Return that the derivatives above an equation are zero, if its sentence says so.

    The letters are those of the equation that nothing gives, and above is where the display just above it begins.
    """
    match = _TO_ZERO.search(beside.sentence)
    if match is None or says(r"\b<otherwise>\b", beside.sentence):
        return []
    near = [each for each in premises[-MOST_TOGETHER:] if each.part == beside.part and each.place < beside.place]
    near = [each for each in near if each.place == above or not each.special]
    slopes = {(*of, each.place): each for each in near if (of := _slope_of(each.left)) is not None}
    functions = _named(match["of"] or "", {function for function, *_ in slopes})
    variables = _named(match["by"] or "", {variable for _, variable, _ in slopes})
    slopes = {key: each for key, each in slopes.items() if key[0] in functions and key[1] in variables}
    last = max((place for *_, place in slopes), default=0)
    lead = beside.before.partition(match[0])[0]
    if _ELSEWHERE.search(beside.sentence.partition(match[0])[0]) or _ITSELF.search(lead):
        return []
    what = match["what"] or match["zero"]
    if _PRONOUN.match(what) and not (_LEADS.fullmatch(lead) and above == last):
        return []
    before = {symbol for each in near for symbol in each.symbols}
    best = {_AT_BEST.sub("", _bare(each)): each for each in letters if each not in before}
    best = {bare: each for bare, each in best.items() if variables & {bare, ""}}
    several = _SEVERAL.fullmatch(what.rpartition(" ")[2]) is not None
    kept = [each for each in slopes.values() if several or each.place == last]
    if not kept and match["of"] and match["by"]:
        return _of_words(beside, match["of"], match["by"], match[0])
    accented = {
        letter_of(one): letter_of(best[_bare(one)]) for each in kept for one in each.symbols if _bare(one) in best
    }
    return [replace(each, left=put_in(each.right, accented), right=ZERO) for each in kept]


def derives(tree: Formula) -> bool:
    r"""Whether a formula is a first derivative, but by time, as ``\frac{\partial S}{\partial a}`` and ``\nabla f``."""
    function, letter = _slope_of(tree) or ("", "t")
    return letter != "t" and not function.startswith(DOT)


def _of_words(beside: Beside, of: str, by: str, words: str) -> list[Premise]:
    """Return that the derivatives of a function by some letters are zero, where words name all of them."""
    functions, variables = (map(_bare, re.findall(_FORMULA, said)) for said in (of, by))
    given = f'the words "{words}"', beside.part, beside.place, frozenset[str](), False, beside.words
    return [
        Premise(Tree("opaque", [Token("OPAQUE", quotient(PARTIAL, one, other))]), ZERO, *given, False, ANYWHERE)
        for one, other in product(functions, variables)
    ]


def _named(said: str, known: set[str]) -> set[str]:
    """Return those of some letters that words may name: of several, only what stands there as a formula."""
    formulas = {*map(_bare, re.findall(_FORMULA, said))}
    return known & formulas if formulas else known if not said or len(known) == 1 else set()


def _slope_of(tree: Formula) -> tuple[str, str] | None:
    """Return the bare function and letter of a first derivative, empty if not said; None for no derivative."""
    slope = derivative_in(str(tree.children[0])) if tree.data == "opaque" else None
    if slope is not None and slope.is_first and slope.head:
        return slope.head, slope.variable
    operator, function = tree.children if tree.data == "run" and len(tree.children) == 2 else (None, None)
    if isinstance(operator, Tree) and operator.data == "symbol" and isinstance(function, Tree):
        match = _NABLA.fullmatch(str(operator.children[0]))
        return (_bare(symbols_in(function)[0]), _bare(match[1] or "")) if match and symbols_in(function) else None
    return None


def _bare(symbol: str) -> str:
    return re.sub(r"[${}\s]", "", symbol)
