"""The oscillator-driven hip controller of the paper."""

import sympy as sp

from stridemap.derive.parts import Clock, Coordinate, Parameter

OMEGA = Parameter(
    "omega", 3.0, "sqrt(g/L)", "oscillator frequency; its phase omega t is reset at touchdown", 0.0,
    lower_open=True,
)  # fmt: skip
GAINS = (
    Parameter("Kp", 10.0, "M g L", "proportional gain of the hip", 0.0),
    Parameter("Kd", 0.6, "M g L sqrt(L/g)", "derivative gain of the hip", 0.0),
    Parameter("S", 0.18, "rad", "stride angle: offset of the desired hip angle"),
    Parameter("gamma", 0.18, "rad", "amplitude of the desired hip angle"),
)
CLOCK = Clock(OMEGA.symbol)


def hip_torque(hip: Coordinate, clock: Clock) -> sp.Expr:
    """Torque that drives `hip` to the desired angle and its rate (paper, eqs. (3) and (4)).

    The desired angle is ``gamma (1 + cos phi) - S`` with the clock's phase ``phi``.
    """
    kp, kd, stride, gamma = (gain.symbol for gain in GAINS)
    angle = gamma * (1 + sp.cos(clock.phase)) - stride
    rate = -gamma * clock.rate * sp.sin(clock.phase)
    return -kp * (hip.symbol - angle) - kd * (hip.rate - rate)
