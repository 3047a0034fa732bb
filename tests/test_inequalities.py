"""Relations other than equality: verdicts of a corpus, and mutations of which none that is false may be proved."""

import copy
import itertools
import json
import random
import re
from pathlib import Path

import mpmath
import pytest
import sympy
from test_real_functions import FUNCTIONS, record, rejected

from algebroproj_sym import prove
from algebroproj_sym.proving.reals import decided
from algebroproj_sym.replaying.reals import require_real
from algebroproj_sym.replaying.reals.statement import statement_of
from algebroproj_sym.replaying.reals.terms import written

CORPUS = Path(__file__).resolve().parent / "corpus" / "inequalities.json"
ITEMS = json.loads(CORPUS.read_text(encoding="utf-8"))
STATED = [item for item in ITEMS if item["expected"] == "proved"]
TRUE = [item for item in STATED if "found" not in item]
FALSE = [item for item in ITEMS if item["expected"] == "refuted"]
QUICK = TRUE[::6]


def question(item, **changes):
    return record(item, **{"relation": item["relation"], **changes})


def names(items):
    return [item["name"] for item in items]


def checked(item):
    found = decided(question(item))
    assert found["verdict"] == item.get("found", item["expected"])
    if found["verdict"] != "open":
        require_real(json.loads(json.dumps(found)))
    return found


@pytest.mark.parametrize("item", QUICK, ids=names(QUICK))
def test_what_is_true_is_proved_and_replayed(item):
    checked(item)


@pytest.mark.parametrize("item", FALSE[::3], ids=names(FALSE[::3]))
def test_what_is_false_is_refuted_at_a_point_that_is_replayed(item):
    checked(item)


@pytest.mark.whole
@pytest.mark.parametrize("item", ITEMS, ids=names(ITEMS))
def test_every_verdict_is_the_declared_one_or_open_where_that_is_listed(item):
    checked(item)


def test_few_of_what_is_true_stay_open():
    assert len(STATED) >= 140
    assert len(FALSE) >= 100
    assert len(TRUE) >= 0.8 * len(STATED)


# -- an oracle of its own: values of mpmath, also at points where both sides may be equal ------------------------------

SPECIAL = ["0", "1", "-1", "1/2", "-1/2", "2", "3", "4", "1/10", "9", "pi/6", "pi/4", "pi/3", "pi/2", "-pi/2", "pi", "2*pi"]
SPECIAL += ["5*pi/4", "29/50", "159/100", "exp(1)", "sqrt(2)", "-9/10", "11/10", "1/100", "-1/100", "100"]


def value(text, point):
    code = re.sub(r"(?<!\w)[0-9]+", lambda found: f"mpf({found[0]})", text)
    return eval(code, {"__builtins__": {}, "mpf": mpmath.mpf, **FUNCTIONS, **point})


def points(symbols):
    """Yield points: of special numbers, and at random, also close together."""
    special = [value(text, {}) for text in SPECIAL]
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
    """Whether a relation fails at a point where the conditions hold, by ordinary evaluation with 40 digits."""
    relation, goal = statement.goal
    with mpmath.workdps(40):
        for point in points(sorted(statement.symbols())):
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


@pytest.mark.parametrize("item", STATED, ids=names(STATED))
def test_the_oracle_agrees_with_what_is_true(item):
    assert not fails_somewhere(statement_of(question(item)))


def test_the_oracle_sees_what_is_false():
    seen = [fails_somewhere(statement_of(question(item))) for item in FALSE]
    assert sum(seen) > 0.95 * len(seen)


# -- mutations --------------------------------------------------------------------------------------------------------


def mutations(item):
    """Yield an item with an assumption dropped or widened, with a strict relation, and with a coefficient changed."""
    given = item.get("assumptions", [])
    for place, condition in enumerate(given):
        others = given[:place] + given[place + 1 :]
        yield question(item, assumptions=others)
        for old, new in ((">= ", "> -1 + "), ("> ", "> -1 + "), ("<= ", "< 1 + "), ("< ", "< 1 + "), ("< ", "<= ")):
            if old in condition:
                yield question(item, assumptions=[*others, condition.replace(old, new, 1)])
        if re.match(r"[^<>]+<", condition) and condition.count("<") == 2:
            yield question(item, assumptions=[*others, f"-1 + {condition}"])
            yield question(item, assumptions=[*others, condition.replace("<", "<=", 1)])
        if "> 0" in condition:
            yield question(item, assumptions=[*others, condition.replace("> 0", ">= 0")])
    strict = {"<=": "<", ">=": ">"}
    if item["relation"] in strict:
        yield question(item, relation=strict[item["relation"]])
    for side in ("lhs", "rhs"):
        for found in re.finditer(r"(?<![\w^.])[0-9]+(?!\w)", item[side]):
            for factor in ("9/10", "11/10"):
                changed = f"{item[side][: found.start()]}({found[0]}*{factor}){item[side][found.end() :]}"
                yield question(item, **{side: changed})
    for factor in ("19/20", "21/20"):
        yield question(item, rhs=f"({item['rhs']})*{factor}")


MUTATED = [(item["name"], mutated) for item in STATED for mutated in mutations(item)]
SOME = MUTATED[::25]


def judge_mutation(mutated):
    found = decided(mutated)
    if found["verdict"] == "proved":
        assert not fails_somewhere(statement_of(mutated)), mutated
    if found["verdict"] != "open":
        require_real(found)
    return found["verdict"]


@pytest.mark.parametrize("mutated", [m for _, m in SOME], ids=[f"{place}: {name}" for place, (name, _) in enumerate(SOME)])
def test_a_mutation_that_is_false_is_not_proved(mutated):
    judge_mutation(mutated)


@pytest.mark.whole
def test_no_mutation_that_is_false_is_proved():
    verdicts = [judge_mutation(mutated) for _, mutated in MUTATED]
    assert verdicts.count("refuted") > len(verdicts) / 3
