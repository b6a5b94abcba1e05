"""Transports: connections to bridges and brokers. Only I/O: what the bytes mean is read elsewhere."""
