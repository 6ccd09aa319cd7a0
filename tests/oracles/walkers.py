"""Walkers that are declared for the tests alone, derived and compiled once for all runs."""

from functools import cache
from pathlib import Path

import numpy as np
import sympy as sp

from stridemap.codegen import declared, derive_model
from stridemap.derive import STANCE_FOOT, Body, Clock, Motor, Parameter, Walker, rolling_arc
from stridemap.derive.models import compass, goswami_compass, simplest_walker, wobbling
from stridemap.derive.models.controller import OMEGA, hip_torque
from stridemap.solver.backends.compiler import cache_folder
from stridemap.solver.backends.interpreter import Interpreter
from stridemap.solver.cycles.search import continued, find_all
from stridemap.solver.cycles.solver import Solver
from stridemap.solver.model.loading import available
from stridemap.solver.model.model import Model
from stridemap.solver.options import SearchOptions
from tests.oracles.remembered import remembered
from tests.oracles.shared import alone

EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "models"

# -- the walkers -----------------------------------------------------------------------------------------


def finite_feet() -> Walker:
    """The simplest walker before the limit: its feet have a mass, and nothing is known of their rates."""
    foot = Parameter("foot_mass", 1e-3, "M", "point mass at each foot", 0.0, lower_open=True)
    walker = simplest_walker.WALKER
    masses = {simplest_walker.foot: foot.symbol}
    return walker.with_(
        name="finite_feet",
        massless=None,
        parameters=(*walker.parameters, foot),
        bodies=tuple(Body(b.name, sp.sympify(b.mass).subs(masses), b.position) for b in walker.bodies),
        section={simplest_walker.phi: 2 * simplest_walker.theta},
        search_box={**walker.search_box, "dphi": (0.0, 0.1)},
    )


def damped() -> Walker:
    """The wobbling walker with a damper beside its spring."""
    zeta = Parameter("zeta", 1.0, "1", "damping ratio of the spring with the hip free", 0.0)
    k, alpha, rate = wobbling.k, wobbling.alpha, wobbling.X.rate
    return wobbling.WALKER.with_(
        name="damped",
        parameters=(*wobbling.WALKER.parameters, zeta),
        dissipation=zeta.symbol * sp.sqrt(k * alpha * (1 - alpha)) * rate**2,
    )


def latched() -> Walker:
    """The wobbling walker whose mass is stopped by a latch at every touchdown."""
    return wobbling.WALKER.with_(name="latched", locks=(wobbling.x,))


def rolling() -> Walker:
    """The compass walker on arcs; the mass of a foot is at the lowest point under an upright leg."""
    radius = Parameter("radius", 0.2, "L", "radius of the feet", 0.0, 1.0, upper_open=True)
    r, theta1, theta2 = radius.symbol, compass.theta1, compass.theta2
    up = sp.Matrix([-sp.sin(theta1), sp.cos(theta1)])
    down = sp.Matrix([sp.sin(theta1 - theta2), -sp.cos(theta1 - theta2)])
    hip = STANCE_FOOT + (1 - r) * up
    swing = hip + (1 - r) * down
    beta = compass.BETA.symbol
    return compass.WALKER.with_(
        name="rolling",
        parameters=(*compass.WALKER.parameters, radius),
        bodies=(
            Body("hip", sp.Integer(1), hip),
            Body("stance foot", beta, STANCE_FOOT - r * up),
            Body("swing foot", beta, swing + r * down),
        ),
        swing_foot=swing,
        stance=rolling_arc(r, theta1),
        drawing=(),
    )


def locked() -> Walker:
    """The compass walker with a clock that touchdown does not reset."""
    clock = Clock(OMEGA.symbol, resets=False)
    torque = hip_torque(compass.THETA2, clock)
    return compass.WALKER.with_(name="locked", clock=clock, torques={compass.THETA2: torque})


def two_motors() -> Walker:
    """The wobbling walker with a second motor on its mass, which pushes with a force that decays in time."""
    push = Parameter("push", 0.05, "M g", "force on the wobbling mass at touchdown")
    (torque,) = wobbling.WALKER.torques.values()
    time = sp.Symbol("t", real=True)
    return wobbling.WALKER.with_(
        name="two_motors",
        parameters=(*wobbling.WALKER.parameters, push),
        torques={compass.THETA2: torque, wobbling.X: push.symbol / (1 + time**2)},
    )


def ankled() -> Walker:
    """The compass gait with a motor at its ankle, which holds the leg back at first and then pushes it on."""
    gain = Parameter("gain", 0.12, "m g L", "torque of the ankle")
    lean = sp.sin(3 * goswami_compass.theta1)
    ankle = Motor("ankle", -gain.symbol * lean, drives=goswami_compass.theta1)
    base = goswami_compass.WALKER
    return base.with_(name="ankled", parameters=(*base.parameters, gain), motors=(ankle,))


WALKERS = {f.__name__: f for f in (finite_feet, damped, latched, rolling, locked, two_motors, ankled)}

# -- what is done with them --------------------------------------------------------------------------------


@cache
def walker(name: str) -> Walker:
    return WALKERS[name]()


@cache
def derived(name: str) -> Model:
    """The model of a walker of this file; where it is in the cache it is not derived again."""
    with alone(cache_folder() / f"{name}.lock"), remembered():
        return derive_model(walker(name))


@cache
def example(name: str) -> Path:
    """A model file of the examples, derived into the cache by one process of the run."""
    path = EXAMPLES / f"{name}.py"
    with alone(cache_folder() / f"{name}.lock"), remembered():
        derive_model(declared(path))
    return path


def solver(model: Model) -> Solver:
    """Walkers of this file are in use for seconds, in CasADi's virtual machine: to compile one takes ten."""
    return Solver.for_model(model, None if model.name in available() else Interpreter())


def cycles(model: Model, **params: float):
    """All limit cycles at one point, ordered by period."""
    built_in = model.name in available()
    options = SearchOptions() if built_in else SearchOptions(starts=128)
    return list(find_all(solver(model), model.point(params)[None, :], options)[1])


def cycle_near(model: Model, state: dict, period: float, **params: float):
    """The limit cycle that Newton's method finds from a state; entries that are not named begin at zero."""
    guess = np.array([[*(state.get(name, 0.0) for name in model.section), period]])
    (orbit,) = continued(solver(model), model.point(params)[None, :], guess)
    assert orbit.status.found, orbit.status
    return orbit
