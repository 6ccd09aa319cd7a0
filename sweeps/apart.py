"""Work on many solutions at a time, and on fewer of them where that raises."""

from collections.abc import Callable
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from stridemap.sweeps.solutions import Solutions

_T = TypeVar("_T")
_S = TypeVar("_S", bound=Solutions)


def one_by_one(
    method: Callable[[_S], _T], solutions: _S, group: NDArray[np.int64], failures: dict[int, str]
) -> list[_T]:
    """Apply a method to all solutions; where that raises, to those of each group by themselves.

    Parameters
    ----------
    method : callable
    solutions : Solutions
    group : ndarray of int, shape (n,)
    failures : dict of int to str
        Gets the cells of the groups for which the method raises, with the reason.

    Returns
    -------
    list
        What the method gave, each time that it was applied.
    """
    if not len(solutions):
        return []
    try:
        return [method(solutions)]
    except Exception:
        out = []
        for one in np.unique(group):
            part = solutions.take(group == one)
            try:
                out.append(method(part))
            except Exception as error:
                for cell in part.cell.tolist():
                    failures[cell] = f"{type(error).__name__}: {error}"
        return out
