"""`fleet-tui config`: a configuration made, and one explained."""
