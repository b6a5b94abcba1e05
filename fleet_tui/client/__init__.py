"""The client: transports and adapters combined, feeding the store."""
