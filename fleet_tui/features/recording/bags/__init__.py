"""ROS bags, converted to recordings so that the console can show them. Only this package imports rosbags."""
