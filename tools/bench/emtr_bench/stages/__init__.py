"""The benchmark of the stages: where a registration's time goes, and what the grid saves."""
