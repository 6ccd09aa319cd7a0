"""What a controller needs of the mechanics: mass matrix, bias forces, energies, Jacobians, as short terms.

A controller that uses the model (feedback linearisation, virtual constraints, energy shaping) is written with
these instead of with expressions that were worked out by hand. They are `Term`s: a torque made of them
stays short however long they are when written out.
"""

from collections.abc import Callable
from functools import cached_property

import sympy as sp

from stridemap.derive import given
from stridemap.derive.declaration import Declaration
from stridemap.derive.normal_form import normal_form
from stridemap.derive.parts import STANCE_FOOT, TIME
from stridemap.derive.simplify import PRODUCTS
from stridemap.derive.steps import is_long, straight_line
from stridemap.derive.terms import Term, short
from stridemap.errors import InputError


class Derived(Declaration):
    """The derived quantities of a declaration, for its torques."""

    @cached_property
    def M(self) -> sp.Matrix:
        """Mass matrix of the swing phase, shape (n, n): ``M ddq + h = Q`` with generalised torques ``Q``.

        Raises
        ------
        InputError
            For a walker with a massless limit, whose equations of motion have another form.
        """
        matrix = self._inertia
        named = sp.zeros(*matrix.shape)
        for i in range(matrix.rows):
            for j in range(i, matrix.cols):
                named[i, j] = named[j, i] = short(f"M_{i + 1}{j + 1}", matrix[i, j])
        return named.as_immutable()

    @cached_property
    def h(self) -> sp.Matrix:
        """Bias forces of the swing phase, shape (n, 1): velocity terms, gravity, springs and dampers.

        They stand on the left-hand side, ``M ddq + h = Q``; torques are not among them.
        """
        matrix, q, v = self._inertia, self.q, self.v
        entries = []
        for i, symbol in enumerate(q):
            moving = (matrix[i, :].jacobian(q) * v).T * v
            moving -= v.T * matrix.diff(symbol) * v / 2
            forces = [_compact(moving[0]), _compact(self._weight.diff(symbol))]
            forces += [_steps(self._standing(e)).diff(symbol) for e in self.potentials.values()]
            forces.append(_steps(self.dissipation).diff(v[i]))
            entries.append(short(f"h_{i + 1}", sp.Add(*forces)))
        return sp.ImmutableMatrix(entries)

    @cached_property
    def kinetic_energy(self) -> sp.Expr:
        """Kinetic energy of the swing phase."""
        motion = [0 if c == self.phase else c.rate for c in self.coordinates]
        rates = sp.Matrix(motion)
        return short("kinetic_energy", (rates.T * self.M * rates)[0] / 2)

    @cached_property
    def potential_energy(self) -> sp.Expr:
        """Potential energy of gravity and of what is declared, zero with all masses on the ground."""
        stored = [_compact(self._weight), *(_steps(self._standing(e)) for e in self.potentials.values())]
        return short("potential_energy", sp.Add(*stored))

    @property
    def energy(self) -> sp.Expr:
        """Kinetic and potential energy of the swing phase."""
        return short("energy", self.kinetic_energy + self.potential_energy)

    @cached_property
    def centre_of_mass(self) -> sp.Matrix:
        """Centre of mass from the stance foot, shape (2, 1)."""
        self._refuse_massless()
        mass = sum(body.mass for body in self.bodies)
        moment = sum((b.mass * self._standing(b.position) for b in self.bodies), sp.zeros(2, 1))
        return sp.ImmutableMatrix(
            [short(f"com_{axis}", _compact(moment[i]) / mass) for i, axis in enumerate("xy")]
        )

    def jacobian(self, value: sp.Expr | sp.Matrix) -> sp.Matrix:
        """Derivative of an expression or point with respect to the coordinates, shape (rows, n).

        Parameters
        ----------
        value : sympy.Expr or sympy.Matrix
            In terms of coordinates, rates, parameters, `STANCE_FOOT` and derived quantities.
        """
        rows = sp.Matrix([self._standing(value)])
        return sp.ImmutableMatrix(rows.rows, self.q.rows, lambda i, j: short("", rows[i].diff(self.q[j])))

    def rate(self, value: sp.Expr | sp.Matrix) -> sp.Expr | sp.Matrix:
        """Rate of change of an expression or point while the coordinates' rates stay as they are.

        ``rate(y)`` is dy/dt of what depends on coordinates and time, and ``rate(rate(y))`` the part of its
        second derivative that no acceleration brings: ``ddy = jacobian(y) * ddq + rate(rate(y))``.
        """
        explicit = sp.Matrix([self._standing(value)]).diff(TIME)
        rates = self.jacobian(value) * self.v + explicit
        return sp.ImmutableMatrix(rates) if isinstance(value, sp.MatrixBase) else rates[0]

    # -- pieces ------------------------------------------------------------------------------------------

    def _refuse_massless(self) -> None:
        if self.massless is not None:
            raise InputError(
                f"model {self.name}: with a massless limit there is no mass matrix that a torque could use; "
                f"make {self.massless.mass} a small parameter, or write the torque without derived quantities"
            )

    def _standing(self, value: sp.Expr | sp.Matrix) -> sp.Expr | sp.Matrix:
        """`value` with the stance foot where it is in the swing phase."""
        if not isinstance(value, sp.MatrixBase):
            value = given.expression(value, "what jacobian or rate was given")
        elif value.cols != 1:
            raise InputError(
                f"jacobian or rate was given a matrix of shape {value.shape}; "
                "give an expression or a single column"
            )
        return value.subs(dict(zip(STANCE_FOOT, self.standing, strict=True)))

    @cached_property
    def _inertia(self) -> sp.Matrix:
        self._refuse_massless()
        n = len(self.coordinates)
        total = sp.zeros(n)
        for body in self.bodies:
            moves = self._standing(body.position).jacobian(self.q)
            turns = sp.Matrix([body.angle]).jacobian(self.q)
            total += body.mass * moves.T * moves + body.inertia * turns.T * turns
        if self.phase is not None:
            i = self.coordinates.index(self.phase)
            total[i, i] += 1
        return total.applyfunc(_compact)

    @cached_property
    def _weight(self) -> sp.Expr:
        return -sum(b.mass * self.gravity.dot(self._standing(b.position)) for b in self.bodies)


def _compact(expr: sp.Expr) -> sp.Expr:
    """A short form that is found quickly."""
    found = normal_form(expr, PRODUCTS)
    return expr if found is None else min(expr, found, sp.factor_terms(found), key=sp.count_ops)


def _steps(expr: sp.Expr) -> sp.Expr:
    return straight_line(expr) if is_long(expr) else expr


def solve(matrix: sp.Matrix, right: sp.Matrix, name: str = "") -> sp.Matrix:
    """Solve ``matrix * x = right`` step by step, each step a term.

    Parameters
    ----------
    matrix : sympy.Matrix, shape (n, n)
        A mass matrix, or another one that can be eliminated from the top; of a column that begins with zeros
        the first entry that is not zero is taken.
    right : sympy.Matrix, shape (n, m)
    name : str
        What the unknowns are called in generated code: ``<name>_1``, ... (by default they have numbers only).

    Returns
    -------
    sympy.Matrix, shape (n, m)

    Raises
    ------
    InputError
        When a column is zero, the shapes do not fit, or one is not a matrix.
    """
    matrix, right = (
        given.matrix(matrix, "what solve was given first"),
        given.matrix(right, "what solve was given"),
    )
    rows, columns = matrix.shape
    if rows != columns or right.rows != rows:
        raise InputError(
            f"solve was given matrices of shapes {matrix.shape} and {right.shape}; the first must be square, "
            "and the second must have as many rows"
        )
    a, b = sp.Matrix(matrix), sp.Matrix(right)
    for j in range(rows):
        pivot = next((i for i in range(j, rows) if a[i, j] != 0), None)
        if pivot is None:
            raise InputError(
                f"solve was given a matrix without an inverse: column {j + 1} is zero below the others"
            )
        a.row_swap(j, pivot)
        b.row_swap(j, pivot)
        for i in range(j + 1, rows):
            factor = short("", a[i, j] / a[j, j])
            for target in (a, b):
                target[i, :] = (target[i, :] - factor * target[j, :]).applyfunc(_named(""))
            a[i, j] = 0
    for i in reversed(range(rows)):
        for k in range(b.cols):
            known = sum((a[i, m] * b[m, k] for m in range(i + 1, rows)), sp.S.Zero)
            label = name and (f"{name}_{i + 1}" if b.cols == 1 else f"{name}_{i + 1}{k + 1}")
            b[i, k] = Term(label, (b[i, k] - known) / a[i, i])
    return b.as_immutable()


def _named(name: str) -> Callable[[sp.Expr], sp.Expr]:
    return lambda expr: short(name, expr)
