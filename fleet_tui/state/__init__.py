"""The state of the fleet: the store, and the effect of each event."""
