"""Documents: a file becomes `displays`, with its `macros` and `environments` expanded, and these `statements`."""
