"""Robots in fleets of Open-RMF, behind a bridge of ROS 2."""
