r"""Which letters words call whole numbers, and whether a capital gamma is the gamma function."""

import re

from algebroproj_sym.reading.prose.describing import described
from algebroproj_sym.reading.prose.devices import heard, says
from algebroproj_sym.reading.prose.phrases import symbols_in_list
from algebroproj_sym.reading.prose.sentences import sentences_of

_LETTERS = r"(?:\$[^$]*\$(?:, ?and |, ?| and )?)+"
_BEFORE = heard(
    r"(?:^|[.,;:(]|\b(?:let|for|where|with|and|given|take|choose|pick|fix|consider)) ?"
    rf"(?:(?!no\b)<of-integers> )*<integers> ({_LETTERS})"
)
_BEHIND = heard(
    rf"({_LETTERS}) ?(?:is|are|be|denotes?|being) (?:<of-integers> )*<integers>"
    r"(?= ?(?:[.,;:)]|and\b|with\b|greater\b|$))"
)
_MEMBER = re.compile(
    r"\$([^$]*?)\\in ?\\(?:mathbb|mathbf|Bbb) ?\{? ?[ZN] ?\}? ?(?:_ ?\{?[^{}$]{0,8}[0+1] ?\}?|\^ ?\{?[*+]\}?)? ?\$"
)
_OF_NUMBERS = heard(r"<integers>|\\in\b|\b(?:real|complex|rational|continuous|fraction\w*)\b")
_DOUBTS = heard(r"\b<if doubts no unlike wants>\b")
_GAMMA = re.compile(r"\\Gamma *(?:\\left *)?\([^()$]*\)")


def wholes_in(text: str) -> frozenset[str]:
    r"""Return the letters that are said to be whole numbers, and nothing else in another sentence.

    Examples
    --------
    >>> sorted(wholes_in(r"Let $n \in \mathbb{Z}$. For integers $k$ and $m$"))
    ['k', 'm', 'n']
    >>> sorted(wholes_in(r"For non-integer $s$. If $n$ is an integer. Let $k \in \mathbb{N}$. The wave number $k$"))
    []
    """
    said, others = set[str](), set[str]()
    for sentence in sentences_of(text):
        whole = set[str]()
        for pattern in (_BEFORE, _BEHIND, _MEMBER):
            for letters in pattern.findall(sentence):
                formulas = letters.split("$")[1::2] or [letters]
                whole |= {symbol for each in formulas for symbol in symbols_in_list(each)}
        whole = set() if _DOUBTS.search(sentence) else whole
        formulas = [re.split(r"\\(?:not)?in\b|=", each)[0] for each in re.findall(r"\$([^$]*)\$", sentence)]
        named = {symbol for symbol, nouns in described(sentence) if nouns}
        if _OF_NUMBERS.search(sentence):
            named |= {symbol for each in formulas for symbol in symbols_in_list(each)}
        said |= whole
        others |= named - whole
    return frozenset() if says(r"\b<same-letter letters-change>", text) else frozenset(said - others)


def has_gamma_function(text: str) -> bool:
    r"""Whether a text speaks of the gamma function, and calls the letter nothing else.

    Examples
    --------
    >>> has_gamma_function("By the gamma function"), has_gamma_function("the incomplete gamma function")
    (True, False)
    """
    named = [nouns for symbol, nouns in described(_GAMMA.sub(r"\\Gamma", text)) if symbol == r"\Gamma" and nouns]
    return says("<gamma>", text) and not says("<other-gamma>", text) and all("gamma" in nouns for nouns in named)
