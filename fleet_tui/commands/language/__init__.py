"""The command language: parsing, completion, finding places by typed text."""
