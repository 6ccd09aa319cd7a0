"""Everything that `derive` writes for one walker, as file contents."""

import hashlib
from collections.abc import Callable, Mapping
from dataclasses import asdict
from typing import Any

import sympy as sp

from stridemap import spec
from stridemap.derive.declaration import Declaration
from stridemap.derive.functions import Functions
from stridemap.derive.motors import record
from stridemap.derive.parts import STANCE_FOOT, Body, Line, Measured
from stridemap.derive.printers.c import C
from stridemap.derive.printers.c_step import step_header, step_source
from stridemap.derive.printers.docs import example, readme
from stridemap.derive.printers.javascript import JavaScript
from stridemap.derive.printers.printer import Equations
from stridemap.derive.printers.python import Python
from stridemap.derive.program import Program
from stridemap.derive.validate.section import validate_section_rates
from stridemap.derive.walker import Walker
from stridemap.errors import InputError
from stridemap.spec import Coordinate, Function, Input, Mass, ModelSpec, Output, Parameter, Quantity

PRINTERS: Mapping[str, Callable[[Equations], str]] = {
    "{model}.py": Python().text,
    "{model}.h": C().header,
    "{model}.c": C().text,
    "{model}_step.h": step_header,
    "{model}_step.c": step_source,
    "{model}.js": JavaScript().text,
    "example.c": example,
    "README.md": readme,
}
"""What prints each generated file, by the file's name."""


Progress = Callable[[int, int, str], None]
"""What is called as the derivation moves on: steps done, steps in all, and what was done last."""


def emit(
    walker: Walker, generator: str, progress: Progress | None = None
) -> tuple[dict[str, str], ModelSpec]:
    """Derive a walker's equations and print them.

    Parameters
    ----------
    walker : Walker
    generator : str
        Name and version for the banner.
    progress : callable, optional

    Raises
    ------
    InputError
        When the equations hold something that generated code has no form for.

    Returns
    -------
    files : dict of str to str
        Contents by file name.
    specification : ModelSpec
        What the files hold: functions, argument order, shapes, units, parameters, hash of the model.
    """
    try:
        return _printed(walker, generator, progress)
    except (TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"model {walker.name}: {error}") from error


def _printed(walker: Walker, generator: str, progress: Progress | None) -> tuple[dict[str, str], ModelSpec]:
    written = equations(walker, generator, progress)
    files = {pattern.format(model=walker.name): text(written) for pattern, text in PRINTERS.items()}
    return files, specification(written)


def equations(walker: Walker, generator: str, progress: Progress | None = None) -> Equations:
    """Derive a walker's equations, without printing them.

    Parameters
    ----------
    walker : Walker
    generator : str
        Name and version for banners.
    progress : callable, optional

    Returns
    -------
    Equations
        What every printer is given.

    Raises
    ------
    InputError
        When the section fixes a rate that the impact does not leave.
    TypeError, ValueError
        When the equations hold something that generated code has no form for.
    """
    functions = Functions(walker)
    validate_section_rates(functions.mechanics)
    programs = []
    for program in functions.programs():
        programs.append(program)
        if progress is not None:
            progress(len(programs), functions.count, program.name)
    body = Python().body(programs)
    digest = hashlib.sha256(body.encode()).hexdigest()
    return Equations(walker, tuple(programs), generator, digest, body)


def specification(written: Equations) -> ModelSpec:
    """What the generated files hold, without the files' own hashes."""
    walker = written.walker
    rate = walker.units.rate
    return ModelSpec(
        name=walker.name,
        title=walker.title,
        reference=walker.reference,
        hash=written.hash,
        generator=written.generator,
        sympy=sp.__version__,
        coordinates=tuple(Coordinate(c.name, c.unit, c.meaning, rate(c.unit)) for c in walker.coordinates),
        parameters=tuple(Parameter(**asdict(parameter)) for parameter in walker.parameters),
        section=walker.section_names,
        search_box={name: _pair(walker.search_box[name]) for name in walker.section_names},
        period_range=_pair(walker.period_range),
        units=walker.units,
        masses=tuple(_mass(walker, body) for body in walker.bodies),
        lines=tuple(_line(line) for line in walker.drawing),
        motors=tuple(record(walker, motor) for motor in walker.actuators),
        stance_angle=walker.stance_angle.name if walker.stance_angle else None,
        wobbling=walker.wobbling.name if walker.wobbling else None,
        phase=walker.phase.name if walker.phase else None,
        functions={p.name: _function(p) for p in written.programs},
        quantities=tuple(_quantity(one) for one in walker.quantities),
    )


def _pair(values: Any) -> tuple[float, float]:
    low, high = values
    return low, high


def _mass(walker: Declaration, body: Body) -> Mass:
    """A body with its role, which its position tells."""
    if body.position == STANCE_FOOT:
        return Mass(body.name, "stance_foot")
    if body.position == walker.swing_foot:
        return Mass(body.name, "swing_foot")
    wobbles = walker.wobbling is not None and walker.wobbling.symbol in body.position.free_symbols
    return Mass(body.name, "wobbling" if wobbles else "body")


def _quantity(one: Measured) -> Quantity:
    return Quantity(one.name, one.kind, one.label, one.definition, reduction=one.reduction)


def _line(line: Line) -> spec.Line:
    return spec.Line(line.name, "spring" if line.spring else "legs" if line.legs else "part")


def _function(program: Program) -> Function:
    used = program.used
    inputs = (
        Input(a.name, tuple(e.symbol.name for e in a.entries if e.symbol in used)) for a in program.arguments
    )
    outputs = (Output(o.name, o.shape, o.meaning) for o in program.outputs)
    return Function(program.summary, program.source, program.operations, tuple(inputs), tuple(outputs))
