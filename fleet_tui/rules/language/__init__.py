"""The command language: parsed, completed, places found by what is typed."""
