"""Commands: what is typed, checked before it leaves, and confirmed by telemetry. Pure."""
