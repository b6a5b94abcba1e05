"""The past: the history, the report of a shift, and metrics for others."""
