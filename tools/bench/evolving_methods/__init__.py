"""Evolutionary methods that EMTR-SSC is compared with, one file each.

Each file has a function ``optimise(problem, rng)``. It asks ``problem.evaluate`` for the fitness of
populations until ``problem.spent``. It returns nothing: the problem remembers the best that each
task has seen. ``problem.py`` says what a problem is, ``methods.py`` lists the files.
"""
