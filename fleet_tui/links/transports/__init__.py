"""Transports: connections to bridges and brokers. Only I/O: decoding is elsewhere."""
