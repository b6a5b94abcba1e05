"""Robots on ROS 2 with Nav2: goals through actions, odometry, no graph, no queue."""
