"""Programs of the robot servers: looked at, started, stopped, their logs followed. No shell is involved."""
