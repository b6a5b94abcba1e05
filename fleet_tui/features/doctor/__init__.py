"""The doctor command: facts are gathered over the wire, then judged without it, outside in."""
