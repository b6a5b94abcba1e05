"""Pictures of robots' cameras in cells: pure."""
