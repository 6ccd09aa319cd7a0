"""Parameter sweeps: configuration, grid, running and storage of limit cycles over many points."""
