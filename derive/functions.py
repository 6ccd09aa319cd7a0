"""Every function that is emitted for a walker, as straight-line programs."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import sympy as sp

from stridemap.derive.declaration import TIME, Walker
from stridemap.derive.mechanics import Mechanics, simplified
from stridemap.derive.program import Argument, Builder, Entry, Output, Program

TIME_UNIT = "sqrt(L/g)"
GAIT = "Kamimura & Sano 2023"


@dataclass
class Functions:
    """The programs of one walker.

    Parameters
    ----------
    walker : Walker
    """

    walker: Walker
    mechanics: Mechanics = field(init=False)
    arguments: tuple[Argument, ...] = field(init=False)

    def __post_init__(self) -> None:
        w = self.walker
        self.mechanics = Mechanics(w)
        time = Entry(TIME, TIME_UNIT, "time since touchdown")
        q = tuple(Entry(c.symbol, c.unit, c.meaning) for c in w.coordinates)
        v = tuple(Entry(c.rate, _rate_unit(c.unit), f"rate of {c.name}") for c in w.coordinates)
        p = tuple(Entry(a.symbol, a.unit, a.meaning) for a in w.parameters)
        self.arguments = (
            Argument("t", (time,), scalar=True),
            Argument("q", q),
            Argument("v", v),
            Argument("p", p),
        )

    def programs(self) -> Iterator[Program]:
        """All programs, in the order in which they are printed."""
        yield self.mass_matrix()
        yield self.bias_forces()
        yield self.controller_torque()
        yield self.state_derivative()
        yield from self.state_derivative_jacobians()
        yield self.touchdown_condition()
        yield self.touchdown_condition_dq()
        yield self.impact_map()
        yield from self.impact_map_jacobians()
        yield self.impact_impulse()
        yield self.kinetic_energy()
        yield self.potential_energy()
        yield self.total_mass()
        yield self.centre_of_mass()
        yield self.ground_force()
        yield self.zmp()
        yield self.swing_foot()
        yield self.drawing()
        if self.walker.spring_mode is not None:
            yield self.spring_mode()
        yield self.section_state()

    def _close(
        self, builder: Builder, name: str, summary: str, source: str, outputs: list[Output]
    ) -> Program:
        return builder.close(name, summary, source, self.arguments, outputs)

    # -- swing phase -------------------------------------------------------------------------------------

    def mass_matrix(self) -> Program:
        """Mass matrix of the swing phase."""
        b = Builder()
        matrix = b.let_symmetric("M", self.mechanics.mass_matrix)
        out = Output("M", matrix, "mass matrix, symmetric positive definite")
        return self._close(b, "mass_matrix", "Mass matrix of the swing phase", f"{GAIT}, eq. (1)", [out])

    def bias_forces(self) -> Program:
        """Velocity terms, gravity and springs, each on the left-hand side of the equation of motion."""
        outputs = [Output("h", self.mechanics.velocity_terms, "Coriolis and centrifugal forces")]
        for name, force in self.mechanics.conservative_forces.items():
            outputs.append(Output(f"v_{name}", force, f"gradient of the potential energy of the {name}"))
        source = f"{GAIT}, eq. (1): M ddq + h + v = Q with v = " + " + ".join(o.name for o in outputs[1:])
        return self._close(Builder(), "bias_forces", "Bias forces of the swing phase", source, outputs)

    def controller_torque(self) -> Program:
        """Torque of the controller."""
        out = Output("u", self.walker.torque, "torque on " + self.walker.actuated.name)
        return self._close(
            Builder(),
            "controller_torque",
            "Torque of the oscillator-driven hip",
            f"{GAIT}, eqs. (3) and (4)",
            [out],
        )

    def _acceleration(self, b: Builder) -> tuple[sp.Matrix, tuple[sp.Matrix, list[sp.Expr]]]:
        """State the equation of motion and solve it; returns the accelerations and the factors of M."""
        m = self.mechanics
        n = m.mass_matrix.rows
        matrix = b.let_symmetric("M", m.mass_matrix)
        u = b.let("u", self.walker.torque)
        force = m.torque_vector(u) - m.velocity_terms - sum(m.conservative_forces.values(), sp.zeros(n, 1))
        right = b.let_vector("force", force)
        factors = b.factor("M", matrix)
        return b.solve("acc", factors, right), factors

    def state_derivative(self) -> Program:
        """Right-hand side of the swing phase."""
        b = Builder()
        acceleration, _ = self._acceleration(b)
        outputs = [
            Output("dq", self.walker.v, "rates of q"),
            Output("dv", acceleration, "accelerations: M dv = Q - h - v"),
        ]
        return self._close(
            b,
            "state_derivative",
            "Time derivative of the state in the swing phase",
            f"{GAIT}, eq. (1)",
            outputs,
        )

    def state_derivative_jacobians(self) -> Iterator[Program]:
        """Derivatives of the accelerations.

        They come from differentiating ``M a = Q - h - v`` with the accelerations `a` held, which keeps
        them as short as the equation of motion: ``M da = d(Q - h - v) - dM a``.
        """
        for name, wrt in (("q", self.walker.q), ("v", self.walker.v)):
            b = Builder()
            acceleration, factors = self._acceleration(b)
            m = self.mechanics
            held = sp.Matrix(sp.symbols(f"held_1:{len(wrt) + 1}", real=True))
            residual = m.torque_vector(self.walker.torque) - m.velocity_terms - m.mass_matrix * held
            residual -= sum(m.conservative_forces.values(), sp.zeros(len(wrt), 1))
            back = dict(zip(held, acceleration, strict=True))
            columns = []
            for j, symbol in enumerate(wrt, 1):
                right = residual.diff(symbol).applyfunc(simplified).xreplace(back)
                columns.append(b.solve(f"d{j}", factors, b.let_vector(f"r{j}", right)))
            out = Output(
                f"dv_d{name}", sp.Matrix.hstack(*columns), f"derivative of dv with respect to {name}"
            )
            source = f"{GAIT}, eq. (1), differentiated: M d(dv) = d(Q - h - v) - dM dv"
            yield self._close(
                b,
                f"state_derivative_d{name}",
                f"Derivative of the accelerations with respect to {name}",
                source,
                [out],
            )

    # -- touchdown and impact ----------------------------------------------------------------------------

    def touchdown_condition(self) -> Program:
        """Touchdown condition and its rate."""
        condition = sp.Matrix([self.walker.touchdown])
        rate = (condition.jacobian(self.walker.q) * self.walker.v)[0]
        outputs = [
            Output(
                "h",
                self.walker.touchdown,
                "zero with the swing foot on the ground; rises through zero at touchdown",
            ),
            Output("dh", rate, "rate of h"),
            Output("side", self.walker.touchdown_side, "negative at an admissible touchdown"),
        ]
        return self._close(
            Builder(), "touchdown_condition", "Touchdown condition", f"{GAIT}, below eq. (1)", outputs
        )

    def touchdown_condition_dq(self) -> Program:
        """Gradient of the touchdown condition."""
        gradient = sp.Matrix([self.walker.touchdown]).jacobian(self.walker.q).T
        out = Output("h_dq", gradient, "gradient of h")
        return self._close(
            Builder(),
            "touchdown_condition_dq",
            "Gradient of the touchdown condition",
            "derivative of h",
            [out],
        )

    def _impact(self, b: Builder) -> tuple[sp.Matrix, tuple[sp.Matrix, list[sp.Expr]]]:
        """Rates after the impact with the legs not swapped, and the factors of the impact mass matrix."""
        m = self.mechanics
        matrix = b.let_symmetric("A", m.impact_mass_matrix)
        momentum = b.let_vector("momentum", m.impact_momentum)
        factors = b.factor("A", matrix)
        return b.solve("after", factors, momentum), factors

    _IMPACT = "plastic impact: Me (v+ - v-) = J^T Lambda, J v+ = 0, projected on the velocities with J v = 0"

    def impact_map(self) -> Program:
        """State after touchdown, legs swapped."""
        b = Builder()
        after, _ = self._impact(b)
        outputs = [
            Output("q_plus", self.mechanics.relabelled_q, "coordinates after the legs swapped names"),
            Output("v_plus", self.mechanics.swap * after, "rates after the impact, legs swapped"),
        ]
        return self._close(
            b, "impact_map", "State just after touchdown from the state just before", self._IMPACT, outputs
        )

    def impact_map_jacobians(self) -> Iterator[Program]:
        """Derivatives of the rates after the impact: ``A dv+ = d(momentum) - dA v+``."""
        m = self.mechanics
        for name, wrt in (("q", self.walker.q), ("v", self.walker.v)):
            b = Builder()
            after, factors = self._impact(b)
            held = sp.Matrix(sp.symbols(f"held_1:{len(wrt) + 1}", real=True))
            residual = m.impact_momentum - m.impact_mass_matrix * held
            back = dict(zip(held, after, strict=True))
            columns = []
            for j, symbol in enumerate(wrt, 1):
                right = residual.diff(symbol).applyfunc(simplified).xreplace(back)
                columns.append(m.swap * b.solve(f"d{j}", factors, b.let_vector(f"r{j}", right)))
            out = Output(
                f"v_plus_d{name}", sp.Matrix.hstack(*columns), f"derivative of v_plus with respect to {name}"
            )
            summary = f"Derivative of the rates after touchdown with respect to {name}"
            yield self._close(b, f"impact_map_d{name}", summary, self._IMPACT + ", differentiated", [out])

    def impact_impulse(self) -> Program:
        """Impulse on the swing foot."""
        b = Builder()
        after, _ = self._impact(b)
        out = Output(
            "Lambda",
            self.mechanics.impact_impulse(after),
            "impulse on the swing foot, horizontal and vertical",
        )
        return self._close(b, "impact_impulse", "Impulse of the ground at touchdown", self._IMPACT, [out])

    # -- what is measured --------------------------------------------------------------------------------

    def kinetic_energy(self) -> Program:
        """Kinetic energy of the swing phase."""
        out = Output("kinetic", simplified(self.mechanics.kinetic_energy), "kinetic energy, in M g L")
        return self._close(
            Builder(), "kinetic_energy", "Kinetic energy of the swing phase", "v^T M v / 2", [out]
        )

    def potential_energy(self) -> Program:
        """Potential energy of gravity and springs."""
        held = simplified(self.mechanics.held(sum(self.mechanics.potentials.values())))
        out = Output("potential", held, "potential energy, in M g L, zero level on the ground")
        return self._close(
            Builder(),
            "potential_energy",
            "Potential energy of gravity and springs",
            "sum of m g y, and k x^2/2",
            [out],
        )

    def total_mass(self) -> Program:
        """Mass of the whole walker."""
        out = Output("mass", simplified(self.mechanics.total_mass), "mass, in M")
        return self._close(
            Builder(), "total_mass", "Mass of the whole walker", "sum of the point masses", [out]
        )

    def centre_of_mass(self) -> Program:
        """Centre of mass and its velocity."""
        position = self.mechanics.centre_of_mass
        velocity = (position.jacobian(self.walker.q) * self.walker.v).applyfunc(simplified)
        outputs = [
            Output("com", position, "centre of mass from the stance foot, horizontal and vertical"),
            Output("dcom", velocity, "velocity of the centre of mass"),
        ]
        return self._close(
            Builder(), "centre_of_mass", "Centre of mass of the whole walker", "mass-weighted mean", outputs
        )

    def ground_force(self) -> Program:
        """Force of the ground on the stance foot."""
        b = Builder()
        acceleration, _ = self._acceleration(b)
        out = Output(
            "force",
            self.mechanics.ground_force(acceleration),
            "force on the stance foot, horizontal and vertical",
        )
        source = "the two floating-base rows that hold the stance foot"
        return self._close(b, "ground_force", "Force of the ground on the stance foot", source, [out])

    def zmp(self) -> Program:
        """Zero moment point and its signed distance from the stance foot."""
        b = Builder()
        acceleration, _ = self._acceleration(b)
        fx, fy = b.let_vector("ground", self.mechanics.ground_force(acceleration))
        com_x, com_y = b.let_vector("com", self.mechanics.centre_of_mass)
        point = b.let("point", com_x - fx / fy * com_y)
        outputs = [
            Output("zmp", point, "zero moment point ahead of the stance foot"),
            Output("d", -point, "signed distance: stance foot minus zero moment point"),
        ]
        return self._close(
            b, "zmp", "Zero moment point", f"{GAIT}, eq. (6): p = x_g - x_g'' y_g / (1 + y_g'')", outputs
        )

    def swing_foot(self) -> Program:
        """Swing foot and its velocity."""
        position = self.mechanics.swing_foot
        velocity = (position.jacobian(self.walker.q) * self.walker.v).applyfunc(simplified)
        outputs = [
            Output("foot", position, "swing foot from the stance foot, horizontal and vertical"),
            Output("dfoot", velocity, "velocity of the swing foot"),
        ]
        return self._close(Builder(), "swing_foot", "Swing foot", "geometry of the legs", outputs)

    def drawing(self) -> Program:
        """What the walker is drawn by: its masses, where they are, and the lines between points."""
        m = self.mechanics

        def rows(points: Iterable[sp.Matrix]) -> sp.Matrix:
            return sp.Matrix.vstack(*(m.held(point).T.applyfunc(simplified) for point in points))

        masses = self.walker.masses
        outputs = [
            Output(
                "positions", rows(a.position for a in masses), "point masses from the stance foot, a row each"
            ),
            Output("masses", sp.Matrix([a.mass for a in masses]), "the masses themselves, in M"),
        ]
        outputs += [
            Output(line.name, rows(line.points), f"points of the line, a row each: {line.name}")
            for line in self.walker.drawing
        ]
        names = ", ".join(a.name for a in masses)
        return self._close(
            Builder(), "drawing", "What the walker is drawn by", f"geometry; masses: {names}", outputs
        )

    def section_state(self) -> Program:
        """Coordinates and rates of a point on the section."""
        w = self.walker
        solved, value = w.section_solves
        entries = {e.symbol.name: e for a in self.arguments for e in a.entries}
        section = Argument("z", tuple(entries[name] for name in w.section))
        outputs = [
            Output("q", w.q.subs(solved, value), "coordinates just after touchdown"),
            Output("v", w.v, "rates just after touchdown"),
        ]
        summary = "State of a point on the Poincare section (the instant just after touchdown)"
        return Builder().close("section_state", summary, f"{solved} = {value} there", (section,), outputs)

    def spring_mode(self) -> Program:
        """Natural frequency that names the solution groups."""
        out = Output(
            "frequency", self.walker.spring_mode, "natural frequency of the spring mode with the hip free"
        )
        return self._close(
            Builder(), "spring_mode", "Frequency of the spring mode", "sqrt(k / (alpha (1 - alpha)))", [out]
        )


def _rate_unit(unit: str) -> str:
    return f"{unit} sqrt(g/L)"
