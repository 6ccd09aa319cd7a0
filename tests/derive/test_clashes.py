"""Parameters and coordinates called like results and terms of generated code: the numbers stay the same.

The rimless wheel with a spring and a damper is declared twice: once with plain names, and once with names
that the generator would use itself.
"""

import math
import subprocess
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sp

from stridemap.derive import Parameter
from stridemap.derive.emit import emit
from stridemap.derive.models import WALKERS

WHEEL = WALKERS["rimless_wheel"]
PLAIN = ("slope", "spokes", "lambda2", *(f"a{i}" for i in range(12)))
CLASHING = (
    # the field case: a coordinate `arm` makes the term `c_arm`
    ("c_arm", "M", "h", "d", "u", "mass", "length", "com", "foot", "weight", "M_11", "held_1", "t1", "dq",
     "A_11"),
    ("s_arm", "d", "c_slope", "s_slope", "acc_1", "force_1", "force", "zmp", "point", "kinetic", "t2", "t3",
     "after_1", "side", "v_plus"),
)  # fmt: skip


def wheel(coordinate, names):
    """The wheel with a spring and a damper, whose parameters and coordinate bear these names."""
    extra = tuple(Parameter(f"a{i}", 0.1 * i + 0.3, "1", "a parameter") for i in range(12))
    old = (*WHEEL.parameters, *extra)
    (theta,) = WHEEL.coordinates
    new_theta = type(theta)(coordinate, theta.unit, theta.meaning)
    new = tuple(
        Parameter(name, a.default, a.unit, a.meaning, a.lower, a.upper, a.lower_open)
        for name, a in zip(names, old, strict=True)
    )
    swap = dict(zip((a.symbol for a in old), (a.symbol for a in new), strict=True))
    swap |= {theta.symbol: new_theta.symbol, theta.rate: new_theta.rate}
    a = [one.symbol for one in extra]
    spring = (a[0] + a[1] * a[2] + a[3] / (1 + a[4] ** 2) + a[5] - a[6]) * (theta.symbol - a[7]) ** 2
    damper = (a[8] + a[9] * a[10] + a[11]) * theta.rate**2 / 2

    def renamed(value):
        return sp.sympify(value).xreplace(swap)

    return WHEEL.with_(
        name="clashing",
        coordinates=(new_theta,),
        parameters=new,
        bodies=tuple(
            type(b)(b.name, renamed(b.mass), renamed(b.position), renamed(b.inertia), renamed(b.angle))
            for b in WHEEL.bodies
        ),
        gravity=renamed(WHEEL.gravity),
        potentials={"spring": renamed(spring)},
        dissipation=renamed(damper),
        swing_foot=renamed(WHEEL.swing_foot),
        touchdown=type(WHEEL.touchdown)(renamed(WHEEL.touchdown.condition), renamed(WHEEL.touchdown.region)),
        relabel={renamed(k): renamed(e) for k, e in WHEEL.relabel.items()},
        stance_angle=new_theta,
        drawing=(),
        search_box={coordinate: (-0.5, 0.5), f"d{coordinate}": (0.5, 1.0)},
    )


@pytest.fixture(scope="module")
def plain():
    return evaluated(emit(wheel("theta", PLAIN), "test")[0])


def point():
    rng = np.random.default_rng(5)
    p = [0.2, 6.0, 2 / 3, *rng.uniform(0.3, 2, 12)]
    return {"t": 0.3, "q": [-0.3], "v": [0.7], "u": [0.4], "p": p, "z": [-0.3, 0.7]}


def evaluated(files):
    """Results of all functions of the Python module at a point, as flat lists."""
    scope = {}
    exec(files["clashing.py"], scope)
    names = {"sqrt": math.sqrt, "sin": math.sin, "cos": math.cos, "pi": math.pi}
    results = {}
    for name, function in scope.items():
        if callable(function):
            arguments = function.__code__.co_varnames[1 : function.__code__.co_argcount]
            found = function(SimpleNamespace(**names), *(point()[a] for a in arguments))
            results |= {(name, key): np.ravel(value) for key, value in found.items()}
    return results


@pytest.mark.parametrize("names", CLASHING, ids=["first", "second"])
def test_the_numbers_are_those_of_the_same_walker_with_plain_names(names, plain, tmp_path):
    files, spec = emit(wheel("arm", names), "test")
    found = evaluated(files)
    assert found.keys() == plain.keys()
    for key in plain:
        np.testing.assert_allclose(found[key], plain[key], rtol=1e-12, atol=1e-13, err_msg=str(key))
    for file in ("clashing.c", "clashing.h"):
        (tmp_path / file).write_text(files[file])
    (tmp_path / "main.c").write_text(main(spec))
    flags = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror"]
    built = [*flags, "main.c", "clashing.c", "-lm", "-o", "main"]
    done = subprocess.run(["cc", *built], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    printed = subprocess.run([tmp_path / "main"], capture_output=True, text=True, check=True).stdout
    values = np.array(printed.split(), dtype=float)
    np.testing.assert_allclose(values, np.concatenate(list(found.values())), rtol=1e-12, atol=1e-13)


def main(spec):
    """A C program that prints all results at the point."""
    lines = ['#include "clashing.h"', "#include <stdio.h>", "int main(void) {", "    int i;"]
    for name, values in point().items():
        given = ", ".join(map(repr, map(float, np.ravel(values))))
        lines.append(f"    const double {name}[] = {{{given}}};")
    for name, function in spec.functions.items():
        given = ["t[0]" if a == "t" else a for a in function.signature]
        sizes = {f"{name}_{o.name}": math.prod(o.shape) for o in function.outputs}
        lines += [f"    double {o}[{size}];" for o, size in sizes.items()]
        lines.append(f"    clashing_{name}({', '.join([*given, *sizes])});")
        lines += [
            f'    for (i = 0; i < {size}; i++) printf("%.17g\\n", {o}[i]);' for o, size in sizes.items()
        ]
    used = {a for f in spec.functions.values() for a in f.signature}
    lines += [f"    (void) {name};" for name in point() if name not in used]
    return "\n".join([*lines, "    return 0;", "}", ""])
