"""Generating: from a kernel to a straight-line program to NumPy source."""
