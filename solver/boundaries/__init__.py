"""Everything that follows bifurcations and the ends of gaits in the plane of two parameters."""
