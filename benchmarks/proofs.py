"""Our prover beside other ways to decide identities: the same 50 claims, one after the other, in one run.

Run with ``python benchmarks/proofs.py [ROUNDS]``; the ways take turns, each round (of three) in new processes, and the
shortest time of each claim counts.  Each way has the same limit for each claim.  Limit and time are processor time of
the decision alone, without start and import, but for Singular (Debian: singular-ui), which is started for each claim
and gets both sides as text, in steps, in its field over Q.  SymPy keeps no results from one claim to the next.  Its
polynomials are measured over integers of Python, of GMP (gmpy2) and of FLINT, if these are installed.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from multiprocessing import get_context
from typing import Any

import sympy
from sympy.core.cache import clear_cache
from sympy.polys.domains import QQ, ZZ
from sympy.polys.fields import field
from sympy.polys.rings import ring

from algebroproj_sym.declaring import Claim, select
from algebroproj_sym.declaring.claim import in_derived_terms
from algebroproj_sym.expressions import divided, entries, evaluate, over, symbols_of
from algebroproj_sym.proving import prove

CLAIMS = 50
LIMIT = 10.0
ROUNDS = 3
WALL = 10
"""How many times the limit a claim may take on the clock."""

_SUM, _PRODUCT, _POWER, _ATOM = range(4)

Decide = Callable[[Claim], bool]


def sides(claim: Claim) -> list[tuple[Any, Any]]:
    """Return the entries of both sides, the printed one in the terms of the derived one."""
    return list(zip(entries(in_derived_terms(claim.printed, claim.where)), entries(claim.derived), strict=True))


def ours(claim: Claim) -> bool:
    """Decide by our prover, hypotheses and certificate included."""
    return prove(in_derived_terms(claim.printed, claim.where), claim.derived).verdict == "proved"


def by_sympy(reduce: Callable[[Any], Any]) -> Decide:
    """Decide by a function that must turn the difference into 0."""
    return lambda claim: all(reduce(divided(p) - divided(d)) == 0 for p, d in sides(claim))


def by_field(domain: Any) -> Decide:
    """Decide by SymPy's sparse rational functions over a domain."""

    def decide(claim: Claim) -> bool:
        symbols = symbols_of([e for pair in sides(claim) for e in pair])
        ground = field([s.name for s in symbols] or ["unused"], domain)[0]
        point = dict(zip(symbols, ground.gens, strict=False))
        lift = lambda q: ground(q.numerator) / ground(q.denominator)  # noqa: E731
        return all(evaluate(p, point, lift) == evaluate(d, point, lift) for p, d in sides(claim))

    return decide


@dataclass(frozen=True)
class Quotient:
    """Two polynomials, never reduced."""

    numerator: Any
    denominator: Any

    def __add__(self, other: Quotient) -> Quotient:
        """Add over the product of both denominators, unless they are equal."""
        if self.denominator == other.denominator:
            return Quotient(self.numerator + other.numerator, self.denominator)
        crossed = self.numerator * other.denominator + other.numerator * self.denominator
        return Quotient(crossed, self.denominator * other.denominator)

    def __mul__(self, other: Quotient) -> Quotient:
        """Multiply numerators and denominators."""
        return Quotient(self.numerator * other.numerator, self.denominator * other.denominator)

    def __truediv__(self, other: Quotient) -> Quotient:
        """Multiply crosswise."""
        return Quotient(self.numerator * other.denominator, self.denominator * other.numerator)

    def __pow__(self, exponent: int) -> Quotient:
        """Raise both polynomials to a power."""
        return Quotient(self.numerator**exponent, self.denominator**exponent)


def by_ring(claim: Claim) -> bool:
    """Decide by SymPy's sparse polynomials over the rational numbers: fractions of them, multiplied crosswise."""
    symbols = symbols_of([e for pair in sides(claim) for e in pair])
    ground = ring([s.name for s in symbols] or ["unused"], QQ)[0]
    point = {s: Quotient(g, ground.one) for s, g in zip(symbols, ground.gens, strict=False)}
    lift = lambda q: Quotient(ground(QQ(q.numerator, q.denominator)), ground.one)  # noqa: E731
    pairs = [(evaluate(p, point, lift)[0], evaluate(d, point, lift)[0]) for p, d in sides(claim)]
    return all(p.numerator * d.denominator == d.numerator * p.denominator for p, d in pairs)


def in_steps(expression: Any) -> dict[str, list[str]]:
    """Return an expression as text that keeps every division, in steps that later ones refer to by ``$0``, ``$1``."""
    roots = entries(expression)
    uses = _uses(roots)
    written: dict[Any, tuple[str, int]] = {}
    steps: list[str] = []
    for root in roots:
        _write(root, uses, written, steps)
    return {"steps": steps, "entries": [written[root][0] for root in roots]}


def _uses(roots: Sequence[Any]) -> Counter[Any]:
    uses: Counter[Any] = Counter(roots)
    waiting = list(dict.fromkeys(roots))
    while waiting:
        for argument in waiting.pop().args:
            uses[argument] += 1
            if uses[argument] == 1:
                waiting.append(argument)
    return uses


def _write(node: Any, uses: Counter[Any], written: dict[Any, tuple[str, int]], steps: list[str]) -> None:
    if node in written:
        return
    for argument in node.args:
        _write(argument, uses, written, steps)
    text, rank = _text(node, written)
    if uses[node] > 1 and len(text) > 3 and rank != _ATOM:
        steps.append(text)
        text, rank = f"${len(steps) - 1}", _ATOM
    written[node] = text, rank


def _text(node: Any, written: dict[Any, tuple[str, int]]) -> tuple[str, int]:
    def within(argument: Any, least: int) -> str:
        text, rank = written[argument]
        return text if rank >= least else f"({text})"

    if isinstance(node, sympy.Add):
        return " + ".join(within(argument, _PRODUCT) for argument in node.args), _SUM
    if isinstance(node, sympy.Mul):
        return "*".join(within(argument, _POWER) for argument in node.args), _PRODUCT
    if isinstance(node, over):
        return f"{within(node.args[0], _POWER)}/{within(node.args[1], _POWER)}", _PRODUCT
    if isinstance(node, sympy.Pow):
        exponent = int(node.exp)
        return f"{within(node.base, _ATOM)}**{exponent if exponent >= 0 else f'({exponent})'}", _POWER
    text = str(node.name if isinstance(node, sympy.Symbol) else node)
    return text, _ATOM if text.isalnum() or not isinstance(node, sympy.Rational) else _SUM


def by_singular(claim: Claim) -> bool:
    """Decide by Singular, in its field of rational functions over Q."""
    symbols = symbols_of([e for pair in sides(claim) for e in pair])
    names = {symbol.name: f"v{place}" for place, symbol in enumerate(symbols)}
    lines = [f"ring r = (0,{','.join(names.values()) or 'v0'}),unused,dp; short = 0;"]
    for place, (p, d) in enumerate(sides(claim)):
        for side, expression in (("p", p), ("d", d)):
            written = in_steps(sympy.Matrix([expression]).as_immutable())
            texts = [*written["steps"], *written["entries"]]
            for step, text in enumerate(texts):
                text = re.sub(r"\$(\d+)", rf"{side}{place}s\1", text.replace("**", "^"))
                text = re.sub(r"[A-Za-z_]\w*", lambda m: names.get(m[0], m[0]), text)
                text = re.sub(r"\^\(-(\d+)\)", r"^-\1", text)
                lines.append(f"number {side}{place}s{step} = {text};")
            lines.append(f"number {side}{place} = {side}{place}s{len(texts) - 1};")
        lines.append(f'if (p{place} - d{place} != 0) {{ "differs"; }}')
    program = "\n".join([*lines, '"end";', "quit;"])
    done = subprocess.run(["Singular", "-q"], input=program, capture_output=True, text=True, check=True)
    answers = [line for line in done.stdout.splitlines() if line.strip() and not line.startswith("//")]
    if answers != ["end"]:
        raise ValueError(done.stdout[:300])
    return True


@dataclass(frozen=True)
class Way:
    """How to decide, and over which integers SymPy computes while it does."""

    name: str
    decide: Decide
    integers: str = "python"


INTEGERS = {"python": "Python", "gmpy": "GMP", "flint": "FLINT"}
INSTALLED = [name for name, module in (("python", "sys"), ("gmpy", "gmpy2"), ("flint", "flint")) if find_spec(module)]
WAYS = [
    Way("algebroproj", ours),
    Way("together, expand", by_sympy(lambda e: sympy.expand(sympy.fraction(sympy.together(e))[0]))),
    Way("ratsimp", by_sympy(sympy.ratsimp)),
    Way("simplify", by_sympy(sympy.simplify)),
    *(Way(f"ring over QQ, {INTEGERS[name]}", by_ring, name) for name in INSTALLED),
    *(Way(f"field over ZZ, {INTEGERS[name]}", by_field(ZZ), name) for name in INSTALLED),
    *(Way(f"field over QQ, {INTEGERS[name]}", by_field(QQ), name) for name in INSTALLED),
    *([Way("Singular", by_singular)] if shutil.which("Singular") else []),
]


def processor_time() -> float:
    """Return the processor time of this process and of those that it has waited for."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


def end(number: int, frame: Any) -> None:
    """Give a decision up."""
    raise TimeoutError


def serve(connection: Any, place: int) -> None:
    """Decide claims that come in, and send back the decision and the time it took."""
    signal.signal(signal.SIGPROF, end)
    connection.send("ready")
    while True:
        try:
            claim = connection.recv()
        except EOFError:
            return
        clear_cache()
        signal.setitimer(signal.ITIMER_PROF, LIMIT)
        start, precisely = processor_time(), time.process_time()
        try:
            decided = "proved" if WAYS[place].decide(claim) else "not"
        except Exception as error:
            decided = "too long" if isinstance(error, TimeoutError) else type(error).__name__
        signal.setitimer(signal.ITIMER_PROF, 0)
        spent = time.process_time() - precisely
        connection.send((decided, processor_time() - start if WAYS[place].decide is by_singular else spent))


class Server:
    """A process that decides claims in one way, and is started again after it was killed."""

    def __init__(self, place: int) -> None:
        self.place = place
        self.process: Any = None

    def decide(self, claim: Claim, limit: float) -> tuple[str, float]:
        """Return what became of a claim, and the seconds of processor time it took."""
        if self.process is None:
            self.start()
        self.connection.send(claim)
        if self.connection.poll(WALL * limit):
            decided, seconds = self.connection.recv()
            return (decided, seconds) if seconds <= limit else ("too long", limit)
        self.process.kill()
        self.process = None
        return "too long", limit

    def start(self) -> None:
        """Start the process with the integers that SymPy is to use."""
        self.connection, other = get_context("spawn").Pipe()
        os.environ["SYMPY_GROUND_TYPES"] = WAYS[self.place].integers
        self.process = get_context("spawn").Process(target=serve, args=(other, self.place), daemon=True)
        self.process.start()
        self.connection.recv()


def decisions(place: int, claims: Sequence[Claim]) -> list[tuple[str, float]]:
    """Return what became of each claim in one of the ways, and the seconds it took."""
    server = Server(place)
    return [server.decide(claim, LIMIT) for claim in claims]


def chosen() -> list[Claim]:
    """Return proved identities without constraints, evenly from all papers."""
    identities = [claim for claim in select() if claim.kind == "identity" and claim.expected == "proved"]
    return identities[:: len(identities) // CLAIMS][:CLAIMS]


def main() -> None:
    """Print a row for each way: how many are proved within the limit, the time of all, the median and the longest."""
    claims, rounds = chosen(), int(sys.argv[1]) if len(sys.argv) > 1 else ROUNDS
    found = [[decisions(place, claims) for place in range(len(WAYS))] for _ in range(rounds)]
    print(f"{len(claims)} identities, at most {LIMIT:g} s each, {rounds} rounds; SymPy {sympy.__version__}")
    print("| way | proved | too long | seconds in all | of the rounds | median, ms | longest, s | faster than ours |")
    print("|---|---|---|---|---|---|---|---|")
    reference: list[float] = []
    for place, way in enumerate(WAYS):
        of_rounds = [sum(seconds for _, seconds in one[place]) for one in found]
        verdicts = [verdict for verdict, _ in found[0][place]]
        times = [min(one[place][k][1] for one in found) for k in range(len(claims))]
        reference = reference or times
        ahead = sum(seconds < ours for seconds, ours in zip(times, reference, strict=True))
        spread = f"{min(of_rounds):.2f} to {max(of_rounds):.2f}"
        middle, longest = 1000 * sorted(times)[len(times) // 2], max(times)
        counts = f"{verdicts.count('proved')} | {verdicts.count('too long')}"
        print(
            f"| {way.name} | {counts} | {sum(times):.2f} | {spread} | {middle:.1f} | {longest:.2f} | {ahead} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
