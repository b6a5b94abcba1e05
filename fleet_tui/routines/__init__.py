"""Routines in use: their files, programs, owner and saved progress, and the run that gives the orders."""
