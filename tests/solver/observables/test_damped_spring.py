"""The damper beside the wobbling mass's spring: costs that others found, and where the energy goes."""

import numpy as np
import pytest

import stridemap

# Cost of transport at alpha = .205, omega = 3 of a walker declared by hand with a damper, to three digits.
# The damper is 0, 1, 2.5 and 5 % of what is critical at k = 6.28.
COSTS = {5.25: (0.281, 0.301, 0.321, 0.342), 6.28: (0.299, 0.303, 0.308, 0.316)}


@pytest.mark.parametrize("k", COSTS)
def test_costs_of_a_damped_spring(k):
    critical = stridemap.critical_damping("wobbling", k=6.28, alpha=0.205)
    for share, cost in zip((0, 0.01, 0.025, 0.05), COSTS[k], strict=True):
        orbits = stridemap.find_orbits(
            "wobbling", k=k, alpha=0.205, omega=3, c=share * critical, options={"starts": 64}
        )
        (stable,) = [orbit for orbit in orbits if orbit.stable]
        assert round(stable.cot, 3) == pytest.approx(cost, abs=1e-9)


def test_motors_supply_what_damper_and_impact_take():
    params = {"k": 6, "alpha": 0.25, "omega": 3, "c": 0.053}
    (orbit,) = [o for o in stridemap.find_orbits("wobbling", params) if o.stable]
    motion = orbit.motion(2001)
    energy = [
        orbit.model.evaluate(name, q=motion.q, v=motion.v, p=orbit.model.point(params))[part]
        for name, part in (("kinetic_energy", "kinetic"), ("potential_energy", "potential"))
    ]
    first, *_, last = sum(energy)
    supplied = np.trapezoid(motion.torque[:, 0] * motion.v[:, 1], motion.t)
    taken = params["c"] * np.trapezoid(motion.v[:, 2] ** 2, motion.t)
    assert taken > 1e-4
    assert last - first == pytest.approx(supplied - taken, abs=1e-8)
