"""The time along a step of the walker, as the equations need it.

Sines are a large part of the work of a Runge-Kutta step. Where time enters the equations as the phase of one
oscillator only (`Oscillator`), no sine of it is taken at a stage: the stages of every step lie at the same
fractions of its size, so that their phases are one rotation each from the phase at its start, the same for
all steps. Elsewhere (`PlainTime`) the time itself is handed on. In both, the sine of a difference of angles
follows from those of the angles.
"""

from typing import Any

import casadi as ca

from stridemap.solver.model.model import Model

Pair = tuple[Any, Any]


class PhaseNamespace:
    """CasADi's functions for generated equations, with the cosine and sine of the phase given.

    Parameters
    ----------
    t : casadi.SX, scalar
        Stands for the time; with a phase it may appear within sines only.
    phase : casadi.SX, shape (2, 1), optional
        Cosine and sine of the phase.
    """

    def __init__(self, t: ca.SX, phase: ca.SX | None = None) -> None:
        self.t = t
        self.phase = phase
        self.angles: list[ca.SX] = []

    def __getattr__(self, name: str) -> Any:
        """All other functions, and pi, are CasADi's."""
        return getattr(ca, name)

    def cos(self, x: ca.SX) -> ca.SX:
        """Cosine."""
        return self._pair(x)[0]

    def sin(self, x: ca.SX) -> ca.SX:
        """Sine."""
        return self._pair(x)[1]

    def _pair(self, x: ca.SX) -> Pair:
        x = ca.SX(x)
        if self.phase is not None and ca.depends_on(x, self.t):
            self.angles.append(x)
            return self.phase[0], self.phase[1]
        if x.is_op(ca.OP_SUB):
            return rotated((ca.cos(x.dep(0)), ca.sin(x.dep(0))), (ca.cos(x.dep(1)), -ca.sin(x.dep(1))))
        return ca.cos(x), ca.sin(x)


def rotated(one: Pair, other: Pair) -> Pair:
    """Cosine and sine of the sum of two angles, each given by its own."""
    return one[0] * other[0] - one[1] * other[1], one[1] * other[0] + one[0] * other[1]


class Oscillator:
    """Time as cosine and sine of a phase.

    Parameters
    ----------
    model : Model
    angle : casadi.SX
        The phase, in terms of `t` and `p`.
    t, p : casadi.SX
    """

    def __init__(self, model: Model, angle: ca.SX, t: ca.SX, p: ca.SX) -> None:
        self.model = model
        self.at = ca.Function(
            "phase", [t, p], [ca.vertcat(ca.cos(angle), ca.sin(angle))], ["t", "p"], ["phase"]
        )
        d = ca.SX.sym("d", *p.shape)
        self._along = ca.Function("turn", [t, p, d], [ca.jtimes(angle, p, d)])

    @staticmethod
    def advance_phase(start: ca.SX, increment: ca.SX) -> ca.SX:
        """The phase after an increment."""
        return ca.vertcat(*rotated((start[0], start[1]), (increment[0], increment[1])))

    def along(self, phase: ca.SX, t: ca.SX, p: ca.SX, d: ca.SX) -> ca.SX:
        """Derivative of the phase at a time in a direction d of the parameters."""
        return self._along(t, p, d) * ca.vertcat(-phase[1], phase[0])

    def call(self, name: str, phase: ca.SX, **values: ca.SX) -> dict[str, ca.SX]:
        """Call a generated function with cosine and sine of the phase in the place of the time."""
        t = ca.SX.sym("t")
        return _called(self.model, name, PhaseNamespace(t, phase), t, values)


class PlainTime:
    """Time as it is, in a pair whose second entry means nothing.

    Parameters
    ----------
    model : Model
    """

    def __init__(self, model: Model) -> None:
        self.model = model
        t, p = ca.SX.sym("t"), ca.SX.sym("p", len(model.parameters))
        self.at = ca.Function("phase", [t, p], [ca.vertcat(t, 0)], ["t", "p"], ["phase"])

    @staticmethod
    def advance_phase(start: ca.SX, increment: ca.SX) -> ca.SX:
        """The time after an increment."""
        return start + increment

    @staticmethod
    def along(phase: ca.SX, t: ca.SX, p: ca.SX, d: ca.SX) -> ca.SX:
        """Derivative of the time in a direction of the parameters: it is zero."""
        return ca.SX.zeros(2)

    def call(self, name: str, phase: ca.SX, **values: ca.SX) -> dict[str, ca.SX]:
        """Call a generated function with the time."""
        return _called(self.model, name, PhaseNamespace(phase[0]), phase[0], values)


def clock_for(model: Model) -> Oscillator | PlainTime:
    """How time enters the equations of a model."""
    t, p, phase = ca.SX.sym("t"), ca.SX.sym("p", len(model.parameters)), ca.SX.sym("phase", 2)
    n = len(model.coordinates)
    namespace = PhaseNamespace(t, phase)
    values = {"q": ca.SX.sym("q", n), "v": ca.SX.sym("v", n), "p": p}
    outputs = _called(model, "state_derivative", namespace, t, values)
    outside = any(ca.depends_on(value, t) for value in outputs.values())
    angle = namespace.angles[0] if namespace.angles else ca.SX(0)
    if outside or not all(ca.is_equal(angle, other, 4) for other in namespace.angles):
        return PlainTime(model)
    return Oscillator(model, angle, t, p)


def _called(
    model: Model, name: str, namespace: PhaseNamespace, t: ca.SX, values: dict[str, ca.SX]
) -> dict[str, ca.SX]:
    inputs = model.spec.functions[name].arguments
    scalars = [t if key == "t" else ca.vertsplit(values[key]) for key in inputs]
    result = getattr(model.equations, name)(namespace, *scalars)
    return {key: Model.matrix(value) for key, value in result.items()}
