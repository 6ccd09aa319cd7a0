"""A generated function of a model as a CasADi function that takes the arguments of every other one, too."""

from typing import Any

import casadi as ca
import numpy as np

from stridemap.errors import InputError
from stridemap.spec import Function, ModelSpec


class ModelFunction(ca.Function):
    """A `casadi.Function` of ``t, q, v, u, p``: time, coordinates, rates, torques of the motors, parameters.

    It is called with numbers or symbols, by keyword or in this order. What it does not read may be left out,
    and is ignored; ``reads`` names the rest. Called by keyword it returns a dict of its results by name, and
    called by position the result itself, or a tuple of several.

    Parameters
    ----------
    function : casadi.Function
        With all arguments of the signature as inputs.
    spec : ModelSpec
    entry : stridemap.spec.Function

    Attributes
    ----------
    reads : tuple of str
        The arguments that it reads.
    """

    def __init__(self, function: ca.Function, spec: ModelSpec, entry: Function) -> None:
        super().__init__(function)
        self._spec = spec
        self.reads = entry.arguments
        self.signature = entry.signature

    def __call__(self, *values: Any, **named: Any) -> Any:
        """Evaluate it.

        Raises
        ------
        InputError
            When an argument that it reads is missing or has another size, or an argument is none of its own.
        """
        given = self._bound(values, named)
        inputs = {name: given[name] for name in self.reads}
        results = super().__call__(**inputs)
        if not values:
            return results
        found = tuple(results[name] for name in self.name_out())
        return found[0] if len(found) == 1 else found

    def _bound(self, values: tuple[Any, ...], named: dict[str, Any]) -> dict[str, Any]:
        if len(values) > len(self.signature):
            raise InputError(f"{self.name()} was given {len(values)} arguments; {self._takes}")
        given = dict(zip(self.signature, values, strict=False))
        if twice := given.keys() & named.keys():
            raise InputError(f"{self.name()} was given {min(twice)} twice; {self._takes}")
        given |= named
        check_arguments(self._spec, self.name(), self.signature, self.reads, given)
        for name in self.reads:
            self._check_size(name, given[name])
        return given

    def _check_size(self, name: str, value: Any) -> None:
        """Refuse what CasADi would stretch or cut."""
        shape = [*_shape(value), 1, 1][:2]
        size = self._spec.size(name)
        # Several columns are several points.
        if shape[0] != size and (shape[0] != 1 or shape[1] % size):
            raise wrong_size(self._spec, self.name(), name, shape[0] if shape[1] == 1 else shape)

    @property
    def _takes(self) -> str:
        return f"it takes {', '.join(self.signature)} and reads {', '.join(self.reads) or 'none of them'}"


def check_arguments(
    spec: ModelSpec, function: str, known: tuple[str, ...], reads: tuple[str, ...], given: dict[str, Any]
) -> None:
    """Refuse arguments that no function has, and the lack of those that this one reads.

    Raises
    ------
    InputError
    """
    takes = f"it takes {', '.join(known)} and reads {', '.join(reads) or 'none of them'}"
    if unknown := [name for name in given if name not in known]:
        raise InputError(f"{function} of {spec.name} has no argument {unknown[0]!r}; {takes}")
    missing = [name for name in reads if given.get(name) is None]
    if missing:
        names = ", ".join(f"{name}[{spec.size(name)}]" if name != "t" else "t" for name in missing)
        raise InputError(f"{function} of {spec.name} lacks {names}; {takes}")


def wrong_size(spec: ModelSpec, function: str, name: str, found: Any) -> InputError:
    """The sentence about an argument of another size than the model's."""
    entries = [entry.name for entry in spec.entries(name)]
    count = "1 entry" if len(entries) == 1 else f"{len(entries)} entries"
    shown = "x".join(map(str, found)) if isinstance(found, list | tuple) else found
    return InputError(
        f"{function} of {spec.name} was given {name} with {shown}; {name} has {count} ({', '.join(entries)})"
    )


def _shape(value: Any) -> tuple[int, ...]:
    """Rows and columns of numbers or symbols; a plain sequence is a column."""
    if hasattr(value, "shape"):
        return tuple(value.shape)
    if isinstance(value, list | tuple):
        inner = [_shape(one) for one in value]
        return (len(value), *(inner[0] if inner and all(one == inner[0] != (1, 1) for one in inner) else ()))
    return tuple(np.shape(value))
