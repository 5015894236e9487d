"""The benchmark of given matches: how many may be wrong, and how long it takes."""
