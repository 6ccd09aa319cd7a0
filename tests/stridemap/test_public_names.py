"""The public names of the package: what a researcher imports."""

import dataclasses
import importlib
import inspect
import pickle
import subprocess
import sys
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

import stridemap
from stridemap.errors import InputError
from stridemap.solver.model.loading import available
from tests.oracles.reference import REFERENCE, TWO_CYCLES, reference_name

PARTS = [
    importlib.import_module(name)
    for name in (
        "stridemap",
        "stridemap.derive",
        "stridemap.generated",
        "stridemap.solver",
        "stridemap.sweeps",
    )
]
MODULES = sorted(
    ".".join([part.__name__, *path.relative_to(Path(part.__file__).parent).with_suffix("").parts])
    for part in PARTS
    for path in Path(part.__file__).parent.rglob("*.py")
    if path.name not in ("__init__.py", "__main__.py")
)


# -- orbits and walks ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("entry", REFERENCE, ids=reference_name)
def test_find_orbits(entry):
    orbits = stridemap.find_orbits(entry["model"], **entry["params"])
    assert all(isinstance(orbit, stridemap.Orbit) for orbit in orbits)
    periods = [orbit.period for orbit in orbits]
    assert periods == sorted(periods)
    orbit = min(orbits, key=lambda orbit: abs(orbit.period - entry["period"]))
    assert orbit.period == pytest.approx(entry["period"], abs=1e-10)
    assert dict(orbit.state) == pytest.approx(entry["state"], abs=1e-10)
    assert (orbit.model.name, dict(orbit.params)) == (entry["model"], entry["params"])
    assert orbit.status is stridemap.Status.CONVERGED


def test_find_orbits_takes_numbers_of_any_kind_and_fills_from_the_preset():
    wanted = list(stridemap.find_orbits("wobbling", **TWO_CYCLES))
    assert list(stridemap.find_orbits("wobbling", k=6)) == wanted
    assert list(stridemap.find_orbits("wobbling", k=np.int64(6), alpha=np.float64(0.25))) == wanted
    few = stridemap.find_orbits("wobbling", k=6, options=stridemap.SearchOptions(starts=4, seed=3))
    assert len(few) <= len(wanted)


def test_the_period_range_is_an_option():
    options = stridemap.SearchOptions(period_min=1.16, period_max=1.3)
    (orbit,) = stridemap.find_orbits("wobbling", **TWO_CYCLES, options=options)
    assert orbit.period == pytest.approx(1.1837395353866969, abs=1e-10)


def test_simulate_walks_the_stable_cycle():
    stable = stridemap.find_orbits("wobbling", **TWO_CYCLES)[1]
    for walk in (
        stridemap.simulate("wobbling", steps=3, **TWO_CYCLES),
        stridemap.simulate("wobbling", stable.state, steps=3, **TWO_CYCLES),
        stridemap.simulate("wobbling", dict(reversed(stable.state.items())), steps=3, **TWO_CYCLES),
    ):
        assert [step.period for step in walk.steps] == pytest.approx([stable.period] * 3, abs=1e-9)
        assert dict(walk.steps[-1].state) == pytest.approx(dict(stable.state), abs=1e-9)
        assert walk.outcome == "walked"
    assert len(stridemap.simulate("wobbling", stable.state, **TWO_CYCLES).steps) == 10


@pytest.mark.quick
@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (
            {"model": "none"},
            "there is no model 'none'; models are compass, goswami_compass, rimless_wheel, round_feet, simpl",
        ),
        ({"model": "wobbling", "alpah": 0.3}, "no parameter 'alpah' .did you mean alpha"),
        ({"model": "wobbling", "alpha": 1}, r"alpha = 1 is outside the allowed range \(> 0 and < 1\)"),
        ({"model": "wobbling", "omega": 0.0}, r"omega = 0 is outside the allowed range \(> 0\)"),
        ({"model": "wobbling", "beta": -0.1}, r"beta = -0.1 is outside the allowed range \(> 0\)"),
        ({"model": "wobbling", "k": float("nan")}, r"k = nan is outside the allowed range \(>= 0\)"),
        ({"model": "wobbling", "S": float("inf")}, "S = inf is outside"),
        ({"model": "wobbling", "k": "6"}, "k = '6' is not a number; allowed: >= 0"),
        ({"model": "wobbling", "k": True}, "k = True is not a number"),
        ({"model": "wobbling", "k": None}, "k = None is not a number"),
    ],
)
@pytest.mark.parametrize("function", ["find_orbits", "simulate"])
def test_bad_arguments(function, arguments, sentence):
    with pytest.raises(stridemap.InputError, match=sentence) as caught:
        getattr(stridemap, function)(**arguments)
    assert "\n" not in str(caught.value)


STATE = {"theta1": 0.09, "dtheta1": -0.1, "dtheta2": 0.0}


@pytest.mark.quick
@pytest.mark.parametrize(
    ("state", "steps", "sentence"),
    [
        (STATE, 0, "steps = 0 is not allowed"),
        ({**STATE, "x": 0.0}, 1, "unknown: x"),
        ({"theta1": 0.09}, 1, "missing: dtheta1, dtheta2"),
        ({**STATE, "theta1": float("nan")}, 1, "theta1 = nan of the state is not a finite number"),
        ({**STATE, "theta1": "0.1"}, 1, "theta1 = '0.1' of the state is not a finite number"),
        ({**STATE, "theta1": True}, 1, "theta1 = True of the state is not a finite number"),
    ],
)
def test_bad_states(state, steps, sentence):
    with pytest.raises(InputError, match=sentence):
        stridemap.simulate("compass", state, steps=steps)


# -- models --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", available())
def test_every_function_of_a_model_is_a_casadi_function_with_names(name):
    model = stridemap.load(name)
    assert isinstance(model, stridemap.Model)
    assert model is stridemap.load(name)
    functions = model.spec.functions
    wanted = {
        "mass_matrix", "bias_forces", "state_derivative", "touchdown_condition", "impact_map",
        "kinetic_energy", "potential_energy", "centre_of_mass", "ground_force", "swing_foot",
        "before_touchdown", "step_length", "total_mass",
        *(["controller_torque", "motor_rates"] if model.actuated else []),
    }  # fmt: skip
    assert wanted <= set(functions), sorted(functions)
    for key, entry in functions.items():
        function = getattr(model, key)
        assert isinstance(function, ca.Function)
        assert function.name_in() == (["z", "p"] if key == "section_state" else ["t", "q", "v", "u", "p"])
        assert function.reads == entry.arguments
        assert function.name_out() == [output.name for output in entry.outputs]
        assert getattr(model, key) is function
        assert not any(word.startswith(("i0", "o0")) for word in function.name_in() + function.name_out())


def test_mass_matrix_by_name():
    model = stridemap.load("wobbling")
    p = model.point({"k": 6})
    assert model.mass_matrix.reads == ("q", "p")
    assert model.mass_matrix.name_out() == ["M"]
    mass = model.mass_matrix(q=[0.1, 0.2, 0.0], p=p)["M"].full()
    assert mass.shape == (3, 3)
    np.testing.assert_array_equal(mass, mass.T)
    assert (np.linalg.eigvalsh(mass) > 0).all()
    np.testing.assert_array_equal(mass, model.evaluate("mass_matrix", q=np.array([0.1, 0.2, 0.0]), p=p)["M"])
    # By position too.
    found = model.mass_matrix(0, [0.1, 0.2, 0.0], None, None, p)
    np.testing.assert_array_equal(mass, found.full())


def test_an_unknown_function_is_named_with_the_known_ones():
    with pytest.raises(AttributeError, match="no attribute 'mass_matirx'; functions: .*mass_matrix"):
        stridemap.load("wobbling").mass_matirx  # noqa: B018


def test_a_model_says_what_it_is():
    model = stridemap.load("compass")
    assert repr(model).startswith("Model('compass', hash='")
    assert model.preset == {p.name: p.default for p in model.parameters}
    assert all(p.check(p.default) == p.default and p.meaning and p.allowed for p in model.parameters)


# -- the package ---------------------------------------------------------------------------------------------


@pytest.mark.quick
def test_public_names():
    assert dir(stridemap) == sorted(stridemap.__all__)
    assert {
        "AcceptanceOptions", "Backend", "Claim", "CompilerError", "ContinuationOptions", "InputError",
        "Interpreter", "Lanes", "Model", "ModelSpec", "Motion", "Orbit", "Orbits", "Parameter", "Progress",
        "QUANTITIES", "Quantity", "ScalarC", "SearchOptions", "Status", "StorageError", "StridemapError",
        "Summary", "SweepConfig", "Units", "Verdict", "Walk", "WorkerError", "__version__", "animate",
        "available", "claims", "derive_model", "find_orbits", "is_physical_gait", "load", "load_config",
        "motion", "parse_config", "read_batches", "read_cells", "read_orbits", "read_provenance",
        "read_special", "read_table", "simulate", "sweep",
    } <= set(stridemap.__all__)  # fmt: skip
    for name in stridemap.__all__:
        value = getattr(stridemap, name)
        assert name in ("__version__", "QUANTITIES") or value.__module__.startswith("stridemap.")
    with pytest.raises(AttributeError, match="module 'stridemap' has no attribute 'find_orbit'"):
        stridemap.find_orbit  # noqa: B018
    with pytest.raises(ImportError, match="cannot import name 'find_orbit'"):
        exec("from stridemap import find_orbit")


IMPORTED = """
import sys
import stridemap
before = set(sys.modules)
heavy = {"casadi", "sympy", "scipy", "numpy", "pandas", "pyarrow", "pydantic", "typer", "rich"}
assert not heavy & before, heavy & before
assert "find_orbits" in dir(stridemap) and not heavy & set(sys.modules)
import stridemap.errors
assert not heavy & set(sys.modules)
assert stridemap.InputError is stridemap.errors.InputError
import stridemap.cli.app
assert not {"casadi", "sympy", "scipy", "pandas", "pyarrow"} & set(sys.modules)
stridemap.find_orbits, stridemap.sweep, stridemap.read_orbits
assert "casadi" in sys.modules
assert not {"sympy", "stridemap.derive"} & set(sys.modules)
"""


def test_importing_is_cheap_and_running_needs_no_sympy():
    done = subprocess.run([sys.executable, "-c", IMPORTED], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


def test_every_error_is_of_one_family():
    for name in ("InputError", "CompilerError", "WorkerError", "StorageError"):
        assert issubclass(getattr(stridemap, name), stridemap.StridemapError)
    assert issubclass(stridemap.InputError, ValueError)
    assert not issubclass(stridemap.CompilerError, stridemap.InputError)


@pytest.mark.quick
def test_is_physical_gait_takes_one_many_or_a_table():
    orbits = stridemap.find_orbits("wobbling", **TWO_CYCLES)
    one_by_one = [bool(stridemap.is_physical_gait(orbit)) for orbit in orbits]
    assert stridemap.is_physical_gait(orbits).tolist() == one_by_one
    assert stridemap.is_physical_gait(orbits.to_frame()).tolist() == one_by_one
    assert any(one_by_one)


def test_orbits_are_values():
    (orbit,) = stridemap.find_orbits("wobbling", k=0.5)
    assert pickle.loads(pickle.dumps(orbit)) == orbit
    with pytest.raises(dataclasses.FrozenInstanceError):
        orbit.period = 1.0
    with pytest.raises(TypeError):
        orbit.state["theta1"] = 1.0


def undocumented(module):
    """Public classes, functions and methods of a module without a docstring."""
    for name, thing in vars(module).items():
        if name.startswith("_") or getattr(thing, "__module__", None) != module.__name__:
            continue
        if inspect.isfunction(thing) and not inspect.getdoc(thing):
            yield name
        if inspect.isclass(thing):
            if not thing.__doc__ or thing.__doc__.startswith(f"{name}("):  # a dataclass writes its own
                yield name
            for attribute, member in vars(thing).items():
                member = getattr(member, "func", getattr(member, "fget", getattr(member, "__func__", member)))
                if not attribute.startswith("_") and inspect.isfunction(member) and not member.__doc__:
                    yield f"{name}.{attribute}"


@pytest.mark.parametrize("name", MODULES)
def test_public_names_are_documented(name):
    module = importlib.import_module(name)
    assert module.__doc__
    assert list(undocumented(module)) == []


def test_every_module_was_looked_at():
    names = ["cli.app", "errors", "solver.cycles.search", "sweeps.run", "derive.models.compass"]
    names += [f"generated.{model}.{model}" for model in available()]
    assert {f"stridemap.{name}" for name in names} <= set(MODULES)
