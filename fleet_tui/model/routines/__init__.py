"""Routines: the instructions that robots carry out one after the other, and the progress of each robot."""
