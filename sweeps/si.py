"""Sweep configurations in SI units: what a file gives for a robot of a size, in the model's units."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from stridemap.columns import Column, columns_of
from stridemap.errors import InputError
from stridemap.solver.model.model import Model
from stridemap.spec import Parameter
from stridemap.units import Units, check_scaled


@dataclass(frozen=True)
class Given:
    """How the numbers of a file become those of the model; without a size they are the model's already.

    Parameters
    ----------
    units : Units or None
    columns : mapping of str to Column
        What is known of each number by name.
    """

    units: Units | None
    columns: Mapping[str, Column]

    @classmethod
    def of(cls, model: Model, sizes: Mapping[str, Any], source: str) -> "Given":
        """By the table ``[units]`` of a file, which may be empty.

        Raises
        ------
        InputError
            When an entry is unknown, missing or out of range, or no size converts the model's units.
        """
        if not sizes:
            return cls(None, {})
        try:
            check_scaled(model.spec)
        except InputError as error:
            raise InputError(f"{source}: [units] cannot be used: {error}") from None
        return cls(Units.from_mapping(sizes, f"{source}: [units]"), columns_of(model.spec))

    def factor(self, name: str) -> float:
        """What 1 of the model's unit of a number is in the unit of the file."""
        if self.units is None:
            return 1.0
        scale = self.columns[name].scale
        return self.units.unit(scale) if scale not in ("", "1", "rad") else 1.0

    def parameter(self, parameter: Parameter) -> Parameter:
        """A parameter whose range is in the units of the file, so that refusals speak of these."""
        factor = self.factor(parameter.name)
        if factor == 1.0:
            return parameter
        lower, upper = (None if end is None else end * factor for end in (parameter.lower, parameter.upper))
        return replace(parameter, unit=self.columns[parameter.name].si, lower=lower, upper=upper)

    def own(self, value: float, parameter: Parameter) -> float:
        """A value of a parameter in the model's units."""
        factor = self.factor(parameter.name)
        if factor == 1.0:
            return value
        scaled = value / factor
        # An end of the range is an end of the range, whatever its last bit becomes.
        low = -math.inf if parameter.lower is None else parameter.lower
        high = math.inf if parameter.upper is None else parameter.upper
        return parameter.check(min(max(scaled, low), high))

    def search(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """The table ``[search]`` in the model's units; what is not a number stays, to be refused."""
        out = dict(given)
        for name in ("period_min", "period_max"):
            if name in out:
                out[name] = self._scaled(out[name], "period")
        boxes = out.get("search_box")
        if isinstance(boxes, Mapping):
            out["search_box"] = {
                name: [self._scaled(end, name) for end in box]
                if isinstance(box, list | tuple) and name in self.columns
                else box
                for name, box in boxes.items()
            }
        return out

    def _scaled(self, value: Any, name: str) -> Any:
        number = isinstance(value, int | float) and not isinstance(value, bool)
        factor = self.factor(name)
        return value / factor if number and factor != 1.0 else value
