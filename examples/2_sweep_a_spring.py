"""
2. Sweep a spring
=================

What happens to a gait as its spring gets stiffer? A sweep finds all limit cycles at every
value of ``k`` and writes them into a table; a few lines of pandas draw the branches.
"""

import tempfile
from concurrent.futures import ThreadPoolExecutor

import matplotlib.pyplot as plt
import numpy as np

import stridemap
from stridemap.sweeps.config import parse_config
from stridemap.views import palette

# %%
# A sweep as a file, or as a dictionary
# -------------------------------------
# A sweep is usually a TOML file for ``stridemap sweep my.toml --out results/my``; the same
# tables as a dictionary do for a small one. The grid may vary any parameter of the model;
# here only ``k`` varies. A sweep runs on any ``concurrent.futures.Executor``: a single thread
# is enough for a hundred cells, and a process pool is what you get when you leave it out.

config = parse_config(
    {
        "model": "wobbling",
        "params": {"alpha": 0.25, "omega": 3.0},
        "grid": {"k": {"start": 0.2, "stop": 40.0, "num": 200}},
        "search": {"starts": 16},
    }
)
with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(1) as executor:
    summary = stridemap.sweep(config, folder, executor=executor)
    orbits = stridemap.read_orbits(folder)

print(f"{summary.orbits} limit cycles, {summary.stable_orbits} of them stable")
print(orbits.groupby("group").agg(cycles=("k", "size"), k_min=("k", "min"), k_max=("k", "max")))

# %%
# The branches
# ------------
# Each row is a limit cycle. The largest modulus of its multipliers decides: below 1 it is
# stable (filled marks). The dashed line is the compass, the same walker without a wobbling
# mass. Groups are lettered by how many whole oscillations the spring makes in a step, and
# between them there is a gap near each resonance: no gait at all on the main branch.

(compass,) = stridemap.find_orbits("compass", omega=3)
marks = dict(zip("ABCD", "osD^", strict=True))
measures = {
    "spectral_radius": "largest modulus\nof a multiplier",
    "d_max": r"$d_\mathrm{max}$ in L",
    "cot": "cost of transport",
}

figure, axes = plt.subplots(3, sharex=True, figsize=(6.4, 6.6), layout="constrained")
for ax, (name, title) in zip(axes, measures.items(), strict=True):
    for group, rows in orbits[orbits.group.isin(list(marks))].groupby("group"):
        colour = palette.GROUPS[group]
        for stable, face in ((True, colour), (False, "none")):
            some = rows[rows.stable == stable]
            ax.scatter(
                some.k, some[name], 11, facecolors=face, edgecolors=colour,
                linewidths=0.7, marker=marks[group], label=f"group {group}" if stable else None,
            )  # fmt: skip
    ax.axhline(
        getattr(compass, name),
        color=palette.COMPASS,
        linestyle="--",
        linewidth=1,
        label="compass",
    )
    ax.set_ylabel(title)
axes[0].axhline(1, color="0.8", linewidth=0.8, zorder=0)
axes[0].set_ylim(0.8, 1.6)
axes[1].set_ylim(0.1, 0.4)
axes[2].set_ylim(0.1, 0.6)
axes[2].set_xlabel("spring $k$ in M g / L")
figure.legend(
    *axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=5, frameon=False
)

# %%
# How the gait is lost
# --------------------
# The table holds all multipliers, not the largest alone. Along the stable part of group B
# they show *how* the gait is lost at either end. At the soft end a real multiplier goes to 1:
# the branch folds back. Stiffer springs send a complex pair around the circle; it meets at
# the negative real axis, and one of the two leaves through -1: a period doubling, behind
# which the walker limps. The multiplier at zero belongs to the impact.

in_b = orbits[(orbits.group == "B") & orbits.stable].sort_values("k")
circle = np.exp(1j * np.linspace(0, 2 * np.pi, 200))
figure, ax = plt.subplots(figsize=(5.4, 4.4), layout="constrained")
ax.plot(circle.real, circle.imag, color="0.7", linewidth=1)
for i in range(5):
    shown = ax.scatter(
        in_b[f"multiplier_{i}_re"], in_b[f"multiplier_{i}_im"], 14, c=in_b.k, cmap="viridis"
    )
figure.colorbar(shown, label="spring $k$ in M g / L")
ax.set_aspect("equal")
ax.set_xticks([-1, -0.5, 0, 0.5, 1])
ax.set_yticks([-1, -0.5, 0, 0.5, 1])
ax.set_xlabel("real part")
ax.set_ylabel("imaginary part")

# %%
# The default sweep, ``make sweep``, does this over spring, mass ratio and frequency: 16,800
# cells in a few minutes.
