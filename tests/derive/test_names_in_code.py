"""Each name in generated code, as the name of a parameter: refused at once, or the same numbers."""

import re
import time

import numpy as np
import pytest
import sympy as sp

from stridemap.codegen import generated_folder
from stridemap.derive import Parameter, Term
from stridemap.derive.emit import emit
from stridemap.derive.models import WALKERS
from stridemap.derive.validate.reserved import meaning
from stridemap.errors import InputError
from tests.derive.test_clashes import evaluated, point
from tests.oracles.rewritten import unsimplified

WHEEL = WALKERS["rimless_wheel"]
WORD = re.compile(r"[A-Za-z_]\w*")
NO_CODE = {
    **dict.fromkeys((".c", ".h", ".js"), re.compile(r'/\*.*?\*/|//[^\n]*|"[^"\n]*"', re.DOTALL)),
    ".py": re.compile(r'""".*?"""|#[^\n]*', re.DOTALL),
}
"""Comments and texts, of whose words none can be taken for a name."""
AT_ONCE = 130
"""Names given to one walker."""


def words():
    """Identifiers in the code of small models, as they are for this one, and terms of larger ones.

    Those of the step function in C have a test of their own.
    """
    found = set()
    for model in ("rimless_wheel", "compass"):
        for path in (generated_folder() / model).iterdir():
            if path.suffix in NO_CODE and not re.search("_kernels|_step", path.name):
                code = NO_CODE[path.suffix].sub(" ", path.read_text())
                found |= {re.sub(rf"^{model}(?=_|$)", "clashing", word) for word in WORD.findall(code)}
    return sorted(found | {f"t{i}" for i in range(1, 9)} | {f"held_{i}" for i in range(1, 4)})


def with_parameters(names):
    """The wheel with a spring whose stiffness is a sum of parameters of these names."""
    (theta,) = WHEEL.coordinates
    extra = tuple(Parameter(name, 0.1 + 0.01 * i, "1", "a parameter") for i, name in enumerate(names))
    # One term of all of them: each function reads them all, and what is derived from it stays short.
    stiffness = Term("of_all", sp.Add(*(sp.Rational(i + 2, 7) * a.symbol for i, a in enumerate(extra))))
    return WHEEL.with_(
        name="clashing",
        parameters=(*WHEEL.parameters, *extra),
        drawing=(),
        potentials={"spring": stiffness * (1 - sp.cos(theta.symbol)) + extra[0].symbol * theta.symbol**2},
    )


def refused_at_once(word):
    """Whether it means something, or is a variant of a function of this very walker."""
    return meaning(word) is not None or re.match("clashing_(old_|.*_float$)", word) is not None


def test_no_name_collides_with_what_the_generator_writes(monkeypatch):
    own = {"theta", "dtheta", *(a.name for a in WHEEL.parameters)}
    found = [word for word in words() if not word.startswith("_")]
    free = [word for word in found if word not in own and not refused_at_once(word)]
    for name in [word for word in found if word not in free][::25]:
        begun = time.process_time()
        with pytest.raises(InputError, match=f"{name}.*(rename|choose another name)"):
            with_parameters([name])
        assert time.process_time() - begun < 1, name
    assert {"M", "h", "u", "mass", "length", "com", "foot", "weight", "c_theta", "M_11", "t1"} <= set(free)
    values = [0.2, 6.0, 2 / 3, *np.linspace(0.3, 2, AT_ONCE)]
    monkeypatch.setattr("tests.derive.test_clashes.point", lambda: {**point_of_wheel(), "p": values})
    wanted = evaluated(printed(with_parameters([f"plain_{i}" for i in range(AT_ONCE)])))
    for begin in range(0, len(free), AT_ONCE):
        names = free[min(begin, len(free) - AT_ONCE) :][:AT_ONCE]
        found = evaluated(printed(with_parameters(names)))
        assert found.keys() == wanted.keys()
        for key in wanted:
            np.testing.assert_allclose(found[key], wanted[key], rtol=1e-12, atol=1e-13, err_msg=str(key))


point_of_wheel = point


def printed(walker):
    """All files of a walker. What is shortened has the names that it had, so that the time is saved."""
    with unsimplified():
        return emit(walker, "test")[0]


def test_terms_of_the_users_may_be_called_like_those_of_the_generator():
    theta = WHEEL.coordinates[0]
    named = [
        Term(name, sp.sin(i + theta.symbol) * theta.rate) for i, name in enumerate(["M_11", "u", "t1", "h"])
    ]
    torque = sp.Add(*named) / (2 + named[0] ** 2)
    walker = WHEEL.with_(name="clashing", torques={theta: torque})
    found = evaluated(emit(walker, "test")[0])
    q, v = point()["q"][0], point()["v"][0]
    parts = [np.sin(i + q) * v for i in range(4)]
    wanted = sum(parts) / (2 + parts[0] ** 2)
    assert found["controller_torque", "u"] == pytest.approx(wanted, rel=1e-13)
