"""Robots as fleet adapters report them, and the tasks that these give them."""
