"""Calibration of the confidence."""
