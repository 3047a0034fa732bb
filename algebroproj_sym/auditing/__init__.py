"""Auditing: what claims say is printed, held against the words and the LaTeX of the papers.

A quote is looked up in the paper's file (`scans`) and read with the paper's tables of symbols.  What it reads must be
what the claim says is printed, symbol by symbol (`audit`).
Which claims quote which line of a paper, `coverage` tells.
"""
