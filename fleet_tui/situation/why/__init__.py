"""Reasons why a robot stands still."""
