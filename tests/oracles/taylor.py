"""A residual and its derivatives in two directions by heyoka: Taylor series in time and in the directions."""

import numpy as np


def directional(heyoka, model, u, p, a, b):
    """The residual at a point, its derivatives in two directions of (u, p), and the second one in both.

    Parameters
    ----------
    heyoka : module
    model : Model
    u : ndarray, shape (nz + 1,)
        Section point and period.
    p : ndarray, shape (n_params,)
    a, b : ndarray, shape (nz + 1 + n_params,)

    Returns
    -------
    tuple of ndarray, shape (nz + 1,) each
    """
    one, other = heyoka.par[0], heyoka.par[1]
    moved = [x + d * one + e * other for x, d, e in zip([*u, *p], a, b, strict=True)]
    z, period, p = moved[: len(u) - 1], moved[len(u) - 1], moved[len(u) :]

    def equation(name, **given):
        reads = model.spec.functions[name].arguments
        return getattr(model.equations, name)(heyoka, *(given[argument] for argument in reads))

    # The distance from the start begins at zero whatever the directions are, and so do all its derivatives.
    n = len(model.coordinates)
    start = equation("section_state", z=z, p=p)
    start = [x + 0 * one for x in (*start["q"], *start["v"])]
    away = list(heyoka.make_vars(*(f"away_{i}" for i in range(2 * n))))
    state = [x + y for x, y in zip(start, away, strict=True)]
    rate = equation("state_derivative", t=period * heyoka.time, q=state[:n], v=state[n:], p=p)
    system = [(x, period * r) for x, r in zip(away, [*rate["dq"], *rate["dv"]], strict=True)]
    variational = heyoka.var_ode_sys(system, [one, other], order=2)
    taylor = heyoka.taylor_adaptive(
        variational, [0.0] * (2 * n), tol=1e-16, pars=[0.0, 0.0], compact_mode=True
    )
    taylor.propagate_until(1.0)
    index = {tuple(taylor.get_mindex(i)): i for i in range(len(taylor.state))}

    def part(i, *powers):
        return float(taylor.state[index[i, *powers]])

    # What has terms of second order in one direction alone does not enter the mixed derivative.
    end = [
        x + part(i, 0, 0) + part(i, 1, 0) * one + part(i, 0, 1) * other + part(i, 1, 1) * one * other
        for i, x in enumerate(start)
    ]
    q, v = end[:n], end[n:]
    after = equation("impact_map", q=q, v=v, p=p)
    names = [*model.coordinates, *(f"d{c}" for c in model.coordinates)]
    landed = dict(zip(names, [*after["q_plus"], *after["v_plus"]], strict=True))
    condition = equation("touchdown_condition", q=q, v=v, p=p)["h"]
    residual = [landed[name] - x for name, x in zip(model.section, z, strict=True)] + [condition]
    tensors = heyoka.diff_tensors(residual, [one, other], diff_order=2)
    wanted = [(0, 0), (1, 0), (0, 1), (1, 1)]
    entries = [tensors[i, *powers] for powers in wanted for i in range(len(u))]
    values = heyoka.cfunc(entries, [], compact_mode=True)(inputs=[], pars=[0.0, 0.0])
    return tuple(np.reshape(values, (len(wanted), len(u))))
