"""One result, many ways to it: the table behind tools/reproducibility."""
