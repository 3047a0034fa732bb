"""Parsing: tokens become a tree of the `grammar`, and a tree an expression.

An expression is made by value, in the order of print (`ordering`), or with `matrices` as letters.
"""
