"""A generated walker, loaded: its parameters, and its equations as CasADi functions."""

import difflib
import hashlib
import importlib.util
import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from types import ModuleType
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

import stridemap.generated
from stridemap.errors import InputError
from stridemap.solver.model.derived import derived_folder

GENERATED = Path(stridemap.generated.__file__).parent
"""Folder of the built-in generated walkers."""

FORMAT = 2
"""Of the manifest."""


@dataclass(frozen=True)
class Parameter:
    """A model parameter with its allowed range.

    Parameters
    ----------
    name : str
    default : float
        The preset's value.
    unit, meaning : str
    lower, upper : float or None
        Ends of the range; None is unlimited (but finite).
    lower_open, upper_open : bool
        Whether the end itself is excluded.
    """

    name: str
    default: float
    unit: str
    meaning: str
    lower: float | None
    upper: float | None
    lower_open: bool
    upper_open: bool

    @property
    def allowed(self) -> str:
        """The allowed range in words."""
        below = None if self.lower is None else f"{'>' if self.lower_open else '>='} {self.lower:g}"
        above = None if self.upper is None else f"{'<' if self.upper_open else '<='} {self.upper:g}"
        return " and ".join(part for part in (below, above) if part) or "any finite number"

    def check(self, value: Any) -> float:
        """Return `value` as a float.

        Raises
        ------
        InputError
            When it is no finite number in the allowed range.
        """
        if isinstance(value, bool) or not isinstance(value, int | float | np.integer | np.floating):
            raise InputError(f"{self.name} = {value!r} is not a number; allowed: {self.allowed}")
        number = float(value)
        inside = math.isfinite(number)
        if inside and self.lower is not None:
            inside = number > self.lower or (number == self.lower and not self.lower_open)
        if inside and self.upper is not None:
            inside = number < self.upper or (number == self.upper and not self.upper_open)
        if not inside:
            raise InputError(f"{self.name} = {number:g} is outside the allowed range ({self.allowed})")
        return number


class Model:
    """A generated walker.

    Every generated function is an attribute, a `casadi.Function` with named inputs and outputs:
    ``load("wobbling").mass_matrix(q=[0.1, 0.2, 0.0], p=model.point({}))["M"]``.

    Parameters
    ----------
    folder : pathlib.Path
        Holds ``manifest.json`` and the generated files that it names.
    source : str, optional
        What `load` found it by: a built-in model's name, or a path.

    Raises
    ------
    InputError
        When a file is missing or is not the one that the manifest names.
    """

    def __init__(self, folder: Path, source: str | None = None) -> None:
        self.folder = folder
        self.source = source or str(folder)
        try:
            self.manifest: dict[str, Any] = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
            self.name: str = self.manifest["model"]
            self.title: str = self.manifest["title"]
            self.hash: str = self.manifest["model_hash"]
            self.section: tuple[str, ...] = tuple(self.manifest["section"]["names"])
            self.coordinates: tuple[str, ...] = tuple(c["name"] for c in self.manifest["coordinates"])
            self.parameters = tuple(Parameter(**entry) for entry in self.manifest["parameters"])
            self.actuated: tuple[str, ...] = tuple(self.manifest["actuated"])
            self.period_range: tuple[float, float] = tuple(self.manifest["section"]["period_range"])
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise InputError(f"{folder} holds no readable manifest.json ({error}); {self._cure}") from None
        if self.manifest["format"] != FORMAT:
            raise InputError(
                f"{folder} was written by another version of stridemap (format {self.manifest['format']}, "
                f"not {FORMAT}); {self._cure}"
            )

    def __getattr__(self, name: str) -> ca.Function:
        """The generated function `name` as a CasADi function."""
        functions = self.__dict__.get("manifest", {}).get("functions", {})
        if name not in functions:
            raise AttributeError(
                f"{type(self).__name__} has no attribute {name!r}; functions: {', '.join(functions)}"
            )
        function = self._casadi(name, functions[name])
        self.__dict__[name] = function
        return function

    def __repr__(self) -> str:
        """Name and hash."""
        return f"Model({self.name!r}, hash={self.hash[:12]!r})"

    @property
    def builtin(self) -> bool:
        """Whether it comes with stridemap."""
        return self.folder.parent == GENERATED

    @property
    def _cure(self) -> str:
        """How the generated files are written again."""
        if self.builtin:
            return "run `stridemap derive`"
        if self.source.endswith(".py"):
            return f"run `stridemap derive {self.source}`"
        return f"run `stridemap derive` with its model file and --out {self.folder}"

    def path(self, file: str) -> Path:
        """Path of a generated file, checked against the manifest.

        Raises
        ------
        InputError
            When the file is missing, or its contents are not what the manifest names.
        """
        path = self.folder / file
        try:
            digest = hashlib.sha256(path.read_bytes()).hexdigest()
        except OSError as error:
            raise InputError(f"cannot read {path}: {error.strerror}; {self._cure}") from None
        if digest != self.manifest["files"].get(file):
            raise InputError(f"{path} is not the file that manifest.json names; {self._cure} to restore it")
        return path

    @cached_property
    def equations(self) -> ModuleType:
        """The namespace-neutral Python module of the model's equations."""
        spec = importlib.util.spec_from_file_location(
            f"stridemap_equations_{self.name}", self.path(f"{self.name}.py")
        )
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module

    def _casadi(self, name: str, entry: Mapping[str, Any]) -> ca.Function:
        symbols = {a["name"]: ca.SX.sym(a["name"], a["size"]) for a in entry["inputs"]}
        scalars = [
            s[0] if a["scalar"] else ca.vertsplit(s)
            for a, s in zip(entry["inputs"], symbols.values(), strict=True)
        ]
        result = getattr(self.equations, name)(ca, *scalars)
        outputs = [self._matrix(result[o["name"]]) for o in entry["outputs"]]
        return ca.Function(
            name, list(symbols.values()), outputs, list(symbols), [o["name"] for o in entry["outputs"]]
        )

    @staticmethod
    def _matrix(value: Any) -> ca.SX:
        if not isinstance(value, list):
            return ca.SX(value)
        return ca.vertcat(*[ca.horzcat(*row) if isinstance(row, list) else row for row in value])

    def evaluate(self, name: str, **values: Any) -> dict[str, NDArray[np.float64]]:
        """Evaluate a generated function on arrays of points, in NumPy.

        Parameters
        ----------
        name : str
        **values : ndarray
            Shape (..., size), or (...) for ``t``. The function uses those that it takes; all together give
            the leading axes of the results.

        Returns
        -------
        dict of str to ndarray
            Shape (...) for a scalar, (..., n) for a vector, (..., n, m) for a matrix.
        """
        entry = self.manifest["functions"][name]
        inputs = [np.asarray(values[a["name"]], dtype=float) for a in entry["inputs"]]
        shape = np.broadcast_shapes(
            *(np.shape(x) if key == "t" else np.shape(x)[:-1] for key, x in values.items())
        )
        split = [
            x if a["scalar"] else list(np.moveaxis(x, -1, 0))
            for a, x in zip(entry["inputs"], inputs, strict=True)
        ]
        with np.errstate(all="ignore"):  # what is beyond the range of numbers comes out as one that says so
            result = getattr(self.equations, name)(np, *split)
        return {key: _stacked(value, shape) for key, value in result.items()}

    def wrapped(self, z: NDArray[np.float64]) -> NDArray[np.float64]:
        """Section points, shape (..., nz or more), with the phase of a clock within one turn.

        A phase that lacks less than 1e-6 of a turn is given from below zero, so that rounding makes no two
        cycles of one.
        """
        if self.manifest["phase"] is None:
            return z
        out, column = z.copy(), self.section.index(self.manifest["phase"])
        out[..., column] = np.mod(z[..., column] + 1e-6, 2 * np.pi) - 1e-6
        return out

    @property
    def preset(self) -> dict[str, float]:
        """The preset's value of every parameter (identified by search, not published)."""
        return {p.name: p.default for p in self.parameters}

    def point(self, params: Mapping[str, Any]) -> NDArray[np.float64]:
        """Parameter vector, shape (n_parameters,); what is not given comes from the preset.

        Raises
        ------
        InputError
            For an unknown name or a value outside its range.
        """
        known = self.preset
        for name in params:
            if name not in known:
                close = difflib.get_close_matches(name, known, n=1)
                hint = f"did you mean {close[0]}? " if close else ""
                raise InputError(
                    f"{self.name} has no parameter {name!r}; {hint}its parameters are {', '.join(known)}"
                )
        return np.array([p.check(params.get(p.name, p.default)) for p in self.parameters])


def _stacked(value: Any, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Nested lists of arrays as one array whose leading axes are `shape`."""
    if not isinstance(value, list):
        return np.broadcast_to(np.asarray(value, dtype=float), shape)
    inner = [_stacked(v, shape) for v in value]
    return np.stack(inner, axis=len(shape))


def available() -> list[str]:
    """Names of the built-in models."""
    return sorted(path.parent.name for path in GENERATED.glob("*/manifest.json"))


def load(name: "str | Path | Model") -> Model:
    """Load a model.

    Parameters
    ----------
    name : str, path or Model
        A built-in model's name; the path of a model file (``.py``), which is derived if that was not done
        before; or the folder that `stridemap derive` wrote. A model that is loaded is returned as it is.

    Raises
    ------
    InputError
        When there is no such model, or its file declares none.
    """
    if isinstance(name, Model):
        return name
    text = str(name)
    if text.endswith(".py"):
        return _loaded(derived_folder(Path(text)), text)
    if text in available():
        return _loaded(GENERATED / text, text)
    if (Path(text) / "manifest.json").exists():
        return _loaded(Path(text).resolve(), text)
    raise InputError(
        f"there is no model {text!r}; models are {', '.join(available())}, or give the path of a model file "
        "(.py) or of a folder that `stridemap derive` wrote"
    )


def _loaded(folder: Path, source: str) -> Model:
    try:
        manifest = (folder / "manifest.json").read_bytes()
    except OSError:
        manifest = b""  # `Model` tells
    return _load(folder, source, hashlib.sha256(manifest).hexdigest())


@cache
def _load(folder: Path, source: str, _manifest: str) -> Model:
    return Model(folder, source)
