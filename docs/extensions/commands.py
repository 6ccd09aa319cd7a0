"""The directive ``stridemap-commands``: every command of the command line with the help that it prints."""

import typer
from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from stridemap.cli.app import app as command_line

WIDTH = 96
"""Characters in a line of the pages."""


class Commands(SphinxDirective):
    def run(self):
        group = typer.main.get_command(command_line)
        return [_section(name, command) for name, command in group.commands.items()]


def _section(name, command):
    context = command.context_class(
        command, info_name=f"stridemap {name}", max_content_width=WIDTH, terminal_width=WIDTH
    )
    section = nodes.section(ids=[f"stridemap-{name}"])
    section += nodes.title("", "", nodes.literal("", f"stridemap {name}"))
    text = command.get_help(context)
    section += nodes.literal_block(text, text, language="text")
    return section


def setup(app):
    app.add_directive("stridemap-commands", Commands)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
