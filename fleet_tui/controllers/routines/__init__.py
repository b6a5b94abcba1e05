"""Routines of this console: what a person asks for, and what is led here."""
