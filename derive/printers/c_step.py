"""One walking step in C: a header with names for what the arrays hold, and the function that takes the step.

It is built on the readable equations of `stridemap.derive.printers.c`, and like them it allocates nothing and
keeps nothing between calls.
"""

from collections.abc import Iterable

from stridemap.derive.declaration import Declaration
from stridemap.derive.motors import record
from stridemap.derive.printers.c import REAL, aligned, array, banner, wrapped
from stridemap.derive.printers.c_step_source import SOURCE
from stridemap.derive.printers.printer import Equations

STATUS = (
    ("TOUCHDOWN", "the swing foot has touched down ahead"),
    ("NO_TOUCHDOWN", "it has not within the time that was allowed"),
    ("ROCKS_BACK", "the walker came back onto the foot behind"),
    ("STOPS", "the walker stands still on both feet"),
    ("FALLS_FORWARD", "the walker has fallen ahead"),
    ("FALLS_BACKWARD", "the walker has fallen back"),
    ("NOT_FINITE", "the motion leaves the range of numbers, or the start is outside it"),
    ("NOT_ALLOWED", "dt is not above 0, or there is less than one integration step"),
)
"""How a step ends: names in C without the model's, in the order of their values from 0."""

SWING = (
    "Motion from any state in the swing phase up to the touchdown that ends it.",
    """On return t, q and v are those just before the touchdown, or those at which the motion ended otherwise.
Touchdown, falls and rocking back are those of stridemap's simulator. The condition is looked at after each
integration step, with its rate, and a zero between two of them is located to rounding.""",
    (
        ("inout", "t", "time since the last touchdown"),
        ("inout", "q, v", "coordinates and rates"),
        ("in", "p", "parameters"),
        ("in", "dt", "length of an integration step (Runge-Kutta method of order 5)"),
        ("in", "most", "integration steps after which it is given up"),
    ),
)
STEP = (
    "One walking step: from just after one touchdown to just after the next, with the legs swapped.",
    """Where it does not end with a touchdown, z stays as it is, and period is the time at which the motion
ended. As in the simulator, the walk goes on where the ground would have to pull.""",
    (
        ("inout", "z", "point on the section, just after touchdown"),
        ("in", "p", "parameters"),
        ("in", "dt", "length of an integration step (Runge-Kutta method of order 5)"),
        ("in", "most", "integration steps after which it is given up"),
        ("out", "period", "time from one touchdown to the next (a single number)"),
    ),
)


CALLED = r"""
/* -- what callers call -------------------------------------------------------------------------------- */

@swing@
{
    moment at;
    int how;

    if (!(dt > REAL(0.0) && dt <= LARGEST) || most < 1)
        return @MODEL@_NOT_ALLOWED;
    at.t = *t;
    for (int i = 0; i < N; i++) {
        at.q[i] = q[i];
        at.v[i] = v[i];
    }
    how = swing_phase(&at, p, dt, most);
    *t = at.t;
    for (int i = 0; i < N; i++) {
        q[i] = at.q[i];
        v[i] = at.v[i];
    }
    return (@model@_status) how;
}

@step@
{
    moment at, next;
    int how;

    *period = REAL(0.0);
    if (!(dt > REAL(0.0) && dt <= LARGEST) || most < 1)
        return @MODEL@_NOT_ALLOWED;
    at.t = REAL(0.0);
    @model@_section_state(z, p, at.q, at.v);
    how = swing_phase(&at, p, dt, most);
    *period = at.t;
    if (how != @MODEL@_TOUCHDOWN)
        return (@model@_status) how;
    next.t = REAL(0.0);
    @model@_impact_map(at.t, at.q, at.v, 0, p, next.q, next.v);
    if (!is_finite(&next))
        return @MODEL@_NOT_FINITE;
@landed@
    return @MODEL@_TOUCHDOWN;
}
"""
"""What callers call, behind the rest of the source."""


def step_header(equations: Equations) -> str:
    """The header file: places in the arrays, parameters by name, statuses, and the two functions."""
    walker, upper = equations.walker, equations.model.upper()
    guard = f"STRIDEMAP_{upper}_STEP_H"
    lines = [*banner(equations, "a walking step"), f"#ifndef {guard}", f"#define {guard}", ""]
    lines += [f'#include "{equations.model}.h"', "", "#ifdef STRIDEMAP_FLOAT"]
    lines += [
        f"#define {equations.model}_{name} {equations.model}_{name}_float" for name in ("swing", "step")
    ]
    lines += ["#endif", "", "#ifdef __cplusplus", 'extern "C" {', "#endif", ""]
    lines += [*_places(walker), *_parameters(walker), *_status(walker)]
    for declared, (summary, text, arguments) in ((_swing(walker), SWING), (_step(walker), STEP)):
        lines += [f"/** {summary}", " *", *(f" * {line}" for line in text.splitlines()), " *"]
        lines += [f" *  {kind:<5} {name:<7} {meaning}" for kind, name, meaning in arguments]
        lines += [" */", *_ended(declared, ";"), ""]
    lines += ["#ifdef __cplusplus", "}", "#endif", "", f"#endif /* {guard} */", ""]
    return "\n".join(lines)


def step_source(equations: Equations) -> str:
    """The source file of the two functions."""
    walker = equations.walker
    middle = ", ".join(f"REAL({float(walker.search_box[name][0])!r})" for name in walker.section_names)
    autonomous = walker.phase is None and not any(
        program.name == "state_derivative" and "t" in (a.name for a in program.arguments)
        for program in equations.programs
    )
    fall, down = "the centre of mass is on the ground", "com[1] <= REAL(0.0)"
    if walker.stance_angle is not None:
        fall = "the stance leg is beyond the horizontal"
        place = walker.coordinates.index(walker.stance_angle)
        down = f"FABS(at->q[{place}]) > REAL(1.5707963267948966)"
    filled = {
        "model": walker.name,
        "MODEL": walker.name.upper(),
        "n": str(len(walker.coordinates)),
        "nz": str(len(walker.section_names)),
        "middle": middle,
        "autonomous": str(int(autonomous)),
        "fall": fall,
        "down": down,
        "swing": "\n".join(_swing(walker)),
        "step": "\n".join(_step(walker)),
        "landed": "\n".join(_landed(walker)),
    }
    text = SOURCE + CALLED
    for name, value in filled.items():
        text = text.replace(f"@{name}@", value)
    return "\n".join(
        [
            *banner(equations, "a walking step"),
            *(part for line in text.lstrip().split("\n") for part in _fit(line)),
        ]
    )


def _fit(line: str) -> list[str]:
    return wrapped(line) if len(line) > 110 else [line]


def _places(walker: Declaration) -> list[str]:
    """Enumerations of what each array holds; names of the user's stand behind a prefix, as they are."""
    counts = [("P", len(walker.parameters), "parameters"), ("Q", len(walker.coordinates), "coordinates")]
    counts += [
        ("U", len(walker.actuators), "motors"),
        ("Z", len(walker.section_names), "entries of a section point"),
    ]
    lines = ["/** Numbers of entries. */", "enum {"]
    lines += aligned([(f"{walker.name.upper()}_N_{x} = {n}", meaning) for x, n, meaning in counts])
    lines += ["};", ""]
    known = {c.name: (c.unit, c.meaning) for c in walker.coordinates}
    known |= {c.rate.name: (walker.units.rate(c.unit), f"rate of {c.name}") for c in walker.coordinates}
    motors = [record(walker, one) for one in walker.actuators]
    arrays = [
        ("P", "parameter in the array p", [(a.name, a.unit, a.meaning) for a in walker.parameters]),
        (
            "Q",
            "coordinate in q, and of its rate in v",
            [(c.name, c.unit, c.meaning) for c in walker.coordinates],
        ),
        ("U", "motor's torque in u", [(m.name, m.unit, m.meaning) for m in motors]),
        ("Z", "entry of a section point z", [(s, *known[s]) for s in walker.section_names]),
    ]
    for letter, what, entries in arrays:
        if entries:
            lines += [f"/** Place of each {what}. */", "enum {"]
            prefix = f"{walker.name.upper()}_{letter}_"
            lines += aligned([(f"{prefix}{name}", f"[{unit}] {meaning}") for name, unit, meaning in entries])
            lines += ["};", ""]
    return lines


def _parameters(walker: Declaration) -> list[str]:
    """The parameters as a structure, with the preset, and the ways to the array and back."""
    if not walker.parameters:
        return []
    name, size = walker.name, len(walker.parameters)
    width = max(len(a.name) for a in walker.parameters) + 1
    lines = [
        "/** Parameters by name, in the order of the array p. */",
        f"typedef struct {name}_parameters {{",
    ]
    lines += [f"    {REAL} {a.name + ';':<{width}} /* [{a.unit}] {a.meaning} */" for a in walker.parameters]
    lines += [f"}} {name}_parameters;", ""]
    ways = [
        ("preset", [f"{name}_parameters *named"], "named->{a} = ({real}) {default!r};"),
        ("to_array", [f"const {name}_parameters *named", f"{REAL} p[{size}]"], "p[{i}] = named->{a};"),
        ("from_array", [f"{name}_parameters *named", f"const {REAL} p[{size}]"], "named->{a} = p[{i}];"),
    ]
    for way, arguments, assignment in ways:
        lines += [*_head("static inline void", f"{name}_parameters_{way}", arguments), "{"]
        for i, a in enumerate(walker.parameters):
            one = assignment.format(i=i, a=a.name, real=REAL, default=float(a.default))
            lines.append(f"    {one}")
        lines += ["}", ""]
    return lines


def _status(walker: Declaration) -> list[str]:
    name, upper = walker.name, walker.name.upper()
    entries = [
        (f"{upper}_{word}" + (" = 0" if i == 0 else ""), text) for i, (word, text) in enumerate(STATUS)
    ]
    head = ["/** How a swing phase or a walking step ended. */", f"typedef enum {name}_status {{"]
    return [*head, *aligned(entries), f"}} {name}_status;", ""]


def _swing(walker: Declaration) -> list[str]:
    n = len(walker.coordinates)
    arguments = [f"{REAL} *t", f"{REAL} q[{n}]", f"{REAL} v[{n}]", *_given(walker)]
    return _head(f"{walker.name}_status", f"{walker.name}_swing", arguments)


def _step(walker: Declaration) -> list[str]:
    arguments = [f"{REAL} z[{len(walker.section_names)}]", *_given(walker), f"{REAL} *period"]
    return _head(f"{walker.name}_status", f"{walker.name}_step", arguments)


def _given(walker: Declaration) -> list[str]:
    return [array(f"const {REAL}", "p", len(walker.parameters)), f"{REAL} dt", "int most"]


def _head(kind: str, name: str, arguments: Iterable[str]) -> list[str]:
    """The head of a function, as lines; a line does not break within an argument."""
    hard = "\N{NO-BREAK SPACE}"
    text = f"{kind} {name}".replace(" ", hard) + f"({', '.join(a.replace(' ', hard) for a in arguments)})"
    return [line.replace(hard, " ") for line in wrapped(text)]


def _ended(lines: list[str], end: str) -> list[str]:
    return [*lines[:-1], lines[-1] + end]


def _landed(walker: Declaration) -> list[str]:
    """The section point from the state after the impact; a clock's phase stays within one turn."""
    places = {c.name: f"next.q[{i}]" for i, c in enumerate(walker.coordinates)}
    places |= {c.rate.name: f"next.v[{i}]" for i, c in enumerate(walker.coordinates)}
    lines = []
    for i, name in enumerate(walker.section_names):
        value = places[name]
        if walker.phase is not None and name == walker.phase.name:
            turn = "REAL(6.283185307179586)"
            value = f"{value} - {turn} * FLOOR(({value} + REAL(1e-6)) / {turn})"
        lines += [f"    z[{i}] = {value};"]
    return lines
