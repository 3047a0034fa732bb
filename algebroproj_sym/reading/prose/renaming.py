"""Which letters words give another meaning from there on: "from here on $b$ is half of it", "$k$ is used for"."""

from algebroproj_sym.reading.prose.devices import heard
from algebroproj_sym.reading.prose.phrases import symbols_in_list

_RENAMES = heard(r"\b<renames>|\$([^$=]*)\$ <renames-behind>")


def renamed_in(words: str) -> frozenset[str]:
    """Return the letters that words give another meaning.

    Examples
    --------
    >>> [sorted(renamed_in(each)) for each in ("Its error is also called $h$.", "From here on $b$ is half of it.")]
    [['h'], ['b']]
    """
    found = [each for match in _RENAMES.finditer(" ".join(words.split())) for each in match.groups() if each]
    return frozenset(symbol for each in found for symbol in symbols_in_list(each))
