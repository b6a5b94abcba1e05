"""The fleet as plain values: no I/O, no clock, no screen."""
