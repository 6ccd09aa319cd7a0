"""Everything that `derive` writes for one walker, as file contents."""

import hashlib
from typing import Any

import sympy as sp

from stridemap.derive import print_c, print_example, print_python
from stridemap.derive.declaration import Walker
from stridemap.derive.functions import Functions
from stridemap.derive.program import Program


def emit(walker: Walker, generator: str) -> tuple[dict[str, str], dict[str, Any]]:
    """Derive a walker's equations and print them.

    Parameters
    ----------
    walker : Walker
    generator : str
        Name and version for the banner.

    Returns
    -------
    files : dict of str to str
        Contents by file name.
    manifest : dict
        What the files hold: functions, argument order, shapes, units, parameters, hash of the model.
    """
    programs = list(Functions(walker).programs())
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
        "format": 1,
        "generator": generator,
        "sympy": sp.__version__,
        "model": walker.name,
        "title": walker.title,
        "reference": walker.reference,
        "model_hash": model_hash,
        "coordinates": [{"name": c.name, "unit": c.unit, "meaning": c.meaning} for c in walker.coordinates],
        "parameters": [
            {
                "name": a.name,
                "default": a.default,
                "unit": a.unit,
                "meaning": a.meaning,
                "lower": a.lower,
                "upper": a.upper,
                "lower_open": a.lower_open,
                "upper_open": a.upper_open,
            }
            for a in walker.parameters
        ],
        "section": {
            "names": list(walker.section),
            "search_box": {k: list(v) for k, v in walker.search_box.items()},
        },
        "masses": [mass.name for mass in walker.masses],
        "lines": [{"name": line.name, "spring": line.spring} for line in walker.drawing],
        "actuated": walker.actuated.name,
        "stance_angle": walker.stance_angle.name,
        "wobbling": walker.wobbling.name if walker.wobbling else None,
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
