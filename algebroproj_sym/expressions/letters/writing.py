"""Terms as text, which `parse_letters` reads."""

from fractions import Fraction

from algebroproj_sym.expressions.letters.terms import FUNCTIONS, Term

_SUM, _PRODUCT, _POWER, _ATOM = range(4)


def letters_text(term: Term) -> str:
    """Return a term as text.

    Examples
    --------
    >>> from algebroproj_sym.expressions.letters.parsing import parse_letters
    >>> letters_text(parse_letters("(A+B) .T*(x - A[0, 1] *x)**-1", {"A": (2, 2), "B": (2, 2)}))
    '(A + B).T*(x - A[0, 1]*x)**-1'
    """
    return _written(term)[0]


def _written(term: Term) -> tuple[str, int]:
    kind, parts, value = term.kind, term.parts, term.value
    if kind == "number":
        whole = value >= 0 and value.denominator == 1
        return str(value), _ATOM if whole else _PRODUCT if value > 0 else _SUM
    if kind in ("symbol", "letter"):
        return str(value), _ATOM
    if kind == "sum":
        first, *others = map(_signed, parts)
        start = f"-{first[1]}" if first[0] else first[1]
        return start + "".join(f" {'-' if minus else '+'} {text}" for minus, text in others), _SUM
    if kind == "product":
        minus, text = _signed(term)
        return (f"-{text}", _SUM) if minus else (text, _PRODUCT)
    if kind == "power":
        return f"{_inside(parts[0], _ATOM)}**{value}", _POWER
    if kind == "transpose":
        text, level = _written(parts[0])
        return (f"{text}.T", level) if level >= _POWER else (f"({text}).T", _ATOM)
    if kind == "entry":
        return f"{_inside(parts[0], _ATOM)}[{value[0]}, {value[1]}]", _ATOM
    if kind == "block":
        texts, width = [letters_text(part) for part in parts], value[0]
        rows = (", ".join(texts[k : k + width]) for k in range(0, len(texts), width))
        return f"block({', '.join(f'[{row}]' for row in rows)})", _ATOM
    arguments = map(letters_text, parts) if kind in FUNCTIONS else map(str, value)
    return f"{kind}({', '.join(arguments)})", _ATOM


def _inside(term: Term, level: int) -> str:
    text, own = _written(term)
    return text if own >= level else f"({text})"


def _signed(term: Term) -> tuple[bool, str]:
    """Return whether a term of a sum is subtracted, and its text without that sign."""
    if term.kind == "number" and term.value < 0:
        return True, str(-term.value)
    if term.kind != "product":
        return False, _inside(term, _PRODUCT)
    first, *others = term.parts
    factors = [_inside(part, _POWER) for part in others]
    if first.kind != "number" or not others:
        return False, "*".join([_inside(first, _POWER), *factors])
    size: Fraction = abs(first.value)
    text = "*".join([*([] if size == 1 else [str(size) if size.denominator == 1 else f"({size})"]), *factors])
    return first.value < 0, text if len(factors) > 1 or size != 1 else _inside(others[0], _PRODUCT)
