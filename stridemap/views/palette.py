"""The colours of everything that is drawn: figures, plots, films, the page to explore, and the examples.

They are from the set of Okabe and Ito (jfly.uni-koeln.de/color), which people with any colour vision can tell
apart. What a colour stands for is said here once: the page's style sheet is given these (`style_sheet`), and
each legend says what is meant with the words of `MEANINGS`.
"""

BLACK, WHITE = "#000000", "#ffffff"
BLUE, VERMILION, GREEN, PURPLE, SKY = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9"
ORANGE = "#e69f00"
DARK, GREY, PALE = "#404040", "#b4b4b4", "#e6e6e6"

FORCE, ZMP, MASS, SPRING, BODY = GREEN, PURPLE, VERMILION, VERMILION, BLUE
"""The ground force, the paper's zero moment point, a wobbling mass and its spring, and other bodies."""

STANCE, SWING = DARK, SKY
"""The leg that stands and the leg that swings; where both are seen over many steps, left and right."""

STABLE, UNSTABLE, NONE = BLUE, GREY, WHITE
"""Where stable limit cycles are, unstable ones only, and none."""

UNSTABLE_LINE, COMPASS = DARK, BLACK
"""Lines of unstable limit cycles, and of the walker without a wobbling mass."""

SEVERAL_STEPS = VERMILION
"""Lines of limit cycles of several steps, which begin at doublings, of the same colour."""

GROUPS = {"A": VERMILION, "B": GREEN, "C": BLUE, "D": PURPLE, "E": ORANGE, "F": SKY}
"""Groups of gaits; A to C have the colours that the paper gives to their typical solutions."""

MEANINGS = {
    "force": "ground force, at the centre of pressure",
    "zmp": "the paper's zero moment point",
    "mass": "wobbling mass",
    "com": "centre of mass",
    "swing": "swing leg",
    "stable": "stable",
    "unstable": "unstable",
    "compass": "compass, without a wobbling mass",
}
"""What legends call the things that have a colour, or a mark, of their own."""

# On a dark ground what is black is light, and large grey patches are not the brightest thing in the picture.
_ON_THE_PAGE = {
    "force": (FORCE, FORCE),
    "zmp": (ZMP, ZMP),
    "mass": (MASS, MASS),
    "spring": (SPRING, SPRING),
    "body": (BODY, BODY),
    "stance": (STANCE, "#d3d8dd"),
    "swing": (SWING, SWING),
    "map-none": (NONE, "#090b0d"),
    "map-stable": (STABLE, STABLE),
    "map-unstable": (UNSTABLE, "#555a60"),
    "open": (UNSTABLE_LINE, GREY),
    "several-steps": (SEVERAL_STEPS, SEVERAL_STEPS),
    "compass": (COMPASS, WHITE),
    "group": (DARK, GREY),
    **{f"group-{letter}": (colour, colour) for letter, colour in GROUPS.items()},
}


def group_colour(letter: str | None) -> str:
    """The colour of a group; letters beyond those of `GROUPS` have one in common."""
    return GROUPS.get(letter or "", DARK)


def style_sheet() -> str:
    """The colours as names of a style sheet, such as ``--force``, for a light and for a dark page."""
    light, dark = (" ".join(f"--{name}: {pair[i]};" for name, pair in _ON_THE_PAGE.items()) for i in (0, 1))
    on_dark = f"@media screen and (prefers-color-scheme: dark) {{ :root:not([data-print]) {{ {dark} }} }}"
    return f":root {{ {light} }}\n{on_dark}\n"
