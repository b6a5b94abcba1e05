"""Recordings at the keyboard and in the shell: record, replay, incident archives, ROS bags."""
