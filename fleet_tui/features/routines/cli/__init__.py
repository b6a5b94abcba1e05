"""Routines from a shell: checked, run, listed, installed as timers."""
