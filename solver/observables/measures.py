"""How each measured quantity is computed, on arrays of limit cycles: one function of its name each.

The entries, with labels and definitions, are in `stridemap.quantities`. Extrema are found in continuous
time, ends included (`solver.observables.reductions`).
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.quantities import MEASURED
from stridemap.solver.kernels.observation import declared
from stridemap.solver.model.model import Model
from stridemap.solver.observables.events import Trace
from stridemap.solver.observables.reductions import count_zeros, extreme, works
from stridemap.spec import Quantity

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Cycles:
    """Limit cycles that are to be measured, and what several quantities have in common.

    ``cycles["cot"]`` is a quantity of all of them, computed once.

    Parameters
    ----------
    model : Model
    params : ndarray, shape (m, n_params)
    u : ndarray, shape (m, nz + 1)
        Section points with periods.
    multipliers : ndarray of complex, shape (m, nz)
    residuals, integration_errors : ndarray, shape (m,)
    trace : Trace
    """

    model: Model
    params: Array
    u: Array
    multipliers: NDArray[np.complex128]
    residuals: Array
    integration_errors: Array
    trace: Trace
    _known: dict[str, Any] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Any:
        """A quantity, shape (m,); None where the model lacks it."""
        if name not in self._known:
            self._known[name] = MEASURES[name](self)
        return self._known[name]

    @property
    def period(self) -> Array:
        """Periods, shape (m,)."""
        return self.u[:, -1]

    @cached_property
    def start(self) -> dict[str, Array]:
        """Coordinates and rates just after touchdown."""
        return self.model.evaluate("section_state", z=self.u[:, :-1], p=self.params)

    @cached_property
    def end(self) -> dict[str, Array]:
        """Coordinates and rates just before the next touchdown."""
        n, state = len(self.model.coordinates), self.trace.w[:, -1]
        return {"q": state[:, :n], "v": state[:, n : 2 * n]}

    @cached_property
    def weights(self) -> dict[str, Array]:
        """Mass of the walker, its weight, and the weight's component along the ground."""
        return self.model.evaluate("total_mass", p=self.params)

    @cached_property
    def works(self) -> tuple[Array, Array, Array]:
        """Absolute, positive and net work of all motors over a step."""
        return works(self.trace)

    @cached_property
    def energy(self) -> Array:
        """What a step costs: down a slope gravity supplies energy; uphill the motors' work has it already."""
        return self["work"] + np.maximum(self.weights["pull"], 0.0) * self["step_length"]

    def where_in_contact(self, values: Array) -> Array:
        """NaN where the foot would lift: there the ground force's ratios run to infinity."""
        return np.where(self["min_vertical_force"] > 0, values, np.nan)


MEASURES: dict[str, Callable[[Cycles], Any]] = {}
"""The function of each measured quantity, by the quantity's name."""


def measured(cycles: Cycles) -> dict[str, Any]:
    """Every measured quantity by name, in order; None for those that the model lacks."""
    own = {one.name: _reduced(cycles.trace, one) for one in cycles.model.spec.quantities}
    return {name: cycles[name] for name in MEASURED} | own


def _reduced(trace: Trace, quantity: Quantity) -> Array:
    """A quantity that the model declares, from its expression along the step."""
    row = declared(quantity.name)
    if quantity.reduction == "final":
        return trace.observable(row)[0][:, -1]
    if quantity.reduction == "minimum":
        return -extreme(trace, row, np.negative)
    return extreme(trace, row, np.absolute if quantity.reduction == "amplitude" else None)


def _measure(function: Callable[[Cycles], Any]) -> Callable[[Cycles], Any]:
    """Enter a function as the one that computes the quantity of its name."""
    MEASURES[function.__name__] = function
    return function


# -- stability -------------------------------------------------------------------------------------------


@_measure
def spectral_radius(cycles: Cycles) -> Array:
    """Largest modulus of a multiplier."""
    radius: Array = np.abs(cycles.multipliers).max(axis=1, initial=0.0)
    return radius


@_measure
def stable(cycles: Cycles) -> NDArray[np.bool_]:
    """Whether the largest multiplier is below 1."""
    below: NDArray[np.bool_] = cycles["spectral_radius"] < 1.0
    return below


@_measure
def group(cycles: Cycles) -> NDArray[np.object_] | None:
    """Letter of the solution group; None without a spring mode."""
    if "spring_mode" not in cycles.model.spec.functions:
        return None
    frequency = cycles.model.evaluate("spring_mode", p=cycles.params)["frequency"]
    oscillations, inverse = np.unique(
        (frequency * cycles.period / (2 * np.pi)).astype(np.int64), return_inverse=True
    )
    letters = np.array([group_letter(n) for n in oscillations.tolist()], dtype=object)
    return letters[inverse.ravel()]


def group_letter(index: int) -> str:
    """Letter of a solution group: 0 is A, 25 is Z, 26 is AA.

    Parameters
    ----------
    index : int
        Number of whole spring oscillations in one period.
    """
    letters = ""
    index += 1
    while index > 0:
        index, rest = divmod(index - 1, 26)
        letters = chr(ord("A") + rest) + letters
    return letters


# -- the step ----------------------------------------------------------------------------------------------


@_measure
def step_length(cycles: Cycles) -> Array:
    """Distance from the stance foot to the next."""
    return cycles.model.evaluate("step_length", **cycles.start, p=cycles.params)["length"]


@_measure
def speed(cycles: Cycles) -> Array:
    """Step length over period."""
    speed: Array = cycles["step_length"] / cycles.period
    return speed


@_measure
def peaks(cycles: Cycles) -> NDArray[np.int64]:
    """Local maxima of the stance angle's rate: falling zeros of its acceleration."""
    return count_zeros(cycles.trace, "peak", falling_only=True)


@_measure
def x_zero_crossings(cycles: Cycles) -> NDArray[np.int64] | None:
    """Sign changes of the wobbling mass's position; None without one."""
    return count_zeros(cycles.trace, "wobble") if cycles.model.spec.wobbling else None


@_measure
def wobble_amplitude(cycles: Cycles) -> Array | None:
    """Largest excursion of the wobbling mass either way; None without one."""
    return extreme(cycles.trace, "wobble", np.absolute) if cycles.model.spec.wobbling else None


@_measure
def touchdown_speed(cycles: Cycles) -> Array:
    """Speed of the swing foot just before touchdown."""
    velocity = cycles.model.evaluate("swing_foot", **cycles.end, p=cycles.params)["dfoot"]
    return np.hypot(velocity[:, 0], velocity[:, 1])


# -- energy ------------------------------------------------------------------------------------------------


@_measure
def work(cycles: Cycles) -> Array:
    """Integral of the motors' absolute power."""
    return cycles.works[0]


@_measure
def work_positive(cycles: Cycles) -> Array:
    """Integral of the positive part of the motors' power."""
    return cycles.works[1]


@_measure
def work_net(cycles: Cycles) -> Array:
    """Integral of the motors' power."""
    return cycles.works[2]


@_measure
def cot(cycles: Cycles) -> Array:
    """Energy per weight and step length."""
    cost: Array = cycles.energy / (cycles.weights["weight"] * cycles["step_length"])
    return cost


@_measure
def cot_per_speed(cycles: Cycles) -> Array:
    """Energy per weight and mean speed, as the paper has it."""
    cost: Array = cycles.energy * cycles.period / (cycles.weights["weight"] * cycles["step_length"])
    return cost


# -- the ground --------------------------------------------------------------------------------------------


@_measure
def d_max(cycles: Cycles) -> Array:
    """Largest distance of stance foot and zero moment point."""
    return cycles.where_in_contact(extreme(cycles.trace, "d", np.absolute))


@_measure
def min_vertical_force(cycles: Cycles) -> Array:
    """Smallest vertical ground force."""
    return -extreme(cycles.trace, "vertical_force", np.negative)


@_measure
def friction(cycles: Cycles) -> Array:
    """Largest ratio of horizontal to vertical ground force."""
    return cycles.where_in_contact(extreme(cycles.trace, "friction", np.absolute))


@_measure
def impact_friction(cycles: Cycles) -> Array:
    """Ratio of horizontal to vertical impulse on the foot that touches down."""
    at_impact = {**cycles.end, "t": cycles.period, "p": cycles.params}
    impulse = cycles.model.evaluate("impact_impulse", **at_impact)["Lambda"]
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.abs(impulse[:, 0]) / impulse[:, 1]
    return np.where(impulse[:, 1] > 0, ratio, np.nan)


@_measure
def lift_off_speed(cycles: Cycles) -> Array:
    """Speed away from the ground of the foot that is released, with the other one at rest on the ground.

    In the coordinates before the legs swap names the stance foot is the one that is released. Its velocity
    is minus that which the foot that landed would have if it stood: only the motion of one foot against the
    other counts, and a round foot's arc rolls along the ground, not away from it.
    """
    model, params = cycles.model, cycles.params
    q, v = cycles.start["q"], cycles.start["v"]
    before, moved = (
        model.evaluate("before_touchdown", q=at, p=params)["q_minus"] for at in (q, q + v)
    )  # which is linear in the coordinates
    landed = model.evaluate("swing_foot", q=before, v=moved - before, p=params)["dfoot"]
    speed: Array = -landed[:, 1]
    return speed


@_measure
def trailing_lifts_off(cycles: Cycles) -> NDArray[np.bool_]:
    """Whether the foot that is released moves away from the ground."""
    lifts: NDArray[np.bool_] = cycles["lift_off_speed"] > 0
    return lifts


@_measure
def clearance(cycles: Cycles) -> Array:
    """Lowest height of the swing foot."""
    return -extreme(cycles.trace, "foot_height", np.negative)


# -- the numbers themselves --------------------------------------------------------------------------------


@_measure
def residual(cycles: Cycles) -> Array:
    """Largest entry of the closing error."""
    return cycles.residuals


@_measure
def integration_error(cycles: Cycles) -> Array:
    """Largest change of the closing error at twice the resolution."""
    return cycles.integration_errors
