"""Senses of simulated robots of any kind: their belief of where they are, lasers, mapping."""
