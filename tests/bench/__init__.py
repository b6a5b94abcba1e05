"""Benchmarks: each bench_*.py measures figures of docs/performance.md; none of them asserts a time."""
