"""Maps and route graphs from files."""
