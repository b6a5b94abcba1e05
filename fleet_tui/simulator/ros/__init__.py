"""The two generations of ROS as a bridge shows them: types, times, arguments and failures."""
