"""The functions that the solver runs, by name, and their C.

`search_<n>`        Newton's method from a rough guess on n Runge-Kutta steps, with the residual there
`limit_cycle_<n>`   Newton's method from a good guess, with Jacobian and residual there
`residual_<n>`      the residual alone
`jacobian_<n>`      the residual with its Jacobian
`trace_<n>`         the states and observables at the n + 1 nodes of a step
`advance`           a part of a Runge-Kutta step, observed

In C every name begins with the model's, so that kernels of several models link into one program.

The same CasADi functions run in CasADi's virtual machine where there is no C compiler.
"""

from dataclasses import dataclass

import casadi as ca

from stridemap.solver.kernels.observation import Observation
from stridemap.solver.kernels.step_map import BLOCK, StepMap
from stridemap.solver.model.model import Model

SEARCH_STEPS = (12, 24, 48)
"""Resolutions of the search from rough guesses."""

CYCLE_STEPS = (24, 36, 48, 72, 96, 144, 192, 288, 384)
"""Resolutions of accepted limit cycles; each is checked at twice as many steps."""


@dataclass(frozen=True)
class Newton:
    """Newton's method as a kernel: (u0, p) -> (u, what `closing` computes there).

    Parameters
    ----------
    steps, jacobian_steps : int
        Resolutions of the residual and of its Jacobian.
    abstol, abstol_step : float
        It stops at this residual, or after a step of this size.
    iterations : int
        It stops after these in any case.
    closing : str
        Kernel: `residual_<n>` or `jacobian_<n>`.
    """

    steps: int
    jacobian_steps: int
    abstol: float
    abstol_step: float
    iterations: int
    closing: str


NEWTON = {
    **{f"search_{n}": Newton(n, n, 1e-12, 1e-4, 10, closing=f"residual_{n}") for n in SEARCH_STEPS},
    **{
        f"limit_cycle_{n}": Newton(n, n // 2 // BLOCK * BLOCK, 1e-14, 1e-9, 6, closing=f"jacobian_{n}")
        for n in CYCLE_STEPS
    },
}
"""The kernels that are Newton's method, by name."""

LOCKSTEP = (
    *(f"residual_{n}" for n in sorted({*SEARCH_STEPS, *CYCLE_STEPS})),
    *(
        f"jacobian_{n}"
        for n in sorted({*SEARCH_STEPS, *CYCLE_STEPS, *(m.jacobian_steps for m in NEWTON.values())})
    ),
    *(f"trace_{2 * n}" for n in CYCLE_STEPS),
    "advance",
)
"""The kernels without branches, which can work on many points in lockstep."""


def build(model: Model) -> dict[str, ca.Function]:
    """All kernels of a model, by name.

    Parameters
    ----------
    model : Model

    Returns
    -------
    dict of str to casadi.Function
    """
    step_map = StepMap(model)
    observation = Observation(step_map)
    kernels = [_newton(step_map, name, method) for name, method in NEWTON.items()]
    for name in LOCKSTEP:
        kind, _, n = name.partition("_")
        maker = {"residual": step_map.residual, "jacobian": step_map.jacobian, "trace": observation.trace}
        kernels.append(maker[kind](int(n)) if n else observation.advance)
    return {kernel.name().removeprefix(f"{model.name}_"): kernel for kernel in kernels}


def _newton(step_map: StepMap, name: str, method: Newton) -> ca.Function:
    """(u0, p) -> (u, R) or (u, J, R)."""
    u0, p = ca.MX.sym("u0", step_map.nz + 1), ca.MX.sym("p", step_map.n_params)
    u = step_map.rootfinder(
        method.steps, method.iterations, method.abstol, method.abstol_step, method.jacobian_steps
    )(u0, p)
    closing = step_map.residual if method.closing.startswith("residual") else step_map.jacobian
    outputs = closing(method.steps).call([u, p])
    names = closing(method.steps).name_out()
    return ca.Function(f"{step_map.model.name}_{name}", [u0, p], [u, *outputs], ["u0", "p"], ["u", *names])


def c_source(model: Model) -> str:
    """The kernels as one C file with `DRIVER`, which maps a kernel over an array of points.

    Parameters
    ----------
    model : Model
    """
    name = f"{model.name}_kernels"
    generator = ca.CodeGenerator(f"{name}.c", {"with_header": False})
    for kernel in build(model).values():
        generator.add(kernel)
    banner = (
        f"/* {model.title}: kernels of the solver\n"
        f" * Printed by CasADi {ca.__version__} from equations {model.hash[:16]}.\n"
        " * Do not edit: run `make derive`.\n * SPDX-License-Identifier: BSD-3-Clause\n */\n"
    )
    text = banner + generator.dump() + DRIVER.replace("MODEL", model.name)
    if "#error" in text:
        raise RuntimeError(f"CasADi could not print every kernel of {model.name} as C")
    return text


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
