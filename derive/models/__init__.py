"""The walkers that come with stridemap, each a short declaration in a file of its own."""

from collections.abc import Iterator, Mapping
from importlib import import_module

from stridemap.derive.walker import Walker

NAMES = (
    "wobbling",
    "compass",
    "simplest_walker",
    "goswami_compass",
    "rimless_wheel",
    "round_feet",
)
"""Of the walkers and of their files."""


class _Walkers(Mapping[str, Walker]):
    """Walkers by name; a declaration is run and checked when it is first asked for, which takes a while."""

    def __getitem__(self, name: str) -> Walker:
        if name not in NAMES:
            raise KeyError(name)
        walker: Walker = import_module(f"{__name__}.{name}").WALKER
        return walker

    def __iter__(self) -> Iterator[str]:
        return iter(NAMES)

    def __len__(self) -> int:
        return len(NAMES)


WALKERS: Mapping[str, Walker] = _Walkers()
"""Every built-in walker by name."""
