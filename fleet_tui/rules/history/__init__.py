"""What of the fleet's state is history."""
