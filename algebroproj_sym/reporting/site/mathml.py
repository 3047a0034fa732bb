"""LaTeX as presentation MathML, of the core that browsers draw without a script."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Literal, TypeAlias

from markupsafe import Markup

Style: TypeAlias = Literal["block", "large", "inline"]

_ATTRIBUTES = {"block": 'display="block"', "large": 'displaystyle="true"', "inline": 'display="inline"'}
_OPENING = re.compile(r"<math[^>]*>")
_ROW_OF_ONE = re.compile(r"<mrow>(<m([ino])[^>]*>[^<]*</m\2>)</mrow>")


@lru_cache(maxsize=4096)
def math(formula: str, style: Style = "large") -> Markup:
    r"""Return a formula that is written in LaTeX as MathML.

    Parameters
    ----------
    formula : str
        LaTeX.
    style : {"block", "large", "inline"}
        A block of its own; in a line, but as large as in a block; as small as the text around it.

    Examples
    --------
    >>> print(math("u_{31}"))
    <math displaystyle="true"><mrow><msub><mi>u</mi><mn>31</mn></msub></mrow></math>
    """
    from latex2mathml.converter import convert

    opened = _OPENING.sub(f"<math {_ATTRIBUTES[style]}>", convert(formula), count=1)
    return Markup(_ROW_OF_ONE.sub(r"\1", opened))
