"""Parts common to the navigation stacks of ROS 1 and ROS 2: places, odometry, batteries, pauses."""
