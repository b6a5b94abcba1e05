"""Programs of robot servers: their states, and the outcomes of what is asked of them."""
