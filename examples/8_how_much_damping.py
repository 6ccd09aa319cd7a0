"""
8. How much damping does the benefit survive?
=============================================

The paper's spring has no friction, and a real one does. How much of what a wobbling mass
gains (lower cost, a smaller ``d_max``) is left when the mass is damped? The paper does not
ask; the walker's parameter ``c``, a damper beside the spring, does.
"""

import tempfile
from concurrent.futures import ThreadPoolExecutor

import matplotlib.pyplot as plt
import numpy as np

import stridemap
from stridemap.sweeps.config import parse_config
from stridemap.views import palette

# %%
# A damper as a share of critical damping
# ---------------------------------------
# ``c`` is in M sqrt(g/L). What one knows of a spring is its damping as a share of the critical
# one, at which the mass would come to rest without swinging through.

typical = {"A": 0.5, "B": 6.0, "C": 22.5}
for group, k in typical.items():
    critical = stridemap.critical_damping("wobbling", k=k, alpha=0.25)
    print(f"group {group}: k = {k:4}, critical damping c = {critical:.4f}")

robot = stridemap.Units(leg_length=0.8, mass=40.0)
print(f"1 M sqrt(g/L) is {robot.to_si(1, 'M sqrt(g/L)'):.1f} N s/m for a robot of 40 kg")

# %%
# The paper's gaits, damped
# -------------------------
# Each typical gait is followed as its damper grows. The dashed lines are the compass walker,
# which has no wobbling mass: above them nothing is gained any more.

(compass,) = stridemap.find_orbits("compass", omega=3)
measures = {
    "cot": "cost of transport",
    "d_max": r"$d_\mathrm{max}$ in L",
    "spectral_radius": "largest modulus\nof a multiplier",
}

figure, axes = plt.subplots(3, sharex=True, figsize=(6.4, 6.6), layout="constrained")
for group, k in typical.items():
    point = {"k": k, "alpha": 0.25, "omega": 3.0}
    critical = stridemap.critical_damping("wobbling", point)
    found = stridemap.branches("wobbling", vary="c", range=(0, 0.1 * critical), params=point)
    gaits = found.to_frame().query("gait and stable").sort_values("c")
    gaits = gaits[gaits.group == group]
    for ax, name in zip(axes, measures, strict=True):
        ax.plot(
            100 * gaits.c / critical, gaits[name], color=palette.GROUPS[group],
            label=f"group {group}, k = {k:g}",
        )  # fmt: skip
for ax, (name, title) in zip(axes, measures.items(), strict=True):
    ax.axhline(
        getattr(compass, name),
        color=palette.COMPASS,
        linestyle="--",
        linewidth=1,
        label="compass",
    )
    ax.set_ylabel(title)
axes[2].set_xlabel("damping in % of critical")
figure.legend(
    *axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=2, frameon=False
)

# %%
# Where exactly the gain is gone: `stridemap.find` solves for the damper at which a gait costs
# as much as the compass does. Group A never cost less.

for group in "BC":
    point = {"k": typical[group], "alpha": 0.25, "omega": 3.0}
    critical = stridemap.critical_damping("wobbling", point)
    for name in ("cot", "d_max"):
        wanted = f"{name} = {getattr(compass, name)!r}"
        found = stridemap.find(
            "wobbling", wanted, vary="c", range=(0, 0.1 * critical), params=point
        )
        (orbit,) = [orbit for orbit in found.orbits if orbit.stable]
        share = 100 * orbit.params["c"] / critical
        print(f"group {group}: {name} is the compass's at {share:.2f} % of critical damping")

# %%
# Another spring for each damper
# ------------------------------
# Damping also *makes gaits stable*: softer springs, whose gaits cost less still but fall
# without a damper, become usable. So the question is which spring is best once the damper is
# known. A sweep over ``k`` and ``c`` answers it.

config = parse_config(
    {
        "model": "wobbling",
        "params": {"alpha": 0.25, "omega": 3.0},
        "grid": {
            "k": {"start": 0.5, "stop": 40.0, "num": 80},
            "c": [0.0, 0.01, 0.02, 0.03, 0.04, 0.06, 0.08, 0.1],
        },
        "search": {"starts": 16, "subgrid": {"k": 4}},
        "special_points": False,  # nothing below is about them
    }
)
with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(1) as executor:
    stridemap.sweep(config, folder, executor=executor)
    orbits = stridemap.read_orbits(folder)

orbits["share"] = 100 * orbits.c / (2 * np.sqrt(orbits.k * orbits.alpha * (1 - orbits.alpha)))
stable = orbits[orbits.stable & orbits.group.isin(list(typical))]
best = stable.loc[stable.groupby(["group", "c"]).cot.idxmin()]
cheaper = best[best.cot < compass.cot].groupby("group").share.max()
print(
    best[["group", "c", "k", "share", "cot", "d_max", "spectral_radius"]].to_string(index=False)
)

# %%
# The stable gaits of four dampers, and the best of each damper:

figure, (left, right) = plt.subplots(
    1, 2, figsize=(8.4, 3.8), layout="constrained", sharey=True
)
for shade, c in zip((0.0, 0.35, 0.6, 0.8), (0.0, 0.02, 0.04, 0.1), strict=True):
    rows = stable[stable.c == c]
    left.scatter(rows.k, rows.cot, 8, color=plt.get_cmap("viridis")(shade), label=f"c = {c:g}")
for group, rows in best.groupby("group"):
    right.plot(rows.share, rows.cot, "o-", color=palette.GROUPS[group], label=f"group {group}")
for ax in (left, right):
    ax.axhline(compass.cot, color=palette.COMPASS, linestyle="--", linewidth=1)
    ax.legend(frameon=False, fontsize="small")
left.set_xlabel("spring $k$ in M g / L")
left.set_ylabel("cost of transport")
left.set_ylim(0.25, 0.36)
right.set_xlim(0, 5)
right.set_xlabel("damping in % of critical, at the best spring")

# %%
# What follows
# ------------
# At ``alpha`` 0.25 and ``omega`` 3, with the paper's springs, **1.5 % of critical damping takes
# the whole gain** in cost, in group B as in group C, and 2 % that in ``d_max``. With a spring
# that is chosen for the damper the gain in cost lasts until 2.6 % in group B and 1.9 % in group
# C. Group A has nothing to lose: it costs more than the compass with and without a damper.
# Stability is the other way round: every group gets more stable with a damper.
#
# So the gain is one of a nearly frictionless mass. ``stridemap sweep sweeps/damped.toml --out
# results/damped`` sweeps the map with dampers, and the report of it has a slider for ``c``.
