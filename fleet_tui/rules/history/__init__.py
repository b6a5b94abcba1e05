"""The part of the fleet's state that is history."""
