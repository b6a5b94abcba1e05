"""The console in a browser, through textual-serve."""
