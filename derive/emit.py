"""Everything that `derive` writes for one walker, as file contents."""

import hashlib
from dataclasses import asdict
from typing import Any

import sympy as sp

from stridemap.derive.functions import Functions
from stridemap.derive.printers import c as print_c
from stridemap.derive.printers import docs as print_example
from stridemap.derive.printers import python as print_python
from stridemap.derive.program import Program
from stridemap.derive.validate.mechanics import check_rates
from stridemap.derive.walker import Walker
from stridemap.errors import InputError


def emit(walker: Walker, generator: str) -> tuple[dict[str, str], dict[str, Any]]:
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
    manifest : dict
        What the files hold: functions, argument order, shapes, units, parameters, hash of the model.
    """
    try:
        return _printed(walker, generator)
    except (TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"model {walker.name}: {error}") from error


def _printed(walker: Walker, generator: str) -> tuple[dict[str, str], dict[str, Any]]:
    functions = Functions(walker)
    check_rates(functions.mechanics)
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
    return files, _manifest(walker, programs, generator, model_hash)


def _manifest(walker: Walker, programs: list[Program], generator: str, model_hash: str) -> dict[str, Any]:
    return {
        "format": 2,
        "generator": generator,
        "sympy": sp.__version__,
        "model": walker.name,
        "title": walker.title,
        "reference": walker.reference,
        "model_hash": model_hash,
        "coordinates": [{"name": c.name, "unit": c.unit, "meaning": c.meaning} for c in walker.coordinates],
        "parameters": [asdict(parameter) for parameter in walker.parameters],
        "section": {
            "names": list(walker.section_names),
            "search_box": {name: list(walker.search_box[name]) for name in walker.section_names},
            "period_range": list(walker.period_range),
        },
        "units": asdict(walker.units),
        "masses": [body.name for body in walker.bodies],
        "lines": [{"name": line.name, "spring": line.spring} for line in walker.drawing],
        "actuated": [c.name for c in walker.torques],
        "stance_angle": walker.stance_angle.name if walker.stance_angle else None,
        "wobbling": walker.wobbling.name if walker.wobbling else None,
        "phase": walker.phase.name if walker.phase else None,
        "functions": {p.name: _function(p) for p in programs},
    }


def _function(program: Program) -> dict[str, Any]:
    return {
        "summary": program.summary,
        "source": program.source,
        "operations": program.operations,
        "inputs": [
            {
                "name": a.name,
                "size": len(a.entries),
                "scalar": a.scalar,
                "entries": [{"name": e.symbol.name, "unit": e.unit, "meaning": e.meaning} for e in a.entries],
            }
            for a in program.arguments
        ],
        "outputs": [{"name": o.name, "shape": list(o.shape), "meaning": o.meaning} for o in program.outputs],
    }
