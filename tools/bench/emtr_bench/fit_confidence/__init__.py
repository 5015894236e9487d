"""The fit of the confidence."""
