"""Forged evidence: each family of forgeries is rejected, and the honest entry beside each forgery replays.

A family yields pairs of an honest and a forged record.  The statements of forgeries are false, or their evidence shows
less than it says; why each is wrong can be seen from how it is made, without the replay.
"""

import contextlib
import copy
import itertools
import json
from fractions import Fraction

import pytest
from cases import for_each
from hypothesis import given, settings
from hypothesis import strategies as st

from algebroproj_sym.replaying import Rejected, declaration_digest, polynomial, replay, replay_claim, replay_identity

AT_LEAST = 20


def entry(kind, printed, derived, certificate, verdict="proved", **changes):
    """A claim of a ledger, bound to its declaration."""
    record = {
        "paper": "demo", "number": "1.1", "section": "1", "title": "", "kind": kind, "expected": verdict,
        "printed": printed, "derived": derived, "corrected": None, "where": {}, "setting": {}, "instead": None,
        "note": "", "quote": None, "verdict": verdict, "hypotheses": certificate.get("denominators", []),
        "counterexample": None, "certificate": certificate, "engine": "flint",
    } | changes  # fmt: skip
    return {"declaration": declaration_digest(record), **record}


def equal(printed, derived, *hypotheses, **changes):
    certificate = {"method": "normal form", "denominators": [*hypotheses]}
    return entry("identity", printed, derived, certificate, **changes)


def end(*cofactors, multiplier="1", exponent=1):
    """The end of a proof, with a cofactor for each of the first things that are zero."""
    named = {str(place): cofactor for place, cofactor in enumerate(cofactors)}
    return {"exponent": exponent, "multiplier": multiplier, "cofactors": named}


def member(
    printed, derived, constraint, cofactor, witness, *hypotheses, nonzero=(), generator=None, claim=None, **changes
):
    certificate = {
        "method": "ideal membership", "denominators": [*hypotheses], "claims": [claim or f"{printed} - ({derived})"],
        "generators": [generator or constraint], "units": [*hypotheses, *nonzero], "entries": [end(cofactor)],
        "witness": witness,
    }  # fmt: skip
    setting = {"constraints": [constraint]} | ({"nonzero": [*nonzero]} if nonzero else {})
    return entry("identity under constraints", printed, derived, certificate, setting=setting, **changes)


def answer(lhs, rhs, certificate, verdict="proved", constraints=(), nonzero=(), counterexample=None):
    """An identity from elsewhere."""
    return {
        "file": "mine.json", "name": "mine", "lhs": lhs, "rhs": rhs, "constraints": [*constraints],
        "nonzero": [*nonzero], "verdict": verdict, "expected": None, "method": certificate["method"], "reason": None,
        "hypotheses": certificate.get("denominators", []), "counterexample": counterexample, "certificate": certificate,
    }  # fmt: skip


def following(lhs, rhs, constraint, claim, part, witness, units=(), nonzero=(), **more):
    """An identity from elsewhere that follows from one constraint."""
    certificate = {
        "method": "ideal membership", "denominators": [], "claims": [claim], "generators": [constraint],
        "units": [*units], "entries": [part], "witness": witness, **more,
    }  # fmt: skip
    return answer(lhs, rhs, certificate, constraints=[constraint], nonzero=nonzero)


def changed(record, value, *path):
    """A copy with another value at a path, as if it had been declared so."""
    copied = copy.deepcopy(record)
    at = copied
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = value
    return {**copied, "declaration": declaration_digest(copied)} if "declaration" in copied else copied


FIRST = ("certificate", "entries", 0)


def over_y(cofactor, y="2"):
    """x**2/y = 1/y follows from x**2 = 1."""
    return member("x**2/y", "1/y", "x**2 - 1", cofactor, {"x": "1", "y": y}, "y", claim="x**2 - 1")


def numbers(count=AT_LEAST):
    return range(2, 2 + count)


# Families of claims


def dividing_cofactors():
    """x = c follows from x**2 = 1 with the cofactor (x - c)/(x**2 - 1), if only cofactors could divide."""
    for c in numbers():
        honest = member("x**2", "1", "x**2 - 1", "1", {"x": "1"})
        yield honest, member("x", str(c), "x**2 - 1", f"(x - {c})/(x**2 - 1)", {"x": "1"})
        yield honest, member("x", str(c), "x**2 - 1", f"(x - {c})*(x**2 - 1)**(-1)", {"x": "1"})


def dividing_generators():
    """A generator that is the constraint only after division by something that vanishes with it."""
    for c in numbers():
        honest = member("x**2", "1", "x**2 - 1", "1", {"x": "1"})
        yield honest, changed(honest, [f"(x**2 - 1)*(x - {c})/(x - {c})"], "certificate", "generators")
        yield honest, changed(honest, f"(x - {c})/(x - {c})", *FIRST, "multiplier")


def other_languages():
    """What is no polynomial with integer coefficients, in each place where one is expected."""
    honest = changed(over_y("y"), "y", *FIRST, "multiplier")
    texts = (
        "y/1",
        "y + 0/y",
        "y*(x - 1)/(x - 1)",
        "y**1.0",
        "1.0*y",
        "y**(-1)",
        "f(y)",
        "y**x",
        "2/2*y",
        "(y,)",
        "y;0",
    )
    for text in texts:
        yield honest, changed(changed(honest, [text], "hypotheses"), [text], "certificate", "denominators")
        yield honest, changed(honest, text, *FIRST, "multiplier")
        yield honest, changed(honest, text, *FIRST, "cofactors", "0")


def hidden_hypotheses():
    """(x**2 - c**2)/(x - c) = x + c is not said to need x - c."""
    for c in numbers():
        printed, derived = f"(x**2 - {c**2})/(x - {c})", f"x + {c}"
        yield equal(printed, derived, f"x - {c}"), equal(printed, derived)
        yield equal(f"x*({c} - x)/({c} - x)", "x", f"x - {c}"), equal(f"x*({c} - x)/({c} - x)", "x")
        yield equal(f"x + 0/(y - {c})", "x", f"y - {c}"), equal(f"x + 0/(y - {c})", "x")
        yield equal(f"1/(1/(x - {c}))", f"x - {c}", f"x - {c}"), equal(f"1/(1/(x - {c}))", f"x - {c}")


def needless_hypotheses():
    """A hypothesis that nothing needs, which would make an entry say less than it shows."""
    for c in numbers():
        honest = equal("x + y", "y + x")
        yield honest, equal("x + y", "y + x", f"x - {c}")
        yield honest, equal("x + y", "y + x", f"{c}")
        yield equal("x/y", "x/y", "y"), equal("x/y", "x/y", "y", f"y - {c}")
        yield equal("x/y", "x/y", "y"), equal("x/y", "x/y", f"y*(x - {c})")


def surplus_fields():
    """`divisions`, and whatever else stands beside the forms, can neither remove nor add a division."""
    honest = equal("(x**2 - 1)/(x - 1)", "x + 1", "x - 1")
    forged = equal("(x**2 - 1)/(x - 1)", "x + 1")
    names = ("divisions", "steps", "hypothesis", "Verdict", "comment", "proof", "assumptions", "printed ")
    for name, value in itertools.product(names, ({"printed": {"steps": [], "entries": ["x + 1"]}}, None, "")):
        yield honest, {**forged, name: value}
        yield honest, {**honest, name: value}
        yield honest, changed(honest, {**honest["certificate"], name: value}, "certificate")
        yield honest, changed(honest, {name: value}, "setting")


def overflowing_exponents():
    """a**(2**k) is no b, however many bits an exponent has; nor do multiples of it meet in a quotient."""
    for k in (*range(4, 14), 15, 16, 17):
        power = f"a**{2**k}"
        yield equal(f"1/{power}", f"1/a**{2 ** (k - 1)}/a**{2 ** (k - 1)}", "a"), equal(f"1/{power}", "1/b", "a", "b")
        yield equal(f"a*{power}", f"a**{2**k + 1}"), equal(f"a*{power}", "a*b")
    for e in (404, 1000, 2047, 2048, 4095, 4096, 65535):
        left, right = (
            f"1/(b**3 + 7*b**2*a**{e + 1096} - 36*b*a**{e})",
            f"1/(b + 3*a**{e})/(b + 6*a**{e})/(b - 2*a**{e})",
        )
        divisors = [f"b + 3*a**{e}", f"b + 6*a**{e}", f"b - 2*a**{e}"]
        yield equal(right, right, *divisors), equal(left, right, *divisors)


def other_witnesses():
    """A witness off the constraints, on a hypothesis, without a coordinate, or with one too many."""
    for c in numbers():
        honest = over_y("1", str(c))
        for point in ({"x": str(c), "y": "1"}, {"x": "1", "y": "0"}, {"x": "1"}, {"x": "1", "y": "1", "z": "1"}):
            yield honest, changed(honest, point, "certificate", "witness")


def contradictory_constraints():
    """Anything follows from what nothing satisfies."""
    for c in numbers():
        honest = member("x", str(c), f"x - {c}", "1", {"x": str(c)})
        yield honest, member("x", "0", str(c), "x", {"x": "1"})
        yield honest, member("x", str(c), "x**2 + 1", f"x - {c}", {"x": "0"})
        yield honest, member(f"x/(x - {c})", f"{c}/(x - {c})", f"x - {c}", "1", {"x": str(c)}, f"x - {c}")
        yield honest, member("x", "0", "x", "1", {"x": "0"}, nonzero=["x"])


def conditions_that_never_hold():
    """What is not zero is zero."""
    for c in numbers():
        for text in ("0", "x - x", f"{c} - {c}", f"(x + {c}) - x - {c}"):
            yield equal("x", "x", setting={"nonzero": [f"x - {c}"]}), equal("x", "x", setting={"nonzero": [text]})


def other_numbers():
    """A number by which an identity is multiplied, and is not, or that is none."""
    for c in numbers():
        honest = member("x**2", "1", "x**2 - 1", "1", {"x": "1"})
        for number in ("0", "-1", str(c), True, 1, 1.0, f"1/{c}", [c], None):
            yield honest, changed(honest, number, *FIRST, "multiplier")
        yield honest, changed(honest, {"x": c}, *FIRST, "cofactors")


def factors_that_vanish():
    """Proportional sides whose pivot is zero, or that differ in an entry, or that have one alone."""
    for c in numbers():
        certificate = {"method": "normal form", "denominators": [], "pivot": 0}
        kind, printed = "identity up to scale", f"Matrix([[{c}*x], [{c}*y]])"
        honest = entry(kind, printed, "Matrix([[x], [y]])", certificate)
        yield honest, entry(kind, "Matrix([[0], [0]])", "Matrix([[x], [y]])", certificate)
        yield honest, entry(kind, printed, f"Matrix([[x], [y + {c}]])", certificate)
        yield honest, changed(honest, 1, "certificate", "pivot")
        yield honest, changed(honest, -2, "certificate", "pivot")
        yield honest, entry(kind, f"Matrix([[{c}*x]])", "Matrix([[x + y]])", certificate)
        yield honest, entry(kind, f"{c}*x", "x + y", certificate)


def other_ranks():
    """Vectors that are dependent, that are not taken to zero, or that divide by zero."""
    derived = "Matrix([[x, y, z]])"
    certificate = {
        "method": "rank at a point and kernel vectors", "point": {"x": "1", "y": "1", "z": "1"}, "rows": [0],
        "columns": [0], "minor": "1", "kernel": [],
    }  # fmt: skip
    honest = entry("rank", "1", derived, certificate)
    kernel = ["Matrix([[y], [-x], [0]])", "Matrix([[z], [0], [-x]])"]
    for c in numbers():
        for vectors in (kernel, kernel[:1] * 2, ["Matrix([[0], [0], [0]])"], [f"Matrix([[{c}], [0], [0]])/(x - x)"]):
            more = {
                "kernel": vectors,
                "kernel at": {"x": "1", "y": "1", "z": "1"},
                "kernel rows": [0, 1],
                "kernel minor": "1",
            }
            forged = entry("rank", "0", derived, certificate | more)
            yield honest, forged
        yield honest, entry("rank", str(c), derived, certificate)
        minor = {key: certificate[key] for key in ("rows", "columns", "minor")}
        higher = entry(
            "rank", "0", derived, {"method": "counterexample", "rank": 1, **minor}, "false", hypotheses=[],
            counterexample={"x": "1", "y": "1", "z": str(c)}, instead="1.2",
        )  # fmt: skip
        yield higher, changed(higher, "1", "printed")
        yield higher, changed(higher, str(c), "printed")


def limit_of(printed, derived, divisors, orders, hypotheses, verdict="proved", **more):
    certificate = {"method": "leading coefficients", "divisors": divisors, "orders": orders} | more.pop("evidence", {})
    return entry(
        "limit", printed, derived, certificate, verdict, setting={"variable": "t"}, hypotheses=hypotheses, **more
    )


def other_limits():
    """The lowest powers are others, or a coefficient that may vanish is not said not to."""
    for c in numbers():
        honest = limit_of(f"x/{c}", f"(x + t)/(t + {c})", [f"t + {c}"], [0], [])
        yield honest, changed(honest, "x", "printed")
        yield honest, changed(changed(honest, "0", "printed"), [1], "certificate", "orders")
        yield honest, changed(honest, [0, 0], "certificate", "orders")
        honest = limit_of("1", "x/(x + t)", ["x + t"], [0], ["x"])
        yield honest, changed(honest, [], "hypotheses")
        honest = limit_of("0", f"t/({c}*x + t)", [f"{c}*x + t"], [1], ["x"])
        yield honest, changed(honest, [], "hypotheses")
        honest = limit_of("x", f"x*(y - {c})/(y - {c}) + t", [f"y - {c}"], [0], [f"y - {c}"])
        yield honest, changed(honest, [], "hypotheses")
        yield honest, changed(honest, [f"y - {c}", "x"], "hypotheses")
        evidence = {"method": "counterexample", "left": ["0"], "right": ["1"]}
        honest = limit_of(
            "0",
            "x/(x + t)",
            ["x + t"],
            [0],
            [],
            "false",
            evidence=evidence,
            instead="1.2",
            counterexample={"x": str(c)},
        )
        yield honest, changed(honest, {"x": "0"}, "counterexample")
        yield honest, changed(honest, "Matrix([[0]])", "printed")


def other_zeros():
    """A factor that is left out, excluded without reason, or counted with content zero."""
    for c in numbers():
        certificate = {
            "method": "factorisation", "content": "1", "factors": [[f"x - {c}", 1], ["y", 1]], "denominator": [],
            "printed": [[["y", 1]], [[f"x - {c}", 1]]], "excluded": [],
        }  # fmt: skip
        honest = entry("vanishing", f"(y, x - {c})", f"(x - {c})*y", certificate, hypotheses=[])
        yield honest, changed(changed(honest, "(y,)", "printed"), [[["y", 1]]], "certificate", "printed")
        less = changed(changed(honest, "(y,)", "printed"), [[["y", 1]]], "certificate", "printed")
        yield honest, changed(less, [f"x - {c}"], "certificate", "excluded")
        yield honest, changed(honest, "0", "certificate", "content")
        yield honest, changed(honest, [[f"x - {c}", 2], ["y", 1]], "certificate", "factors")


def several_components():
    """Sides that are proportional on one component of the constraints, and not on another."""
    for c in numbers():
        constraint = f"x*(x - {c})"
        certificate = {
            "method": "ideal membership", "denominators": [], "generators": [constraint], "units": [], "pivot": 1,
            "nonzero at": {"x": str(c)}, "witness": {"x": str(c)},
        }  # fmt: skip
        kind, setting = "identity up to scale", {"constraints": [constraint]}
        right = {"claims": ["0", f"x*{constraint}", constraint], "entries": [end(), end("x"), end("1")]}
        honest = entry(
            kind, f"Matrix([[x, 1, 1 + {constraint}]])", "Matrix([[x, 1, 1]])", {**certificate, **right},
            setting=setting,
        )  # fmt: skip
        wrong = {"claims": ["0", constraint, f"x - {c}"], "entries": [end(), end("1"), end("1")]}
        wrong = {**certificate, **wrong}
        forged = entry(kind, f"Matrix([[x, 1, {c + 1} - x]])", "Matrix([[x, 1, 1]])", wrong, setting=setting)
        yield honest, forged
        multiplied = changed(forged, "x", "certificate", "entries", 2, "multiplier")
        yield honest, multiplied
        yield honest, changed(multiplied, 0, "certificate", "pivot")


def other_shapes():
    """Rows for columns, lists for matrices, matrices for scalars."""
    for c in numbers():
        row, column = f"Matrix([[x, {c}]])", f"Matrix([[x], [{c}]])"
        yield equal(row, row), equal(row, column)
        marks = {"method": "normal form", "denominators": [], "pattern": {"a": [1, 2]}}
        honest = entry("structure", "Matrix([[a, a]])", "Matrix([[x, x]])", marks)
        yield honest, changed(honest, "Matrix([[a], [a]])", "printed")
        for places in ([True, 2], [1, 2.0], [1, "2"]):
            yield honest, changed(honest, {"a": places}, "certificate", "pattern")
        reference = {"method": "comparison of references"}
        honest = entry("reference", f"Matrix([[1, {c}]])", f"Matrix([[1, {c}]])", reference)
        yield honest, changed(honest, f"Matrix([[1], [{c}]])", "printed")
        yield honest, changed(honest, ["banana", c], "hypotheses")
        honest = limit_of(row, row, [], [0, 0], [])
        yield honest, changed(honest, column, "printed")
        factors = {
            "method": "factorisation", "content": "1", "factors": [["x", 1]], "denominator": [],
            "printed": [[["x", 1]]], "excluded": [],
        }  # fmt: skip
        honest = entry("vanishing", "(x,)", "x", factors, hypotheses=[])
        yield honest, changed(honest, f"Matrix([[x, y - {c}]])", "derived")
        yield honest, changed(honest, [[f"{c}*x", 1]], "certificate", "factors")


def other_meanings():
    """Symbols that stand for something without occurring, or that stand for themselves elsewhere."""
    for c in numbers():
        honest = equal("z", f"x + {c}", where={"z": f"x + {c}"})
        for name, meaning in (("q", "1/0"), ("x + y", "5"), ("", "0"), ("q", "x"), ("x", str(c)), ("z", 5)):
            yield honest, changed(honest, {**honest["where"], name: meaning}, "where")
        yield honest, changed(honest, "z", "derived")


def other_numerals():
    """Numbers, references and ranks with needless evidence, and what is no integer."""
    for c in numbers():
        rounding = {"method": "exact rounding", "rounded": "0.33"}
        honest = entry("numeric", "0.33", "1/3", rounding, setting={"rounding": "nearest"}, hypotheses=[])
        yield honest, changed(honest, [f"x - {c}"], "hypotheses")
        false = entry(
            "numeric", "0.34", "1/3", rounding, "false", setting={"rounding": "nearest"}, hypotheses=[], instead="1.2",
            counterexample={},
        )  # fmt: skip
        yield false, changed(false, {"x": str(c)}, "counterexample")
        rank = {"method": "kernel vectors", "rank at most": 1, "kernel": []}
        lower = entry(
            "rank", str(c), "Matrix([[x, y]])", rank, "false", hypotheses=[], counterexample={}, instead="1.2"
        )
        yield lower, changed(lower, True, "certificate", "rank at most")
        yield lower, changed(lower, "1", "printed")
        yield lower, changed(lower, "0", "printed")
        yield lower, changed(lower, {"lie": "banana"}, "counterexample")


def listed_texts():
    """A text where a list of texts is meant."""
    honest = over_y("1")
    for wrong in ("x", {"x**2 - 1": "lies"}, ("x",), None, [1], [["x"]], "y"):
        yield honest, changed(honest, wrong, "setting", "constraints")
        yield honest, changed(honest, wrong, "certificate", "generators")
        yield honest, changed(changed(honest, wrong, "hypotheses"), wrong, "certificate", "denominators")


def nested_refutations():
    """A misprint whose refutation holds more than it should."""
    for c in numbers():
        refutation = {"method": "counterexample", "left": ["2"], "right": ["1"]}
        certificate = {"method": "normal form", "denominators": [], "refutation": refutation}
        honest = entry(
            "identity", "2*x", "x", certificate, "misprint", corrected="x", counterexample={"x": "1"}, hypotheses=[]
        )
        yield honest, changed(honest, {**refutation, "refutation": c}, "certificate", "refutation")
        yield honest, changed(honest, {**refutation, "note": "lies"}, "certificate", "refutation")


def other_references():
    """A wrong reference that is said to be right, and a right one that is said to be wrong."""
    for c in numbers():
        certificate = {"method": "comparison of references"}
        honest = entry("reference", f"Matrix([[1, 3, {c}]])", f"Matrix([[1, 3, {c}]])", certificate)
        yield honest, changed(honest, f"Matrix([[1, 3, {c + 1}]])", "printed")
        yield honest, changed(honest, f"Matrix([[1, 3, {c}, 0]])", "printed")


def other_declarations():
    """An entry that is not bound to what it declares."""
    honest = equal("x + y", "y + x")
    for key, value in {
        "paper": "other", "number": "1.2", "section": "2", "title": "more", "note": "none", "printed": "x + y + 0",
        "derived": "x + y", "quote": {"line": 1, "latex": "x"}, "instead": "1.2", "where": {"z": "x"},
        "setting": {"nonzero": ["x"]}, "corrected": "x", "declaration": "0" * 64, "kind": "structure",
    }.items():  # fmt: skip
        yield honest, {**honest, key: value}
    for number in ("1.1 ", " 1.1", "1.1\u200b", "1.\uff11", "1..1", "", "x", "1.1#", "1.1/", None, 11):
        yield honest, changed(honest, number, "number")
    for text in ("a\x1b[31mb", "a\nb", "\u202eab", None):
        yield honest, changed(honest, text, "title")


def other_verdicts():
    """Verdicts, kinds and engines that do not exist, or that are not those of the evidence."""
    honest = equal("x + y", "y + x")
    for verdict in ("Proved", "proved ", "misprint", "false", "illegible", "definition", "open", "error", "", None):
        yield honest, changed(honest, verdict, "verdict")
        yield honest, changed(changed(honest, verdict, "verdict"), verdict, "expected")
    for kind in ("Identity", "identity under constraints", "rank", "limit", "numeric", "definition", "theorem", None):
        yield honest, changed(honest, kind, "kind")
        yield honest, changed(honest, kind, "engine")


def false_refutations():
    """A point at which the sides agree, are not defined, or that is none."""
    for c in numbers():
        certificate = {"method": "counterexample", "left": [str(c)], "right": ["1"]}
        honest = entry(
            "identity", f"{c}/x", "1/x", certificate, "false", instead="1.2", counterexample={"x": "1"}, hypotheses=[]
        )
        yield honest, changed(honest, f"1/x + 0*{c}", "printed")
        yield honest, changed(honest, {"x": "0"}, "counterexample")
        yield honest, changed(honest, {}, "counterexample")
        yield honest, changed(honest, {"x": "1", "y": "1"}, "counterexample")
        yield honest, changed(honest, {"x": "2/2"}, "counterexample")
        yield honest, changed(honest, [str(c + 1)], "certificate", "left")
        yield honest, changed(honest, {"nonzero": ["x - 1"]}, "setting")


def other_readings():
    """A damaged place that the quote has not, or a reading that is no text."""
    for c in numbers():
        edit = {"scan": f"\\xi_{c}", "read": f"x_{c}", "why": "the scan takes xi for x"}
        honest = equal("x", "x", quote={"line": c, "latex": f"a = \\xi_{c} + 1", "read_as": [edit]})
        for name, value in (("scan", f"\\eta_{c}"), ("scan", ""), ("scan", c), ("read", c), ("why", None)):
            yield honest, changed(honest, value, "quote", "read_as", 0, name)
        yield honest, changed(honest, "1", "quote", "read_as", 0, "line")
        yield honest, changed(honest, [{"scan": f"\\xi_{c}", "read": ""}], "quote", "read_as")
        for value in ([], {}, "", edit, [edit["scan"]]):
            yield honest, changed(honest, value, "quote", "read_as")


def other_variables():
    """A limit or a count in what is no name, or in a name that only looks like one that occurs."""
    for c in numbers():
        name = f"t{c}"
        honest = entry(
            "limit", f"1/{name}", f"1/({name} + s)",
            {"method": "leading coefficients", "divisors": [f"{name} + s"], "orders": [0]},
            setting={"variable": "s"}, hypotheses=[name],
        )  # fmt: skip
        pole = changed(changed(honest, f"1/{name}", "derived"), [name], "certificate", "divisors")
        for variable in (f"{name} ", f"\uff54{c}", f"{name} + 0", ""):
            yield honest, changed(pole, variable, "setting", "variable")
        kernel = {"kernel": ["Matrix([[1]])"], "kernel at": {}, "kernel rows": [0], "kernel minor": "1"}
        one = {
            "method": "rank at a point and kernel vectors",
            "point": {name: "1"},
            "rows": [0],
            "columns": [0],
            "minor": "1",
        }
        honest = entry("count", "1", name, one | {"kernel": []}, setting={"variables": [name]}, hypotheses=[])
        yield honest, changed(honest, [name, name], "setting", "variables")
        for variable in (f"{name} ", f"\uff54{c}", f"{name}/1", ""):
            none = one | kernel | {"point": {name: "1", variable: "1"}, "rows": [], "columns": []}
            yield honest, entry("count", "0", name, none, setting={"variables": [variable]}, hypotheses=[])


def names_that_look_alike():
    """What is refuted because one letter is written in two alphabets."""
    for c in numbers():
        for latin, other in (("x", "\u0445"), ("o", "\u03bf"), ("v", "\uff56")):
            left, right, point = f"{c}*{latin}", f"{c}*{other}", {latin: "1", other: "0"}
            certificate = {"method": "counterexample", "left": [str(c)], "right": ["0"]}
            forged = entry(
                "identity", left, right, certificate, "false", instead="1.2", counterexample=point, hypotheses=[]
            )
            honest = changed(forged, left.replace(latin, "y"), "printed")
            yield changed(honest, {"y": "1", other: "0"}, "counterexample"), forged
            forged = answer(left, right, certificate, "refuted", counterexample=point)
            assert replay_identity(forged).status == "rejected"


@pytest.mark.parametrize(("name", "status"), [("p", "replayed"), ("pi", "rejected")])
def test_pi_is_no_letter(name, status):
    point = {name: [["1"]], "v": [["1"]], "n": 1}
    certificate = {"method": "counterexample", "left": [["1"]], "right": [["3"]]}
    record = answer(f"{name}*v", "3*v", certificate, "refuted", counterexample=point)
    assert replay_identity({**record, "letters": {name: "1x1", "v": "nx1"}}).status == status


CLAIMS = (
    dividing_cofactors, dividing_generators, other_languages, hidden_hypotheses, needless_hypotheses, surplus_fields,
    overflowing_exponents, other_witnesses, contradictory_constraints, conditions_that_never_hold, other_numbers,
    factors_that_vanish, other_ranks, other_limits, other_zeros, several_components, other_shapes, other_meanings,
    other_numerals, listed_texts, nested_refutations, other_references, other_declarations, other_verdicts,
    false_refutations, other_readings, other_variables, names_that_look_alike,
)  # fmt: skip


# Families of identities from elsewhere


def square_of_one():
    return following("x**2", "1", "x**2 - 1", "x**2 - 1", end("1"), {"x": "1"})


def dividing_steps():
    """Steps, units and multipliers that divide by what vanishes."""
    for c in numbers():
        honest, point, about = square_of_one(), {"x": "1"}, ("x", str(c), "x**2 - 1", f"x - {c}")
        yield honest, following(*about, end(f"(x - {c})/(x**2 - 1)"), point)
        step = {"not zero": f"x - {c}", "multiplier": "1", "cofactors": {"0": "0"}, "factor": f"1/(x - {c})"}
        yield honest, following(*about, end("0", multiplier="0/x"), point, steps=[step])
        step = {"zero": f"x - {c}", "multiplier": "1", "cofactors": {"0": f"(x - {c})/(x**2 - 1)"}}
        yield honest, following(*about, {"steps": [step], **end("0", "1")}, point)
        yield honest, following(*about, end("0", "1"), point, steps=[step])


def steps_of_others():
    """Steps that use what is shown only later, in another entry, or about another claim."""
    for c in numbers():
        honest, point, about = square_of_one(), {"x": "1"}, ("x", str(c), "x**2 - 1", f"x - {c}")
        later = {"zero": f"x - {c}", "multiplier": "1", "cofactors": {"1": "1"}}
        yield honest, following(*about, end("0", "1"), point, steps=[later])
        yield honest, following(*about, {"steps": [later, later], **end("0", "1")}, point)
        goal = {"goal": "0", "multiplier": "1", "cofactors": {}, "factor": "0"}
        yield honest, following(*about, end(), point, steps=[goal])
        yield honest, changed(honest, [goal], "certificate", "steps")
        yield honest, following(*about, {"steps": [goal], **end()}, point)
        unit = {"not zero": f"x - {c}", "multiplier": f"x - {c}", "cofactors": {}, "factor": "1"}
        yield honest, following(*about, end(multiplier="0"), point, steps=[unit])
        yield honest, following(*about, end("0", multiplier=f"x - {c}", exponent=0), point, steps=[unit])


def invented_units():
    """Something is said not to vanish without a reason."""
    for c in numbers():
        about = "x", str(c), f"x*(x - {c})", f"x - {c}", end("1", multiplier="x"), {"x": str(c)}
        honest = following(*about, ["x"], ["x"])
        yield honest, following(*about)
        yield honest, following(*about, ["x"])
        yield honest, changed(honest, ["x - 1"], "nonzero")
        yield honest, changed(honest, "0", *FIRST, "multiplier")
        yield honest, changed(honest, -1, *FIRST, "exponent")


def squares_that_are_none():
    """Weights that are not positive, and squares that need not vanish."""
    for c in numbers():
        step = {"squares": [["1", "x"], [str(c), "y"]], "multiplier": "1", "cofactors": {"0": "1"}}
        part = end("0", "1", "0")
        constraint, point = f"x**2 + {c}*y**2", {"x": "0", "y": "0"}
        honest = following("x", "0", constraint, "x", part, point, steps=[step])
        honest["certificate"]["method"] = honest["method"] = "sums of squares"
        negative = following("x", "0", f"x**2 - {c}*y**2", "x", part, point)
        for weights in (("1", f"-{c}"), ("0", str(c)), ("1", "0"), ("1/1", str(c)), ("x", str(c))):
            squares = [[weights[0], "x"], [weights[1], "y"]]
            forged = changed(negative, [{**step, "squares": squares}], "certificate", "steps")
            forged["certificate"]["method"] = forged["method"] = "sums of squares"
            yield honest, forged
            inside = changed(forged, forged["certificate"]["steps"], *FIRST, "steps")
            del inside["certificate"]["steps"]
            yield honest, inside


def positive_sums_that_are_none():
    """A sum of squares that may vanish, since none of them is a number other than zero."""
    for c in numbers():

        def of(squares, total, c=c):
            about = "x", str(c), f"(x - {c})*({total})", f"x - {c}", end("1", multiplier=total), {"x": str(c)}
            entry = following(*about, steps=[{"squares": squares, "not zero": total}])
            entry["certificate"]["method"] = entry["method"] = "sums of squares"
            return entry

        honest = of([["1", "x"], [str(c), "1"]], f"x**2 + {c}")
        yield honest, of([["1", "x"]], "x**2")
        yield honest, of([["1", "x"], ["1", "0"]], "x**2")
        yield honest, of([["1", "x"], [str(c), "x - x"]], "x**2")
        yield honest, of([["1", "x"], ["1", "2*x"]], "5*x**2")
        yield honest, of([["1", "x"], [f"-{c}", "1"]], f"x**2 - {c}")
        yield honest, of([["1", "x"], [str(c), "1"]], "x**2")


def shown_numbers():
    """A counterexample in an extension field that is shown and is not the one that was checked."""
    for c in (2, 3, 5, 6, 7, 10, 11, 13, 14, 15, 17, 19, 21, 22, 23, 26, 29, 30, 31, 33):
        extension = {"coefficients": ["1", "0", str(-c)], "root between": ["0", str(c)]}
        certificate = {"method": "counterexample", "left": ["r"], "right": ["1"], "extension": extension}
        honest = answer("x", "1", certificate, "refuted", [f"x^2 = {c}"], (), {"x": "r"})
        yield honest, changed(honest, {"x": "1"}, "counterexample")
        yield honest, changed(honest, {"x": "r + 1"}, "counterexample")
        yield honest, changed(honest, {"x": "r", "y": "7"}, "counterexample")
        yield honest, changed(honest, ["2*r"], "certificate", "left")
        yield honest, changed(honest, [str(c), str(c + 1)], "certificate", "extension", "root between")
        yield honest, changed(honest, ["1", "0", str(c)], "certificate", "extension", "coefficients")
        yield honest, changed(honest, {"x": ["1", "0"]}, "certificate", "extension", "values")
        yield honest, changed(honest, ["x"], "hypotheses")
        for method in ("normal form", "ideal membership", "Counterexample"):
            yield honest, changed(changed(honest, method, "certificate", "method"), method, "method")


def matrices_as_conditions():
    """A matrix as a constraint or a condition, of which one entry might be read."""
    for c in numbers():
        difference = {"method": "counterexample", "left": ["0"], "right": [str(c)]}
        honest = answer("y", str(c), difference, "refuted", ["x - 1"], (), {"x": "1", "y": "0"})
        yield honest, changed(honest, [f"[[x - 1, y - {c}]]"], "constraints")
        point = {"x": "1", "y": str(c), "z": "0"}
        honest = following("z + 0*y", "0", "x*z", "z", end("1", multiplier="x"), point, ["x"], ["x"])
        yield honest, changed(honest, ["[[x, y]]"], "nonzero")
        yield honest, changed(honest, ["1) + (x = y) - (0"], "nonzero")
        yield honest, changed(honest, "radical membership", "certificate", "method")
        yield honest, changed(honest, "banana", "seconds")
        yield honest, changed(honest, c, "file")
        yield honest, changed(honest, {"\u0660": "1"}, "certificate", "entries", 0, "cofactors")


def moved_statements():
    """A translation along which something changes."""
    for c in numbers():
        along = [{"zero": "a", "along": {"a": "1", "b": "1"}}]
        part = end("1")
        honest = following(
            "b", f"a + {c}", f"b - a - {c}", f"b - a - {c}", part, {"a": "0", "b": str(c)}, translations=along
        )
        yield (
            honest,
            following("b", str(c), f"b - a - {c}", f"b - {c}", part, {"a": "0", "b": str(c)}, translations=along),
        )
        for wrong in ({"a": "1"}, {"a": "1", "b": "2"}, {"a": "2", "b": "2"}, {"b": "1"}):
            yield honest, changed(honest, [{"zero": "a", "along": wrong}], "certificate", "translations")


def surplus_parts():
    """Whatever else stands in a certificate, at any depth."""
    honest = square_of_one()
    step = {"not zero": "x", "multiplier": "1", "cofactors": {"0": "-1"}, "factor": "x"}
    stepped = changed(honest, [step], "certificate", "steps")
    for name in (
        "proof",
        "value",
        "power",
        "Factor",
        "comment",
        "zero",
        "product",
        "cases",
        "divisions",
        "goal",
        "scale",
        "refutation",
    ):
        yield honest, {**honest, name: "0"}
        yield honest, changed(honest, "0", "certificate", name)
        yield honest, changed(honest, "0", "certificate", "entries", 0, name)
        yield stepped, changed(stepped, "0", "certificate", "steps", 0, name)


IDENTITIES = (
    surplus_parts,
    matrices_as_conditions,
    dividing_steps,
    steps_of_others,
    invented_units,
    squares_that_are_none,
    positive_sums_that_are_none,
    shown_numbers,
    moved_statements,
)


@pytest.mark.parametrize("family", [*CLAIMS, *IDENTITIES], ids=lambda family: family.__name__)
def test_forgeries_are_rejected_and_their_honest_twins_replay(family):
    replay_one = replay_claim if family in CLAIMS else replay_identity
    pairs = list(family())
    assert len(pairs) >= AT_LEAST
    for honest, forged in pairs:
        assert replay_one(honest).status == "replayed", (replay_one(honest).reason, honest)
        assert replay_one(forged).status != "replayed", forged


def test_the_families_are_many():
    assert len(CLAIMS) + len(IDENTITIES) >= 12


# Ledgers


def book(*claims, **changes):
    verdicts = [claim["verdict"] for claim in claims]
    counts = {verdict: verdicts.count(verdict) for verdict in verdicts}
    return {"schema": 1, "claims": [*claims], "summary": counts} | changes


def false_claim(instead, number="1.2"):
    certificate = {"method": "counterexample", "left": ["1"], "right": ["2"]}
    return entry(
        "identity", "x", "2*x", certificate, "false", number=number, instead=instead, counterexample={"x": "1"}
    )


TRUE = equal("x + y", "y + x")


@for_each(
    "ledger",
    [
        book(),
        {"schema": 1, "claims": [], "summary": {}},
        book(TRUE, TRUE),
        book(TRUE, summary={"proved": 2}),
        book(TRUE, summary={}),
        book(TRUE, schema=2),
        book(TRUE, schema="1"),
        book(TRUE, more=1),
        book(TRUE, claims=None),
        book(TRUE, claims=[None]),
        {"schema": 1, "identities": [], "summary": {}},
        {"schema": 1, "summary": {}},
        [],
    ],
)
def test_a_ledger_that_is_not_what_it_says_is_rejected_as_a_whole(ledger):
    with pytest.raises(Rejected):
        list(replay(ledger))


@pytest.mark.parametrize("instead", ["1.3", "1.2", "1.1 ", "", "demo:1.1", None])
def test_what_is_true_instead_is_a_claim_that_holds(instead):
    assert [result.status for result in replay(book(TRUE, false_claim("1.1")))] == ["replayed"] * 2
    assert [result.status for result in replay(book(TRUE, false_claim(instead)))] == ["replayed", "rejected"]


def test_a_claim_that_differs_by_a_blank_is_no_second_claim():
    twin = {**TRUE, "number": "1.1 "}
    twin["declaration"] = declaration_digest(twin)
    assert [result.status for result in replay(book(TRUE, twin))] == ["replayed", "rejected"]


# Honest answers of unusual form


@for_each(
    ("lhs", "rhs", "hypotheses"),
    [
        ("α + Matrix", "Matrix + α", []),
        ("x' + x''", "x'' + x'", []),
        ("x + y - y", "x", []),
        ("x + 0*y", "x", []),
        ("x^3000/x^2999", "x", ["x"]),
        ("lambda*E", "E*lambda", []),
        ("1/y - 1/y", "0", ["y"]),
        (f"{'9' * 5000} + x", f"x + {'9' * 5000}", []),
        ("(a + b)^20 - (b + a)^20", "0", []),
    ],
)
def test_unusual_honest_answers_replay(lhs, rhs, hypotheses):
    record = answer(lhs, rhs, {"method": "normal form", "denominators": hypotheses})
    assert (replay_identity(record).status, replay_identity(record).reason) == ("replayed", "")
    dishonest = answer(f"{lhs} + 1", rhs, {"method": "normal form", "denominators": hypotheses})
    assert replay_identity(dishonest).status == "rejected"


# A search: certificates of false statements, put together from pieces of valid ones

PIECES = (
    "0", "1", "-1", "2", "x", "y", "-x", "x + y", "x - y", "x**2", "y**2", "x**2 + y**2 - 1", "x*y", "x**2 - y",
    "y - 1", "x - 1", "x + 1", "2*x", "x*y - 1", "x**2 + y**2", "1 - y**2", "1 - x**2", "x**2 - 1",
)  # fmt: skip
METHODS = ("ideal membership", "sums of squares")
CONSTRAINTS = {
    "x**2 + y**2 - 1": ("3/5", "4/5"), "x*y - 1": ("2", "1/2"), "x**2 - y": ("3", "9"), "x - y": ("7", "7"),
    "x*(y - 1)": ("5", "1"),
}  # fmt: skip


def value(text, point):
    return eval(text, {"x": point[0], "y": point[1]})


@st.composite
def false_statements(draw):
    """Two sides that differ at a point of the constraint, and the point."""
    constraint = draw(st.sampled_from(sorted(CONSTRAINTS)))
    point = tuple(map(Fraction, CONSTRAINTS[constraint]))
    lhs, rhs = draw(st.sampled_from(PIECES)), draw(st.sampled_from(PIECES))
    return (lhs, rhs, constraint, point) if value(lhs, point) != value(rhs, point) else None


@settings(max_examples=6 * settings.default.max_examples)
@given(data=st.data())
def test_no_certificate_of_a_false_statement_is_found(data):
    statement = data.draw(false_statements())
    if statement is None:
        return
    lhs, rhs, constraint, point = statement
    piece = st.sampled_from(PIECES)
    claims = st.sampled_from([f"{lhs} - ({rhs})", f"{rhs} - ({lhs})", lhs, rhs]) | piece
    places = st.dictionaries(st.sampled_from("0123"), piece, max_size=3)
    exact = {"x": str(point[0]), "y": str(point[1])}
    weighted = st.lists(st.tuples(st.sampled_from(["1", "2", "3/4"]), piece), min_size=1, max_size=3)
    step = st.one_of(
        st.fixed_dictionaries({"squares": weighted, "multiplier": piece, "cofactors": places}),
        st.fixed_dictionaries({"squares": weighted, "not zero": piece}),
        st.fixed_dictionaries({"zero": piece, "multiplier": piece, "cofactors": places}),
        *(
            st.fixed_dictionaries({shown: piece, "multiplier": piece, "cofactors": places, "factor": piece})
            for shown in ("not zero", "goal")
        ),
    )
    last = st.fixed_dictionaries(
        {"exponent": st.integers(0, 2), "multiplier": piece, "cofactors": places},
        optional={"steps": st.lists(step, min_size=1, max_size=2)},
    )

    @st.composite
    def split(draw):
        assumed = draw(piece)
        first, second = draw(last), draw(last)
        return {"cases": [{**first, "assumed": {"not zero": assumed}}, {**second, "assumed": {"zero": assumed}}]}

    proof, steps = data.draw(last | split()), data.draw(st.lists(step, max_size=2))
    squares = any("squares" in shown for shown in (*steps, *proof.get("steps", ())))
    membership = "radical membership" if proof.get("exponent", 0) > 1 else "ideal membership"
    certificate = {
        "method": "case distinction" if "cases" in proof else "sums of squares" if squares else membership,
        "denominators": [], "claims": [data.draw(claims)], "generators": [constraint],
        "units": data.draw(st.lists(piece, max_size=1)), "entries": [proof],
        "witness": data.draw(st.sampled_from([exact, {"x": "1", "y": "1"}, {"x": "1", "y": "0"}])),
    }  # fmt: skip
    certificate |= {"steps": steps} if steps else {}
    nonzero = data.draw(st.lists(st.sampled_from(["x - 9", "y + 3"]), max_size=1))
    record = json.loads(json.dumps(answer(lhs, rhs, certificate, constraints=[constraint], nonzero=nonzero)))
    assert replay_identity(record).status != "replayed"


@settings(max_examples=4 * settings.default.max_examples)
@given(data=st.data())
def test_no_certificate_of_a_false_claim_is_found(data):
    statement = data.draw(false_statements())
    if statement is None:
        return
    lhs, rhs, constraint, point = statement
    piece = st.sampled_from(PIECES)
    hypotheses = data.draw(st.lists(piece, max_size=1))
    record = member(
        lhs, rhs, constraint, data.draw(piece), {"x": str(point[0]), "y": str(point[1])}, *hypotheses,
        nonzero=data.draw(st.lists(piece, max_size=1)), generator=data.draw(st.none() | piece),
    )  # fmt: skip
    record = changed(record, data.draw(st.integers(0, 2)), *FIRST, "exponent")
    assert replay_claim(record).status != "replayed"
    assert replay_claim(equal(lhs, rhs, *hypotheses)).status != "replayed"


@pytest.mark.parametrize("others", [False, pytest.param(True, marks=pytest.mark.whole)])
def test_the_pieces_make_certificates_of_true_statements_alone(others):
    """The search would find certificates if there were any: those of true statements are of the same form."""
    found = 0
    for constraint, point in CONSTRAINTS.items():
        exact = tuple(map(Fraction, point))
        for lhs, rhs in itertools.product(PIECES, PIECES):
            may_hold = value(lhs, exact) == value(rhs, exact)
            for cofactor in ("0", "1", "-1", "x", "y") if may_hold or others else ():
                record = member(lhs, rhs, constraint, cofactor, dict(zip("xy", point, strict=True)))
                if replay_claim(record).status == "replayed":
                    assert may_hold
                    found += lhs != rhs
    assert found > 10


# What is too large, or is no ledger at all, is neither replayed nor a traceback

LARGE = (
    equal("x**((((((10**6)**(-20))**20)**20)**20)**20)", "x"),
    equal("(3**1000000)**1000", "1"),
    equal("1/((x**1000000)**1000 - 1)", "0", "x - 1"),
    equal("((x + 1)**1000)**1000", "x"),
    equal("(x + 1)**16000", "x"),
    equal("(" + " + ".join(f"x{place}" for place in range(999)) + ")**4", "0"),
    equal(" + ".join(f"1/(x{place} + y{place})" for place in range(40)), "0", *(f"x{k} + y{k}" for k in range(40))),
    equal("(" * 150 + "x" + ")" * 150, "y"),
    equal("x" + " + x" * 20000, "y"),
)


@pytest.mark.parametrize("record", LARGE, ids=range(len(LARGE)))
def test_what_is_too_large_is_not_replayed(record, monkeypatch):
    monkeypatch.setattr(polynomial, "MOST_PRODUCTS", 10**6)
    assert replay_claim(record).status in ("not replayable", "rejected")


@for_each("place", ["paper", "number", "verdict", "kind", "instead", "certificate", "where", "quote", "setting"])
@for_each("value", [[], ["1.1"], {}, {"a": [[[[]]]]}, 7, True, None, 1.5, "", "\ud800"])
def test_any_value_anywhere_gives_an_answer(place, value):
    for honest in (TRUE, false_claim("1.1")):
        forged = {**honest, place: value}
        result = replay_claim(forged)
        assert result.status != "replayed" or value == honest[place]
        verdicts = {"proved": 2} if forged["verdict"] == "proved" else {"proved": 1, str(forged["verdict"]): 1}
        with contextlib.suppress(Rejected):
            assert len(list(replay(book(TRUE) | {"claims": [TRUE, forged], "summary": verdicts}))) == 2
    nested = []
    for _ in range(900):
        nested = [nested]
    with pytest.raises(Rejected):
        list(replay(book(TRUE) | {"claims": [TRUE, {**TRUE, place: nested}]}))


@pytest.mark.parametrize("record", [[], None, 7, "x", {}])
def test_what_is_no_record_is_rejected(record):
    assert replay_claim(record).status == replay_identity(record).status == "rejected"
