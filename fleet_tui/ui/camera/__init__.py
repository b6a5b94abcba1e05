"""Pictures of robots' cameras, decoded."""
