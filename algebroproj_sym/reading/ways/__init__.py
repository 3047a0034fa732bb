"""Ways: each module has a way in which a relation may follow from what stands above it.

`trying` lists them.  A relation may follow with equations above it put in (`substituting`), under these
(`constraining`), with what its sentence supposes (`supposing`), with letters for other formulas (`renaming`), by
`components`, or as matrices of `quaternions`; with what is usually taken for granted of letters (`assuming`), at
another index (`indexing`), by roots and inverse functions (`inverting`), as `fields`, or as `solutions` of
differential equations.
"""
