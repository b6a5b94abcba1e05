"""Support for tests: sites, links, terminals, peers, recordings."""
