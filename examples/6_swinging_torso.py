"""
6. A walker of your own: a swinging torso
=========================================

The outlook of Kamimura and Sano's paper asks for masses that swing like a pendulum. Here is
one: a compass walker whose torso is a mass above the hip, held up by a rotational spring. The
walker is declared in one short file, and the sweep over its spring takes a few lines.
"""

import inspect
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stridemap
from stridemap.sweeps.config import parse_config
from stridemap.views import palette

# %%
# The model file
# --------------
# This is all of it, below its first lines. The compass walker gets a coordinate, four
# parameters and a body; the spring and the damper act between the torso and the line that
# halves the angle between the legs.

HERE = (
    Path(inspect.currentframe().f_code.co_filename).resolve().parent
)  # the pages are built without __file__
PATH = HERE / "models" / "swinging_torso.py"
print(PATH.read_text(encoding="utf-8").split('"""')[2])

# %%
# The sweep
# ---------
# One without a damper and one with a little of it. Gaits that would pull at the ground are left
# out.


def branches(damper):
    """All limit cycles over the torso's spring."""
    config = parse_config(
        {
            "model": str(PATH),
            "params": {"c": damper},
            "grid": {"k": {"start": 0.8, "stop": 40.0, "num": 250, "spacing": "log"}},
            "search": {"starts": 32},
            "special_points": False,  # nothing below is about them
        }
    )
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(1) as executor:
        stridemap.sweep(config, folder, executor=executor)
        orbits = stridemap.read_orbits(folder)
    return orbits[(orbits.min_vertical_force > 0) & (orbits.step_length > 0)]


undamped, damped = branches(0.0), branches(0.05)

# %%
# What the spring does
# --------------------
# Filled marks are stable, open marks are not. The dashed line is the compass walker, whose
# upper body is all at the hip. Below ``alpha r`` = 0.125 the spring could not even hold the
# torso up at rest, and it takes more than ten times that before a gait is stable. Then one
# resonance follows another: from each branch to the next the torso swings once more in a step.
# Without a damper the branches overlap. With a little damping they join, and the resonances are
# waves in the cost of transport.

for name, orbits in (("no damper", undamped), ("with one", damped)):
    print(f"{name}: stable gaits from k = {orbits[orbits.stable].k.min():.2f} on")

measures = [
    ("spectral_radius", "largest modulus\nof a multiplier", (0.6, 1.6)),
    ("cot", "cost of transport", (0.2, 0.6)),
]
(compass,) = stridemap.find_orbits("compass")
figure, axes = plt.subplots(
    2, 2, sharex=True, sharey="row", figsize=(7.2, 5.6), layout="constrained"
)
for column, (orbits, title) in enumerate(
    [(undamped, "no damper"), (damped, "damper $c = 0.05$")]
):
    for row, (name, label, limits) in enumerate(measures):
        ax = axes[row, column]
        for stable, face in ((False, "none"), (True, palette.STABLE)):
            some = orbits[orbits.stable == stable]
            kind = "stable" if stable else "unstable"
            look = {"facecolors": face, "edgecolors": palette.STABLE, "linewidths": 0.6}
            ax.scatter(some.k, some[name], 10, label=kind, **look)
        ax.axhline(
            getattr(compass, name),
            color=palette.COMPASS,
            linestyle="--",
            linewidth=1,
            label="compass",
        )
        ax.set_ylim(limits)
        if column == 0:
            ax.set_ylabel(label)
    axes[0, column].axhline(1, color="0.8", linewidth=0.8, zorder=0)
    axes[0, column].set_title(title)
    axes[1, column].set_xlabel("spring $k$ in M g L")
    axes[1, column].set_xscale("log")
    axes[1, column].set_xticks([1, 2, 5, 10, 20, 40], ["1", "2", "5", "10", "20", "40"])
    axes[1, column].minorticks_off()
figure.legend(
    *axes[0, 0].get_legend_handles_labels(), loc="outside upper center", ncols=3, frameon=False
)

# %%
# A step, drawn
# -------------
# The lines by which a walker is drawn are part of its declaration. Here is the cheapest stable
# gait of the damped walker, at five instants of one step.

cheapest = damped[damped.stable].sort_values("cot").iloc[0]
gaits = stridemap.find_orbits(PATH, k=cheapest.k, c=0.05)
gait = min(gaits, key=lambda orbit: abs(orbit.period - cheapest.period))
motion = stridemap.motion(gait)
print(f"k = {cheapest.k:.2f}: cost of transport {gait.cot:.3f}, compass {compass.cot:.3f}")

figure, ax = plt.subplots(figsize=(7.2, 2.6), layout="constrained")
for i, n in enumerate(np.linspace(0, len(motion.t) - 1, 5).astype(int)):
    shift = np.array([0.7 * i, 0.0])
    for name, colour in (("legs", palette.STANCE), ("torso", palette.BODY)):
        ax.plot(
            *(motion.lines[name][n] + shift).T,
            color=colour,
            linewidth=2,
            solid_capstyle="round",
        )
    ax.scatter(
        *(motion.positions[n] + shift).T, 160 * motion.masses, color=palette.BODY, zorder=3
    )
    ax.text(shift[0] + motion.com[n, 0], -0.16, f"t = {motion.t[n]:.2f}", ha="center")
ax.axhline(0, color="0.7", zorder=0)
ax.set_aspect("equal")
ax.set_ylim(-0.25, 1.7)
ax.set_axis_off()
