"""What a search did: how many starts it made, how each ended, and what it threw away."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Index = NDArray[np.int64]

LIMIT_CYCLE = "limit_cycle"
OPEN = "open"
IMPOSSIBLE = "impossible"

ENDS: Mapping[str, str] = {
    LIMIT_CYCLE: "in a limit cycle",
    OPEN: "nowhere: Newton's method did not come near a solution",
    IMPOSSIBLE: "in a walker that hangs, walks backwards or falls over",
    "not_converged": "in a solution of the rough search that does not close",
    "unresolved": "near a solution that the finest resolution does not resolve",
    "not_a_step": "in a closed motion that is not a step",
    "later_touchdown": "in a closed motion that an earlier touchdown ends",
    "out_of_range": "in a cycle with a period outside the range",
}
"""How a start can end, each with a few words for readers."""


@dataclass(frozen=True, eq=False)
class SearchReport:
    """What a search for all limit cycles did.

    Parameters
    ----------
    starts : int
        Starts that were made.
    ended : mapping of str to int
        How many of them ended in what: the keys of `ENDS`.
    reached : ndarray of int, shape (n,)
        For each limit cycle the number of starts that led to it.
    settled : bool
        Whether every limit cycle was reached from at least two starts, so that another one is unlikely.
    discarded : Orbits
        The solutions that are not limit cycles, one row each; ``discarded.status`` says why.
    reason : str or None
        Where nothing was found and the equations say why: a sentence.
    """

    starts: int
    ended: Mapping[str, int]
    reached: Index
    settled: bool
    discarded: Any = field(repr=False)
    reason: str | None = None

    @property
    def unresolved(self) -> int:
        """Number of solutions that nearly closed, and may be limit cycles."""
        return int(np.count_nonzero(self.discarded.status == "unresolved")) if len(self.discarded) else 0

    @property
    def reasons(self) -> dict[str, int]:
        """How many solutions were thrown away for which reason, in words."""
        words = [status.reason for status in self.discarded.status.tolist()]
        return {word: words.count(word) for word in dict.fromkeys(words)}

    @property
    def warnings(self) -> list[str]:
        """Sentences on what the search may have missed; none where it is sure of itself."""
        out = [] if self.reason is None else [self.reason]
        if self.reason is None and self.ended[OPEN] == self.starts:
            out.append(
                "no start came near a solution: look whether all values are in the units that they are taken "
                "for, and raise starts or widen the search box"
            )
        if self.unresolved:
            out.append(
                f"{_counted(self.unresolved, 'solution')} nearly closed, but the motion changes too suddenly "
                "for the finest resolution: there may be limit cycles that are not listed"
            )
        if not self.settled:
            once = int(np.count_nonzero(self.reached == 1))
            out.append(
                f"{_counted(once, 'limit cycle')} reached from one start of {self.starts:,} only: there may "
                "be more; raise starts or max_starts, or widen the search box"
            )
        return out

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        lost = self.discarded
        rows = [
            {
                "status": one.value,
                "reason": one.reason,
                "residual": _number(residual),
                "state": {name: _number(x) for name, x in zip(lost.model.section, u[:-1], strict=True)},
                "period": _number(u[-1]),
            }
            for one, residual, u in zip(
                lost.status.tolist(), lost.residual.tolist(), lost.u.tolist(), strict=True
            )
        ]
        return {
            "starts": self.starts,
            "settled": self.settled,
            "ended": dict(self.ended),
            "reached": self.reached.tolist(),
            "discarded": rows,
            "warnings": self.warnings,
        }


def _number(value: float) -> float | None:
    """A number for JSON; None for what is not one."""
    return value if np.isfinite(value) else None


def _counted(n: int, word: str) -> str:
    return f"{n:,} {word}{'' if n == 1 else 's'}"
