"""Driving by hand: for how long a key counts as held, and how fast the robot may go."""
