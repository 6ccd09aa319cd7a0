"""Input that nobody writes on purpose: command lines, configurations and declarations, changed at random.

Each is made from a number, so that one that fails can be made again by itself.
"""

import random
import string
from dataclasses import fields, is_dataclass, replace

import sympy as sp

from stridemap.derive.declaration import Declaration
from stridemap.derive.models import WALKERS

WORDS = (
    "", " ", "0", "-1", "1", "2.5", "1e308", "-1e308", "1e999", "nan", "inf", "-inf", "1e-320", "0x10",
    "1_000", "9" * 400, "9" * 5000, "True", "None", "null", "[]", "{}", "x", "é", "\u2028", "\x1b[2J",
    "\ud800", "💥", "a b", "a\nb", "a\tb", "nowhere/at/all", "/dev/null", "/dev/zero", "~", "./.", "*",
    "%s", "{}", "{0.__class__}", "$HOME", "`id`", "'", '"', "\\", "--", "-", "---", "-x", "--set", "=",
    "==", "k=", "=k", "k==1", "a" * 300, "b/" * 3000, "c" * 100_000, "wobbling", "compass",
    "rimless_wheel", "NaN.py", "nowhere.py", "lanes", "scalar", "gpu", "A", "Z",
)  # fmt: skip
"""Values that have tripped some program before."""

OPTIONS = (
    "--model", "--set", "--starts", "--search", "--acceptance", "--backend", "--json", "--state",
    "--steps", "--group", "--cycle", "--fps", "--size", "--magnify", "--out", "--workers", "--resume",
    "--claims", "--sweeps", "--thin", "--check", "--only", "--help", "--derive-timeout", "--k", "--omega",
    "--alpha", "--beta", "--slope", "--version", "--vary", "--range", "--target", "--period-n", "--cascade",
    "--seeds", "--friction-limit", "--continuation", "--plot", "--show", "--from", "--trajectory", "--rate",
    "--search-box", "--x", "--y", "--colour", "--where", "--to", "--by", "--units", "--csv",
)  # fmt: skip
COMMANDS = (
    "orbit", "find", "branch", "simulate", "animate", "sweep", "report", "claims", "figures", "derive",
    "version", "plot", "export", "models", "completion",
)  # fmt: skip

LINES = (
    "orbit --model compass --starts 4 --json",
    "orbit --model wobbling --k 6 --alpha 0.25 --set omega=3 --starts 4 --search seed=1 --backend lanes",
    "orbit --model rimless_wheel --slope 0.2 --starts 4 --acceptance max_residual=1e-11",
    "simulate --model compass --state theta1=0.1 --state dtheta1=-0.2 --state dtheta2=0 --steps 1",
    "simulate --model rimless_wheel --steps 2 --json",
    "simulate --model compass --steps 1 --trajectory walk.csv --rate 50",
    "branch --model simplest_walker --vary slope --range 0.01 0.02 --seeds 1 --period-n 2 --cascade 1 --json",
    "branch --model compass --vary omega --range 2 3 --out b.parquet --plot b.svg --show cot --set S=0.2",
    "find --model rimless_wheel --target speed=0.45 --vary slope --range 0.05 0.2 --json",
    "animate --model compass --out a.gif --steps 2 --fps 10 --size 100 --magnify 2 --cycle 1",
    "sweep small.toml --out new --workers 1 --backend lanes",
    "sweep small.toml --out out --resume",
    "report out --out page.html --model compass",
    "report --sweeps paper --out page.html --thin 60 --set beta=0.2",
    "claims --sweeps paper --thin 60 --json --workers 1",
    "figures --out figures --only map --sweeps paper --thin 60",
    "derive model.py --out derived --derive-timeout 5",
    "derive --check",
    "plot out --x omega --y cot --colour group --where stable --out f.svg --units leg_length=1,mass=2",
    "export out --to nc --where omega<3 --by branch --out t.nc --model compass",
    "orbit --model compass --starts 4 --csv --units leg_length=0.75,mass=32",
    "models compass --json",
    "completion bash",
    "version",
)


def command_line(number):
    """Words after ``stridemap``: one of `LINES` with up to four changes."""
    chance = random.Random(f"line {number}")
    words = chance.choice(LINES).split()
    for _ in range(chance.randint(0, 4)):
        at = chance.randrange(len(words)) if words else 0
        match chance.randrange(9):
            case 0 if words:
                del words[at]
            case 1 if words:
                words.insert(at, words[at])
            case 2 if words:
                words[at] = chance.choice(WORDS)
            case 3:
                words.insert(at, chance.choice(WORDS))
            case 4:
                words[at:at] = [chance.choice(OPTIONS), chance.choice(WORDS)]
            case 5:
                words.append(f"{chance.choice(OPTIONS)}={chance.choice(WORDS)}")
            case 6 if words:
                words[at] = noise(chance, words[at])
            case 7 if words:
                name, equals, _ = words[at].partition("=")
                words[at] = f"{name}{equals or '='}{chance.choice(WORDS)}"
            case 8 if words:
                words[0] = chance.choice(COMMANDS)
    return [word.replace("\0", "") for word in words]  # no system passes these on


def noise(chance, text):
    """A text with a few characters changed."""
    characters = list(text)
    for _ in range(chance.randint(1, 3)):
        at = chance.randint(0, len(characters))
        match chance.randrange(3):
            case 0:
                del characters[at : at + chance.randint(1, 4)]
            case 1:
                characters.insert(at, chance.choice(string.printable + "é\u2028💥\x00\x7f"))
            case 2:
                characters[at:at] = characters[: chance.randint(0, 20)]
    return "".join(characters).replace("..", ".").lstrip("/")  # nothing is written elsewhere


CONFIGURATIONS = (
    'model = "compass"\n[grid]\nomega = [2.5, 3.0]\n[search]\nstarts = 16\n',
    'model = "wobbling"\nmax_cells = 1000\n[params]\nalpha = 0.25\n[grid]\n'
    "k = { start = 0.5, stop = 50, num = 12, spacing = \"log\" }\nomega = [2, 3]\n"
    "[search]\nsubgrid = { k = 2 }\nseed = 7\nperiod_min = 0.4\nperiod_max = 2\n"
    "[acceptance]\nmax_residual = 1e-10\n[continuation]\nmax_steps = 10\nds_max = 1.0\n",
    'model = "rimless_wheel"\n[grid]\nslope = { start = 0.1, stop = 0.3, num = 5 }\nspokes = [6, 7]\n',
)  # fmt: skip
VALUES = (
    "0", "-1", "1", "2.5", "1e308", "1e400", "nan", "inf", "-inf", "true", '"x"', "[]", "{}", "[[]]",
    "[{}]", "1979-05-27", "07:32:00", "0x10", "[1, 2, \"x\"]", "{ start = 1 }",
    "{ start = 1, stop = 2, num = 1_000_000_000 }", "9" * 400, "9" * 5000, "'" + "x" * 5000 + "'",
    "[" * 500, "[" * 5000, "{ start = 0, stop = 1, num = 3, spacing = \"log\" }", "''", '"""a\nb"""',
    '"\\u0000"', '"../../etc/passwd"', '"nowhere.py"', "[1, 1]", "-0.0", "1e-320", "[nan]", "[true]",
)  # fmt: skip


def configuration(number):
    """The bytes of a TOML file: one of `CONFIGURATIONS` with up to three changes."""
    chance = random.Random(f"toml {number}")
    lines = chance.choice(CONFIGURATIONS).split("\n")
    for _ in range(chance.randint(0, 3)):
        at = chance.randrange(len(lines))
        match chance.randrange(7):
            case 0:
                lines[at] = f"{lines[at].partition('=')[0]}= {chance.choice(VALUES)}"
            case 1:
                lines.insert(at, lines[at])
            case 2:
                del lines[at : at + 1]
            case 3:
                lines[at] = noise(chance, lines[at])
            case 4:
                lines.insert(
                    at,
                    f"{chance.choice(['k', 'num', 'model', 'seed', 'grid', 'x'])} = {chance.choice(VALUES)}",
                )
            case 5:
                lines.insert(
                    at, chance.choice(["[grid]", "[[grid]]", "[search]", "[a.b]", "]", "[params", "\ufeff"])
                )
            case 6:
                one, other = at, chance.randrange(len(lines))
                lines[one], lines[other] = lines[other], lines[one]
        lines = lines or [""]
    data = "\n".join(lines).encode("utf-8", "surrogatepass")
    if chance.random() < 0.05:
        data = data[: chance.randint(0, len(data))] + bytes(chance.randbytes(3)) + data[:10]
    return data


class Unprintable:
    """Something that cannot even be shown."""

    def __repr__(self):
        raise RuntimeError("cannot be shown")


x, theta = sp.Symbol("x"), sp.Symbol("theta", real=True)
THINGS = (
    3, -1, 0, 2.5, True, None, "x", "", "a\nb", "é", "class", "_", "a" * 300, "*/", (), (3,), (None,), [],
    [3], {}, {"x": 3}, {3: 3}, {theta: theta}, set(), object(), Unprintable(), int, len, float("nan"),
    float("inf"), 10**400, 1j, b"x", range(3), x, theta, sp.nan, sp.oo, sp.zoo, sp.I, sp.pi, sp.S.true,
    sp.Symbol("a b"), sp.Symbol("a\nb"), sp.Symbol("n", commutative=False), sp.Function("f")(theta),
    sp.floor(theta), sp.Mod(theta, 2), sp.Eq(theta, 1), theta > 1, sp.Matrix([theta]),
    sp.Matrix([[1, 2], [3, 4]]), sp.Matrix([sp.nan, 1]), sp.Matrix([theta, "x"]),
    sp.Derivative(sp.Function("f")(theta), theta), sp.Integral(theta, theta), sp.Sum(theta, (theta, 1, 3)),
    sp.Interval(0, 1), sp.Tuple(1, 2), sp.Lambda(theta, theta), sp.factorial(theta), sp.gamma(theta),
    sp.Heaviside(theta), sp.Piecewise((1, theta > 0), (0, True)), sp.Max(theta, 0), sp.DiracDelta(theta),
    sp.re(theta), sp.conjugate(x), sp.besselj(0, theta), theta**theta, sp.sqrt(-1 - theta**2),
    1 / sp.Integer(3), sp.Float(1e-300), sp.log(theta), sp.Order(theta),
)  # fmt: skip
"""What is put into fields that want something else."""


def places():
    """Every field of a declaration, and every field of every part in it."""
    for name in ("rimless_wheel", "wobbling", "simplest_walker"):
        walker = WALKERS[name]
        for one in fields(Declaration):
            value = getattr(walker, one.name)
            yield name, (one.name,)
            parts = list(enumerate(value)) if isinstance(value, tuple) else []
            parts += list(value.items()) if isinstance(value, dict) else []
            parts += [(None, value)] if is_dataclass(value) else []
            for key, part in parts:
                if key is not None:
                    yield name, (one.name, key)
                if is_dataclass(part):
                    for inner in fields(part):
                        yield name, (one.name, key, inner.name)


PLACES = tuple(places())


def declaration(number):
    """A declared walker with one field changed: the walker, the field's name and what it becomes."""
    chance = random.Random(f"walker {number}")
    name, (field, *inside) = chance.choice(PLACES)
    thing = chance.choice(THINGS)
    walker = WALKERS[name]
    value = getattr(walker, field)
    if inside:
        key, *inner = inside
        part = value if key is None else value[key]
        made = changed(part, inner[0], thing) if inner else thing
        if key is None:
            thing = made
        elif isinstance(value, tuple):
            thing = (*value[:key], made, *value[key + 1 :])
        else:
            thing = {**value, key: made}
    return walker, field, thing


def changed(part, field, thing):
    """A part with one field changed."""
    return replace(part, **{field: thing})
