"""Draw the rooms of the package and the way of the data, docs/images/rooms.svg: ``python docs/rooms.py``.

Which arrows there are, and which room stands above which, is read from the imports. An arrow leads from a
room to one that imports it, unless others lead there already.
"""

import sys
from dataclasses import replace
from html import escape
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "extensions"))

from import_graph import Package  # noqa: E402
from room_layout import LINE, PAD, Box, Drawing, chip_rows, place, words  # noqa: E402

PICTURE = HERE / "images" / "rooms.svg"

# What each room is for, in a few words, and the colour of its edge.
ROOMS = {
    "derive": ("declarations become equations, equations become code", "sympy"),
    "generated": ("what derive wrote: C, Python, JavaScript, kernels, manifest", "leaf"),
    "solver": ("limit cycles of a generated walker: arrays in, arrays out", "casadi"),
    "codegen": ("calls derive, writes generated, compiles kernels", "sympy"),
    "controller": ("C for a controller, with a limit cycle", "sympy"),
    "units": ("to SI units and back", "casadi"),
    "tables": ("tables read, selected from, written for others", "tables"),
    "sweeps": ("grids of parameters, tile by tile, into tables that can be trusted", "tables"),
    "views": ("plots, animations, and a sweep as a page to explore", "pictures"),
    "paper": ("one paper: its sweeps, its statements decided, its figures drawn", "pictures"),
    "cli": ("the command line: a file per command", "typer"),
    "errors": ("what fails", "leaf"),
    "services": ("asking upwards", "leaf"),
    "spec": ("what a model is", "leaf"),
    "quantities": ("measures", "leaf"),
    "words": ("taken names", "leaf"),
    "columns": ("of all tables", "leaf"),
}
SUBROOMS = {
    "api": ("what users call", "casadi"),
    "boundaries": ("bifurcations over two parameters", "casadi"),
    "branches": ("continuation, folds, stability's edges", "casadi"),
    "walks": ("many steps forward", "casadi"),
    "cycles": ("Newton, multipliers, search", "casadi"),
    "observables": ("events, measures, motion", "casadi"),
    "backends": ("SIMD lanes, scalar C, interpreter", "casadi"),
    "kernels": ("step map, Runge-Kutta, observation", "casadi"),
    "options": ("checked records", "casadi"),
    "linear": ("linear systems on arrays", "numpy"),
    "model": ("its specification and equations, wherever its files are", "casadi"),
}
WRITES = ("derive", "generated", "writes")
"""The one way of the data that is not an import."""

WIDTH, MARGIN, SIDE, GUTTER, GAP = 880.0, 20.0, 250.0, 60.0, 44.0
SUB_SIDE, SUB_GUTTER, SUB_GAP = 184.0, 36.0, 28.0
FLOOR = 92.0

STYLE = """
  svg { font-family: system-ui, -apple-system, "Segoe UI", "DejaVu Sans", Arial, sans-serif; }
  .paper { fill: #f8fafc; }
  .card { fill: #ffffff; stroke: #cbd5e1; } .inner { fill: #f1f5f9; stroke: #cbd5e1; }
  .name { fill: #0f172a; font-weight: 600; font-size: 15px; } .small { font-size: 13px; }
  .text, .count { fill: #475569; font-size: 12px; } .count { text-anchor: end; }
  .middle { text-anchor: middle; }
  .chip { fill: #f1f5f9; } .chiptext { fill: #334155; font-size: 11px; }
  .arrow { fill: none; stroke: #64748b; stroke-width: 1.6; marker-end: url(#head); } .head { fill: #64748b; }
  .writes { stroke-dasharray: 5 4; }
  .sympy { fill: #d97706; } .casadi { fill: #2563eb; } .tables { fill: #059669; }
  .pictures { fill: #9333ea; } .typer { fill: #db2777; } .leaf { fill: #64748b; }
  @media (prefers-color-scheme: dark) {
    .paper { fill: #0f172a; }
    .card { fill: #1e293b; stroke: #475569; } .inner { fill: #172033; stroke: #475569; }
    .name { fill: #f1f5f9; } .text, .count { fill: #cbd5e1; }
    .chip { fill: #334155; } .chiptext { fill: #e2e8f0; }
    .arrow { stroke: #94a3b8; } .head { fill: #94a3b8; }
    .sympy { fill: #f59e0b; } .casadi { fill: #60a5fa; } .tables { fill: #34d399; }
    .pictures { fill: #c084fc; } .typer { fill: #f472b6; } .leaf { fill: #94a3b8; }
  }
"""
LEGEND = (
    ("sympy", "needs SymPy"),
    ("casadi", "CasADi and NumPy"),
    ("tables", "pandas and pyarrow"),
    ("pictures", "matplotlib, when it draws"),
    ("typer", "typer and rich"),
    ("leaf", "the standard library only"),
)


def about(lines: int) -> str:
    """A number of lines to one digit, or two where the first is a 1."""
    digits = len(str(lines)) - (2 if str(lines)[0] == "1" and lines >= 100 else 1)
    return f"about {round(lines, -digits):,} lines"


# -- the whole ---------------------------------------------------------------------------------------------


def drawing(package: Package) -> tuple[Drawing, list[Box]]:
    """The rooms at their places, and the leaves below them."""
    whole = package.graph()
    leaves = whole.leaves()
    upper = whole.without(leaves)
    inside = package.graph("solver")
    subrooms = {room: Box(room, *SUBROOMS[room], count="") for room in inside.rooms}
    width = WIDTH - 2 * MARGIN
    wide = width - SIDE - GUTTER - 2 * PAD
    inner = place(inside, subrooms, wide, SUB_SIDE, SUB_GUTTER, SUB_GAP)
    boxes = {
        room: Box(
            room,
            *ROOMS[room],
            count=about(whole.lines(room)),
            chips=() if room == "solver" or whole.is_file(room) else packages(package, room),
            inner=inner if room == "solver" else None,
        )
        for room in upper.rooms
    }
    return place(upper, boxes, width, SIDE, GUTTER, GAP), [
        Box(room, *ROOMS[room], count="") for room in sorted(leaves, key=lambda r: (whole.levels()[r], r))
    ]


def packages(package: Package, room: str) -> tuple[str, ...]:
    """The folders in a room."""
    graph = package.graph(room)
    return tuple(sorted(sub for sub in graph.rooms if not graph.is_file(sub)))


# -- SVG ---------------------------------------------------------------------------------------------------


def rect(kind: str, x: float, y: float, width: float, height: float, radius: int) -> str:
    """A rectangle with round corners."""
    size = f'x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}"'
    return f'<rect class="{kind}" {size} rx="{radius}"/>'


def text(kind: str, x: float, y: float, content: str) -> str:
    """A line of text."""
    return f'<text class="{kind}" x="{x:.1f}" y="{y:.1f}">{escape(content)}</text>'


def svg_box(box: Box, dx: float, dy: float, inner: bool = False) -> list[str]:
    """A box with what is in it, moved."""
    x, y = box.x + dx, box.y + dy
    out = [
        rect("card", x, y, box.width, box.height, 7),
        rect(box.colour, x, y + 8, 4, box.height - 16, 2),
        text("name small" if inner else "name", x + PAD, y + 23, box.name),
    ]
    if box.count:
        out.append(text("count", box.right + dx - PAD, y + 23, box.count))
    at = y + 25
    for line in words(box.text, box.width - 2 * PAD):
        at += LINE
        out.append(text("text", x + PAD, at, line))
    at += 8
    for row in chip_rows(box.chips, box.width - 2 * PAD):
        left = x + PAD
        for chip, size in row:
            out += [rect("chip", left, at, size, 19, 9), text("chiptext", left + 7, at + 13, chip)]
            left += size + 6
        at += 24
    if box.inner:
        out += svg_drawing(box.inner, x + PAD, at + 2, inner=True)
    return out


def svg_drawing(drawn: Drawing, dx: float, dy: float, inner: bool = False) -> list[str]:
    """Boxes and arrows, moved."""
    out = [line for name in sorted(drawn.boxes) for line in svg_box(drawn.boxes[name], dx, dy, inner)]
    for edge in sorted(drawn.arrows):
        out.append(arrow(drawn.arrows[edge], dx, dy, f"{edge[0]} to {edge[1]}"))
    return out


def arrow(points: list[tuple[float, float]], dx: float, dy: float, title: str, kind: str = "arrow") -> str:
    """A polyline with a head, which ends just before its target."""
    *rest, (x, y) = [(px + dx, py + dy) for px, py in points]
    back = (x, y + 7) if rest[-1][0] == x else (x - 7 if x > rest[-1][0] else x + 7, y)
    path = " L ".join(f"{px:.1f} {py:.1f}" for px, py in [*rest, back])
    return f'<path class="{kind}" d="M {path}"><title>{escape(title)}</title></path>'


def draw(root: Path) -> str:
    """The picture as SVG."""
    drawn, leaves = drawing(Package(root))
    floor = MARGIN + drawn.height + GAP
    height = floor + FLOOR + MARGIN
    label = "The rooms of stridemap: an arrow leads from each room to those that import it, upwards only"
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH:.0f} {height:.0f}" role="img" '
        f'aria-label="{label}">',
        f"<style>{STYLE}</style>",
        '<defs><marker id="head" viewBox="0 0 8 8" refX="1" refY="4" markerWidth="5.5" markerHeight="5.5" '
        'orient="auto"><path class="head" d="M0 0 L8 4 L0 8 z"/></marker></defs>',
        f'<rect class="paper" width="{WIDTH:.0f}" height="{height:.0f}" rx="10"/>',
        *svg_drawing(drawn, MARGIN, MARGIN),
        *writes(drawn),
        *svg_leaves(leaves, floor),
        *svg_legend(drawn),
        "</svg>",
    ]
    return "\n".join(out) + "\n"


def writes(drawn: Drawing) -> list[str]:
    """The dashed arrow from what derives to what is written."""
    source, target = drawn.boxes[WRITES[0]], drawn.boxes[WRITES[1]]
    y = min(source.bottom, target.bottom) - 18
    start, end = (source.x, target.right) if source.x > target.x else (source.right, target.x)
    title = f"{source.name} writes {target.name}"
    return [
        arrow([(start, y), (end, y)], MARGIN, MARGIN, title, "arrow writes"),
        text("text middle", MARGIN + (start + end) / 2, MARGIN + y - 7, WRITES[2]),
    ]


def svg_leaves(leaves: list[Box], top: float) -> list[str]:
    """The floor that everything stands on."""
    width = WIDTH - 2 * MARGIN
    said = "the floor: files that need the standard library only, and that every room may import"
    out = [rect("inner", MARGIN, top, width, FLOOR, 7), text("text", MARGIN + PAD, top + 21, said)]
    each = (width - 2 * PAD - 10 * (len(leaves) - 1)) / len(leaves)
    for i, leaf in enumerate(leaves):
        box = replace(leaf, x=MARGIN + PAD + i * (each + 10), y=top + 31, width=each, height=51)
        out += svg_box(box, 0, 0, inner=True)
    return out


def svg_legend(drawn: Drawing) -> list[str]:
    """What the colours and arrows mean, in the free place beside the largest room."""
    room = max(drawn.boxes.values(), key=lambda box: box.height)
    x, y = MARGIN + room.right + 14, MARGIN + room.y + room.height / 2 - 100
    out = []
    for colour, meaning in LEGEND:
        out += [rect(colour, x, y, 4, 16, 2), text("text", x + 14, y + 12, meaning)]
        y += 24
    for line in ("An arrow leads from a room", "to one that imports it.", "All of them lead upwards."):
        y += LINE
        out.append(text("text", x, y, line))
    return out


def main() -> None:
    """Draw it."""
    PICTURE.write_text(draw(HERE.parent), "utf-8")


if __name__ == "__main__":
    main()
