"""Codec: rosbridge v2 operations and the ROS messages in them."""
