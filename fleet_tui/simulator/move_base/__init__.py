"""Robots with the navigation stack of ROS 1: amcl and move_base."""
