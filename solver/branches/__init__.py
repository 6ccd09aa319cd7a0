"""Everything that follows limit cycles over parameters."""
