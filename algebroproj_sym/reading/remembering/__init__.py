"""Remembering: what the document has said up to an equation.

`survey` is what is known of the whole document before its equations are read in order, and `sections` what letters are
in each section.  `memory` is what was said so far, and `standing` what of it holds where an equation stands.  `hearing`
takes in the words beside an equation, and `keeping` the equation itself.  `introducing` says which equations define a
letter.  Formulas `within` the text and the `surroundings` of a display say more, also on derivatives that are zero
(`stationary`).
"""
