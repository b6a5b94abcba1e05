"""The `map` commands: facts, a picture, saving."""
