"""A. Okamoto, Orientation and Construction of Models, Part I: The Orientation Problem in Close-Range Photogrammetry, 1981."""
