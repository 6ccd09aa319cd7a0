"""The explorable report: one HTML file with a sweep's limit cycles and the equations that move them."""
