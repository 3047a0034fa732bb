"""Prose: what the words of a document say, as far as they are heard.

`devices` is the table of all phrases that are heard.  `sentences` finds the words beside an equation.  They name what
letters are (`phrases`, `describing`), what is done to them (`acting`, `renaming`), and where an equation holds
(`contexts`, `scopes`, `supposing`).  They also say that an equation is a wish or a condition (`conditions`), or that it
follows (`words`).
"""
