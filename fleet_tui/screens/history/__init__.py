"""The history of the shift, over the console."""
