"""The second front end: the same link, store and model without a screen."""
