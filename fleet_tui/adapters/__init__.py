"""Adapters: what robots say and take, one folder for each kind. Pure."""
