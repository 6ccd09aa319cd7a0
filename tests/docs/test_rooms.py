"""The picture of the rooms is that of the imports, and imports go one way only."""

import re
import sys
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))

import rooms  # noqa: E402
from import_graph import Graph, Module, Package  # noqa: E402

COUNT = re.compile(r"about ([\d,]+) lines")


@pytest.fixture(scope="module")
def package():
    return Package(ROOT)


@pytest.fixture(scope="module")
def drawn():
    return rooms.draw(ROOT)


def test_the_picture_is_up_to_date(drawn):
    """To the byte, but for the lines of code, which may differ by a third."""
    stored = rooms.PICTURE.read_text("utf-8")
    again = "run `python docs/rooms.py`, which draws it anew"
    assert COUNT.sub("", stored) == COUNT.sub("", drawn), again
    for old, new in zip(*(map(number, COUNT.findall(text)) for text in (stored, drawn)), strict=True):
        assert abs(old - new) <= max(old, new) / 3, again


def number(text):
    return int(text.replace(",", ""))


@pytest.mark.parametrize("inside", [(), ("solver",)])
def test_imports_go_one_way(package, inside):
    """Every import, hidden ones included, leads to a lower layer of those that `make lint` holds."""
    graph = package.graph(*inside)
    layers = package.layers(".".join(["stridemap", *inside]))
    height = {room: -i for i, row in enumerate(layers) for room in row}
    assert set(graph.rooms) <= set(height)
    wrong = sorted((upper, lower) for lower, upper in graph.edges if height[lower] >= height[upper])
    assert wrong == []
    assert len(graph.edges) > 10


def test_every_arrow_leads_upwards_and_through_no_room(package):
    outer, _ = rooms.drawing(package)
    for drawing in (outer, outer.boxes["solver"].inner):
        assert len(drawing.arrows) >= len(drawing.boxes) - 1
        for (lower, upper), points in drawing.arrows.items():
            assert points[0][1] == drawing.boxes[lower].y
            assert points[-1][1] == drawing.boxes[upper].bottom
            assert points[0][1] > points[-1][1]
            for (x0, y0), (x1, y1) in pairwise(points):
                assert y1 <= y0, (lower, upper)
                for box in drawing.boxes.values():
                    apart = max(x0, x1) <= box.x or min(x0, x1) >= box.right
                    apart |= max(y0, y1) <= box.y or min(y0, y1) >= box.bottom
                    assert apart, (lower, upper, box.name)


def test_the_picture_says_what_is_imported(package):
    """Whatever imports what, directly or through others: the arrows say the same."""
    outer, floor = rooms.drawing(package)
    graph = package.graph()
    assert {box.name for box in floor} | set(outer.boxes) == set(graph.rooms)
    reachable = {room: {room} for room in outer.boxes}
    for _ in outer.boxes:
        for lower, upper in outer.arrows:
            reachable[upper] |= reachable[lower]
    direct = graph.without(box.name for box in floor).edges
    assert all(lower in reachable[upper] for lower, upper in direct)
    assert set(outer.arrows) <= set(direct)


def test_texts_stay_in_their_boxes(drawn):
    """By a generous estimate of the width of a letter."""
    tree = ElementTree.fromstring(drawn)
    space = "{http://www.w3.org/2000/svg}"
    cards = [r for r in tree.iter(f"{space}rect") if r.get("class") == "card"]
    for text in tree.iter(f"{space}text"):
        x, y = float(text.get("x")), float(text.get("y"))
        around = [
            float(c.get("x")) + float(c.get("width"))
            for c in cards
            if float(c.get("x")) < x < float(c.get("x")) + float(c.get("width"))
            and float(c.get("y")) < y < float(c.get("y")) + float(c.get("height"))
        ]
        if around and text.get("class") == "text":
            assert x + 6.6 * len(text.text) <= min(around), text.text


def fake(tmp_path, **rooms_):
    """A graph of files, each with the text given."""
    modules = {}
    for room, text in rooms_.items():
        path = tmp_path / f"{room}.py"
        path.write_text(text)
        modules[f"stridemap.{room}"] = Module(f"stridemap.{room}", path)
    package = Package.__new__(Package)
    package.modules = modules
    return package.graph()


def test_hidden_imports_count_and_a_circle_is_refused(tmp_path):
    graph = fake(
        tmp_path,
        low="def f():\n    from stridemap.high import g\n",
        high="from stridemap import low\n",
        alone="import typing\n",
    )
    assert graph.edges == {("high", "low"), ("low", "high")}
    with pytest.raises(ValueError, match="circle between high, low"):
        graph.levels()
    assert graph.leaves() == {"alone"}


def test_an_arrow_that_follows_from_others_is_left_out():
    graph = Graph({room: () for room in "abc"}, frozenset({("a", "b"), ("b", "c"), ("a", "c")}))
    assert graph.reduced() == {("a", "b"), ("b", "c")}
    assert graph.levels() == {"a": 0, "b": 1, "c": 2}


def test_the_files_of_the_floor_need_the_standard_library_only(package):
    floor = package.graph().leaves()
    assert {"errors", "services", "spec", "quantities"} <= floor
    for room in floor:
        imported = {name.split(".")[0] for name in package.modules[f"stridemap.{room}"].imports()}
        assert imported <= set(sys.stdlib_module_names) | {"stridemap"}
