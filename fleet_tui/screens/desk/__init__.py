"""The desk on the main screen."""
