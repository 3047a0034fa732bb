r"""Letters and signs of Unicode, as LaTeX writes them: ``α`` is ``\alpha``, and ``x̂`` is ``\hat{x}``."""

import unicodedata
from collections.abc import Iterable

from algebroproj_sym.reading.documents.pending import braced, renamed
from algebroproj_sym.reading.lexing.pieces import Piece

_OF_UNICODE = (
    "α#alpha β#beta γ#gamma δ#delta ε#varepsilon ζ#zeta η#eta θ#theta ι#iota κ#kappa λ#lambda μ#mu ν#nu ξ#xi π#pi "
    "ρ#rho σ#sigma τ#tau υ#upsilon φ#varphi ϕ#phi χ#chi ψ#psi ω#omega Γ#Gamma Δ#Delta Θ#Theta Λ#Lambda Ξ#Xi Π#Pi "
    "Σ#Sigma Φ#Phi Ψ#Psi Ω#Omega ϵ#epsilon ×#times ·#cdot ⋅#cdot ≤#le ≥#ge ≠#ne ±#pm ∓#mp ∂#partial ∇#nabla ∞#infty "
    "≈#approx ≡#equiv ∈#in →#to ⇒#Rightarrow ⇔#Leftrightarrow ∥#| ∑#sum ∫#int ∏#prod ℓ#ell ∝#propto "
    "⋮#vdots ⋯#cdots …#ldots ∧#wedge ⊗#otimes ⊕#oplus ⊙#odot ⟂#perp ⊥#perp"
)
SIGNS_OF_UNICODE = {sign: rf"\{name}" for sign, _, name in (pair.partition("#") for pair in _OF_UNICODE.split())}
_ACCENTS = {
    "\u0302": r"\hat",
    "\u0303": r"\tilde",
    "\u0304": r"\bar",
    "\u0305": r"\bar",
    "\u0307": r"\dot",
    "\u0308": r"\ddot",
    "\u030c": r"\check",
    "\u20d7": r"\vec",
}
"""The marks that Unicode writes above the letter before them."""
SIGNS_OF_UNICODE |= {
    "°": r"^\circ",
    "′": "'",
    "’": "'",
    "″": "''",
    "½": r"\frac{1}{2}",
    "¼": r"\frac{1}{4}",
    "¾": r"\frac{3}{4}",
}
SIGNS_OF_UNICODE |= {sign: f"^{number}" for number, sign in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")}
SIGNS_OF_UNICODE |= {sign: f"_{number}" for number, sign in enumerate("₀₁₂₃₄₅₆₇₈₉")}


def accented(pieces: Iterable[Piece]) -> list[Piece]:
    """Return pieces in which a letter with a mark of Unicode above it is one with an accent."""
    found: list[Piece] = []
    for piece in pieces:
        letter, mark = piece.text[:-1], piece.text[-1]
        if (
            len(piece.text) == 1
            and len(parts := unicodedata.normalize("NFD", piece.text)) == 2
            and parts[1] in _ACCENTS
        ):
            letter, mark = parts[0], parts[1]
        if mark in _ACCENTS and (letter or found):
            base = [renamed(piece, letter)] if letter else [found.pop()]
            found += [renamed(piece, _ACCENTS[mark]), *braced(piece, base)]
        else:
            found.append(piece)
    return found
