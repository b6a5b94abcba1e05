"""Plain objects between keys and the fleet: each is given what it needs, none knows Textual."""
