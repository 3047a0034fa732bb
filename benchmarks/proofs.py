"""Our prover beside other ways to decide identities: the same 50 claims, one after the other, in one run.

Run with ``python benchmarks/proofs.py``.  Each way has the same time limit for each claim, in a process of its own that
is killed when it is over; the time is that of the decision alone, without start and import, but for Singular (Debian:
singular-ui), which is started for each claim and gets both sides as text, in steps, in its field over Q.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import time
from collections.abc import Callable, Sequence
from multiprocessing import get_context
from typing import Any

import sympy
from sympy.polys.domains import QQ, ZZ
from sympy.polys.fields import field

from algebroproj_sym.declaring import Claim, select
from algebroproj_sym.declaring.claim import in_derived_terms
from algebroproj_sym.expressions import divided, entries, evaluate, in_steps, symbols_of
from algebroproj_sym.proving import prove

CLAIMS = 50
LIMIT = 10.0

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


WAYS: dict[str, Decide] = {
    "algebroproj (FLINT)": ours,
    "together, expand": by_sympy(lambda e: sympy.expand(sympy.fraction(sympy.together(e))[0])),
    "ratsimp": by_sympy(sympy.ratsimp),
    "simplify": by_sympy(sympy.simplify),
    "field over ZZ": by_field(ZZ),
    "field over QQ": by_field(QQ),
    **({"Singular": by_singular} if shutil.which("Singular") else {}),
}


def serve(connection: Any, way: str) -> None:
    """Decide claims that come in, and send back the decision and the time it took."""
    connection.send("ready")
    while True:
        claim = connection.recv()
        start = time.perf_counter()
        try:
            decided = WAYS[way](claim)
        except Exception as error:
            connection.send((type(error).__name__, time.perf_counter() - start))
        else:
            connection.send(("proved" if decided else "not", time.perf_counter() - start))


def decisions(way: str, claims: Sequence[Claim], limit: float) -> list[tuple[str, float]]:
    """Return what became of each claim, and the seconds it took."""
    found: list[tuple[str, float]] = []
    process = connection = None
    for claim in claims:
        if process is None:
            connection, other = get_context("spawn").Pipe()
            process = get_context("spawn").Process(target=serve, args=(other, way), daemon=True)
            process.start()
            connection.recv()
        connection.send(claim)
        if connection.poll(limit):
            found.append(connection.recv())
        else:
            found.append(("too long", limit))
            process.kill()
            process = None
    if process is not None:
        process.kill()
    return found


def chosen() -> list[Claim]:
    """Return proved identities without constraints, evenly from all papers."""
    identities = [claim for claim in select() if claim.kind == "identity" and claim.expected == "proved"]
    return identities[:: len(identities) // CLAIMS][:CLAIMS]


def main() -> None:
    """Print a row for each way: how many are proved within the limit, the time of all, the median and the longest."""
    claims = chosen()
    print(f"{len(claims)} identities, at most {LIMIT:g} s each")
    reference: list[float] = []
    for way in WAYS:
        found = decisions(way, claims, LIMIT)
        times = sorted(seconds for _, seconds in found)
        proved = sum(verdict == "proved" for verdict, _ in found)
        reference = reference or [seconds for _, seconds in found]
        ahead = sum(seconds < ours for (_, seconds), ours in zip(found, reference, strict=True))
        others = sorted({verdict for verdict, _ in found} - {"proved"})
        print(
            f"{way:<20} {proved:3} proved, {sum(times):8.2f} s in all, median {1000 * times[len(times) // 2]:7.1f} ms, "
            f"longest {times[-1]:6.2f} s, faster than the first on {ahead} {', '.join(others)}",
            flush=True,
        )


if __name__ == "__main__":
    main()
