"""The panes: each paints what it is shown and says what the operator did to it."""
