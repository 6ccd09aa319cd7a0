"""Kernels as C++ that works on several points per instruction, one per lane of the processor's vectors.

CasADi's C has no branches and names its type of number once. As C++, with `Lanes` (lanes.h) for that type,
the same text works on 8 points at a time with AVX-512, on 4 with AVX2, on 2 elsewhere. Newton's method,
which stops when it has converged, is written by hand around it (lockstep.h).

Where many guesses lead to each solution, a search runs in single precision, on twice as many points at a
time: it needs only to come near. Where it ends, the residual is in double precision, and so is all else.

The results do not depend on the processor, nor on which points are in a batch.
"""

import ctypes
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stridemap.solver.backends.base import Backend, Directional, Kernels, Lockstep, Searched
from stridemap.solver.backends.compiler import Compiler, processor_features
from stridemap.solver.backends.shared_library import check, pointers, sizes
from stridemap.solver.kernels.catalogue import (
    BRANCH_FREE,
    NEARLY,
    NEWTON,
    PLAIN_PIECES,
    SEARCH_RESIDUAL,
    Kernel,
    Kind,
    Newton,
    c_name,
    jacobian,
    plain_pieces_source,
    residual,
    search,
)
from stridemap.solver.kernels.step_map import BLOCK
from stridemap.solver.kernels.tableau import rests
from stridemap.solver.model.files import kernels_file
from stridemap.solver.model.model import Model
from stridemap.solver.model.scales import Scales, rounded

Array = NDArray[np.float64]
Index = NDArray[np.int64]

FLAGS = (
    *(
        "-x",
        "c++",
        "-O1",
        "-std=c++17",
        "-ffp-contract=off",
        "-fno-math-errno",
        "-fno-exceptions",
        "-fno-rtti",
    ),
    *("-Wno-psabi", "-Wno-ignored-attributes", "-fPIC", "-shared"),
)
"""No contraction here either: processors that can and that cannot would differ in the last digits."""

INSTRUCTIONS = (
    (frozenset({"avx512f", "avx512dq", "avx512vl"}), ("-mavx512f", "-mavx512dq", "-mavx512vl")),
    (frozenset({"avx2"}), ("-mavx2",)),
)
"""What a processor must offer for which flags, best first."""


def instruction_flags() -> tuple[str, ...]:
    """Flags for the widest instructions of this processor; none where it does not say what it has."""
    return next((flags for needed, flags in INSTRUCTIONS if needed <= processor_features()), ())


def fused_flags(flags: Sequence[str]) -> tuple[str, ...]:
    """More flags for products whose rounding is computed: with them it takes one instruction, not sixteen."""
    return ("-mfma",) if "-mavx2" in flags and "fma" in processor_features() else ()


def source(model: Model) -> str:
    """The kernels, and what calls them in lockstep, as one C++ file.

    Parameters
    ----------
    model : Model

    Raises
    ------
    InputError
        When the C is not the one that the manifest names.
    """
    kernels = [kernel for kernel in BRANCH_FREE if kernel not in ALONG]
    return _joined(_kernels(model), ("lanes.h",), "Lanes", "lockstep.h", _names(model, kernels))


def along_source(model: Model) -> str:
    """The derivatives in directions of the parameters too, as one C++ file; see `source`."""
    return _joined(_kernels(model), ("lanes.h",), "Lanes", "lockstep.h", _names(model, ALONG))


def search_source(model: Model) -> str:
    """What a quick search needs, in single precision, as one C++ file; see `source`."""
    kernels = [jacobian(NEWTON[kernel].jacobian_n_rk) for kernel in SEARCHES]
    return "#define SINGLE_PRECISION\n" + _joined(
        _kernels(model), ("lanes.h",), "Lanes", "lockstep.h", _names(model, kernels)
    )


def directional_source(model: Model) -> str:
    """The residuals with derivatives in two directions, as one C++ file; see `source`."""
    return _joined(_kernels(model), ("lanes.h", "jets.h"), "Jet", "directional.h", _names(model, RESIDUALS))


def precise_source(model: Model) -> str:
    """The residuals in numbers of twice the digits, as one C++ file; see `source`."""
    return _precise(_kernels(model), _names(model, RESIDUALS))


def precise_pieces_source(model: Model) -> str:
    """The pieces of which a residual is chained, in numbers of twice the digits, as one C++ file."""
    return _precise(plain_pieces_source(model), [f"{model.name}_{name}" for name in PLAIN_PIECES])


def _precise(text: str, shown: Sequence[str]) -> str:
    """Functions in numbers of twice the digits, and so the coefficients of the integration."""
    rest = rests(tuple(kernel.n_rk for kernel in RESIDUALS))

    def whole(found: re.Match[str]) -> str:
        """A constant with what its double leaves out, where that is known."""
        left_out = rest.get(float(found[0]), 0.0)
        return f"Pair({found[0]}, {left_out!r})" if left_out else found[0]

    text = re.sub(r"\b\d\.\d{16}e[-+]\d\d\b", whole, text)  # as CasADi writes constants
    return _joined(text, ("lanes.h", "pairs.h"), "Pair", "precise.h", shown)


def _joined(text: str, numbers: Sequence[str], number: str, driver: str, shown: Sequence[str]) -> str:
    """CasADi's C with another type of number, between the number's header and what calls the functions."""
    *headers, caller = map(_header, (*numbers, driver))
    # What is not shown is not compiled.
    return "\n".join(
        [
            *headers,
            f"#define casadi_real {number}",
            "#define CASADI_SYMBOL_EXPORT",
            f"namespace {{\n{text}\n}}",
            caller,
            *(f"KERNEL({name})" for name in shown),
            "",
        ]
    )


def _header(name: str) -> str:
    return (Path(__file__).parent / name).read_text(encoding="utf-8")


def _kernels(model: Model) -> str:
    return model.text(kernels_file(model.name))


def _names(model: Model, kernels: Sequence[Kernel]) -> list[str]:
    return [c_name(model, kernel) for kernel in kernels]


RESIDUALS = tuple(kernel for kernel in BRANCH_FREE if kernel.kind == Kind.RESIDUAL)

ALONG = tuple(kernel for kernel in BRANCH_FREE if kernel.kind == Kind.JACOBIAN_ALONG)

SEARCHES = tuple(kernel for kernel in NEWTON if kernel.kind == Kind.SEARCH)

FINISHING = 4
"""Newton steps at most in double precision, where single precision came near and left much open."""


@dataclass(frozen=True)
class Lanes(Backend):
    """C++ for several points per instruction.

    Parameters
    ----------
    compiler : str, optional
        Command line of the C compiler; by default the one that `Compiler.found` finds where it runs.
    instructions : tuple of str, optional
        Flags for the processor's instructions; by default the widest that it has. The results are the same.
    """

    compiler: str | None = None
    instructions: tuple[str, ...] | None = None

    def __post_init__(self) -> None:
        if self.instructions is not None:
            object.__setattr__(self, "instructions", tuple(self.instructions))

    @property
    def arithmetic(self) -> str:
        """The same on every processor and with every compiler: its sines are its own."""
        return (
            "several points per instruction, without contraction, sines of its own, quick searches in 32 bits"
        )

    def kernels(self, model: Model) -> "LaneKernels":
        """The kernels of a model."""
        return LaneKernels(model, self)


class LaneKernels(Kernels):
    """Kernels as machine code for several points per instruction.

    Parameters
    ----------
    model : Model
    backend : Lanes
    """

    def __init__(self, model: Model, backend: Lanes) -> None:
        super().__init__(model, backend)
        self._command = backend.compiler
        self._compiler = Compiler.named(backend.compiler)
        wide = instruction_flags() if backend.instructions is None else backend.instructions
        self._flags = [*FLAGS, *wide]
        self._library = self._compiler.library(f"{model.name}_lockstep.cpp", source(model), self._flags)
        self.library = Path(self._library._name)
        self._addresses: dict[tuple[ctypes.CDLL, Kernel], int] = {}
        self._drivers: dict[Path, Lockstep] = {}

    @cached_property
    def _search(self) -> ctypes.CDLL:
        """What quick searches need; compiled when it is first asked for."""
        return self._compiled_now("search", search_source(self.model))

    @cached_property
    def _along(self) -> ctypes.CDLL:
        """Derivatives in directions of the parameters too; compiled when they are first asked for."""
        return self._compiled_now("along", along_source(self.model))

    def prepare_search_and_following(self) -> None:
        """Compile what these take: see `Kernels.prepare_search_and_following`."""
        _ = self._search, self._along

    def lockstep(self, driver: Path) -> Lockstep:
        """An algorithm around the kernels: see `Kernels.lockstep`."""
        if driver not in self._drivers:
            integer = "#define casadi_int long long int"  # as in CasADi's C
            headers = map(_header, ("lanes.h", "lockstep.h"))
            text = "\n".join([integer, *headers, driver.read_text(encoding="utf-8")])
            library = Compiler.named(self._command).library(f"{driver.stem}.cpp", text, self._flags)
            self._drivers[driver] = Lockstep(library, self._address)
        return self._drivers[driver]

    def _address(self, kernel: Kernel) -> int:
        """Where in memory a kernel is."""
        return self._shown(self._owner(kernel), kernel)

    def _owner(self, kernel: Kernel) -> ctypes.CDLL:
        """The library that has a kernel."""
        return self._along if kernel in ALONG else self._library

    def quick_search(self, n_rk: int, u: Array, p: Array, steps: int | None = None) -> Searched:
        """Newton's method from rough guesses in single precision: see `Kernels.quick_search`.

        Where that came near, which an unstable cycle magnifies, it goes on in double precision.
        """
        u, p = np.array(u, dtype=np.float64, order="C"), np.ascontiguousarray(p, dtype=np.float64)
        library, method = self._search, NEWTON[search(n_rk)]
        if len(u) != len(p):
            raise ValueError(f"there are {len(u)} guesses and {len(p)} points of parameters")
        if not len(u):
            return Searched(u, u.copy())
        self._newton(library, replace(method, iterations=steps or method.iterations), u, p)
        closing = self.residual(n_rk, u, p)
        size = np.abs(closing / Scales.of(self.model).residual).max(axis=1)
        with np.errstate(invalid="ignore"):
            near = np.flatnonzero((size > SEARCH_RESIDUAL) & (size < NEARLY))
        ends = u[near]
        self._newton(self._library, replace(method, iterations=FINISHING), ends, p[near])
        u[near], closing[near] = ends, self.residual(n_rk, ends, p[near])
        return Searched(u, closing)

    @cached_property
    def _directional(self) -> ctypes.CDLL:
        """The residuals with derivatives in two directions; compiled when they are first asked for."""
        return self._compiled_now("directional", directional_source(self.model))

    def directional(self, n_rk: int, u: Array, p: Array, a: Array, b: Array) -> Directional:
        """Residuals with exact derivatives in two directions of (u, p): see `Kernels.directional`."""
        u, p, a, b = (np.ascontiguousarray(one, dtype=np.float64) for one in (u, p, a, b))
        outputs = [np.empty_like(u) for _ in range(4)]
        kernel = residual(n_rk)
        if len(u):
            status = self._directional.directional_map(
                _shown(self._directional, "directional", c_name(self.model, kernel)),
                *map(ctypes.c_longlong, (len(u), u.shape[1], p.shape[1])),
                *(ctypes.c_void_p(one.ctypes.data) for one in (u, p, a, b)), pointers(outputs),
            )  # fmt: skip
            check(status, kernel)
        return Directional(*outputs)

    @cached_property
    def _precise(self) -> ctypes.CDLL:
        """The residuals in numbers of twice the digits; compiled when they are first asked for."""
        return self._compiled_now("precise", precise_source(self.model), fused_flags(self._flags))

    @cached_property
    def _precise_pieces(self) -> ctypes.CDLL:
        """The pieces of those on more RK steps than a kernel has."""
        text = precise_pieces_source(self.model)
        return self._compiled_now("precise_pieces", text, fused_flags(self._flags))

    def precise_residual(self, n_rk: int, u: Array, p: Array) -> Array:
        """Residuals in numbers of twice the digits: see `Kernels.precise_residual`."""
        u, p = (np.ascontiguousarray(one, dtype=np.float64) for one in (u, p))
        out, kernel = np.full(u.shape, np.nan), residual(n_rk)
        if not len(u):
            return out
        sizes = [len(u), u.shape[1], p.shape[1]]
        points = [ctypes.c_void_p(one.ctypes.data) for one in (u, p, out)]
        whole = kernel in self.functions
        library = self._precise if whole else self._precise_pieces
        run = library.precise_map if whole else library.precise_chain
        if not whole:
            sizes = [n_rk // BLOCK, BLOCK, *sizes, 2 * len(self.model.coordinates)]
        names = (kernel.name,) if whole else PLAIN_PIECES
        pieces = [_shown(library, "precise", f"{self.model.name}_{name}") for name in names]
        check(run(*pieces, *map(ctypes.c_longlong, sizes), *points), kernel)
        return out

    def _compiled_now(self, what: str, text: str, more: Sequence[str] = ()) -> ctypes.CDLL:
        compiler = Compiler.named(self._command)  # what is found now: much may have changed since
        return compiler.library(f"{self.model.name}_{what}.cpp", text, [*self._flags, *more])

    @property
    def compiler(self) -> str:
        """Compiler, its version and those flags on which results may depend."""
        return f"{self._compiler.version} {' '.join(FLAGS)}"

    def _map(self, kernel: Kernel, inputs: list[Array], outputs: list[Array]) -> None:
        method = NEWTON.get(kernel)
        if method is None:
            self._apply(kernel, inputs, outputs)
            return
        outputs[0][:] = inputs[0]
        self._newton(self._library, method, outputs[0], inputs[1])
        self._apply(method.closing, [outputs[0], inputs[1]], outputs[1:])

    def _newton(self, library: ctypes.CDLL, method: Newton, u: Array, params: Array) -> None:
        """Newton's method from the guesses in `u`, which the solutions replace."""
        derivative = jacobian(method.jacobian_n_rk)
        alike = method.n_rk == method.jacobian_n_rk
        scales = Scales.of(self.model)
        unknowns, rows = rounded(scales.unknowns), rounded(scales.residual)
        status = library.lockstep_newton(
            ctypes.c_void_p(self._shown(library, derivative)),
            ctypes.c_void_p(None if alike else self._shown(library, residual(method.n_rk))),
            ctypes.c_longlong(len(u)), ctypes.c_longlong(u.shape[1]), ctypes.c_longlong(params.shape[1]),
            ctypes.c_void_p(u.ctypes.data), ctypes.c_void_p(params.ctypes.data),
            ctypes.c_void_p(unknowns.ctypes.data), ctypes.c_void_p(rows.ctypes.data),
            ctypes.c_double(method.abstol), ctypes.c_double(method.abstol_step), method.iterations,
        )  # fmt: skip
        check(status, derivative)

    def _apply(self, kernel: Kernel, inputs: list[Array], outputs: list[Array]) -> None:
        """A kernel without branches, point by point."""
        self._apply_each([kernel], [len(inputs[0])], None, inputs, outputs)

    def _apply_each(
        self,
        kernels: Sequence[Kernel],
        counts: Sequence[int],
        points: Index | None,
        inputs: list[Array],
        outputs: list[Array],
    ) -> None:
        """Kernels of the same inputs and outputs, each to so many of the points in their order."""
        n = len(kernels)
        library = self._owner(kernels[0])
        status = library.lockstep_map(
            ctypes.c_longlong(n),
            (ctypes.c_void_p * n)(*(self._shown(library, kernel) for kernel in kernels)),
            (ctypes.c_longlong * n)(*counts), ctypes.c_void_p(None if points is None else points.ctypes.data),
            ctypes.c_longlong(len(inputs)), pointers(inputs), sizes(inputs),
            ctypes.c_longlong(len(outputs)), pointers(outputs), sizes(outputs),
        )  # fmt: skip
        check(status, kernels[0])

    def _map_each(
        self, kernels: Sequence[Kernel], rows: Sequence[Index], inputs: list[Array], outputs: list[Array]
    ) -> None:
        points = np.concatenate(rows).astype(np.int64, copy=False)
        self._apply_each(kernels, [len(one) for one in rows], points, inputs, outputs)

    def _shown(self, library: ctypes.CDLL, kernel: Kernel) -> int:
        known = self._addresses.get((library, kernel))
        if known is None:
            known = _shown(library, "lockstep", c_name(self.model, kernel)).value or 0
            self._addresses[library, kernel] = known
        return known


def _shown(library: ctypes.CDLL, driver: str, kernel: str) -> ctypes.c_void_p:
    """Address of a kernel in a library."""
    return ctypes.c_void_p(ctypes.addressof(ctypes.c_char.in_dll(library, f"{driver}_{kernel}")))
