"""LaTeX as presentation MathML, of the core that browsers draw without a script."""

import re
from functools import lru_cache
from typing import Literal, TypeAlias

from markupsafe import Markup

Style: TypeAlias = Literal["block", "large", "inline"]

_ATTRIBUTES = {"block": ' display="block"', "large": ' displaystyle="true"', "inline": ""}
_AROUND_ALL = re.compile(r"<math[^>]*><mrow>(.*)</mrow></math>", re.DOTALL)
_AS_BY_DEFAULT = re.compile(r' stretchy="true" fence="true" form="\w+"')
_CODE = re.compile("&#x0(?!0026|003C|003E)([0-9A-F]{4});")
_AROUND_TABLE = re.compile(r"<mrow>(?=<mo>([\[|])</mo><mtable)")
_CLASSES = {"[": "matrix", "|": "determinant"}
_PRIMES = re.compile("<mrow>((?:<mi>′</mi>){2,3})</mrow>|<mi>([′″‴])</mi>")
_ROW_OF_ONE = re.compile(r"<mrow>(<m([ino])[^>]*>[^<]*</m\2>)</mrow>")


@lru_cache(maxsize=4096)
def math(formula: str, style: Style = "large") -> Markup:
    r"""Return a formula that is written in LaTeX as MathML.

    It is a block of its own; in a line, but as large as in a block; or as small as the text around it.

    Examples
    --------
    >>> print(math("u_{31}"))
    <math displaystyle="true"><msub><mi>u</mi><mn>31</mn></msub></math>
    """
    from latex2mathml.converter import convert

    written = _AROUND_ALL.sub(rf"<math{_ATTRIBUTES[style]}>\1</math>", convert(formula))
    written = _CODE.sub(lambda found: chr(int(found[1], 16)), _AS_BY_DEFAULT.sub("", written))
    written = _PRIMES.sub(lambda found: f"<mo>{found[2] or '″‴'[found[1].count('′') - 2]}</mo>", written)
    written = _AROUND_TABLE.sub(lambda found: f'<mrow class="{_CLASSES[found[1]]}">', written)
    return Markup(_ROW_OF_ONE.sub(r"\1", written))
