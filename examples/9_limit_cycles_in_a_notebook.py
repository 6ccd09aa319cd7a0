"""
9. Limit cycles in a notebook
=============================

In a notebook, what stridemap finds shows itself: a list of limit cycles, one of them, a table
and a figure, as on this page. Plots take one line, and tables become data frames, arrays over
the grid, and numbers in SI units.
"""

# sphinx_gallery_capture_repr = ('_repr_html_', '__repr__')

import tempfile
from concurrent.futures import ThreadPoolExecutor

import stridemap
from stridemap.sweeps.config import parse_config

# %%
# A list of limit cycles
# ----------------------
# All cycles at a point: a row each, units below the names. The picture has their Floquet
# multipliers beside the unit circle; a cycle with one outside is unstable.

orbits = stridemap.find_orbits("wobbling", k=6, alpha=0.25, omega=3)
orbits

# %%
# One limit cycle
# ---------------
# Its parameters, what matters most, and its phase portraits; *all values* opens the rest.

stable = orbits[orbits.stable][0]
stable

# %%
# Its profiles over one step:

stable.plot()

# %%
# A sweep, in one line
# --------------------
# A table of a sweep (here a small one, from a dictionary in place of a file) knows what its
# columns hold. So axes have labels and units, and a condition selects rows.

config = parse_config(
    {
        "model": "wobbling",
        "grid": {"k": {"start": 1, "stop": 20, "num": 20}},
        "search": {"starts": 16},
    }
)
with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(1) as executor:
    stridemap.sweep(config, folder, executor=executor)
    table = stridemap.read_table(folder)

table.plot("k", "cot", colour="spectral_radius", where="cot < 0.6")

# %%
# Frames and arrays
# -----------------
# The cheapest stable gaits, as a data frame of pandas:

cheapest = table.where("stable").to_frame().nsmallest(4, "cot")
cheapest[["k", "group", "period", "speed", "cot", "spectral_radius"]]

# %%
# Arrays over the grid, as a dataset of xarray: the lowest cost of a stable gait at each spring.

data = table.to_xarray()
lowest = data.cot.where(data.stable == 1).min("cycle", keep_attrs=True)
lowest

# %%
# In newtons and metres
# ---------------------
# For a robot with legs of 0.75 m and an upper body of 32 kg the same table is in SI units:

robot = stridemap.Units(leg_length=0.75, mass=32.0)
si = table.to_si(robot)
figure = si.plot("k", "speed", colour="group", where="stable")
figure
