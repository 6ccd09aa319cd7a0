"""Many steps forward."""
