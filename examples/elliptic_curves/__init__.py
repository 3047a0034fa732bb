"""Elliptic curves: the group law, its formulas in the usual coordinates, and the maps between the usual forms.

What is "printed" here is what textbooks and standards print, and some wrong variants that are often met.
"""
