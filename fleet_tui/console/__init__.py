"""The console put together: it opens on a fleet, and its main screen composes the features."""
