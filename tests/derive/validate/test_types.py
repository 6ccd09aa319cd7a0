"""Whatever stands in whichever field: a declaration, or one sentence; and names that a model cannot have."""

import pytest
import sympy as sp

from stridemap.derive import Term, UnitNames, rolling_arc, solve
from stridemap.derive.models import WALKERS
from stridemap.derive.validate.model_name import LONGEST
from stridemap.errors import InputError
from tests.fuzz.inputs import PLACES, changed

COMPASS = WALKERS["compass"]
ANGLE = COMPASS.q[0]
WRONG = (
    3,
    None,
    "x",
    (),
    {},
    [],
    object(),
    2.5,
    True,
    "a\nb",
    b"x",
    float("nan"),
    10**400,
    sp.nan,
    sp.oo,
    {1},
    int,
)


FIRST = list({tuple("#" if isinstance(key, int) else key for key in path): (name, path)
              for name, path in reversed(PLACES)}.values())  # fmt: skip
"""One place of each kind: of which parameter, body or model it is does not matter."""

SOME = 4
"""Things that are tried in a further place of a kind; together such places see all of them."""


def things(place):
    """What is put into a place: everything into the first of its kind, some in turn into the others."""
    if place in FIRST:
        return WRONG
    begin = SOME * PLACES.index(place)
    return [WRONG[(begin + i) % len(WRONG)] for i in range(SOME)]


@pytest.mark.parametrize("place", PLACES, ids=lambda place: f"{place[0]} {'.'.join(map(str, place[1]))}")
def test_any_thing_in_any_field_is_refused_in_a_sentence_or_allowed(place):
    name, (field, *inside) = place
    walker = WALKERS[name]
    value = getattr(walker, field)
    refusals = 0
    for wrong in things(place):
        thing = wrong
        if inside:
            key, *inner = inside
            part = value if key is None else value[key]
            made = changed(part, inner[0], wrong) if inner else wrong
            thing = made if key is None else made_up(value, key, made)
        try:
            walker.with_(**{field: thing})
        except InputError as error:
            refusals += 1
            assert str(error).startswith("model ")
            assert "\n" not in str(error)
            assert len(str(error)) <= 700
    assert refusals >= 10 or place not in FIRST  # most things are wrong anywhere


def made_up(value, key, made):
    return (*value[:key], made, *value[key + 1 :]) if isinstance(value, tuple) else {**value, key: made}


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"units": 3}, "units is 3, which is not a UnitNames"),
        ({"units": UnitNames(mass=3)}, "the mass of the units is 3; it must be a text"),
        ({"massless": 3}, "massless is 3, which is not a Massless"),
        ({"title": None}, "title is None; it must be a text"),
        ({"name": 3}, "model without a name: name is 3; it must be a text"),
        ({"name": "two\nlines"}, "cannot be a name in generated code"),
        ({"dissipation": sp.nan}, "the dissipation is nan, which is not finite"),
        ({"dissipation": sp.Function("f")(COMPASS.q[0])}, "not made of numbers, symbols and functions alone"),
        ({"sources": {3: "x"}}, "sources names 3, which is not a text"),
        ({"torques": {COMPASS.coordinates[0]: object()}}, "the torque on theta1 is <object object"),
    ],
)
def test_sentences(changes, words):
    with pytest.raises(InputError) as error:
        COMPASS.with_(**changes)
    assert words in str(error.value)


def test_an_expression_that_is_nested_too_deeply():
    deep = COMPASS.coordinates[0].symbol
    for _ in range(3000):
        deep = sp.sin(deep, evaluate=False)
    with pytest.raises(InputError, match="nested too deeply"):
        COMPASS.with_(dissipation=deep)


TAKEN = """
class main I errno stdin assert bool NULL M_PI INFINITY NAN printf exit double this new delete namespace int
template lambda yield None True import let function var await typeof math complex string time limits numpy
sympy casadi stridemap sys os json types readme README MANIFEST example con NUL aux com1 lockstep
"""


@pytest.mark.parametrize("name", TAKEN.split())
def test_names_that_a_model_cannot_have(name):
    with pytest.raises(InputError, match=f"model {name}: "):
        COMPASS.with_(name=name)


@pytest.mark.parametrize("name", ["a" * (LONGEST + 1), "a" * 300, "a" * 1_000_000])
def test_names_that_are_too_long(name):
    with pytest.raises(InputError, match=f"has {len(name)} characters; at most {LONGEST} are allowed"):
        COMPASS.with_(name=name)


def test_names_that_a_model_can_have():
    for name in ("walker", "a" * LONGEST, "Walker", "my_wobbling", "M", "x1"):
        assert COMPASS.with_(name=name).name == name


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: Term("two\nlines", ANGLE**2), "a Term has the name 'two"),
        (lambda: Term("*/", ANGLE**2), "a Term has the name '\\*/'"),
        (lambda: Term("_hidden", ANGLE**2), "a Term has the name '_hidden'"),
        (lambda: Term(3, ANGLE**2), "a Term has the name 3"),
        (
            lambda: Term("a", None),
            "what the Term 'a' stands for is None; it must be a single SymPy expression",
        ),
        (lambda: Term("a", [ANGLE]), "must be a single SymPy expression"),
        (lambda: Term("a", "theta1"), "must be a single SymPy expression"),
        (lambda: COMPASS.rate(COMPASS.coordinates[0]), "take its symbol"),
        (lambda: COMPASS.rate(sp.eye(2)), "give an expression or a single column"),
        (lambda: COMPASS.jacobian(None), "what jacobian or rate was given is None"),
        (lambda: solve(3, sp.Matrix([1])), "what solve was given first is 3; it must be a sympy.Matrix"),
        (lambda: solve(sp.eye(2), [1, 2]), "it must be a sympy.Matrix"),
        (
            lambda: rolling_arc(COMPASS.parameters[0], ANGLE),
            "the radius of rolling_arc is Parameter.*take its",
        ),
        (lambda: rolling_arc(0.2, "angle"), "the angle of rolling_arc is 'angle'"),
        (lambda: Term("a", ANGLE * sp.Integer(10) ** 5000), "too large or too small for double precision"),
        (
            lambda: COMPASS.with_(dissipation=sp.Integer(10) ** 5000),
            "dissipation has a number that is too large",
        ),
        (lambda: COMPASS.with_(potentials={"a": ANGLE / sp.Integer(10) ** 400}), "too large or too small"),
        (lambda: COMPASS.with_(colour=3), "with_ was given colour, which a Walker does not have"),
    ],
)
def test_what_declarations_are_written_with_refuses_in_a_sentence(call, words):
    with pytest.raises(InputError, match=words):
        call()
