"""SI units for a robot of a given size: metres, kilograms and seconds to the units of the models, and back.

The models do not use metres: their unit of mass is the mass M of the upper body, their unit of length the
leg L, and their unit of time sqrt(L/g). A `Units` holds M, L and g of one robot, and every conversion is a
product or a quotient with a unit that is formed from these three.

>>> robot = Units(leg_length=0.8, mass=40.0, gravity=9.81)
>>> robot.from_si(2943.0, "stiffness")  # 2,943 N/m in units of M g / L
6.0
>>> round(robot.to_si(0.1, "M g L"), 6)  # N m: any unit formed from M, L and g
31.392
"""

import difflib
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from stridemap import quantities
from stridemap.columns import SCALED, unit_value
from stridemap.errors import InputError
from stridemap.quantities import KINDS as KINDS
from stridemap.services import service

if TYPE_CHECKING:
    from stridemap.solver.cycles.orbit import Orbit
    from stridemap.spec import ModelSpec

STANDARD_GRAVITY = 9.80665
"""In m/s^2, exactly, by definition: 3rd General Conference on Weights and Measures, 1901."""

MEASURE_KINDS: Mapping[str, str] = {
    name: quantity.kind for name, quantity in quantities.QUANTITIES.items() if quantity.type == "float"
}
"""The kind of each measured quantity of an `Orbit` that is a number with a unit or a ratio."""

# Wide enough for a walking insect and a crane; a leg in millimetres or a mass in grams is outside.
_RANGES = {"leg_length": (1e-4, 50.0, "m"), "mass": (1e-7, 1e4, "kg"), "gravity": (1e-2, 300.0, "m/s^2")}


@dataclass(frozen=True)
class Units:
    r"""The units of one robot: what 1 is, of each quantity, in SI units.

    Parameters
    ----------
    leg_length : float
        L, in m: from the hip to the foot.
    mass : float
        M, in kg: the **upper body**, hip and wobbling mass together, *without* the feet. The whole walker
        weighs ``M (1 + 2 beta)``: see `from_total_mass`.
    gravity : float
        g, in m/s^2; standard gravity, 9.80665, if it is left out.

    Raises
    ------
    InputError
        For a value that is not a finite number, or outside 0.1 mm to 50 m, 0.1 mg to 10 t, 0.01 to 300 m/s^2.

    Notes
    -----
    With :math:`M`, :math:`L`, :math:`g` in SI units, a dimensionless :math:`k` is the spring of
    :math:`k M g / L` newtons per metre, a time :math:`t` is :math:`t \sqrt{L/g}` seconds, and so on through
    `KINDS`. The equations of motion divided by these units are those of the models, so two robots with
    equal dimensionless numbers walk alike (their Froude numbers :math:`v^2/(g L)` are equal). The source of
    this choice of units is Kamimura and Sano (2023), section II, for length, time and torque.

    Examples
    --------
    >>> robot = Units(leg_length=0.8, mass=40.0, gravity=9.81)
    >>> robot.to_si(6.0, "stiffness")
    2943.0
    >>> round(robot.to_si(3.0, "angular frequency"), 4)  # rad/s
    10.5054
    >>> robot.parameters("wobbling", k=2943.0, beta=6.0)
    {'k': 6.0, 'beta': 0.15}
    """

    leg_length: float
    mass: float
    gravity: float = STANDARD_GRAVITY

    def __post_init__(self) -> None:
        for name in _RANGES:
            object.__setattr__(self, name, _size(name, getattr(self, name)))

    @classmethod
    def from_total_mass(
        cls, leg_length: float, total_mass: float, beta: float, gravity: float = STANDARD_GRAVITY
    ) -> "Units":
        """Units of a robot whose weight on a scale is known, feet included.

        Parameters
        ----------
        leg_length : float
            L, in m.
        total_mass : float
            Upper body and both feet, ``M (1 + 2 beta)``, in kg.
        beta : float
            Mass of one foot as a share of M, as in the models.
        gravity : float
            g, in m/s^2.

        Raises
        ------
        InputError
            As for `Units`, and for a `beta` that is negative or not a finite number.

        Examples
        --------
        >>> round(Units.from_total_mass(leg_length=0.8, total_mass=52.0, beta=0.15).mass, 9)
        40.0
        """
        share = _number(beta, "beta")
        if share < 0:
            raise InputError(f"beta = {share:g} is not allowed: the mass of a foot is at least 0")
        return cls(leg_length, _size("mass", total_mass, "total_mass") / (1 + 2 * share), gravity)

    @classmethod
    def from_mapping(cls, data: Mapping[str, Any], where: str = "units") -> "Units":
        """Units from the entries of a table ``[units]`` or of the option ``--units``.

        Parameters
        ----------
        data : mapping
            ``leg_length`` and ``mass``, and optionally ``gravity``.
        where : str
            Where they stand, for messages.

        Raises
        ------
        InputError
            For an unknown entry, a missing one, or one outside its range.
        """
        for name in data:
            if name not in _RANGES:
                close = difflib.get_close_matches(str(name), _RANGES, n=1)
                more = f" (did you mean {close[0]}?)" if close else ""
                raise InputError(f"{where}: {name} is unknown{more}; the entries are {', '.join(_RANGES)}")
        if missing := [name for name in ("leg_length", "mass") if name not in data]:
            raise InputError(f"{where}: {missing[0]} is missing; give leg_length in m and mass in kg")
        try:
            return cls(**data)
        except InputError as error:
            raise InputError(f"{where}: {error}") from None

    def unit(self, quantity: str) -> float:
        """What 1 of a quantity is in SI units.

        Parameters
        ----------
        quantity : str
            A name from `KINDS`, or a unit formed from ``M``, ``L``, ``g``, ``rad`` and ``1`` with
            blanks or ``*`` for products, ``/``, ``^`` and ``sqrt( )``, as the models' parameters have them.

        Raises
        ------
        InputError
            When it is neither.

        Examples
        --------
        >>> robot = Units(leg_length=0.8, mass=40.0, gravity=9.81)
        >>> robot.unit("stiffness") == robot.unit("M g / L") == 40.0 * 9.81 / 0.8
        True
        """
        values = {"M": self.mass, "L": self.leg_length, "g": self.gravity, "rad": 1.0}
        try:
            text = KINDS[quantity][0] if quantity in KINDS else quantity
            return unit_value(text, values)
        except (
            ArithmeticError,
            AttributeError,
            KeyError,
            RecursionError,
            SyntaxError,
            TypeError,
            ValueError,
        ):
            close = difflib.get_close_matches(str(quantity), KINDS, n=1)
            hint = f"; did you mean {close[0]!r}?" if close else ""
            raise InputError(
                f"{quantity!r} is neither a quantity ({', '.join(KINDS)}) nor a unit formed from "
                f"M, L, g and rad, such as 'M g / L'{hint}"
            ) from None

    def to_si(self, value: Any, quantity: str) -> Any:
        """A number in the models' units, or an array of them, in SI units.

        Parameters
        ----------
        value : float or array_like
            A column of pandas or a variable of xarray stays one; what is missing there stays missing.
        quantity : str
            As for `unit`.

        Returns
        -------
        float, ndarray, pandas.Series or xarray.DataArray

        Raises
        ------
        InputError
            For an unknown quantity, or a value that is not a finite number.

        Examples
        --------
        >>> Units(leg_length=0.8, mass=40.0).to_si([0.0, 1.1837], "time").round(4)  # s
        array([0.    , 0.3381])
        """
        return _finite(value, quantity) * self.unit(quantity)

    def from_si(self, value: Any, quantity: str) -> Any:
        """A number in SI units, or an array of them, in the models' units; parameters as for `to_si`.

        Examples
        --------
        >>> round(Units(leg_length=0.8, mass=40.0, gravity=9.81).from_si(31.392, "torque"), 9)
        0.1
        """
        return _finite(value, quantity) / self.unit(quantity)

    def parameters(
        self, model: Any, params: Mapping[str, float] | None = None, **keywords: float
    ) -> dict[str, float]:
        """Parameters of a model from SI units, ready for `find_orbits` and the other functions.

        Parameters
        ----------
        model : str, path or Model
            As for `find_orbits`.
        params : mapping of str to float, optional
            Parameters by name, in the SI units that belong to the model's own: for ``wobbling`` a spring
            ``k`` in N/m, ``omega`` in rad/s, a foot ``beta`` in kg, ``Kp`` in N m/rad, ``Kd`` in N m s/rad,
            angles in rad, ``alpha`` as it is.
        **keywords : float
            Parameters too.

        Raises
        ------
        InputError
            For an unknown model or parameter, or a value that the model does not allow.
        """
        from stridemap.solver.api.arguments import joined

        si = joined(params, keywords)
        units = {p.name: p.unit for p in _load(model).parameters}
        converted = {
            name: _number(value, name) / self.unit(units[name]) for name, value in si.items() if name in units
        }
        _load(model).point({**si, **converted})  # refuses what it does not know or allow
        return converted

    def parameters_si(self, model: Any, params: Mapping[str, float]) -> dict[str, float]:
        """Parameters of a model, or an orbit's ``params``, in SI units: the inverse of `parameters`.

        Raises
        ------
        InputError
            For an unknown model or parameter, or a value that the model does not allow.
        """
        _load(model).point(params)
        units = {p.name: p.unit for p in _load(model).parameters}
        return {name: float(value) * self.unit(units[name]) for name, value in params.items()}

    def table_si(self, table: Any, model: Any = None) -> Any:
        """A whole table in SI units: every column by the unit that it has in the model.

        Parameters
        ----------
        table : pandas.DataFrame, xarray.Dataset, Orbits, Branches, Boundaries or Table
        model : str, path or Model, optional
            The table's model, where the table does not say what its columns hold, as what
            `stridemap.read_orbits` returns.

        Returns
        -------
        pandas.DataFrame, xarray.Dataset or Table
            Of the kind that was given; a frame for limit cycles, branches and boundaries. What it says of its
            units is changed too.

        Raises
        ------
        InputError
            When the table is in SI units already, when it is not known what its columns hold, or when its
            model is written in units that have nothing to do with a robot's size.

        Examples
        --------
        >>> import stridemap
        >>> robot = Units(leg_length=0.8, mass=40.0, gravity=9.81)
        >>> orbits = stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3)
        >>> robot.table_si(orbits)["k"].tolist()  # N/m
        [2943.0, 2943.0]
        """
        return service("table_si")(table, self, model)

    def measures(self, orbit: "Orbit") -> dict[str, float]:
        """What was measured on a limit cycle, in SI units: m, s, m/s, J, N; pure numbers as they are.

        The keys are those of `MEASURE_KINDS` and of what the model's file declares; what is NaN in the
        orbit stays NaN. A model that is written in kilograms, metres and seconds is in SI units already.

        Raises
        ------
        InputError
            When the model is written in units of another kind.
        """
        names = orbit.model.spec.units
        in_si = (names.mass, names.length, names.time) == ("kg", "m", "s")
        if not in_si:
            check_scaled(orbit.model.spec)
        own = {name: one.kind for name, one in orbit.model.measured.items() if one.type == "float"}
        kinds = {**MEASURE_KINDS, **own}
        return {
            name: getattr(orbit, name) * (1.0 if in_si else self.unit(kind))
            for name, kind in kinds.items()
            if getattr(orbit, name) is not None
        }


def critical_damping(model: Any, params: Mapping[str, float] | None = None, **keywords: float) -> float:
    r"""Damping at which a free spring-borne mass no longer oscillates, in the model's unit of damping.

    Dampers are known as a share of it: ``c = 0.025 * critical_damping("wobbling", k=6, alpha=0.25)`` is 2.5 %
    of critical, whatever the robot's size.

    Parameters
    ----------
    model : str, path or Model
        A model with a spring mode and a spring `k`, as ``wobbling``.
    params : mapping of str to float, optional
        Parameters by name, in the model's units; the preset for those that are left out.
    **keywords : float
        Parameters too.

    Raises
    ------
    InputError
        For an unknown model or parameter, a value that the model does not allow, or a model without a spring.

    Notes
    -----
    :math:`2 k / \Omega`, with the frequency :math:`\Omega` of the mass against the freely sliding hip: for
    ``wobbling`` :math:`2 \sqrt{k \alpha (1 - \alpha)}`, with the reduced mass of wobbling mass and hip.

    Examples
    --------
    >>> round(critical_damping("wobbling", k=6, alpha=0.25), 6)  # in M sqrt(g/L)
    2.12132
    >>> robot = Units(leg_length=0.8, mass=40.0)
    >>> c = 0.025 * critical_damping("wobbling", robot.parameters("wobbling", k=2941.995))
    >>> round(robot.to_si(c, "M sqrt(g/L)"), 3)  # N s/m
    7.427
    """
    from stridemap.solver.api.arguments import joined

    loaded = _load(model)
    if "spring_mode" not in loaded.spec.functions or "k" not in loaded.preset:
        raise InputError(
            f"{loaded.name} has no critical damping: that needs a model with a spring mode and a spring k, "
            "such as wobbling"
        )
    point = loaded.point(joined(params, keywords))
    frequency = float(loaded.evaluate("spring_mode", p=point)["frequency"])
    stiffness = float(point[loaded.spec.names.index("k")])
    return 2 * stiffness / frequency if frequency > 0 else 0.0


_RENAMED = {"QUANTITIES": "KINDS", "MEASURES": "MEASURE_KINDS"}


def __getattr__(name: str) -> Any:
    if name in _RENAMED:
        raise InputError(f"stridemap.units.{name} is called stridemap.units.{_RENAMED[name]} now")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def _load(model: Any) -> Any:
    # Here and not at the top, so that converting a number does not load CasADi.
    from stridemap.solver.model.loading import load

    return load(model)


def _number(value: Any, name: str) -> float:
    """A finite number, or an `InputError` that names it."""
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | float | np.integer | np.floating):
        raise InputError(f"{name} = {value!r} is not a number")
    if not math.isfinite(value):
        raise InputError(f"{name} = {value} is not a finite number")
    return float(value)


def _size(name: str, value: Any, called: str | None = None) -> float:
    """A size of a robot within its range."""
    lower, upper, unit = _RANGES[name]
    number = _number(value, called or name)
    if not lower <= number <= upper:
        raise InputError(
            f"{called or name} = {number:g} {unit} is outside the allowed range "
            f"({lower:g} to {upper:g} {unit}); give it in {unit}"
        )
    return number


def _finite(value: Any, quantity: str) -> Any:
    """A finite number, or an array of them; in columns of pandas and xarray values may be missing."""
    if isinstance(value, list | tuple | np.ndarray):
        array = np.asarray(value)
        if array.dtype.kind not in "iuf" or not np.isfinite(array).all():
            raise InputError(f"{quantity}: not all of the values {value!r} are finite numbers")
        return array.astype(np.float64)
    if not isinstance(value, str) and all(
        hasattr(value, name) for name in ("dtype", "shape", "astype", "copy")
    ):
        kind = getattr(value.dtype, "kind", "O")
        if kind not in "iuf" or np.isinf(np.asarray(value, dtype=np.float64)).any():
            raise InputError(f"{quantity}: the values of {value.name} are not all finite numbers")
        return value
    return _number(value, quantity)


def check_scaled(spec: "ModelSpec") -> None:
    """Refuse a model whose units are not formed from M, L and g.

    Raises
    ------
    InputError
    """
    names = spec.units
    if (names.mass, names.length, names.time) == ("kg", "m", "s"):
        raise InputError(f"{spec.name} is written in kg, m and s already; there is nothing to convert")
    if names.time != SCALED:
        raise InputError(
            f"{spec.name} is written in units of {names.mass}, {names.length} and {names.time}, "
            "which have nothing to do with a robot's size; convert them by hand"
        )
