"""Which functions the solver runs, what each is called, and their C.

`search(n)`           Newton's method from a rough guess on n RK steps, with the residual there
`limit_cycle(n)`      Newton's method from a good guess, with Jacobian and residual there
`residual(n)`         the residual alone
`jacobian(n)`         the residual with its Jacobian
`jacobian_along(n)`   the same with the derivative in a direction of the parameters
`trace(n)`            the states and observables at the n + 1 nodes of a step
`ADVANCE`             a part of an RK step, observed
`BEGIN`, `SWING`, `END`, `OBSERVED_SWING`
                      pieces of a step, of which any number of RK steps can be chained (`backends.chained`)

In C every name begins with the model's, so that kernels of several models link into one program. The same
CasADi functions run in CasADi's virtual machine where there is no C compiler.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

import casadi as ca

from stridemap.solver.kernels.observation import Observation, observables
from stridemap.solver.kernels.step_map import BLOCK, StepMap
from stridemap.solver.model.files import kernels_file
from stridemap.solver.model.model import Model


class Kind(StrEnum):
    """What a kernel computes."""

    SEARCH = "search"
    LIMIT_CYCLE = "limit_cycle"
    RESIDUAL = "residual"
    JACOBIAN = "jacobian"
    JACOBIAN_ALONG = "jacobian_along"
    TRACE = "trace"
    ADVANCE = "advance"
    BEGIN = "begin"
    SWING = "swing"
    END = "end"
    OBSERVED_SWING = "observed_swing"


class Kernel(NamedTuple):
    """A kernel of a model.

    Parameters
    ----------
    kind : Kind
    n_rk : int
        RK steps per step of the walker; 0 where that means nothing.
    """

    kind: Kind
    n_rk: int = 0

    @property
    def name(self) -> str:
        """What it is called in C, after the model's name."""
        return f"{self.kind}_{self.n_rk}" if self.n_rk else str(self.kind)


def c_name(model: Model, kernel: Kernel) -> str:
    """What a kernel of a model is called in C."""
    return f"{model.name}_{kernel.name}"


def search(n_rk: int) -> Kernel:
    """Newton's method from a rough guess."""
    return Kernel(Kind.SEARCH, n_rk)


def limit_cycle(n_rk: int) -> Kernel:
    """Newton's method from a good guess."""
    return Kernel(Kind.LIMIT_CYCLE, n_rk)


def residual(n_rk: int) -> Kernel:
    """The residual."""
    return Kernel(Kind.RESIDUAL, n_rk)


def jacobian(n_rk: int) -> Kernel:
    """The residual and its Jacobian."""
    return Kernel(Kind.JACOBIAN, n_rk)


def jacobian_along(n_rk: int) -> Kernel:
    """The residual with its Jacobian, and its derivative in a direction of the parameters."""
    return Kernel(Kind.JACOBIAN_ALONG, n_rk)


def trace(n_rk: int) -> Kernel:
    """States and observables at the nodes of a step."""
    return Kernel(Kind.TRACE, n_rk)


ADVANCE = Kernel(Kind.ADVANCE)
"""A part of an RK step, observed."""

BEGIN, SWING, END = Kernel(Kind.BEGIN), Kernel(Kind.SWING), Kernel(Kind.END)
"""Start of a step with its tangents, `BLOCK` RK steps of both, and impact with touchdown condition."""

OBSERVED_SWING = Kernel(Kind.OBSERVED_SWING)
"""`BLOCK` RK steps of the state with net works, observed at their nodes."""

SEARCH_N_RK = (12, 24, 48)
"""Resolutions of the search from rough guesses."""

CYCLE_N_RK = (24, 36, 48, 72, 96, 144, 192, 288, 384)
"""Resolutions of accepted limit cycles; each is checked at twice as many RK steps."""

FINE_N_RK = (768, 1536, 3072, 6144, 12288, 24576)
"""Resolutions beyond those of one function each, for motions with sudden changes. They are chained from
pieces (`backends.chained`), and cost no time to compile. The last is a bound on the time that one point may
take: at it, a cycle takes seconds."""


@dataclass(frozen=True)
class Newton:
    """Newton's method as a kernel: (u0, p) -> (u, what `closing` computes there).

    Parameters
    ----------
    n_rk, jacobian_n_rk : int
        Resolutions of the residual and of its Jacobian.
    abstol, abstol_step : float
        It stops at this residual, or after a Newton step of this size.
    iterations : int
        It stops after these in any case.
    closing : Kernel
        A residual, or one with its Jacobian.
    """

    n_rk: int
    jacobian_n_rk: int
    abstol: float
    abstol_step: float
    iterations: int
    closing: Kernel


NEWTON = {
    **{search(n): Newton(n, n, 1e-12, 1e-4, 10, closing=residual(n)) for n in SEARCH_N_RK},
    **{
        limit_cycle(n): Newton(n, n // 2 // BLOCK * BLOCK, 1e-14, 1e-9, 6, closing=jacobian(n))
        for n in CYCLE_N_RK
    },
}
"""The kernels that are Newton's method."""

SEARCH_RESIDUAL = 1e-4
"""What a search may leave open for Newton's method at full resolution, in terms of the model's scales."""

NEARLY = 1e-2
"""Residual below which a solution nearly closed, in terms of the scales: a finer resolution may close it."""

BRANCH_FREE = (
    *(residual(n) for n in sorted({*SEARCH_N_RK, *CYCLE_N_RK})),
    *(jacobian(n) for n in sorted({*SEARCH_N_RK, *CYCLE_N_RK, *(m.jacobian_n_rk for m in NEWTON.values())})),
    *(jacobian_along(n) for n in sorted({*SEARCH_N_RK, *CYCLE_N_RK})),
    *(trace(2 * n) for n in CYCLE_N_RK),
    ADVANCE,
    BEGIN,
    SWING,
    END,
    OBSERVED_SWING,
)
"""The kernels without branches, which can work on many points in lockstep."""


KERNELS = (*NEWTON, *BRANCH_FREE)
"""All kernels, in the order in which they are printed."""


class Shapes(NamedTuple):
    """What a kernel takes and gives.

    Parameters
    ----------
    inputs : dict of str to int
        Number of entries of each input, by name and in order.
    outputs : tuple of (int, int)
        Rows and columns of each output.
    """

    inputs: dict[str, int]
    outputs: tuple[tuple[int, int], ...]


def shapes(model: Model, kernel: Kernel) -> Shapes:
    """Sizes of a kernel's inputs and outputs, which are known without building it.

    Parameters
    ----------
    model : Model
    kernel : Kernel
    """
    n, nu = 2 * len(model.coordinates), len(model.section) + 1
    width, rows, nodes = n + len(model.actuated), len(observables(model)), kernel.n_rk + 1
    point = {"u": nu, "p": len(model.parameters)}
    p = {"p": len(model.parameters)}
    closing = {Kind.RESIDUAL: ((nu, 1),), Kind.JACOBIAN: ((nu, nu), (nu, 1))}
    if kernel in NEWTON:
        return Shapes({"u0": nu, **p}, ((nu, 1), *closing[NEWTON[kernel].closing.kind]))
    known = {
        **{kind: (point, outputs) for kind, outputs in closing.items()},
        Kind.JACOBIAN_ALONG: ({**point, "d": len(model.parameters)}, ((nu, nu), (nu, 1), (nu, 1))),
        Kind.TRACE: (point, ((width, nodes), (rows, nodes), (rows, nodes), (nu, 1))),
        Kind.ADVANCE: ({"t": 1, "w": width, "h": 1, **p}, ((width, 1), (rows, 1), (rows, 1))),
        Kind.BEGIN: (point, ((n, nu),)),
        Kind.SWING: ({"t": 1, "h": 1, "y": n * nu, **p}, ((n, nu),)),
        Kind.END: ({"y": n * nu, **point}, closing[Kind.JACOBIAN]),
        Kind.OBSERVED_SWING: (
            {"t": 1, "h": 1, "w": width, **p},
            ((width, 1), (width, BLOCK), (rows, BLOCK), (rows, BLOCK)),
        ),
    }
    return Shapes(*known[kernel.kind])


class Catalogue(Mapping[Kernel, ca.Function]):
    """All kernels of a model as CasADi functions, each built when it is first asked for.

    Parameters
    ----------
    model : Model
    """

    def __init__(self, model: Model) -> None:
        self._step_map = StepMap(model)
        self._observation = Observation(self._step_map)
        self._built: dict[Kernel, ca.Function] = {}

    def __getitem__(self, kernel: Kernel) -> ca.Function:
        if kernel not in self:
            raise KeyError(kernel)
        if kernel not in self._built:
            self._built[kernel] = self._made(kernel)
        return self._built[kernel]

    def __contains__(self, kernel: object) -> bool:
        return kernel in KERNELS

    def __iter__(self) -> Iterator[Kernel]:
        return iter(KERNELS)

    def __len__(self) -> int:
        return len(KERNELS)

    def _made(self, kernel: Kernel) -> ca.Function:
        step_map, observation = self._step_map, self._observation
        if kernel in NEWTON:
            return _newton(step_map, kernel, NEWTON[kernel])
        if kernel.n_rk:
            makers = {
                Kind.RESIDUAL: step_map.residual,
                Kind.JACOBIAN: step_map.jacobian,
                Kind.JACOBIAN_ALONG: step_map.jacobian_along,
                Kind.TRACE: observation.trace,
            }
            return makers[kernel.kind](kernel.n_rk)
        owner = observation if kernel in (ADVANCE, OBSERVED_SWING) else step_map
        return getattr(owner, kernel.kind.value)


def _newton(step_map: StepMap, kernel: Kernel, method: Newton) -> ca.Function:
    """(u0, p) -> (u, R) or (u, J, R)."""
    u0, p = ca.MX.sym("u0", step_map.nz + 1), ca.MX.sym("p", step_map.n_params)
    u = step_map.rootfinder(
        method.n_rk, method.iterations, method.abstol, method.abstol_step, method.jacobian_n_rk
    )(u0, p)
    closing = step_map.residual if method.closing.kind == Kind.RESIDUAL else step_map.jacobian
    outputs = closing(method.n_rk).call([u, p])
    names = closing(method.n_rk).name_out()
    return ca.Function(c_name(step_map.model, kernel), [u0, p], [u, *outputs], ["u0", "p"], ["u", *names])


def c_source(model: Model) -> str:
    """The kernels as one C file with `DRIVER`, which maps a kernel over an array of points.

    Parameters
    ----------
    model : Model
    """
    generator = ca.CodeGenerator(kernels_file(model.name), {"with_header": False})
    for kernel in Catalogue(model).values():
        generator.add(kernel)
    banner = (
        f"/* {model.title}: kernels of the solver\n"
        f" * Printed by CasADi {ca.__version__} from equations {model.hash[:16]}.\n"
        " * Do not edit: run `stridemap derive`.\n * SPDX-License-Identifier: BSD-3-Clause\n */\n"
    )
    text = banner + generator.dump() + DRIVER.replace("MODEL", model.name)
    if "#error" in text:
        raise RuntimeError(f"CasADi could not print every kernel of {model.name} as C")
    return text


PLAIN_PIECES = ("plain_begin", "plain_swing", "plain_end")
"""What the functions of `plain_pieces_source` are called, after the model's name."""


def plain_pieces_source(model: Model) -> str:
    """Pieces of a step without tangents, as C that is printed when it is needed.

    Parameters
    ----------
    model : Model
    """
    generator = ca.CodeGenerator("pieces.c", {"with_header": False})
    for piece in StepMap(model).plain_pieces():
        generator.add(piece)
    return str(generator.dump())


DRIVER = """
/* Map a kernel over an array of points: point i reads in[j] + i*in_size[j] (a size of 0 repeats one input
 * for all points) and writes out[j] + i*out_size[j]. failed[i] is the kernel's return value.
 * work_size: lengths of arg, res, iw, w. Returns 0, or 1 when there is no memory. */
#include <stdlib.h>

typedef int (*MODEL_kernel)(const double** arg, double** res, casadi_int* iw, double* w, int mem);

CASADI_SYMBOL_EXPORT int MODEL_map(MODEL_kernel kernel, const casadi_int* work_size, casadi_int n,
    casadi_int n_in, const double* const* in, const casadi_int* in_size,
    casadi_int n_out, double* const* out, const casadi_int* out_size, int* failed)
{
    const double** arg = (const double**) malloc((size_t) work_size[0] * sizeof(double*));
    double** res = (double**) malloc((size_t) work_size[1] * sizeof(double*));
    casadi_int* iw = (casadi_int*) malloc((size_t) (work_size[2] + 1) * sizeof(casadi_int));
    double* w = (double*) malloc((size_t) (work_size[3] + 1) * sizeof(double));
    const int ready = arg && res && iw && w;
    casadi_int i, j;
    if (ready) {
        for (i = 0; i < n; i++) {
            for (j = 0; j < n_in; j++) arg[j] = in[j] + i * in_size[j];
            for (j = 0; j < n_out; j++) res[j] = out[j] + i * out_size[j];
            failed[i] = kernel(arg, res, iw, w, 0);
        }
    }
    free(arg);
    free(res);
    free(iw);
    free(w);
    return ready ? 0 : 1;
}
"""
