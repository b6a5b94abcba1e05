"""The desk at the keyboard: claims, notes, acknowledgements, closed edges."""
