"""Lines of parameter space: one parameter varies along each, and all others keep their values."""

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.cycles.orbits import Orbits

Array = NDArray[np.float64]
Index = NDArray[np.int64]


def values_of(orbits: Orbits, parameter: str) -> Array:
    """The value of one parameter at each cycle, shape (n,)."""
    return orbits.params[:, orbits.model.spec.names.index(parameter)]


def line_numbers(orbits: Orbits, parameter: str) -> Index:
    """The number of the line along `parameter` on which each cycle lies, shape (n,).

    Lines are numbered by the values of the other parameters, which are compared in the model's order.
    """
    others = np.delete(orbits.params, orbits.model.spec.names.index(parameter), axis=1)
    return np.unique(others, axis=0, return_inverse=True)[1].reshape(-1)


def group_numbers(orbits: Orbits, parameter: str) -> Index:
    """The number of the line and group to which each cycle belongs, shape (n,).

    Groups of one line follow one another by their names; a model without groups has one on each line.
    """
    name = np.unique(orbits.group.astype(str), return_inverse=True)[1].reshape(-1)
    return line_numbers(orbits, parameter) * (1 + name.max(initial=0)) + name
