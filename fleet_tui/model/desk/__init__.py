"""The desk: consoles of several people on one fleet."""
