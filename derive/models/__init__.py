"""The walkers that come with stridemap, each a short declaration in a file of its own."""

from stridemap.derive.declaration import Walker
from stridemap.derive.models import compass, wobbling

WALKERS: dict[str, Walker] = {walker.name: walker for walker in (wobbling.WALKER, compass.WALKER)}
"""Every built-in walker by name."""
