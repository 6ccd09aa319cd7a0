"""The straight-line functions that the solver runs, and their C."""
