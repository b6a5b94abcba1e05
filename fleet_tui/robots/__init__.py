"""Kinds of robots: the messages that they send and accept, one folder each (`ros` and `ros_navigation`
are shared by several). Pure."""
