"""The geometry of two images: scenes, their images, and the quadrics on which the linear equations fail."""
