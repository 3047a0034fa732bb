"""What happens to the generated functions near singularities, with how many digits, for which uncertainty of the input.

The modules are imported by name: `precision` and `ladder` (any arithmetic, certified values), `conditioning` and
`propagation` (derivatives and errors), and the folders `stereo` (the chain from images to the model) and `studies`.
"""
