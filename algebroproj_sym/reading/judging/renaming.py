"""Which letters words give another meaning from there on: "from here on $b$ is half of it", "$k$ is used for"."""

import re

from algebroproj_sym.reading.defining.phrases import symbols_in_list

_IS = r"(?:is|are|denotes?|stands?|means?|becomes?|represents?|will)\b"
_RENAMES = re.compile(
    r"\b(?:from (?:here|now|this point)(?: on(?:wards?)?)?|henceforth|hereafter|below|in what follows|"
    rf"in the following|now)\b,?[^.$]{{0,30}}\$([^$=]*)\$\s*(?:now\s+)?{_IS}"
    r"|\bin this (?:section|chapter|appendix)\b,?[^.$]{0,30}\$([^$=]*)\$\s*(?:denotes?|stands? for|is the)\b"
    r"|\b(?:in|for|throughout) the (?:second|third|next|following|other|last|remaining|rest|remainder)\b[^.$]{0,40}"
    rf"\$([^$=]*)\$\s*(?:now )?{_IS}"
    r"|\$([^$=]*)\$ (?:now )?has (?:an?other|a new|a different|its own) meaning"
    r"|\$([^$=]*)\$ (?:is|are) (?:now |then |here |also |again |instead )?(?:re-?)?used (?:for|as|to denote)\b"
    r"|\b(?:for|as) which \$([^$=]*)\$ (?:now )?stands"
    r"|\b(?:if|when|instead|now)\b,? (?:\w+ ){0,2}(?:measure|count|express|give) \$([^$=]*)\$ in \w+"
    r"|\b(?:also|again|likewise|too|still) (?:called|denoted|named|written|labell?ed|known) "
    r"(?:by |as |with )?\$([^$=]*)\$"
    r"|\b(?:also|again|likewise|still) (?:denote|call|write|name|label)s? (?:the|an?|its|this|that|it)\b"
    r"[^.$]*\$([^$=]*)\$"
    r"|\babuse of notation\b[^.$]*\$([^$=]*)\$"
    r"|\bwrite \$([^$=]*)\$ for \$"
    r"|\b(?:write|use) (?:again |now |once more |the (?:letter|symbol) )?\$([^$=]*)\$ "
    r"(?:again |now |also )?(?:for|as|to denote) (?:the|an?|its)\b"
    r"|\b(?:re-?defin\w+|re-?us(?:e|ing)) (?:the (?:letter|symbol) )?\$([^$=]*)\$|\bnow let \$([^$=]*)=[^$]*\$",
    re.IGNORECASE,
)
_SAME_LETTER = re.compile(
    r"\b(?:the|its) same (?:letter|symbol|name) (?:now |also |again |then |here )?"
    r"(?:denotes?|stands?|means?|is|will|for)\b"
    r"|\b(?:keep|retain|reus)\w* (?:its|the|their|this|the same|the old) (?:names?|letters?|symbols?|notation)\b",
    re.IGNORECASE,
)


def renamed_in(words: str) -> frozenset[str]:
    """Return the letters that words give another meaning.

    Examples
    --------
    >>> [sorted(renamed_in(each)) for each in ("Its error is also called $h$.", "From here on $b$ is half of it.")]
    [['h'], ['b']]
    """
    found = [each for match in _RENAMES.finditer(" ".join(words.split())) for each in match.groups() if each]
    return frozenset(symbol for each in found for symbol in symbols_in_list(each))


def gives_its_name_away(words: str) -> bool:
    """Whether words between two displays say that another thing has the letter of the first one, and do not name it.

    Examples
    --------
    >>> gives_its_name_away("The same letter denotes its estimate."), gives_its_name_away("It has the same value.")
    (True, False)
    """
    return _SAME_LETTER.search(words) is not None
