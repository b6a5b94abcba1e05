"""The panes: each paints its input and posts the operator's actions on it."""
