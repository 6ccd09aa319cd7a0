"""The translation of generated Python into JavaScript means the same, or is refused."""

import ast

import pytest

from stridemap.derive.printers.javascript import function


def test_a_reserved_word_is_renamed():
    source = 'def f(xp, q):\n    """Doc."""\n    new = q[0]\n    return {"y": [new*xp.sin(new), 1/2]}'
    assert function(ast.parse(source).body[0]) == (
        "f(xp, q) {\n  const new_ = q[0];\n  return {'y': [new_ * xp.sin(new_), 1 / 2]};\n}"
    )


@pytest.mark.parametrize(
    "line",
    [
        "y = q[0]**2", "y = q[0]//2", "y = q[0] % 2", "y = xp.arcsin(q[0])", "y = abs(q[0])", "y = q.real",
        "y = q[1:]", "y = q[-1]", "y = True", "y = 1j", "y = 1 if q[0] else 2", "y = q[0] < 2",
        "y = (q[0], 1)", "y = xp.sin(q[0], 1)", "y += 1", "for y in q: pass", "y, z = q", "return y",
        "y = lambda: 1", "y: int = 1",
    ],
)  # fmt: skip
def test_what_could_mean_something_else_is_refused(line):
    source = f"def f(xp, q):\n    {line}\n    return {{'y': y}}"
    with pytest.raises(TypeError, match="in JavaScript"):
        function(ast.parse(source).body[0])
