"""
1. Find a limit cycle
=====================

One call finds **all** limit cycles of a walker at a point of parameter space. Here: what
comes back, what the numbers mean, and two ways to check them without trusting the search.
"""

import matplotlib.pyplot as plt
import numpy as np

import stridemap

# %%
# A point of parameter space
# --------------------------
# The walker is a compass with a mass on a horizontal spring at its hip. The spring ``k`` is
# in units of ``M g / L``, the oscillator's frequency ``omega`` in ``sqrt(g/L)``, and
# ``alpha`` is the wobbling mass as a share of the upper body. What is not given (``beta``,
# ``Kp``, ``Kd``, ``S``, ``gamma``) comes from the preset.

orbits = stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3)

for orbit in orbits:
    kind = "stable" if orbit.stable else "unstable"
    print(f"group {orbit.group}, {kind}: period {orbit.period:.6f}")
    print(f"    largest modulus of a multiplier {orbit.spectral_radius:.6f}")

# %%
# There are two cycles at this one point. A solver that stops at the first one tells half of
# the story.
#
# Each is a record. Its state is the walker's just after touchdown, where a step begins; its
# multipliers are the eigenvalues of the exact derivative of the step map. One of them is
# always zero, because the impact forgets how fast the swing foot came down.

stable = next(orbit for orbit in orbits if orbit.stable)
print(*(f"{name} = {value:.6f}" for name, value in stable.state.items()))
print("multipliers", np.round(stable.multipliers, 4))
print(f"closed to {stable.residual:.0e}; integration error {stable.integration_error:.0e}")

# %%
# The motion
# ----------
# :func:`stridemap.motion` samples one step. The dotted vertical line is the instant when the
# leg is upright.

motion = stridemap.motion(stable)
upright = np.interp(0, -motion.coordinate("theta1"), motion.t)

figure, axes = plt.subplots(3, sharex=True, figsize=(6.4, 6.4), layout="constrained")
axes[0].plot(motion.t, motion.coordinate("theta1"), label=r"stance leg $\theta_1$")
axes[0].plot(motion.t, motion.coordinate("theta2"), "--", label=r"between the legs $\theta_2$")
axes[0].set_ylabel("rad")
axes[1].plot(motion.t, motion.coordinate("x"), label="wobbling mass $x$")
axes[1].plot(motion.t, motion.d, "--", label="the paper's distance $d$")
axes[1].set_ylabel("L")
axes[2].plot(motion.t, motion.force[:, 1], label="vertical ground force")
axes[2].plot(motion.t, motion.force[:, 0], "--", label="horizontal ground force")
axes[2].set_ylabel("M g")
axes[2].set_xlabel(r"time since touchdown in $\sqrt{L/g}$")
for ax in axes:
    ax.axvline(upright, color="0.6", linestyle=":")
    ax.axhline(0, color="0.8", linewidth=0.8, zorder=0)
    ax.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=2, frameon=False, borderaxespad=0)

# %%
# In group B the wobbling mass is ahead of the hip in the first half of the step and behind it
# in the second: it brakes and pushes against what the legs do.
#
# Walk it
# -------
# :func:`stridemap.simulate` walks with SciPy's event-driven integrator. It shares no
# integration code with the search. Started on the cycle, it stays there; started beside it,
# it comes back, and how fast it comes back is what the multipliers promise. At first the
# complex pair shows: the distance swings. What is left after some thirty steps shrinks by the
# largest modulus, 0.969, a step.

walk = stridemap.simulate(
    "wobbling",
    {**stable.state, "dtheta1": stable.state["dtheta1"] - 0.001},
    steps=90,
    **stable.params,
)
cycle = np.array(list(stable.state.values()))
distance = [np.linalg.norm(np.array(list(step.state.values())) - cycle) for step in walk.steps]

figure, ax = plt.subplots(figsize=(6.4, 3.2), layout="constrained")
steps = np.arange(1, len(distance) + 1)
ax.semilogy(steps, distance, "o", markersize=3, label="walked")
ax.semilogy(
    steps,
    distance[-1] * stable.spectral_radius ** (steps - steps[-1]),
    label="largest multiplier to the n-th",
)
ax.set_xlabel("step n")
ax.set_ylabel("distance from the cycle")
ax.legend(frameon=False)

rate = (distance[-1] / distance[-31]) ** (1 / 30)  # of the last 30 steps
print(f"walked: {rate:.4f} a step; largest multiplier: {stable.spectral_radius:.4f}")

# %%
# The unstable cycle is just as real: it is the edge between starts from which the walker
# settles on the stable cycle and starts from which it does not. A simulation alone would
# never have shown it.
