"""A shape, a scanner to look at it with, and what makes a sample pair of the two."""
