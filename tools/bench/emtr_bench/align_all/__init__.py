"""The benchmark of many scans: how many are placed right, and how long it takes."""
