"""Compares the results of every build, instruction set, number of threads and API."""
