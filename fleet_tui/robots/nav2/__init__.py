"""Robots with Nav2 behind a bridge of ROS 2."""
