"""The history on the screen, notes for the next shift, and the way into recordings."""
