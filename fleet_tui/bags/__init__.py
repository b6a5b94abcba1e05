"""ROS bags, made into recordings so that the console can show them. Only this package knows rosbags."""
