"""The geometry of two images: scenes, the chain to the model, and the quadrics on which the linear equations fail."""
