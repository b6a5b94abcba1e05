"""The places of labels and of the robots' numbers on the map."""
