"""Corpora of statements with real functions, and an oracle of their own: values of mpmath at many points."""

import itertools
import json
import random
import re
from pathlib import Path

import mpmath

from algebroproj_sym.proving.reals import decided
from algebroproj_sym.replaying import NotReplayable, Rejected
from algebroproj_sym.replaying.reals import require_real
from algebroproj_sym.replaying.reals.terms import written

FUNCTIONS = {
    "abs": abs, "sign": mpmath.sign,
    "atan2": lambda y, x: mpmath.atan2(y, x) if (x, y) != (0, 0) else mpmath.nan,
} | {
    name: getattr(mpmath, name)
    for name in (
        "sqrt", "exp", "log", "sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan", "asec", "acsc",
        "sinh", "cosh", "tanh", "coth", "sech", "csch", "asinh", "acosh", "atanh", "acoth", "asech", "acsch",
    )
}  # fmt: skip
SPECIAL = [
    "0", "1", "-1", "1/2", "-1/2", "2", "3", "4", "1/10", "9", "pi/6", "pi/4", "pi/3", "pi/2", "-pi/2", "pi", "2*pi",
    "5*pi/4", "29/50", "159/100", "exp(1)", "sqrt(2)", "-9/10", "11/10", "1/100", "-1/100", "20",
]  # fmt: skip


def items(name):
    """The items of a corpus."""
    return json.loads((Path(__file__).resolve().parent / "corpus" / f"{name}.json").read_text(encoding="utf-8"))


def names(items):
    return [item["name"] for item in items]


def question(item, **changes):
    """The question of an item, as the replay has it."""
    asked = {"relation": "=", "assumptions": [], "constraints": [], "nonzero": []} | item | changes
    return {key: asked[key] for key in ("lhs", "relation", "rhs", "assumptions", "constraints", "nonzero")}


def found_for(lhs, rhs, **asked):
    """What is found of a statement, as a ledger has it."""
    return json.loads(json.dumps(decided(question({"lhs": lhs, "rhs": rhs, **asked}))))


def rejected(forged):
    try:
        require_real(forged)
    except (Rejected, NotReplayable, KeyError, TypeError, ValueError, AttributeError, IndexError):
        return True
    return False


def value(text, point):
    code = re.sub(r"(?<!\w)[0-9]+", lambda found: f"mpf({found[0]})", text)
    return eval(code, {"__builtins__": {}, "mpf": mpmath.mpf, "pi": mpmath.pi, **FUNCTIONS, **point})


def points(symbols, special):
    """Yield points: of special numbers, and at random, also close together."""
    if len(symbols) <= 2:
        yield from (dict(zip(symbols, each, strict=True)) for each in itertools.product(special, repeat=len(symbols)))
    else:
        yield from (dict.fromkeys(symbols, number) for number in special)
    generator = random.Random(11)
    for _ in range(400):
        scale = generator.choice((0.01, 1, 1, 3, 10))
        shift = generator.choice((0, 0, generator.uniform(-2, 4)))
        yield {name: mpmath.mpf(generator.uniform(-scale, scale) + shift) for name in symbols}


def fails_somewhere(statement):
    """Whether a relation fails at a point where the conditions hold, by ordinary evaluation with 60 digits."""
    relation, goal = statement.goal
    with mpmath.workdps(60):
        # Next to a pole, which pi with 60 digits misses, the sides of an equation differ by rounding.
        special = [value(text, {}) for text in (SPECIAL[:3] if relation == "=" else SPECIAL)]
        for point in points(sorted(statement.symbols()), special):
            try:
                sides = [value(written(side), point) for side in (statement.left, statement.right)]
                holds = [is_so(r, value(written(term), point)) for r, term in statement.given]
                difference = value(written(goal), point)
            except (ZeroDivisionError, ValueError, OverflowError):
                continue
            if all(holds) and all(map(is_real, (*sides, difference))):
                close = abs(difference) <= 1e-30 * max(1, *map(abs, sides))
                if not is_so(relation, mpmath.mpf(0) if close else difference):
                    return True
    return False


def is_real(number):
    return not isinstance(number, mpmath.mpc) and mpmath.isfinite(number)


def is_so(relation, number):
    if not is_real(number):
        return False
    return {"=": number == 0, "!=": number != 0, ">": number > 0, ">=": number >= 0}[relation]
