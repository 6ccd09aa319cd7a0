"""The parts of the page that are plain text: what it is, the verdicts, and where the numbers come from."""

import html
import json
from collections.abc import Mapping, Sequence
from typing import Any

from stridemap.solver.model.model import Model
from stridemap.views import palette
from stridemap.views.notation import symbol, units
from stridemap.views.report.payload import axes
from stridemap.views.report.shown import Shown, what_is_shown

OF_THE_PAPER = ("wobbling", "compass")
"""The models that the paper's statements are about, and from which their preset was identified."""


def text(value: Any) -> str:
    """Return anything as text that HTML shows as it is."""
    # Half a surrogate pair, which JSON can hold, cannot be written.
    return html.escape(str(value).encode("utf-8", "replace").decode("utf-8"))


def lead(shown: Shown) -> str:
    """Say what the page shows."""
    model, orbits, cells = shown.model, shown.orbits, shown.cells
    varied = [
        f"<i>{text(symbol(axis.name))}</i> ({text(axis.meaning.split(';')[0])})"
        for axis in axes(model, shown.configuration)
    ]
    part = what_is_shown(shown, {name: f"<i>{text(symbol(name))}</i>" for name in shown.grid})
    named = [f"{kind} {text(units(model.spec.units)[kind])}" for kind in ("mass", "length", "time")]
    return (
        f"<p>{'L' if part else 'All l'}imit cycles found in a sweep over {_listed(varied)}: "
        f"<b>{len(orbits):,}</b> cycles, "
        f"<b>{int(orbits['stable'].sum()):,}</b> of them stable, in <b>{len(cells):,}</b> grid cells. "
        "Choose a cell of the map to see its cycles walk.</p>"
        f"{part and f'<p id=part-shown class=warning>{part}</p>'}"
        f'<p class="note">Units: {_listed(named)}. {text(model.spec.reference)}.</p>'
    )


def keys(model: Model) -> str:
    """Return the legend of the walker: what is drawn, in the words and colours of all pictures."""
    legs = any(line.role == "legs" for line in model.spec.lines)
    shown = {
        "force": palette.MEANINGS["force"],
        "zmp": f"{palette.MEANINGS['zmp']}, distance d from the foot",
        "com": palette.MEANINGS["com"],
        **({"swing": palette.MEANINGS["swing"]} if legs else {}),
    }
    if any(mass.role == "wobbling" for mass in model.spec.masses):
        shown["mass"] = f"{palette.MEANINGS['mass']}; its dots are for equal times"
    if any(line.role == "spring" for line in model.spec.lines):
        shown["lens"] = "under the glass: the ends of the spring over a step, seen while walking along"
    marks = " ".join(
        f'<span class="key"><span class="mark {name}"></span>{text(meaning)}</span>'
        for name, meaning in shown.items()
    )
    return f'<p class="keys">{marks}</p>'


def provenance(model: Model, found: Mapping[str, Any]) -> str:
    """Return where the numbers come from, as a list of terms."""
    configuration, fixed = found["configuration"], found["configuration"]["params"]
    terms = {
        "model": f"{text(found['model'])}: {text(model.title)}",
        "model hash": f"<code>{text(found['model_hash'])}</code>",
        "configuration hash": f"<code>{text(found['configuration_hash'])}</code>",
        "grid": "<br>".join(_axis(a.name, configuration["grid"][a.name]) for a in axes(model, configuration)),
        "fixed": text(", ".join(f"{name} = {fixed[name]!r}" for name in model.preset if name in fixed))
        or "nothing",
        "search": text(", ".join(f"{name} = {_plain(v)}" for name, v in configuration["search"].items())),
        "versions": text(", ".join(f"{name} {version}" for name, version in found["versions"].items())),
        "compiler": text(found["compiler"] or "none: CasADi's virtual machine"),
        "commit": f"<code>{text(found['commit'])}</code>" if found["commit"] else "not from a checkout",
    }
    listed = "".join(f"<dt>{text(term)}</dt><dd>{value}</dd>" for term, value in terms.items())
    preset = "Parameters that the sweep did not set have the model's preset values"
    if model.name in OF_THE_PAPER:
        preset += ", which were <b>identified by search, not published</b>"
    return (
        f'<dl class="terms">{listed}</dl>'
        f"<p>{preset}. State, period, multipliers and measures are those of the sweep's tables, rounded to "
        "the digits that are shown here, and states to three decimals more. Motions are integrated in this "
        "page, from the tables' section points, with the model's equations and a Runge-Kutta method of "
        "order 8.</p>"
    )


def _axis(name: str, values: Sequence[float]) -> str:
    count = f"{len(values)} values from {values[0]!r} to {values[-1]!r}"
    return text(f"{name}: {count if len(values) > 6 else ', '.join(map(repr, values))}")


def _listed(words: Sequence[str]) -> str:
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"


def _plain(value: Any) -> str:
    return value if isinstance(value, str) else json.dumps(value)
