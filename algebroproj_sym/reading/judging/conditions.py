"""Which equations are conditions: "A point is critical if g = 0" does not say that g is zero.

Such an equation serves its own sentence, a sentence that goes on from it, and where words cite it.
"""

import re

from algebroproj_sym.reading.judging.sentences import without_formulas
from algebroproj_sym.reading.judging.words import Beside
from algebroproj_sym.reading.parsing.grammar import Parsed

_IF = re.compile(
    r"\b(?:if|iff|when|whenever|unless|whether|until|as long as|in case|provided(?! by))\b"
    r"(?!.*(?:[,;:]|\b(?:then|we|one|you|gives?|yields?|becomes?|reads?|holds?|hence|so|follows)\b))",
    re.IGNORECASE | re.DOTALL,
)
"""A word of a condition, with no main clause behind it."""
_WISHED = re.compile(
    r"\b(?:if|when|whenever|unless|whether|provided|satisf(?:y|ies|ying)|requir(?:es?|ed|ing)|goals?|aims?|objectives?|"
    r"subject to|solv(?:e|es|ing)|tests?|special case)\b",
    re.IGNORECASE,
)
"""Words of a condition or of a wish, where a letter alone is a number."""
_WANTED = re.compile(r"\b(?:we|you|one) (?:want|wish|demand|would like)(?: that)?\W*$", re.IGNORECASE)
_SOUGHT = re.compile(
    r"\bwhether\W*$|\b(?:(?:question|aim|goal) is|subject to|(?:roots|zeros|zeroes) of|points (?:with|where))\W*$"
    r"|\b(?:we|you|one) (?:want|wish|would like|seek|look for|search for)\b"
    r"|\b(?:exists?|find|seek|there (?:is|are)) (?:an? |some )?[^.;]*\bsuch that\W*$"
    r"|\bsome \w+ (?:satisfy|have|obey|fulfil)\W*$",
    re.IGNORECASE,
)
"""How a sentence ends before an equation that it wishes, or of which only some points are said to have it."""
_CRITERION = re.compile(
    r"(?:\b(?:criteri(?:on|a)|tests?|requirements?)\b|"
    r"\bconditions? (?:of|for|that|under which)\b(?![^.]*\b(?:minim|maxim|extrem|optim|station)))"
    r"[^.]*\b(?:is|are|reads?|becomes?)\W*$",
    re.IGNORECASE,
)
"""Words that name a condition, and what it is one of: "The criterion of rest is"."""
_SAYS = re.compile(
    r"\b(?:suppos\w+|assum\w+|let|set|setting|tak\w+|choos\w+|put|fix|impos\w+|have|has|hence|thus|therefore|so|then|"
    r"giv\w+|yield\w*|obtain\w*|get|follows|since|because|as|is|are|becomes?|vanish\w*|reads?|equals?|write|denote\w*|"
    r"conclude|recall|implies|from|where|initial\w*|and)\W*$|^\W*$",
    re.IGNORECASE,
)
_SUPPOSES = re.compile(r"\b(?:suppos\w+|assum\w+|let|hence|thus|therefore|consequently)\b", re.IGNORECASE)
"""The last word before an equation by which a letter is zero from there on; or there are none."""
_LATER = re.compile(
    r"[\s,$]*(?:only |just |exactly )?(?:if|when|whenever|unless|iff|at|in|for|on|as long as)\b", re.IGNORECASE
)
"""How a sentence says behind an equation where it holds."""
_GOES_ON = re.compile(
    r"^\W*(?:and )?(?:hence|thus|therefore|so|consequently|it follows|this (?:gives|yields|implies|means))\b"
    r"|\b(?:then|if so|(?:in|at|under|for|on) (?:this|that|these|those|such|which)(?: an?)?"
    r" (?:cases?|points?|conditions?|situations?|states?|events?))\b",
    re.IGNORECASE,
)
"""How a sentence goes on from the condition of the one before it."""


def is_condition(beside: Beside, formula: Parsed) -> bool:
    """Whether an equation is the condition of which its sentence speaks, or what the sentence wishes.

    A letter that is zero is one at a place or in a case, unless words say that it is zero from there on.
    """
    sentence = without_formulas(beside.sentence)
    number = _number_of(formula)
    if _IF.search(sentence) or _CRITERION.search(sentence) or _WANTED.search(sentence):
        return True
    if _SOUGHT.search(sentence) and not any(each.data == "symbol" for each in formula.sides):
        return True
    if number == "0" and (_LATER.match(beside.behind) or not (_SAYS.search(sentence) or _SUPPOSES.search(sentence))):
        return True
    return bool(number) and _WISHED.search(sentence) is not None and "," not in sentence


def _number_of(formula: Parsed) -> str:
    """Return the number that a letter alone is equal to; empty if there is none."""
    lone = [each for each in formula.sides if each.data == "symbol"]
    numbers = [str(each.children[0]) for each in formula.sides if each.data == "number"]
    return numbers[0] if len(formula.sides) == 2 and lone and numbers else ""


def goes_on(beside: Beside) -> bool:
    """Whether a sentence goes on from the condition of the one before it: "Then", "In this case"."""
    return _GOES_ON.search(without_formulas(beside.sentence)) is not None
