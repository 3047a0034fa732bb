"""Lexing: LaTeX as pieces, and pieces as the tokens of the grammar.

A text becomes `pieces`.  A `cursor` goes through them, and `tokens` reads one after the other: `names` of letters, also
with scripts before them (`prescripts`), `functions`, and `brackets`.  `commands` lists what LaTeX has words for.
"""
