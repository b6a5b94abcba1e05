"""Links: transports and robots' kinds combined, feeding the store."""
