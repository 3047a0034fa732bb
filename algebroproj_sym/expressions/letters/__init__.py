"""Expressions in letters: vectors and matrices that are named, not written out.

`notation` has what SymPy's matrix expressions lack, `terms` the one form that everything is read into.
"""

from algebroproj_sym.expressions.letters.notation import (
    Adjugate,
    BigAdjoint,
    Cross,
    Directional,
    Dot,
    Exponential,
    Hat,
    LeftJacobian,
    LeftPerturbed,
    LittleAdjoint,
    Norm,
    Outer,
    Pure,
    QuaternionConjugate,
    QuaternionProduct,
    RightJacobian,
    RightPerturbed,
    RotationOf,
    Skew,
    Vec,
    VectorPart,
    Vee,
)
from algebroproj_sym.expressions.letters.parsing import parse_letters
from algebroproj_sym.expressions.letters.reading import Reading
from algebroproj_sym.expressions.letters.terms import (
    ONE,
    LetterError,
    Shape,
    Size,
    Term,
    factors_of,
    made,
    minus,
    number,
)
from algebroproj_sym.expressions.letters.writing import letters_text
