"""Bridges: where the papers overlap, and how their terms translate into those of the textbooks."""
