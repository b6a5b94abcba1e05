"""Robots with move_base, the navigation stack of ROS 1."""
