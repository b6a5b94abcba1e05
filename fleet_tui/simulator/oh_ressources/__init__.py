"""The robots of the source's stack: a queue of orders, services, graphs as topics."""
