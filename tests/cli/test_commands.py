"""The command line on good input: what it prints and its exit status."""

import json
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import stridemap
from stridemap.quantities import MEASURED
from stridemap.solver.backends.selection import load_kernels
from stridemap.solver.model.loading import available, load
from stridemap.solver.walks.outcomes import Outcome
from tests.oracles.reference import REFERENCE, reference_name
from tests.oracles.sweeping import STRIDEMAP, tables

ORBIT_KEYS = (
    "status state period period_n multipliers spectral_radius multiplier_error stable undecided group "
    "step_length speed d_max cop_max work work_positive work_net peak_torque peak_power cot cot_per_speed "
    "min_vertical_force friction clearance peaks x_zero_crossings wobble_amplitude touchdown_speed "
    "impact_friction lift_off_speed trailing_lifts_off residual state_error integration_error"
).split()
"""In this order; others script against them."""
FIRST = ("status", "state", "period", "period_n", "multipliers")

TWO = ["--k", "6", "--alpha", "0.25", "--omega", "3"]


@pytest.mark.quick
def test_the_keys_are_those_of_the_registry():
    assert ORBIT_KEYS == ["status", "state", "period", "period_n", "multipliers", *MEASURED]


def printed(result):
    """The JSON object that a successful command printed, alone."""
    status, out, err = result
    assert (status, err) == (0, "")
    return json.loads(out)


# -- orbit ---------------------------------------------------------------------------------------------------


def test_the_command_and_the_module_are_the_same():
    commands = [[str(Path(sys.executable).with_name("stridemap"))], STRIDEMAP]
    words = ["orbit", "--model", "wobbling", *TWO, "--json"]

    def shell(command):
        done = subprocess.run([*command, *words], capture_output=True, text=True)
        return done.returncode, done.stdout, done.stderr

    with ThreadPoolExecutor(2) as pool:
        script, module = pool.map(shell, commands)
    assert script == module
    found = printed(script)
    assert list(found) == ["model", "params", "orbits", "search"]
    orbits = stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3)
    assert found["orbits"] == [orbit.to_dict() for orbit in orbits]
    assert len(orbits) == 2


@pytest.mark.quick
def test_json_of_a_point_with_two_cycles(run):
    found = printed(run("orbit", "--model", "wobbling", *TWO, "--json"))
    assert list(found) == ["model", "params", "orbits", "search"]
    assert found["model"] == "wobbling"
    assert found["params"] == {
        "k": 6.0, "alpha": 0.25, "omega": 3.0, "beta": 0.15, "Kp": 10.0, "Kd": 0.6, "S": 0.18, "gamma": 0.18,
        "c": 0.0,
    }  # fmt: skip
    first, second = found["orbits"]
    assert first["period"] < second["period"]
    for orbit in (first, second):
        assert list(orbit) == ORBIT_KEYS
        assert list(orbit["state"]) == ["theta1", "dtheta1", "dtheta2", "x", "dx"]
        moduli = [abs(complex(*pair)) for pair in orbit["multipliers"]]
        assert len(moduli) == 5
        assert moduli == sorted(moduli, reverse=True)
        assert orbit["spectral_radius"] == pytest.approx(moduli[0], rel=1e-15)
        assert orbit["stable"] is (moduli[0] < 1)
        assert (orbit["status"], orbit["group"]) == ("converged", "B")
        assert type(orbit["peaks"]) is type(orbit["x_zero_crossings"]) is int
    assert [first["stable"], second["stable"]] == [False, True]


@pytest.mark.quick
@pytest.mark.parametrize("entry", REFERENCE, ids=reference_name)
def test_json_holds_the_reference_orbits(run, entry):
    words = [word for name, value in entry["params"].items() for word in ("--set", f"{name}={value!r}")]
    found = printed(run("orbit", "--model", entry["model"], *words, "--json"))
    assert found["params"] == entry["params"]
    orbit = min(found["orbits"], key=lambda orbit: abs(orbit["period"] - entry["period"]))
    assert orbit["period"] == pytest.approx(entry["period"], abs=1e-10)
    assert orbit["state"] == pytest.approx(entry["state"], abs=1e-10)
    # The last one is zero, and of a pair either may come first.
    mine = sorted(map(tuple, orbit["multipliers"]), key=lambda m: (round(abs(complex(*m)), 6), m[1]))
    wanted = sorted(map(tuple, entry["multipliers"]), key=lambda m: (round(abs(complex(*m)), 6), m[1]))
    np.testing.assert_allclose(mine, wanted, atol=1e-9, rtol=0)


@pytest.mark.parametrize(
    "words",
    [
        ["--k=22.5", "--omega=3.0"],
        ["--k", "22.5"],
        ["--set", "k=22.5", "--set", "alpha=0.25"],
        ["--omega", "3", "--set", "k=2.25e1"],
        ["--starts", "512", "--k", "22.5", "--model=wobbling"],
    ],
)
def test_every_way_to_give_parameters_and_the_preset_fills_the_rest(run, words):
    found = printed(run("orbit", "--json", *words))
    assert found["params"] == {**load("wobbling").preset, "k": 22.5}
    wanted = stridemap.find_orbits("wobbling", k=22.5)
    assert found["orbits"] == [orbit.to_dict() for orbit in wanted]


def test_starts_is_the_number_of_starts(run):
    few = printed(run("orbit", "--json", "--starts", "4", *TWO))["orbits"]
    wanted = stridemap.find_orbits(
        "wobbling", k=6, alpha=0.25, omega=3, options=stridemap.SearchOptions(starts=4)
    )
    assert few == [orbit.to_dict() for orbit in wanted]


@pytest.mark.quick
def test_the_plain_table_tells_the_same(run):
    status, out, err = run("orbit", *TWO)
    assert (status, err) == (0, "")
    head, *lines = out.splitlines()
    assert head.split() == ["cycle", "1", "cycle", "2", "unit", "meaning"]
    unit, meaning = head.index("unit"), head.index("meaning")
    assert {line[unit - 2 : unit] + line[meaning - 2 : meaning] for line in lines} == {"    "}  # in columns
    cycles = [line[:unit] for line in lines]
    rows = {" ".join(line.split()[:-2]): line.split()[-2:] for line in cycles}
    words = {line[:18].strip(): (line[unit:meaning].strip(), line[meaning:]) for line in lines}
    assert words["dx"] == ("L sqrt(g/L)", "rate of x")
    assert words["work"][0] == "M g L"
    assert words["cot"] == ("1", "cost of transport")
    assert words["period"] == ("sqrt(L/g)", "time from one touchdown to the next")
    assert words["multiplier 1"] == ("1", "Floquet multiplier 1")
    orbits = printed(run("orbit", *TWO, "--json"))["orbits"]
    state = list(orbits[0]["state"])
    multipliers = [f"multiplier {i}" for i in range(5)]
    rest = [key for key in ORBIT_KEYS if key not in FIRST]
    assert list(rows) == ["status", *state, "period", *multipliers, *rest]
    assert [float(v) for v in rows["period"]] == pytest.approx([o["period"] for o in orbits], abs=1e-12)
    assert [float(v) for v in rows["theta1"]] == pytest.approx(
        [o["state"]["theta1"] for o in orbits], abs=1e-12
    )
    assert rows["stable"] == ["no", "yes"]
    shown = complex(rows["multiplier 1"][0].replace("i", "j"))
    assert shown == pytest.approx(complex(*orbits[0]["multipliers"][1]), abs=1e-9)


def test_what_a_model_has_not_is_null_or_a_dash(run):
    (orbit,) = printed(run("orbit", "--model", "compass", "--json"))["orbits"]
    assert list(orbit) == ORBIT_KEYS
    assert list(orbit["state"]) == ["theta1", "dtheta1", "dtheta2"]
    assert orbit["group"] is orbit["x_zero_crossings"] is orbit["wobble_amplitude"] is None
    _, out, _ = run("orbit", "--model", "compass")
    rows = dict(line.split()[:2] for line in out.splitlines()[1:] if not line.startswith("multiplier"))
    assert rows["group"] == rows["x_zero_crossings"] == rows["wobble_amplitude"] == "-"


def test_nothing_found_is_status_1(run):
    # Without torque nothing makes up for what the impacts take: the walker can only stand still.
    words = ["orbit", "--Kp", "0", "--Kd", "0"]
    status, out, err = run(*words)
    assert (status, out) == (1, "")
    assert re.fullmatch(r"no limit cycle found\n512 starts ended: [^\n]*\n", err)
    status, out, err = run(*words, "--json")
    assert (status, err) == (1, "")
    assert json.loads(out)["orbits"] == []


# -- simulate ------------------------------------------------------------------------------------------------


def test_simulate_starts_from_the_most_stable_cycle(run):
    walk = printed(run("simulate", *TWO, "--steps", "4", "--json"))
    assert list(walk) == ["model", "params", "start", "outcome", "steps"]
    assert (walk["model"], walk["params"]["k"], walk["outcome"]) == ("wobbling", 6.0, "walked")
    stable = stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3)[1]
    assert len(walk["steps"]) == 4
    for step in walk["steps"]:
        assert list(step) == ["period", "step_length", "state"]
        assert step["period"] == pytest.approx(stable.period, abs=1e-9)
        assert step["step_length"] == pytest.approx(stable.step_length, abs=1e-9)
        assert step["state"] == pytest.approx(dict(stable.state), abs=1e-9)


def states(state):
    return [word for name, value in state.items() for word in ("--state", f"{name}={value!r}")]


def test_simulate_from_a_given_state(run):
    entry = next(e for e in REFERENCE if e["model"] == "compass")
    words = [f"--{name}={value!r}" for name, value in entry["params"].items()]
    walk = printed(run("simulate", "--model", "compass", *words, *states(entry["state"]), "--json"))
    assert len(walk["steps"]) == 10
    assert walk["steps"][0]["period"] == pytest.approx(entry["period"], abs=1e-9)
    assert walk["steps"][0]["state"] == pytest.approx(entry["state"], abs=1e-9)


def test_simulate_prints_a_table(run):
    status, out, err = run("simulate", "--k=22.5", "--steps", "2")
    assert (status, err) == (0, "")
    head, *rows, last = out.splitlines()
    assert head.split() == ["step", "period", "length", "theta1", "dtheta1", "dtheta2", "x", "dx"]
    assert last == "walked after 2 of 2 steps"
    stable = min(stridemap.find_orbits("wobbling", k=22.5), key=lambda orbit: orbit.spectral_radius)
    for number, row in enumerate(rows, 1):
        values = [float(word) for word in row.split()]
        assert values == pytest.approx(
            [number, stable.period, stable.step_length, *stable.state.values()], abs=2e-9
        )


def test_a_fall_is_status_1(run):
    fallen = {"theta1": 0.09, "dtheta1": -50.0, "dtheta2": 0.0, "x": 0.0, "dx": 0.0}
    status, out, err = run("simulate", *states(fallen), "--steps=5", "--json")
    assert (status, err) == (1, "")
    walk = json.loads(out)
    assert walk["steps"] == []
    assert walk["outcome"] in set(Outcome) - {"walked"}
    status, out, err = run("simulate", *states(fallen), "--steps=5")
    assert (status, err) == (1, "")
    assert out.splitlines()[-1] == f"{walk['outcome'].replace('_', ' ')} after 0 of 5 steps"


# -- sweep, derive, version, help ----------------------------------------------------------------------------


def test_sweep_tells_what_it_found_and_what_was_there(run, tmp_path):
    config, out = tmp_path / "my.toml", tmp_path / "new" / "out"
    config.write_text('model = "compass"\n[grid]\nomega = [2.5, 3.0]\n[search]\nstarts = 64\n')
    status, said, shown = run("sweep", config, "--out", out, "--workers", "1")
    orbits = stridemap.read_orbits(out)
    found = f"{len(orbits)} limit cycles ({orbits['stable'].sum()} stable) in 2 cells; tables in {out}\n"
    assert (status, said) == (0, f"sweep finished: {found}")
    assert len(orbits) >= 2
    assert shown.startswith("round 1: 1 of 1 pieces")
    before = tables(out)
    assert run("sweep", config, "--out", out, "--resume") == (0, f"sweep was finished before: {found}", "")
    assert tables(out) == before


def test_a_sweep_that_finds_nothing_is_status_1(run, tmp_path):
    config, out = tmp_path / "none.toml", tmp_path / "out"
    config.write_text('model = "compass"\n[grid]\nomega = [3.0]\n[search]\nstarts = 8\nperiod_max = 0.35\n')
    status, said, _ = run("sweep", config, "--out", out, "--workers", "1")
    assert (status, said) == (
        1,
        f"sweep finished: 0 limit cycles (0 stable) in 1 cells; tables in {out}\n",
    )
    assert stridemap.read_cells(out)["status"].tolist() == ["empty"]


def test_derive_prints_what_it_wrote_or_what_differs(run, monkeypatch):
    one, two = Path("a/one.c"), Path("b/two.c")
    monkeypatch.setattr("stridemap.codegen.derive", lambda: [one, two])
    assert run("derive") == (0, f"{one}\n{two}\n", "")
    monkeypatch.setattr("stridemap.codegen.drift", lambda: [])
    assert run("derive", "--check") == (0, "generated files are what the derivation writes\n", "")
    monkeypatch.setattr("stridemap.codegen.drift", lambda: ["compass/compass.c"])
    status, out, err = run("derive", "--check")
    assert (status, out) == (1, "differs: compass/compass.c\n")
    assert err == "1 generated files differ from the derivation; run `stridemap derive`\n"


def test_version(run):
    assert run("version") == (0, f"{stridemap.__version__}\n", "")


def test_help_names_the_commands_and_the_parameters(run):
    status, out, err = run("--help")
    assert (status, err) == (0, "")
    listed = [line.split()[0] for line in out[out.index("Commands:") :].splitlines()[1:] if line.strip()]
    assert {"orbit", "sweep", "simulate", "derive"} <= set(listed)
    for command in ("orbit", "simulate"):
        text = " ".join(run(command, "--help")[1].split())
        assert " ".join(run(command, "--help", "--model=wobbling")[1].split()) == text
        for name in available():
            status, out, err = run(command, "--model", name, "--help")
            assert (status, err) == (0, "")
            parameters = out[out.index(f"Parameters of the model {name}") :].splitlines()[1:]
            options = [line.split()[0] for line in parameters if line.strip().startswith("--")]
            assert options == [f"--{parameter}" for parameter in load(name).preset]
            told = " ".join(out.split())
            for a in load(name).parameters:
                assert f"{a.meaning} [{a.unit}]; {a.allowed}; preset {a.default:.6g}" in told
        for option in ("--model", "--set", "--json"):
            assert option in text
    text = run("sweep", "--help")[1]
    for option in ("--out", "--workers", "--resume"):
        assert option in text


# -- without a compiler --------------------------------------------------------------------------------------


def test_without_a_compiler_the_same_comes_with_one_warning(run, tmp_path, monkeypatch):
    words = ["orbit", *TWO, "--json", "--starts", "32"]
    compiled = printed(run(*words))
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CC", raising=False)
    load_kernels.cache_clear()
    try:
        status, out, err = run(*words)
    finally:
        load_kernels.cache_clear()
    assert status == 0
    assert err.count("\n") == 1
    assert err.startswith("warning: no C compiler found")
    found = json.loads(out)
    # Compiled kernels may take several points at a time, with sines of their own: equal but for rounding.
    assert len(found["orbits"]) == len(compiled["orbits"])
    for mine, wanted in zip(found["orbits"], compiled["orbits"], strict=True):
        assert mine["period"] == pytest.approx(wanted["period"], rel=1e-12)
        assert mine["state"] == pytest.approx(wanted["state"], rel=0, abs=1e-11)


def test_a_sweep_without_a_compiler_warns_once(tmp_path):
    config, out = tmp_path / "my.toml", tmp_path / "out"
    config.write_text('model = "compass"\n[grid]\nomega = [2.5, 3.0]\n[search]\nstarts = 8\n')
    environment = {"PATH": str(tmp_path), "CC": "", "SYSTEMROOT": ""}
    done = subprocess.run(
        [*STRIDEMAP, "sweep", str(config), "--out", str(out), "--workers", "2"],
        capture_output=True,
        text=True,
        env=environment,
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr.count("no C compiler found") == 1
    assert done.stderr.startswith("warning: no C compiler found")
    assert "virtual machine" in stridemap.sweeps.store.read_provenance(out)["compiler"]
