"""Tables of contents may name pages that not every version has: patterns that match nothing are left out."""

import re
from pathlib import Path

TABLE = re.compile(r"^```\{toctree\}\n((?::.*\n)*)\n((?:[^`].*\n)+)```\n", re.MULTILINE)


def _present(folder):
    def table(match):
        options, entries = match.groups()
        kept = [
            entry for entry in entries.splitlines() if "*" not in entry or any(folder.glob(f"{entry}.md"))
        ]
        return f"```{{toctree}}\n{options}\n" + "\n".join(kept) + "\n```\n" if kept else ""

    return table


def _read(app, name, source):
    if name == app.config.root_doc:
        source[0] = TABLE.sub(_present(Path(app.srcdir)), source[0])


def setup(app):
    app.connect("source-read", _read)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
