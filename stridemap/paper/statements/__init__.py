"""The statements of the paper, each a function of tables."""
