"""Measurements: speed (`bench`) and completeness (`recall`)."""
