"""A theory that writes down, for Coq, why each of its facts holds.

The replay's theory finds what is asked and added, in its order; each fact becomes a hypothesis, an equation or
inequality of a polynomial in symbols and in the values of functions, which are names here.
"""

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from typing import NamedTuple, Self

from algebroproj_sym.exporting.gallina import digits
from algebroproj_sym.exporting.reals.formulas import APPLIED, SIGNS, called, formula, root
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.replaying.field import Element
from algebroproj_sym.replaying.polynomial import Polynomial, powers_of
from algebroproj_sym.replaying.reals.definitions import Condition, expanded
from algebroproj_sym.replaying.reals.terms import Term
from algebroproj_sym.replaying.reals.terms import power as raised
from algebroproj_sym.replaying.reals.theory import Application, Fact, Theory

LEMMAS = {"=": "zero", "!=": "nonzero", ">": "positive", ">=": "nonnegative"}

_DEFINED = {
    "abs": "apply absolute",
    "tan": "reflexivity",
    "acos": "apply arc_cosine; lra",
    "sinh": "apply hyperbolic_sine",
    "cosh": "apply hyperbolic_cosine",
    "tanh": "apply hyperbolic_tangent",
}
"""Why functions that have a name in Coq are what others define them as."""


class Added(NamedTuple):
    """What a law adds, and whether that was unknown."""

    relation: str
    element: Element
    new: bool


class Enclosed(NamedTuple):
    """Bounds of a number, its formula, and the name of what proves them."""

    low: Fraction
    high: Fraction
    text: str
    proof: str


class Written(Theory):
    """A theory with the tactics that prove its facts.

    The premises are what a theorem assumes, each with how a proof of the relation to zero is made.  `lines` are the
    tactics, and `enclosed` are the numbers whose bounds are written down.
    """

    def __init__(self, symbols: Iterable[str], premises: Sequence[tuple[Condition, str]]) -> None:
        self.lines: list[str] = []
        self.premises = premises
        self.count = [0]
        self.hypotheses: dict[Fact, str] = {}
        self.units: dict[int, str] = {}
        self.leaves: dict[str, str] = {}
        self.added: list[Added] = []
        self.enclosed: dict[str, Enclosed] = {}
        self.absurd = ""
        super().__init__(symbols)

    def branch(self) -> Self:
        """Return a copy for a case, which writes after it."""
        other = super().branch()
        other.lines, other.premises, other.count, other.absurd = self.lines, self.premises, self.count, self.absurd
        other.hypotheses, other.units, other.leaves = dict(self.hypotheses), dict(self.units), dict(self.leaves)
        other.added, other.enclosed = [], dict(self.enclosed)
        return other

    def fresh(self) -> str:
        """Return a name of its own, which no symbol has."""
        self.count[0] += 1
        return f"h'{self.count[0]}"

    # -- texts

    def text_of(self, polynomial: Polynomial) -> str:
        """Return a polynomial as a formula."""
        names = [called(name) for name in self.field.places]
        terms = []
        for monomial, coefficient in sorted(polynomial.terms.items(), reverse=True):
            factors = [] if abs(coefficient) == 1 and monomial else [digits(abs(coefficient))]
            factors += [names[place] if n == 1 else f"{names[place]} ^ {n}" for place, n in powers_of(monomial)]
            terms.append(("- " if coefficient < 0 else "+ ") + " * ".join(factors))
        return " ".join(terms).removeprefix("+ ") or "0"

    def shown(self, element: Element) -> str:
        """Return an element as a formula in brackets."""
        above = [f"({self.text_of(element.numerator)})"]
        above += [self._raised(place, power) for place, power in element.exponents.items() if power > 0]
        below = [digits(element.denominator)] if element.denominator != 1 else []
        below += [self._raised(place, -power) for place, power in element.exponents.items() if power < 0]
        self._know_units(element)
        divisor = f" / ({' * '.join(below)})" if below else ""
        return f"({' * '.join(above)}{divisor})"

    def _raised(self, place: int, power: int) -> str:
        text = f"({self.text_of(self.field.factors[place])})"
        return text if power == 1 else f"{text} ^ {power}"

    # -- facts and their proofs

    def _ratio(self, relation: str, element: Element) -> tuple[str, str, str]:
        """Return P, K and M, where the element times K is P times M, and P stands in the fact."""
        fact = self.fact(relation, element)
        parity = relation in (">", ">=")
        numerator, powers = element.cancelled()
        kept = {place: power if power > 0 else -power % 2 * parity for place, power in powers.items()}
        whole = numerator * self.field.powers({place: power for place, power in kept.items() if power})
        monomial = max(whole.terms)
        scale = whole.terms[monomial] // fact.polynomial.terms[monomial]
        factors = [digits(element.denominator)]
        for place, power in powers.items():
            missing = kept[place] - power
            if missing:
                half = self._raised(place, missing // 2)
                factors.append(f"({half} * {half})" if missing % 2 == 0 else self._raised(place, missing))
        multiple = digits(scale) if scale > 0 else f"(- {digits(-scale)})"
        self._know_units(element)
        return self.text_of(fact.polynomial), " * ".join(factors), multiple

    def _know_units(self, element: Element) -> None:
        for place, power in element.exponents.items():
            if power < 0 and place not in self.units:
                self.units[place] = self._unit(self.field.factors[place])

    def _unit(self, factor: Polynomial) -> str:
        for fact in self.hypotheses:
            if fact.relation in ("!=", ">") and (rest := fact.polynomial.quotient(factor)) is not None:
                name, proof = self.fresh(), self._of_fact("!=", Fact("!=", fact.polynomial))
                whole, other = self.text_of(fact.polynomial), self.text_of(rest)
                stated = f"factor_nonzero ({whole}) ({self.text_of(factor)}) ({other})"
                self.lines.append(
                    f"assert ({self.text_of(factor)} <> 0) as {name} by (refine ({stated} {proof} _); ring)."
                )
                return name
        raise NotExportable("it is not known that a divisor is not zero")

    def enter(self, relation: str, element: Element, proof: str, rewriting: str = "") -> None:
        """Write down a fact with its proof, unless it is there or is evident."""
        fact = self.fact(relation, element)
        if fact in self.hypotheses or (fact.polynomial.is_constant() and self.holds(relation, element)):
            return
        if not element.numerator:
            part, multiple, scale = "0", "1", "1"
        else:
            part, multiple, scale = self._ratio(relation, element)
        name = self.fresh()
        sides = {"=": "nonzero", "!=": "nonzero"}.get(relation, "positive")
        more = f" | {sides}" if relation in (">", ">=") else ""
        self.lines.append(
            f"assert ({SIGNS[relation].format(f'({part})')}) as {name}.\n"
            f"{{ refine ({LEMMAS[relation]}_from _ ({multiple}) ({part}) {scale} ({proof}) _ _{' _' * bool(more)}); "
            f"[{rewriting}matching | {sides}{more}]. }}"
        )
        if fact.polynomial.is_constant():
            self.absurd = name
        else:
            self.hypotheses[fact] = name

    def _of_fact(self, relation: str, fact: Fact) -> str:
        """Return a proof of a fact as it is known."""
        if fact.polynomial.is_constant():
            text = SIGNS[relation].format(f"({self.text_of(fact.polynomial)})")
            return f"(ltac:(lra) : {text})"
        if fact in self.hypotheses:
            return self.hypotheses[fact]
        polynomial, opposite = fact.polynomial, -fact.polynomial
        if (proof := self.hypotheses.get(Fact(">", polynomial))) and relation in ("!=", ">="):
            return f"({'positive_nonzero' if relation == '!=' else 'positive_nonnegative'} _ {proof})"
        if (proof := self.hypotheses.get(Fact(">", opposite))) and relation == "!=":
            texts = f"({self.text_of(polynomial)}) ({self.text_of(opposite)})"
            return f"(opposite_nonzero {texts} {proof} ltac:(ring))"
        raise KeyError(fact)

    def proof(self, relation: str, element: Element, text: str = "", rewriting: str = "") -> str:
        """Return the name of a proof that something is so related to zero; its text may be given."""
        text = text or self.shown(element)
        if not element.numerator:
            zero = self.asserted(f"{text} = 0", f"{rewriting}matching.")
            return zero if relation == "=" else f"(zero_nonnegative _ {zero})"
        try:
            known = self._of_fact(relation, self.fact(relation, element))
        except KeyError:
            if relation == ">":
                parts = [self.proof(weaker, element, text, rewriting) for weaker in (">=", "!=")]
                return f"(both_positive _ {' '.join(parts)})"
            if relation == ">=" and self.holds("=", element):
                return f"(zero_nonnegative _ {self.proof('=', element, text, rewriting)})"
            raise NotExportable(f"it is not known that it is {relation} 0") from None
        part, multiple, scale = self._ratio(relation, element)
        sides = "nonzero" if relation in ("=", "!=") else "positive"
        more = f" | {sides}" if relation in (">", ">=") else ""
        return self.asserted(
            SIGNS[relation].format(text),
            f"refine ({LEMMAS[relation]}_from ({part}) {scale} {text} ({multiple}) {known} _ _{' _' * bool(more)}); "
            f"[{rewriting}matching | {sides}{more}].",
        )

    def asserted(self, text: str, tactics: str) -> str:
        """Write down what some tactics prove; return its name."""
        name = self.fresh()
        self.lines.append(f"assert ({text}) as {name}.\n{{ {tactics} }}")
        return name

    # -- what is added

    def add(self, relation: str, element: Element) -> None:
        """Enter what is known to hold, and remember it for the lemma that shows it."""
        fact = self.fact(relation, element)
        evident = fact.polynomial.is_constant() and self.holds(relation, element)
        self.added.append(Added(relation, element, not evident and fact not in self.known))
        super().add(relation, element)

    def concluded(self, lemma: str) -> None:
        """Write down what was added since `adding` began, as the parts of what a lemma shows."""
        added, self.added = self.added, []
        if not any(each.new for each in added):
            return
        parts = [self.fresh() for _ in added]
        pattern = parts[-1]
        for part in reversed(parts[:-1]):
            pattern = f"[{part} {pattern}]"
        self.lines.append(
            f"destruct ({lemma}) as {pattern}." if len(parts) > 1 else f"pose proof ({lemma}) as {pattern}."
        )
        for each, part in zip(added, parts, strict=True):
            if each.new:
                self.enter(each.relation, each.element, part)

    @contextmanager
    def adding(self) -> Iterator[None]:
        """Collect what is added by itself."""
        outer, self.added = self.added, []
        yield
        self.added = outer

    @property
    def pi(self) -> Element:
        """The number pi."""
        with self.adding():
            found = super().pi
            if self.added:
                self.concluded("facts_of_pi")
        return found

    # -- functions

    def _symbol(self, application: Application) -> Element:
        found = super()._symbol(application)
        name = called(f"_{len(self.applications)}")
        value = self.applied_text(application, [self.shown(arg) for arg in application.args])
        self.lines.append(f"assert (exists v'0, v'0 = {value}) as [{name} d{name}] by (eexists; reflexivity).")
        return found

    def applied_text(self, application: Application, args: Sequence[str]) -> str:
        """Return an application as a formula."""
        if application.function == "root":
            return root(args[0], application.degree)
        return f"({APPLIED[application.function]} {' '.join(args)})"

    def name(self, function: str, *args: Element, degree: int = 0) -> str:
        """Return what the value of a function that is known to be defined is called."""
        for name, known in self.applications.items():
            if (known.function, known.degree) == (function, degree) and all(
                (a - b).is_zero for a, b in zip(known.args, args, strict=True)
            ):
                return called(name)
        raise NotExportable(f"a {function} is not known to be defined")

    def _new(self, application: Application, granted: bool) -> Element:
        function, degree, args = application
        with self.adding():
            found = super()._new(application, granted)
            if self.added:
                self.concluded(self._facts(function, degree, args))
        return found

    def _facts(self, function: str, degree: int, args: Sequence[Element]) -> str:
        """Return the lemma with the facts of a function; those of a cosine are with its sine."""
        value, texts = self.name(function, *args, degree=degree), [self.shown(arg) for arg in args]
        u = args[0]
        if function == "sin":
            cos = self.name("cos", u)
            return f"facts_of_sin {value} {cos} {texts[0]} d{value} d{cos}"
        if function == "root":
            strict = self.added[0].relation == ">"
            radicand = self.proof(">" if strict else ">=", u)
            kind = f"sqrt {value}" if degree == 2 else f"root {degree - 1} {value}"
            return f"{'strictly' if strict else 'facts'}_of_{kind} {texts[0]} d{value} {radicand}"
        more = []
        if function in ("asin", "atan", "atan2"):
            arc = self.field.symbol(next(n for n in self.applications if called(n) == value))
            sin, cos = self.name("sin", arc), self.name("cos", arc)
            given = f"d{value} d{sin} d{cos}"
            if function == "asin":
                more = [self.proof(">=", self.number(1) - u * u, f"(1 - {texts[0]} * {texts[0]})")]
            elif function == "atan2":
                y, x = texts
                more = [self.proof("!=", u * u + args[1] * args[1], f"({y} * {y} + {x} * {x})")]
            return f"facts_of_{function} {value} {sin} {cos} {' '.join(texts)} {given} {' '.join(more)}"
        if function == "log":
            more = [self.proof(">", u)]
        return f"facts_of_{function} {value} {texts[0]} d{value} {' '.join(more)}"

    # -- terms of the statement

    def _ask(self, relation: str, element: Element, about: str, granted: bool) -> None:
        if not granted:
            super()._ask(relation, element, about, granted)
            return
        fact = self.fact(relation, element)
        if fact in self.known or (fact.polynomial.is_constant() and self.holds(relation, element)):
            return
        proof, rewriting = self._premise(relation, element)
        if not proof and self.holds(relation, element):
            proof = self.proof(relation, element)
        if not proof:
            text = SIGNS[relation].format(f"({self.text_of(fact.polynomial)})")
            self.hypotheses[fact] = self.asserted(text, "evident.")
        else:
            self.enter(relation, element, proof, rewriting)
        Theory.add(self, relation, element)

    def _premise(self, relation: str, element: Element) -> tuple[str, str]:
        for (asked, term), proof in self.premises:
            if asked == relation and self._is_made(term) and (self.term(term) - element).is_zero:
                return proof, self.rewriting(term)
        return "", ""

    def _is_made(self, term: Term) -> bool:
        """Whether a term is a polynomial in terms that were met."""
        plain = term.kind in ("number", "symbol", "pi", "+", "-", "*") or (
            term.kind == "^" and term.value.denominator == 1 and term.value > 0
        )
        return term in self._terms or (plain and all(map(self._is_made, term.args)))

    def given(self, condition: Condition, proof: str) -> None:
        """Enter what is assumed."""
        relation, term = condition
        element = self.term(term, granted=True)
        self.enter(relation, element, proof, self.rewriting(term))
        Theory.add(self, relation, element)

    def _made(self, term: Term, granted: bool) -> Element:
        if term.kind == "abs":
            square = raised(term.args[0], 2)
            self.premises = [*self.premises, ((">=", square), f"(pow2_ge_0 {formula(term.args[0])})")]
        if term.kind == "asinh":
            argument, u = expanded(term)[0].args[0], formula(term.args[0])
            radicand = argument.args[1].args[0]
            known = [((">=", radicand), f"(area_radicand {u})"), ((">", argument), f"(area_argument {u})")]
            self.premises = [*self.premises, *known]
        found = super()._made(term, granted)
        if granted and term.args and term.kind not in "+-*/":
            self._leaf(term)
        return found

    def _leaf(self, term: Term) -> None:
        """Write down which value a function of the statement is."""
        kind = term.kind
        if kind == "^":
            if term.value.denominator == 1:
                return
            value = self.name("root", self.term(term.args[0]), degree=term.value.denominator)
            text = root(formula(term.args[0]), term.value.denominator)
        elif kind in _DEFINED:
            text, definition = formula(term), formula(expanded(term)[0])
            if text not in self.leaves:
                self.leaves[text] = self.asserted(f"{text} = {definition}", f"{_DEFINED[kind]}.")
            return
        elif kind in APPLIED and expanded(term)[0] is term:
            value, text = self.name(kind, *map(self.term, term.args)), formula(term)
        else:
            return
        if text in self.leaves:
            return
        known = next(known for name, known in self.applications.items() if called(name) == value)
        same = self.applied_text(known, [self.shown(arg) for arg in known.args])
        inside = "".join(map(self.rewriting, term.args))
        self.leaves[text] = self.asserted(
            f"{text} = {value}", f"transitivity {same}; [f_equal; {inside}matching | symmetry; exact d{value}]."
        )

    def rewriting(self, term: Term) -> str:
        """Return the tactics that put names of values for the functions of a term, the outer ones first."""
        met: dict[str, None] = {}
        for part in _with_definitions(term):
            if part.args:
                texts = [formula(part)]
                if part.kind == "^":
                    texts = [root(formula(part.args[0]), part.value.denominator)]
                met |= {text: None for text in texts if text in self.leaves}
        ordered = [text for text in reversed(self.leaves) if text in met]
        return "".join(f"rewrite ?{self.leaves[text]}; " for text in ordered)


def _with_definitions(term: Term) -> Iterator[Term]:
    for part in term.parts():
        yield part
        definition = expanded(part)[0]
        if definition is not part:
            yield from _with_definitions(definition)
