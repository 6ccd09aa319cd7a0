"""Numerics on generated equations: step map, limit cycles, Floquet multipliers, measures, search.

`model` loads a generated walker; `runge_kutta` and `step_map` build the straight-line functions that
`kernels` gathers and prints as C; `lockstep` makes them work on several points an instruction; `compiler`
compiles and `library` loads them (or runs them in CasADi's virtual machine); `limit_cycle`, `floquet`,
`measures`, `search` and `continuation` work on arrays of points; `simulate` walks with an event-driven
integrator that shares nothing with the rest, to check it.
"""
