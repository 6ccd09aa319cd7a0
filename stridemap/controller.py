"""C for a controller: a model's equations, a function that takes a step, and a limit cycle, in one folder."""

import re
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stridemap.codegen import check_folder, contents_of, put_all
from stridemap.derive.printers.c_cycle import Cycle, cycle_header
from stridemap.derive.validate.model_name import HEADERS
from stridemap.derive.validate.reserved import FILES, in_code
from stridemap.errors import InputError, short
from stridemap.solver.api.arguments import whole
from stridemap.solver.cycles.orbit import Orbit
from stridemap.solver.model.model import Model

Array = NDArray[np.float64]

SAMPLES = 65
"""Rows of the reference motion of each step, unless it is said."""
MOST_SAMPLES = 10_001
"""Rows that a header may have: some megabytes."""


def write_c(
    orbit: Orbit, folder: str | Path, *, samples: int | None = None, header: str | None = None
) -> list[Path]:
    """Write a limit cycle as a C header, beside the generated code of its model.

    Parameters
    ----------
    orbit : Orbit
    folder : path
        Made if it does not exist.
    samples : int, optional
        Rows of the reference motion of each walking step, both ends included; by default 65.
    header : str, optional
        Name of the header without its ending, with which all that is in it begins; by default
        ``<model>_cycle``. Headers of several cycles may be included together.

    Returns
    -------
    list of pathlib.Path
        The files; the cycle's header is the last.

    Raises
    ------
    InputError
        When there is no limit cycle, the name of the header cannot be one, or the folder cannot be written or
        holds another model's code.
    """
    Orbit.required(orbit)._require_found()
    rows = SAMPLES if samples is None else samples
    whole("samples", rows, 2, MOST_SAMPLES)
    model, target = orbit.model, Path(folder)
    name = _header_name(model, header)
    text = cycle_header(model.spec, _cycle(orbit, rows), name)
    check_folder(target, model.name)
    return put_all(target, {**contents_of(model), f"{name}.h": text.encode()})


def _header_name(model: Model, header: Any) -> str:
    """The name of a cycle's header, which is also the beginning of names in C."""
    if header is None:
        return f"{model.name}_cycle"
    if not isinstance(header, str) or not re.fullmatch(r"[A-Za-z]\w{0,59}", header, re.ASCII):
        raise InputError(
            f"the header {short(header)!r} cannot be a name in C; use at most 60 letters, digits and "
            "underscores, begin with a letter, and leave the ending .h out"
        )
    taken = in_code(header) or ("the name of a header of C" if header.lower() in HEADERS else None)
    own = {file.partition(".")[0].lower() for file in model.spec.files} | {one.lower() for one in FILES}
    if taken is None and header.lower() in own:
        taken = "the name of a generated file"
    if header.lower() in {f"{model.name}_{array}".lower() for array in "npquz"}:
        taken = "the beginning of names that the model's code has"
    if taken is not None:
        raise InputError(f"the header {header} has {taken}; choose another name, such as {header}_cycle")
    return header


def _cycle(orbit: Orbit, samples: int) -> Cycle:
    """What the header says of a limit cycle."""
    model = orbit.model
    motion = orbit.motion(2 * samples - 1)  # every second row is there to see how well the others do
    q, v, u, t = (_by_step(orbit, getattr(motion, name)) for name in ("q", "v", "torque", "t"))
    params = model.point(orbit.params)
    dv = model.evaluate("state_derivative", t=t, q=q, v=v, p=params)["dv"]
    steps = orbit.steps or ({**orbit.state, "period": orbit.period},)
    return Cycle(
        summary=orbit.summary[0].upper() + orbit.summary[1:],
        measured=_measured(orbit),
        params=params.tolist(),
        z=[[step[name] for name in model.section] for step in steps],
        periods=[step["period"] for step in steps],
        multipliers=orbit.multipliers,
        q=q[:, ::2].tolist(),
        v=v[:, ::2].tolist(),
        dv=dv[:, ::2].tolist(),
        u=u[:, ::2].tolist(),
        between=(_between(q, v, t), _between(v, dv, t)),
    )


def _by_step(orbit: Orbit, column: Array) -> Array:
    return column if orbit.steps else column[None]


def _between(value: Array, rate: Array, t: Array) -> float:
    """How far cubic interpolation of every second row is from the others, at most.

    They are half-way, where its error is largest; a tenth is added for what is of higher order.
    """
    h = (t[:, 2::2] - t[:, :-2:2])[..., None]
    middle = (value[:, 2::2] + value[:, :-2:2]) / 2 + h * (rate[:, :-2:2] - rate[:, 2::2]) / 8
    return 1.1 * float(np.abs(middle - value[:, 1::2]).max())


def _measured(orbit: Orbit) -> list[tuple[str, str]]:
    """A few measured quantities, each with its value and unit."""
    units, shown = orbit.model.spec.units, []
    of = {"step_length": units.length, "speed": units.rate(units.length), "cot": "1", "spectral_radius": "1"}
    for name, unit in {**of, "integration_error": "1"}.items():
        value = orbit.measures.get(name)
        if isinstance(value, float):
            shown.append((orbit.model.measured[name].label, f"{value:.9g} [{unit}]"))
    return shown
