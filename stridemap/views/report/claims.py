"""The verdicts on statements of the paper: what decides each, as numbers and as a small figure."""

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from stridemap.errors import InputError
from stridemap.solver.model.files import contents
from stridemap.solver.model.model import Model
from stridemap.views import palette
from stridemap.views.report.claim_figures import drawn
from stridemap.views.report.sections import OF_THE_PAPER, text
from stridemap.views.report.verdicts import VERDICTS, tally
from stridemap.views.small_figures import figure_from

WANTED = "give what `stridemap claims --json` printed"

_NO_CLAIMS = (
    "<p>No verdicts were given to this report. <code>stridemap claims --json</code> prints them; "
    "<code>stridemap report --claims FILE</code> puts them here.</p>"
)


def read_claims(path: str | Path) -> list[dict[str, Any]]:
    """Return the verdicts in a file that ``stridemap claims --json`` printed.

    Raises
    ------
    InputError
        When it cannot be read or holds something else.
    """
    try:
        found = json.loads(contents(path).decode("utf-8"))
    except OSError as error:
        raise InputError(f"cannot read {path} ({error.strerror}); {WANTED}") from None
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path} is not JSON ({error}); {WANTED}") from None
    claims = found.get("claims") if isinstance(found, dict) else None
    if not isinstance(claims, list):
        raise InputError(f'{path} does not hold a list "claims"; {WANTED}')
    for i, claim in enumerate(claims, 1):
        if not isinstance(claim, dict) or not isinstance(claim.get("id"), str):
            raise InputError(f"claim {i} in {path} does not have an id; {WANTED}")
        if claim.get("verdict") not in list(VERDICTS):
            raise InputError(
                f"the verdict of {claim['id']} in {path} is {claim.get('verdict')!r}, not one of "
                f"{', '.join(VERDICTS)}; {WANTED}"
            )
        try:
            if claim.get("figure") is not None:
                figure_from(claim["figure"])
        except ValueError as error:
            raise InputError(
                f"the figure of {claim['id']} in {path} is not one that can be drawn: {error}; {WANTED}"
            ) from None
    return claims


def claims(model: Model, verdicts: Sequence[Mapping[str, Any]] | None) -> str:
    """Return the verdicts, or a sentence that says how to get them; nothing for another walker."""
    if not verdicts:
        return _section(_NO_CLAIMS) if model.name in OF_THE_PAPER else ""
    chips = "".join(
        f'<a href="#claim-{text(claim["id"])}" data-verdict="{text(claim["verdict"])}" '
        f'title="{text(claim.get("short") or claim.get("statement", ""))}: {text(claim["verdict"])}">'
        f'{text(claim["id"])} <span aria-hidden="true">{VERDICTS[claim["verdict"]]}</span></a>'
        for claim in verdicts
    )
    count = f"{len(verdicts)} statement{'' if len(verdicts) == 1 else 's'}"
    return _section(
        f"<p>{count}: {tally(claim['verdict'] for claim in verdicts)}.</p>"
        f'<nav class="chips" aria-label="Statements">{chips}</nav>{_legend()}'
        f'<ol class="claims">{"".join(map(_claim, verdicts))}</ol>'
    )


def _section(body: str) -> str:
    return f'<section id="claims" class="card"><h2>Statements of the paper</h2>{body}</section>'


def _legend() -> str:
    """What the small figures draw; one legend for all of them."""
    dots = "".join(
        '<span class="key"><svg viewBox="0 0 12 12" aria-hidden="true">'
        f'<path d="M6 6h0" class="dots group-{g}"/></svg>{g}</span>'
        for g in palette.GROUPS
    )
    keys = {
        '<path d="M6 6h0" class="dots unstable"/>': "unstable, on the main branch",
        '<line x1="0" x2="12" y1="6" y2="6" class="guide compass"/>': palette.MEANINGS["compass"],
        '<circle cx="6" cy="6" r="4" class="so"/>': "decides: as stated",
        '<path d="M2 2l8 8m0 -8l-8 8" class="not-so"/>': "decides: not as stated",
    }
    others = "".join(
        f'<span class="key"><svg viewBox="0 0 12 12" aria-hidden="true">{mark}</svg>{text(meaning)}</span>'
        for mark, meaning in keys.items()
    )
    return (
        f'<p class="keys small-keys"><span class="key">stable cycles of group</span>{dots}{others}</p>'
        '<p class="note">Press on a mark to see its cycles on the map. Numbers have as many digits as it '
        "takes to tell them apart; <code>stridemap claims --json</code> prints them in full.</p>"
    )


def _claim(claim: Mapping[str, Any]) -> str:
    verdict, figure = claim["verdict"], claim.get("figure")
    where = f'<p class="where">Section {text(claim["where"])}</p>' if claim.get("where") else ""
    return (
        f'<li class="claim" id="claim-{text(claim["id"])}"><div class="said">'
        f'<h3><span class="id">{text(claim["id"])}</span> {text(claim.get("statement", ""))}</h3>'
        f'<p class="verdict" data-verdict="{text(verdict)}"><span aria-hidden="true">{VERDICTS[verdict]}'
        f"</span> {text(verdict)}</p>{where}{_numbers(claim)}</div>"
        f"{drawn(figure_from(figure)) if figure else ''}</li>"
    )


# -- numbers -------------------------------------------------------------------------------------------------


def _numbers(claim: Mapping[str, Any]) -> str:
    """The deciding numbers in a few words, which parts are not so, and all numbers to be unfolded."""
    said, listed, evidence = str(claim.get("numbers") or ""), claim.get("listed"), claim.get("evidence")
    body = said.partition("; not so: ")[0]
    if listed and isinstance(listed, Mapping):
        what = body.partition(":")[0]
        cells = "".join(
            f"<div><dt>{_symbols(name)}</dt><dd>{text(value).replace('/', '/<wbr>')}</dd></div>"
            for name, value in listed.items()
        )
        body = f'<p class="what">{text(what)}</p><dl class="listed">{cells}</dl>'
    else:
        body = f"<p>{text(body)}</p>" if body else ""
    parts = evidence.get("parts") if isinstance(evidence, Mapping) else None
    body += _not_so(parts) if isinstance(parts, Mapping) else ""
    if evidence is None:
        return body
    return f"{body}<details><summary>all numbers</summary>{_evidence(evidence)}</details>"


def _not_so(parts: Mapping[str, Any]) -> str:
    """The parts of a statement that are not so."""
    failing = [
        name for name, part in parts.items() if isinstance(part, Mapping) and part.get("holds") is False
    ]
    if not failing:
        return ""
    named = ", ".join(_symbols(name) for name in failing[:6])
    more = f" and {len(failing) - 6} more" if len(failing) > 6 else ""
    return f'<p class="not-so">Not so in {len(failing)} of {len(parts)} parts: {named}{more}</p>'


def _symbols(name: str) -> str:
    """The name of a pair of alpha and omega, or of a part, as text with symbols."""
    return re.sub(r"\b(alpha|omega) ?(?==|\d)", lambda m: {"alpha": "α ", "omega": "ω "}[m[1]], text(name))


def _evidence(value: Any, digits: int = 4) -> str:
    """Evidence of any shape: numbers and words as they are, tables and lists within each other."""
    if isinstance(value, Mapping):
        if not any(isinstance(inner, Mapping) for inner in value.values()):
            digits = enough_digits(value)
        items = "".join(
            f"<dt>{text(key)}</dt><dd>{_evidence(inner, digits)}</dd>" for key, inner in value.items()
        )
        return f'<dl class="evidence">{items}</dl>'
    if isinstance(value, list):
        if any(isinstance(inner, Mapping | list) for inner in value):
            return "<ul>" + "".join(f"<li>{_evidence(inner, digits)}</li>" for inner in value) + "</ul>"
        return ", ".join(_evidence(inner, digits) for inner in value)
    if isinstance(value, bool) or value is None:
        return {True: "yes", False: "no", None: "none"}[value]
    return text(_shown(value, digits) if isinstance(value, float) else value)


def _shown(value: float, digits: int) -> str:
    """A number in so many digits; without an exponent where there are a few more before the point."""
    return f"{value:.0f}" if 10**digits <= abs(value) < 1e7 else f"{value:.{digits}g}"


def enough_digits(value: Any) -> int:
    """Significant digits, from 3 to 9, by which different numbers that stand together look different."""
    found = set(_floats(value))
    return next((n for n in range(3, 9) if len({f"{number:.{n}g}" for number in found}) == len(found)), 9)


def _floats(value: Any) -> Iterator[float]:
    if isinstance(value, float):
        yield value
    elif isinstance(value, Mapping | list):
        for inner in value.values() if isinstance(value, Mapping) else value:
            yield from _floats(inner)
