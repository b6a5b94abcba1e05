"""Benchmarks: each prints its figure, its target and what it is measured against."""

# Before anything of Textual: the package tells it how often to paint.
import fleet_tui as fleet_tui
