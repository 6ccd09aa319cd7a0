"""The oscillator-driven hip controller of the paper."""

import sympy as sp

from stridemap.derive.declaration import TIME, Coordinate, Parameter

OSCILLATOR = (
    Parameter(
        "omega",
        3.0,
        "sqrt(g/L)",
        "oscillator frequency; its phase omega t is reset at touchdown",
        0.0,
        lower_open=True,
    ),
)
GAINS = (
    Parameter("Kp", 10.0, "M g L", "proportional gain of the hip", 0.0),
    Parameter("Kd", 0.6, "M g L sqrt(L/g)", "derivative gain of the hip", 0.0),
    Parameter("S", 0.18, "rad", "stride angle: offset of the desired hip angle"),
    Parameter("gamma", 0.18, "rad", "amplitude of the desired hip angle"),
)


def desired_angle() -> sp.Expr:
    """Desired hip angle ``gamma (1 + cos phi) - S`` with ``phi = omega t`` (paper, eq. (4))."""
    omega, gamma, stride = sp.symbols("omega gamma S", real=True)
    return gamma * (1 + sp.cos(omega * TIME)) - stride


def hip_torque(hip: Coordinate) -> sp.Expr:
    """Torque that drives `hip` to the desired angle and its rate (paper, eq. (3))."""
    kp, kd = sp.symbols("Kp Kd", real=True)
    target = desired_angle()
    return -kp * (hip.symbol - target) - kd * (hip.rate - sp.diff(target, TIME))
