"""G. Brandstätter, Notes on the direct projective transformation of general stereo pairs, 1992."""
