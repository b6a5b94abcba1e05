"""Orders: from a key, a row or a line to a request."""
