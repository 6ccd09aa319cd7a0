"""Small figures as vectors: one drawing per panel, so that panels flow into as many columns as fit.

They need no program, print as they are, and take their colours from the page's style sheet.
"""

import html
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from urllib.parse import urlencode

from stridemap.views.small_figures import Axis, Bar, Curve, Guide, Mark, Panel, SmallFigure

WIDTH, HEIGHT, ROW = 300, 168, 17
"""Size of a panel, and how high one of its rows is, in units of the drawing."""
TOP, RIGHT, BOTTOM = 20, 12, 32
LETTER = 5.9
"""Mean width of a letter."""
APART = 13
"""How far lines of text are apart, lest they touch."""


def drawn(figure: SmallFigure) -> str:
    """The panels of a figure, with what they show below them."""
    panels = "".join(_drawn(panel) for panel in figure.panels)
    kind = "panels four" if len(figure.panels) == 4 else "panels"  # two by two, as the paper has them
    caption = f"<figcaption>{_text(figure.caption)}</figcaption>" if figure.caption else ""
    return f'<figure class="deciding"><div class="{kind}">{panels}</div>{caption}</figure>'


def _text(value: str) -> str:
    return html.escape(value.encode("utf-8", "replace").decode("utf-8"))


@dataclass(frozen=True)
class _Frame:
    """Where the axes of a panel lie."""

    panel: Panel

    @property
    def left(self) -> float:
        rows = self.panel.y.rows
        if rows:
            return min(150.0, 10 + LETTER * max(map(len, rows)))
        return 24 + LETTER * max((len(written(value)) for value in ticks(self.panel.y, 4)), default=3)

    @property
    def height(self) -> float:
        rows = self.panel.y.rows
        return TOP + BOTTOM + ROW * max(2, len(rows)) if rows else HEIGHT

    def x(self, value: float) -> float:
        axis = self.panel.x
        share = (value - axis.low) / (axis.high - axis.low)
        return self.left + min(max(share, 0.0), 1.0) * (WIDTH - RIGHT - self.left)

    def y(self, value: float) -> float:
        axis = self.panel.y
        share = min(max((value - axis.low) / (axis.high - axis.low), 0.0), 1.0)
        inside = self.height - TOP - BOTTOM
        return TOP + (share if axis.rows else 1 - share) * inside  # the first row is at the top


def _drawn(panel: Panel) -> str:
    frame = _Frame(panel)
    parts = [
        *_bands(frame), *_grid(frame),
        *(_guide(frame, guide) for guide in panel.guides),
        *(_curve(frame, curve) for curve in panel.curves),
        *(_bar(frame, bar) for bar in panel.bars),
        *_marks(frame),
    ]  # fmt: skip
    so, all_ = sum(mark.holds for mark in panel.marks), len(panel.marks)
    said = f"{panel.title}: {so} of {all_} marked points are as stated" if all_ else panel.title
    return (
        f'<svg viewBox="0 0 {WIDTH} {frame.height:g}" class="small" role="group" aria-label="{_text(said)}">'
        f'<text x="{4 if panel.y.rows else frame.left:g}" y="10" class="title">{_text(panel.title)}</text>'
        f"{''.join(parts)}</svg>"
    )


def _bands(frame: _Frame) -> Iterable[str]:
    for band in frame.panel.bands:
        low, high = (getattr(frame, band.axis)(v) for v in (band.low, band.high))
        if band.axis == "x":
            box = f'x="{low:.1f}" y="{TOP}" width="{high - low:.1f}" height="{frame.height - TOP - BOTTOM:g}"'
        else:
            width = WIDTH - RIGHT - frame.left
            box = f'x="{frame.left:g}" y="{high:.1f}" width="{width:g}" height="{low - high:.1f}"'
        yield f'<rect {box} class="band"><title>{_text(band.label)}</title></rect>'


def _grid(frame: _Frame) -> Iterable[str]:
    """Ticks, names of rows, and the labels of the axes."""
    panel, bottom, right = frame.panel, frame.height - BOTTOM, WIDTH - RIGHT
    yield (
        f'<rect x="{frame.left:g}" y="{TOP}" width="{right - frame.left:g}" height="{bottom - TOP:g}" '
        'class="frame"/>'
    )
    for value in ticks(panel.x, 5):
        x = frame.x(value)
        yield f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{bottom:g}" y2="{bottom + 4:g}" class="axis"/>'
        yield f'<text x="{x:.1f}" y="{bottom + 11:g}" class="middle">{written(value)}</text>'
    yield (
        f'<text x="{(frame.left + right) / 2:g}" y="{bottom + 24:g}" class="middle name">'
        f"{_text(panel.x.label)}</text>"
    )
    for i, name in enumerate(panel.y.rows):
        yield f'<text x="{frame.left - 6:g}" y="{frame.y(i):.1f}" class="end">{_text(name)}</text>'
    if panel.y.rows:
        return
    for value in ticks(panel.y, 4):
        y = frame.y(value)
        yield f'<line x1="{frame.left:g}" x2="{right:g}" y1="{y:.1f}" y2="{y:.1f}" class="grid"/>'
        yield f'<text x="{frame.left - 5:g}" y="{y:.1f}" class="end">{written(value)}</text>'
    middle = (TOP + bottom) / 2
    yield (
        f'<text x="8" y="{middle:g}" class="middle name" transform="rotate(-90 8 {middle:g})">'
        f"{_text(panel.y.label)}</text>"
    )


def _guide(frame: _Frame, guide: Guide) -> str:
    axis = getattr(frame.panel, guide.axis)
    if not axis.low <= guide.value <= axis.high:
        return ""
    bottom, right = frame.height - BOTTOM, WIDTH - RIGHT
    if guide.axis == "x":
        at = frame.x(guide.value)
        ends, label = f'x1="{at:.1f}" x2="{at:.1f}" y1="{TOP}" y2="{bottom:g}"', ""
    else:
        at = frame.y(guide.value)
        ends = f'x1="{frame.left:g}" x2="{right:g}" y1="{at:.1f}" y2="{at:.1f}"'
        label = _guide_label(frame, guide.label, at)
    return f'<line {ends} class="guide {guide.look}"><title>{_text(guide.label)}</title></line>{label}'


def _guide_label(frame: _Frame, label: str, at: float) -> str:
    """The label of a line across, at the end at which least is in its way."""
    up = at - 6 if at > TOP + 20 else at + 8
    width, right = LETTER * len(label), WIDTH - RIGHT - 3
    points = _points(frame)
    points += [(frame.x(m.x) + aside, frame.y(m.y)) for m in frame.panel.marks for aside in (-20, 0, 20, 40)]
    left = min(right - width, frame.left + 4, key=lambda left: _covered(points, left, up, width))
    return f'<text x="{left:.1f}" y="{up:.1f}" class="halo">{_text(label)}</text>' if label else ""


def _curve(frame: _Frame, curve: Curve) -> str:
    """A line; or dots, which are one path of strokes without length. What lies outside is left out."""
    x, y = frame.panel.x, frame.panel.y
    kind, path, joined = ("dots" if curve.dots else "line"), [], False
    for along, up in zip(curve.x, curve.y, strict=True):
        inside = x.low <= along <= x.high and y.low <= up <= y.high
        if inside:
            point = f"{frame.x(along):.1f} {frame.y(up):.1f}"
            path.append(f"M{point}h0" if curve.dots else f"{'L' if joined else 'M'}{point}")
        joined = inside
    if not path:
        return ""
    return f'<path d="{"".join(path)}" class="{kind} {curve.look}"/>{_letter(frame, curve)}'


def _letter(frame: _Frame, curve: Curve) -> str:
    """The letter of a curve: above dots at the top of the panel, on a line where others are farthest."""
    if not curve.text:
        return ""
    x, y = frame.x((min(curve.x) + max(curve.x)) / 2), TOP + 7.0
    if not curve.dots:
        others = [
            other for other in frame.panel.curves if other is not curve and len(other.y) == len(curve.y)
        ]
        apart = [min((abs(v - other.y[i]) for other in others), default=v) for i, v in enumerate(curve.y)]
        i = max(range(len(apart)), key=apart.__getitem__)
        x, y = frame.x(curve.x[i]), frame.y(curve.y[i])
    return f'<text x="{x:.1f}" y="{y:.1f}" class="middle letter halo">{_text(curve.text)}</text>'


def _bar(frame: _Frame, bar: Bar) -> str:
    low, high, middle = frame.x(bar.low), frame.x(bar.high), frame.y(bar.row)
    width = max(high - low, 1.0)
    box = (
        f'<rect x="{low:.1f}" y="{middle - 5.5:.1f}" width="{width:.1f}" height="11" class="bar {bar.look}">'
        f"<title>{_text(bar.text)}: {written(bar.low)} to {written(bar.high)}</title></rect>"
    )
    text = ""
    if bar.text and width > LETTER * len(bar.text) + 2:
        at = f'x="{low + width / 2:.1f}" y="{middle + 0.5:.1f}"'
        text = f'<text {at} class="middle on">{_text(bar.text)}</text>'
    return _linked(box + text, bar.text, bar.at)


def _marks(frame: _Frame) -> Iterable[str]:
    """Marks with their texts, which keep out of each other's way as far as there is room."""
    taken = [(frame.x(mark.x) - 5, frame.y(mark.y), 10.0) for mark in frame.panel.marks]
    points = _points(frame)
    first = sorted(frame.panel.marks, key=lambda mark: (mark.holds, mark.x))  # those that are not so
    for mark in first:
        x, y = frame.x(mark.x), frame.y(mark.y)
        text, width = "", LETTER * len(mark.text)
        free = [
            (left, up)
            for left, up in _places(frame, x, y, width)
            if all(abs(up - v) > APART or left + width < u or left > u + w for u, v, w in taken)
        ]
        if free and mark.text:
            left, up = min(free, key=lambda place: _covered(points, place[0], place[1], width))
            taken.append((left, up, width))
            text = f'<text x="{left:.1f}" y="{up:.1f}" class="halo">{_text(mark.text)}</text>'
        yield _linked(_symbol(mark, x, y) + text, mark.text, mark.at)


def _points(frame: _Frame) -> list[tuple[float, float]]:
    """All that is drawn as points, which texts should not cover."""
    return [
        (frame.x(x), frame.y(y))
        for curve in frame.panel.curves
        for x, y in zip(curve.x, curve.y, strict=True)
    ]


def _covered(points: Iterable[tuple[float, float]], left: float, up: float, width: float) -> int:
    """How many points a text would cover."""
    return sum(left - 4 < x < left + width + 4 and abs(y - up) < 8 for x, y in points)


def _places(frame: _Frame, x: float, y: float, width: float) -> Iterable[tuple[float, float]]:
    """Where the text of a mark may begin: right of it, left of it, below or above."""
    right, bottom = WIDTH - 2, frame.height - BOTTOM - 5
    sides = [(x + 8, y), (x - 8 - width, y)]
    if not frame.panel.y.rows:
        up, down = y - APART - 2, y + APART + 2
        sides += [(x - width / 2, up), (x - width / 2, down), (x + 4, up), (x - width - 4, down)]
    for left, up in sides:
        if left > frame.left + 1 and left + width < right and TOP + 5 <= up <= bottom + 3:
            yield left, up


def _symbol(mark: Mark, x: float, y: float) -> str:
    """A disc where it is so, a cross where it is not; with room for a finger."""
    about = f'<circle cx="{x:.1f}" cy="{y:.1f}" r="11" class="reach"/>'
    if mark.holds:
        return f'{about}<circle cx="{x:.1f}" cy="{y:.1f}" r="4" class="so"/>'
    arms = f"M{x - 4:.1f} {y - 4:.1f}l8 8m0 -8l-8 8"
    return f'{about}<path d="{arms}" class="not-so under"/><path d="{arms}" class="not-so"/>'


def _linked(content: str, text: str, at: Mapping[str, float] | None) -> str:
    """What leads to a place of the map, if it has one."""
    if not at:
        return f"<g>{content}</g>"
    where = ", ".join(f"{name} = {value:.6g}" for name, value in at.items())
    said = _text(f"{text}: {where}, on the map" if text else f"{where}, on the map")
    address = _text(urlencode({name: f"{value:.9g}" for name, value in at.items()}, errors="replace"))
    return f'<a href="#{address}" aria-label="{said}"><title>{said}</title>{content}</a>'


def ticks(axis: Axis, count: int) -> list[float]:
    """Round values inside of an axis, about so many."""
    raw = (axis.high - axis.low) / count
    unit = 10.0 ** math.floor(math.log10(raw))
    step = next(unit * m for m in (1, 2, 2.5, 5, 10) if unit * m >= raw * (1 - 1e-9))
    first, last = math.ceil(axis.low / step - 1e-9), math.floor(axis.high / step + 1e-9)
    return [float(f"{i * step:.9g}") for i in range(first, min(last, first + 2 * count) + 1)]


def written(value: float) -> str:
    """A number in few digits, with a minus sign."""
    return f"{value:.4g}".replace("-", "\u2212")
