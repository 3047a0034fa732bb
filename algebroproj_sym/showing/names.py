"""The parts of the name of a symbol: base letter, star, primes and indices.

In the derivations a symbol is spelled in ASCII: ``up31`` is u'_31, ``upp31`` is u''_31, ``mu1`` is μ_1, ``ps00`` is
p*_00.  Everything that shows mathematics asks here.
"""

import re
from dataclasses import dataclass
from functools import cache

_WORDS = (
    "alpha beta gamma delta eps epsilon zeta eta theta kappa lam lambda mu nu xi rho sigma tau phi chi psi omega "
    "Gamma Delta Theta Lambda Sigma Phi Psi Omega"
)
GREEK = dict(zip(_WORDS.split(), "αβγδεεζηθκλλμνξρστφχψωΓΔΘΛΣΦΨΩ", strict=True))
"""Greek letters by their English names, some of which are short."""
_LATEX = {"eps": "varepsilon", "epsilon": "varepsilon", "lam": "lambda", "phi": "varphi"}
_GREEK = "|".join(sorted(GREEK, key=len, reverse=True))
_NAME = re.compile(rf"({_GREEK}|[A-Za-z])(s(?=p{{0,2}}\d))?(p{{1,2}}(?=[\dN_]|$))?_?(.*?)((?<=\d)p{{1,2}})?")
_WORD = re.compile("[a-z]{3,}")
_DIFFERENTIAL = re.compile(rf"d((?:{_GREEK}|[xy])p{{0,2}})")
_PRIMED = re.compile(rf"(?:{_GREEK}|[xy])p{{1,2}}")


@dataclass(frozen=True)
class Name:
    """The parts of a symbol's name.

    The base is a letter, or the English name of a Greek one. The index has digits and letters, or such a name.
    """

    base: str
    star: bool
    primes: int
    index: str


@cache
def parts(name: str) -> Name:
    """Return the parts of a symbol's name.

    Examples
    --------
    >>> parts("up31")
    Name(base='u', star=False, primes=1, index='31')
    >>> parts("weighted").base
    'weighted'
    >>> parts("muN1").base, parts("pspp00").primes, parts("y0_3").index, parts("c_phi").index
    ('mu', 2, '0,3', 'phi')
    """
    match = _NAME.fullmatch(name)
    if match is None:
        return Name(name, False, 0, "")
    base, star, before, index, after = match.groups()
    if _WORD.fullmatch(index) and not _PRIMED.fullmatch(index) and not name.startswith(f"{base}_"):
        return Name(name, False, 0, "")
    return Name(base, star is not None, len(before or "") + len(after or ""), index.replace("_", ","))


def latex_name(name: str) -> str:
    r"""Return the name of a symbol as LaTeX.

    Examples
    --------
    >>> print(latex_name("up31"), latex_name("mu"), latex_name("x"), latex_name("ps00"))
    u^{\prime}_{31} \mu x p^{*}_{00}
    >>> print(latex_name("dphip"), latex_name("s_kappa"), latex_name("s_phipp"))
    d\varphi^{\prime} s_{\kappa} s_{\varphi^{\prime\prime}}
    """
    if differential := _DIFFERENTIAL.fullmatch(name):
        return f"d{latex_name(differential[1])}"
    read = parts(name)
    marks = "*" * read.star + r"\prime" * read.primes
    above = f"^{{{marks}}}" if marks else ""
    index = latex_name(read.index) if _PRIMED.fullmatch(read.index) else _latex_letter(read.index)
    below = f"_{{{index}}}" if read.index else ""
    return f"{_latex_letter(read.base)}{above}{below}"


def plain_name(name: str) -> str:
    """Return the name of a symbol as a line of text.

    Examples
    --------
    >>> plain_name("upp31"), plain_name("mup1"), plain_name("c_phi")
    ("u''31", "μ'1", 'cφ')
    """
    read = parts(name)
    star = "*" if read.star else ""
    return f"{letter(read.base)}{star}{read.primes * chr(39)}{letter(read.index)}"


def letter(word: str) -> str:
    """Return a Greek letter for its English name, and any other word as it is."""
    return GREEK.get(word, word)


def _latex_letter(word: str) -> str:
    if word in GREEK:
        return f"\\{_LATEX.get(word, word)}"
    return rf"\mathrm{{{word}}}" if _WORD.fullmatch(word) else word
