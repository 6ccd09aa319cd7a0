"""The equations of one model at one parameter point, on plain floating-point numbers."""

import math
from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from stridemap.solver.model.model import Model

Array = NDArray[np.float64]


class Equations:
    """The equations of one model at one parameter point; a state y is (q, v), shape (2 n,).

    Parameters
    ----------
    model : Model
    params : ndarray, shape (n_params,)
    """

    def __init__(self, model: Model, params: Array) -> None:
        self.model = model
        self.p = [float(value) for value in params]
        self.n = len(model.coordinates)
        self._state_derivative = self._bind("state_derivative")
        self._touchdown_condition = self._bind("touchdown_condition")
        self._impact_map = self._bind("impact_map")
        self._swing_foot = self._bind("swing_foot")
        self._stance_foot = self._bind("stance_foot")
        self._centre_of_mass = self._bind("centre_of_mass")

    def _bind(self, name: str) -> Callable[[float, list[float]], dict[str, Any]]:
        """A generated function of time and state, with numbers for sines and cosines."""
        function, n, p = getattr(self.model.equations, name), self.n, self.p
        inputs = self.model.spec.functions[name].arguments
        indices = [("t", "q", "v", "p").index(key) for key in inputs]

        def call(t: float, y: list[float]) -> dict[str, Any]:
            values = (t, y[:n], y[n:], p)
            return function(math, *[values[i] for i in indices])

        return call

    # -- motion ------------------------------------------------------------------------------------------

    def rate(self, t: float, y: Array) -> list[float]:
        """Time derivative of the state."""
        try:
            out = self._state_derivative(t, y.tolist())
        except (ValueError, OverflowError, ZeroDivisionError):
            # Beyond the range of numbers; the integrator then gives up by itself.
            return [math.nan] * (2 * self.n)
        return out["dq"] + out["dv"]

    def advance(self, t: float, y: Array, to: float, rtol: float, atol: float) -> Array:
        """State at the time `to`, integrated from `t`."""
        return solve_ivp(self.rate, (t, to), y, "DOP853", rtol=rtol, atol=atol).y[:, -1]

    @cached_property
    def autonomous(self) -> bool:
        """Whether the motion depends on the state alone, not on a clock."""
        spec = self.model.spec
        return spec.phase is None and "t" not in spec.functions["state_derivative"].arguments

    # -- touchdown ---------------------------------------------------------------------------------------

    def touchdown(self, y: Array) -> tuple[float, float, float]:
        """Touchdown condition, its rate, and what is negative where a touchdown counts."""
        out = self._touchdown_condition(0.0, y.tolist())
        return out["h"], out["dh"], out["side"]

    def gradient(self, y: Array) -> Array:
        """Gradient of the touchdown condition, shape (n,)."""
        return self.model.evaluate("touchdown_condition_dq", q=y[: self.n], p=np.array(self.p))["h_dq"]

    def in_double_support(self, y: Array) -> bool:
        """Whether the touchdown condition is zero, but for rounding: both feet are on the ground."""
        return abs(self.touchdown(y)[0]) <= 1e-12 * float(np.abs(self.gradient(y) * y[: self.n]).sum())

    def land(self, y: Array) -> Array:
        """Section point after the impact."""
        out = self._impact_map(0.0, y.tolist())
        values = dict(zip(self.model.coordinates, out["q_plus"], strict=True))
        rates = {f"d{c}": v for c, v in zip(self.model.coordinates, out["v_plus"], strict=True)}
        z = np.array([(values | rates)[name] for name in self.model.section])
        return self.model.wrapped(z)

    def start(self, z: Array) -> Array:
        """State of a section point."""
        out = self.model.evaluate("section_state", z=z, p=np.array(self.p))
        return np.concatenate([out["q"], out["v"]])

    # -- where everything is -----------------------------------------------------------------------------

    def swing_foot(self, y: Array) -> tuple[list[float], list[float]]:
        """Swing foot and its velocity."""
        out = self._swing_foot(0.0, y.tolist())
        return out["foot"], out["dfoot"]

    def stance_foot(self, y: Array) -> list[float]:
        """Stance foot; the centre of its arc where it is round."""
        foot: list[float] = self._stance_foot(0.0, y.tolist())["stance"]
        return foot

    def centre_of_mass(self, y: Array) -> tuple[list[float], list[float]]:
        """Centre of mass from the stance foot, and its velocity."""
        out = self._centre_of_mass(0.0, y.tolist())
        return out["com"], out["dcom"]

    def lean(self, y: Array) -> float:
        """How far the centre of mass is ahead of the stance foot."""
        return float(self.centre_of_mass(y)[0][0] - self.stance_foot(y)[0])

    def before_touchdown(self, y: Array) -> Array:
        """Coordinates just before the touchdown that led to those of `y`, shape (n,)."""
        return self.model.evaluate("before_touchdown", q=y[: self.n], p=np.array(self.p))["q_minus"]

    def alternates(self, y: Array) -> bool:
        """Whether the stance foot becomes the swing foot at touchdown, as on two legs but not on a wheel.

        Parameters
        ----------
        y : ndarray, shape (2 n,)
            A state just after touchdown.
        """
        old = np.concatenate([self.before_touchdown(y), y[self.n :]])
        ahead = np.subtract(self.swing_foot(old)[0], self.stance_foot(old))
        behind = np.subtract(self.swing_foot(y)[0], self.stance_foot(y))
        return bool(np.abs(ahead + behind).max() <= 1e-6 * np.abs(ahead).max())

    @cached_property
    def ground(self) -> float:
        """Lowest height at which the swing foot is on the ground: that ahead, or on stairs that behind.

        It is found at a touchdown: from the middle of the search box, Newton's method on the condition.
        """
        box = self.model.spec.search_box
        y = self.start(np.array([box[name][0] for name in self.model.section]))
        for _ in range(50):
            gradient = self.gradient(y)
            size = float(gradient @ gradient)
            if self.in_double_support(y) or not size > 0:
                break
            y[: self.n] -= self.touchdown(y)[0] * gradient / size
        old = np.concatenate([self.before_touchdown(y), y[self.n :]])
        heights = [self.swing_foot(old)[0][1]]
        if self.alternates(y):
            heights.append(self.swing_foot(y)[0][1])
        return float(min(heights))
