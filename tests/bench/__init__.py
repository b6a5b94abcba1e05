"""Benchmarks: each bench_*.py prints its figures; none of them asserts a time."""
