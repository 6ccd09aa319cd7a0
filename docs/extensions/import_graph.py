"""Which room imports which, read from the source with the standard library alone.

A room is what stands directly below ``stridemap``: a folder such as ``solver`` or a file such as ``spec.py``.
Every import counts, those inside functions and those for type checkers included.
"""

import ast
import tomllib
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

TOP = ("__init__", "__main__")
"""Modules that put the rooms together and belong to none."""


@dataclass(frozen=True)
class Module:
    """A Python file of the package.

    Parameters
    ----------
    name : str
        As it is imported, such as ``stridemap.solver.api``.
    path : pathlib.Path
    """

    name: str
    path: Path

    @property
    def parts(self) -> tuple[str, ...]:
        """Its name below ``stridemap``."""
        return tuple(self.name.split(".")[1:])

    @property
    def lines(self) -> int:
        """How many lines it has."""
        return len(self.path.read_text("utf-8").splitlines())

    def imports(self) -> set[str]:
        """Everything that it imports, by full name; a name that is imported from a module counts as both."""
        found: set[str] = set()
        for node in ast.walk(ast.parse(self.path.read_text("utf-8"))):
            if isinstance(node, ast.Import):
                found |= {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom) and node.module:
                found |= {f"{node.module}.{alias.name}" for alias in node.names}
        return found


class Package:
    """All modules of stridemap in a checkout.

    Parameters
    ----------
    root : pathlib.Path
        Where ``pyproject.toml`` lies.
    """

    def __init__(self, root: Path) -> None:
        self.project = tomllib.loads((root / "pyproject.toml").read_text("utf-8"))
        folders = self.project["tool"]["setuptools"]["package-dir"]
        self.modules: dict[str, Module] = {}
        for package, folder in folders.items():
            for path in sorted((root / folder).rglob("*.py")):
                parts = path.relative_to(root / folder).with_suffix("").parts
                name = ".".join([package, *parts]).removesuffix(".__init__")
                self.modules[name] = Module(name, path)

    @cached_property
    def imports(self) -> list[tuple[Module, Module]]:
        """Who imports whom, module by module."""
        pairs = []
        for module in self.modules.values():
            known = (self._module(name) for name in module.imports())
            pairs += [(module, other) for other in known if other is not None and other is not module]
        return sorted(set(pairs), key=lambda pair: (pair[0].name, pair[1].name))

    def _module(self, name: str) -> Module | None:
        """The module that a name lies in; None if it is not of this package."""
        while name and name not in self.modules:
            name = name.rpartition(".")[0]
        return self.modules.get(name)

    def graph(self, *inside: str) -> "Graph":
        """The rooms of the package, or the sub-rooms of a room, and who imports whom.

        Parameters
        ----------
        *inside : str
            Nothing for the package; "solver" for what is in the solver.
        """
        depth = len(inside)

        def room(module: Module) -> str | None:
            within = module.parts[:depth] == inside and len(module.parts) > depth
            return module.parts[depth] if within and module.parts[depth] not in TOP else None

        rooms: dict[str, list[Module]] = {}
        for module in self.modules.values():
            if name := room(module):
                rooms.setdefault(name, []).append(module)
        pairs = ((room(lower), room(upper)) for upper, lower in self.imports)
        edges = {(a, b) for a, b in pairs if a and b and a != b}
        return Graph({name: tuple(modules) for name, modules in rooms.items()}, frozenset(edges), depth)

    def layers(self, container: str) -> list[list[str]]:
        """The rooms in the order that `make lint` holds them to, the uppermost first.

        Parameters
        ----------
        container : str
            "stridemap", or "stridemap.solver".
        """
        for contract in self.project["tool"]["importlinter"]["contracts"]:
            if contract["type"] == "layers" and contract["containers"] == [container]:
                return [[name.strip(" ()") for name in row.split("|")] for row in contract["layers"]]
        raise LookupError(f"no contract of layers for {container}")


@dataclass(frozen=True)
class Graph:
    """Rooms and imports between them.

    Parameters
    ----------
    rooms : dict of str to tuple of Module
    edges : frozenset of (str, str)
        (lower, upper): the upper room imports the lower one.
    depth : int
        0 for the rooms of the package, 1 for the sub-rooms of a room.
    """

    rooms: dict[str, tuple[Module, ...]]
    edges: frozenset[tuple[str, str]]
    depth: int = 0

    def lines(self, room: str) -> int:
        """Lines of code of a room, blank ones and comments included."""
        return sum(module.lines for module in self.rooms[room])

    def is_file(self, room: str) -> bool:
        """Whether a room is one file, and not a folder."""
        return all(
            len(module.parts) == self.depth + 1 and module.path.stem == room for module in self.rooms[room]
        )

    def below(self, room: str) -> set[str]:
        """The rooms that a room imports."""
        return {lower for lower, upper in self.edges if upper == room}

    def leaves(self) -> set[str]:
        """Rooms of one file that import nothing, or nothing but such files."""
        leaves: set[str] = set()
        while True:
            new = {r for r in self.rooms if self.is_file(r) and self.below(r) <= leaves} - leaves
            if not new:
                return leaves
            leaves |= new

    def without(self, rooms: Iterable[str]) -> "Graph":
        """The same without some rooms."""
        gone = set(rooms)
        return Graph(
            {name: modules for name, modules in self.rooms.items() if name not in gone},
            frozenset(edge for edge in self.edges if gone.isdisjoint(edge)),
            self.depth,
        )

    def levels(self) -> dict[str, int]:
        """How many rooms stand on top of each other below each room.

        Raises
        ------
        ValueError
            When imports go in a circle.
        """
        levels: dict[str, int] = {}
        while len(levels) < len(self.rooms):
            ready = [r for r in self.rooms if r not in levels and self.below(r) <= levels.keys()]
            if not ready:
                circle = sorted(self.rooms.keys() - levels.keys())
                raise ValueError(f"imports go in a circle between {', '.join(circle)}")
            levels |= {r: max((levels[lower] + 1 for lower in self.below(r)), default=0) for r in ready}
        return levels

    def reduced(self) -> set[tuple[str, str]]:
        """The edges that do not follow from others: a -> c is left out where a -> b -> c."""
        self.levels()
        above = {room: {upper for lower, upper in self.edges if lower == room} for room in self.rooms}

        def reach(room: str) -> set[str]:
            return above[room].union(*(reach(upper) for upper in above[room]))

        return {(a, b) for a, b in self.edges if not any(b in reach(other) for other in above[a] - {b})}
