"""Replay: the console on a recording, without a way to a robot."""
