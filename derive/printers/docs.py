"""A worked C program and a README for the generated folder of one walker."""

import textwrap
from collections.abc import Iterable

from stridemap.derive.declaration import Declaration
from stridemap.derive.motors import record
from stridemap.derive.printers.c import REAL, banner, signature
from stridemap.derive.printers.printer import Equations
from stridemap.derive.program import Program

CALLED = (
    "section_state", "mass_matrix", "kinetic_energy", "potential_energy", "ground_force", "state_derivative",
    "impact_map",
)  # fmt: skip
"""The functions that the example calls."""


def example(equations: Equations) -> str:
    """A C program that takes one Euler step and one touchdown with the readable functions."""
    walker = equations.walker
    name, n = walker.name, len(walker.coordinates)
    by_name = {p.name: p for p in equations.programs}
    preset = ", ".join(repr(a.default) for a in walker.parameters)
    names = ", ".join(a.name for a in walker.parameters)
    parameters = [
        f"    /* the preset: {names} */",
        f"    const {REAL} p[{len(walker.parameters)}] = {{{preset}}};",
    ]
    if not walker.parameters:
        parameters = [f"    const {REAL} *p = 0; /* there are no parameters */"]
    start = [_inside(walker.search_box[s]) for s in walker.section_names]

    def call(function: str, *outputs: str) -> str:
        inputs = [a.name for a in by_name[function].signature]
        return f"    {name}_{function}({', '.join([*inputs, *outputs])});"

    lines = [
        *banner(equations),
        "/* How to call the equations from C. Build and run:",
        f" *   cc -std=c99 example.c {name}.c -lm -o example && ./example",
        " */",
        f'#include "{name}.h"',
        "",
        "#include <stdio.h>",
        "",
        "int main(void)",
        "{",
        *parameters,
        *_torques_of_example(walker),
        f"    /* a state just after touchdown: {', '.join(walker.section_names)} */",
        f"    const {REAL} z[{len(walker.section_names)}] = {{{', '.join(f'{v:g}' for v in start)}}};",
        f"    const {REAL} t = 0, dt = 1e-3;",
        f"    {REAL} q[{n}], v[{n}], M[{n * n}], dq[{n}], dv[{n}], kinetic[1], potential[1];",
        f"    {REAL} force[2], q_plus[{n}], v_plus[{n}];",
        "    int i, j;",
        "",
        call("section_state", "q", "v"),
        call("mass_matrix", "M"),
        f"    for (i = 0; i < {n}; i++) {{",
        '        printf("M(%d,:) =", i + 1);',
        f"        for (j = 0; j < {n}; j++)",
        f'            printf(" % .6f", M[{n} * i + j]);',
        '        printf("\\n");',
        "    }",
        "",
        call("kinetic_energy", "kinetic"),
        call("potential_energy", "potential"),
        '    printf("energy = %.9f\\n", kinetic[0] + potential[0]);',
        call("ground_force", "force"),
        '    printf("ground force = %.6f %.6f\\n", force[0], force[1]);',
        "",
        "    /* one explicit Euler step of the swing phase */",
        call("state_derivative", "dq", "dv"),
        f"    for (i = 0; i < {n}; i++) {{",
        "        q[i] += dt * dq[i];",
        "        v[i] += dt * dv[i];",
        "    }",
        "",
        "    /* what a touchdown at this instant would do */",
        call("impact_map", "q_plus", "v_plus"),
        f"    for (i = 0; i < {n}; i++)",
        '        printf("q_plus[%d] = % .9f   v_plus[%d] = % .9f\\n", i, q_plus[i], i, v_plus[i]);',
        "    return 0;",
        "}",
        "",
    ]
    return "\n".join(lines)


def _torques_of_example(walker: Declaration) -> list[str]:
    if not walker.actuators:
        return [f"    const {REAL} *u = 0; /* there are no motors */"]
    # Only functions of given torques read them.
    return [f"    const {REAL} u[{len(walker.actuators)}] = {{0}};"]


def readme(equations: Equations) -> str:
    """What each file is and how to call the C."""
    walker, programs = equations.walker, equations.programs
    name = walker.name
    lines = [
        f"# {walker.title}: generated code",
        "",
        f"Written by {equations.generator} (`stridemap derive`); do not edit. Source of the model: "
        f"{walker.reference}.",
        "",
        "| file | what it is |",
        "| --- | --- |",
        f"| `{name}.h`, `{name}.c` | readable C99: one function per quantity, documented in the header |",
        f"| `{name}_step.h`, `{name}_step.c` | a function that takes a walking step, for a controller |",
        "| `example.c` | a complete C program that calls the equations |",
        f"| `{name}.py` | the same equations for any Python namespace (NumPy, CasADi, mpmath) |",
        f"| `{name}.js` | the same equations in JavaScript, for pages |",
        f"| `{name}_kernels.c` | what the solver runs, from CasADi: step map, Newton search, measures |",
        "| `manifest.json` | functions, argument order, shapes, units, parameters, hashes |",
        "",
        "## Call it from C",
        "",
        "```sh",
        f"cc -std=c99 example.c {name}.c -lm -o example && ./example",
        "```",
        "",
        "Vectors are plain arrays, matrices are row-major, a scalar result is an array of one. There is no",
        "allocation and no global state, so every function may be called from any thread. The header also",
        "compiles as C++.",
        "",
        "In single precision (a microcontroller): define `STRIDEMAP_FLOAT` for your own files and for",
        f"`{name}.c` and `{name}_step.c`. All numbers are `float` then, and the functions have names of",
        "their own, so that the two precisions do not link by mistake. Code that was written for the",
        "former prototypes, which differed from function to function, compiles with",
        "`STRIDEMAP_OLD_SIGNATURES` for one release.",
        "",
        "## Take a step",
        "",
        *_filled(
            f"`{name}_step` integrates one walking step from just after a touchdown, finds the next one "
            f"as stridemap's simulator does, and applies the impact; `{name}_swing` starts from any state "
            f"within a step. The status that they return says how the step ended. {_names(walker)}"
        ),
        "",
        "```c",
        *_call_of_step(walker),
        "```",
        "",
        *_filled(
            f"`stridemap derive {name} --out DIR --cycle stable`, or the path of a model file in place of "
            f"the name, writes a limit cycle beside these files: `{name}_cycle.h` has its parameters, its "
            "section point, period and multipliers, and its motion over phase."
        ),
        "",
        "## Arguments",
        "",
        "In C every function takes `t, q, v, u, p` in this order, whatever it reads (see the list below),",
        "and then its results; what it does not read may be a null pointer. Only `section_state` takes a",
        "point on the section and parameters, `z, p`. Functions of a model that",
        "`stridemap.load` returned take the same",
        f"arguments; those in `{name}.py` and `{name}.js` take what they read, in this order.",
        "",
        "| argument | entries, in order |",
        "| --- | --- |",
        f"| `q[{len(walker.coordinates)}]` | {_list(c.name for c in walker.coordinates)} |",
        f"| `v[{len(walker.coordinates)}]` | {_list('d' + c.name for c in walker.coordinates)} |",
        f"| `p[{len(walker.parameters)}]` | {_list(a.name for a in walker.parameters)} |",
        *_torque_row(walker),
        f"| `z[{len(walker.section_names)}]` | {_list(walker.section_names)} (just after touchdown) |",
        "| `t` | time since touchdown |",
        "",
        *_motors(walker),
        "## Functions",
        "",
        "| function | operations | what it computes | what it reads |",
        "| --- | --- | --- | --- |",
        *(
            f"| `{name}_{p.name}` | {p.operations} | {_lower(p.summary)} | {_list(_reads(p)) or 'nothing'} |"
            for p in programs
        ),
        "",
        "```c",
        *(line for p in programs for line in signature(name, p, ";")),
        "```",
        "",
    ]
    return "\n".join(lines)


def _filled(text: str) -> list[str]:
    """A paragraph as lines."""
    return textwrap.wrap(text, 100, break_long_words=False, break_on_hyphens=False)


def _names(walker: Declaration) -> str:
    """What has names in the header of the step function."""
    name, upper = walker.name, walker.name.upper()
    text = f"`{name}_step.h` also has names for places in arrays, such as `{upper}_"
    if not walker.parameters:
        return f"{text}Z_{walker.section_names[0]}`."
    first = walker.parameters[0].name
    return f"{text}P_{first}`, and a structure of the parameters, `{name}_parameters`."


def _call_of_step(walker: Declaration) -> list[str]:
    """How a step is taken."""
    name, most = walker.name, "1000"
    lines = [f"{REAL} p[{len(walker.parameters)}], z[{len(walker.section_names)}], period;"]
    given = "p"
    if walker.parameters:
        lines += [f"{name}_parameters walker;", "", f"{name}_parameters_preset(&walker);"]
        lines += [f"{name}_parameters_to_array(&walker, p);"]
    else:
        lines, given = [f"{REAL} z[{len(walker.section_names)}], period;", ""], "0"
    start = [_inside(walker.search_box[s]) for s in walker.section_names]
    lines += [
        f"z[{walker.name.upper()}_Z_{s}] = {v:g};" for s, v in zip(walker.section_names, start, strict=True)
    ]
    return [*lines, f"{name}_status status = {name}_step(z, {given}, 0.01, {most}, &period);"]


def _torque_row(walker: Declaration) -> list[str]:
    names = _list(motor.name for motor in walker.actuators)
    what = "torques of the motors; read by the forward dynamics only"
    if not names:
        return ["| `u` | nothing: there are no motors |"]
    return [f"| `u[{len(walker.actuators)}]` | {names} ({what}) |"]


def _motors(walker: Declaration) -> list[str]:
    """What the entries of ``u`` are."""
    if not walker.actuators:
        return []
    rows = []
    for i, motor in enumerate(record(walker, one) for one in walker.actuators):
        limit = "none" if motor.limit is None else f"{motor.limit:g} {motor.unit}"
        cells = (f"`u[{i}]`", motor.name, f"{motor.kind} in {motor.unit}", f"`{motor.drives}`", limit)
        rows.append(f"| {' | '.join(cells)} | {motor.efficiency:g} | {motor.meaning} |")
    return [
        "## Motors",
        "",
        f"The torques `u` are those of `{walker.name}_controller_torque`; times the rates of what they",
        f"drive, from `{walker.name}_motor_rates`, they are the motors' powers.",
        "",
        "| entry | motor | what it gives | what it drives | limit | efficiency | meaning |",
        "| --- | --- | --- | --- | --- | --- | --- |",
        *rows,
        "",
    ]


def _list(names: Iterable[str]) -> str:
    return ", ".join(f"`{n}`" for n in names)


def _reads(program: Program) -> list[str]:
    used = program.used
    return [e.symbol.name for a in program.arguments for e in a.entries if e.symbol in used]


def _lower(sentence: str) -> str:
    return sentence[0].lower() + sentence[1:]


def _inside(box: tuple[float, float]) -> float:
    """A plain number near the middle of a box, not in it, because the middle is often zero."""
    middle, half_width = box
    return round(middle + half_width / 6, 3)
