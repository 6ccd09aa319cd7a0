"""The same machine in other coordinates: any declaration with its coordinates q as ``q = A q' + b``.

All that a declaration says is carried over, so that whatever is measured must come out the same. The
rewritten walker is derived without simplifying its equations, which is fast, and a second check of what
simplifying does; its kernels run in CasADi's virtual machine.
"""

from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, fields, replace
from unittest import mock

import numpy as np
import sympy as sp

from stridemap.derive import (
    Coordinate,
    Massless,
    Motor,
    Touchdown,
    Walker,
    emit,
    functions,
    mechanics,
    program,
)
from stridemap.derive.printers.python import Python
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.cycles.search import continued
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.files import MANIFEST, InMemory, equations_file
from stridemap.solver.model.model import Model
from tests.oracles.manifest import manifest


@dataclass(frozen=True)
class Change:
    """A linear change of coordinates, ``q = A q' + b``.

    Parameters
    ----------
    names : tuple of str
        Of the new coordinates.
    matrix : tuple of tuple of int
        A; a clock's phase has a coordinate too, which stays as it is.
    shift : tuple of number
        b.
    """

    names: tuple[str, ...]
    matrix: tuple[tuple[int, ...], ...]
    shift: tuple[float, ...]

    @property
    def a(self):
        return sp.Matrix(self.matrix)

    @property
    def b(self):
        return sp.Matrix([sp.nsimplify(x, rational=True) for x in self.shift])

    def new(self, q):
        """New coordinates of old ones, both as arrays."""
        a, b = np.array(self.matrix, float), np.array(self.shift, float)
        return np.linalg.solve(a, q - b)

    def new_rates(self, v):
        return np.linalg.solve(np.array(self.matrix, float), v)


def rewritten(walker, change, suffix):
    """The same walker in other coordinates, with motors for its torques.

    Parameters
    ----------
    walker : Walker
    change : Change
        Stance angle and wobbling coordinate must go over into one new coordinate each, up to a sign.
    suffix : str
        Added to the walker's name.
    """
    return _Rewriting(walker, change).walker(suffix)


class _Rewriting:
    def __init__(self, walker, change):
        self.w, self.change = walker, change
        self.coordinates = tuple(self._coordinate(j, name) for j, name in enumerate(change.names))
        self.q = sp.Matrix([c.symbol for c in self.coordinates])
        self.v = sp.Matrix([c.rate for c in self.coordinates])
        old_q, old_v = change.a * self.q + change.b, change.a * self.v
        self.places = dict(zip([*walker.q, *walker.v], [*old_q, *old_v], strict=True))

    def _coordinate(self, j, name):
        made_of = [c for c, row in zip(self.w.coordinates, self.change.matrix, strict=True) if row[j]]
        (unit,) = {c.unit for c in made_of}
        if made_of == [self.w.phase]:
            return self.w.phase
        return Coordinate(name, unit, "a combination of coordinates")

    def put(self, expr):
        return expr.xreplace(self.places)

    def _one(self, coordinate):
        """The one new coordinate that an old one has become, up to a sign."""
        if coordinate is None:
            return None
        row = self.change.matrix[self.w.coordinates.index(coordinate)]
        (j,) = np.flatnonzero(row)
        assert abs(row[j]) == 1
        return self.coordinates[j]

    def walker(self, suffix):
        w, put = self.w, self.put
        given = {f.name: getattr(w, f.name) for f in fields(w)}
        relabelled = self.change.a.inv() * (sp.Matrix([put(w.relabel[q]) for q in w.q]) - self.change.b)
        section = self._section()
        return Walker(
            **given
            | {
                "name": f"{w.name}_{suffix}",
                "coordinates": self.coordinates,
                "bodies": tuple(replace(b, position=put(b.position), angle=put(b.angle)) for b in w.bodies),
                "swing_foot": put(w.swing_foot),
                "touchdown": Touchdown(
                    put(w.touchdown.condition), put(w.touchdown.region), w.touchdown.rising
                ),
                "relabel": dict(zip(self.q, relabelled.applyfunc(sp.expand), strict=True)),
                "search_box": self._box(section),
                "potentials": {name: put(v) for name, v in w.potentials.items()},
                "dissipation": put(w.dissipation),
                "torques": {},
                "motors": tuple(self._motor(m) for m in w.actuators),
                "clock": w.clock,
                "stance": put(w.stance),
                "locks": tuple(map(put, w.locks)),
                "massless": self._massless(),
                "section": section,
                "stance_angle": self._one(w.stance_angle),
                "wobbling": self._one(w.wobbling),
                "drawing": tuple(replace(x, points=tuple(map(put, x.points))) for x in w.drawing),
                "quantities": tuple(replace(x, expression=put(x.expression)) for x in w.quantities),
            }
        )

    def _motor(self, m):
        return Motor(m.name, self.put(m.torque), self.put(m.drives), m.meaning, m.limit, m.efficiency, m.kind)

    def _massless(self):
        if self.w.massless is None:
            return None
        light = [c in self.w.massless.coordinates for c in self.w.coordinates]
        mine = [
            c
            for j, c in enumerate(self.coordinates)
            if all(light[i] for i, row in enumerate(self.change.matrix) if row[j])
        ]
        assert len(mine) == sum(light)
        return Massless(self.w.massless.mass, tuple(mine))

    def _section(self):
        """What the section fixes, solved for new coordinates and new rates."""
        fixed = {self.put(s) - self.put(sp.sympify(e)): s for s, e in self.w.section.items()}
        out = {}
        for kind, unknowns in ((list(self.w.q), self.q), (list(self.w.v), self.v)):
            equations = [e.xreplace(out) for e, s in fixed.items() if s in kind]
            for equation in equations:
                equation = equation.xreplace(out)
                wanted = [
                    x for x in reversed(list(unknowns)) if x not in out and sp.expand(equation).diff(x) != 0
                ]
                own = next(
                    x
                    for x in wanted
                    if not sp.expand(equation).diff(x).free_symbols and x != self._stance_symbol
                )
                out[own] = sp.expand(sp.solve(equation, own)[0])
        return out

    @property
    def _stance_symbol(self):
        angle = self._one(self.w.stance_angle)
        return angle.symbol if angle is not None else None

    def _box(self, section):
        w, n = self.w, len(self.w.coordinates)
        known = {**w.search_box}
        middles = {s: known[s.name][0] for s in (*w.q, *w.v) if s.name in known}
        for s, e in w.section.items():
            values = {**middles, **{a.symbol: a.default for a in w.parameters}}
            known.setdefault(s.name, (float(sp.sympify(e).subs(values)), 0.3))
        a = np.array(self.change.matrix, float)
        widths = np.abs(np.linalg.inv(a))
        box = {}
        for old, new, back in ((w.q, self.q, self.change.new), (w.v, self.v, self.change.new_rates)):
            middle = back(np.array([known[s.name][0] for s in old]))
            width = widths @ np.array([known[s.name][1] for s in old])
            box |= {new[j].name: (float(middle[j]), float(width[j])) for j in range(n)}
        return {name: pair for name, pair in box.items() if name not in {s.name for s in section}}


@contextmanager
def unsimplified():
    """What is derived inside is not simplified, which is fast."""
    plain = {"new": lambda expr: sp.sympify(expr)}
    with (
        mock.patch.object(mechanics, "simplified", **plain),
        mock.patch.object(functions, "simplified", **plain),
        mock.patch.object(program, "simplified", **plain),
    ):
        yield


def light_model(walker, forward=False):
    """A walker's model, derived without simplifying and without kernels in C.

    Parameters
    ----------
    walker : Walker
    forward : bool
        Whether to derive the accelerations under given torques, which no gait needs.
    """
    absent = mock.patch.object(functions.Functions, "forward_dynamics", lambda _: iter(()))
    with unsimplified(), nullcontext() if forward else absent:
        equations = emit.equations(walker, "tests")
    text = Python().text(equations).encode()
    contents = {equations_file(walker.name): text}
    return Model(
        InMemory({**contents, MANIFEST: manifest(emit.specification(equations), contents)}, "-"), "-"
    )


def carried_over(orbits, change, model):
    """Cycles in new coordinates, found from where they lie in the old ones.

    Parameters
    ----------
    orbits : Orbits
    change : Change
    model : Model
        Of the rewritten walker, with the same parameters.
    """
    old = orbits.model
    start = old.evaluate("section_state", z=orbits.u[:, :-1], p=orbits.params)
    guesses = []
    for q, v, period in zip(start["q"], start["v"], orbits.period, strict=True):
        names = dict(zip(model.coordinates, change.new(q), strict=True))
        names |= dict(zip((f"d{c}" for c in model.coordinates), change.new_rates(v), strict=True))
        guesses.append([*(names[name] for name in model.section), period])
    return continued(Solver.for_model(model, Interpreter()), orbits.params, np.array(guesses))


def states(orbits, change=None):
    """Coordinates and rates just after touchdown, in the old coordinates, shape (m, 2 n)."""
    start = orbits.model.evaluate("section_state", z=orbits.u[:, :-1], p=orbits.params)
    q, v = start["q"], start["v"]
    if change is not None:
        a = np.array(change.matrix, float)
        q, v = q @ a.T + np.array(change.shift, float), v @ a.T
    return np.hstack([q, v])
