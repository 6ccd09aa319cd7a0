"""A limit cycle as a C header: its numbers are the cycle's, and the C walks on it."""

import re
import subprocess

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline

import stridemap
from stridemap.errors import InputError
from tests.oracles.states import need
from tests.oracles.step_in_c import STRICT

POINT = {"k": 6, "alpha": 0.25, "omega": 3}


@pytest.fixture(scope="module")
def orbit():
    return next(o for o in stridemap.find_orbits("wobbling", POINT) if o.stable)


@pytest.fixture(scope="module")
def folder(orbit, tmp_path_factory):
    """The C of the stable gait, with 33 rows of its motion."""
    folder = tmp_path_factory.mktemp("walker")
    written = stridemap.write_c(orbit, folder, samples=33)
    assert sorted(written) == sorted(folder.iterdir())
    assert written[-1].name == "wobbling_cycle.h"
    return folder


WALK = """
#include "{header}.h"
#include <stdio.h>

/* All numbers of the header, the motion at other times, and the section points of a walk. */
int main(void)
{{
    enum {{ STEPS = {upper}_STEPS }};
    stridemap_real z[{model}_N_Z], q[{model}_N_Q], v[{model}_N_Q], period;
    for (int i = 0; i < {model}_N_P; i++)
        printf("%.17g\\n", (double) {header}_p[i]);
    for (int s = 0; s < STEPS; s++) {{
        for (int i = 0; i < {model}_N_Z; i++)
            printf("%.17g\\n", (double) {header}_z[s][i]);
        printf("%.17g\\n", (double) {header}_period[s]);
    }}
    for (int i = 0; i < {model}_N_Z; i++)
        printf("%.17g %.17g\\n", (double) {header}_multipliers[i][0], (double) {header}_multipliers[i][1]);
    for (int s = 0; s < STEPS; s++)
        for (int i = 0; i <= 10; i++) {{
            {header}_at(s, {header}_period[s] * (stridemap_real) i / 10, q, v);
            for (int j = 0; j < {model}_N_Q; j++)
                printf("%.17g %.17g\\n", (double) q[j], (double) v[j]);
        }}
    for (int i = 0; i < {model}_N_Z; i++)
        z[i] = {header}_z[0][i];
    for (int s = 0; s < 2 * STEPS; s++) {{
        const stridemap_real dt = {header}_period[0] / {count};
        if ({name}_step(z, {header}_p, dt, 4 * {count}, &period) != {model}_TOUCHDOWN)
            return 1;
        for (int i = 0; i < {model}_N_Z; i++)
            printf("%.17g\\n", (double) z[i]);
        printf("%.17g\\n", (double) period);
    }}
    return 0;
}}
"""


def printed(name, folder, header=None, options=(), count=200):
    """What the program prints, under all warnings."""
    header = header or f"{name}_cycle"
    filled = WALK.format(header=header, upper=header.upper(), model=name.upper(), name=name, count=count)
    (folder / "main.c").write_text(filled)
    flags = ["-std=c99", "-O2", *STRICT, *options]
    command = [need("gcc", "clang"), *flags, "main.c", f"{name}_step.c", f"{name}.c", "-lm", "-o", "main"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    out = subprocess.run([folder / "main"], capture_output=True, text=True, check=True).stdout
    return iter(map(float, out.split()))


def compare(orbit, values, exact, motion, walked):
    """Numbers of the header, its motion between rows, and two cycles walked from its section point."""

    def take(*shape):
        return np.array([next(values) for _ in range(int(np.prod(shape)))]).reshape(shape)

    model, n = orbit.model, len(orbit.model.coordinates)
    steps = orbit.steps or ({**orbit.state, "period": orbit.period},)
    points = np.array([[step[name] for name in (*model.section, "period")] for step in steps])
    np.testing.assert_allclose(take(len(model.parameters)), list(orbit.params.values()), rtol=exact)
    np.testing.assert_allclose(take(*points.shape), points, rtol=exact)
    pairs = take(len(orbit.multipliers), 2)
    np.testing.assert_allclose(pairs @ [1, 1j], orbit.multipliers, rtol=exact, atol=exact)
    whole = orbit.motion(11)
    wanted = np.stack([whole.q, whole.v], axis=-1).reshape(len(steps), 11, n, 2)
    np.testing.assert_allclose(take(*wanted.shape), wanted, rtol=0, atol=motion)
    twice = np.concatenate([points[1:], points, points[:1]])[: 2 * len(points)]
    ends = take(2 * len(points), points.shape[1])
    np.testing.assert_allclose(ends[:, :-1], twice[:, :-1], rtol=0, atol=walked)
    periods = np.tile(points[:, -1], 2)
    np.testing.assert_allclose(ends[:, -1], periods, rtol=0, atol=walked)
    assert next(values, None) is None


def test_the_header_holds_the_cycle_and_the_c_walks_on_it(orbit, folder):
    said = re.search(r"off by at most (\S+) in q and (\S+) in v", (folder / "wobbling_cycle.h").read_text())
    in_q, in_v = map(float, said.groups())
    assert 1e-9 < in_q < in_v < 5e-5
    compare(orbit, printed("wobbling", folder), 0.0, in_v, 1e-9)
    # What is said of the interpolation, from SciPy's own at sixteen times between two rows.
    motion = orbit.motion(32 * 16 + 1)
    values = {"t": motion.t, "q": motion.q, "v": motion.v, "p": orbit.model.point(orbit.params)}
    rates = {"q": motion.v, "v": orbit.model.evaluate("state_derivative", **values)["dv"]}
    for name, bound in (("q", in_q), ("v", in_v)):
        rows, whole = motion.t[::16], values[name]
        off = np.abs(CubicHermiteSpline(rows, whole[::16], rates[name][::16])(motion.t) - whole).max()
        assert off < bound < 1.3 * off


def test_in_single_precision(orbit, folder):
    compare(orbit, printed("wobbling", folder, options=["-DSTRIDEMAP_FLOAT"]), 1e-6, 5e-6, 2e-5)


def test_rows_are_the_motion_and_torques_at_evenly_spaced_times(orbit, folder):
    text = (folder / "wobbling_cycle.h").read_text()
    motion = orbit.motion(33)
    for letter, wanted in (("q", motion.q), ("v", motion.v), ("u", motion.torque)):
        table = re.search(rf"wobbling_cycle_{letter}\[1\]\[33\]\[\d\] = (\{{.*?\n\}});", text, flags=re.S)[1]
        found = [float(x) for x in re.findall(r"-?\d+\.\d+(?:e-?\d+)?", table)]
        np.testing.assert_allclose(found, wanted.ravel(), rtol=0, atol=1e-13)


def test_a_cycle_of_three_steps_of_a_walker_without_motors(tmp_path):
    """Two headers in one program: names begin with the header's."""
    three = stridemap.find_orbits("simplest_walker", period_n=3, slope=0.0124)[0]
    stridemap.write_c(three, tmp_path, header="limp")
    compare(three, printed("simplest_walker", tmp_path, "limp", count=400), 0.0, 1e-6, 1e-9)
    one = stridemap.find_orbits("simplest_walker", slope=0.0124)[0]
    stridemap.write_c(one, tmp_path)
    assert "_u[" not in (tmp_path / "limp.h").read_text()
    (tmp_path / "both.c").write_text(
        '#include "limp.h"\n#include "simplest_walker_cycle.h"\n'
        "int main(void) { return LIMP_STEPS - 2 - SIMPLEST_WALKER_CYCLE_STEPS; }\n"
    )
    for flags in (["-std=c99"], ["-x", "c++", "-std=c++17", "-DSTRIDEMAP_FLOAT"]):
        command = [need("clang", "gcc"), *flags, *STRICT, "both.c", "-o", "both"]
        subprocess.run(command, cwd=tmp_path, check=True)
        subprocess.run([tmp_path / "both"], check=True)


def test_the_folder_is_a_model_that_can_be_loaded(folder):
    assert stridemap.load(str(folder)).hash == stridemap.load("wobbling").hash


@pytest.mark.parametrize(
    ("header", "words"),
    [
        ("wobbling", "generated file"),
        ("Wobbling_Step", "generated file"),
        ("README", "generated file"),
        ("math", "header of C"),
        ("double", "means something in C"),
        ("wobbling_p", "beginning of names"),
        ("a-b", "cannot be a name in C"),
        ("gait.h", "cannot be a name in C"),
        ("x" * 61, "cannot be a name in C"),
        (3, "cannot be a name in C"),
    ],
)
def test_names_that_a_header_cannot_have(orbit, tmp_path, header, words):
    with pytest.raises(InputError, match=words):
        stridemap.write_c(orbit, tmp_path / "c", header=header)
    assert not (tmp_path / "c").exists()


def test_what_cannot_be_written(orbit, tmp_path):
    with pytest.raises(InputError, match="samples = 1 is not allowed"):
        stridemap.write_c(orbit, tmp_path / "c", samples=1)
    (tmp_path / "README.md").write_text("mine")
    with pytest.raises(InputError, match="does not belong to the model wobbling"):
        stridemap.write_c(orbit, tmp_path)
    with pytest.raises(InputError, match="cannot write"):
        stridemap.write_c(orbit, tmp_path / "README.md" / "c")
    several = stridemap.find_orbits("wobbling", POINT)
    with pytest.raises(InputError, match="is not one limit cycle; give one of those"):
        stridemap.write_c(several, tmp_path / "c")
    with pytest.raises(InputError, match="orbit = 'compass' is not one limit cycle"):
        stridemap.motion("compass")


# -- the command ---------------------------------------------------------------------------------------------


def test_derive_writes_a_cycle(run, refused, orbit, folder, tmp_path):
    out = tmp_path / "c"
    status, listed, err = run(
        "derive",
        "wobbling",
        "--out",
        out,
        "--cycle",
        "stable",
        "--samples",
        33,
        "--k",
        6,
        "--set",
        "alpha=0.25",
    )
    assert (status, err) == (0, "")
    assert listed.splitlines()[-1] == str(out / "wobbling_cycle.h")
    assert (out / "wobbling_cycle.h").read_bytes() == (folder / "wobbling_cycle.h").read_bytes()
    assert sorted(listed.splitlines()) == sorted(map(str, out.iterdir()))
    # The first cycle is the unstable one, as `stridemap orbit` numbers them.
    assert run("derive", "wobbling", "--out", out, "--cycle", 1, "--header", "first")[0] == 0
    assert "unstable" in (out / "first.h").read_text()
    refused(f"derive wobbling --out {out} --cycle 3", "--cycle 3", "1 to 2")
    refused(f"derive wobbling --out {out} --cycle soon", "--cycle soon", "stable")
    status, listed, err = run("derive", "wobbling", "--out", out, "--cycle", "stable", "--k", 1)
    assert (status, listed) == (1, "")
    assert err == "no cycle is stable at this point; --cycle 1 to 1 writes an unstable one\n"


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("derive wobbling --cycle stable", "--out DIR"),
        ("derive --out x --cycle stable", "MODEL"),
        ("derive wobbling --out x --k 6", "--k is not understood"),
        ("derive wobbling --out x --header a", "--header is for a limit cycle"),
        ("derive wobbling --out x --period-n 2", "--period-n is for a limit cycle"),
        ("derive wobbling", "wobbling is a built-in model"),
        ("derive no_such_file.py", "cannot read"),
        ("derive wobbling --out x --cycle stable --kk 6", "no parameter 'kk'"),
    ],
)
def test_what_the_command_refuses(refused, line, words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    refused(line, words)
    assert not list(tmp_path.iterdir())


def test_the_help_lists_the_parameters_of_the_model_that_is_named(run):
    assert "--slope NUMBER" in run("derive", "simplest_walker", "--help")[1]
    assert "--omega NUMBER" in run("derive", "--help")[1]


def test_a_built_in_model_is_copied(run, tmp_path):
    status, listed, err = run("derive", "compass", "--out", tmp_path / "c")
    assert (status, err) == (0, "")
    assert sorted(listed.splitlines()) == sorted(map(str, (tmp_path / "c").iterdir()))
    assert (tmp_path / "c" / "compass_step.c").exists()
