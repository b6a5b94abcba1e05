"""Discovery: what is behind the address of a bridge, as a configuration."""
