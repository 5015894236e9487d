"""The benchmark of many pairs."""
