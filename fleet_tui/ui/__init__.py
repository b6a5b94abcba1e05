"""The screen: keys become requests, the state becomes pictures."""
