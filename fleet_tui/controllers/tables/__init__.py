"""Commands to several rows."""
