"""Rules: pure decisions over the state of the fleet."""
