"""Arclength steps of many branches in C++ (arcs.h), several evaluations at a time.

No branch waits for another one's arclength step, so that nearly all lanes are always at work.
"""

import ctypes
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Kernels, Lockstep
from stridemap.solver.backends.shared_library import check
from stridemap.solver.branches import arcs
from stridemap.solver.branches.arcs import Arcs, Lines, Round
from stridemap.solver.branches.heads import Heads, Points
from stridemap.solver.branches.stops import BULGE, ON_CURVE, Stops
from stridemap.solver.kernels.catalogue import jacobian_along, residual
from stridemap.solver.kernels.resolution import BRANCH_N_RK, BRANCH_PHASE
from stridemap.solver.options import ContinuationOptions

Array = NDArray[np.float64]

DRIVER = Path(__file__).with_name("arcs.h")


def prepared(kernels: Kernels) -> Lockstep | None:
    """What takes arclength steps with some kernels, compiled; None where there are no lanes.

    Raises
    ------
    CompilerError
        When the compiler fails.
    """
    return kernels.lockstep(DRIVER)


def arcs_for(
    lines: Lines,
    options: ContinuationOptions,
    period_range: tuple[float, float],
    stops: Stops,
    beginnings: Array,
) -> Arcs:
    """What takes arclength steps along some lines, with the parameters of `Arcs`."""
    lockstep = prepared(lines.kernels)
    what = (lines, options, period_range, stops, beginnings)
    return Arcs(*what) if lockstep is None else _ArcsInLanes(*what, lockstep)


_OPTIONS = ("ds_min", "ds_max", "step_growth", "step_shrink", "min_tangent_cosine", "easy_tangent_cosine")
_INTEGERS = (
    *("n_unknowns", "n_params", "n_levels", "n_modes", "n_stops", "n_beginnings"),
    *("max_steps", "max_corrections"),
)
_NUMBERS = (
    *("shortest", "longest", *_OPTIONS),
    *("tolerance", "short_correction", "correction_ratio", "contraction", "sharp", "sideways", "telling"),
    *("on_curve", "bulge"),
)
_ARRAYS = (
    *("jacobian_along", "residual", "largest_phase", "scale", "params", "direction", "modes"),
    *("stop_key", "stop", "beginning", "line", "stop_number"),
)
_HEADS = (
    *("branch", "x", "tangent", "bend", "ds", "idle", "steps", "passed"),
    *("points", "tangents", "met_from_behind"),
)
_CHANGING = ("x", "tangent", "bend", "ds", "idle")


class _Course(ctypes.Structure):
    """What arcs.h calls by this name."""

    _fields_ = (
        *((name, ctypes.c_longlong) for name in _INTEGERS),
        *((name, ctypes.c_double) for name in _NUMBERS),
        *((name, ctypes.c_void_p) for name in _ARRAYS),
    )


class _Heads(ctypes.Structure):
    """What arcs.h calls by this name."""

    _fields_ = tuple((name, ctypes.c_void_p) for name in _HEADS)


def _in_memory(arrays: dict[str, NDArray[Any]], dtype: type) -> dict[str, NDArray[Any]]:
    """Copies, or the arrays themselves, as the C++ reads them."""
    return {name: np.ascontiguousarray(array, dtype=dtype) for name, array in arrays.items()}


def _addresses(arrays: dict[str, NDArray[Any]]) -> dict[str, int]:
    return {name: array.ctypes.data for name, array in arrays.items()}


@dataclass(frozen=True)
class _ArcsInLanes(Arcs):
    """Takes arclength steps in C++."""

    lockstep: Lockstep

    @cached_property
    def _arrays(self) -> dict[str, NDArray[Any]]:
        """What the C++ reads all along; it must stay where it is."""
        lines = self.lines
        kernels = {
            name: np.array([self.lockstep.address(kind(n)) for n in BRANCH_N_RK], dtype=np.uintp)
            for name, kind in (("jacobian_along", jacobian_along), ("residual", residual))
        }
        numbers = {name: getattr(lines, name) for name in ("scale", "params", "direction", "modes")}
        numbers |= {"stop_key": self.stops.key, "stop": self.stops.x, "beginning": self.beginnings}
        numbers["largest_phase"] = np.array(BRANCH_N_RK) * BRANCH_PHASE
        integers = {"line": lines.number, "stop_number": self.stops.number}
        return kernels | _in_memory(numbers, np.float64) | _in_memory(integers, np.int64)

    @cached_property
    def _course(self) -> _Course:
        options = self.options
        return _Course(
            n_unknowns=len(self.lines.scale) - 1,
            n_params=self.lines.params.shape[1],
            n_levels=len(BRANCH_N_RK),
            n_modes=arcs.MODES,
            n_stops=len(self.stops.key),
            n_beginnings=len(self.beginnings),
            max_steps=options.max_steps,
            max_corrections=options.max_corrections,
            shortest=self.period_range[0],
            longest=self.period_range[1],
            **{name: getattr(options, name) for name in _OPTIONS},
            tolerance=arcs.TOLERANCE,
            short_correction=arcs.SHORT,
            correction_ratio=arcs.CORRECTION_RATIO,
            contraction=arcs.CONTRACTION,
            sharp=arcs.SHARP,
            sideways=arcs.SIDEWAYS,
            telling=arcs.TELLING,
            on_curve=ON_CURVE,
            bulge=BULGE,
            **_addresses(self._arrays),
        )

    def taken(self, heads: Heads, tries: int) -> Round:
        """Up to so many arclength steps of each branch, failed ones included."""
        n, width = heads.x.shape
        new = {name: np.array(getattr(heads, name), np.float64, order="C") for name in _CHANGING}
        steps, branch = np.array(heads.steps, np.int64), np.ascontiguousarray(heads.branch, np.int64)
        passed, met = np.zeros(n, dtype=np.int64), np.zeros(len(self.beginnings), dtype=np.uint8)
        points, tangents = np.empty((n, tries, width)), np.empty((n, tries, width))
        arrays = {"branch": branch, **new, "steps": steps, "passed": passed, "points": points}
        pointers = _Heads(**_addresses(arrays | {"tangents": tangents, "met_from_behind": met}))
        status = self.lockstep.library.lockstep_arcs(
            ctypes.byref(self._course), ctypes.byref(pointers), ctypes.c_longlong(n), ctypes.c_longlong(tries)
        )
        check(status, "arclength steps")
        kept = np.arange(tries) < passed[:, None]
        row = np.repeat(np.arange(n), passed)
        return Round(
            self.going(Heads(heads.branch, heads.ahead, **new, steps=steps)),
            Points(heads.branch[row], heads.ahead[row], points[kept], tangents[kept]),
            np.flatnonzero(met),
        )
