"""The oscillator's phase along a step of the walker, with few sines.

Sines are a large part of the work of a Runge-Kutta step. The stages of every step lie at the same fractions
of its size, so that their phases are one rotation each from the phase at its start, the same for all steps;
and the sine of a difference of angles follows from those of the angles.
"""

from typing import Any

import casadi as ca

from stridemap.solver.model import Model


class Sines:
    """CasADi's functions for generated equations, with the phase's cosine and sine given.

    Parameters
    ----------
    t : casadi.SX, scalar
        Stands for the time; it may appear within sines only.
    phase : casadi.SX, shape (2, 1)
        Cosine and sine of the phase.
    """

    sqrt = staticmethod(ca.sqrt)

    def __init__(self, t: ca.SX, phase: ca.SX) -> None:
        self.t = t
        self.phase = phase
        self.angles: list[ca.SX] = []

    def cos(self, x: ca.SX) -> ca.SX:
        """Cosine."""
        return self._pair(x)[0]

    def sin(self, x: ca.SX) -> ca.SX:
        """Sine."""
        return self._pair(x)[1]

    def _pair(self, x: ca.SX) -> tuple[ca.SX, ca.SX]:
        if ca.depends_on(x, self.t):
            self.angles.append(x)
            return self.phase[0], self.phase[1]
        if x.is_op(ca.OP_SUB):
            return rotated((ca.cos(x.dep(0)), ca.sin(x.dep(0))), (ca.cos(x.dep(1)), -ca.sin(x.dep(1))))
        return ca.cos(x), ca.sin(x)


def rotated(one: Any, other: Any) -> tuple[ca.SX, ca.SX]:
    """Cosine and sine of the sum of two angles, each given by its own."""
    return one[0] * other[0] - one[1] * other[1], one[1] * other[0] + one[0] * other[1]


def with_phase(
    model: Model, name: str, t: ca.SX, phase: ca.SX, **values: ca.SX
) -> tuple[dict[str, ca.SX], list]:
    """Call a generated function with the cosine and sine of the phase in the place of the time.

    Returns
    -------
    outputs : dict of str to casadi.SX
    angles : list of casadi.SX
        What the phase stood for, in terms of `t`.
    """
    sines = Sines(t, phase)
    inputs = [entry["name"] for entry in model.manifest["functions"][name]["inputs"]]
    scalars = [t if key == "t" else ca.vertsplit(values[key]) for key in inputs]
    result = getattr(model.equations, name)(sines, *scalars)
    return {key: Model._matrix(value) for key, value in result.items()}, sines.angles


def phase_function(model: Model) -> ca.Function:
    """(t, p) -> (cosine, sine) of the oscillator's phase; of 0 where the equations have none."""
    t, p, phase = ca.SX.sym("t"), ca.SX.sym("p", len(model.parameters)), ca.SX.sym("phase", 2)
    n = len(model.coordinates)
    values = {"q": ca.SX.sym("q", n), "v": ca.SX.sym("v", n), "p": p}
    outputs, angles = with_phase(model, "state_derivative", t, phase, **values)
    if any(ca.depends_on(value, t) for value in outputs.values()):
        raise ValueError(f"{model.name}: time appears outside sines")
    angle = angles[0] if angles else ca.SX(0)
    if not all(ca.is_equal(angle, other, 4) for other in angles):
        raise ValueError(f"{model.name}: there are several phases")
    return ca.Function("phase", [t, p], [ca.vertcat(ca.cos(angle), ca.sin(angle))], ["t", "p"], ["phase"])
