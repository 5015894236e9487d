"""The benchmark against other libraries: same pairs, same motions, one run."""
