"""Builds wheels of pyemtr with the libraries that they need inside, and tries them."""
