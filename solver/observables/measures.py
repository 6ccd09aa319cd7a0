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

from stridemap.quantities import LIMIT_USE, MEASURED
from stridemap.solver.kernels.observation import declared, power, torque
from stridemap.solver.model.model import Model
from stridemap.solver.observables import peak_power as powers
from stridemap.solver.observables.events import Trace
from stridemap.solver.observables.reductions import Works, count_zeros, extreme, works
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
    residuals, integration_errors, state_errors, multiplier_errors : ndarray, shape (m,)
    trace : Trace
    """

    model: Model
    params: Array
    u: Array
    multipliers: NDArray[np.complex128]
    residuals: Array
    integration_errors: Array
    state_errors: Array
    multiplier_errors: Array
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
    def works(self) -> Works:
        """Absolute, positive and net work of each motor over a step."""
        return works(self.trace)

    @cached_property
    def torques(self) -> Array:
        """Largest absolute torque, or force, of each motor, shape (m, n_motors)."""
        return self._of_motors(
            [extreme(self.trace, torque(name), np.absolute) for name in self.model.actuated]
        )

    @cached_property
    def powers(self) -> Array:
        """Largest absolute power of each motor, shape (m, n_motors)."""
        return self._of_motors(
            [extreme(self.trace, power(name), np.absolute) for name in self.model.actuated]
        )

    def _of_motors(self, columns: list[Array]) -> Array:
        return np.stack(columns, axis=1) if columns else np.zeros((len(self.u), 0))

    @cached_property
    def limit_use(self) -> Array:
        """Largest ratio of a motor's torque to its limit; 0 without limits."""
        limits = [np.inf if motor.limit is None else motor.limit for motor in self.model.spec.motors]
        used: Array = (self.torques / limits).max(axis=1, initial=0.0)
        return used

    @cached_property
    def drawn(self) -> Array:
        """Energy that the motors draw: nothing of the work that is done on them is recovered."""
        share = np.array([motor.efficiency for motor in self.model.spec.motors])
        positive = self.works.positive
        energy: Array = (positive / share + (self.works.absolute - positive)).sum(axis=1)
        return energy

    @cached_property
    def drop(self) -> Array:
        """Energy that gravity supplies per step.

        The posture comes back, so the whole walker has moved as far as its foot: along the ground, and away
        from it on stairs.
        """
        step = self.model.evaluate("step_length", **self.start, p=self.params)
        return self.weights["pull"] * step["length"] - self.weights["press"] * step["rise"]

    @cached_property
    def energy(self) -> Array:
        """What a step costs; where it leads up, the motors' work has it already."""
        return self.drawn + np.where(self.drop > 0, self.drop, 0.0)

    def where_in_contact(self, values: Array) -> Array:
        """NaN where the foot would lift: there the ground force's ratios run to infinity."""
        return np.where(self["min_vertical_force"] > 0, values, np.nan)


MEASURES: dict[str, Callable[[Cycles], Any]] = {}
"""The function of each measured quantity, by the quantity's name."""


def measured(cycles: Cycles) -> dict[str, Any]:
    """Every measured quantity by name, in order; None for those that the model lacks."""
    own = {one.name: _reduced(cycles.trace, one) for one in cycles.model.spec.quantities}
    everything = {name: cycles[name] for name in MEASURED} | _of_each_motor(cycles) | own
    return {name: everything[name] for name in cycles.model.measured}


def _of_each_motor(cycles: Cycles) -> dict[str, Any]:
    """The quantities of each motor, under all names that a model may have for them."""
    if not any(name not in MEASURED for name in cycles.model.measured):
        return {}
    columns = {"work": cycles.works.absolute, "work_positive": cycles.works.positive}
    columns |= {"work_net": cycles.works.net, "peak_power": cycles.powers}
    columns |= {"peak_torque": cycles.torques, "peak_force": cycles.torques}
    names = cycles.model.actuated
    return {LIMIT_USE.name: cycles.limit_use} | {
        f"{what}_{name}": column[:, i] for what, column in columns.items() for i, name in enumerate(names)
    }


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
def stable(cycles: Cycles) -> NDArray[np.object_]:
    """Whether the largest multiplier is below 1; None where its error does not tell."""
    return decided(cycles["spectral_radius"], cycles["multiplier_error"])


@_measure
def undecided(cycles: Cycles) -> NDArray[np.object_]:
    """Why it is not known whether the cycle is stable; empty where it is."""
    reasons = [
        f"the largest multiplier is {radius:.12g}, which its error of {error:.1g} does not tell from 1"
        if known is None
        else ""
        for known, radius, error in zip(
            cycles["stable"], cycles["spectral_radius"], cycles["multiplier_error"], strict=True
        )
    ]
    return np.array(reasons, dtype=object)


def decided(radius: Array, error: Array) -> NDArray[np.object_]:
    """Whether spectral radii are below 1: True, False, or None where 1 lies within the error.

    Parameters
    ----------
    radius, error : ndarray, shape (m,)
        An error that is not a number decides nothing.
    """
    known = np.abs(radius - 1.0) > error
    out = np.full(radius.shape, None, dtype=object)
    out[known] = (radius < 1.0)[known].tolist()
    return out


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
    """Minima of the speed at which the stance leg turns over: zeros of its angle's acceleration."""
    index = cycles.model.stance_index
    if index is None:
        return np.zeros(len(cycles.u), dtype=np.int64)
    # Where the angle falls on the whole, its rate is largest where the leg is slowest.
    falls = cycles.end["q"][:, index] < cycles.start["q"][:, index]
    return count_zeros(cycles.trace, "peak", falling=falls)


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
    """Integral of the motors' absolute powers."""
    return cycles.works.absolute.sum(axis=1)


@_measure
def work_positive(cycles: Cycles) -> Array:
    """Integral of the positive parts of the motors' powers."""
    return cycles.works.positive.sum(axis=1)


@_measure
def work_net(cycles: Cycles) -> Array:
    """Integral of the motors' powers."""
    return cycles.works.net.sum(axis=1)


@_measure
def peak_torque(cycles: Cycles) -> Array:
    """Largest absolute torque of any motor that drives an angle."""
    rotary = [motor.kind == "torque" for motor in cycles.model.spec.motors]
    return cycles.torques[:, rotary].max(axis=1, initial=0.0)


@_measure
def peak_power(cycles: Cycles) -> Array:
    """Largest sum of the motors' absolute powers."""
    return powers.peak_power(cycles.trace)


@_measure
def cot(cycles: Cycles) -> Array:
    """Energy per weight and step length."""
    cost: Array = cycles.energy / (cycles.weights["weight"] * np.abs(cycles["step_length"]))
    return cost


@_measure
def cot_per_speed(cycles: Cycles) -> Array:
    """Energy per weight and mean speed, as the paper has it."""
    cost: Array = cycles.energy * cycles.period / (cycles.weights["weight"] * np.abs(cycles["step_length"]))
    return cost


# -- the ground --------------------------------------------------------------------------------------------


@_measure
def d_max(cycles: Cycles) -> Array:
    """Largest absolute value of the paper's distance d."""
    return cycles.where_in_contact(extreme(cycles.trace, "d", np.absolute))


@_measure
def cop_max(cycles: Cycles) -> Array:
    """Largest distance of the centre of pressure from the contact."""
    return cycles.where_in_contact(extreme(cycles.trace, "cop", np.absolute))


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
def state_error(cycles: Cycles) -> Array:
    """Error of section point and period."""
    return cycles.state_errors


@_measure
def multiplier_error(cycles: Cycles) -> Array:
    """Error of the multipliers."""
    return cycles.multiplier_errors


@_measure
def integration_error(cycles: Cycles) -> Array:
    """Largest change of the closing error at twice the resolution."""
    return cycles.integration_errors
