"""How the derivation grows with the number of links: ``python -m benchmarks.links``.

For planar bipeds of two to seven links (`chain`; of seven with arms, and with feet), in angles from the
vertical and in angles of each link from the one that carries it: processor time of the derivation with all
its files, and operations of the mass matrix and the bias forces, beside those of the recursive Newton-Euler
equations. These are written as a straight-line program, in which equal operations are counted once, and those
with zero or one and changes of sign not at all; of the generated functions SymPy counts all.
"""

import argparse
import json
import sys
import time
from typing import Any

from benchmarks import chain
from stridemap.derive.emit import emit
from tests.oracles import recursive


def measure(count: int, coordinates: str, feet: bool = False) -> dict[str, Any]:
    """Processor seconds and operations of one biped."""
    start = time.process_time()
    walker = chain.walker(count, coordinates, feet)
    _, spec = emit(walker, "benchmark")
    seconds = time.process_time() - start
    names = [p.name for p in walker.parameters]
    functions = spec.functions
    return {
        "links": count,
        "feet": feet,
        "angles": coordinates,
        "seconds": seconds,
        "operations": functions["mass_matrix"].operations + functions["bias_forces"].operations,
        "recursive": recursive.operations(chain.links(count, feet), coordinates, names),
        "state_derivative": functions["state_derivative"].operations,
    }


HEAD = "links   angles    derived in  M and forces  recursive  ratio  accelerations"


def row(found: dict[str, Any]) -> str:
    """One line of the table."""
    name = f"{found['links']}{'f' if found['feet'] else ' '}"
    ratio = found["operations"] / found["recursive"]
    return (
        f"{name:>6s}  {found['angles']:8s} {found['seconds']:9.1f} s {found['operations']:13d}"
        f" {found['recursive']:10d} {ratio:6.2f} {found['state_derivative']:14d}"
    )


def main(arguments: list[str] | None = None) -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.links", description="Measure the derivation.")
    parser.add_argument("--json", action="store_true", help="print one JSON object per biped")
    parser.add_argument("--links", type=int, nargs="+", default=list(range(2, 8)), help="numbers (2 to 7)")
    parser.add_argument(
        "--angles", nargs="+", choices=chain.COORDINATES, default=list(chain.COORDINATES), help="(both)"
    )
    options = parser.parse_args(arguments)
    if not all(2 <= count <= 7 for count in options.links):
        parser.error("--links are from 2 to 7")
    if not options.json:
        print(f"{HEAD}\n(f: with feet, instead of arms)")
    bipeds = [(count, False) for count in options.links]
    bipeds += [(7, True)] * (7 in options.links)
    for coordinates in options.angles:
        for count, feet in bipeds:
            found = measure(count, coordinates, feet)
            print(json.dumps(found) if options.json else row(found), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
