"""Limit cycles followed to other values of one parameter, in steps that halve where they fail.

Other than `stridemap.solver.branches.continuation`, this does not go around folds: a branch ends at one, and
every cycle on the way is converged and measured.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.branches.main_branch import fixed_point_index
from stridemap.solver.cycles.orbits import Orbits
from stridemap.solver.cycles.search import continued
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.scales import Scales
from stridemap.solver.options import SearchOptions

Array = NDArray[np.float64]
Index = NDArray[np.int64]

MAX_CHANGE = 0.05
"""Largest change from one cycle of a branch to the next, in any section coordinate or the period and in terms
of the model's scales."""

MAX_HALVINGS = 14
"""A branch ends where it does not go on in steps of 2^-MAX_HALVINGS of the whole distance."""


@dataclass(frozen=True)
class BranchPath:
    """The part of a branch from one cycle, which is left out, towards a value of the parameter.

    Parameters
    ----------
    orbits : Orbits
        Cycles in their order along the branch.
    reached : bool
        Whether the last of them is at the target; if not, the branch ends there.
    """

    orbits: Orbits
    reached: bool


def follow_parameter(
    solver: Solver, starts: Orbits, parameter: str, target: Array, options: SearchOptions | None = None
) -> list[BranchPath]:
    """Follow each of n limit cycles to its own target value of one parameter.

    A step is taken if it leads to a cycle of the same index (see `fixed_point_index`) that differs little,
    and is halved if not.

    Parameters
    ----------
    solver : Solver
    starts : Orbits, length n
    parameter : str
    target : ndarray, shape (n,)
    options : SearchOptions, optional
        Their period range holds.

    Returns
    -------
    list of BranchPath, length n
    """
    if not len(starts):
        return []
    column = solver.model.spec.names.index(parameter)
    scale = Scales.of(solver.model).unknowns
    index, begin, u = fixed_point_index(starts.multipliers), starts.params[:, column], starts.u.copy()
    done, step = np.zeros(len(u)), np.ones(len(u))  # as fractions of the whole distance
    slope = np.zeros_like(u)
    active = np.arange(len(u))
    owners, parts = [active[:0]], [starts.take(active[:0])]
    while len(active):
        ahead = done[active] + step[active]
        points = starts.params[active]
        points[:, column] = np.where(
            ahead == 1, target[active], begin[active] + ahead * (target - begin)[active]
        )
        found = continued(solver, points, u[active] + slope[active] * step[active, None], options)
        near = np.abs((found.u - u[active]) / scale).max(axis=1) < MAX_CHANGE
        good = found.found & near & (fixed_point_index(found.multipliers) == index[active])
        taken, failed = active[good], active[~good]
        slope[taken] = (found.u[good] - u[taken]) / step[taken, None]
        u[taken] = found.u[good]
        done[taken] += step[taken]
        step[failed] /= 2
        slope[failed] = 0  # near a fold a straight line leads astray
        owners.append(taken)
        parts.append(found.take(good))
        active = active[(done[active] != 1) & (step[active] >= 0.5**MAX_HALVINGS)]
    return _paths(np.concatenate(owners), Orbits.concatenate(solver.model, parts), done == 1)


def _paths(owner: Index, orbits: Orbits, reached: NDArray[np.bool_]) -> list[BranchPath]:
    """One path per start, from all that was found, round after round."""
    order = np.argsort(owner, kind="stable")
    ends = np.cumsum(np.bincount(owner, minlength=len(reached)))
    return [
        BranchPath(orbits.take(rows), over)
        for rows, over in zip(np.split(order, ends[:-1]), reached.tolist(), strict=True)
    ]
