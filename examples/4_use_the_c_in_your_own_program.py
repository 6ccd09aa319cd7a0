"""
4. Use the C in your own program
================================

The generated C needs a C99 compiler and nothing else: no CasADi, no allocation, no global
state. This page writes a program around it, a controller's or a simulator's inner loop,
compiles it, and compares with Python.
"""

import shutil
import subprocess
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stridemap
from stridemap.views import palette

# %%
# The program
# -----------
# It reads parameters and a state just after touchdown, integrates one swing phase with the
# classical Runge-Kutta method, and prints the motion and the state after the impact. All
# mechanics comes from four generated functions: ``section_state``, ``state_derivative``,
# ``zmp`` and ``impact_map``. The header documents every argument. All functions of all models
# take time, coordinates, rates, torques of the motors and parameters, in this order (on the
# section: a point and parameters). What a function does not read may be a null pointer: here
# the torques, because the controller is part of the model.

PROGRAM = r"""
#include "wobbling.h"

#include <stdio.h>
#include <stdlib.h>

enum { N = 3, P = 9 }; /* coordinates and parameters */

/* y = (q, v): y + a k as coordinates and rates */
static void moved(const double y[2 * N], double a, const double k[2 * N],
        double q[N], double v[N])
{
    for (int i = 0; i < N; i++) {
        q[i] = y[i] + a * k[i];
        v[i] = y[N + i] + a * k[N + i];
    }
}

static void runge_kutta(double t, double h, const double p[P], double y[2 * N])
{
    static const double part[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0, 2.0, 2.0, 1.0};
    double k[2 * N] = {0.0}, sum[2 * N] = {0.0}, q[N], v[N];

    for (int stage = 0; stage < 4; stage++) {
        moved(y, part[stage] * h, k, q, v);
        wobbling_state_derivative(t + part[stage] * h, q, v, NULL, p, k, k + N);
        for (int i = 0; i < 2 * N; i++)
            sum[i] += weight[stage] * k[i];
    }
    for (int i = 0; i < 2 * N; i++)
        y[i] += h / 6.0 * sum[i];
}

/* walk  period  p[0..8]  z[0..4] */
int main(int argc, char **argv)
{
    const int steps = 400;
    double p[P], z[5], y[2 * N], zmp[1], d[1], q_plus[N], v_plus[N];

    if (argc != 2 + P + 5)
        return 2;
    const double period = atof(argv[1]);
    for (int i = 0; i < P; i++)
        p[i] = atof(argv[2 + i]);
    for (int i = 0; i < 5; i++)
        z[i] = atof(argv[2 + P + i]);

    wobbling_section_state(z, p, y, y + N);
    for (int i = 0; i <= steps; i++) {
        const double t = period * i / steps;
        wobbling_zmp(t, y, y + N, NULL, p, zmp, d);
        printf("%.17g %.17g %.17g %.17g %.17g\n", t, y[0], y[1], y[2], d[0]);
        if (i < steps)
            runge_kutta(t, period / steps, p, y);
    }
    wobbling_impact_map(period, y, y + N, NULL, p, q_plus, v_plus);
    printf("%.17g %.17g %.17g %.17g %.17g\n",
            q_plus[0], v_plus[0], v_plus[1], q_plus[2], v_plus[2]);
    return 0;
}
"""

# %%
# Compile and run
# ---------------
# Two files to compile, ``-lm`` to link. ``model.text`` gives the text of a generated file;
# copy ``wobbling.c`` and ``wobbling.h`` into your own project, they stand alone.

model = stridemap.load("wobbling")
orbit = next(o for o in stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3) if o.stable)

compiler = next(name for name in ("cc", "gcc", "clang") if shutil.which(name))
numbers = [orbit.period, *orbit.params.values(), *orbit.state.values()]

with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    (folder / "walk.c").write_text(PROGRAM)
    for name in ("wobbling.c", "wobbling.h"):
        (folder / name).write_text(model.text(name))
    flags = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror"]
    command = [compiler, *flags, "walk.c", "wobbling.c", "-lm", "-o", "walk"]
    print("$", " ".join(command))
    subprocess.run(command, cwd=folder, check=True)
    printed = subprocess.run(
        [folder / "walk", *map(repr, numbers)], capture_output=True, text=True, check=True
    ).stdout

rows = np.array([line.split() for line in printed.splitlines()], dtype=float)
t, c_motion, after_impact = rows[:-1, 0], rows[:-1, 1:], rows[-1]

# %%
# Compare
# -------
# The motion of the same limit cycle from Python, at the same times. The Runge-Kutta method in
# C has order 4, and its error at 400 steps is what is seen; the state after the impact is the
# one that the step began with, because it is a limit cycle.

motion = stridemap.motion(orbit, samples=len(t))
python_motion = np.column_stack(
    [*(motion.coordinate(name) for name in model.coordinates), motion.d]
)
difference = np.abs(c_motion - python_motion).max(axis=0)
closing = np.abs(after_impact - list(orbit.state.values())).max()
print(
    "largest difference in theta1, theta2, x, d:",
    " ".join(f"{value:.0e}" for value in difference),
)
print(f"the cycle closes to {closing:.0e}")
assert difference.max() < 1e-8
assert closing < 1e-8

figure, axes = plt.subplots(2, sharex=True, figsize=(6.4, 5.2), layout="constrained")
lines = [(r"$\theta_1$", "-"), (r"$\theta_2$", "--"), ("$x$", "-."), ("$d$", ":")]
for i, (label, style) in enumerate(lines):
    axes[0].plot(motion.t, python_motion[:, i], style, color="0.2", label=label)
    axes[0].plot(
        t[::20],
        c_motion[::20, i],
        "o",
        color=palette.VERMILION,
        markersize=4,
        label="dots: from C" if i == 3 else None,
    )
    axes[1].semilogy(
        t[1:], np.abs(c_motion - python_motion)[1:, i], style, color="0.2", label=label
    )
axes[0].set_ylabel("rad, L")
axes[0].legend(ncols=5, loc="lower left", bbox_to_anchor=(0, 1), frameon=False, columnspacing=1)
axes[1].set_ylabel("difference, C and Python")
axes[1].set_xlabel(r"time since touchdown in $\sqrt{L/g}$")

# %%
# In a real-time program, call the functions with your own state estimate: none has a loop or a
# branch, the longest is some 150 operations, and none of them keeps anything between calls, so
# they may run in any thread.
