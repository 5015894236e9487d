"""BENCHMARK.md: runs the benchmarks, keeps their JSON, and writes the page from it."""
