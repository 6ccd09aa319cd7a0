"""Generated code, one folder a model; written by ``make derive``, never edited."""
