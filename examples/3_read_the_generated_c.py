"""
3. Read the generated C
=======================

Code that came out of a program can be read. Here the mass matrix of the walker is looked up
in the generated C, laid beside a derivation by hand, and compared with it in numbers.
"""

import matplotlib.pyplot as plt
import mpmath
import numpy as np

import stridemap
from stridemap.views import palette

model = stridemap.load("wobbling")

# %%
# What the coordinates are
# ------------------------
# ``theta1`` is the stance leg's angle from the vertical, positive leaning back; ``theta2``
# the angle from the stance leg to the swing leg; ``x`` how far the wobbling mass is ahead of
# the hip. The drawing is made by the model itself: the generated function ``drawing`` gives
# the masses and the lines.

q, p = np.array([0.25, 0.6, 0.3]), model.point({})
drawing = model.evaluate("drawing", q=q, p=p)

figure, ax = plt.subplots(figsize=(4.8, 4.4), layout="constrained")
ax.plot(*drawing["legs"].T, color=palette.STANCE, linewidth=2)
ax.plot(*drawing["spring"].T, color=palette.SPRING, linewidth=2, linestyle=(0, (1, 1)))
colours = [palette.MASS if m.role == "wobbling" else palette.STANCE for m in model.spec.masses]
ax.scatter(*drawing["positions"].T, 1200 * drawing["masses"], color=colours, zorder=3)
hip, wobbling_mass = drawing["spring"]
swing_foot = drawing["legs"][-1]
ax.plot([0, 0], [0, 1.1], color="0.6", linestyle=":")
for centre, start, end, name in [
    (np.zeros(2), hip, [0, 1], "1"),
    (hip, swing_foot - hip, -hip, "2"),
]:
    angles = np.linspace(np.arctan2(*start[::-1]), np.arctan2(*end[::-1]), 30)
    ax.plot(
        *(centre + 0.35 * np.column_stack([np.cos(angles), np.sin(angles)])).T,
        color="0.3",
        linewidth=1,
    )
    middle = angles.mean()
    ax.annotate(
        rf"$\theta_{name}$",
        centre + 0.44 * np.array([np.cos(middle), np.sin(middle)]),
        ha="center",
        va="center",
    )
for label, point, offset in [
    ("$x$", (hip + wobbling_mass) / 2, (0, 8)),
    (r"hip $1-\alpha$", hip, (0, 25)),
    (r"$\alpha$", wobbling_mass, (16, 0)),
    (r"stance foot $\beta$", np.zeros(2), (0, -18)),
    (r"swing foot $\beta$", swing_foot, (0, -18)),
]:
    ax.annotate(
        label, point, xytext=offset, textcoords="offset points", ha="center", va="center"
    )
ax.axhline(0, color="0.8", zorder=0)
ax.set_aspect("equal")
ax.margins(0.25)
ax.set_axis_off()

# %%
# The C
# -----
# Every function takes named vectors, unpacks them at the top, and has one line per term. A
# comment names the equation that it is.

source = model.text("wobbling.c")
start = source.index("/* Mass matrix")
print(source[start : source.index("\n}\n", start) + 2])

# %%
# By hand
# -------
# Put the stance foot at the origin, and write :math:`w_1, w_2, w_x` for the rates of
# :math:`\theta_1`, :math:`\theta_2`, :math:`x`. The hip is at :math:`(-\sin\theta_1,
# \cos\theta_1)`, so its speed is :math:`w_1`; the wobbling mass has :math:`w_x` more in the
# horizontal; the swing foot is the hip and a leg that turns at :math:`w_1 - w_2`. Twice the
# kinetic energy is
#
# .. math::
#
#    2 T = (1-\alpha)\, w_1^2
#        + \alpha\,(w_1^2 - 2 \cos\theta_1\, w_1 w_x + w_x^2)
#        + \beta\,\bigl(w_1^2 + (w_1 - w_2)^2 - 2 \cos\theta_2\, w_1 (w_1 - w_2)\bigr)
#
# and the mass matrix collects its coefficients:
#
# .. math::
#
#    M_{11} &= 1 + 2 \beta (1 - \cos\theta_2) \\
#    M_{12} &= \beta (\cos\theta_2 - 1) \\
#    M_{13} &= -\alpha \cos\theta_1 \\
#    M_{22} &= \beta \\
#    M_{23} &= 0 \\
#    M_{33} &= \alpha
#
# That is the C above, entry by entry. It is the inertia matrix of eq. (1) in Kamimura and
# Sano's paper, which leaves the entries to the reader.
#
# In numbers
# ----------
# A check that does not trust the derivation either: positions of the four masses, written
# down by hand, their velocities from a complex step, and twice the kinetic energy at a
# thousand random states.


def positions(q):
    """Hip, wobbling mass, stance foot, swing foot; shape (4, 2)."""
    theta1, theta2, x = q
    hip = np.array([-np.sin(theta1), np.cos(theta1)])
    swing_foot = hip + np.array([np.sin(theta1 - theta2), -np.cos(theta1 - theta2)])
    return np.array([hip, hip + np.array([x, 0]), [0, 0], swing_foot])


rng = np.random.default_rng(1)
worst = 0.0
for _ in range(1000):
    q, v = rng.uniform(-1, 1, 3), rng.uniform(-3, 3, 3)
    p = model.point({"alpha": rng.uniform(0.05, 0.95), "beta": rng.uniform(0.05, 1)})
    alpha, beta = p[1], p[3]
    masses = np.array([1 - alpha, alpha, beta, beta])
    velocities = positions(q + 1e-30j * v).imag / 1e-30
    by_hand = np.sum(masses[:, None] * velocities**2)
    generated = v @ model.evaluate("mass_matrix", q=q, p=p)["M"] @ v
    worst = max(worst, abs(generated - by_hand) / by_hand)

print(f"largest relative difference at 1,000 states: {worst:.1e}")
assert worst < 1e-13

# %%
# The same equations, three more times
# ------------------------------------
# The C, a Python module and CasADi functions come from one list of terms. The CasADi function
# has named inputs and outputs, and can be differentiated or put into an optimisation. It takes
# time, coordinates, rates, torques and parameters, as all of them do, and uses what it needs:

mass_matrix = model.mass_matrix
print(mass_matrix)
print(mass_matrix(q=[0.1, 0.2, 0.0], p=model.point({}))["M"])

# %%
# The Python module takes the namespace that it computes in, so the same lines run in NumPy,
# in CasADi and at fifty digits:

with mpmath.workdps(50):
    q = [mpmath.mpf("0.1"), mpmath.mpf("0.2"), mpmath.mpf(0)]
    p = [mpmath.mpf(value) for value in model.preset.values()]
    print(model.equations.mass_matrix(mpmath, q, p)["M"][0][2])
