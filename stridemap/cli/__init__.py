"""The commands that draw and judge, one a file."""
