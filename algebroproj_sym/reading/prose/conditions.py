"""Which equations are conditions: "A point is critical if g = 0" does not say that g is zero.

Such an equation serves its own sentence, a sentence that goes on from it, and where words cite it.
"""

from algebroproj_sym.reading.parsing.grammar import Parsed
from algebroproj_sym.reading.prose.devices import heard, says
from algebroproj_sym.reading.prose.sentences import without_formulas
from algebroproj_sym.reading.prose.words import Beside

_IF = heard(
    r"\b<if>\b(?!(?s:.*)(?:[,;:]|\b(?:then|we|one|you|gives?|yields?|becomes?|reads?|holds?|hence|so|follows)\b))"
)
"""A word of a condition, with no main clause behind it."""
_CRITERION = heard(r"\b<criterion>\b[^.]*\b(?:is|are|reads?|becomes?)\W*$")
_LATER = heard(r"[\s,$]*(?:only |just |exactly )?(?:<if>|at|in|for|on)\b")
"""How a sentence says behind an equation where it holds."""
_GOES_ON = heard(
    r"^\W*(?:and )?(?:<concludes>|so|it follows|this (?:gives|yields|implies|means))\b|\b(?:<goes-on>|then)\b"
)


def is_condition(beside: Beside, formula: Parsed) -> bool:
    """Whether an equation is the condition of which its sentence speaks, or what the sentence wishes.

    A letter that is zero is one at a place or in a case, unless words say that it is zero from there on.
    """
    sentence = without_formulas(beside.sentence)
    number = _number_of(formula)
    if _IF.search(sentence) or _CRITERION.search(sentence) or says(r"\b<wanted>(?: that)?\W*$", sentence):
        return True
    wishes = says(r"\b<sought>\W*$|\b<wanted seeks>\b", sentence) and not says(r"\b<optimizes>\W*$", sentence)
    if wishes and not any(each.data == "symbol" for each in formula.sides):
        return True
    if number == "0" and (
        _LATER.match(beside.behind)
        or not (says(r"\b<sets>\W*$|^\W*$", sentence) or says(r"\b<supposes concludes>\b", sentence))
    ):
        return True
    return bool(number) and says(r"\b<wishes>\b", sentence) and "," not in sentence


def _number_of(formula: Parsed) -> str:
    """Return the number that a letter alone is equal to; empty if there is none."""
    lone = [each for each in formula.sides if each.data == "symbol"]
    numbers = [str(each.children[0]) for each in formula.sides if each.data == "number"]
    return numbers[0] if len(formula.sides) == 2 and lone and numbers else ""


def goes_on(beside: Beside) -> bool:
    """Whether a sentence goes on from the condition of the one before it: "Then", "In this case"."""
    return _GOES_ON.search(without_formulas(beside.sentence)) is not None
