"""Tables of limit cycles, wherever they come from: read, selected from, converted, and written for others."""
