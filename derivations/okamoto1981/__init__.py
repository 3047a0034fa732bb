"""A. Okamoto, Orientation and Construction of Models, Part I: The Orientation Problem, 1981."""
