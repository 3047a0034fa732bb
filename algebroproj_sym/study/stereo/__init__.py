"""The chain from two images to a model of the object, and how near it is to what makes it fail."""
