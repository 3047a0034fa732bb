"""Numerical studies of what the papers derive: one module a study; `stereo` is the geometry that they share."""
