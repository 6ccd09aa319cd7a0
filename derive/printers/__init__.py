"""Printers of straight-line programs: one file for each language."""
