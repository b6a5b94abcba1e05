"""The state of the fleet: the store, and how each event changes it."""
