"""G. Brandstätter, Notes on the direct projective transformation of general stereo pairs into the rigorous normal case by image correlation, 1992."""
