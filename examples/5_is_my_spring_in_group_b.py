"""
5. Is my robot's spring in group B?
===================================

A worked case in SI units. A robot has legs of 0.8 m and an upper body of 40 kg, of which a
quarter, 10 kg, slides on a horizontal spring of 3,500 N/m. Which gaits does it have? How far
may the spring be off before the gait is lost?
"""

import matplotlib.pyplot as plt
import numpy as np

import stridemap
from stridemap.views import palette

# %%
# The robot's units
# -----------------
# The models know no metre. Their unit of mass is the upper body ``M``, hip and wobbling mass
# together **without the feet**; of length the leg ``L``; of time ``sqrt(L/g)``.
# :class:`stridemap.Units` converts both ways.

robot = stridemap.Units(leg_length=0.8, mass=40.0)

print(f"k = 1      is  {robot.to_si(1, 'stiffness'):8.2f} N/m")
print(f"3,500 N/m  is  k = {robot.from_si(3500.0, 'stiffness'):.4f}")
print(f"k = 7.138  is  {robot.to_si(7.138, 'stiffness'):8.2f} N/m")
print(f"1 unit of time is  {robot.to_si(1, 'time'):.4f} s")

# %%
# A scale shows more than 40 kg: the feet weigh ``beta`` = 0.15 M each, so the robot weighs 52
# kg. Where only the weight on the scale is known, say so, and M comes out:

on_a_scale = stridemap.Units.from_total_mass(leg_length=0.8, total_mass=52.0, beta=0.15)
print(f"M = {on_a_scale.mass:.6f} kg")

# %%
# All gaits with this spring
# --------------------------
# The other numbers of the robot, in SI units too. The controller's gains are the model's
# preset (identified, not published) for a robot of this size.

others = {"omega": 3.0, "beta": 0.15, "Kp": 10.0, "Kd": 0.6}
si = robot.parameters_si("wobbling", others) | {"k": 3500.0, "alpha": 0.25}
names = {"k": "N/m", "omega": "rad/s", "beta": "kg a foot", "Kp": "N m/rad", "Kd": "N m s/rad"}
for name, unit in names.items():
    print(f"{name:6} {si[name]:9.3f} {unit}")

orbits = stridemap.find_orbits("wobbling", **robot.parameters("wobbling", **si))

for orbit in orbits:
    m = robot.measures(orbit)
    print(
        f"\ngroup {orbit.group}, {'stable' if orbit.stable else 'unstable'} "
        f"(largest multiplier {orbit.spectral_radius:.4f})\n"
        f"  step {m['step_length']:.4f} m in {m['period']:.4f} s: {m['speed']:.4f} m/s\n"
        f"  the paper's distance d up to {m['d_max']:.4f} m\n"
        f"  work of the hip {m['work']:.3f} J a step, cost of transport {m['cot']:.4f}\n"
        f"  vertical ground force at least {m['min_vertical_force']:.1f} N\n"
        f"  friction needed {m['friction']:.3f}"
    )

# %%
# One gait, stable, in group B: the wobbling mass moves against the legs. (The cost of
# transport here is the hip's work over weight and distance, a pure number.)
#
# The interval of springs
# -----------------------
# Where does the stable gait of group B begin and end? Look at springs from 2,000 to 7,000
# N/m, and bisect both edges to a hundredth of a N/m. An edge is where the answer to "is there
# a stable cycle in group B" changes.

options = stridemap.SearchOptions(starts=128)


def gait_in_b(spring):
    """The stable limit cycle in group B with the largest margin, or None; the spring in N/m."""
    point = robot.parameters("wobbling", **(si | {"k": float(spring)}))
    found = stridemap.find_orbits("wobbling", options=options, **point)
    stable = [orbit for orbit in found if orbit.stable and orbit.group == "B"]
    return min(stable, key=lambda orbit: orbit.spectral_radius, default=None)


def edge(inside, outside):
    """Bisect between a spring with and one without a stable gait in group B."""
    while abs(inside - outside) > 0.01:
        middle = (inside + outside) / 2
        inside, outside = (middle, outside) if gait_in_b(middle) else (inside, middle)
    return inside


springs = np.arange(2000.0, 7001.0, 125.0)
inside = [spring for spring in springs if gait_in_b(spring)]
assert np.ptp(inside) == 125.0 * (len(inside) - 1)  # one interval, no holes at this spacing

softest = edge(inside[0], inside[0] - 125.0)
stiffest = edge(inside[-1], inside[-1] + 125.0)

for name, spring in (("softest", softest), ("stiffest", stiffest)):
    print(f"{name:8} {spring:9.2f} N/m  (k = {robot.from_si(spring, 'stiffness'):.5f})")
print(
    f"margin of 3,500 N/m: -{(3500 - softest) / 35:.1f} % and +{(stiffest - 3500) / 35:.1f} %"
)

# %%
# So a spring of 3,500 N/m may be softer by a sixth or stiffer by half before the gait is
# lost. The two edges are not alike. At the soft one the branch ends in a fold, and softer
# springs have no such gait at all. At the stiff one the gait goes on, but a multiplier leaves
# the unit circle through -1, and the robot begins to limp:

for spring in (softest, stiffest):
    print(f"{spring:9.2f} N/m:", np.round(gait_in_b(spring).multipliers, 3))

# %%
# The margin is not only the distance to the edges. The largest multiplier says how fast the
# robot recovers, and the paper's distance d how hard the ground's force turns it about its
# centre of mass (on a point foot the force acts at the foot, so d is not a measure of tipping):

figure, axes = plt.subplots(3, sharex=True, figsize=(6.4, 6.2), layout="constrained")
# Closer together towards the fold, where everything changes as the square root of the
# distance to it.
x = softest + (stiffest - softest) * np.linspace(0, 1, 33) ** 2
gaits = [gait_in_b(spring) for spring in x]
axes[0].plot(
    x, [gait.spectral_radius for gait in gaits], "o-", color=palette.GROUPS["B"], markersize=3
)
axes[0].axhline(1, color="0.8", linewidth=0.8, zorder=0)
axes[0].set_ylabel("largest modulus\nof a multiplier")
axes[1].plot(
    x,
    [1000 * robot.measures(gait)["d_max"] for gait in gaits],
    "o-",
    color=palette.GROUPS["B"],
    markersize=3,
)
axes[1].set_ylabel(r"$d_\mathrm{max}$ in mm")
axes[2].plot(
    x,
    [robot.measures(gait)["work"] for gait in gaits],
    "o-",
    color=palette.GROUPS["B"],
    markersize=3,
)
axes[2].set_ylabel("work of the hip\nin J a step")
axes[2].set_xlabel("spring in N/m")
for ax in axes:
    ax.axvspan(softest, stiffest, color=palette.STABLE, alpha=0.08)
    ax.axvline(3500, color=palette.DARK, linestyle="--", label="3,500 N/m")
axes[0].legend(frameon=False)

# %%
# Near the soft edge the robot needs least work and keeps `d` smallest, but
# it stands with its back to a cliff: a spring only a little softer has no gait. The best of
# both is somewhat above the fold, where the largest multiplier is smallest:

radius = [gait.spectral_radius for gait in gaits]
print(f"most stable near {x[np.argmin(radius)]:.0f} N/m: largest multiplier {min(radius):.4f}")
recovery = np.log(0.1) / np.log(orbits[0].spectral_radius)
print(f"with 3,500 N/m a disturbance shrinks to a tenth in {recovery:.0f} steps")
