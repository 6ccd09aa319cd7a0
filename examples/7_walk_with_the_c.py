"""
7. Walk with the C: a step function for a controller
====================================================

Beside the equations there is a function that takes a whole step: it integrates, finds the
touchdown, and applies the impact. With a limit cycle in a header of its own, a controller has
all that it needs, on a microcontroller too. This page walks twenty steps with it, in double
and in single precision, and compares with the simulator.
"""

import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stridemap
from stridemap.views import palette

# %%
# The files
# ---------
# On the command line: ``stridemap derive wobbling --out walker --cycle stable --k 6``. It takes
# the name of a model or a model file, and parameters as ``stridemap orbit`` does. In Python:

orbit = next(o for o in stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3) if o.stable)
scratch = tempfile.TemporaryDirectory()
folder = Path(scratch.name)
print(*(path.name for path in stridemap.write_c(orbit, folder)), sep="\n")

# %%
# The header of the limit cycle has its parameters, its section point, period and multipliers,
# and the motion over phase, with a function that interpolates it.

print((folder / "wobbling_cycle.h").read_text()[:2200])

# %%
# The program
# -----------
# Parameters have names, and so have the places in the arrays. The walker is pushed: its leg
# turns 2 % faster than on the cycle. Each step returns a status that says how it ended, and
# nothing is allocated or kept between calls.

PROGRAM = r"""
#include "wobbling_cycle.h"

#include <stdio.h>

int main(void)
{
    const int per_step = PER_STEP; /* integration steps */
    const stridemap_real dt = wobbling_cycle_period[0] / (stridemap_real) per_step;
    stridemap_real p[WOBBLING_N_P], z[WOBBLING_N_Z], period;
    wobbling_parameters walker;

    wobbling_parameters_from_array(&walker, wobbling_cycle_p);
    fprintf(stderr, "k = %g, alpha = %g\n", (double) walker.k, (double) walker.alpha);
    wobbling_parameters_to_array(&walker, p);

    for (int i = 0; i < WOBBLING_N_Z; i++)
        z[i] = wobbling_cycle_z[0][i];
    z[WOBBLING_Z_dtheta1] *= (stridemap_real) 1.02;

    for (int step = 0; step < 20; step++) {
        const wobbling_status status = wobbling_step(z, p, dt, 4 * per_step, &period);
        if (status != WOBBLING_TOUCHDOWN) {
            fprintf(stderr, "step %d ended with status %d\n", step + 1, (int) status);
            return 1;
        }
        for (int i = 0; i < WOBBLING_N_Z; i++)
            printf("%.17g ", (double) z[i]);
        printf("%.17g\n", (double) period);
    }
    return 0;
}
"""
(folder / "walk.c").write_text(PROGRAM)

# %%
# Compile and walk
# ----------------
# Three files, and every warning is an error. ``STRIDEMAP_FLOAT`` makes all numbers ``float``;
# no ``double`` is left in what runs, which ``-Wdouble-promotion`` sees to.

WARNINGS = "-Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Werror".split()
compiler = next(name for name in ("cc", "gcc", "clang") if shutil.which(name))


def walked(per_step, *options):
    """Section points and periods of the steps that the C walks, shape (20, 6)."""
    flags = ["-std=c99", "-O2", *WARNINGS, f"-DPER_STEP={per_step}", *options]
    command = [compiler, *flags, "walk.c", "wobbling_step.c", "wobbling.c", "-lm", "-o", "walk"]
    print("$", " ".join(command))
    subprocess.run(command, cwd=folder, check=True)
    done = subprocess.run([folder / "walk"], capture_output=True, text=True, check=True)
    return np.array([line.split() for line in done.stdout.splitlines()], dtype=float)


in_double = walked(256)
in_float = walked(64, "-DSTRIDEMAP_FLOAT")

# %%
# Compare
# -------
# The simulator shares the equations with the C and nothing else: it integrates with adaptive
# steps, and searches for the touchdown in an interpolant.

pushed = {**orbit.state, "dtheta1": 1.02 * orbit.state["dtheta1"]}
walk = stridemap.simulate("wobbling", pushed, steps=20, params=orbit.params)
simulated = np.array([[*step.state.values(), step.period] for step in walk.steps])

off_double, off_float = (np.abs(c - simulated).max(axis=1) for c in (in_double, in_float))
print(f"largest difference in 20 steps: {off_double.max():.0e} in double precision,")
print(f"                                {off_float.max():.0e} in single precision")
assert off_double.max() < 1e-9
assert off_float.max() < 1e-4

fixed_point = np.array([*orbit.state.values(), orbit.period])
figure, axes = plt.subplots(2, sharex=True, figsize=(6.4, 5.2), layout="constrained")
steps = np.arange(1, 21)
for data, style, label in [
    (simulated, dict(marker="o", color="0.7", markersize=8), "simulator"),
    (in_double, dict(marker="x", color=palette.BLUE), "C, double"),
    (in_float, dict(marker="+", color=palette.VERMILION, markersize=9), "C, float"),
]:
    axes[0].plot(steps, data[:, 1] - fixed_point[1], linestyle="", label=label, **style)
axes[0].set_ylabel(r"$\dot\theta_1$ from the cycle's, $\sqrt{g/L}$")
axes[0].legend(frameon=False)
axes[1].semilogy(steps, off_float, "+", color=palette.VERMILION, markersize=9, label="float")
axes[1].semilogy(steps, off_double, "x", color=palette.BLUE, label="double")
axes[1].set_ylabel("difference from the simulator")
axes[1].set_xlabel("step")
axes[1].set_xticks(steps[::3])

# %%
# How much room it takes
# ----------------------
# The code of the step function and of the equations, and the stack, as this machine's compiler
# makes them when it is asked for small code. Functions that are never called, such as the
# derivatives, are left out by the linker when it is run with ``--gc-sections``.


def sections(file):
    """Bytes of code and constants by function, in an object file."""
    listed = subprocess.run(
        ["size", "-A", file], cwd=folder, capture_output=True, text=True, check=True
    )
    rows = (line.split() for line in listed.stdout.splitlines())
    kept = {row[0]: int(row[1]) for row in rows if row and re.match(r"\.(text|rodata)", row[0])}
    return kept


def stack(file):
    """Bytes of stack of each function that the compiler has left as one."""
    rows = (line.split("\t") for line in (folder / file).read_text().splitlines())
    return {name.rpartition(":")[2]: int(size) for name, size, _ in rows}


room = {}
for precision, options in {"double": [], "float": ["-DSTRIDEMAP_FLOAT"]}.items():
    for name in ("wobbling_step", "wobbling"):
        flags = ["-std=c99", "-Os", "-ffunction-sections", "-fstack-usage", *options]
        subprocess.run([compiler, *flags, "-c", f"{name}.c"], cwd=folder, check=True)
    source = (folder / "wobbling_step.c").read_text()
    called = {name for name in re.findall(r"\bwobbling_(\w+)\(", source)}
    of_step = sum(sections("wobbling_step.o").values())
    of_equations = sum(
        size
        for name, size in sections("wobbling.o").items()
        if name.rpartition(".wobbling_")[2].removesuffix("_float") in called or "rodata" in name
    )
    # The step's functions call each other, and then one of the equations: no path is deeper.
    deepest = sum(stack("wobbling_step.su").values()) + max(stack("wobbling.su").values())
    room[precision] = of_step, of_equations, deepest
    print(
        f"{precision:>6}: {of_step:,} bytes of code in the step function, {of_equations:,} in "
        f"the equations it calls; at most {deepest:,} bytes of stack"
    )

scratch.cleanup()

# %%
# In your own program
# -------------------
# * ``wobbling_step`` takes a section point, just after touchdown; ``wobbling_swing`` starts
#   from any state within a step, such as an estimate, and says when the foot will touch down.
# * Its work is bounded by the number of integration steps that it is allowed.
# * ``wobbling_cycle_at`` gives the reference motion at any time of a step.
# * All numbers are in the units of the model; ``stridemap.Units`` converts parameters, states
#   and times to SI.
