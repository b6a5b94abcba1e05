"""The terminal console for robot fleets behind a rosbridge server."""

__version__ = "0.1.0"
