"""Everything that `derive` writes for one walker, as file contents."""

import hashlib
from dataclasses import asdict
from typing import Any

import sympy as sp

from stridemap import spec
from stridemap.derive.functions import Functions
from stridemap.derive.parts import STANCE_FOOT, Body, Line
from stridemap.derive.printers import c as print_c
from stridemap.derive.printers import docs as print_example
from stridemap.derive.printers import python as print_python
from stridemap.derive.program import Program
from stridemap.derive.validate.section import validate_section_rates
from stridemap.derive.walker import Walker
from stridemap.errors import InputError
from stridemap.spec import Coordinate, Function, Input, Mass, ModelSpec, Output, Parameter, UnitNames


def emit(walker: Walker, generator: str) -> tuple[dict[str, str], ModelSpec]:
    """Derive a walker's equations and print them.

    Parameters
    ----------
    walker : Walker
    generator : str
        Name and version for the banner.

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
        return _printed(walker, generator)
    except (TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"model {walker.name}: {error}") from error


def _printed(walker: Walker, generator: str) -> tuple[dict[str, str], ModelSpec]:
    functions = Functions(walker)
    validate_section_rates(functions.mechanics)
    programs = list(functions.programs())
    python = print_python.module(walker.title, programs, generator)
    model_hash = hashlib.sha256(print_python.body(programs).encode()).hexdigest()
    first_lines = print_c.banner(f"{walker.title}: readable equations", generator, model_hash)
    files = {
        f"{walker.name}.py": python,
        f"{walker.name}.h": print_c.header(walker.name, programs, first_lines),
        f"{walker.name}.c": print_c.source(walker.name, programs, first_lines),
        "example.c": print_example.example(walker, programs, first_lines),
        "README.md": print_example.readme(walker, programs, generator),
    }
    return files, specification(walker, programs, generator, model_hash)


def specification(walker: Walker, programs: list[Program], generator: str, model_hash: str) -> ModelSpec:
    """What the generated files hold, without the files' own hashes."""
    rate = walker.units.rate
    return ModelSpec(
        name=walker.name,
        title=walker.title,
        reference=walker.reference,
        hash=model_hash,
        generator=generator,
        sympy=sp.__version__,
        coordinates=tuple(Coordinate(c.name, c.unit, c.meaning, rate(c.unit)) for c in walker.coordinates),
        parameters=tuple(Parameter(**asdict(parameter)) for parameter in walker.parameters),
        section=walker.section_names,
        search_box={name: _pair(walker.search_box[name]) for name in walker.section_names},
        period_range=_pair(walker.period_range),
        units=UnitNames(**asdict(walker.units)),
        masses=tuple(_mass(walker, body) for body in walker.bodies),
        lines=tuple(_line(line) for line in walker.drawing),
        actuated=tuple(c.name for c in walker.torques),
        stance_angle=walker.stance_angle.name if walker.stance_angle else None,
        wobbling=walker.wobbling.name if walker.wobbling else None,
        phase=walker.phase.name if walker.phase else None,
        functions={p.name: _function(p) for p in programs},
    )


def _pair(values: Any) -> tuple[float, float]:
    low, high = values
    return low, high


def _mass(walker: Walker, body: Body) -> Mass:
    """A body with its role, which its position tells."""
    if body.position == STANCE_FOOT:
        return Mass(body.name, "stance_foot")
    if body.position == walker.swing_foot:
        return Mass(body.name, "swing_foot")
    wobbles = walker.wobbling is not None and walker.wobbling.symbol in body.position.free_symbols
    return Mass(body.name, "wobbling" if wobbles else "body")


def _line(line: Line) -> spec.Line:
    return spec.Line(line.name, "spring" if line.spring else "legs" if line.legs else "part")


def _function(program: Program) -> Function:
    used = program.used
    inputs = (
        Input(a.name, tuple(e.symbol.name for e in a.entries if e.symbol in used)) for a in program.arguments
    )
    outputs = (Output(o.name, o.shape, o.meaning) for o in program.outputs)
    return Function(program.summary, program.source, program.operations, tuple(inputs), tuple(outputs))
