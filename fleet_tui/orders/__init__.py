"""Orders: their life in the queues of robots and of this console, and how they end. Pure."""
