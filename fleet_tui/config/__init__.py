"""The configuration: its shape, its checks, where it is found."""
