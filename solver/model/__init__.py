"""Generated walkers, loaded."""
