"""What the navigation stacks of ROS 1 and ROS 2 have in common: places, odometry, batteries, pauses."""
