"""Alarm rules: the conditions that need a person."""
