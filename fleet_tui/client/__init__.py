"""The client: transports and adapters put together, feeding the store."""
