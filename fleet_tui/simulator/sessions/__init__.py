"""Connected clients: what they ask for, what is due to them."""
