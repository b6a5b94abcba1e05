"""ROS bags, made into recordings so that the console can show them. Only this room knows rosbags."""
