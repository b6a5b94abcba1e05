"""The desk at the keyboard."""
