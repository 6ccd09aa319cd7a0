"""How a search for a limit cycle ended."""

from enum import StrEnum

import numpy as np


class Status(StrEnum):
    """How a search for a limit cycle ended."""

    CONVERGED = "converged"
    """A limit cycle, closed to 1e-11, with an integration error below 1e-9 and a state error below 1e-10."""
    INACCURATE = "inaccurate"
    """A limit cycle whose integration error or state error stays above these, whatever the resolution."""
    NOT_CONVERGED = "not_converged"
    """Newton's method did not close the cycle."""
    UNRESOLVED = "unresolved"
    """Newton's method nearly closed it, but the finest resolution does not resolve the motion."""
    NOT_A_STEP = "not_a_step"
    """Closed, but not at a descending foot ahead of the hip, or the walker falls over during the step."""
    LATER_TOUCHDOWN = "later_touchdown"
    """Closed, but an earlier touchdown would have ended the step."""
    OUT_OF_RANGE = "out_of_range"
    """Closed, with a period outside the range that was asked for."""

    @property
    def found(self) -> bool:
        """Whether it is a limit cycle."""
        return self in (Status.CONVERGED, Status.INACCURATE)

    @property
    def reason(self) -> str:
        """Why it is not a limit cycle in a few words; empty for one."""
        return _REASONS.get(self, "")

    @property
    def code(self) -> int:
        """Its number in arrays."""
        return CODES[self]


_REASONS = {
    Status.NOT_CONVERGED: "Newton's method did not close it",
    Status.UNRESOLVED: "nearly closed, but the motion changes too suddenly for the finest resolution",
    Status.NOT_A_STEP: "closed, but not as a step: the foot does not descend ahead, or the walker falls over",
    Status.LATER_TOUCHDOWN: "closed, but an earlier touchdown ends the step",
    Status.OUT_OF_RANGE: "closed, with a period outside the range that was asked for",
}

STATUSES = np.array(list(Status), dtype=object)
"""Every status at its code."""

CODES = {status: code for code, status in enumerate(Status)}

FOUND = tuple(code for status, code in CODES.items() if status.found)
"""Codes of limit cycles."""
