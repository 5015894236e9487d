"""Flat, printed and labelled scenes, of which shape alone does not tell the pose."""
