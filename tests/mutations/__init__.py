"""Changes of meaning that the tests must notice, by subject; `python -m tests.mutate` tries them."""

from tests.mutations import branches, derivation, numerics, tables
from tests.mutations.mutation import Mutation

MUTATIONS: tuple[Mutation, ...] = (
    *derivation.MUTATIONS,
    *numerics.MUTATIONS,
    *branches.MUTATIONS,
    *tables.MUTATIONS,
)
