"""The small figures of the statements: what decides each of them, drawn from its evidence and the tables."""
