"""One limit cycle as a value."""

import html
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NoReturn

import numpy as np

from stridemap.columns import Column, columns_of
from stridemap.errors import InputError, short
from stridemap.services import service
from stridemap.solver.cycles.status import Status
from stridemap.solver.model.model import Model
from stridemap.solver.observables.motion import Motion, motions
from stridemap.spec import Quantity


class FrozenDict(dict[str, Any]):
    """A dict that refuses to be changed; otherwise as any, for JSON, pickles and `dataclasses.asdict`."""

    def _refuse(self, *_args: Any, **_values: Any) -> NoReturn:
        """Raise TypeError."""
        raise TypeError("this dict cannot be changed; change a copy, dict(...)")

    __setitem__ = __delitem__ = __ior__ = _refuse
    clear = pop = popitem = setdefault = update = _refuse

    def __reduce__(self) -> tuple[Any, ...]:
        """Made anew in one piece."""
        return FrozenDict, (dict(self),)


@dataclass(frozen=True)
class Orbit:
    """A limit cycle, or the reason why there is none.

    Every measured quantity (`stridemap.quantities`) is an attribute too: ``orbit.cot``, ``orbit.group``.
    The numbers of a failure are NaN; what the model lacks is None. Units are the model's
    (``orbit.model.spec.units``).

    Parameters
    ----------
    model : Model
    params : mapping of str to float
        Every parameter of the model.
    status : Status
    state : mapping of str to float
        The section point, just after touchdown.
    period : float
        Of the whole cycle.
    multipliers : tuple of complex
        Floquet multipliers by falling modulus.
    measures : mapping of str
        The measured quantities by name, over the whole cycle.
    steps : tuple of mapping of str to float
        Of a cycle of several steps: section point and period of each. Empty for a cycle of one step.
    """

    model: Model
    params: Mapping[str, float]
    status: Status
    state: Mapping[str, float] = field(default_factory=dict)
    period: float = math.nan
    multipliers: tuple[complex, ...] = ()
    measures: Mapping[str, Any] = field(default_factory=dict)
    steps: tuple[Mapping[str, float], ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "params", FrozenDict(self.params))
        object.__setattr__(self, "state", FrozenDict(self.state))
        object.__setattr__(self, "steps", tuple(FrozenDict(step) for step in self.steps))
        everything = {name: self.measures.get(name, missing(q)) for name, q in self.model.measured.items()}
        object.__setattr__(self, "measures", FrozenDict(everything))

    def __getattr__(self, name: str) -> Any:
        measures = self.__dict__.get("measures", {})
        if name not in measures:
            raise AttributeError(f"an Orbit has no attribute {name!r}; measured are {', '.join(measures)}")
        return measures[name]

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.measures})

    def __repr__(self) -> str:
        return f"<{self.model.name}: {self.summary}>"

    @property
    def summary(self) -> str:
        """The cycle in a few words."""
        if not self.status.found:
            return f"no limit cycle, {self.status.value} ({self.reason})"
        kind = f"group {self.group}, " if self.group else ""
        kind += f"{self.period_n} steps, " if self.steps else ""
        return (
            f"limit cycle, {kind}period {self.period:.6g}, {self.stability} "
            f"(largest multiplier {self.spectral_radius:.4g})"
        )

    @property
    def period_n(self) -> int:
        """Number of walking steps after which it closes."""
        return len(self.steps) or 1

    @property
    def stability(self) -> str:
        """Whether it is stable, in a word or two."""
        return {True: "stable", False: "unstable", None: "stable or not: not known"}[self.stable]

    @property
    def reason(self) -> str:
        """Why it is not a limit cycle, in a few words; empty for one."""
        return self.status.reason

    def _repr_html_(self) -> str:
        """Tables for notebooks, with units and meanings, and a picture where matplotlib is installed."""
        columns = columns_of(self.model.spec)
        known = {**self.params, **self.state, **self.to_dict()}
        known |= {f"multiplier {i}": f"{one:.6g}" for i, one in enumerate(self.multipliers)}
        rows = {
            name: html_row(name, value, columns.get(name))
            for name, value in known.items()
            if not isinstance(value, dict | list)
        }
        first = "".join(rows[name] for name in (*self.params, *SHOWN) if name in rows)
        caption = f"<caption>{html.escape(repr(self)[1:-1])}</caption>"
        return (
            f"<table>{caption}{HEAD}{first}</table>{service('picture')(self)}"
            f"<details><summary>all values</summary><table>{HEAD}{''.join(rows.values())}</table></details>"
        )

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON, without model and parameters; what is not a number is None."""
        out: dict[str, Any] = {
            "status": self.status.value,
            "state": {name: _json(value) for name, value in self.state.items()},
            "period": _json(self.period),
            "period_n": self.period_n,
            "multipliers": [[m.real, m.imag] for m in self.multipliers],
        }
        if self.steps:
            out["steps"] = [dict(step) for step in self.steps]
        return out | {name: _json(value) for name, value in self.measures.items()}

    @property
    def section_point(self) -> list[float]:
        """Section point and period of the first step: the unknowns that a cycle of one step solves."""
        period = self.steps[0]["period"] if self.steps else self.period
        return [*(self.state[name] for name in self.model.section), period]

    @classmethod
    def required(cls, given: Any) -> "Orbit":
        """What was given, if it is one limit cycle.

        Raises
        ------
        InputError
            When it is something else.
        """
        if not isinstance(given, cls):
            raise InputError(
                f"orbit = {short(given)} is not one limit cycle; give one of those that `find_orbits` "
                'returns, such as find_orbits("compass")[0]'
            )
        return given

    def _require_found(self) -> None:
        if not self.status.found:
            raise InputError(
                f"this orbit is not a limit cycle (status {self.status}); choose one whose status is "
                "converged or inaccurate"
            )

    def motion(self, samples: int = 201) -> Motion:
        """The cycle as a motion over one step, or, with a leading axis, over each of several steps.

        Parameters
        ----------
        samples : int
            Number of times, both ends included.

        Raises
        ------
        InputError
            When there is no limit cycle, or for fewer than two samples.
        """
        self._require_found()
        point = self.model.point(self.params)[None, :]
        if not self.steps:
            return motions(self.model, [self.section_point], point, samples, squeeze=True)
        names = (*self.model.section, "period")
        steps = [[step[name] for name in names] for step in self.steps]
        return motions(self.model, steps, np.repeat(point, len(steps), axis=0), samples)

    def simulate(self, steps: int = 10) -> Any:
        """Walk from the cycle's section point with the event-driven integrator: see `stridemap.simulate`."""
        self._require_found()
        return service("simulate")(self.model, self.state, steps=steps, params=self.params)

    def plot(self, kind: str = "profiles", **options: Any) -> Any:
        """Draw the cycle with matplotlib: see `stridemap.views.plot`."""
        self._require_found()
        return service("plot")(self, kind, **options)

    def animate(self, path: Any, **options: Any) -> Any:
        """Write the walker's motion as a looping GIF: see `stridemap.animate`."""
        self._require_found()
        return service("animate")(self, path, **options)


SHOWN = ("group", "period", "stable", "spectral_radius", "step_length", "speed", "cot", "min_vertical_force")
"""Quantities of the tables in a notebook that are seen first; all others are there too."""

HEAD = "<tr><th></th><th>value</th><th>unit</th><th>meaning</th></tr>"


def html_row(name: str, value: Any, column: Column | None) -> str:
    """A row of a table in a notebook: name, value, unit and meaning."""
    shown = f"{value:.8g}" if isinstance(value, float) else "" if value is None else str(value)
    unit, label = ("", "") if column is None else (column.unit, column.label)
    cells = "".join(f"<td>{html.escape(text)}</td>" for text in (shown, unit if unit != "1" else "", label))
    return f"<tr><th>{html.escape(name)}</th>{cells}</tr>"


def missing(quantity: Quantity) -> Any:
    """What stands for a quantity that was not measured."""
    if quantity.optional:
        return None
    return {"float": math.nan, "int": 0, "bool": False, "str": ""}[quantity.type]


def plain(value: Any) -> Any:
    """A number of NumPy as Python's; one NaN for all, so that equal cycles compare as equal."""
    value = value.item() if isinstance(value, np.generic) else value
    return math.nan if isinstance(value, float) and math.isnan(value) else value


def _json(value: Any) -> Any:
    return None if isinstance(value, float) and not math.isfinite(value) else value
