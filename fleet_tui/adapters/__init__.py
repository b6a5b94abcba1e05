"""Adapters: the messages that robots send and accept, one folder per kind (`ros` and
`ros_navigation` are shared by several). Pure."""
