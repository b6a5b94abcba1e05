"""A simulated hospital with fleets of Open-RMF: robots, adapters, a dispatcher, lifts and doors."""
