"""What prints a straight-line program, one language a file."""
