"""The steps of a proof, each by its law: the lemma that shows what the replay's law adds."""

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import Any

from algebroproj_sym.exporting.gallina import digits
from algebroproj_sym.exporting.reals.enclosures import positive
from algebroproj_sym.exporting.reals.formulas import SIGNS, called
from algebroproj_sym.exporting.reals.writing import LEMMAS, Written
from algebroproj_sym.exporting.refusal import Silent
from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.reals.comparisons import REVERSED
from algebroproj_sym.replaying.reals.laws import LAWS
from algebroproj_sym.replaying.reals.proofs import assume

Step = Mapping[str, Any]

_CASES = {
    (">", "=", "<"): ("three_cases", "[{0}|[{1}|{2}]]"),
    (">=", "<"): ("not_negative_or_negative", "[{0}|{1}]"),
}


def write_proof(theory: Written, node: Mapping[str, Any], goal: Callable[[Written], None]) -> None:
    """Write a proof down: its steps, then its cases or its end."""
    for step in node["steps"]:
        write_step(theory, step)
    if "cases" in node:
        parts, text = node["cases"]["parts"], node["cases"]["of"]
        lemma, pattern = _CASES[tuple(part["assumed"] for part in parts)]
        names = [theory.fresh() for _ in parts]
        whole = theory.shown(theory.polynomial(text))
        theory.lines.append(f"destruct ({lemma} {whole}) as {pattern.format(*names)}.")
        for part, name in zip(parts, names, strict=True):
            branch = theory.branch()
            theory.lines.append("{")
            polynomial = branch.polynomial(text)
            reverse = part["assumed"] in REVERSED
            relation = REVERSED.get(part["assumed"], part["assumed"])
            branch.enter(relation, -polynomial if reverse else polynomial, name)
            assume(branch, part["assumed"], text)
            write_proof(branch, part, goal)
            theory.lines.append("}")
    elif node["end"] == "contradiction":
        theory.lines.append(f"exfalso; clear - {theory.absurd}; first [lra | now apply {theory.absurd}].")
    else:
        goal(theory)


def write_step(theory: Written, step: Step) -> None:
    """Write down what follows by a law."""
    if step["law"] not in _LEMMAS:
        raise Silent(f"no theorem is written yet for a proof by the law {step['law']!r}")
    theory.added = []
    LAWS[step["law"]][0](theory, step)
    added = theory.added
    if any(each.new for each in added):
        theory.added = []
        lemma = _LEMMAS[step["law"]](theory, step)
        theory.added = added
        theory.concluded(lemma)


# -- combinations


def _combined(theory: Written, cofactors: Mapping[str, str]) -> str:
    """Return a proof that a combination of zeros is zero."""
    proof = "(eq_refl 0)"
    for place, text in cofactors.items():
        fact = theory.hypotheses[theory.facts[int(place)]]
        proof = f"(sum_zero _ _ {proof} (multiple_zero {theory.shown(theory.polynomial(text))} _ {fact}))"
    return proof


def _proved(theory: Written, place: str, relation: str) -> str:
    fact = theory.facts[int(place)]
    known = theory.hypotheses[fact]
    if fact.relation == relation:
        return known
    return f"(positive_{'nonzero' if relation == '!=' else 'nonnegative'} _ {known})"


def _product(theory: Written, scale: str, powers: Mapping[str, int], relation: str) -> str:
    """Return a proof that a positive number times a product of facts is not zero, positive or not negative."""
    kind = LEMMAS[relation]
    sign = SIGNS[relation].format(scale)
    proof = f"(ltac:(lra) : {sign})"
    for place, power in powers.items():
        fact = theory.facts[int(place)]
        if fact.relation == "!=" and relation != "!=":
            factor = f"(square_positive _ (power_nonzero _ {power // 2} {theory.hypotheses[fact]}))"
            factor = f"(positive_nonnegative _ {factor})" if relation == ">=" else factor
        else:
            factor = f"(power_{kind} _ {power} {_proved(theory, place, relation)})"
        proof = f"(product_{kind} _ _ {proof} {factor})"
    return proof


def _identity(theory: Written, step: Step, relation: str) -> tuple[str, str]:
    """Return proofs of what multiplies an identity, and of what it adds."""
    multiplier = _product(theory, digits(step["scale"]), step["multiplier"], relation)
    return multiplier, _combined(theory, step["cofactors"])


def _follows(theory: Written, step: Step) -> str:
    zero, power = theory.shown(theory.polynomial(step["zero"])), step["exponent"]
    whole, combined = _identity(theory, step, "!=")
    if not power:
        return f"absurd_by _ _ {whole} {combined} ltac:(matching)"
    return f"zero_by _ {zero} {power} _ {whole} {combined} ltac:(matching)"


def _sign(theory: Written, step: Step) -> str:
    polynomial = theory.shown(theory.polynomial(step["polynomial"]))
    whole, combined = _identity(theory, step, ">")
    proof, positive = "", False
    for weight, root, powers in step["sum"]:
        square = theory.polynomial(root)
        constant = square.cleared().is_constant() and not square.is_zero
        strict = constant and all(theory.facts[int(place)].relation != ">=" for place in powers)
        number = _rational(Fraction(weight))
        product = _product(theory, "1", powers, ">" if strict else ">=")
        nonzero = f"(ltac:(lra) : {theory.shown(square)} <> 0) " if strict else ""
        term = (
            f"(weighted_{'positive' if strict else 'nonnegative'} {number} {theory.shown(square)} _ "
            f"(ltac:(lra) : 0 < {number}) {nonzero}{product})"
        )
        if not proof:
            proof = term
        elif positive:
            term = f"(positive_nonnegative _ {term})" if strict else term
            proof = f"(sum_positive_left _ _ {proof} {term})"
        else:
            proof = f"({'sum_positive_right' if strict else 'sum_nonnegative'} _ _ {proof} {term})"
        positive = positive or strict
    relation = step["relation"]
    if not proof:
        proof = "(Rle_refl 0)"
    elif positive and relation == ">=":
        proof = f"(positive_nonnegative _ {proof})"
    return f"{LEMMAS[relation]}_by _ {polynomial} _ _ {whole} {combined} {proof} ltac:(matching)"


def _rational(value: Fraction) -> str:
    return f"({digits(value.numerator)} / {digits(value.denominator)})"


def _nonzero(theory: Written, step: Step) -> str:
    whole, combined = _identity(theory, step, "!=")
    factor, polynomial = (theory.shown(theory.polynomial(step[key])) for key in ("factor", "polynomial"))
    return f"nonzero_by_factor _ {factor} {polynomial} _ {whole} {combined} ltac:(matching)"


def _both(theory: Written, step: Step) -> str:
    polynomial = theory.polynomial(step["polynomial"])
    text = theory.shown(polynomial)
    if theory.holds(">=", -polynomial):
        parts = [theory.proof(">=", polynomial), theory.proof(">=", -polynomial, f"(- {text})")]
        return f"both_zero _ {' '.join(parts)}"
    return f"both_positive _ {theory.proof('>=', polynomial)} {theory.proof('!=', polynomial)}"


def _value(theory: Written, step: Step) -> str:
    return positive(theory, theory.polynomial(step["polynomial"]))


# -- angles


def _angle(theory: Written, step: Step, function: str) -> tuple[Element, str, str]:
    angle = theory.read(step["angle"])
    return angle, theory.shown(angle), theory.name(function, angle)


def _addition(theory: Written, step: Step) -> str:
    sin, angle = called(step["target"]), theory.applications[step["target"]].args[0]
    proof, whole, rest = "unturned", "0", angle
    for count, text in step["parts"]:
        part = theory.read(text)
        shown = theory.shown(part)
        if (part + part - theory.pi).is_zero:
            equal = theory.asserted(f"2 * {shown} = PI", "matching.")
            known = f"(quarter_cosine _ {equal}) (quarter_sine _ {equal})"
        else:
            known = f"d{theory.name('cos', part)} d{theory.name('sin', part)}"
        rest = rest - theory.number(count) * part
        turned, added = _turned(abs(count), f"(once _ _ {shown} {known})", shown)
        if count < 0:
            turned, added = f"(reversed _ _ _ {turned})", f"(- {added})"
        proof, whole = f"(together _ _ _ _ _ _ {proof} {turned})", f"({whole} + {added})"
    zero = theory.proof("=", rest, f"({theory.shown(angle)} - {whole})")
    return f"addition _ _ _ _ _ _ d{sin} d{theory.name('cos', angle)} {proof} {zero}"


def _turned(count: int, once: str, angle: str) -> tuple[str, str]:
    """Return a proof of what the cosine and sine of a multiple of an angle are, by doubling, and the multiple."""
    if count == 1:
        return once, angle
    proof, multiple = _turned(count // 2, once, angle)
    proof, multiple = f"(twice _ _ _ {proof})", f"(2 * {multiple})"
    if count % 2:
        proof, multiple = f"(together _ _ _ _ _ _ {proof} {once})", f"({multiple} + {angle})"
    return proof, multiple


def _zero_of_sine(theory: Written, step: Step) -> str:
    angle, text, sin = _angle(theory, step, "sin")
    zero = theory.proof("=", theory.field.symbol(_plain(theory, "sin", angle)), sin)
    return f"zero_of_sine {text} {sin} d{sin} {zero} {_around(theory, angle, text, 1)}"


def _around(theory: Written, angle: Element, text: str, turns: int) -> str:
    """Return proofs that an angle lies between minus and plus so many half turns."""
    half = theory.number(turns) * theory.pi
    bound = "PI" if turns == 1 else f"{turns} * PI"
    pairs = ((half - angle, f"({bound} - {text})"), (half + angle, f"({bound} + {text})"))
    return " ".join(theory.proof(">", element, shown) for element, shown in pairs)


def _plain(theory: Written, function: str, angle: Element) -> str:
    name = theory.name(function, angle)
    return next(plain for plain in theory.applications if called(plain) == name)


def _full_turn(theory: Written, step: Step) -> str:
    angle, text, cos = _angle(theory, step, "cos")
    one = theory.proof("=", theory.field.symbol(_plain(theory, "cos", angle)) - theory.number(1), f"({cos} - 1)")
    return f"full_turn {text} {cos} d{cos} {one} {_around(theory, angle, text, 2)}"


def _sine_in_range(theory: Written, step: Step) -> str:
    angle, text, sin = _angle(theory, step, "sin")
    rest = theory.pi - angle
    strict = theory.holds(">", angle) and theory.holds(">", rest)
    relation = ">" if strict else ">="
    proofs = f"{theory.proof(relation, angle)} {theory.proof(relation, rest, f'(PI - {text})')}"
    return f"sine_{'strictly_' * strict}in_range {text} {sin} d{sin} {proofs}"


def _cosine_in_range(theory: Written, step: Step) -> str:
    angle, text, cos = _angle(theory, step, "cos")
    double = theory.number(2) * angle
    pairs = ((theory.pi - double, f"(PI - 2 * {text})"), (theory.pi + double, f"(PI + 2 * {text})"))
    strict = all(theory.holds(">", side) for side, _ in pairs)
    proofs = " ".join(theory.proof(">" if strict else ">=", side, shown) for side, shown in pairs)
    return f"cosine_{'strictly_' * strict}in_range {text} {cos} d{cos} {proofs}"


def _range_of_sine(theory: Written, step: Step) -> str:
    angle, text, _ = _angle(theory, step, "sin")
    sides = ((angle + theory.pi, f"({text} + PI)"), (theory.number(2) * theory.pi - angle, f"(2 * PI - {text})"))
    return _in_range(theory, "sine", angle, sides)


def _range_of_cosine(theory: Written, step: Step) -> str:
    angle, text, _ = _angle(theory, step, "cos")
    double, three = theory.number(2) * angle, theory.number(3) * theory.pi
    sides = ((three - double, f"(3 * PI - 2 * {text})"), (three + double, f"(3 * PI + 2 * {text})"))
    return _in_range(theory, "cosine", angle, sides)


def _in_range(theory: Written, function: str, angle: Element, sides: Iterable[tuple[Element, str]]) -> str:
    short = {"sine": "sin", "cosine": "cos"}[function]
    value, name = theory.field.symbol(_plain(theory, short, angle)), theory.name(short, angle)
    strict = theory.holds(">", value)
    proofs = " ".join(theory.proof(">=" if strict else ">", side, shown) for side, shown in sides)
    sign = theory.proof(">" if strict else ">=", value, name)
    return f"range_of_{function}{'_weakly' * (not strict)} {theory.shown(angle)} {name} d{name} {sign} {proofs}"


def _order_of_sines(theory: Written, step: Step) -> str:
    given, proofs, sines, names = "", "", list[Element](), list[str]()
    for angle in (theory.read(step[key]) for key in ("larger", "smaller")):
        text, double = theory.shown(angle), theory.number(2) * angle
        pairs = ((theory.pi - double, f"(PI - 2 * {text})"), (theory.pi + double, f"(PI + 2 * {text})"))
        proofs += "".join(f" {theory.proof('>=', side, shown)}" for side, shown in pairs)
        names.append(theory.name("sin", angle))
        sines.append(theory.field.symbol(_plain(theory, "sin", angle)))
        given += f" {text} {names[-1]}"
    rise = sines[0] - sines[1]
    relation = next(relation for relation in ("=", ">", ">=") if theory.holds(relation, rise))
    lemma = {"=": "equal_sines", ">": "order_of_sines_strictly", ">=": "order_of_sines"}[relation]
    shown = theory.proof(relation, rise, f"({names[0]} - {names[1]})")
    return f"{lemma}{given} d{names[0]} d{names[1]}{proofs} {shown}"


# -- exponentials, logarithms, powers, signs


def _exponents(theory: Written, step: Step) -> str:
    target = theory.applications[step["target"]].args[0]
    proof, whole, rest = "no_exponent", "0", target
    for count, name in step["parts"]:
        known = theory.applications[name]
        (argument,) = known.args
        if known.function == "log":
            exponent = theory.field.symbol(name)
            text, equal = called(name), f"(exp_of_log _ _ d{called(name)} {theory.proof('>', argument)})"
        else:
            exponent, text, equal = argument, theory.shown(argument), f"d{called(name)}"
        rest = rest - theory.number(count) * exponent
        for _ in range(abs(count)):
            proof = f"({'exponent_on' if count > 0 else 'exponent_back'} _ _ _ {text} _ {proof} {equal})"
            whole = f"({whole} {'+' if count > 0 else '-'} {text})"
    zero = theory.proof("=", rest, f"({theory.shown(target)} - {whole})")
    return f"exponents _ _ _ _ _ d{called(step['target'])} {proof} {zero}"


def _logarithms(theory: Written, step: Step) -> str:
    argument = theory.applications[step["target"]].args[0]
    proof, whole, product = "no_factor", "1", theory.number(1)
    for count, text in step["parts"]:
        part = theory.read(text)
        shown, positive = theory.shown(part), theory.proof(">", part)
        equal = _logarithm(theory, part, shown)
        product = product * part**count
        for _ in range(abs(count)):
            proof = f"({'factor_on' if count > 0 else 'factor_back'} _ _ {shown} _ {proof} {positive} {equal})"
            whole = f"({whole} {'*' if count > 0 else '/'} {shown})"
    zero = theory.proof("=", argument - product, f"({theory.shown(argument)} - {whole})")
    return f"logarithms _ _ _ _ d{called(step['target'])} {proof} {zero}"


def _logarithm(theory: Written, part: Element, shown: str) -> str:
    for name, known in theory.applications.items():
        if known.function == "exp" and (theory.field.symbol(name) - part).is_zero:
            return f"(log_of_exp {shown} {theory.shown(known.args[0])} d{called(name)})"
    return f"d{theory.name('log', part)}"


def _equal_powers(theory: Written, step: Step) -> str:
    left, right, degree = theory.read(step["left"]), theory.read(step["right"]), step["degree"]
    signs = f"{theory.proof('>=', left)} {theory.proof('>=', right)}"
    texts = theory.shown(left), theory.shown(right)
    powers = theory.proof("=", left**degree - right**degree, f"({texts[0]} ^ {degree} - {texts[1]} ^ {degree})")
    return f"equal_powers {texts[0]} {texts[1]} {degree - 1} {signs} {powers}"


def _order_of_powers(theory: Written, step: Step) -> str:
    larger, smaller, degree = theory.read(step["larger"]), theory.read(step["smaller"]), step["degree"]
    texts, rise = (theory.shown(larger), theory.shown(smaller)), larger**degree - smaller**degree
    strict = theory.holds(">", rise)
    shown = theory.proof(">" if strict else ">=", rise, f"({texts[0]} ^ {degree} - {texts[1]} ^ {degree})")
    lemma = f"order_of_powers{'_strictly' * strict}"
    return f"{lemma} {texts[0]} {texts[1]} {degree - 1} {theory.proof('>=', larger)} {shown}"


def _sign_function(theory: Written, step: Step) -> str:
    value, argument = called(step["target"]), theory.applications[step["target"]].args[0]
    text = theory.shown(argument)
    for relation, side, shown, lemma in (
        (">", argument, text, "positive"),
        (">", -argument, f"(- {text})", "negative"),
        ("=", argument, text, "zero"),
    ):
        if theory.holds(relation, side):
            return f"sign_of_{lemma} {value} {text} d{value} {theory.proof(relation, side, shown)}"
    raise AssertionError("the replay refuses a sign that is not known")


def _strict_bounds(theory: Written, step: Step) -> str:
    value, known = called(step["target"]), theory.applications[step["target"]]
    (u,), text = known.args, theory.shown(known.args[0])
    if known.function == "root":
        kind = f"strictly_of_sqrt {value}" if known.degree == 2 else f"strictly_of_root {known.degree - 1} {value}"
        return f"proj1 ({kind} {text} d{value} {theory.proof('>', u)})"
    if known.function == "exp":
        return f"strict_bounds_of_exp {value} {text} d{value} {theory.proof('!=', u)}"
    one = theory.proof("!=", u - theory.number(1), f"({text} - 1)")
    return f"strict_bounds_of_log {value} {text} d{value} {theory.proof('>', u)} {one}"


_LEMMAS: Mapping[str, Callable[[Written, Step], str]] = {
    "defined": lambda theory, step: "",
    "follows": _follows,
    "sign": _sign,
    "nonzero": _nonzero,
    "both": _both,
    "value": _value,
    "addition": _addition,
    "exponents": _exponents,
    "logarithms": _logarithms,
    "equal powers": _equal_powers,
    "order of powers": _order_of_powers,
    "zero of sine": _zero_of_sine,
    "full turn": _full_turn,
    "sine in range": _sine_in_range,
    "cosine in range": _cosine_in_range,
    "range of sine": _range_of_sine,
    "range of cosine": _range_of_cosine,
    "order of sines": _order_of_sines,
    "strict bounds": _strict_bounds,
    "sign function": _sign_function,
}
