"""Mutating: are the checks able to fail?  Single changes of claims and of generated functions must be noticed."""
