"""Rules of commands: checked before they leave, confirmed by telemetry, followed to their end."""
