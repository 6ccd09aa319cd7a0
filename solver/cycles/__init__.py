"""Limit cycles: Newton's method, acceptance, multipliers, search."""
