"""Tables that are made from the source: what rooms there are, and what words a record of options has."""

import functools
import importlib
from dataclasses import fields
from pathlib import Path

from docutils import nodes
from import_graph import Package
from numpydoc.docscrape import ClassDoc
from sphinx.util.docutils import SphinxDirective

ROOT = Path(__file__).resolve().parents[2]


class Options(SphinxDirective):
    """``stridemap-options``: the words of a record, with meaning and default, from its docstring."""

    required_arguments = 1

    def run(self):
        home, *names = self.arguments[0].split(".")
        found = functools.reduce(named, names, importlib.import_module(home))
        record = found if isinstance(found, type) else type(found)  # or what a class has by default
        defaults = {one.name: getattr(found, one.name) for one in fields(record)}
        rows = []
        for entry in ClassDoc(record)["Parameters"]:
            names = entry.name.split(", ")
            values = ", ".join(shown(defaults.pop(name)) for name in names)
            code = text(", ".join(f"`{name}`" for name in names))
            rows.append((code, text(" ".join(entry.desc)), text(values)))
        if defaults:
            raise self.error(f"{record.__name__} does not document {', '.join(defaults)}")
        return [table(("word", "meaning", "default"), rows)]


class Rooms(SphinxDirective):
    """``stridemap-rooms``: every room with its size and the rooms that it imports."""

    def run(self):
        graph = Package(ROOT).graph()
        levels = graph.levels()
        rows = [
            (
                nodes.literal("", f"stridemap.{room}"),
                text(f"{len(graph.rooms[room])}"),
                text(f"{graph.lines(room):,}"),
                text(", ".join(sorted(graph.below(room))) or "-"),
            )
            for room in sorted(graph.rooms, key=lambda r: (-levels[r], r))
        ]
        return [table(("room", "files", "lines", "imports"), rows)]


def named(owner, name):
    """What an owner has by a name, or by default under it."""
    usual = getattr(owner, "model_fields", {}).get(name)
    return getattr(owner, name) if usual is None else usual.default


def shown(value):
    """A default as a reader would write it."""
    return "the model's" if value is None else f"{value:g}"


def text(words):
    """Text with code between single or double backticks."""
    paragraph = nodes.inline()
    for i, piece in enumerate(words.replace("``", "`").split("`")):
        paragraph += nodes.literal("", piece) if i % 2 else nodes.Text(piece)
    return paragraph


def table(head, rows):
    """A table of nodes."""
    out, group = nodes.table(), nodes.tgroup(cols=len(head))
    group += [nodes.colspec(colwidth=1) for _ in head]
    group += nodes.thead("", row(nodes.Text(word) for word in head))
    group += nodes.tbody("", *(row(cells) for cells in rows))
    out += group
    return out


def row(cells):
    return nodes.row("", *(nodes.entry("", nodes.paragraph("", "", cell)) for cell in cells))


def setup(app):
    app.add_directive("stridemap-options", Options)
    app.add_directive("stridemap-rooms", Rooms)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
