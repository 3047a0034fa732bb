"""Parsing: tokens become a tree of the `grammar`, which becomes an expression or text (`evaluating`, `writing`).

An expression is made by value, in the order of print (`ordering`), or with `matrices` as letters.
"""
