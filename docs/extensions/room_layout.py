"""Where the boxes of a picture of rooms stand, and how the arrows between them run."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from import_graph import Graph

PAD, LINE = 14.0, 16.0
"""Inside of a box's edge, and from line to line."""

LANE = 26.0
"""Where an arrow passes a room, at the right."""

Edge = tuple[str, str]
Line = list[tuple[float, float]]


@dataclass(frozen=True)
class Box:
    """A room as it is drawn.

    Parameters
    ----------
    name, text, colour, count : str
    chips : tuple of str
        Sub-rooms that are only named.
    x, y, width, height : float
    inner : Drawing or None
        Sub-rooms that are drawn.
    """

    name: str
    text: str
    colour: str
    count: str
    chips: tuple[str, ...] = ()
    x: float = 0.0
    y: float = 0.0
    width: float = 0.0
    height: float = 0.0
    inner: "Drawing | None" = None

    @property
    def right(self) -> float:
        """Its right edge."""
        return self.x + self.width

    @property
    def bottom(self) -> float:
        """Its lower edge."""
        return self.y + self.height


@dataclass(frozen=True)
class Drawing:
    """Boxes at their places, and polylines between them.

    Parameters
    ----------
    boxes : dict of str to Box
    arrows : dict of (str, str) to list of (float, float)
    height : float
    """

    boxes: dict[str, Box]
    arrows: dict[Edge, Line] = field(default_factory=dict)
    height: float = 0.0


# -- boxes -------------------------------------------------------------------------------------------------


def words(text: str, width: float) -> list[str]:
    """A text in lines of a width in pixels."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if len(longer) * 6.5 > width and lines[-1]:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


def chip_rows(chips: tuple[str, ...], width: float) -> list[list[tuple[str, float]]]:
    """Chips with their widths, in rows."""
    rows: list[list[tuple[str, float]]] = [[]]
    for chip in chips:
        size = len(chip) * 6.6 + 14
        if rows[-1] and sum(w + 6 for _, w in rows[-1]) + size > width:
            rows.append([])
        rows[-1].append((chip, size))
    return rows if chips else []


def sized(box: Box, width: float) -> Box:
    """A box as high as what is in it."""
    inside = width - 2 * PAD
    height = 36 + LINE * len(words(box.text, inside)) + 24 * len(chip_rows(box.chips, inside)) + 4
    if box.inner:
        height += box.inner.height + 8
    return replace(box, width=width, height=height)


# -- places ------------------------------------------------------------------------------------------------


def main_column(graph: Graph) -> set[str]:
    """Rooms of a longest way up, the larger one where there are several."""
    levels = graph.levels()
    top = max(levels.values())
    room = max((r for r in levels if levels[r] == top), key=lambda r: (not graph.is_file(r), graph.lines(r)))
    chain = {room}
    while levels[room]:
        below = [r for r in graph.below(room) if levels[r] == levels[room] - 1]
        room = max(below, key=lambda r: (not graph.is_file(r), graph.lines(r)))
        chain.add(room)
    return chain


def rows(graph: Graph, chain: set[str]) -> dict[str, int]:
    """The row of each room: its level, or the next above it that is free beside the long column."""
    levels, row = graph.levels(), {room: level for room, level in graph.levels().items() if room in chain}

    def slack(room: str) -> int:
        return (
            min((levels[upper] for lower, upper in graph.edges if lower == room), default=99) - levels[room]
        )

    def held(room: str) -> bool:
        """Whether the long column, whose rows are fixed, imports it."""
        return any(upper in chain for lower, upper in graph.edges if lower == room and upper != top)

    top = max(chain, key=lambda r: levels[r])
    for room in sorted(graph.rooms.keys() - chain, key=lambda r: (slack(r), not held(r), r)):
        taken = {row[other] for other in row if other not in chain}
        row[room] = next(n for n in range(levels[room], levels[room] + 99) if n not in taken)
    return row


def place(
    graph: Graph, boxes: Mapping[str, Box], width: float, side: float, gutter: float, gap: float
) -> Drawing:
    """Put the rooms of a longest way into one column, and the others beside it."""
    chain = main_column(graph)
    row = rows(graph, chain)
    passed = {
        room
        for room in row
        for lower, upper in graph.reduced()
        if not chain & {room, upper} and row[lower] < row[room] < row[upper]
    }
    placed: dict[str, Box] = {}
    y = 0.0
    for n in range(max(row.values()), -1, -1):
        left, *right = sorted((r for r in row if row[r] == n), key=lambda r: r not in chain)
        ends = n in (0, max(row.values()))
        main = sized(boxes[left], width if ends and not right else width - side - gutter)
        beside = [sized(boxes[r], side - LANE * (r in passed)) for r in right]
        height = max(box.height for box in (main, *beside))
        placed[left] = replace(main, y=y, height=height)
        for box in beside:
            placed[box.name] = replace(box, x=width - side, y=y, height=height)
        y += height + gap
    return Drawing(placed, route(graph, placed, width, width - side - gutter / 2, gap), y - gap)


def route(
    graph: Graph, boxes: Mapping[str, Box], width: float, gutter: float, gap: float
) -> dict[Edge, Line]:
    """Lines from the upper edge of each lower room to the lower edge of the upper room.

    Straight up where nothing stands in between; else along the right edge within the column at the side, and
    through the gutter from one column into the other.
    """
    arrows: dict[Edge, Line] = {}
    bends = 0
    for edge in sorted(graph.reduced()):
        lower, upper = boxes[edge[0]], boxes[edge[1]]
        low, high = max(lower.x, upper.x), min(lower.right, upper.right)
        if high > low:
            between = [b for b in boxes.values() if upper.bottom < b.y < b.bottom < lower.y]
            blocked = any(b.x < (low + high) / 2 < b.right for b in between)
            x = width - LANE / 2 if blocked else (low + high) / 2
            arrows[edge] = [(x, lower.y), (x, upper.bottom)]
            continue
        shift = gap / 5 * (bends % 3 - 1)
        bends += 1
        to_right = lower.right < upper.x
        start = lower.right - 44 + shift if to_right else lower.x + 44 + shift
        end = upper.x + 44 + shift if to_right else upper.right - 44 + shift
        leave, arrive = lower.y - gap / 2 + shift, upper.bottom + gap / 2 + shift
        if abs(leave - arrive) < gap:
            arrive = leave
        x = gutter + shift
        corners = [
            (start, lower.y),
            (start, leave),
            (x, leave),
            (x, arrive),
            (end, arrive),
            (end, upper.bottom),
        ]
        arrows[edge] = [p for i, p in enumerate(corners) if i == 0 or p != corners[i - 1]]
    return arrows
