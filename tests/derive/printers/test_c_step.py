"""The step function in C: it ends where the simulator ends, without a warning, whatever names there are."""

import re
import shutil
import subprocess
from collections import Counter
from types import SimpleNamespace

import numpy as np
import pytest

import stridemap
from stridemap.codegen import generated_folder
from stridemap.derive import Parameter
from stridemap.derive.models import WALKERS
from stridemap.derive.printers.c_step import STATUS as DOCUMENTED
from stridemap.derive.printers.c_step import step_header, step_source
from stridemap.derive.printers.printer import Equations
from stridemap.derive.validate.reserved import meaning
from stridemap.solver.model.loading import load
from tests.derive.test_names_in_code import WORD
from tests.oracles import walkers
from tests.oracles.states import MODELS, need
from tests.oracles.step_in_c import STATUS, STRICT, StepInC, random_points, simulated, usual_dt


@pytest.fixture(scope="module")
def in_c(tmp_path_factory):
    """The step function of a model, compiled once."""
    made = {}

    def get(model, single=False):
        key = model.name, single
        if key not in made:
            made[key] = StepInC(model, tmp_path_factory.mktemp(model.name), single)
        return made[key]

    return get


# -- the same steps as the simulator's -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "count"), [("wobbling", 24), ("simplest_walker", 20), ("rimless_wheel", 16)]
)
def test_it_ends_where_the_simulator_ends(name, count, in_c):
    """Far from a gait, too: scuffing, rocking back and falls are told apart as by the simulator."""
    model = load(name)
    p, dt = model.point({}), usual_dt(model)
    seen = Counter()
    for z in random_points(model, count, seed=4):
        status, landed, duration = simulated(model, z, p)
        found, after, period = in_c(model).step(z, p, dt)
        assert found == status, z
        seen[status] += 1
        if landed is None:
            np.testing.assert_array_equal(after, z)
        else:
            np.testing.assert_allclose(after, landed, rtol=0, atol=5e-8)  # the integrator's error at this dt
            assert period == pytest.approx(duration, abs=5e-8)
    assert seen["TOUCHDOWN"] >= 2
    assert seen["ROCKS_BACK"] >= 2
    assert seen["FALLS_BACKWARD"] + seen["FALLS_FORWARD"] >= 1


def test_the_error_falls_with_the_fifth_power_of_dt(in_c):
    model = load("wobbling")
    p, z = model.point({}), [0.0942, -0.1455, -0.0026, 0.0029, 0.152]
    _, landed, duration = simulated(model, z, p)
    off = []
    for n in (24, 48, 96):
        _, after, period = in_c(model).step(z, p, 1.2 / n)
        off.append(np.abs([*(after - landed), period - duration]).max())
    assert off[0] < 1e-5
    ratios = np.divide(off[:-1], off[1:])
    assert (ratios > 20).all()
    assert (ratios < 60).all()


def test_single_precision_walks_the_same_steps(in_c):
    model = load("wobbling")
    p, z = model.point({}), np.array([0.0942, -0.1455, -0.0026, 0.0029, 0.152])
    double, single = z.copy(), z.copy()
    for _ in range(5):
        how, double, period = in_c(model).step(double, p, 0.01)
        how_single, single, period_single = in_c(model, True).step(single, p, 0.01)
        assert how == how_single == "TOUCHDOWN"
        np.testing.assert_allclose(single, double, rtol=0, atol=5e-6)
        assert period_single == pytest.approx(period, abs=5e-6)
    assert (np.float32(single) == single).all()


def test_a_swing_phase_may_begin_anywhere(in_c):
    """From the simulator's own states within the step: the same touchdown."""
    model = load("wobbling")
    p, z = (
        model.point({}),
        {"theta1": 0.0942, "dtheta1": -0.1455, "dtheta2": -0.0026, "x": 0.0029, "dx": 0.152},
    )
    walk = stridemap.simulate("wobbling", z, steps=1)
    rows = walk.trajectory(0.2)
    before = rows.take(rows.event == "before_impact")
    for i in np.flatnonzero((rows.event == "sample") & (rows.step == 1)):
        how, t, state = in_c(model).swing(rows.step_time[i], rows.q[i], rows.v[i], p, 0.004)
        assert how == "TOUCHDOWN"
        assert t == pytest.approx(walk.steps[0].period, abs=1e-9)
        np.testing.assert_allclose(state, [*before.q[0], *before.v[0]], rtol=0, atol=1e-9)


def test_a_clock_that_is_not_reset_and_a_wheel_that_counts_its_spokes(in_c):
    """The phase of the clock stays within one turn; a parameter that counts is a number like others."""
    model = walkers.derived("locked")
    p = model.point({})
    turned = []
    for z in random_points(model, 16, seed=2, spread=0.6):
        status, landed, duration = simulated(model, z, p)
        found, after, _ = in_c(model).step(z, p, 0.01)
        assert found == status, z
        if landed is not None:
            np.testing.assert_allclose(after, landed, rtol=0, atol=1e-8)
            turned.append(round((z[3] + 3 * duration - after[3]) / (2 * np.pi)))
    assert set(turned) >= {0, 1}, "the phase has passed the end of a turn, and has not"
    wheel = load("rimless_wheel")
    for spokes in (5, 8):
        p = wheel.point({"spokes": spokes})
        z = [-np.pi / spokes, 0.6]
        status, landed, duration = simulated(wheel, z, p)
        found, after, period = in_c(wheel).step(z, p, 0.01)
        assert found == status == "TOUCHDOWN"
        np.testing.assert_allclose([*after, period], [*landed, duration], rtol=0, atol=1e-10)


def test_every_way_to_fail_has_a_status(in_c):
    model = load("simplest_walker")
    p, z, step = model.point({}), [0.2, -0.2], in_c(model).step
    assert step(z, p, 0.01)[0] == "TOUCHDOWN"
    how, after, period = step(z, p, 0.01, most=100)
    assert (how, period) == ("NO_TOUCHDOWN", pytest.approx(1.0))
    np.testing.assert_array_equal(after, z)
    assert step([0.2, 0.0], p, 0.01)[0] == "STOPS"
    assert step([0.2, np.nan], p, 0.01)[0] == "NOT_FINITE"
    assert step([0.2, -0.2], [np.inf], 0.01)[0] == "NOT_FINITE"
    assert step([0.2, -1e300], p, 0.01)[0] == "NOT_FINITE"
    for dt, most in ((0.0, 10), (-0.01, 10), (np.nan, 10), (np.inf, 10), (0.01, 0), (0.01, -1)):
        assert step(z, p, dt, most)[0] == "NOT_ALLOWED", (dt, most)
    assert STATUS == tuple(word for word, _ in DOCUMENTED)


@pytest.mark.parametrize("name", MODELS)
def test_what_is_generated_is_what_the_printer_writes(name):
    """What is tested here is what would be printed now; no equation needs to be derived for that."""
    spec = load(name).spec
    read = [SimpleNamespace(name=a) for a in spec.functions["state_derivative"].arguments]
    program = SimpleNamespace(name="state_derivative", arguments=read)
    equations = Equations(WALKERS[name], (program,), spec.generator, spec.hash)
    assert step_header(equations) == load(name).text(f"{name}_step.h")
    assert step_source(equations) == load(name).text(f"{name}_step.c")


# -- compilers -----------------------------------------------------------------------------------------------

AS_C, AS_CPP = ["-std=c99"], ["-x", "c++", "-std=c++17"]


def compiled(compiler, flags, folder, source, target):
    command = [need(compiler), *flags, *STRICT, "-O2", f"-I{folder}", "-c", source, "-o", target]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert not done.stderr


@pytest.mark.parametrize("name", MODELS)
def test_it_compiles_without_a_warning(name, tmp_path):
    """In both precisions, as C and as C++; with both compilers, but not in every combination."""
    where = generated_folder() / name
    source, target = where / f"{name}_step.c", tmp_path / "out.o"
    ways = [("gcc", AS_C), ("clang++", [*AS_CPP, "-DSTRIDEMAP_FLOAT"])]
    if name in ("wobbling", "rimless_wheel"):  # a fall is seen by an angle, or by a height
        ways += [
            ("clang", [*AS_C, "-DSTRIDEMAP_FLOAT"]),
            ("g++", AS_CPP),
            ("gcc", [*AS_C, "-DSTRIDEMAP_FLOAT"]),
        ]
    for compiler, flags in ways:
        compiled(compiler, flags, where, source, target)


def test_it_has_no_state_and_needs_only_libm_and_the_equations(tmp_path):
    where = generated_folder() / "wobbling"
    compiled("gcc", AS_C, where, where / "wobbling_step.c", tmp_path / "out.o")
    listed = subprocess.run(["nm", tmp_path / "out.o"], capture_output=True, text=True, check=True).stdout
    symbols = [line.split()[-2:] for line in listed.splitlines()]
    kinds = {kind: {symbol for k, symbol in symbols if k == kind} for kind, _ in symbols}
    assert kinds["T"] == {"wobbling_step", "wobbling_swing"}
    own = {symbol for symbol in kinds["U"] if symbol.startswith("wobbling_")}
    assert {symbol.removeprefix("wobbling_") for symbol in own} <= load("wobbling").spec.functions.keys()
    assert kinds["U"] - own <= {"sqrt", "floor", "_GLOBAL_OFFSET_TABLE_"}
    assert not kinds.keys() & set("BbCDdGgSs"), "there is data that can change"


# -- names ---------------------------------------------------------------------------------------------------


def names_in_c():
    """Names that a user may choose among all words of a model's C."""
    found = set()
    for path in (generated_folder() / "rimless_wheel").iterdir():
        if path.name in ("rimless_wheel_step.c", "rimless_wheel_step.h", "rimless_wheel.h"):
            code = re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.DOTALL)
            found |= set(WORD.findall(code))
    own = {"theta", "dtheta", "slope", "spokes", "lambda2"}
    found = {n for n in found if not n.startswith("_") and meaning(n) is None and n not in own}
    return sorted(n for n in found if not VARIANT.search(n))


VARIANT = re.compile(r"^rimless_wheel_(old_|\w+_float$)")


@pytest.mark.parametrize("name", ["rimless_wheel_zmp_float", "rimless_wheel_old_zmp", "STRIDEMAP_X"])
def test_names_that_macros_make_or_bear_are_refused(name):
    wheel = WALKERS["rimless_wheel"]
    with pytest.raises(stridemap.InputError, match=f"the parameter {name} has .*choose another name"):
        wheel.with_(parameters=(*wheel.parameters, Parameter(name, 0.5, "1", "a parameter")))


def test_no_name_of_a_parameter_collides(tmp_path):
    """A header with every such name, and names that differ in case only, used as C and as C++."""
    names = [*names_in_c(), "c_arm", "C_arm", "kp", "COUNT", "STEPS"]
    assert {"N", "REAL", "STAGES", "moment", "after", "named", "rimless_wheel_step"} <= {*names}
    assert len(names) > 150
    wheel = WALKERS["rimless_wheel"]
    extra = tuple(Parameter(name, 0.5, "1", "a parameter") for name in names)
    # The header needs the declaration alone.
    walker = wheel.with_(parameters=(*wheel.parameters, *extra), drawing=())
    header = step_header(Equations(walker, (), "test", "0" * 64))
    (tmp_path / "rimless_wheel_step.h").write_text(header)
    shutil.copy(generated_folder() / "rimless_wheel" / "rimless_wheel.h", tmp_path)
    count = len(walker.parameters)
    (tmp_path / "main.c").write_text(
        '#include "rimless_wheel_step.h"\n#include <math.h>\n#include <stdio.h>\n#include <stdlib.h>\n'
        "int main(void)\n{\n"
        f"    stridemap_real p[{count}];\n    rimless_wheel_parameters a;\n"
        "    rimless_wheel_parameters_preset(&a);\n    rimless_wheel_parameters_to_array(&a, p);\n"
        "    p[RIMLESS_WHEEL_P_c_arm] = 7;\n    rimless_wheel_parameters_from_array(&a, p);\n"
        f"    if (RIMLESS_WHEEL_N_P != {count} || (int) sizeof(a) != {count} * (int) sizeof(p[0]))\n"
        "        return 1;\n"
        '    printf("%g %g %g\\n", (double) a.c_arm, (double) a.C_arm, (double) a.spokes);\n'
        "    return 0;\n}\n"
    )
    for compiler, flags in (("gcc", AS_C), ("g++", [*AS_CPP, "-DSTRIDEMAP_FLOAT"]), ("clang", AS_C)):
        compiled(compiler, flags, tmp_path, tmp_path / "main.c", tmp_path / "main.o")
        subprocess.run([need(compiler), "main.o", "-o", "main"], cwd=tmp_path, check=True)
        done = subprocess.run([tmp_path / "main"], capture_output=True, text=True, check=True)
        assert done.stdout == "7 0.5 6\n"


def test_names_and_arrays_have_the_same_order():
    for name in MODELS:
        spec, header = load(name).spec, load(name).text(f"{name}_step.h")
        for letter, argument in (("P", "p"), ("Q", "q"), ("Z", "z"), ("U", "u")):
            places = re.findall(rf"^    {name.upper()}_{letter}_(\w+)\b", header, flags=re.M)
            assert places == [e.name for e in spec.entries(argument)], (name, letter)
            assert f"{name.upper()}_N_{letter} = {spec.size(argument)}" in header
        fields = re.search(r"typedef struct \w+ \{(.*?)\}", header, flags=re.S)[1]
        assert re.findall(r"^    stridemap_real (\w+);", fields, flags=re.M) == list(spec.names)


def test_the_page_says_what_the_header_says():
    """Prototype and statuses on the page are those of the wobbling walker."""
    page = (generated_folder().parent / "docs" / "controller.md").read_text()
    header = load("wobbling").text("wobbling_step.h")
    (prototype,) = re.findall(r"^wobbling_status wobbling_step\(.*?;$", header, flags=re.M | re.S)
    assert prototype in page
    assert set(re.findall(r"`WOBBLING_([A-Z_]+)`", page)) - {"N_P"} == set(STATUS)
