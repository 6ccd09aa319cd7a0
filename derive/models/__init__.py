"""The walkers that come with stridemap, each a short declaration in a file of its own."""

from stridemap.derive.models import (
    compass,
    goswami_compass,
    rimless_wheel,
    round_feet,
    simplest_walker,
    wobbling,
)
from stridemap.derive.walker import Walker

WALKERS: dict[str, Walker] = {
    module.WALKER.name: module.WALKER
    for module in (wobbling, compass, simplest_walker, goswami_compass, rimless_wheel, round_feet)
}
"""Every built-in walker by name."""
