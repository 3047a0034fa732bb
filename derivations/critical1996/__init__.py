"""G. Brandstätter, on critical configurations of projective stereo correlation, 1996: what survives of it."""
