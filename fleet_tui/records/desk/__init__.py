"""The desk: a folder in which consoles of several people share presence, claims and facts. No server."""
