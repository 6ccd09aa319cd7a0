"""The solver's public functions, by model name and parameters: a file per question."""
