"""Ways along route graphs, for the map and for orders that are being typed."""
