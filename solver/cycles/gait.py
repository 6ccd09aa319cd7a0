"""Which limit cycles are gaits that a walker could walk."""

from typing import Any


def is_physical_gait(orbit: Any) -> Any:
    """Whether a cycle counts: converged, forward, and with a stance foot that never pulls at the ground.

    Parameters
    ----------
    orbit : Orbit, Orbits or DataFrame
        One cycle; or many, also as rows of ``orbits.parquet``: then the answer is an array, or a column.
    """
    return (orbit.status == "converged") & (orbit.step_length > 0) & (orbit.min_vertical_force > 0)
