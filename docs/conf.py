"""How the pages are built: `make docs`. Nothing here needs the network, nor do the pages that come out."""

import enum
import functools
import os
import sys
from importlib.metadata import version as installed
from pathlib import Path
from types import FunctionType, MethodType

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "extensions"))

# As in any terminal without a screen; set before the examples import matplotlib.
os.environ["MPLBACKEND"] = "Agg"

project = "stridemap"
author = "the stridemap authors"
project_copyright = author
version = release = installed("stridemap")

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "numpydoc",
    "sphinx_gallery.gen_gallery",
    "commands",
    "contents",
    "mathml",
    "quantities",
    "tables",
]
exclude_patterns = ["_build", "gallery/*.ipynb", "gallery/*.json", "gallery/*.py", "images/*.md"]
# In docstrings a name between single backticks is a name of ours.
default_role = "py:obj"

myst_enable_extensions = ["colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3

autodoc_member_order = "bysource"
autodoc_typehints = "none"
autodoc_default_options = {"members": True, "undoc-members": False}
numpydoc_show_class_members = False
numpydoc_xref_param_type = False
toc_object_entries_show_parents = "hide"

html_math_renderer = "mathml"
html_theme = "furo"
html_title = f"stridemap {release}"
html_static_path = ["static"]
html_css_files = ["pages.css"]
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0b5394", "color-brand-content": "#0b5394"},
    "dark_css_variables": {"color-brand-primary": "#8ab8e6", "color-brand-content": "#8ab8e6"},
}
pygments_style = "tango"

sphinx_gallery_conf = {
    "examples_dirs": "../examples",
    "gallery_dirs": "gallery",
    "filename_pattern": r"[\\/]\d_\w+\.py$",
    "within_subsection_order": "FileNameSortKey",
    "abort_on_example_error": True,
    "run_stale_examples": True,  # what they print depends on the program, not on their own text alone
    "capture_repr": (),
    "download_all_examples": False,
    "show_memory": False,
    "show_signature": False,
    "min_reported_time": 1e9,
    "write_computation_times": False,
    "remove_config_comments": True,
    "notebook_extensions": set(),
    "matplotlib_animations": False,
    "image_srcset": ["2x"],
}

DOCUMENTED = (FunctionType, MethodType, classmethod, property, functools.cached_property, enum.Enum)


def _left_out(app, what, name, member, skip, options):
    """Leave out the fields of records: the parameters above them say what they are."""
    return True if what == "class" and not isinstance(member, DOCUMENTED) else None


def setup(app):
    app.connect("autodoc-skip-member", _left_out)
