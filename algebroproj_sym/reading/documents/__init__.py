"""Documents: a file becomes `displays`, with its `macros` expanded; a display becomes `statements`."""
