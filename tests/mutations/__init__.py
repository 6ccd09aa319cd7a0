"""Changes of meaning that the tests must notice, by subject; `python -m tests.mutate` tries them."""

from tests.mutations import (
    boundaries,
    branches,
    derivation,
    following,
    numerics,
    observables,
    special_points,
    tables,
)
from tests.mutations.mutation import Mutation

MUTATIONS: tuple[Mutation, ...] = (
    *derivation.MUTATIONS,
    *observables.MUTATIONS,
    *numerics.MUTATIONS,
    *branches.MUTATIONS,
    *special_points.MUTATIONS,
    *following.MUTATIONS,
    *boundaries.MUTATIONS,
    *tables.MUTATIONS,
)
