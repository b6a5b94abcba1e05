"""Discovery: from the address of a bridge to a configuration."""
