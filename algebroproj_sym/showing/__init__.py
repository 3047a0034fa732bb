"""Showing: claims and their evidence as text and as LaTeX, in the order and with the names of the author."""
