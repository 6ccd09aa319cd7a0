"""Measurements: speed (`bench`), completeness (`recall`) and growth of the derivation (`links`)."""
