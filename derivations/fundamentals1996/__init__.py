"""G. Brandstätter, Fundamentals of Algebro-Projective Photogrammetry, 1996."""
