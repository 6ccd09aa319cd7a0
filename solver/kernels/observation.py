"""What is observed along a step, with time derivatives, as straight-line CasADi functions."""

from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from stridemap.solver.kernels.dormand_prince import STAGES
from stridemap.solver.kernels.step_map import BLOCK, StepMap
from stridemap.solver.model.model import Model

OBSERVABLES = ("d", "cop", "vertical_force", "friction", "foot_height", "peak", "touchdown", "wobble")
"""Row order of the observables.

`d`, the paper's distance; `cop`, centre of pressure ahead of the contact; vertical ground force; horizontal
over vertical ground force;
height of the swing foot; acceleration of the stance angle (zero where its rate is extreme);
touchdown condition; position of the wobbling mass. Zero where a model has no such angle or mass. The power
of each motor follows, then the torque of each.
"""


def power(motor: str) -> str:
    """Name of the row that holds the power of a motor."""
    return f"power_{motor}"


def torque(motor: str) -> str:
    """Name of the row that holds the torque, or the force, of a motor."""
    return f"torque_{motor}"


def declared(quantity: str) -> str:
    """Name of the row that holds the expression of a quantity that the model file declares."""
    return f"quantity_{quantity}"


def observables(model: Model) -> tuple[str, ...]:
    """Names of the rows: `OBSERVABLES`, powers and torques of the motors, what the model file declares."""
    motors = (*map(power, model.actuated), *map(torque, model.actuated))
    return (*OBSERVABLES, *motors, *(declared(one.name) for one in model.spec.quantities))


@dataclass(frozen=True)
class Observation:
    """Builds the observing functions of one model.

    Parameters
    ----------
    step_map : StepMap
    """

    step_map: StepMap

    @property
    def width(self) -> int:
        """Length of the state with the net work of each motor."""
        return 2 * self.step_map.n + len(self.step_map.model.actuated)

    def _values(self, t: ca.SX, y: ca.SX, p: ca.SX) -> ca.SX:
        sm, spec = self.step_map, self.step_map.model.spec
        values = {"t": t, "q": y[: sm.n], "v": y[sm.n :], "p": p}
        coordinates = sm.model.coordinates
        force = sm.call("ground_force", **values)["force"]
        wobbling, stance = spec.wobbling, spec.stance_angle
        rows = {
            "d": sm.call("zmp", **values)["d"],
            "cop": sm.call("centre_of_pressure", **values)["offset"],
            "vertical_force": force[1],
            "friction": force[0] / force[1],
            "foot_height": sm.call("swing_foot", **values)["foot"][1],
            "peak": sm.rate(t, y, p)[sm.n + coordinates.index(stance)] if stance else ca.SX(0),
            "touchdown": sm.call("touchdown_condition", **values)["h"],
            "wobble": y[coordinates.index(wobbling)] if wobbling else ca.SX(0),
        }
        own = sm.call("quantities", **values) if spec.quantities else {}
        own_rows = [own[one.name] for one in spec.quantities]
        torques = self._torques(t, y, p)
        motors = [self._powers(torques, y, p), torques]
        return ca.vertcat(*[rows[name] for name in OBSERVABLES], *motors, *own_rows)

    def _torques(self, t: ca.SX, y: ca.SX, p: ca.SX) -> ca.SX:
        """Torque of each motor."""
        sm = self.step_map
        if not sm.model.actuated:
            return ca.SX(0, 1)
        return sm.call("controller_torque", t=t, q=y[: sm.n], v=y[sm.n :], p=p)["u"]

    def _powers(self, torques: ca.SX, y: ca.SX, p: ca.SX) -> ca.SX:
        """Power of each motor: its torque times the rate of what it drives."""
        sm = self.step_map
        if not sm.model.actuated:
            return ca.SX(0, 1)
        return torques * sm.call("motor_rates", q=y[: sm.n], v=y[sm.n :], p=p)["rate"]

    def _working_rate(self, phase: ca.SX, w: ca.SX, p: ca.SX) -> ca.SX:
        """Time derivative of the state and of each motor's net work."""
        sm = self.step_map
        y = w[: 2 * sm.n]
        if not sm.model.actuated:
            return sm.rate_at_phase(phase, y, p)
        torques = sm.at_phase("controller_torque", phase, q=y[: sm.n], v=y[sm.n :], p=p)["u"]
        return ca.vertcat(sm.rate_at_phase(phase, y, p), self._powers(torques, y, p))

    @cached_property
    def observe(self) -> ca.Function:
        """(t, y, p) -> (values, their time derivatives), as many rows as there are observables."""
        sm = self.step_map
        t, y, p = ca.SX.sym("t"), ca.SX.sym("y", 2 * sm.n), ca.SX.sym("p", sm.n_params)
        values = self._values(t, y, p)
        along = ca.jtimes(values, ca.vertcat(t, y), ca.vertcat(1, sm.rate(t, y, p)))
        outputs = [ca.densify(e) for e in ca.cse([values, along])]
        return ca.Function("observe", [t, y, p], outputs, ["t", "y", "p"], ["g", "dg"])

    @cached_property
    def working_rk_step(self) -> ca.Function:
        """One RK step of state and net works: (y, phase, increments, h, p) -> y with y = (state, works)."""
        sm = self.step_map
        return sm.rk_step("working_step", self._working_rate, ca.SX.sym("w", self.width))

    @cached_property
    def advance(self) -> ca.Function:
        """One Runge-Kutta step of any size from a node, observed: (t, w, h, p) -> (w, g, dg)."""
        sm = self.step_map
        t, w, h = ca.MX.sym("t"), ca.MX.sym("w", self.width), ca.MX.sym("h")
        p = ca.MX.sym("p", sm.n_params)
        end = self.working_rk_step(w, sm.phase(t, p), sm.phase_increments(h, p), h, p)
        g, dg = self.observe(t + h, end[: 2 * sm.n], p)
        return ca.Function(
            f"{sm.model.name}_advance", [t, w, h, p], [end, g, dg], ["t", "w", "h", "p"], ["w_end", "g", "dg"]
        )

    @cached_property
    def _block(self) -> ca.Function:
        """`BLOCK` working RK steps, observed at the start of each.

        (t, increments, w, h, p) -> (w_end, nodes, g, dg)
        """
        sm = self.step_map
        t, w, h = ca.MX.sym("t"), ca.MX.sym("w", self.width), ca.MX.sym("h")
        p, increments = ca.MX.sym("p", sm.n_params), ca.MX.sym("turns", 2, STAGES)
        nodes = [w]
        for i in range(BLOCK):
            nodes.append(self.working_rk_step(nodes[-1], sm.phase(t + i * h, p), increments, h, p))
        # Every node is kept: just after touchdown the power can cross zero several times between two.
        seen = [self.observe(t + i * h, node[: 2 * sm.n], p) for i, node in enumerate(nodes[:-1])]
        outputs = [
            nodes[-1],
            ca.horzcat(*nodes[:-1]),
            ca.horzcat(*[s[0] for s in seen]),
            ca.horzcat(*[s[1] for s in seen]),
        ]
        inputs = {"t": t, "turns": increments, "w": w, "h": h, "p": p}
        return ca.Function(
            "working_steps", [*inputs.values()], outputs, [*inputs], ["w_end", "nodes", "g", "dg"]
        )

    @cached_property
    def observed_swing(self) -> ca.Function:
        """`BLOCK` working RK steps, observed at the start of each: (t, h, w, p) -> (w_end, nodes, g, dg)."""
        sm = self.step_map
        t, h, w = ca.MX.sym("t"), ca.MX.sym("h"), ca.MX.sym("w", self.width)
        p = ca.MX.sym("p", sm.n_params)
        outputs = self._block(t, sm.phase_increments(h, p), w, h, p)
        names = ["w_end", "nodes", "g", "dg"]
        return ca.Function(
            f"{sm.model.name}_observed_swing", [t, h, w, p], list(outputs), ["t", "h", "w", "p"], names
        )

    def trace(self, n_rk: int) -> ca.Function:
        """A whole step of `n_rk` RK steps, observed at n_rk + 1 nodes.

        (u, p) -> (w, g, dg, R): state and net works at the nodes, shape (width, n_rk + 1),
        observables and their derivatives at the nodes, and the residual at this resolution.
        """
        sm = self.step_map
        u, p = ca.MX.sym("u", sm.nz + 1), ca.MX.sym("p", sm.n_params)
        z, period = u[: sm.nz], u[sm.nz]
        w = ca.vertcat(sm.start(z, p)[0], ca.DM.zeros(len(sm.model.actuated)))
        parts = []
        h = period / n_rk
        increments = sm.phase_increments(h, p)
        for i in range(0, n_rk, BLOCK):
            w, *part = self._block((i / n_rk) * period, increments, w, h, p)
            parts.append(part)
        parts.append([w, *self.observe(period, w[: 2 * sm.n], p)])
        nodes, g, dg = (ca.horzcat(*column) for column in zip(*parts, strict=True))
        residual = sm.landing(w[: 2 * sm.n], z, p)
        return ca.Function(
            f"{sm.model.name}_trace_{n_rk}",
            [u, p],
            [nodes, g, dg, residual],
            ["u", "p"],
            ["w", "g", "dg", "R"],
        )
