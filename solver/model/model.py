"""A generated walker, loaded: its specification, and its equations as CasADi functions."""

import hashlib
import json
from collections.abc import Mapping
from functools import cached_property
from types import ModuleType
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from stridemap.errors import InputError
from stridemap.quantities import measured_on
from stridemap.solver.model.files import MANIFEST, Files, equations_file, kernels_file, packed, unpacked
from stridemap.solver.model.function import ModelFunction, check_arguments, wrong_size
from stridemap.spec import SIGNATURE, Function, ModelSpec, Parameter, Quantity
from stridemap.words import hint


class Model:
    """A generated walker.

    Every generated function is an attribute, a `casadi.Function` with named inputs and outputs:
    ``load("wobbling").mass_matrix(q=[0.1, 0.2, 0.0], p=model.point({}))["M"]``. Each takes all of ``t``,
    ``q``, ``v``, ``u`` and ``p`` (``section_state``: ``z``, ``p``), uses what it needs and ignores the rest.

    A model is a value: it can be sent to another process or machine, and takes its generated files along.

    Parameters
    ----------
    files : Files
        ``manifest.json`` and the generated files that it names.
    source : str
        What `load` found it by: a built-in model's name, or a path.

    Attributes
    ----------
    spec : ModelSpec
        What is known of it without its equations.

    Raises
    ------
    InputError
        When a file is missing or is not the one that the manifest names.
    """

    def __init__(self, files: Files, source: str) -> None:
        self.files = files
        self.source = source
        try:
            self._manifest = files.read(MANIFEST)
            self.spec = ModelSpec.from_manifest(json.loads(self._manifest))
        except InputError as error:
            raise InputError(f"{files.shown} {error}; {self._remedy}") from None
        except (OSError, ValueError, KeyError, TypeError, AttributeError, IndexError) as error:
            raise InputError(
                f"{files.shown} does not hold a readable {MANIFEST} ({error}); {self._remedy}"
            ) from None
        self._digest = hashlib.sha256(self._manifest).hexdigest()
        _KNOWN.setdefault((source, self._digest), self)

    # -- what it is called -------------------------------------------------------------------------------

    @property
    def name(self) -> str:
        """Name of the model."""
        return self.spec.name

    @property
    def title(self) -> str:
        """One line for readers."""
        return self.spec.title

    @property
    def hash(self) -> str:
        """SHA-256 of its equations."""
        return self.spec.hash

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates."""
        return tuple(c.name for c in self.spec.coordinates)

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters, in the order of every parameter vector."""
        return self.spec.parameters

    @property
    def section(self) -> tuple[str, ...]:
        """Names of the free coordinates and rates on the Poincare section."""
        return self.spec.section

    @property
    def actuated(self) -> tuple[str, ...]:
        """Names of the motors, in the order of their torques; `ModelSpec.motors` says more of each."""
        return self.spec.actuated

    @property
    def period_range(self) -> tuple[float, float]:
        """Shortest and longest period that is searched for by default."""
        return self.spec.period_range

    @cached_property
    def measured(self) -> dict[str, Quantity]:
        """What is measured on its limit cycles, by name and in the order of columns."""
        return measured_on(self.spec)

    @property
    def stance_index(self) -> int | None:
        """Place of the stance leg's angle among the coordinates, where there is one."""
        angle = self.spec.stance_angle
        return None if angle is None else self.coordinates.index(angle)

    def __getattr__(self, name: str) -> ModelFunction:
        """The generated function `name` as a CasADi function."""
        spec = self.__dict__.get("spec")
        functions = {} if spec is None else spec.functions
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

    def __eq__(self, other: object) -> bool:
        """Whether it is this very model; what comes from another process is, where it was loaded here too."""
        if isinstance(other, str):
            raise InputError(f"a model is not its name; compare model.name with {other!r}")
        return self is other

    __hash__ = object.__hash__

    def __copy__(self) -> "Model":
        """Itself: a model does not change."""
        return self

    def __deepcopy__(self, _memo: Any) -> "Model":
        """Itself: a model does not change."""
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        """Its source and the generated files that running it needs."""
        return _from_pack, (self.source, self._digest, self._pack)

    @cached_property
    def _pack(self) -> dict[str, bytes]:
        needed = (equations_file(self.name), kernels_file(self.name))
        return packed({MANIFEST: self._manifest, **{name: self._checked(name) for name in needed}})

    @property
    def builtin(self) -> bool:
        """Whether it comes with stridemap."""
        return self.files.builtin

    @property
    def _remedy(self) -> str:
        """How the generated files are written again."""
        if self.builtin:
            return "run `stridemap derive`"
        if self.source.endswith(".py"):
            return f"run `stridemap derive {self.source}`"
        return f"run `stridemap derive` with its model file and --out {self.files.shown}"

    def text(self, file: str) -> str:
        """Contents of a generated file, checked against the manifest.

        Raises
        ------
        InputError
            When the file is missing, or its contents are not what the manifest names.
        """
        return self._checked(file).decode("utf-8")

    def _checked(self, file: str) -> bytes:
        where = self.files.path(file)
        try:
            content = self.files.read(file)
        except OSError as error:
            raise InputError(f"cannot read {where}: {error.strerror}; {self._remedy}") from None
        if hashlib.sha256(content).hexdigest() != self.spec.files.get(file):
            raise InputError(f"{where} is not the file that {MANIFEST} names; {self._remedy} to restore it")
        return content

    @cached_property
    def equations(self) -> ModuleType:
        """The namespace-neutral Python module of the model's equations."""
        module = ModuleType(f"stridemap_equations_{self.name}")
        file = equations_file(self.name)
        exec(compile(self.text(file), self.files.path(file), "exec"), vars(module))
        return module

    # -- what it computes --------------------------------------------------------------------------------

    def _casadi(self, name: str, function: Function) -> ModelFunction:
        symbols = {a: ca.SX.sym(a, self.spec.size(a)) for a in function.signature}
        scalars = [symbols[a][0] if a == "t" else ca.vertsplit(symbols[a]) for a in function.arguments]
        result = getattr(self.equations, name)(ca, *scalars)
        names = [one.name for one in function.outputs]
        outputs = [self.matrix(result[one]) for one in names]
        # The torques are an argument of every function, and the result of one.
        options = {"allow_duplicate_io_names": True}
        made = ca.Function(name, list(symbols.values()), outputs, list(symbols), names, options)
        return ModelFunction(made, self.spec, function)

    @staticmethod
    def matrix(value: Any) -> ca.SX:
        """A result of a generated function (a scalar, a list, or a list of rows) as a CasADi matrix."""
        if not isinstance(value, list):
            return ca.SX(value)
        return ca.vertcat(*[ca.horzcat(*row) if isinstance(row, list) else row for row in value])

    def evaluate(self, name: str, **values: Any) -> dict[str, NDArray[np.float64]]:
        """Evaluate a generated function on arrays of points, in NumPy.

        Parameters
        ----------
        name : str
        **values : ndarray
            Any of t, q, v, u, p and z: shape (..., size), or (...) for ``t``. The function uses those that it
            reads; all together give the leading axes of the results.

        Returns
        -------
        dict of str to ndarray
            Shape (...) for a scalar, (..., n) for a vector, (..., n, m) for a matrix.

        Raises
        ------
        InputError
            When something that the function reads is missing or has another size, or for an unknown name.
        """
        function = self.spec.functions.get(name)
        if function is None:
            raise InputError(f"{self.name} has no function {name!r}; it has {', '.join(self.spec.functions)}")
        arguments = function.arguments
        check_arguments(self.spec, name, (*SIGNATURE, "z"), arguments, values)
        inputs = [np.asarray(values[a], dtype=float) for a in arguments]
        for a, x in zip(arguments, inputs, strict=True):
            if a != "t" and np.shape(x)[-1:] != (self.spec.size(a),):
                raise wrong_size(self.spec, name, a, np.shape(x)[-1] if np.ndim(x) else "a single number")
        shape = np.broadcast_shapes(
            *(np.shape(x) if key == "t" else np.shape(x)[:-1] for key, x in values.items())
        )
        split = [
            x if a == "t" else list(np.moveaxis(x, -1, 0)) for a, x in zip(arguments, inputs, strict=True)
        ]
        with np.errstate(all="ignore"):  # what is beyond the range of numbers comes out as one that says so
            result = getattr(self.equations, name)(np, *split)
        return {key: _stacked(value, shape) for key, value in result.items()}

    def wrapped(self, z: NDArray[np.float64]) -> NDArray[np.float64]:
        """Section points, shape (..., nz or more), with the phase of a clock within one turn.

        A phase that lacks less than 1e-6 of a turn is given from below zero, so that rounding makes no two
        cycles of one.
        """
        if self.spec.phase is None:
            return z
        out, column = z.copy(), self.section.index(self.spec.phase)
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
                raise InputError(
                    f"{self.name} has no parameter {name!r}{hint(str(name), known)}; its parameters are "
                    f"{', '.join(known)}"
                )
        return np.array([p.check(params.get(p.name, p.default)) for p in self.parameters])


def _stacked(value: Any, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Nested lists of arrays as one array whose leading axes are `shape`."""
    if not isinstance(value, list):
        return np.broadcast_to(np.asarray(value, dtype=float), shape)
    inner = [_stacked(v, shape) for v in value]
    return np.stack(inner, axis=len(shape))


_KNOWN: dict[tuple[str, str], Model] = {}
"""Models of this process by source and digest of the manifest."""


def _from_pack(source: str, digest: str, pack: Mapping[str, bytes]) -> Model:
    """The model that came from another process; made once, however often it is sent."""
    return _KNOWN.get((source, digest)) or Model(unpacked(pack, source), source)
