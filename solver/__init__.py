"""Numerics on generated equations: limit cycles, multipliers, measures, branches, walks.

`model` loads a generated walker; `kernels` builds the straight-line functions and prints them as C;
`backends` run them on arrays of points; `observables` finds events and measures; `cycles` finds limit
cycles; `branches` follows them over parameters; `walks` takes many steps with an event-driven integrator
that shares nothing with the rest, to check it; `api` is what users call for one point.
"""
