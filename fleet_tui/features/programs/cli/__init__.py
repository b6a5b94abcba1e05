"""Programs of the robot servers from a shell."""
