"""`fleet-tui doctor`: facts are gathered over the wire, then judged without it, outside in."""
