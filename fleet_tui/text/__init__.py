"""Text: sanitized, measured, shortened; durations and sizes in one format."""
