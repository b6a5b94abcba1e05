"""What goes wrong between a console and its robots, one test for each fault (docs/faults.md)."""
