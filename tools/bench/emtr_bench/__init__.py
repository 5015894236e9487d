"""Benchmarks of emtr: accuracy over pairs of clouds with ground truth."""
