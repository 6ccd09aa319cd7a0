"""Run an example as a notebook and keep what its cells show: ``python docs/notebook.py``.

It writes docs/static/limit_cycles.ipynb, a file of Jupyter's format 4.5. The cells are the blocks of the
example, and what a cell shows is what Jupyter would show: the HTML of its last line.
"""

import ast
import contextlib
import io
import itertools
import json
import re
from collections import defaultdict
from pathlib import Path

from sphinx_gallery.notebook import rst2md
from sphinx_gallery.py_source_parser import split_code_and_text_blocks

HERE = Path(__file__).resolve().parent
EXAMPLE = HERE.parent / "examples" / "9_limit_cycles_in_a_notebook.py"
NOTEBOOK = HERE / "static" / "limit_cycles.ipynb"

CONFIGURATION = re.compile(r"^# sphinx_gallery_.*\n?", re.MULTILINE)
UNIQUE = re.compile(r"[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}")
"""Identifiers that xarray makes up anew each time."""


def blocks() -> list[tuple[str, str]]:
    """Kind, "markdown" or "code", and text of each cell."""
    out, levels = [], itertools.count(1)
    headings: dict = defaultdict(lambda: next(levels))
    for kind, text, _ in split_code_and_text_blocks(EXAMPLE)[1]:
        if kind == "text":
            out.append(("markdown", rst2md(text, {}, str(EXAMPLE.parent), headings).strip()))
        elif code := CONFIGURATION.sub("", text).strip():
            out.append(("code", code))
    return out


def outputs(code: str, names: dict) -> list[dict]:
    """What a cell prints, and what its last line shows."""
    tree, printed, value = ast.parse(code), io.StringIO(), None
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, EXAMPLE.name, "exec"), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), EXAMPLE.name, "eval"), names)
    shown = []
    if printed.getvalue():
        shown.append({"output_type": "stream", "name": "stdout", "text": printed.getvalue()})
    if value is not None:
        seen: dict[str, str] = {}
        data = {"text/plain": repr(value)}
        if hasattr(value, "_repr_html_"):
            data["text/html"] = UNIQUE.sub(
                lambda match: seen.setdefault(match[0], f"made-up-{len(seen)}"), value._repr_html_()
            )
        shown.append({"output_type": "display_data", "data": data, "metadata": {}})
    return shown


def notebook() -> dict:
    """The notebook as plain values."""
    names: dict = {"__name__": "__main__"}
    cells, count = [], 0
    for i, (kind, text) in enumerate(blocks()):
        cell = {"cell_type": kind, "id": f"cell-{i}", "metadata": {}, "source": text}
        if kind == "code":
            count += 1
            cell |= {"execution_count": count, "outputs": outputs(text, names)}
        cells.append(cell)
    language = {"name": "python", "file_extension": ".py", "mimetype": "text/x-python"}
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    metadata = {"kernelspec": kernel, "language_info": language}
    return {"cells": cells, "metadata": metadata, "nbformat": 4, "nbformat_minor": 5}


def main() -> None:
    """Write it."""
    NOTEBOOK.write_text(json.dumps(notebook(), indent=1, ensure_ascii=False) + "\n", "utf-8")


if __name__ == "__main__":
    main()
