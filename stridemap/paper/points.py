"""The points of parameter space, and the groups of cycles, that the paper speaks of."""

ALPHAS, OMEGAS = (0.25, 0.5), (2.0, 3.0)
"""Mass ratios and oscillator frequencies at which the paper varies the spring stiffness."""

GROUPS = "ABCDE"
"""The groups that the paper names."""

TYPICAL = {"A": 0.5, "B": 6.0, "C": 22.5}
"""Spring stiffness of the typical solution of a group."""

PLANE = {"alpha": 0.25, "omega": 3.0}
"""Where the typical solutions are."""

KEPT = {"k": tuple(TYPICAL.values()), "alpha": ALPHAS, "omega": OMEGAS}
"""Values that a report leaves in where it leaves others out."""

GROUPS_FOUND = "III-A, Obtained solution groups"
PERFORMANCE = "III-B, Walking performances"
DEPENDENCY = "IV-A, Parameter dependency of the model"
ACTUAL = "IV-C, Relationship between model and actual walking"
"""Sections of the paper that make the statements."""
