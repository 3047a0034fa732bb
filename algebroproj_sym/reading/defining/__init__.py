"""Defining: what letters stand for.

The `symbols` file, the `phrases` of a document and its definitions make a `vocabulary`; equations above a relation and
derivatives are `premises` of it.
"""
