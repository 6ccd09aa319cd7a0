"""The statements of the paper (Kamimura and Sano, ICRA 2023), decided by computed limit cycles.

`data` sweeps what the statements are about, `profiles`, `branch` and `edges` add what the tables of a sweep
do not hold, and each statement is a function of these tables in `gaits`, `stability` or `measures`.
"""
