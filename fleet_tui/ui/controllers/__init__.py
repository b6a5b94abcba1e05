"""Plain objects between keys and the fleet: dependencies are passed in, none uses Textual."""
