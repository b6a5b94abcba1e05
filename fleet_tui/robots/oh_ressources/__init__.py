"""Robots of the OH_ressources interface."""
