"""``stridemap models``: which walkers there are, and their parameters."""

import json
import shutil
import textwrap
from typing import TYPE_CHECKING, Annotated, Any

import typer

from stridemap.cli.options import FOUND, JsonOption

if TYPE_CHECKING:
    from stridemap.spec import ModelSpec


def models(
    name: Annotated[
        str | None,
        typer.Argument(
            metavar="[MODEL]", help="Show this one alone: a name, a model file or a derived folder."
        ),
    ] = None,
    json_: JsonOption = False,
) -> int:
    """List the models that come with stridemap: what each is, and its parameters with units and presets."""
    from stridemap.solver.model.loading import available, load

    specs = [load(one).spec for one in ([name] if name is not None else available())]
    if json_:
        print(json.dumps({"models": [_plain(spec) for spec in specs]}, indent=1, allow_nan=False))
        return FOUND
    print("\n\n".join(_text(spec) for spec in specs))
    return FOUND


def _plain(spec: "ModelSpec") -> dict[str, Any]:
    """A model as plain values."""
    return {
        "name": spec.name,
        "title": spec.title,
        "reference": spec.reference,
        "units": {"mass": spec.units.mass, "length": spec.units.length, "time": spec.units.time},
        "parameters": [
            {
                "name": a.name,
                "meaning": a.meaning,
                "unit": a.unit,
                "preset": a.default,
                "allowed": a.allowed,
                "counts": a.counts,
            }
            for a in spec.parameters
        ],
        "coordinates": [
            {"name": c.name, "meaning": c.meaning, "unit": c.unit, "rate_unit": c.rate_unit}
            for c in spec.coordinates
        ],
        "section": list(spec.section),
    }


def _text(spec: "ModelSpec") -> str:
    """A model as it is printed: its title, and a row per parameter."""
    from stridemap.cli.output import aligned

    head = ["parameter", "preset", "unit", "allowed", "meaning"]
    rows = [[a.name, f"{a.default:.6g}", a.unit, a.allowed, a.meaning] for a in spec.parameters]
    about = f"{spec.name}: {spec.title}"
    width = max(60, min(shutil.get_terminal_size().columns, 110))
    source = textwrap.fill(spec.reference, width, initial_indent="  ", subsequent_indent="  ")
    lines = [
        about,
        *([source] if spec.reference else []),
        *(f"  {line}" for line in aligned([head, *rows], 3)),
    ]
    return "\n".join(lines)
