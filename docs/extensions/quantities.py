"""The directive ``stridemap-units``: the table of quantities that `stridemap.units` holds."""

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from stridemap.units import QUANTITIES

HEAD = ("quantity", "unit", "SI unit")


class Quantities(SphinxDirective):
    def run(self):
        table, group = nodes.table(), nodes.tgroup(cols=len(HEAD))
        group += [nodes.colspec(colwidth=1) for _ in HEAD]
        group += nodes.thead("", _row(nodes.Text(word) for word in HEAD))
        rows = (
            _row((nodes.literal("", name), nodes.literal("", unit), nodes.Text(si)))
            for name, (unit, si) in QUANTITIES.items()
        )
        group += nodes.tbody("", *rows)
        table += group
        return [table]


def _row(cells):
    return nodes.row("", *(nodes.entry("", nodes.paragraph("", "", cell)) for cell in cells))


def setup(app):
    app.add_directive("stridemap-units", Quantities)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
