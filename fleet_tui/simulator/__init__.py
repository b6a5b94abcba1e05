"""The simulated fleet: a rosbridge with robots of its own, which shares no codec with the client."""
