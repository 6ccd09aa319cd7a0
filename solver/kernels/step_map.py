"""The step map with the period as an unknown, as straight-line CasADi functions.

Time is scaled to the period: a limit cycle is a zero of

    R(z, T) = ( P(z, T) - z,  h(q(T)) ),

with P the flow over the time T, followed by the impact, and h the touchdown condition. R is smooth
and free of branches and event detection; which touchdown it is, is checked afterwards.

The state y is (q, v); a point on the section is z. One SX graph holds an RK step with its
derivative, so that sines, cosines and eliminations are shared; MX chains the RK steps.
"""

from collections.abc import Callable
from functools import cached_property

import casadi as ca
import numpy as np

from stridemap.solver.kernels import runge_kutta
from stridemap.solver.kernels.dormand_prince import NODES, STAGES
from stridemap.solver.kernels.phase import clock_for
from stridemap.solver.model.model import Model
from stridemap.solver.model.scales import Scales, rounded

BLOCK = 12
"""RK steps in one block; every resolution is a multiple of it."""


class StepMap:
    """Builds the functions of one model.

    Parameters
    ----------
    model : Model
    """

    def __init__(self, model: Model) -> None:
        self.model = model
        self.n = len(model.coordinates)
        self.nz = len(model.section)
        self.n_params = len(model.parameters)
        self._clock = clock_for(model)
        self._whole: dict[str, ca.Function] = {}

    # -- pieces ------------------------------------------------------------------------------------------

    def call(self, name: str, **values: ca.SX) -> dict[str, ca.SX]:
        """Call a generated function; it uses those of `values` that it reads."""
        return getattr(self.model, name)(**values)

    def _symbols(self) -> tuple[ca.SX, ca.SX, ca.SX]:
        return ca.SX.sym("t"), ca.SX.sym("y", 2 * self.n), ca.SX.sym("p", self.n_params)

    def rate(self, t: ca.SX, y: ca.SX, p: ca.SX) -> ca.SX:
        """Time derivative of the state, shape (2 n, 1)."""
        out = self.call("state_derivative", t=t, q=y[: self.n], v=y[self.n :], p=p)
        return ca.vertcat(out["dq"], out["dv"])

    def at_phase(self, name: str, phase: ca.SX, **values: ca.SX) -> dict[str, ca.SX]:
        """Call a generated function with the phase (see `phase`) in the place of the time."""
        return self._clock.call(name, phase, **values)

    def rate_at_phase(self, phase: ca.SX, y: ca.SX, p: ca.SX) -> ca.SX:
        """Time derivative of the state, shape (2 n, 1)."""
        out = self.at_phase("state_derivative", phase, q=y[: self.n], v=y[self.n :], p=p)
        return ca.vertcat(out["dq"], out["dv"])

    def _variational_rate(self, phase: ca.SX, y: ca.SX, p: ca.SX) -> ca.SX:
        """Time derivative of the state and of its tangents; y is (state | tangents), shape (2 n, 1 + nz)."""
        state, tangents = y[:, 0], y[:, 1:]
        values = {"q": state[: self.n], "v": state[self.n :], "p": p}
        dv_dq = self.at_phase("state_derivative_dq", phase, **values)["dv_dq"]
        dv_dv = self.at_phase("state_derivative_dv", phase, **values)["dv_dv"]
        upper, lower = tangents[: self.n, :], tangents[self.n :, :]
        return ca.horzcat(
            self.rate_at_phase(phase, state, p), ca.vertcat(lower, dv_dq @ upper + dv_dv @ lower)
        )

    def _rate_along(self, phase: ca.SX, y: ca.SX, p: ca.SX, t: ca.SX, d: ca.SX) -> ca.SX:
        """The same with one tangent more, that in a direction d of the parameters, shape (2 n, 2 + nz)."""
        rate = self._variational_rate(phase, y, p)
        given = self._rate_in_direction(phase, y[:, 0], p, self._clock.along(phase, t, p, d), d)
        return ca.horzcat(rate[:, :-1], rate[:, -1] + given)

    @cached_property
    def _rate_in_direction(self) -> ca.Function:
        """Derivative of the state's rate in a direction of phase and parameters, shape (2 n, 1)."""
        _, y, p = self._symbols()
        phase, turn, d = ca.SX.sym("phase", 2), ca.SX.sym("turn", 2), ca.SX.sym("d", self.n_params)
        moved = ca.jtimes(self.rate_at_phase(phase, y, p), ca.vertcat(phase, p), ca.vertcat(turn, d))
        return ca.Function("rate_in_direction", [phase, y, p, turn, d], [moved])

    @cached_property
    def phase(self) -> ca.Function:
        """(t, p) -> the time as the equations need it: cosine and sine of a phase where they have one."""
        return self._clock.at

    @cached_property
    def phase_increments(self) -> ca.Function:
        """(h, p) -> for each stage, the phase's advance since the start of the step."""
        h, p = ca.SX.sym("h"), ca.SX.sym("p", self.n_params)
        columns = [self.phase(node * h, p) for node in NODES]
        return ca.Function("turns", [h, p], [ca.cse(ca.horzcat(*columns))], ["h", "p"], ["turns"])

    def rk_step(self, name: str, rate: Callable[..., ca.SX], y: ca.SX, *, along: bool = False) -> ca.Function:
        """One RK step: (y, phase, increments, h, p) -> y, for a rate of (phase, y, p).

        With `along` the step also takes the time t at its beginning and a direction d of the parameters, and
        the rate the time of the stage and d.
        """
        phase, increments, h = ca.SX.sym("phase", 2), ca.SX.sym("turns", 2, STAGES), ca.SX.sym("h")
        p, t, d = ca.SX.sym("p", self.n_params), ca.SX.sym("t"), ca.SX.sym("d", self.n_params)
        phases = [
            self._clock.advance_phase(phase, increments[:, i]) if node else phase
            for i, node in enumerate(NODES)
        ]
        stages = [
            (one, t + node * h, d) if along else (one,) for one, node in zip(phases, NODES, strict=True)
        ]
        end = runge_kutta.rk_step(lambda s, x: rate(s[0], x, p, *s[1:]), stages, y, h)
        inputs = {"y": y, "phase": phase, "turns": increments, "h": h, "p": p}
        inputs |= {"t": t, "d": d} if along else {}
        return ca.Function(name, [*inputs.values()], [ca.cse(end)], [*inputs], ["y_end"])

    @cached_property
    def plain_rk_step(self) -> ca.Function:
        """One RK step of the state: (y, phase, increments, h, p) -> y."""
        return self.rk_step("plain_step", self.rate_at_phase, ca.SX.sym("y", 2 * self.n))

    @cached_property
    def variational_rk_step(self) -> ca.Function:
        """One step of the state and its tangents, y of shape (2 n, 1 + nz)."""
        y = ca.SX.sym("y", 2 * self.n, 1 + self.nz)
        return self.rk_step("variational_step", self._variational_rate, y)

    @cached_property
    def rk_step_along(self) -> ca.Function:
        """The same with one tangent more, that in a direction of the parameters, y of shape (2 n, 2 + nz)."""
        y = ca.SX.sym("y", 2 * self.n, 2 + self.nz)
        return self.rk_step("step_along", self._rate_along, y, along=True)

    @cached_property
    def start(self) -> ca.Function:
        """State of a section point and its derivative: (z, p) -> (y, dy/dz)."""
        z, p = ca.SX.sym("z", self.nz), ca.SX.sym("p", self.n_params)
        out = self.call("section_state", z=z, p=p)
        y = ca.vertcat(out["q"], out["v"])
        outputs = [ca.densify(y), ca.densify(ca.jacobian(y, z))]
        return ca.Function("start", [z, p], outputs, ["z", "p"], ["y", "dy_dz"])

    @cached_property
    def start_along(self) -> ca.Function:
        """(z, p, d) -> the state with its tangents at a section point, shape (2 n, 2 + nz)."""
        z, p, d = ca.SX.sym("z", self.nz), ca.SX.sym("p", self.n_params), ca.SX.sym("d", self.n_params)
        y, derivative = self.start(z, p)
        whole = ca.densify(ca.horzcat(y, derivative, ca.jtimes(y, p, d)))
        return ca.Function("start_along", [z, p, d], [whole], ["z", "p", "d"], ["y"])

    def _landing_expr(self, y: ca.SX, p: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Section point after the impact, and the touchdown condition before it."""
        values = {"q": y[: self.n], "v": y[self.n :], "p": p}
        after = self.call("impact_map", **values)
        names = {c: after["q_plus"][i] for i, c in enumerate(self.model.coordinates)}
        names |= {f"d{c}": after["v_plus"][i] for i, c in enumerate(self.model.coordinates)}
        return ca.vertcat(*[names[s] for s in self.model.section]), self.call(
            "touchdown_condition", **values
        )["h"]

    @cached_property
    def landing(self) -> ca.Function:
        """Residual from the state at the end of the step: (y, z, p) -> R."""
        _, y, p = self._symbols()
        z = ca.SX.sym("z", self.nz)
        after, condition = self._landing_expr(y, p)
        return ca.Function(
            "landing", [y, z, p], [ca.cse(ca.vertcat(after - z, condition))], ["y", "z", "p"], ["R"]
        )

    @cached_property
    def landing_with_derivative(self) -> ca.Function:
        """(y with tangents, z, T, p) -> (dR/d(z, T), R).

        The derivative with respect to the period is that of the flow, the rate at its end; the impact's
        derivative is the generated one.
        """
        _, _, p = self._symbols()
        y, z, period = ca.SX.sym("y", 2 * self.n, 1 + self.nz), ca.SX.sym("z", self.nz), ca.SX.sym("T")
        state = ca.SX.sym("state", 2 * self.n)
        after, condition = self._landing_expr(state, p)
        image = ca.vertcat(after, condition)
        slope = ca.densify(ca.substitute(ca.jacobian(image, state), state, y[:, 0]))
        end_rate = self.rate(period, y[:, 0], p)
        derivative = ca.horzcat(slope @ y[:, 1:], slope @ end_rate)
        derivative[: self.nz, : self.nz] -= ca.DM.eye(self.nz)
        residual = self.landing(y[:, 0], z, p)
        outputs = list(ca.cse([ca.densify(derivative), residual]))
        return ca.Function(
            "landing_with_derivative", [y, z, period, p], outputs, ["y", "z", "T", "p"], ["J", "R"]
        )

    @cached_property
    def landing_along(self) -> ca.Function:
        """(y with tangents, z, T, p, d) -> (dR/d(z, T), dR/dp d, R), the last tangent being that along d."""
        p, d = ca.SX.sym("p", self.n_params), ca.SX.sym("d", self.n_params)
        y, z, period = ca.SX.sym("y", 2 * self.n, 2 + self.nz), ca.SX.sym("z", self.nz), ca.SX.sym("T")
        derivative, residual = self.landing_with_derivative(y[:, :-1], z, period, p)
        state = ca.SX.sym("state", 2 * self.n)
        image = ca.vertcat(*self._landing_expr(state, p))
        moved = ca.jtimes(image, ca.vertcat(state, p), ca.vertcat(y[:, -1], d))
        moved = ca.substitute(moved, state, y[:, 0])
        outputs = list(ca.cse([derivative, ca.densify(moved), residual]))
        names = ["J", "R_d", "R"]
        return ca.Function("landing_along", [y, z, period, p, d], outputs, ["y", "z", "T", "p", "d"], names)

    # -- pieces of which a step of any number of RK steps is chained -----------------------------------------

    @cached_property
    def begin(self) -> ca.Function:
        """(u, p) -> the state with its tangents just after touchdown, shape (2 n, 1 + nz)."""
        u, p = ca.MX.sym("u", self.nz + 1), ca.MX.sym("p", self.n_params)
        y = ca.horzcat(*self.start(u[: self.nz], p))
        return ca.Function(f"{self.model.name}_begin", [u, p], [y], ["u", "p"], ["y"])

    @cached_property
    def swing(self) -> ca.Function:
        """`BLOCK` RK steps of size h of the state with its tangents: (t, h, y, p) -> y."""
        t, h, p = ca.MX.sym("t"), ca.MX.sym("h"), ca.MX.sym("p", self.n_params)
        y = ca.MX.sym("y", 2 * self.n, 1 + self.nz)
        end = self._variational_block(y, t, self.phase_increments(h, p), h, p)
        return ca.Function(f"{self.model.name}_swing", [t, h, y, p], [end], ["t", "h", "y", "p"], ["y_end"])

    @cached_property
    def end(self) -> ca.Function:
        """The residual from the state with its tangents at the end of the step: (y, u, p) -> (dR/du, R)."""
        y, p = ca.MX.sym("y", 2 * self.n, 1 + self.nz), ca.MX.sym("p", self.n_params)
        u = ca.MX.sym("u", self.nz + 1)
        outputs = self.landing_with_derivative(y, u[: self.nz], u[self.nz], p)
        return ca.Function(f"{self.model.name}_end", [y, u, p], list(outputs), ["y", "u", "p"], ["J", "R"])

    def plain_pieces(self) -> list[ca.Function]:
        """The same three pieces without tangents: (u, p) -> y, (t, h, y, p) -> y, and (y, u, p) -> R."""
        u, p = ca.MX.sym("u", self.nz + 1), ca.MX.sym("p", self.n_params)
        t, h, y = ca.MX.sym("t"), ca.MX.sym("h"), ca.MX.sym("y", 2 * self.n)
        end = self._plain_block(y, t, self.phase_increments(h, p), h, p)
        pieces = {
            "begin": ([u, p], self.start(u[: self.nz], p)[0]),
            "swing": ([t, h, y, p], end),
            "end": ([y, u, p], self.landing(y, u[: self.nz], p)),
        }
        return [
            ca.Function(f"{self.model.name}_plain_{name}", inputs, [ca.densify(output)])
            for name, (inputs, output) in pieces.items()
        ]

    # -- whole steps -------------------------------------------------------------------------------------

    def _block(self, rk_step: ca.Function) -> ca.Function:
        """`BLOCK` RK steps as one function, so that the C of a long chain stays short.

        (y, t, increments, h, p) -> y; steps with a direction of the parameters also take d
        """
        y0, p = ca.MX.sym("y", *rk_step.size_in("y")), ca.MX.sym("p", self.n_params)
        t, increments, h = ca.MX.sym("t"), ca.MX.sym("turns", 2, STAGES), ca.MX.sym("h")
        inputs = {"y": y0, "t": t, "turns": increments, "h": h, "p": p}
        along = "d" in rk_step.name_in()
        if along:
            inputs["d"] = ca.MX.sym("d", self.n_params)
        y = y0
        for i in range(BLOCK):
            now = t + i * h
            y = rk_step(y, self.phase(now, p), increments, h, p, *((now, inputs["d"]) if along else ()))
        return ca.Function(f"{rk_step.name()}s", [*inputs.values()], [y], [*inputs], ["y_end"])

    @cached_property
    def _plain_block(self) -> ca.Function:
        return self._block(self.plain_rk_step)

    @cached_property
    def _variational_block(self) -> ca.Function:
        return self._block(self.variational_rk_step)

    @cached_property
    def _block_along(self) -> ca.Function:
        return self._block(self.rk_step_along)

    def _flow(
        self, block: ca.Function, y: ca.MX, period: ca.MX, p: ca.MX, n_rk: int, *direction: ca.MX
    ) -> ca.MX:
        """The state after `period`; `n_rk` is a multiple of `BLOCK`."""
        h = period / n_rk
        increments = self.phase_increments(h, p)
        for i in range(0, n_rk, BLOCK):
            y = block(y, (i / n_rk) * period, increments, h, p, *direction)
        return y

    def residual(self, n_rk: int) -> ca.Function:
        """(u, p) -> R with u = (z, T) and a step of the walker cut into `n_rk` RK steps."""

        def outputs(z: ca.MX, period: ca.MX, p: ca.MX) -> list[ca.MX]:
            y = self._flow(self._plain_block, self.start(z, p)[0], period, p, n_rk)
            return [self.landing(y, z, p)]

        return self._of_whole_step(f"residual_{n_rk}", outputs, ["R"])

    def jacobian(self, n_rk: int) -> ca.Function:
        """(u, p) -> (dR/du, R), by forward sensitivities through every stage."""

        def outputs(z: ca.MX, period: ca.MX, p: ca.MX) -> list[ca.MX]:
            y = self._flow(self._variational_block, ca.horzcat(*self.start(z, p)), period, p, n_rk)
            return list(self.landing_with_derivative(y, z, period, p))

        return self._of_whole_step(f"jacobian_{n_rk}", outputs, ["J", "R"])

    def jacobian_along(self, n_rk: int) -> ca.Function:
        """(u, p, d) -> (dR/du, dR/dp d, R), for a direction d of the parameters."""

        def outputs(z: ca.MX, period: ca.MX, p: ca.MX, d: ca.MX) -> list[ca.MX]:
            y = self._flow(self._block_along, self.start_along(z, p, d), period, p, n_rk, d)
            return list(self.landing_along(y, z, period, p, d))

        return self._of_whole_step(f"jacobian_along_{n_rk}", outputs, ["J", "R_d", "R"], along=True)

    def _of_whole_step(
        self, name: str, outputs: Callable[..., list[ca.MX]], names: list[str], *, along: bool = False
    ) -> ca.Function:
        """A function of (u, p), given as one of (z, T, p); with `along` of d as well.

        Built once per name, to be printed once.
        """
        if name not in self._whole:
            inputs = {"u": ca.MX.sym("u", self.nz + 1), "p": ca.MX.sym("p", self.n_params)}
            inputs |= {"d": ca.MX.sym("d", self.n_params)} if along else {}
            u, *more = inputs.values()
            out = outputs(u[: self.nz], u[self.nz], *more)
            full = f"{self.model.name}_{name}"
            self._whole[name] = ca.Function(full, [*inputs.values()], out, [*inputs], names)
        return self._whole[name]

    def rootfinder(
        self,
        n_rk: int,
        iterations: int,
        abstol: float,
        abstol_step: float,
        jacobian_n_rk: int | None = None,
    ) -> ca.Function:
        """Newton's method on R as one CasADi rootfinder: (u0, p) -> u.

        It prints as a single C function. It stops at residual `abstol`, after a Newton step below
        `abstol_step` (the error left is of the order of its square), both in terms of the model's scales, or
        after `iterations`; whether it converged is for the caller to judge from the residual.

        With a smaller `jacobian_n_rk` the derivative is that of a coarser integration, which costs less and
        does not change what the iteration converges to.
        """
        value, derivative = self.residual(n_rk), self.jacobian(n_rk)
        if jacobian_n_rk is not None and jacobian_n_rk != n_rk:
            u, p = ca.MX.sym("u", self.nz + 1), ca.MX.sym("p", self.n_params)
            coarse, _ = self.jacobian(jacobian_n_rk)(u, p)
            outputs = [coarse, self.residual(n_rk)(u, p)]
            derivative = ca.Function(f"coarse_jacobian_{n_rk}", [u, p], outputs, ["u", "p"], ["J", "R"])
        options = {
            "jacobian_function": derivative,
            "abstol": abstol,
            "abstolStep": abstol_step,
            "max_iter": iterations,
            "error_on_fail": False,
        }
        scales = Scales.of(self.model)
        unknowns, rows = rounded(scales.unknowns), rounded(scales.residual)
        if (unknowns == 1).all() and (rows == 1).all():
            return ca.rootfinder(f"newton_{n_rk}", "fast_newton", value, options)
        # What is near to zero is decided in terms of the model's scales, not of its units.
        x, u0 = ca.MX.sym("x", self.nz + 1), ca.MX.sym("u0", self.nz + 1)
        p = ca.MX.sym("p", self.n_params)
        matrix, closing = derivative(unknowns * x, p)
        options["jacobian_function"] = ca.Function(
            f"scaled_jacobian_{n_rk}",
            [x, p],
            [ca.densify(matrix) * ca.DM(np.outer(1 / rows, unknowns)), closing / rows],
            ["u", "p"],
            ["J", "R"],
        )
        scaled = ca.Function(
            f"scaled_residual_{n_rk}", [x, p], [value(unknowns * x, p) / rows], ["u", "p"], ["R"]
        )
        finder = ca.rootfinder(f"newton_{n_rk}", "fast_newton", scaled, options)
        return ca.Function(f"scaled_newton_{n_rk}", [u0, p], [unknowns * finder(u0 / unknowns, p)])
