"""Numbers of a model in the SI units of a robot, for pictures."""

from stridemap.columns import columns_of
from stridemap.solver.model.model import Model
from stridemap.units import Units, check_scaled


def in_units(model: Model, name: str, units: Units | None) -> tuple[float, str]:
    """What 1 of a number is in SI units, and these as the end of a label; 1 and nothing without a size.

    Parameters
    ----------
    model : Model
    name : str
        Of a parameter, a state, or a measured quantity.
    units : Units or None

    Raises
    ------
    InputError
        When no size converts the model's units.
    """
    if units is None:
        return 1.0, ""
    check_scaled(model.spec)
    column = columns_of(model.spec)[name]
    word = f" [{column.si}]" if column.si not in ("", "1") else ""
    return (units.unit(column.scale) if column.scale not in ("", "1", "rad") else 1.0), word
