"""Set-up from the console: poses and goals, streams, mapping."""
