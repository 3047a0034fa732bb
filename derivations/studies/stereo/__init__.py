"""The geometry of two images: scenes, critical quadrics, and the chain from the images to a model of the object."""
