"""The parts of the page that are plain text: what it is, the verdicts, and where the numbers come from."""

import html
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import pandas as pd

from stridemap.errors import InputError
from stridemap.solver.model.files import contents
from stridemap.solver.model.model import Model
from stridemap.views.notation import symbol, units
from stridemap.views.report.payload import axes

VERDICTS = {"holds": "✓", "in part": "◐", "differs": "✗"}
"""What a verdict may be, each with a mark that distinguishes it from the others without colour."""

OF_THE_PAPER = ("wobbling", "compass")
"""The models that the paper's statements are about, and from which their preset was identified."""

_NO_CLAIMS = (
    "<p>No verdicts were given to this report. <code>stridemap claims --json</code> prints them; "
    "<code>stridemap report --claims FILE</code> puts them here.</p>"
)


def text(value: Any) -> str:
    """Return anything as text that HTML shows as it is."""
    # Half a surrogate pair, which JSON can hold, cannot be written.
    return html.escape(str(value).encode("utf-8", "replace").decode("utf-8"))


def lead(model: Model, provenance: Mapping[str, Any], orbits: pd.DataFrame, cells: pd.DataFrame) -> str:
    """Say what the page shows."""
    varied = [
        f"<i>{text(symbol(axis.name))}</i> ({text(axis.meaning.split(';')[0])})"
        for axis in axes(model, provenance["configuration"])
    ]
    named = [f"{kind} {text(units(model.spec.units)[kind])}" for kind in ("mass", "length", "time")]
    return (
        f"<p>All limit cycles found in a sweep over {_listed(varied)}: <b>{len(orbits):,}</b> cycles, "
        f"<b>{int(orbits['stable'].sum()):,}</b> of them stable, in <b>{len(cells):,}</b> grid cells. "
        "Choose a cell of the map to see its cycles walk.</p>"
        f'<p class="note">Units: {_listed(named)}. {text(model.spec.reference)}.</p>'
    )


def read_claims(path: str | Path) -> list[dict[str, Any]]:
    """Return the verdicts in a file that ``stridemap claims --json`` printed.

    Raises
    ------
    InputError
        When it cannot be read or holds something else.
    """
    wanted = "give what `stridemap claims --json` printed"
    try:
        found = json.loads(contents(path).decode("utf-8"))
    except OSError as error:
        raise InputError(f"cannot read {path} ({error.strerror}); {wanted}") from None
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path} is not JSON ({error}); {wanted}") from None
    claims = found.get("claims") if isinstance(found, dict) else None
    if not isinstance(claims, list):
        raise InputError(f'{path} does not hold a list "claims"; {wanted}')
    for i, claim in enumerate(claims, 1):
        if not isinstance(claim, dict) or not isinstance(claim.get("id"), str):
            raise InputError(f"claim {i} in {path} does not have an id; {wanted}")
        if claim.get("verdict") not in list(VERDICTS):
            raise InputError(
                f"the verdict of {claim['id']} in {path} is {claim.get('verdict')!r}, not one of "
                f"{', '.join(VERDICTS)}; {wanted}"
            )
    return claims


def claims(model: Model, verdicts: Sequence[Mapping[str, Any]] | None) -> str:
    """Return the table of verdicts, or a sentence that says how to get them; nothing for another walker."""
    if not verdicts:
        return _section(_NO_CLAIMS) if model.name in OF_THE_PAPER else ""
    counts = [
        f"{sum(claim['verdict'] == verdict for claim in verdicts)} {verdict}"
        for verdict in VERDICTS
        if any(claim["verdict"] == verdict for claim in verdicts)
    ]
    rows = "".join(
        f'<tr><th scope="row">{text(claim["id"])}</th><td>{text(claim.get("statement", ""))}</td>'
        f'<td class="verdict" data-verdict="{text(claim["verdict"])}">'
        f'<span aria-hidden="true">{VERDICTS[claim["verdict"]]}</span> {text(claim["verdict"])}</td>'
        f"<td>{_numbers(claim)}</td></tr>"
        for claim in verdicts
    )
    return _section(
        f"<p>{len(verdicts)} statements: {', '.join(counts)}.</p>"
        '<div class="wide" tabindex="0" role="region" aria-label="Verdicts"><table class="claims"><thead><tr>'
        '<th scope="col">id</th><th scope="col">statement</th><th scope="col">verdict</th>'
        f'<th scope="col">deciding numbers</th></tr></thead><tbody>{rows}</tbody></table></div>'
    )


def _section(body: str) -> str:
    return f'<section id="claims" class="card"><h2>Statements of the paper</h2>{body}</section>'


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


def _numbers(claim: Mapping[str, Any]) -> str:
    """The deciding numbers in a few words, if there are any, and all of them to be unfolded."""
    evidence = _evidence(claim.get("evidence"))
    if not claim.get("numbers"):
        return evidence
    return f"{text(claim['numbers'])}<details><summary>all numbers</summary>{evidence}</details>"


def _evidence(value: Any) -> str:
    """Evidence of any shape: numbers and words as they are, tables and lists within each other."""
    if isinstance(value, Mapping):
        items = "".join(f"<dt>{text(key)}</dt><dd>{_evidence(inner)}</dd>" for key, inner in value.items())
        return f'<dl class="evidence">{items}</dl>'
    if isinstance(value, list):
        if any(isinstance(inner, Mapping | list) for inner in value):
            return "<ul>" + "".join(f"<li>{_evidence(inner)}</li>" for inner in value) + "</ul>"
        return ", ".join(_evidence(inner) for inner in value)
    if isinstance(value, bool) or value is None:
        return {True: "yes", False: "no", None: "none"}[value]
    return text(f"{value:.6g}" if isinstance(value, float) else value)
