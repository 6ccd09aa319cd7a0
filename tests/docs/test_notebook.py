"""The notebook in the pages is the example, run: the same cells, with what they show."""

import json
import sys
from pathlib import Path

import pytest

pytest.importorskip("sphinx_gallery")
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))

import notebook  # noqa: E402

STORED = json.loads(notebook.NOTEBOOK.read_text("utf-8"))
CODE = [cell for cell in STORED["cells"] if cell["cell_type"] == "code"]


def test_its_cells_are_the_blocks_of_the_example():
    cells = [(cell["cell_type"], cell["source"]) for cell in STORED["cells"]]
    assert cells == notebook.blocks(), "run `python docs/notebook.py`, which writes it anew"


def test_its_cells_show_tables_and_pictures():
    shown = [output["data"].get("text/html", "") for cell in CODE for output in cell["outputs"]]
    assert len(shown) == len(CODE) - 1  # the first one imports
    assert sum('id="figure_1"' in one for one in shown) == 5
    assert "<td>1.1837395</td><td>sqrt(L/g)</td>" in shown[1]
    assert str(ROOT.parent) not in json.dumps(STORED)


def test_a_cell_is_run_and_its_last_line_shown():
    names = {}
    assert notebook.outputs("a = 2", names) == []
    printed, value = notebook.outputs("print(a)\na + 1", names)
    assert printed == {"output_type": "stream", "name": "stdout", "text": "2\n"}
    assert value["data"] == {"text/plain": "3"}
