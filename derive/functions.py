"""Every function that is emitted for a walker, as straight-line programs."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.ground import in_ground_frame
from stridemap.derive.mechanics import Mechanics
from stridemap.derive.motors import kind_of
from stridemap.derive.parts import TIME, Motor
from stridemap.derive.program import Argument, Builder, Entry, Factors, Output, Program, free
from stridemap.derive.simplify import simplified, start_afresh
from stridemap.derive.steps import in_steps

ALWAYS = 24
"""Programs that every walker has."""

DEFAULT_SOURCES = {
    "mass_matrix": "M ddq + h + v = Q",
    "bias_forces": "M ddq + h + v = Q",
    "controller_torque": "the model's declaration",
    "motor_rates": "the model's declaration",
    "state_derivative": "M ddq + h + v = Q",
    "touchdown_condition": "the model's declaration",
    "impact_map": "plastic impact: Me (v+ - v-) = J^T Lambda, J v+ = 0, "
    "projected on the velocities with J v = 0",
    "zmp": "p = x_g - F_x / F_y y_g with the ground force F",
}
"""Sources of equations for which a declaration names none."""


@dataclass
class Functions:
    """The programs of one walker.

    Parameters
    ----------
    walker : Walker
    """

    walker: Declaration
    mechanics: Mechanics = field(init=False)
    arguments: tuple[Argument, ...] = field(init=False)

    def __post_init__(self) -> None:
        start_afresh()
        self.walker = w = in_ground_frame(self.walker)
        self.mechanics = Mechanics(in_steps(w))
        time = Entry(TIME, w.units.time, "time since touchdown")
        q = tuple(Entry(c.symbol, c.unit, c.meaning) for c in w.coordinates)
        v = tuple(Entry(c.rate, w.units.rate(c.unit), f"rate of {c.name}") for c in w.coordinates)
        p = tuple(Entry(a.symbol, a.unit, a.meaning) for a in w.parameters)
        taken = {*"tqvup", *(e.symbol.name for e in (time, *q, *v, *p))}
        self.arguments = (
            Argument("t", (time,), scalar=True),
            Argument("q", q),
            Argument("v", v),
            Argument("u", tuple(_torque_entry(w, motor, taken) for motor in w.actuators)),
            Argument("p", p),
        )

    def programs(self) -> Iterator[Program]:
        """All programs, in the order in which they are printed."""
        yield self.mass_matrix()
        yield self.bias_forces()
        if self.walker.actuators:
            yield self.controller_torque()
            yield self.motor_rates()
        yield self.state_derivative()
        yield from self.state_derivative_jacobians()
        yield from self.forward_dynamics()
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
        yield self.centre_of_pressure()
        yield self.swing_foot()
        yield self.stance_foot()
        yield self.drawing()
        if self.walker.quantities:
            yield self.quantities()
        if self.walker.spring_mode is not None:
            yield self.spring_mode()
        yield self.section_state()
        yield self.before_touchdown()
        yield self.step_length()

    @property
    def count(self) -> int:
        """How many programs there are, known before any is derived."""
        w = self.walker
        optional = [w.quantities, w.spring_mode is not None]
        forward = len(self._forward_inputs)
        return ALWAYS + sum(map(bool, optional)) + 2 * bool(w.actuators) + forward + bool(forward)

    def _builder(self) -> Builder:
        return Builder(self.arguments)

    def _source(self, function: str) -> str:
        return self.walker.sources.get(function, DEFAULT_SOURCES[function])

    # -- swing phase -------------------------------------------------------------------------------------

    def mass_matrix(self) -> Program:
        """Mass matrix of the swing phase."""
        b = self._builder()
        m = self.mechanics
        matrix = b.let_matrix("M", m.mass_matrix, m.symmetric)
        meaning = "mass matrix, symmetric positive definite"
        if self.walker.massless is not None:
            rows = ", ".join(c.name for c in self.walker.massless.coordinates)
            meaning = f"mass matrix in the limit {self.walker.massless.mass} -> 0, by which {rows} is divided"
        out = Output("M", matrix, meaning, is_matrix=True)
        return b.close("mass_matrix", "Mass matrix of the swing phase", self._source("mass_matrix"), [out])

    def bias_forces(self) -> Program:
        """Velocity terms, gravity, springs and dampers, on the left-hand side of the equation of motion."""
        outputs = [Output("h", self.mechanics.velocity_terms, "Coriolis and centrifugal forces")]
        for name, force in self.mechanics.conservative_forces.items():
            outputs.append(Output(f"v_{name}", force, f"gradient of the {name} potential"))
        terms = " + ".join(o.name for o in outputs[1:])
        damping = ""
        if self.walker.dissipation != 0:
            outputs.append(Output("damping", self.mechanics.dissipative_force, "force of the dampers"))
            damping = " + damping"
        equation = f"M ddq + h + v{damping} = Q with v = {terms}"
        known = self._source("bias_forces")
        source = equation if known.startswith("M ddq") else f"{known}: {equation}"
        return self._builder().close("bias_forces", "Bias forces of the swing phase", source, outputs)

    def controller_torque(self) -> Program:
        """Torques of the controller."""
        motors = self.walker.actuators
        names = ", ".join(motor.name for motor in motors)
        out = Output(
            "u", self.mechanics.applied_torques, f"torque of the motor{'s' * (len(motors) > 1)} {names}"
        )
        summary = "Torque of the controller" if len(motors) == 1 else "Torques of the controller"
        return self._builder().close("controller_torque", summary, self._source("controller_torque"), [out])

    def motor_rates(self) -> Program:
        """What the motors drive, and its rates."""
        names = ", ".join(motor.name for motor in self.walker.actuators)
        outputs = [
            Output("driven", self.mechanics.driven, f"angle or length that each motor drives: {names}"),
            Output("rate", self.mechanics.motor_rates, "its rate; times the torque it is the motor's power"),
        ]
        summary = "What each motor drives, with its rate"
        return self._builder().close("motor_rates", summary, self._source("motor_rates"), outputs)

    def _force(self, torques: Iterable[sp.Expr]) -> sp.Matrix:
        m = self.mechanics
        return m.torque_vector(torques) + m.passive_force()

    def _acceleration(self, b: Builder) -> tuple[sp.Matrix, Factors]:
        """State the equation of motion and solve it; returns the accelerations and the factors of M."""
        m = self.mechanics
        matrix = b.let_matrix("M", m.mass_matrix, m.symmetric)
        name = "torque" if len(m.controller) == 1 else "torque_{}"
        torques = [b.let(name.format(i), u) for i, u in enumerate(m.controller, 1)]
        right = b.let_vector("force", self._force(torques))
        factors = b.factor("M", matrix, m.symmetric)
        return b.solve("acc", factors, right), factors

    def state_derivative(self) -> Program:
        """Right-hand side of the swing phase."""
        b = self._builder()
        acceleration, _ = self._acceleration(b)
        outputs = [
            Output("dq", self.walker.v, "rates of q"),
            Output("dv", acceleration, "accelerations: M dv = Q - h - v"),
        ]
        summary = "Time derivative of the state in the swing phase"
        return b.close("state_derivative", summary, self._source("state_derivative"), outputs)

    def state_derivative_jacobians(self) -> Iterator[Program]:
        """Derivatives of the accelerations.

        They come from differentiating ``M a = Q - h - v`` with the accelerations `a` held constant, which
        keeps them as short as the equation of motion: ``M da = d(Q - h - v) - dM a``.
        """
        source = self._source("state_derivative")
        for name, wrt in (("q", self.walker.q), ("v", self.walker.v)):
            b = self._builder()
            acceleration, factors = self._acceleration(b)
            constant = self._constant(b, len(wrt))
            residual = self._force(self.mechanics.controller) - self.mechanics.mass_matrix * constant
            columns = self._columns(b, residual, wrt, constant, acceleration, factors)
            meaning = f"derivative of dv with respect to {name}"
            out = Output(f"dv_d{name}", sp.Matrix.hstack(*columns), meaning, is_matrix=True)
            yield b.close(
                f"state_derivative_d{name}",
                f"Derivative of the accelerations with respect to {name}",
                f"{source}, differentiated: M d(dv) = d(Q - h - v) - dM dv",
                [out],
            )

    @staticmethod
    def _constant(b: Builder, size: int) -> sp.Matrix:
        """Symbols that stand for a solution while the equations around it are differentiated."""
        return sp.Matrix([b.symbol(f"held_{i}") for i in range(1, size + 1)])

    @staticmethod
    def _columns(
        b: Builder,
        residual: sp.Matrix,
        wrt: sp.Matrix,
        constant: sp.Matrix,
        solution: sp.Matrix,
        factors: Factors,
        shorten: bool = True,
    ) -> list[sp.Matrix]:
        """Derivatives of the solution of ``residual = 0``, in which it stands as `constant`."""
        back = dict(zip(constant, solution, strict=True))
        columns = []
        for j, symbol in enumerate(wrt, 1):
            right = residual.diff(symbol)
            right = (right.applyfunc(simplified) if shorten else right).xreplace(back)
            columns.append(b.solve(f"d{j}", factors, b.let_vector(f"r{j}", right, shorten)))
        return columns

    # -- touchdown and impact ----------------------------------------------------------------------------

    def touchdown_condition(self) -> Program:
        """Touchdown condition and its rate."""
        condition = sp.Matrix([self.walker.guard])
        rate = (condition.jacobian(self.walker.q) * self.walker.v)[0]
        meaning = "zero with the swing foot on the ground; rises through zero at touchdown"
        outputs = [
            Output("h", self.walker.guard, meaning),
            Output("dh", rate, "rate of h"),
            Output("side", self.walker.touchdown.region, "negative at an admissible touchdown"),
        ]
        source = self._source("touchdown_condition")
        return self._builder().close("touchdown_condition", "Touchdown condition", source, outputs)

    def touchdown_condition_dq(self) -> Program:
        """Gradient of the touchdown condition."""
        gradient = sp.Matrix([self.walker.guard]).jacobian(self.walker.q).T
        out = Output("h_dq", gradient, "gradient of h")
        summary = "Gradient of the touchdown condition"
        return self._builder().close("touchdown_condition_dq", summary, "derivative of h", [out])

    def _impact(self, b: Builder) -> tuple[sp.Matrix, Factors]:
        """Rates after touchdown in the new names (and the locks' forces), and the factors."""
        symmetric = self.mechanics.symmetric
        equations, right = self.mechanics.impact_equations
        matrix = b.let_matrix("A", equations, symmetric)
        momentum = b.let_vector("momentum", right)
        factors = b.factor("A", matrix, symmetric)
        return b.solve("after", factors, momentum), factors

    @property
    def _n(self) -> int:
        return len(self.walker.coordinates)

    def impact_map(self) -> Program:
        """State after touchdown, legs swapped."""
        b = self._builder()
        after, _ = self._impact(b)
        outputs = [
            Output("q_plus", self.mechanics.relabelled_q, "coordinates after the legs swapped names"),
            Output("v_plus", after[: self._n, :], "rates after the impact, legs swapped"),
        ]
        summary = "State just after touchdown from the state just before"
        return b.close("impact_map", summary, self._source("impact_map"), outputs)

    def impact_map_jacobians(self) -> Iterator[Program]:
        """Derivatives of the rates after the impact: ``A dv+ = d(momentum) - dA v+``."""
        equations, right = self.mechanics.impact_equations
        for name, wrt in (("q", self.walker.q), ("v", self.walker.v)):
            b = self._builder()
            after, factors = self._impact(b)
            constant = self._constant(b, len(after))
            columns = self._columns(b, right - equations * constant, wrt, constant, after, factors)
            value = sp.Matrix.hstack(*(c[: self._n, :] for c in columns))
            meaning = f"derivative of v_plus with respect to {name}"
            out = Output(f"v_plus_d{name}", value, meaning, is_matrix=True)
            summary = f"Derivative of the rates after touchdown with respect to {name}"
            source = f"{self._source('impact_map')}, differentiated"
            yield b.close(f"impact_map_d{name}", summary, source, [out])

    def impact_impulse(self) -> Program:
        """Impulse on the swing foot."""
        b = self._builder()
        after, _ = self._impact(b)
        value = self.mechanics.impact_impulse(after[: self._n, :])
        out = Output("Lambda", value, "impulse on the swing foot, horizontal and vertical")
        source = self._source("impact_map")
        return b.close("impact_impulse", "Impulse of the ground at touchdown", source, [out])

    # -- what is measured --------------------------------------------------------------------------------

    def kinetic_energy(self) -> Program:
        """Kinetic energy of the swing phase."""
        energy = self.walker.units.energy
        out = Output("kinetic", simplified(self.mechanics.kinetic_energy), f"kinetic energy, in {energy}")
        return self._builder().close(
            "kinetic_energy", "Kinetic energy of the swing phase", "v^T M v / 2", [out]
        )

    def potential_energy(self) -> Program:
        """Potential energy of gravity and springs."""
        energy = self.walker.units.energy
        value = simplified(self.mechanics.potential_energy)
        out = Output("potential", value, f"potential energy, in {energy}, zero level on the ground")
        terms = ", ".join(self.mechanics.potentials)
        return self._builder().close("potential_energy", "Potential energy", f"sum over {terms}", [out])

    def total_mass(self) -> Program:
        """Mass and weight of the whole walker."""
        outputs = [
            Output("mass", simplified(self.mechanics.total_mass), f"mass, in {self.walker.units.mass}"),
            Output("weight", self.mechanics.weight, "mass times the acceleration of gravity"),
            Output(
                "pull",
                self.mechanics.tangential_weight,
                "component of the weight along the ground, in walking direction",
            ),
            Output("press", self.mechanics.normal_weight, "component of the weight into the ground"),
        ]
        summary = "Mass and weight of the whole walker"
        return self._builder().close("total_mass", summary, "sum over the bodies", outputs)

    def centre_of_mass(self) -> Program:
        """Centre of mass and its velocity."""
        position = self.mechanics.centre_of_mass
        velocity = (position.jacobian(self.walker.q) * self.walker.v).applyfunc(simplified)
        outputs = [
            Output("com", position, "centre of mass from the stance foot, horizontal and vertical"),
            Output("dcom", velocity, "velocity of the centre of mass"),
        ]
        summary = "Centre of mass of the whole walker"
        return self._builder().close("centre_of_mass", summary, "mass-weighted mean", outputs)

    def ground_force(self) -> Program:
        """Force of the ground on the stance foot."""
        b = self._builder()
        acceleration, _ = self._acceleration(b)
        force = self._ground_force(b, acceleration)
        out = Output("force", force, "force on the stance foot, horizontal and vertical")
        source = "the two floating-base rows that hold the stance foot"
        return b.close("ground_force", "Force of the ground on the stance foot", source, [out])

    def _ground_force(self, b: Builder, acceleration: sp.Matrix) -> sp.Matrix:
        m = self.mechanics
        torques = m.applied_torques
        if not m.motor_base_jacobian.is_zero_matrix:  # else none of them reaches the ground but by the foot
            torques = b.let_vector("applied", torques)
        return m.ground_force(acceleration, torques)

    def zmp(self) -> Program:
        """The paper's point: where the ground force's line through the centre of mass meets the ground."""
        b = self._builder()
        acceleration, _ = self._acceleration(b)
        fx, fy = b.let_vector("ground", self._ground_force(b, acceleration))
        com_x, com_y = b.let_vector("com", self.mechanics.centre_of_mass)
        point = b.let("point", com_x - fx / fy * com_y - self.walker.stance[0])
        outputs = [
            Output("zmp", point, "the paper's zero moment point, ahead of the stance foot"),
            Output("d", -point, "the paper's distance d: stance foot minus this point"),
        ]
        source = DEFAULT_SOURCES["zmp"]
        if "zmp" in self.walker.sources:
            source = f"{self.walker.sources['zmp']}: p = x_g - x_g'' y_g / (1 + y_g'')"
        summary = "The paper's zero moment point, which leaves out the change of angular momentum"
        return b.close("zmp", summary, source, outputs)

    def centre_of_pressure(self) -> Program:
        """Where the ground force acts, from the moment about the contact."""
        b = self._builder()
        contact = self.walker.stance[0]
        # The force matters where there is a moment; symbols show that before it is worked out.
        stand_in = sp.Matrix(sp.symbols("ground_x ground_y", real=True))
        m = self.mechanics
        torques = m.applied_torques
        if len(torques):
            torques = b.let_vector("applied", torques)
        moment = m.contact_moment(stand_in, torques)
        offset = sp.S.Zero
        if moment != 0:
            acceleration, _ = self._acceleration(b)
            force = b.let_vector("ground", m.ground_force(acceleration, torques))
            moment = b.let("about_contact", moment.xreplace(dict(zip(stand_in, force, strict=True))))
            offset = b.let("ahead", moment / force[1])
        outputs = [
            Output("cop", contact + offset, "centre of pressure, along the ground"),
            Output("offset", offset, "from the contact, which is straight below the stance foot, to it"),
            Output("moment", moment, "moment of the ground about the contact, positive from x to y"),
        ]
        source = "angular momentum about the contact: its change is that of gravity and of this moment"
        return b.close("centre_of_pressure", "Centre of pressure", source, outputs)

    def swing_foot(self) -> Program:
        """Swing foot and its velocity."""
        position = self.mechanics.swing_foot
        velocity = (position.jacobian(self.walker.q) * self.walker.v).applyfunc(simplified)
        outputs = [
            Output("foot", position, "swing foot from the stance foot, horizontal and vertical"),
            Output("dfoot", velocity, "velocity of the swing foot"),
        ]
        return self._builder().close("swing_foot", "Swing foot", "geometry of the legs", outputs)

    def stance_foot(self) -> Program:
        """Stance foot: where a foot that rolls has rolled to."""
        meaning = "stance foot (the centre of a round foot's arc), horizontal and vertical"
        out = Output("stance", self.walker.stance, meaning)
        source = "the origin for a point foot; a round foot rolls without slip"
        return self._builder().close("stance_foot", "Stance foot", source, [out])

    def drawing(self) -> Program:
        """What the walker is drawn by: its bodies, where they are, and the lines between points."""
        m = self.mechanics

        def rows(points: Iterable[sp.Matrix]) -> sp.Matrix:
            return sp.Matrix.vstack(*(m.on_stance(point).T.applyfunc(simplified) for point in points))

        bodies = self.walker.bodies
        masses = sp.Matrix([m.without_massless(sp.sympify(body.mass)) for body in bodies])
        outputs = [
            Output(
                "positions",
                rows(body.position for body in bodies),
                "positions of the bodies from the stance foot, one row each",
            ),
            Output("masses", masses, f"their masses, in {self.walker.units.mass}"),
        ]
        outputs += [
            Output(line.name, rows(line.points), f"points of the line {line.name}, one row each")
            for line in self.walker.drawing
        ]
        source = f"geometry; bodies: {', '.join(body.name for body in bodies)}"
        return self._builder().close("drawing", "What the walker is drawn by", source, outputs)

    def quantities(self) -> Program:
        """What the walker declares to be measured, along a step."""
        outputs = [Output(one.name, simplified(one.expression), one.label) for one in self.walker.quantities]
        summary = "Expressions of the quantities that the model declares"
        return self._builder().close("quantities", summary, "the model's declaration", outputs)

    # -- the section -------------------------------------------------------------------------------------

    def section_state(self) -> Program:
        """Coordinates and rates of a point on the section."""
        w = self.walker
        entries = {e.symbol.name: e for a in self.arguments for e in a.entries}
        section = Argument("z", tuple(entries[name] for name in w.section_names))
        outputs = [
            Output("q", w.q.subs(w.section), "coordinates just after touchdown"),
            Output("v", w.v.subs(w.section), "rates just after touchdown"),
        ]
        summary = "State of a point on the Poincare section (the instant just after touchdown)"
        fixed = ", ".join(f"{symbol} = {value}" for symbol, value in w.section.items())
        source = f"{fixed} there" if fixed else "all coordinates and rates are free there"
        return Builder((section, self.arguments[-1])).close("section_state", summary, source, outputs)

    def before_touchdown(self) -> Program:
        """Coordinates before the legs swapped names."""
        out = Output("q_minus", self.mechanics.before_touchdown, "coordinates just before it")
        summary = "Coordinates just before touchdown from those just after"
        return self._builder().close("before_touchdown", summary, "the legs' names swapped back", [out])

    def step_length(self) -> Program:
        """Length of the step that ended with a touchdown."""
        outputs = [
            Output(
                "length", self.mechanics.step_length, "from the old stance foot to the new, along the ground"
            ),
            Output(
                "rise", self.mechanics.step_rise, "from the old stance foot to the new, away from the ground"
            ),
        ]
        summary = "Length of the step from the coordinates just after touchdown"
        return self._builder().close("step_length", summary, "geometry of the legs", outputs)

    def spring_mode(self) -> Program:
        """Natural frequency that names the solution groups."""
        value = self.walker.spring_mode
        out = Output("frequency", value, "natural frequency that names the solution groups")
        summary = "Natural frequency whose whole oscillations name the solution groups"
        return self._builder().close("spring_mode", summary, str(value), [out])

    # -- forward dynamics with the torques as an input ---------------------------------------------------

    @property
    def _forward_inputs(self) -> dict[str, sp.Matrix]:
        """What the forward dynamics is differentiated by, where there is any of it; empty without it.

        In a massless limit, a torque on what has no mass is of the order of the mass: it is no input.
        """
        if not self.mechanics.takes_torques:
            return {}
        w = self.walker
        inputs = {"q": w.q, "v": w.v, "u": self._torques, "p": sp.Matrix([a.symbol for a in w.parameters])}
        return {name: wrt for name, wrt in inputs.items() if len(wrt)}

    @property
    def _torques(self) -> sp.Matrix:
        """Symbols of the torques that are given, shape (n_motors, 1)."""
        entries = next(a.entries for a in self.arguments if a.name == "u")
        return sp.Matrix(len(entries), 1, [e.symbol for e in entries])

    def forward_dynamics(self) -> Iterator[Program]:
        """Accelerations for torques that are given, and their derivatives: the matrices of a linearisation.

        As for `state_derivative_jacobians`, the equation of motion is differentiated, not its solution.
        """
        source = f"{self._source('state_derivative')} with the torques u in Q"
        for name in ("", *self._forward_inputs) if self._forward_inputs else ():
            b, m = self._builder(), self.mechanics
            matrix = b.let_matrix("M", m.mass_matrix, m.symmetric)
            force = m.force_of_given(self._torques)
            right = b.let_vector("force", force)
            factors = b.factor("M", matrix, m.symmetric)
            acceleration = b.solve("acc", factors, right)
            if not name:
                out = Output("dv", acceleration, "accelerations: M dv = Q - h - v")
                summary = "Accelerations for given torques of the motors"
                yield b.close("forward_dynamics", summary, source, [out])
                continue
            constant = self._constant(b, len(acceleration))
            residual = force - m.mass_matrix * constant
            wrt = self._forward_inputs[name]
            # Simplified terms stay short when they are differentiated by parameters, of which there are many.
            shorten = name != "p"
            columns = self._columns(b, residual, wrt, constant, acceleration, factors, shorten)
            value = sp.Matrix.hstack(*columns)
            out = Output(f"dv_d{name}", value, f"derivative of dv with respect to {name}", is_matrix=True)
            summary = f"Derivative with respect to {name} of the accelerations for given torques"
            yield b.close(f"forward_dynamics_d{name}", summary, f"{source}, differentiated", [out])


def _torque_entry(walker: Declaration, motor: Motor, taken: set[str]) -> Entry:
    """What an entry of the torques that are given is, under a name that nothing else bears."""
    name = free(f"u_{motor.name}", taken)
    taken.add(name)
    unit = walker.units.of_motor(kind_of(walker, motor))
    return Entry(sp.Symbol(name, real=True), unit, motor.meaning or f"of the motor {motor.name}")
