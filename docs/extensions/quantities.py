"""Tables for the pages, from the program itself.

``stridemap-units`` is the table of kinds of quantities with their units, ``stridemap-quantities`` that of the
measured quantities with their definitions. The names given to the latter, one per line, choose quantities;
all those that no other table of the page names are where ``rest`` stands.
"""

from typing import ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.util.docutils import SphinxDirective

from stridemap.quantities import QUANTITIES
from stridemap.units import KINDS


class Units(SphinxDirective):
    def run(self):
        rows = [
            (nodes.literal("", name), nodes.literal("", unit), nodes.Text(si))
            for name, (unit, si) in KINDS.items()
        ]
        return [_table(("quantity", "unit", "SI unit"), rows)]


class Quantities(SphinxDirective):
    has_content = True
    option_spec: ClassVar = {"rest": directives.flag}

    def run(self):
        taken = self.env.temp_data.setdefault("stridemap-quantities", set())
        names = [line.strip() for line in self.content if line.strip()]
        if unknown := [name for name in names if name not in QUANTITIES]:
            raise self.error(f"no measured quantity is called {', '.join(unknown)}")
        if "rest" in self.options:
            names += [name for name in QUANTITIES if name not in taken]
        taken.update(names)
        return [_table(("name", "definition", "unit"), [_defined(QUANTITIES[name]) for name in names])]


def _defined(quantity):
    definition = [nodes.Text(quantity.definition)]
    if quantity.formula:
        definition += [nodes.Text(" "), nodes.math(quantity.formula, quantity.formula)]
    if quantity.optional:
        definition.append(nodes.Text(" None for a model that does not have it."))
    unit = KINDS[quantity.kind][0] if quantity.type == "float" else "1"
    return nodes.literal("", quantity.name), definition, nodes.literal("", unit) if unit != "1" else None


def _table(head, rows):
    table, group = nodes.table(), nodes.tgroup(cols=len(head))
    group += [nodes.colspec(colwidth=1) for _ in head]
    group += nodes.thead("", _row([nodes.Text(word) for word in head]))
    group += nodes.tbody("", *(_row(row) for row in rows))
    table += group
    return table


def _row(cells):
    row = nodes.row()
    for cell in cells:
        content = cell if isinstance(cell, list) else [] if cell is None else [cell]
        row += nodes.entry("", nodes.paragraph("", "", *content))
    return row


def setup(app):
    app.add_directive("stridemap-units", Units)
    app.add_directive("stridemap-quantities", Quantities)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
