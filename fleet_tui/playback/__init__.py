"""Recordings played back: the same console on what was recorded, and no way out of it to a robot."""
