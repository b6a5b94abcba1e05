"""Set-up commands: their checks, and their confirmation by telemetry."""
