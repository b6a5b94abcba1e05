"""Replay: the console on a recording, without connections to robots."""
